//! The study on scenes with a known solution.

use super::*;
use crate::study::context::{never_cancel, until};
use crate::study::plain_run;
use crate::study::testing::scene;

fn computed(pairs: &str, request: &Request) -> SensitivityReport {
    run(&scene(pairs), request, &mut Context::new(2, &mut never_cancel)).unwrap()
}

#[test]
fn the_usual_variables_are_those_that_the_scene_uses() {
    let usual = |pairs: &str| -> Vec<(&str, (f64, f64))> {
        let axes = default_axes(&scene(pairs));
        axes.iter().map(|axis| (axis.symbol(), axis.ends())).collect()
    };
    let symbols = |pairs: &str| -> Vec<&str> { usual(pairs).iter().map(|it| it.0).collect() };
    let shot = ["v_i", "m_p", "R", "h", "rho", "S_y", "C_d"];
    // The damper exponent has no effect without a damper; the scene has no stop.
    assert_eq!(symbols(""), [&["gamma", "d", "k", "n", "b"][..], &shot].concat());
    assert_eq!(usual("")[0], ("gamma", (0.8, 7.0)));
    assert_eq!(usual("")[5], ("v_i", (25.0, 400.0)));
    assert_eq!(symbols("mount=rigid"), shot);
    assert!(symbols("b=10 x_stop=0.02").contains(&"x_stop"));
    assert!(!symbols("k=0").contains(&"n"));
    // With a given face the mass ratio does not determine the size of the plate.
    assert!(!symbols("face=0.1").contains(&"gamma"));
}

/// The scene itself lies between the points: with slips its depth may be outside all of theirs.
#[test]
fn the_range_of_a_row_holds_the_result_of_the_scene() {
    let report = computed("interface=plastic", &Request::default());
    let own = report.own.unwrap().result.unwrap();
    for effect in &report.effects {
        let (least, most) = report.range(effect).unwrap();
        assert!(least <= own && own <= most, "{}: {least} {own} {most}", effect.axis.symbol());
    }
    // A range beside the scene's value does not contain the scene.
    let beside = Request {
        over: vec![Axis::new("v_i", (200.0, 300.0), 2, Spacing::Linear).unwrap()],
        output: None,
    };
    let beside = computed("", &beside);
    assert!(beside.range(&beside.effects[0]).unwrap().0 > own);
}

/// Every point equals the depth of a single run, including perforations and both ends.
#[test]
fn results_are_those_of_single_runs() {
    for pairs in ["", "interface=plastic gamma=4 d=0.02", "mount=rigid h=20mm"] {
        let report = computed(pairs, &Request::default());
        assert_eq!(report.points_least(), POINTS);
        for effect in &report.effects {
            let symbol = effect.axis.symbol();
            for (at, point) in effect.points.iter().enumerate().step_by(4) {
                let mut own = scene(pairs);
                effect.axis.set(&mut own, value_at(&effect.axis, at));
                let run = plain_run(&own).unwrap();
                let pair = (point.unwrap().result, run.penetration.final_m);
                let is_same = match pair {
                    (Some(found), Some(exact)) => (found - exact).abs() <= 1e-7 * exact,
                    (found, exact) => found == exact,
                };
                assert!(is_same, "{symbol} {at}: {pair:?}");
                assert_eq!(point.unwrap().outcome, PointOutcome::from_run(&run), "{symbol} {at}");
            }
        }
    }
}

/// On a rigid mount `m u' = -(S + c u²)`, with `S = S_y A` and `c = C_d rho A/2` once the nose is buried. With `u = v_i`,
/// `dp = m/(2 c) d ln(S + c v_i²)`, so `d p/d v_i = m v_i/(S + c v_i²)`.
#[test]
fn valid_the_slope_over_the_impact_velocity() {
    let base = "mount=rigid R=1e-4 dishing=off h=0.5 m_p=0.001 v_i=50";
    let report = computed(base, &Request::default());
    let own = scene(base);
    let area = std::f64::consts::PI * 1e-8;
    let force = own.target.flow_strength_pa * area
        + 0.5 * own.target.drag_coefficient * own.target.density_kg_m3 * area * 2500.0;
    let slope = report.effect("v_i").unwrap().slope.unwrap();
    // The nose, of 0.1 mm, is a small part of the depth.
    assert!((slope / (0.001 * 50.0 / force) - 1.0).abs() < 1e-3, "{slope} {}", 0.05 / force);
}

/// At the end of the allowed range the slope is one-sided. Without a damper the depth increases with b.
#[test]
fn slopes_at_zero_are_from_above() {
    let report = computed("", &Request::default());
    let depth = |b: &str| plain_run(&scene(b)).unwrap().penetration.final_m.unwrap();
    let slope = report.effect("b").unwrap().slope.unwrap();
    // Richardson extrapolation of forward differences.
    let forward = |h: f64| (depth(&format!("b={h}")) - depth("b=0")) / h;
    let exact = 2.0 * forward(0.5) - forward(1.0);
    assert!((slope / exact - 1.0).abs() < 1e-3, "{slope} {exact}");
}

#[test]
fn a_study_that_is_stopped_has_the_ends_of_all_rows_first() {
    let watch = &mut until::<SensitivityReport>(24);
    let mut context = Context::new(1, watch);
    let report = compute(&Scene::default(), &Request::default(), &mut context).unwrap();
    assert!(report.points_least() < POINTS);
    let ends = |effect: &Effect| effect.points[0].is_some() && effect.points[16].is_some();
    assert!(report.effects.iter().filter(|effect| ends(effect)).count() >= 10);
    assert!(report.effects.iter().all(|effect| effect.slope.is_none()));
    // Cells without computed points are empty.
    let cells = report.effects[0].cells(8);
    assert!(cells[0].is_some() && cells[7].is_some() && cells[1..7].iter().all(Option::is_none));
}

#[test]
fn cells_are_the_middles_of_equal_parts() {
    let mut effect = Effect {
        axis: Axis::new("gamma", (1.0, 9.0), 2, Spacing::Linear).unwrap(),
        own: Some(9.0),
        points: [None; POINTS],
        slope: None,
    };
    let outcome = PointOutcome::Ended(Outcome::Arrested);
    let value = |at: usize| Some(Value { outcome, result: Some(value_at_place(at)) });
    for at in [0, 4, 8, 12, 16] {
        effect.points[at] = value(at);
    }
    // Linear interpolation: 1.5, 2.5, ... 8.5.
    let middles: Vec<Option<f64>> = (0..8).map(|cell| Some(1.5 + f64::from(cell))).collect();
    assert_eq!(effect.cells(8), middles);
    assert_eq!(effect.own_cell(8), Some(7));
    assert_eq!(Effect { own: Some(2.0), ..effect.clone() }.own_cell(8), Some(1));
    assert_eq!(Effect { own: Some(9.5), ..effect }.own_cell(8), None);
}

fn value_at_place(at: usize) -> f64 {
    1.0 + at as f64 / 2.0
}
