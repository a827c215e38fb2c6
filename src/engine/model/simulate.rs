//! Simulation of a scene: validation, run with the contact model of the scene, and further plates of a stack.
//!
//! All functions are pure: no clock, no file, no thread.

use std::sync::Arc;

use crate::model::appendix::listing;
use crate::model::impact;
use crate::model::plug;
use crate::model::run::{
    AtLeast, ContactMode, Departure, EndReason, ErrorEstimate, MechanismLoad, Outcome, Penetration,
    Run, RunWarning, WORK_MAX,
};
pub use crate::model::run::{Observer, RunSnapshot, Settings};
use crate::model::scene::{ContactModel, InterfaceLaw, Listing, Scene};
use crate::model::stack;
use crate::model::variables::{self, VariableError};

/// Simulates an impact.
///
/// # Errors
/// A [`VariableError`] if the scene is physically impossible, or the interval of rows is not positive. Later problems are reported in
/// [`Run::end`], with the partial results.
pub fn simulate(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    shoot(scene, settings, withhold_perforation, observer)
}

/// Simulates an impact as [`simulate`] does, and returns a perforation also where the law is known to underestimate the limit. For comparisons
/// of numerical methods, which have the law in common.
///
/// # Errors
/// A [`VariableError`] under the same conditions as [`simulate`].
pub fn simulate_by_law_alone(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    shoot(scene, settings, |_| (), observer)
}

/// Simulates an impact by a listing of Appendix A, with any contact model of the scene; without error estimate and rigid-mount run.
///
/// # Errors
/// A [`VariableError`] if the scene is physically impossible.
pub fn simulate_by_listing(
    scene: &Arc<Scene>,
    listing: Listing,
    series: bool,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    Ok(listing::compute(scene, listing, series, observer))
}

/// Runs the plates of a scene one after the other and applies a verdict to each.
fn shoot(
    scene: &Arc<Scene>,
    settings: &Settings,
    conclude: fn(&mut Run),
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    check_rows(settings)?;
    if scene.contact.model == ContactModel::Appendix {
        return Ok(listing::run(scene, *settings, observer));
    }
    let mut run = impact::run(scene, *settings, observer);
    conclude(&mut run);
    let mut unseen = |look: &RunSnapshot<'_>| observer(&RunSnapshot { so_far: &|| None, ..*look });
    let behind = &mut |plate: Scene| shoot(&Arc::new(plate), settings, conclude, &mut unseen);
    run.stack = stack::follow(scene, &mut run, behind)?.map(Arc::new);
    Ok(run)
}

/// Removes outcome, residual velocity and results that depend on them, if the law underestimates the limit and the run perforates.
fn withhold_perforation(run: &mut Run) {
    if !plug::is_law_low(&run.scene) {
        return;
    }
    run.warnings.retain(|warning| *warning != RunWarning::NoBaseline);
    if run.outcome != Outcome::Perforated {
        return;
    }
    let exit_s = run.departure.exit_time_s.unwrap_or(f64::INFINITY);
    run.events.retain(|event| event.t_s < exit_s);
    run.series.retain(|row| row.mode != ContactMode::Perforated);
    let MechanismLoad { added_kg, spring_mass_kg, .. } = run.mechanism;
    *run = Run {
        outcome: Outcome::Unmeasured,
        penetration: Penetration {
            baseline_m: run.penetration.baseline_m,
            ..Penetration::default()
        },
        max_plate_displacement_m: None,
        at_least: AtLeast::default(),
        departure: Departure::default(),
        estimate: ErrorEstimate { basis: run.estimate.basis, ..ErrorEstimate::default() },
        mechanism: MechanismLoad { added_kg, spring_mass_kg, ..MechanismLoad::default() },
        ..std::mem::take(run)
    };
}

/// Checks that the interval of rows is positive.
fn check_rows(settings: &Settings) -> Result<(), VariableError> {
    match settings.every_s.filter(|every_s| !(every_s.is_finite() && *every_s > 0.0)) {
        Some(every_s) => Err(VariableError::Rows { every_s: every_s.to_string() }),
        None => Ok(()),
    }
}

/// Work of a run beside another: a third of that of a run by itself.
const BESIDE_WORK_MAX: usize = WORK_MAX / 3;

