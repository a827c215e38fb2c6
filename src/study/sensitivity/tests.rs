//! The study on scenes whose answer is known.

use super::*;
use crate::study::context::{to_its_end, until};
use crate::study::plain_run;
use crate::study::testing::{axes, rigid};

const EFFORT: Effort = Effort { rows: 256, trajectories: 20, seed: 1 };

fn found(scene: &Scene, axes: Vec<Axis>, output: &str) -> Result<Report, SweepError> {
    study(scene, axes, output, EFFORT, &mut Context::new(2, &mut to_its_end))
}

#[test]
fn what_has_an_effect_comes_first_and_the_ends_are_those_of_runs() {
    let asked = axes(&[("gamma", 0.8, 7.0), ("v_i", 80.0, 120.0)]);
    let found = found(&rigid(), asked, "final_penetration_m").unwrap();
    assert_eq!(found.order(), [1, 0]);
    // The tornado's ends are the runs' own.
    let mut fast = rigid();
    fast.projectile.velocity_m_s = 120.0;
    assert_eq!(found.bars[1].high, plain_run(&fast).unwrap().final_penetration_m);
}

#[test]
fn a_stop_keeps_what_there_is() {
    let asked = axes(&[("gamma", 0.8, 7.0), ("k", 0.0, 7.5e6)]);
    let mut watch = until(10);
    let stopped = &mut Context::new(2, &mut watch);
    let cut = study(&Scene::default(), asked, "percent_of_baseline", EFFORT, stopped).unwrap();
    assert!(cut.sobol.is_none() && cut.effects.is_empty() && cut.bars[0].swing().is_some());
}

#[test]
fn points_without_a_value_are_omitted_and_counted() {
    let asked = axes(&[("v_i", 200.0, 300.0)]);
    let found = found(&rigid(), asked, "percent_of_baseline").unwrap();
    let sobol = found.sobol.unwrap();
    assert!(sobol.used < sobol.rows && sobol.used > 0);
    assert!(found.bars[0].high.is_none() && found.bars[0].low.is_some());
}

#[test]
fn too_many_variables_are_refused() {
    let names = ["gamma", "d", "b", "k", "n", "v_i", "h"];
    let seven = axes(&names.map(|name| (name, 1.0, 2.0)));
    let refused = found(&Scene::default(), seven, "stroke_m").unwrap_err();
    assert!(refused.to_string().contains("7 axes are too many: a sweep has at most 6"));
}
