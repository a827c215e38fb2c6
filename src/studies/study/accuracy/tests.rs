//! Errors fall with the parameter, orders are what theory says, refused points keep their rows, floors are kept. No time is asserted.

use std::collections::HashMap;

use super::reference::{ReferenceSource, stored};
use super::*;
use crate::study::changed_free_plate;
use crate::study::context::{Progress, never_cancel};
use cmra_engine::model::reference::Stored;
use cmra_engine::model::run::{EndReason, Outcome};

fn scene(pairs: &str) -> Arc<Scene> {
    Arc::new(changed_free_plate(pairs).unwrap())
}

fn report(scene: &Arc<Scene>, ladder: SettingGrid) -> AccuracyReport {
    report_within(scene, ladder, usize::MAX)
}

/// A comparison to its end, by a clock that ticks once a look: no repeats are made, since each seems to take long.
fn report_within(scene: &Arc<Scene>, ladder: SettingGrid, evaluations: usize) -> AccuracyReport {
    let mut ticks = 0.0;
    let clock = &mut || {
        ticks += 1.0;
        ticks
    };
    let effort = ComparisonOptions { ladder, point_s: 0.0, evaluations };
    compare(scene, effort, clock, &mut Context::new(1, &mut never_cancel)).unwrap()
}

fn compared(pairs: &str, ladder: SettingGrid) -> HashMap<char, MethodReport> {
    let methods = report(&scene(pairs), ladder).methods.into_iter();
    methods.map(|method| (method.method.letter(), method)).collect()
}

/// A run of the scene may have no end.
#[test]
fn a_comparison_on_an_endless_scene_is_stopped() {
    let scene = scene("k=1e5 n=0.3 run.horizon_s=1e9");
    let stops = &mut |_: Progress, _: Option<&AccuracyReport>| ControlFlow::Break(());
    let effort = ComparisonOptions::FULL;
    let found = compare(&scene, effort, &mut || 0.0, &mut Context::new(1, stops)).unwrap();
    assert!(found.references.any().is_none() && found.run_s.is_none());
}

/// The whole run: greatest displacement and forces of a sprung plate, velocity and time behind a thin one, or of one that pulls out.
#[test]
fn whole_runs_are_compared_in_every_result_they_have() {
    for (pairs, results) in [
        ("k=1e5 b=50", [true, true, true, true, false, false, true]),
        ("h=0.003 v_i=400", [false, true, false, true, true, true, false]),
        ("k=7.5e6 interface=plastic", [true, true, true, true, true, true, true]),
    ] {
        let methods = compared(pairs, SettingGrid::Quick);
        for letter in ['A', 'N', 'D', 'I', 'E'] {
            let (_, finest) = methods[&letter].measured().next_back().unwrap();
            assert_eq!(finest.errors.exist(), results, "{pairs}: {letter}");
            let within = if letter == 'E' { 1e-6 } else { 1e-9 };
            assert!(finest.error() < within, "{pairs}: {letter} {:?}", finest.errors);
            assert!(
                finest.errors.get(Compared::MountForce).is_none_or(|error| error < 1e-6),
                "{pairs}: {letter}"
            );
        }
        // The kernel knows nothing beyond the contact.
        for (_, contact) in methods[&'L'].measured() {
            let is_of_contact = |of| matches!(of, Compared::Depth | Compared::Time);
            assert!(contact.errors.known().all(|(of, _)| is_of_contact(of)), "{pairs}");
        }
    }
}

/// Other contact models, a stack, and a cylinder below the measured range: the methods have the law in common, whatever it is.
#[test]
fn methods_are_compared_for_every_contact_model_and_for_stacks() {
    let blunt = "nose=blunt m_p=197g R=10mm rho=7850 closure=cylindrical E=200GPa Y=490MPa UTS=567MPa \
                 h=11.9mm v_i=400 mount=rigid";
    for pairs in [
        "k=1e5 b=50 model=half-sine",
        "k=1e5 b=50 model=initial-velocity",
        "k=1e5 b=50 model=lumped k_load=1e7 k_unload=3e7",
        "k=1e5 b=50 h=3mm v_i=200 h_base=20mm",
        blunt,
    ] {
        let methods = compared(pairs, SettingGrid::Quick);
        for letter in ['A', 'N', 'D', 'I'] {
            let finest = methods[&letter].measured().next_back();
            let (_, finest) = finest.unwrap_or_else(|| panic!("{pairs}: {letter}"));
            assert!(finest.error() < 1e-8, "{pairs}: {letter} {:?}", finest.errors);
        }
        // Without a contact there is no time to divide into steps.
        if pairs != blunt && !pairs.contains("initial-velocity") {
            let refusals = methods[&'T'].refusals();
            assert_eq!(refusals[0].0, Refusal::OtherContact.message(), "{pairs}");
        }
    }
    let stack = scene("k=1e5 b=50 h=3mm v_i=200 h_base=20mm");
    let references = References::from_scene(&stack, &mut |_| ControlFlow::Continue(()));
    // Deeper than the first plate: the depth of the whole shot.
    assert!(references.engine.unwrap().results.get(Compared::Depth).unwrap() > 3e-3);
}