/// Runs the same shot with a plastic interface, without series and estimate, for comparison with a fused one. Returns `None` for a stack, a
/// scene without interface or with the plastic law, and if the observer cancels.
fn plastic_beside(scene: &Scene, observer: Observer<'_>) -> Option<Run> {
    let is_fused = scene.interface.law == InterfaceLaw::Fused
        && scene.contact.model == ContactModel::Hydrodynamic
        && scene.is_sprung();
    if !is_fused || scene.is_stack() {
        return None;
    }
    let mut plastic = scene.clone();
    plastic.interface.law = InterfaceLaw::Plastic;
    let settings = Settings { work_max: Some(BESIDE_WORK_MAX), ..Settings::BARE };
    let run = simulate(&Arc::new(plastic), &settings, observer).ok()?;
    (run.end != EndReason::Cancelled).then_some(run)
}

/// Simulates an impact, and beside a complete run with a fused interface the same shot with a plastic one. Between the two, `took_s` gives
/// the time of the first, s: the model has no clock.
///
/// # Errors
/// A [`VariableError`] under the same conditions as [`simulate`].
pub fn simulate_beside_plastic(
    scene: &Arc<Scene>,
    settings: &Settings,
    took_s: &mut dyn FnMut() -> f64,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    let mut run = simulate(scene, settings, observer)?;
    run.cost.took_s = Some(took_s());
    if run.end.is_complete() {
        run.plastic = plastic_beside(scene, observer).map(Arc::new);
    }
    Ok(run)
}

/// Runs a scene without time series and error estimate, for tests.
#[cfg(test)]
pub(in crate::model) fn bare_run(scene: &Scene) -> Run {
    let go_on = &mut |_: &RunSnapshot<'_>| std::ops::ControlFlow::Continue(());
    simulate(&Arc::new(scene.clone()), &Settings::BARE, go_on).expect("a valid scene")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::run::{EVERY_ROWS_MAX, EventKind};
    use crate::model::variables::scene_with;

    fn run(pairs: &str, every_s: f64) -> Result<Run, VariableError> {
        let settings = Settings { every_s: Some(every_s), ..Settings::SERIES };
        let go_on = &mut |_: &RunSnapshot<'_>| std::ops::ControlFlow::Continue(());
        simulate(&Arc::new(scene_with(pairs)), &settings, go_on)
    }

    /// A cylinder of 20 mm at 400 m/s: 12 mm of steel are 0.6 of it, 11.9 mm less. The base plate behind is not struck by it.
    #[test]
    fn a_law_that_is_low_says_of_no_shot_that_it_perforates() {
        let steel =
            "nose=blunt m_p=197g R=10mm rho=7850 closure=cylindrical E=200GPa Y=490MPa UTS=567MPa";
        for (more, outcome) in [
            ("h=12mm v_i=400", Outcome::Perforated),
            ("h=11.9mm v_i=400", Outcome::Unmeasured),
            ("h=11.9mm v_i=400 mount=sprung k=1e6 m_2=1", Outcome::Unmeasured),
            ("h=11.9mm v_i=100", Outcome::Arrested),
            ("h=11.9mm v_i=400 h_base=50mm", Outcome::Unmeasured),
        ] {
            let run = bare_run(&scene_with(&format!("mount=rigid {steel} {more}")));
            assert_eq!(run.shot_outcome(), outcome, "{more}");
            if outcome == Outcome::Unmeasured {
                assert_eq!(
                    (run.departure.residual_velocity_m_s, run.departure.exit_time_s),
                    (None, None),
                    "{more}"
                );
                assert!(run.events.iter().all(|event| event.kind != EventKind::Perforation));
                assert!(run.stack.is_none_or(|stack| stack.behind.is_empty()), "{more}");
            }
        }
    }

    #[test]
    fn rows_that_do_not_follow_each_other_are_refused_and_their_number_is_bounded() {
        for every_s in [0.0, -0.0, -1e-6, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(run("", every_s).unwrap_err().to_string().contains("greater than 0 s"));
        }
        let rows = run("gamma=1 k=0 horizon=1ms", 1e-300).unwrap().series.len();
        assert_eq!(rows, EVERY_ROWS_MAX);
    }
}
