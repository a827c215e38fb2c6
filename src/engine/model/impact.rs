//! Simulation of an impact from first contact to its end; a pure function without clock, file or thread.
//!
//! `parameters` has what a scene gives, `equations` the equations of motion. `state` is the mechanical state, `modes` the discrete ones,
//! `transitions` leads from one to the next, `events` has the event functions of each. `reduced_system` selects the active degrees of
//! freedom; `plate_lock` locks the plate while a stiff spring holds it. `run` is the integration loop, and `method` lists the methods;
//! `fused_swing` goes from event to event without steps, `zero_passage` across the singular zero of a spring. `outcome` decides by energy
//! (`energy_bounds`) when the run ends. `dense_output` has the states on a step, `recorder` accumulates rows, work and peak forces (`loads`),
//! `free_oscillation` what the method damps, `contact_end` how well the end of a contact is known, `farthest` the maximum
//! displacement, and `results` builds the [`Run`]. `resolution` has the tolerances that several of them share.

use std::sync::Arc;

use crate::model::closed_form;
use crate::model::estimate;
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::resolution::{NEGLIGIBLE, ROUNDING, TOLERANCE_RATIO};
use crate::model::mechanism::Mechanism;
use crate::model::run::{EndReason, EstimateBasis, Observer, Run, RunSnapshot, Settings, WORK_MAX};
use crate::model::scene::{ContactModel, Scene};
use crate::model::stack;
use crate::model::variables::{self, VariableError};
use crate::numerics::collocation::{ELEVEN, RADAU_IIA_17, SEVEN, THREE};
use crate::numerics::explicit::{Dop853, Rk4};
use crate::numerics::larger;
pub use method::IntegrationMethod;

mod contact_end;
mod dense_output;
mod energy_bounds;
mod equations;
mod events;
mod farthest;
mod free_oscillation;
mod fused_swing;
mod loads;
mod method;
mod modes;
mod outcome;
mod parameters;
mod plate_lock;
mod recorder;
mod reduced_system;
mod resolution;
mod results;
mod rule;
mod run;
mod state;
#[cfg(test)]
mod tests;
mod transitions;
mod weight;
mod zero_passage;

/// Tolerance of the steps of the second computation, relative to that of the first, for laws that are not analytic at zero. Towards these
/// zeros both computations take equal steps, and two stages more leave less than a hundredth of the error; a tighter tolerance would only
/// add steps.
const SECOND_FACTOR_AT_ZEROS: f64 = 1e-1;

/// Simulates one impact on a valid scene; [`simulate`](super::simulate::simulate) checks it.
pub(super) fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let stepping = IntegrationMethod::Collocation(local_tolerance(scene));
    let run = run_by(scene, settings, stepping, observer);
    if settings.estimate && run.end.is_complete() {
        with_estimate(run, settings.most_work(f64::INFINITY), observer)
    } else {
        run
    }
}

/// Runs an impact of a valid scene with a method, for every contact model except the listing of the Appendix.
fn run_by(
    scene: &Arc<Scene>,
    settings: Settings,
    stepping: IntegrationMethod,
    observer: Observer<'_>,
) -> Run {
    let setup = |tolerance: f64| ImpactParameters::from_scene(scene, tolerance).by(stepping);
    let is_analytic = Mechanism::from_scene(scene).is_analytic();
    match stepping {
        IntegrationMethod::Collocation(tolerance)
        | IntegrationMethod::CollocationInFull(tolerance) => {
            let setup = setup(tolerance);
            if is_analytic {
                run::run(scene, &setup, &SEVEN.to(tolerance), settings, observer)
            } else {
                run::run(scene, &setup, &RADAU_IIA_17.to(tolerance), settings, observer)
            }
        }
        IntegrationMethod::Second(first) => {
            let fraction = if is_analytic { TOLERANCE_RATIO } else { SECOND_FACTOR_AT_ZEROS };
            let tolerance = larger(fraction * first, ROUNDING);
            let setup = setup(tolerance);
            if is_analytic {
                run::run(scene, &setup, &RADAU_IIA_17.for_second(tolerance), settings, observer)
            } else {
                run::run(scene, &setup, &ELEVEN.for_second(tolerance), settings, observer)
            }
        }
        IntegrationMethod::Radau5(tolerance) => {
            run::run(scene, &setup(tolerance), &THREE.to(tolerance), settings, observer)
        }
        IntegrationMethod::Dop853(tolerance) => {
            run::run(scene, &setup(tolerance), &Dop853 { tolerance }, settings, observer)
        }
        IntegrationMethod::Rk4(step) => {
            run::run(scene, &setup(NEGLIGIBLE), &Rk4 { step, locates: true }, settings, observer)
        }
        IntegrationMethod::Rk4WithoutEvents(step) => {
            run::run(scene, &setup(NEGLIGIBLE), &Rk4 { step, locates: false }, settings, observer)
        }
    }
}

