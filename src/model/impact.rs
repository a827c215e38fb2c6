//! One impact from first contact to its end.
//!
//! [`simulate`] validates the scene, takes the contact in closed form where the scene allows it (`contact.rs`), tracks modes
//! and events through the rest (`track.rs`, `events.rs`, `verdict.rs`) and gathers the [`Run`] (`report.rs`). It is a pure
//! function: no clock, no file, no thread.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::interaction;
use crate::model::run::{EndReason, ErrorEstimate, EstimateBasis, Outcome, Run};
use crate::model::scene::Scene;
use crate::model::stack;
use crate::model::variables::{self, VariableError};
use crate::numerics::larger;
use problem::Problem;
use track::Track;
use window::Window;

mod contact;
mod events;
pub mod forced;
mod guard;
pub mod lean;
mod overdue;
mod problem;
mod record;
mod report;
mod start;
mod stiff;
mod stride;
mod taylor;
mod track;
mod verdict;
mod watch;
pub mod window;

/// Order of the ordinary computation, plus one.
const TERMS: usize = 17;
/// Order of the second, tighter computation that the error estimate compares with, plus one.
const TERMS_CHECK: usize = 21;
/// Tolerance of the second computation per tolerance of the first.
const TIGHTER: f64 = 1e-3;
/// Rounding that no second computation can see, relative.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What a run should deliver besides its results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Keep the series to draw from.
    pub series: bool,
    /// Compute the error estimate (a second, tighter computation).
    pub estimate: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { series: true, estimate: true }
    }
}

/// Asked before every step with the time reached, s; `Break` ends the run as cancelled.
pub type Observer<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

/// Simulate one impact.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense. Anything that goes wrong later is told in
/// [`Run::end`], with the part that was computed.
pub fn simulate(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    simulate_openly(scene, settings, observer, &Window::default())
}

/// As [`simulate`], with a window through which the observer can look at the run so far. Other interaction models than the engine's
/// own, and the plates of a stack behind the first, show nothing.
///
/// # Errors
/// As [`simulate`].
pub fn simulate_openly(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
    window: &Window,
) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    if let Some(run) = interaction::simulate(scene, *settings, observer) {
        return Ok(run);
    }
    let problem = Problem::of(scene);
    let tolerance = scene.run.tolerance;
    let mut track = Track::new(&problem, tolerance, settings.series);
    track.record.window = Some(window);
    let end = compute::<TERMS>(&mut track, observer);
    let by_strides = track.stride_error;
    let mut run = report::gather(&problem, track, end);
    if settings.estimate && run.end.is_complete() {
        let watched = &mut |t_s| {
            window.show(|| run.clone());
            observer(t_s)
        };
        run.error_estimate = estimate(&problem, &run, by_strides, watched);
    }
    run.stack = stack::follow(scene, &mut run, *settings, observer)?.map(Arc::new);
    Ok(run)
}

/// How many times the usual horizon, and how many times as many swings, an undecided shot is followed.
const FOLLOWED: f64 = 50.0;
const PATIENCE: usize = 4;

/// As [`simulate`] without a series, an estimate or a horizon of the scene's own, but for longer: a run of the engine that swings on
/// undecided is followed for many times as long. For the outcome of a shot that an ordinary run leaves undecided.
///
/// # Errors
/// As [`simulate`].
pub fn follow(scene: &Arc<Scene>, observer: Observer<'_>) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    let mut own = Scene::clone(scene);
    own.run.horizon_s = None;
    let own = Arc::new(own);
    let settings = Settings { series: false, estimate: false };
    if let Some(run) = interaction::simulate(&own, settings, observer) {
        return Ok(run);
    }
    let mut problem = Problem::of(&own);
    problem.horizon_s *= FOLLOWED;
    problem.patience = PATIENCE;
    let mut track = Track::new(&problem, own.run.tolerance, false);
    let end = compute::<TERMS>(&mut track, observer);
    Ok(report::gather(&problem, track, end))
}

fn compute<const N: usize>(track: &mut Track<'_>, observer: Observer<'_>) -> EndReason {
    track.begin();
    track.run::<N>(observer)
}

/// The difference to a computation of another order at a much tighter tolerance, but not below what the strides, which both have in
/// common, say of themselves; rounding alone for closed forms.
fn estimate(
    problem: &Problem,
    run: &Run,
    by_strides: f64,
    observer: Observer<'_>,
) -> Option<ErrorEstimate> {
    let measure = |run: &Run| match run.outcome {
        Outcome::Perforated => run.exit_time_s,
        Outcome::Arrested | Outcome::Separated | Outcome::Moving => run.final_penetration_m,
    };
    let value = measure(run)?;
    if run.cost.steps == 0 {
        return Some(ErrorEstimate { relative: ROUNDING, basis: EstimateBasis::ClosedForm });
    }
    let mut track = Track::new(problem, run.scene.run.tolerance * TIGHTER, false);
    let end = compute::<TERMS_CHECK>(&mut track, observer);
    if end == EndReason::Cancelled {
        return None;
    }
    let second = measure(&report::gather(problem, track, end))?;
    let relative = ((value - second) / second).abs();
    let relative = larger(larger(relative, by_strides), ROUNDING);
    Some(ErrorEstimate { relative, basis: EstimateBasis::SecondComputation })
}
