//! A ballistic limit: a row a shot, and the whole as an object. SI.

use serde_json::{Value, json};

use crate::report::table::{Table, pretty};
use crate::study::limit::fit::{LambertJonas, RechtIpson};
use crate::study::limit::monte_carlo::SampledLimit;
use crate::study::limit::{Limit, Report, Shot};

/// The shots, in order of velocity, with what each fitted law says and the limit or what it lies between.
pub fn shots<'c>(name: &'c str, report: &'c Report) -> Table<'c, &'c Shot> {
    let (above, below) = report.limit.bracket_m_s();
    let limit_m_s = report.limit.velocity_m_s();
    Table::of(&report.shots)
        .with("scene", "scene", "", move |_| name)
        .with("impact_velocity_m_s", "impact velocity", "m/s", |shot| shot.impact_m_s)
        .with("outcome", "outcome", "", |shot| shot.outcome.word())
        .with("residual_velocity_m_s", "residual velocity", "m/s", |shot| shot.residual_m_s)
        .with("recht_ipson_m_s", "Recht-Ipson", "m/s", |shot| {
            report.recht_ipson.map(|law| law.residual_m_s(shot.impact_m_s))
        })
        .with("lambert_jonas_m_s", "Lambert-Jonas", "m/s", |shot| {
            report.lambert_jonas.map(|law| law.residual_m_s(shot.impact_m_s))
        })
        .with("limit_velocity_m_s", "limit", "m/s", move |_| limit_m_s)
        .with("limit_above_m_s", "limit above", "m/s", move |_| above)
        .with("limit_below_m_s", "limit below", "m/s", move |_| below)
}

fn recht_ipson(law: RechtIpson) -> Value {
    json!({ "a": law.a, "v_bl_m_s": law.limit_m_s, "misfit_m_s": law.misfit_m_s })
}

fn lambert_jonas(law: LambertJonas) -> Value {
    json!({ "a": law.a, "p": law.p, "v_bl_m_s": law.limit_m_s, "misfit_m_s": law.misfit_m_s })
}

/// What the sampled shots come down to.
fn monte_carlo(found: SampledLimit) -> Value {
    let asked = found.sampling;
    json!({
        "input_deviation": asked.deviation,
        "model_error": { "bias": asked.model.bias, "spread": asked.model.spread },
        "samples": asked.samples,
        "seed": asked.seed,
        "with_limit": found.found,
        "v50_m_s": found.v50_m_s,
        "deviation_m_s": found.deviation_m_s,
        "quantile_05_m_s": found.range90_m_s.0,
        "quantile_95_m_s": found.range90_m_s.1,
        "perforated": found.perforated,
        "perforated_low_95": found.perforated95.0,
        "perforated_high_95": found.perforated95.1,
    })
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let (basis, stopped) = match report.limit {
        Limit::Found { basis, stopped_at_m_s, .. } => (Some(basis.words()), stopped_at_m_s),
        Limit::Between { .. } | Limit::Never | Limit::Always | Limit::Unknown => (None, None),
    };
    let (above, below) = report.limit.bracket_m_s();
    let load = report.load.unwrap_or_default();
    let closures = report.closures.map(|closures| {
        json!({
            "double_yield_dishing_m_s": closures.double_yield_m_s,
            "cavity_no_dishing_m_s": closures.cavity_m_s,
        })
    });
    let own = ["impact_velocity_m_s", "outcome", "residual_velocity_m_s"];
    pretty(&json!({
        "scene": name,
        "limit_velocity_m_s": report.limit.velocity_m_s(),
        "criterion": report.criterion.word(),
        "basis": basis,
        "no_limit": report.limit.absence(),
        "limit_above_m_s": above,
        "limit_below_m_s": below,
        "stopped_again_at_m_s": stopped,
        "impact_velocity_m_s": report.scene.projectile.velocity_m_s,
        "margin": report.margin(),
        "caution": report.caution(),
        "stroke_at_limit_m": load.stroke_m,
        "stored_energy_at_limit_j": load.stored_j,
        "peak_mount_force_at_limit_n": load.mount_force_n,
        "closures": closures,
        "recht_ipson": report.recht_ipson.map(recht_ipson),
        "lambert_jonas": report.lambert_jonas.map(lambert_jonas),
        "scatter": report.sampled.map(monte_carlo),
        "shots": shots(name, report).objects(|key| own.contains(&key)),
    }))
}
