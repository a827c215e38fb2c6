//! Plans are checked, points are found from their index, and results equal those of a single run.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::grid::{Cell, Grid};
use super::*;
use crate::study::context::{CancelFlag, Context};
use crate::study::quantities::{QuantityFlag, of_runs};
use crate::study::testing::scene;
use crate::study::{plain_run, run_with, validity};
use cmra_engine::model::run::Outcome;
use cmra_engine::model::simulate::Settings;

const NONE: [&str; 0] = [];

fn axis(name: &str, from: f64, to: f64, count: u64) -> Axis {
    Axis::new(name, (from, to), count, Spacing::Linear).unwrap()
}

fn points(plan: &Plan) -> Vec<Point> {
    let stop = CancelFlag::default();
    let all: Vec<u64> = (0..plan.points()).collect();
    Evaluator::new(plan, &stop).points(&all)
}

/// Nothing stops a plate without spring; no shot in range perforates 5 m of it.
#[test]
fn a_row_says_why_many_shots_give_no_value() {
    let outputs = ["limit_velocity_m_s", "mass_efficiency"];
    let axes = vec![axis("h", 0.0254, 5.0, 2)];
    let plan = Plan::new(&scene("k=0 b=0"), axes, &outputs).unwrap();
    let found = points(&plan);
    let reasons = [0, 1].map(|row: usize| found[row].reason().unwrap().to_owned());
    assert_eq!(reasons[0], "nothing stops plate and projectile");
    assert!(reasons[1].contains("beyond 3000 m/s"), "{reasons:?}");
    assert!(
        (found[0].values[0].unwrap() - 347.708_052).abs() < 5e-7,
        "the closed form of a free plate"
    );
}

/// Plans that the command line can state are tested in `bad_sweeps_are_refused_before_anything_runs`.
#[test]
fn a_bad_plan_is_refused_before_anything_runs() {
    let huge = vec![axis("k", 0.0, 1.0, 1_000_000_000), axis("b", 0.0, 1.0, 1_000_000_000)];
    for (axes, fragments) in [
        (Vec::new(), ["at least one axis", "gamma=0.8..7:101"]),
        (huge, ["1.0e18 points are too many", "fewer"]),
    ] {
        let refused = Plan::new(&Scene::default(), axes, &NONE).unwrap_err();
        let text = refused.to_string();
        assert!(fragments.iter().all(|fragment| text.contains(fragment)), "{text}");
    }
}

/// Scenes with a stop behind, at or before the zero of the spring, where a cocked plate comes to rest or only meets it on its way.
fn stopped() -> Vec<String> {
    let places = ["d=0.1 x_stop=-50mm", "d=0.1 x_stop=0", "d=0.1 x_stop=1mm", "x_stop=2mm"];
    let kinds = ["e=0", "e=1", "e=0.5 b=50"];
    let others = ["", "spring=constant", "v_i=500"];
    let with_kinds = places.iter().flat_map(|place| kinds.map(|kind| format!("{place} {kind}")));
    with_kinds.flat_map(|pairs| others.map(|other| format!("{pairs} {other}"))).collect()
}

/// An output has the same value in a sweep of its own as in a sweep of all outputs.
#[test]
fn the_value_of_an_output_does_not_depend_on_the_others() {
    let outputs: Vec<&str> =
        of_runs().filter(|it| !it.has(QuantityFlag::OfComputation)).map(|it| it.name).collect();
    for pairs in stopped() {
        let base = scene(&pairs);
        let v_m_s = base.projectile.velocity_m_s;
        let whole = |outputs: &[&str]| {
            let axes = vec![axis("v_i", v_m_s, v_m_s + 1.0, 2)];
            let plan = Plan::new(&base, axes, outputs).unwrap();
            Evaluator::new(&plan, &CancelFlag::default()).points(&[0]).remove(0)
        };
        let beside = whole(&outputs);
        let run = run_with(&base, Settings::default()).unwrap();
        for (output, beside) in outputs.iter().zip(beside.values) {
            let alone = whole(&[output]).values[0];
            assert_eq!(alone, beside, "{pairs}: {output}");
            assert_eq!(alone, named(output).unwrap().value(&run), "{pairs}: {output}");
        }
    }
}

/// The cocked spring drives the plate onto the stop; a rigid one takes the blow in no time.
#[test]
fn valid_a_row_and_its_warnings_know_the_hit_on_a_stop_where_a_cocked_plate_comes_to_rest() {
    let outputs = ["peak_mount_force_n", "fused_stop_hit"];
    for pairs in ["d=0.1 x_stop=0 e=0", "d=0.1 x_stop=-50mm e=0"] {
        let plan = Plan::new(&scene(pairs), vec![axis("v_i", 100.0, 101.0, 2)], &outputs).unwrap();
        assert_eq!(points(&plan)[0].values, [None, Some(1.0)], "{pairs}");
        let warnings = validity::of_plan(&plan);
        let sentences: Vec<String> = warnings.iter().map(|it| format!("{it:?}")).collect();
        assert!(sentences.iter().any(|it| it.contains("rigid stop")), "{pairs}: {sentences:?}");
    }
}

