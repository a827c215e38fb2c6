//! The error estimate of a run, held against the true error over a thousand random scenes.
//!
//! Truth comes from a method that is not the engine's: DOP853 at two tolerances that agree. The estimate may not be below the true error by more than a factor of ten, nor above it by more
//! than a thousand except at round-off. Tolerances are drawn with the scenes. Those that fall short are printed
//! (`--nocapture`) as a person would type them; known ones are counted, and the count may only shrink.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra::model::impact::Stepping;
use cmra::model::impact::step_by;
use cmra::model::run::{EstimateBasis, Outcome, Run};
use cmra::model::scene::Scene;
use cmra::model::simulate::{Settings, simulate};
use cmra::study::quantities;

use crate::random::{Random, scene, typed};

/// Number of scenes compared, and of those compared in every run of the tests.
const JUDGED: usize = 1_000;
const SAMPLE: usize = 250;
/// How far below the true error the estimate may be, and how far above.
const BELOW: f64 = 10.0;
const ABOVE: f64 = 1e3;
/// What double precision leaves of any depth, relative.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;
/// Steps a run may take here.
const STEPS_MAX: usize = 20_000;
/// A reference with a greater uncertainty is not used.
const UNCERTAINTY_MAX: f64 = 1e-11;
/// What DOP853 may be off that its two tolerances do not show: it lands on singular zeros within its own rounding.
const EXPLICIT_FLOOR: f64 = 2e-12;
/// An estimate of this part of the tolerance is never too high: it is what the second computation cannot see.
const NOTHING_KNOWN: f64 = 1e-3;
/// Known shortfalls, too low and too high, of the sample and of all. The one too low is DOP853's own: the engine, its seven stages and
/// Radau IIA 5 agree there to 1e-12, and DOP853 is 2e-11 off.
const KNOWN: [(usize, usize); 2] = [(0, 1), (1, 4)];
/// Shots of which every result is compared with itself, and the loose tolerance they are computed at.
const SHOTS: usize = 300;
const LOOSE: f64 = 1e-4;
/// Far below that: errors of this size are rounding.
const NOTHING: f64 = 1e-12;
/// An estimate from here on says that no digit is known, and errors of this part of the tolerance do not count.
const KNOWN_DIGITS: f64 = 0.1;
const NOTHING_ASKED: f64 = 1e-6;
const SEED: u64 = 0x5eed_2007_0412;

/// A run by DOP853, if it came to its end.
fn by_dop853(scene: &Arc<Scene>, tolerance: f64) -> Option<Run> {
    let run = step_by(Stepping::Dop853(tolerance), scene).unwrap()?;
    (run.end.is_complete() && run.outcome != Outcome::Moving).then_some(run)
}

/// The exit time of a perforation, else the depth.
fn measure(run: &Run) -> Option<f64> {
    match run.outcome {
        Outcome::Perforated => run.exit_time_s,
        Outcome::Arrested | Outcome::Separated | Outcome::Moving => run.final_penetration_m,
    }
}

/// How the shot ends, depth or exit time, and how far that may be off.
fn truth(scene: &Arc<Scene>) -> Option<(Outcome, f64, f64)> {
    let (tight, tighter) = (by_dop853(scene, 1e-13)?, by_dop853(scene, 1e-14)?);
    let (value, best) = (measure(&tight)?, measure(&tighter)?);
    let off = (value / best - 1.0).abs() + EXPLICIT_FLOOR;
    (tight.outcome == tighter.outcome).then_some((tighter.outcome, best, off))
}