/// Error of each step for the tolerance of a scene.
fn local_tolerance(scene: &Scene) -> f64 {
    larger(TOLERANCE_RATIO * scene.run.tolerance, ROUNDING)
}

/// Runs a scene and estimates the errors of the run, from closed forms or a second computation by another member of the family of methods.
///
/// The two computations share the evaluation budget `work_max`. If it is exhausted, the errors are unknown.
fn with_estimate(mut run: Run, work_max: usize, observer: Observer<'_>) -> Run {
    let scene = Arc::clone(&run.scene);
    let exact = closed_form::results(&scene).map(|exact| (exact, EstimateBasis::ClosedForm));
    let (second, basis) = exact.unwrap_or_else(|| {
        let shown = &mut |look: &RunSnapshot<'_>| {
            observer(&RunSnapshot { so_far: &|| Some(run.clone()), ..*look })
        };
        let stepping = IntegrationMethod::Second(local_tolerance(&scene));
        let work_max = Some(work_max.saturating_sub(run.cost.work()));
        let settings = Settings { work_max, ..Settings::BARE };
        (run_by(&scene, settings, stepping, shown), EstimateBasis::SecondComputation)
    });
    if second.end != EndReason::Cancelled {
        estimate::set(&mut run, &second, basis);
    }
    run
}

/// Simulates a shot by a given method and the law alone, without series or error estimate: one plate, or a stack plate by plate. `None` for
/// the listing of the Appendix, which has a scheme of its own. The observer may cancel the run.
///
/// # Errors
/// A [`VariableError`] if the scene is physically impossible.
pub fn step_by(
    stepping: IntegrationMethod,
    scene: &Arc<Scene>,
    observer: Observer<'_>,
) -> Result<Option<Run>, VariableError> {
    shoot_by(stepping, scene, Settings::BARE, observer)
}

/// Simulates a shot as [`step_by`] does, with as much work as a reference may take, whose steps are smaller.
///
/// # Errors
/// A [`VariableError`] if the scene is physically impossible.
pub fn reference_by(
    stepping: IntegrationMethod,
    scene: &Arc<Scene>,
    observer: Observer<'_>,
) -> Result<Option<Run>, VariableError> {
    let work_max = Some(3 * WORK_MAX);
    shoot_by(stepping, scene, Settings { work_max, ..Settings::BARE }, observer)
}

fn shoot_by(
    stepping: IntegrationMethod,
    scene: &Arc<Scene>,
    settings: Settings,
    observer: Observer<'_>,
) -> Result<Option<Run>, VariableError> {
    variables::validate(scene)?;
    if scene.contact.model == ContactModel::Appendix {
        return Ok(None);
    }
    let mut run = run_by(scene, settings, stepping, observer);
    let behind = &mut |plate: Scene| {
        shoot_by(stepping, &Arc::new(plate), settings, observer).map(Option::unwrap_or_default)
    };
    run.stack = stack::follow(scene, &mut run, behind)?.map(Arc::new);
    Ok(Some(run))
}
