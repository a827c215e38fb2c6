//! The fit through the shots of a ballistic test: one row for each shot, and the whole as an object. SI.

use serde_json::{Value, json};

use crate::report::table::Table;
use crate::study::fit::calibrate::Calibration;
use crate::study::fit::{CONFIDENCE, MeasuredShot, Report};

/// The shots, with what the fits say of their velocities.
pub fn table(report: &Report) -> Table<'_, &MeasuredShot> {
    Table::of(&report.shots)
        .with("velocity_m_s", "velocity", "m/s", |shot| shot.velocity_m_s)
        .with("perforated", "perforated", "", |shot| u8::from(shot.perforated))
        .shown(|shot, _| Some(if shot.perforated { "yes" } else { "no" }.to_owned()))
        .with("residual_m_s", "residual", "m/s", |shot| shot.residual_m_s)
        .with("penetration_m", "depth", "m", |shot| shot.penetration_m)
        .with("perforation_probability", "probability", "", |shot| {
            report.logistic.probability(shot.velocity_m_s)
        })
        .with("lambert_jonas_m_s", "Lambert-Jonas", "m/s", |shot| {
            report.lambert_jonas.map(|law| law.residual_m_s(shot.velocity_m_s))
        })
}

/// Everything as one object; null for what does not exist.
pub fn json(report: &Report, calibration: Option<&Calibration>) -> Value {
    let fit = &report.logistic;
    let law = report.lambert_jonas.map(|law| {
        json!({
            "a": law.a,
            "p": law.p,
            "limit_velocity_m_s": law.limit_m_s,
            "rms_error_m_s": law.misfit_m_s,
            "shots": report.residuals().len(),
        })
    });
    let strength = calibration.map(|it| {
        let depths = it.from_depths;
        json!({
            "variable": it.symbol,
            "scene_value_pa": it.own_pa,
            "scene_limit_velocity_m_s": it.own_limit_m_s,
            "from_v50_pa": it.from_limit_pa,
            "from_v50_low_pa": it.range_pa.0,
            "from_v50_high_pa": it.range_pa.1,
            "from_depths_pa": depths.map(|it| it.mean_pa),
            "from_depths_deviation_pa": depths.and_then(|it| it.deviation_pa),
            "depths": depths.map_or(0, |it| it.shots),
        })
    });
    json!({
        "shots": report.shots.len(),
        "perforated": report.perforated(),
        "highest_stopped_m_s": report.highest_stopped_m_s,
        "lowest_perforated_m_s": report.lowest_perforated_m_s,
        "mixed_results": report.has_mixed_results(),
        "method": fit.method.words(),
        "v50_m_s": fit.v50_m_s,
        "v50_low_m_s": fit.range_m_s.0,
        "v50_high_m_s": fit.range_m_s.1,
        "confidence": CONFIDENCE,
        "scale_m_s": fit.scale_m_s,
        "v10_m_s": fit.quantile_m_s(0.1),
        "v90_m_s": fit.quantile_m_s(0.9),
        "lambert_jonas": law,
        "calibration": strength,
    })
}
