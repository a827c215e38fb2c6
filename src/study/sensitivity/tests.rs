//! The study on scenes whose answer is known.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::*;
use crate::model::simulate::{Settings, simulate};
use crate::study::context::{to_its_end, until};

const EFFORT: Effort = Effort { rows: 256, trajectories: 20, seed: 1 };

fn axes(list: &[(&str, f64, f64)]) -> Vec<Axis> {
    let axis =
        |(name, low, high): &(&str, f64, f64)| Axis::new(name, (*low, *high), 2, Spacing::Linear);
    list.iter().map(|asked| axis(asked).unwrap()).collect()
}

fn rigid() -> Scene {
    let mut scene = Scene::default();
    scene.plate.mount = crate::model::scene::Mount::Rigid;
    scene
}

fn found(scene: &Scene, axes: Vec<Axis>, output: &str) -> Result<Report, SweepError> {
    study(scene, axes, output, EFFORT, &mut Context::new(2, &mut to_its_end))
}

/// On a rigid mount gamma does nothing, and velocity all.
#[test]
fn what_has_no_effect_has_none_in_any_of_the_three() {
    let asked = axes(&[("gamma", 0.8, 7.0), ("v_i", 80.0, 120.0)]);
    let found = found(&rigid(), asked, "final_penetration_m").unwrap();
    assert!((found.own.unwrap() - 7.113_055e-3).abs() < 5e-10);
    assert_eq!(found.bars[0].swing(), Some(0.0));
    assert_eq!(found.effects[0].magnitude, Some(0.0));
    let sobol = found.sobol.as_ref().unwrap();
    assert!(sobol.inputs[0].total.unwrap().value.abs() < 1e-12);
    assert!((sobol.inputs[1].total.unwrap().value - 1.0).abs() < 0.05);
    assert_eq!(found.order(), [1, 0]);
    // The tornado's ends are the runs' own.
    let mut fast = rigid();
    fast.projectile.velocity_m_s = 120.0;
    let settings = Settings { series: false, estimate: false };
    let run = simulate(&Arc::new(fast), &settings, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(found.bars[1].high, run.final_penetration_m);
}

#[test]
fn no_digit_depends_on_the_threads_and_a_stop_keeps_what_there_is() {
    let asked = || axes(&[("gamma", 0.8, 7.0), ("k", 0.0, 7.5e6)]);
    let with = |threads| {
        let (effort, mut watch) = (Effort { rows: 64, ..EFFORT }, to_its_end);
        let context = &mut Context::new(threads, &mut watch);
        study(&Scene::default(), asked(), "percent_of_baseline", effort, context).unwrap()
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.sobol, three.sobol);
    assert_eq!(one.effects, three.effects);
    let mut watch = until(10);
    let stopped = &mut Context::new(2, &mut watch);
    let cut = study(&Scene::default(), asked(), "percent_of_baseline", EFFORT, stopped).unwrap();
    assert!(cut.sobol.is_none() && cut.effects.is_empty() && cut.bars[0].swing().is_some());
}

#[test]
fn points_without_a_value_are_left_out_and_counted() {
    let asked = axes(&[("v_i", 200.0, 300.0)]);
    let found = found(&rigid(), asked, "percent_of_baseline").unwrap();
    let sobol = found.sobol.unwrap();
    assert!(sobol.used < sobol.rows && sobol.used > 0);
    assert!(found.bars[0].high.is_none() && found.bars[0].low.is_some());
}

#[test]
fn bad_bounds_and_too_many_are_refused_and_the_table_has_its_five() {
    let scene = Scene::default();
    let symbols: Vec<&str> = thesis_axes(&scene).unwrap().iter().map(Axis::symbol).collect();
    assert_eq!(symbols, ["gamma", "d", "b", "k", "n"]);
    assert!(thesis_axes(&rigid()).unwrap().is_empty());
    let names = ["gamma", "d", "b", "k", "n", "v_i", "h"];
    let seven = axes(&names.map(|name| (name, 1.0, 2.0)));
    let refused = found(&scene, seven, "stroke_m").unwrap_err();
    assert!(refused.to_string().contains("7 axes are too many: a sweep has at most 6"));
    let two = axes(&[("gamma", 1.0, 2.0)]);
    assert!(found(&scene, two, "depth").is_err());
}
