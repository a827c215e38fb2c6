//! One impact from first contact to its end, by any contact model.
//!
//! [`run`] takes the contact in closed form where the scene allows it (`contact.rs`), tracks modes and events through the rest
//! (`simulation.rs`, `events.rs`, `termination.rs`) and gathers the [`Run`] (`report.rs`). It is a pure function: no clock, no
//! file, no thread.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::estimate::{self, ROUNDING};
use crate::model::hybrid::{self, Stepping};
use crate::model::run::{EndReason, EstimateBasis, Observer, Outcome, Run, Settings};
use crate::model::scene::Scene;
use crate::model::variables::{self, VariableError};
use crate::numerics::larger;
use problem::Problem;
use simulation::Simulation;
use window::Window;

mod body;
mod contact;
mod crush;
mod events;
mod problem;
mod record;
mod report;
mod simulation;
mod singular_crossing;
mod start;
mod step_control;
mod stiff;
mod straight_core;
mod taylor;
mod termination;
pub mod window;

/// Order of the ordinary computation, plus one.
const TERMS: usize = 17;
/// Order of the second, tighter computation that the error estimate compares with where `hybrid` does not serve, plus one.
const TERMS_CHECK: usize = 21;
/// Tolerance of the second computation per tolerance of the first, and the least: below it there is only rounding.
const TIGHTER: f64 = 1e-3;
const TIGHTEST: f64 = 1e-14;
/// Tolerance of the other engine as the second computation, whatever that of the first: its order is so high that it costs little.
const COLLOCATION: f64 = 1e-12;
/// What both computations may be off by alike where a steep power law of a combination is straight close to zero, relative.
const STRAIGHTENED: f64 = 2e-7;
/// How many times the usual horizon, and how many times as many oscillations, an undecided shot is followed.
const FOLLOWED_HORIZONS: f64 = 50.0;
const FOLLOWED_OSCILLATIONS: usize = 4;

/// Simulate one impact on a valid scene. The observer can look at the run so far through the window.
pub fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>, window: &Window) -> Run {
    let problem = Problem::of(scene);
    let tolerance = scene.run.tolerance;
    let mut simulation = Simulation::new(&problem, tolerance, settings.series);
    simulation.record.window = Some(window);
    let end = compute::<TERMS>(&mut simulation, observer);
    // Rounding adds up over implicit steps, in which large forces hold each other, like a random walk.
    let rounding = ROUNDING * (1.0 + simulation.control.stiff_steps as f64).sqrt();
    let floor = larger(simulation.control.crossing_error, rounding);
    let floor = if problem.straightens() { larger(floor, STRAIGHTENED) } else { floor };
    let mut run = report::gather(&problem, simulation, end);
    if settings.estimate && run.end.is_complete() {
        let is_closed = run.cost.steps == 0;
        let second = second(&problem, &run, &mut |t_s| {
            window.show(|| run.clone());
            observer(t_s)
        });
        let basis =
            if is_closed { EstimateBasis::ClosedForm } else { EstimateBasis::SecondComputation };
        if let Some(second) = second {
            estimate::set(&mut run, &second, basis, floor);
        }
    }
    run
}

/// As [`run`] without a series or an estimate, but for longer: a run that oscillates on undecided is followed for many times as
/// long. The scene has no horizon.
pub fn follow(scene: &Arc<Scene>, observer: Observer<'_>) -> Run {
    let mut problem = Problem::of(scene);
    problem.horizon_s *= FOLLOWED_HORIZONS;
    problem.oscillation_factor = FOLLOWED_OSCILLATIONS;
    let mut simulation = Simulation::new(&problem, scene.run.tolerance, false);
    let end = compute::<TERMS>(&mut simulation, observer);
    report::gather(&problem, simulation, end)
}

fn compute<const N: usize>(simulation: &mut Simulation<'_>, observer: Observer<'_>) -> EndReason {
    simulation.begin();
    let end = simulation.run::<N>(observer);
    let is_cancelled = simulation.follow_loads::<N>(observer) == EndReason::Cancelled;
    if is_cancelled { EndReason::Cancelled } else { end }
}

/// The same at a much tighter tolerance, by the other engine where that serves the scene and comes to an end, else by this one with
/// another order; `None` when it was cancelled. An engine that decides nothing says nothing of one that does, and a closed form is
/// compared with itself.
fn second(problem: &Problem, first: &Run, observer: Observer<'_>) -> Option<Run> {
    if first.cost.steps > 0
        && let Some(run) = hybrid::run(
            &problem.scene,
            hybrid::Extent::BARE,
            Stepping::Collocation(COLLOCATION),
            observer,
        )
    {
        if run.end == EndReason::Cancelled {
            return None;
        }
        let decides = run.outcome != Outcome::Moving || first.outcome == Outcome::Moving;
        if run.end.is_complete() && decides {
            return Some(run);
        }
    }
    let own = problem.has_absorber().then(|| problem.anew());
    let problem = own.as_ref().unwrap_or(problem);
    let tolerance = larger(problem.scene.run.tolerance * TIGHTER, TIGHTEST);
    let mut simulation = Simulation::new(problem, tolerance, false);
    simulation.control.is_second = true;
    let end = compute::<TERMS_CHECK>(&mut simulation, observer);
    (end != EndReason::Cancelled).then(|| report::gather(problem, simulation, end))
}

/// Simulate one impact by this method, without series or error estimate. `None` where the engine does not know the scene.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn step_by(stepping: Stepping, scene: &Arc<Scene>) -> Result<Option<Run>, VariableError> {
    variables::validate(scene)?;
    let go_on = &mut |_: f64| ControlFlow::Continue(());
    Ok(hybrid::run(scene, hybrid::Extent::BARE, stepping, go_on))
}

/// Simulate one impact by Taylor steps alone, also where a closed form exists, without series or error estimate. `None` when these had
/// to be left before the end, on a stiff stretch.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn by_taylor_steps(scene: &Arc<Scene>) -> Result<Option<Run>, VariableError> {
    variables::validate(scene)?;
    let problem = Problem::of(scene);
    let mut simulation = Simulation::new(&problem, scene.run.tolerance, false);
    simulation.control.unit_s = 0.1 * problem.time_scales().contact_s;
    simulation.start();
    if simulation.control.stiff {
        return Ok(None);
    }
    let end = simulation.run::<TERMS>(&mut |_| ControlFlow::Continue(()));
    Ok((simulation.control.stiff_steps == 0).then(|| report::gather(&problem, simulation, end)))
}
