//! A ballistic limit for machines: the shots as CSV rows, and everything as one JSON object. SI.

use serde_json::{Map, Value, json};

use crate::files::rows::{Rows, number};
use crate::study::limit::fit::{LambertJonas, RechtIpson};
use crate::study::limit::scatter::{ModelError, Scatter};
use crate::study::limit::{Limit, Report};

/// One row a shot, in order of velocity, with what each fitted law says and the limit or what it lies between.
pub fn shots(name: &str, report: &Report) -> Rows {
    let (above, below) = report.limit.bracket_m_s();
    let row = |shot: &crate::study::limit::Shot| {
        let v = shot.impact_m_s;
        vec![
            Value::from(name),
            number(Some(v)),
            Value::from(shot.outcome.word()),
            number(shot.residual_m_s),
            number(report.recht_ipson.map(|law| law.residual_m_s(v))),
            number(report.lambert_jonas.map(|law| law.residual_m_s(v))),
            number(report.limit.velocity_m_s()),
            number(above),
            number(below),
        ]
    };
    Rows {
        columns: vec![
            "scene",
            "impact_velocity_m_s",
            "outcome",
            "residual_velocity_m_s",
            "recht_ipson_m_s",
            "lambert_jonas_m_s",
            "limit_velocity_m_s",
            "limit_above_m_s",
            "limit_below_m_s",
        ],
        rows: report.shots.iter().map(row).collect(),
    }
}

fn model_error(model: ModelError) -> Value {
    json!({ "bias": number(Some(model.bias)), "spread": number(Some(model.spread)) })
}

fn recht_ipson(law: RechtIpson) -> Value {
    json!({
        "a": number(Some(law.a)),
        "v_bl_m_s": number(Some(law.limit_m_s)),
        "misfit_m_s": number(Some(law.misfit_m_s)),
    })
}

fn lambert_jonas(law: LambertJonas) -> Value {
    json!({
        "a": number(Some(law.a)), "p": number(Some(law.p)),
        "v_bl_m_s": number(Some(law.limit_m_s)),
        "misfit_m_s": number(Some(law.misfit_m_s)),
    })
}

/// What the sampled shots come down to.
fn monte_carlo(found: Scatter) -> Value {
    json!({
        "input_deviation": number(Some(found.scattering.deviation)),
        "model_error": model_error(found.scattering.model),
        "samples": found.scattering.samples,
        "seed": found.scattering.seed,
        "with_limit": found.found,
        "v50_m_s": number(Some(found.v50_m_s)),
        "deviation_m_s": number(Some(found.deviation_m_s)),
        "quantile_05_m_s": number(Some(found.range90_m_s.0)),
        "quantile_95_m_s": number(Some(found.range90_m_s.1)),
        "perforated": number(Some(found.perforated)),
        "perforated_low_95": number(Some(found.perforated95.0)),
        "perforated_high_95": number(Some(found.perforated95.1)),
    })
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let (basis, stopped) = match report.limit {
        Limit::Found { basis, stopped_at_m_s, .. } => (Some(basis.words()), stopped_at_m_s),
        Limit::Between { .. } | Limit::Never | Limit::Always | Limit::Unknown => (None, None),
    };
    let mut object = Map::new();
    let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
    put("scene", Value::from(name));
    put("limit_velocity_m_s", number(report.limit.velocity_m_s()));
    put("criterion", Value::from(report.criterion.word()));
    put("basis", basis.map_or(Value::Null, Value::from));
    put("no_limit", report.limit.absence().map_or(Value::Null, Value::from));
    let (above, below) = report.limit.bracket_m_s();
    put("limit_above_m_s", number(above));
    put("limit_below_m_s", number(below));
    put("stopped_again_at_m_s", number(stopped));
    put("impact_velocity_m_s", number(Some(report.scene.projectile.velocity_m_s)));
    put("margin", number(report.margin()));
    put("caution", report.caution().map_or(Value::Null, Value::from));
    let load = report.load.unwrap_or_default();
    put("stroke_at_limit_m", number(load.stroke_m));
    put("stored_energy_at_limit_j", number(load.stored_j));
    put("peak_mount_force_at_limit_n", number(load.mount_force_n));
    let closures = report.closures.map(|closures| {
        json!({
            "double_yield_dishing_m_s": number(closures.double_yield_m_s),
            "cavity_no_dishing_m_s": number(closures.cavity_m_s),
        })
    });
    put("closures", closures.unwrap_or(Value::Null));
    put("recht_ipson", report.recht_ipson.map_or(Value::Null, recht_ipson));
    put("lambert_jonas", report.lambert_jonas.map_or(Value::Null, lambert_jonas));
    put("scatter", report.scatter.map_or(Value::Null, monte_carlo));
    let shots = report.shots.iter().map(|shot| {
        json!({
            "impact_velocity_m_s": number(Some(shot.impact_m_s)),
            "outcome": shot.outcome.word(),
            "residual_velocity_m_s": number(shot.residual_m_s),
        })
    });
    put("shots", shots.collect());
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&Value::Object(object)).unwrap_or_default() + "\n"
}