/// True error and estimate of a run, and how far the truth may be off; nothing where one of them does not exist.
fn errors(scene: &Arc<Scene>) -> Option<(f64, f64, f64)> {
    let mut steps = 0;
    let settings = Settings { estimate: true, ..Settings::BARE };
    let run = simulate(scene, &settings, &mut |_| {
        steps += 1;
        if steps > STEPS_MAX { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let run = run.unwrap();
    let estimate = run.error_estimate?;
    let (outcome, value, off) = truth(scene).filter(|(_, _, off)| *off < UNCERTAINTY_MAX)?;
    let own = measure(&run)?;
    let error = if run.outcome == outcome { (own / value - 1.0).abs() } else { f64::INFINITY };
    Some((error, estimate, off))
}

#[test]
fn the_estimate_is_within_ten_below_and_a_thousand_above_the_true_error() {
    assert_estimates_hold(SAMPLE, KNOWN[0]);
}

#[test]
#[ignore = "takes minutes: a thousand scenes in place of the sample"]
fn all_thousand_estimates_are_within_ten_below_and_a_thousand_above_the_true_error() {
    assert_estimates_hold(JUDGED, KNOWN[1]);
}

fn assert_estimates_hold(count: usize, known: (usize, usize)) {
    let mut random = Random(SEED);
    let (mut judged, mut drawn) = (0, 0);
    let (mut low, mut high) = (0, 0);
    while judged < count {
        drawn += 1;
        // Scenes that move for ever or are too stiff for the reference are skipped.
        assert!(drawn <= count + count / 4, "{judged} of {drawn} could be judged");
        let changes = random.changes();
        let scene = scene(&changes);
        let Some((error, estimate, off)) = errors(&scene) else { continue };
        judged += 1;
        let too_low = error > BELOW * estimate + off;
        let certain = if error > ROUND_OFF + off { error } else { ROUND_OFF + off };
        let too_high = estimate > ABOVE * certain && estimate > NOTHING_KNOWN * scene.run.tolerance;
        (low, high) = (low + usize::from(too_low), high + usize::from(too_high));
        if too_low || too_high {
            let word = if too_low { "too low" } else { "too high" };
            println!("{word}: estimate {estimate:.1e}, error {error:.1e}: {}", typed(&changes));
        }
    }
    println!("{judged} of {drawn} judged; {low} too low, {high} too high");
    assert!(low <= known.0, "{low} estimates too low");
    assert!(high <= known.1, "{high} estimates too high");
}

fn run_of(scene: &Arc<Scene>) -> Run {
    let mut steps = 0;
    let settings = Settings { estimate: true, ..Settings::BARE };
    simulate(scene, &settings, &mut |_| {
        steps += 1;
        if steps > STEPS_MAX { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
    .unwrap()
}

/// What DOP853 says of the end of a contact, by the names of the results.
fn results_by_dop853(scene: &Arc<Scene>) -> Option<(Outcome, Vec<(&'static str, f64)>)> {
    let run = by_dop853(scene, 1e-13)?;
    let names: &[&str] = if run.outcome == Outcome::Perforated {
        &["exit_time_s", "residual_velocity_m_s"]
    } else {
        &[
            "first_arrest_penetration_m",
            "first_arrest_time_s",
            "first_arrest_plate_displacement_m",
            "first_arrest_plate_velocity_m_s",
        ]
    };
    let value = |name: &&'static str| Some((*name, quantities::find(name)?.value(&run)?));
    // A plate that is held has no velocity to be relative to.
    let rows = names.iter().filter_map(value).filter(|(_, value)| *value != 0.0);
    Some((run.outcome, rows.collect()))
}

/// The estimates of time, velocities and displacement, each by itself, at a loose tolerance: none is below the true error by more
/// than a factor of ten. Truth is DOP853 at a tight one.
#[test]
fn each_result_has_an_estimate_of_its_own_that_covers_its_error() {
    let mut random = Random(SEED + 1);
    let (mut judged, mut perforated, mut told) = (0, 0, Vec::new());
    for _ in 0..4 * SHOTS {
        if judged == SHOTS {
            break;
        }
        let mut changes = random.changes();
        let last = changes.len() - 1;
        changes[last].1 = LOOSE;
        let scene = scene(&changes);
        let Some((outcome, rows)) = results_by_dop853(&scene) else { continue };
        let run = run_of(&scene);
        if run.error_estimates.is_empty() || run.outcome != outcome {
            continue;
        }
        judged += 1;
        perforated += usize::from(outcome == Outcome::Perforated);
        for (name, exact) in rows {
            let own = quantities::find(name).unwrap().value(&run).unwrap();
            // What is taken for nothing has no error relative to itself.
            if own == 0.0 {
                continue;
            }
            let estimate = run.error_of(name).unwrap();
            let error = (own / exact - 1.0).abs();
            // What is zero but for rounding has no error relative to itself.
            let is_none = name == "first_arrest_plate_velocity_m_s"
                && exact.abs() < NOTHING * scene.projectile.velocity_m_s;
            if error > BELOW * estimate + NOTHING && !is_none {
                told.push(format!("{name}: {estimate:.1e}, not {error:.1e}: {}", typed(&changes)));
            }
        }
    }
    assert!(judged == SHOTS && perforated > SHOTS / 5, "{perforated} of {judged} perforated");
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// Every estimated result, after the contact too, at a loose tolerance against the same run at a tight one: none is below the error by
/// more than a factor of ten, but for errors a million times below the tolerance, and for values whose estimate says that no digit is
/// known.
#[test]
fn each_estimate_covers_the_difference_to_a_tight_run() {
    let mut random = Random(SEED + 2);
    let (mut judged, mut perforated, mut told) = (0, 0, Vec::new());
    for index in 0..SHOTS {
        let mut changes = random.changes();
        let last = changes.len() - 1;
        changes[last].1 = LOOSE;
        let mut own = Scene::clone(&scene(&changes));
        if index % 3 == 0 {
            own.interface.law = cmra::model::scene::InterfaceLaw::Plastic;
        }
        let run = run_of(&Arc::new(own.clone()));
        own.run.tolerance = 1e-12;
        let tight = run_of(&Arc::new(own));
        if !(run.end.is_complete() && tight.end.is_complete()) || run.outcome != tight.outcome {
            continue;
        }
        judged += 1;
        perforated += usize::from(run.outcome == Outcome::Perforated);
        for (name, relative) in run.error_estimates.iter().filter(|it| it.1 < KNOWN_DIGITS) {
            let column = quantities::find(name).unwrap();
            let Some((own, exact)) = column.value(&run).zip(column.value(&tight)) else { continue };
            let off = (own / exact - 1.0).abs();
            if off > BELOW * relative + NOTHING_ASKED * LOOSE {
                told.push(format!("{name}: {relative:.1e}, not {off:.1e}: {}", typed(&changes)));
            }
        }
    }
    assert!(judged > SHOTS * 9 / 10 && perforated > SHOTS / 5, "{perforated} of {judged}");
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// The exit time at 232.7 m/s on a rigid mount, s.
const EXIT_TIME_S: f64 = 0.000_571_271_081_253_093;

/// Times of closed forms: 232.7 m/s is just above the limit of 232.295 m/s. The time is the integral of dq/u, by
/// tanh-sinh quadrature of the same closed form with 30 digits.
#[test]
fn the_time_of_an_exit_just_above_the_rigid_limit_is_right_to_rounding() {
    let mut own = Scene::default();
    own.plate.mount = cmra::model::scene::Mount::Rigid;
    own.projectile.velocity_m_s = 232.7;
    for series in [true, false] {
        let settings = Settings { series, ..Settings::default() };
        let run = simulate(&Arc::new(own.clone()), &settings, &mut |_| ControlFlow::Continue(()));
        let run = run.unwrap();
        let error = (run.exit_time_s.unwrap() / EXIT_TIME_S - 1.0).abs();
        let estimate = run.error_estimate.unwrap();
        assert!(error < 1e-13, "{error:e}");
        assert!(error <= BELOW * estimate, "{error:e} {estimate:e}");
    }
}

/// Two computations that end differently say nothing of each other.
#[test]
fn an_estimate_from_two_outcomes_is_unknown() {
    let scene = Arc::new(Scene::default());
    let mut run = run_of(&scene);
    let mut second = run.clone();
    second.outcome = Outcome::Perforated;
    second.exit_time_s = Some(1.0);
    run.error_estimates.clear();
    cmra::model::estimate::set(&mut run, &second, EstimateBasis::SecondComputation, 0.0);
    assert_eq!(run.estimate_basis, Some(EstimateBasis::OutcomeDiffers(Outcome::Perforated)));
    assert_eq!(quantities::find("error_estimate").unwrap().value(&run), None);
    assert!(run.error_estimates.is_empty());
}

#[test]
fn a_rigid_or_free_plate_is_held_against_its_closed_form() {
    for (changes, basis) in [
        ("mount=rigid", EstimateBasis::ClosedForm),
        ("k=0", EstimateBasis::ClosedForm),
        ("k=1e5", EstimateBasis::SecondComputation),
        ("mount=rigid horizon=1ms", EstimateBasis::SecondComputation),
    ] {
        let scene = cmra::model::variables::changed(Scene::default(), changes).unwrap();
        let run = run_of(&Arc::new(scene));
        assert_eq!(run.estimate_basis, Some(basis), "{changes}");
        assert!(run.error_of("peak_contact_force_n").unwrap() < 1e-12, "{changes}");
    }
}