/// The value of an output by a single full simulation.
fn single(scene: &Scene, name: &str) -> (PointOutcome, Option<f64>) {
    let mut scene = scene.clone();
    // A tenth of the tolerance of the sweep: the contact kernel is tested, not this run.
    scene.run.tolerance *= 0.1;
    let run = plain_run(&scene).unwrap();
    (PointOutcome::from_run(&run), named(name).unwrap().value(&run))
}

/// Surfaces that between them take every way through the evaluator.
fn surfaces() -> Vec<(Scene, Vec<Axis>)> {
    let k = |count| axis("k", 0.0, 7.5e6, count);
    let n = |count| axis("n", 0.1, 3.0, count);
    let d = |count| axis("d", 0.0, 0.5, count);
    let gamma = |count| axis("gamma", 0.8, 7.0, count);
    vec![
        (scene(""), vec![gamma(9), k(9)]),
        (scene(""), vec![gamma(4), n(5)]),
        (scene(""), vec![k(4), n(5)]),
        (scene(""), vec![d(9), gamma(9)]),
        (scene(""), vec![d(9), k(9)]),
        (scene(""), vec![d(4), n(5)]),
        (scene("b=500"), vec![axis("v_i", 50.0, 500.0, 7), axis("b", 0.0, 2000.0, 5)]),
        (scene("mount=rigid"), vec![axis("v_i", 50.0, 400.0, 15)]),
        (scene("k=0"), vec![axis("v_i", 50.0, 500.0, 10), axis("theta", 0.0, 60.0, 4)]),
        (scene("interface=plastic"), vec![gamma(3), k(4)]),
        (scene("x_stop=2mm"), vec![gamma(3), axis("v_i", 60.0, 400.0, 4)]),
        (scene("h=6mm k=1e7"), vec![axis("v_i", 50.0, 500.0, 16), axis("h", 0.003, 0.03, 7)]),
    ]
}

#[test]
fn valid_every_point_of_every_surface_is_what_a_single_run_gives() {
    let names = [
        "percent_of_baseline",
        "max_plate_displacement_m",
        "first_arrest_penetration_m",
        "first_arrest_time_s",
        "final_penetration_m",
        "stroke_m",
        "first_arrest_plate_velocity_m_s",
        "baseline_penetration_m",
    ];
    for (scene, axes) in surfaces() {
        let plan = Plan::new(&scene, axes, &names).unwrap();
        let found = points(&plan);
        assert_eq!(found.len() as u64, plan.points());
        for (point, index) in found.iter().zip(0..) {
            let scene = plan.scene(index);
            for (output, name) in names.iter().enumerate() {
                let (outcome, exact) = single(&scene, name);
                assert_eq!(point.outcome, outcome, "{:?} {index}", plan.axes());
                let found = point.values[output];
                assert_eq!(found.is_some(), exact.is_some(), "{:?} {index} {name}", plan.axes());
                let Some((found, exact)) = found.zip(exact) else { continue };
                // What moves by less than a thousand-millionth of a millimetre does not move.
                let size =
                    if name.ends_with("velocity_m_s") { 100.0 } else { exact.abs().max(1e-12) };
                assert!(
                    (found - exact).abs() <= 1e-9 * size,
                    "{:?} {index} {name}: {found} {exact}",
                    plan.axes()
                );
            }
        }
    }
}

#[test]
fn a_grid_is_filled_coarse_first_and_ends_as_if_it_were_not() {
    let axes = vec![axis("gamma", 0.8, 7.0, 33), axis("k", 0.0, 7.5e6, 20)];
    let plan = Plan::new(&scene(""), axes, &DEFAULT_OUTPUTS).unwrap();
    let direct = points(&plan);
    let mut seen = Vec::new();
    let watch = &mut |_, pass: Option<&Grid>| {
        if let Some(grid) = pass {
            seen.push(grid.progress().0);
            // What is not there yet is shown by a coarser point.
            assert_ne!(grid.cell(32, 19, 0), Cell::Waiting);
        }
        ControlFlow::Continue(())
    };
    let grid = Grid::new(Arc::new(plan)).unwrap().fill(7, &mut Context::new(2, watch));
    assert_eq!(seen, [9 * 5, 17 * 10, 33 * 20]);
    assert!(grid.is_complete());
    assert_eq!(grid.points().1, direct);
    // k = 0: nothing stops the plate.
    assert_eq!(grid.cell(3, 0, 1), Cell::Outcome(PointOutcome::Ended(Outcome::Arrested)));
}