#[test]
fn tight_parameters_of_every_accurate_method_reach_the_reference() {
    let scenes =
        ["k=1e5", "k=1e6 n=0.5", "b=2000 k=1e5", "", "d=0.5 k=1e5", "h=0.003 v_i=400 k=1e5"];
    for pairs in scenes {
        let methods = compared(pairs, SettingGrid::Full);
        for letter in "DILNA".chars() {
            let method = &methods[&letter];
            assert!(matches!(method.reference.unwrap().basis, ReferenceSource::Stored(_)));
            let least = method.min_error().unwrap();
            assert!(least < 1e-9, "{pairs}: {letter} {least:e}");
            let first = method.measured().next().unwrap().1.error();
            assert!(first >= least);
        }
    }
}

#[test]
fn every_error_has_a_reference_of_other_steps_and_none_lies_below_its_uncertainty() {
    for (pairs, others) in [
        ("mount=rigid", ReferenceSource::Dop853),
        ("k=2e5 n=1.5", ReferenceSource::Dop853),
        ("k=1e5 theta=30deg", ReferenceSource::Dop853),
        ("k=1e5 x_stop=0.001", ReferenceSource::Dop853),
        ("k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e9", ReferenceSource::Dop853),
        ("b=1e8 gamma=1e-4", ReferenceSource::Radau),
    ] {
        let report = report(&scene(pairs), SettingGrid::Quick);
        for method in &report.methods {
            // The listing knows no stop.
            let Some(reference) = method.reference else {
                assert_eq!(method.method, Method::ThesisPrinted, "{pairs}");
                continue;
            };
            let floor = reference.uncertainty.unwrap();
            match method.method {
                Method::ThesisPrinted => {}
                Method::Auto | Method::Full => assert_eq!(reference.basis, others, "{pairs}"),
                _ => assert_eq!(reference.basis, ReferenceSource::Engine, "{pairs}"),
            }
            assert!(floor < 1e-9 || method.method == Method::ThesisPrinted, "{floor:e}");
            for (_, measured) in method.measured() {
                assert!(measured.error() >= floor);
            }
        }
    }
}

/// At its coarsest step the Runge-Kutta method finds no end on a spring that is steep at zero. At the next it does, in more evaluations than
/// the ten that are allowed here.
#[test]
fn a_point_of_much_work_is_the_last_of_its_method_and_a_failed_one_is_not() {
    let report = report_within(&scene("k=1e7 n=0.5"), SettingGrid::Quick, 10);
    let method = |it: &&MethodReport| it.method == Method::Rk4Events;
    let points = &report.methods.iter().find(method).unwrap().points;
    let results: Vec<_> = points.iter().map(|point| point.result.err()).collect();
    let gave_up = Some(Refusal::Ended(EndReason::StepBudget));
    assert_eq!(results[..3], [gave_up, None, Some(Refusal::TooMuchWork)], "{results:?}");
}

/// Nothing decides this run within its evaluations: each method that chooses its steps tries it once.
#[test]
fn a_tolerance_that_takes_too_many_evaluations_is_the_last_of_its_method() {
    let report = report(&scene("interface=plastic g=0 n=0.26 k=4e7 b=3 m=2"), SettingGrid::Quick);
    for method in &report.methods {
        let is_given_up = |point: &&Point| {
            !point.parameter.is_step() && point.result.is_err_and(Refusal::is_of_work)
        };
        assert!(method.points.iter().filter(is_given_up).count() <= 1, "{method:?}");
    }
}

/// A report of points with a tolerance, an error and a run time each.
fn made_up(points: &[(f64, f64, f64)]) -> MethodReport {
    let point = |(tolerance, depth_error, min_s): &(f64, f64, f64)| {
        let errors = Results::new(|of| match of {
            Compared::Depth => Some(*depth_error),
            Compared::Time => Some(0.0),
            _ => None,
        });
        let answer = Answer {
            outcome: Outcome::Arrested,
            results: Results::new(|of| errors.get(of).map(|_| 1.0)),
            steps: 1,
            rejected: 0,
            evaluations: 1,
        };
        let found = Measured { answer, errors, floor: 1e-16, min_s: *min_s };
        Point { parameter: Parameter::Tolerance(*tolerance), result: Ok(found) }
    };
    let points = points.iter().map(point).collect();
    MethodReport { method: Method::Dop853, reference: None, points }
}

#[test]
fn a_lucky_hit_is_not_the_answer() {
    let report = made_up(&[(1e-3, 1e-9, 1.0), (1e-4, 1e-5, 2.0), (1e-5, 1e-7, 3.0)]);
    assert_eq!(report.cheapest(1e-6).unwrap().parameter, Parameter::Tolerance(1e-5));
    assert_eq!(report.cheapest(1e-8), None);
}

#[test]
fn of_points_that_cost_the_same_the_coarsest_answers() {
    let report = made_up(&[(1e-3, 0.0, 1.02), (1e-4, 0.0, 1.0), (1e-5, 0.0, 1.04)]);
    assert_eq!(report.cheapest(1e-6).unwrap().parameter, Parameter::Tolerance(1e-3));
}

#[test]
fn every_row_of_the_stored_digits_is_found_by_its_scene() {
    for row in Stored::rows() {
        let (found, uncertainty) = stored(&scene(&row.changes)).unwrap();
        assert_eq!(found, row);
        let expected = if row.name == "S13" { 1e-14 } else { f64::EPSILON };
        assert!((uncertainty / expected - 1.0).abs() < 1e-12, "{}", row.name);
    }
    assert_eq!(Stored::rows().count(), 10);
    assert_eq!(stored(&scene("k=1e5 interface=plastic")), None);
    assert_eq!(stored(&scene("k=1.001e5")), None);
}
