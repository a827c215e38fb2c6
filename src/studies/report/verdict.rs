//! The verdict on a shot: its keys in files, and its words on pages.

use serde_json::{Map, Value, json};

use crate::report::table::Table;
use crate::study::envelope;
use crate::study::limit;
use crate::study::quantities::EXPECTED;
use crate::study::verdict::{Decision, Expected, Verdict};
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{fixed_significant, velocity};

/// Meaning of a ballistic limit, shown beside each verdict.
pub const V50: &str = "a limit is a V50: at it half of the shots perforate";

/// The expected limit, its band and its class, as columns of a table.
pub fn expected_columns<'c, R: 'c>(
    table: Table<'c, R>,
    expected: impl Fn(&R) -> Option<&Expected> + Copy + 'c,
) -> Table<'c, R> {
    table
        .with(EXPECTED[0], "expected", "m/s", move |row| Some(expected(row)?.limit_m_s))
        .with(EXPECTED[1], "low", "m/s", move |row| Some(expected(row)?.low_m_s))
        .with(EXPECTED[2], "high", "m/s", move |row| Some(expected(row)?.high_m_s))
        .field("class", move |row| Some(expected(row)?.class.clone()))
        .field("measurements", move |row| Some(expected(row)?.measurements))
        .field("papers", move |row| Some(expected(row)?.papers))
}

/// The keys of a verdict, null for what does not exist.
pub fn object(verdict: &Verdict) -> Map<String, Value> {
    let expected = verdict.expected.as_ref();
    let value = json!({
        "limit_velocity_m_s": verdict.limit_m_s,
        (EXPECTED[0]): expected.map(|it| it.limit_m_s),
        (EXPECTED[1]): expected.map(|it| it.low_m_s),
        (EXPECTED[2]): expected.map(|it| it.high_m_s),
        "class": expected.map(|it| it.class.as_str()),
        "measurements": expected.map(|it| it.measurements),
        "papers": expected.map(|it| it.papers),
        "verdict": verdict.decision.word(),
    });
    if let Value::Object(object) = value { object } else { Map::new() }
}

/// The verdict on a shot in a sentence, with what the law alone says where nothing was measured.
pub fn sentence(scene: &Scene, verdict: &Verdict, by_law: Option<Outcome>) -> String {
    let v = velocity(scene.projectile.velocity_m_s, 4);
    let Some(expected) = &verdict.expected else {
        let model = scene.contact.model;
        if !model.knows_perforation() {
            let why = why_not(scene);
            return format!("not measured: {why}; the {} model cannot perforate", model.word());
        }
        let is_low = envelope::is_law_low(scene);
        let is_stopped = matches!(by_law, Some(Outcome::Arrested | Outcome::Separated));
        let is_between = is_stopped && !limit::is_stopped_by_every_closure(scene);
        let law = by_law.map_or_else(String::new, |outcome| match outcome {
            _ if is_between => format!(
                "; by the law alone {v} is stopped, but not by the lowest of the three rules: open"
            ),
            Outcome::Perforated if is_low => {
                format!("; the law is low, safe for stopping, and says nothing of {v}")
            }
            Outcome::Perforated => format!("; by the law alone {v} perforates"),
            Outcome::Arrested | Outcome::Separated => format!("; by the law alone {v} is stopped"),
            Outcome::Unmeasured => {
                format!("; the law is low, safe for stopping, and says nothing of {v}")
            }
            Outcome::Moving => String::new(),
        });
        return format!("not measured: {}{law}", why_not(scene));
    };
    let (low, high) = (fixed_significant(expected.low_m_s, 4), velocity(expected.high_m_s, 4));
    match verdict.decision {
        Decision::Stops => {
            format!("stops: {v} is below the band of measured limits, {low} to {high}")
        }
        Decision::Open => {
            format!("open: {v} is inside the band of measured limits, {low} to {high}")
        }
        Decision::Perforates => {
            format!("perforates: {v} is above the band of measured limits, {low} to {high}")
        }
        Decision::NotMeasured => String::new(),
    }
}

/// Why no class of measurements applies.
fn why_not(scene: &Scene) -> &'static str {
    if scene.is_stack() {
        "no measured limit of a stack is public"
    } else if scene.is_sprung() {
        "no measured limit of a spring-mounted or free plate is public"
    } else if envelope::is_law_low(scene) {
        "no limit of a rigid cylinder on a plate thinner than 0.6 D, which dishes, is in the table"
    } else {
        "no class of measurements has such shots (`cmra validate` lists the classes)"
    }
}

/// The verdict on a run's shot in a sentence.
pub fn of_run(run: &Run) -> String {
    sentence(&run.scene, &Verdict::from_scene(&run.scene), Some(run.shot_outcome()))
}
