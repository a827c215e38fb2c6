//! Numerical stability: test scenes (stiff or extreme), one scene over the tolerance, and the stability map of a method with a fixed step
//! size.
//!
//! The constants below are the requirements on `auto`. This module depends on neither files nor threads nor screens; the clock is passed by
//! the caller.

use crate::study::accuracy::method::{answer_of, first_arrest_of};
use crate::study::accuracy::reference::{Reference, ReferenceSource, References};
use crate::study::context::{CancelFlag, Context};
use cases::Case;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::VariableError;

pub mod cases;
pub mod map;
pub mod scene;

/// Largest allowed energy residual of `auto`, relative to the energy at the start.
pub const RESIDUAL_MAX: f64 = 1e-8;
/// Largest allowed relative error of any result of `auto`.
pub const ERROR_MAX: f64 = 1e-8;

enumeration! {
    /// Reason for a failed requirement.
    pub enum FailureReason in ShortfallRow {
        /// A short text.
        words: &'static str,
    }
    /// The run ended early.
    Incomplete { words: "ended early" }
    /// A result is not finite.
    NotFinite { words: "not finite" }
    /// The energy residual is above [`RESIDUAL_MAX`].
    Energy { words: "energy" }
    /// The error is above [`ERROR_MAX`].
    Error { words: "error" }
}

/// Result of a test scene.
#[derive(Clone, Debug)]
pub struct Row {
    /// Scene.
    pub case: &'static Case,
    /// Run by `auto`.
    pub run: Run,
    /// Run time, s.
    pub took_s: f64,
    /// Largest relative error of depth, times, displacement, velocity and forces, of an undecided outcome that of the first arrest; NaN if the
    /// outcome differs from that of the reference.
    pub error: Option<f64>,
    /// Source of the reference; `None` if no method finished.
    pub basis: Option<ReferenceSource>,
    /// Requirement that `auto` fails; `None` if it meets all.
    pub shortfall: Option<FailureReason>,
}

/// Returns the test scenes; every fifth one if `quick`.
pub fn battery(quick: bool) -> Vec<&'static Case> {
    cases::CASES.iter().step_by(if quick { 5 } else { 1 }).collect()
}

/// Runs the cases, timed by the clock `now_s`, and reports rows in their order; a stopped study returns the finished ones.
pub fn run(
    cases: &[&'static Case],
    now_s: &(dyn Fn() -> f64 + Sync),
    context: &mut Context<'_, [Row]>,
) -> Result<Vec<Row>, VariableError> {
    let stop = context.stop();
    for case in cases {
        case.scene()?;
    }
    let examine = |case: &&'static Case| examine(case, now_s, &stop);
    context.expect(cases.len());
    let show = |context: &mut Context<'_, [Row]>, rows: &[Row]| context.show(rows);
    Ok(context.map_items(cases, examine, show))
}

/// Runs a test scene; `None` if the study is stopped (or the case is invalid, which a test excludes).
fn examine(
    case: &'static Case,
    now_s: &(dyn Fn() -> f64 + Sync),
    stop: &CancelFlag,
) -> Option<Row> {
    let scene = case.scene().ok()?;
    let start_s = now_s();
    let run = simulate(&scene, &Settings::BARE, &mut |_| stop.flow()).ok()?;
    let took_s = now_s() - start_s;
    let reference = reference_of(&run, stop);
    let error = reference.and_then(|reference| error_of(&run, &reference));
    let basis = reference.filter(|_| error.is_some()).map(|reference| reference.basis);
    let shortfall = shortfall(&run, error);
    let row = Row { case, run, took_s, error, basis, shortfall };
    (!stop.is_set()).then_some(row)
}

/// Returns the reference for a run by another family of methods, or else by the engine at a tighter tolerance; for an undecided run that of
/// its first arrest.
fn reference_of(run: &Run, stop: &CancelFlag) -> Option<Reference> {
    let references = match answer_of(run) {
        Ok(_) => References::from_scene,
        Err(_) => References::of_first_arrest,
    };
    let References { engine, other } = references(&run.scene, &mut |_| stop.flow());
    other.or(engine)
}

/// Returns the largest error of the results that the reference has; `None` if the outcome of the run is undecided and that of the reference
/// is not.
fn error_of(run: &Run, reference: &Reference) -> Option<f64> {
    let answer = match reference.outcome {
        Outcome::Moving => first_arrest_of(run),
        _ => answer_of(run).ok(),
    }?;
    if answer.outcome != reference.outcome {
        return Some(f64::NAN);
    }
    Some(reference.error_of_all(&run.scene, &answer.results))
}

fn shortfall(run: &Run, error: Option<f64>) -> Option<FailureReason> {
    let residual = run.ledger.residual();
    let results = [
        run.penetration.final_m,
        run.departure.exit_time_s,
        run.departure.residual_velocity_m_s,
        run.max_plate_displacement_m,
        run.peak_contact_force_n,
        Some(residual),
    ];
    if !run.end.is_complete() {
        Some(FailureReason::Incomplete)
    } else if results.iter().flatten().any(|value| !value.is_finite()) {
        Some(FailureReason::NotFinite)
    } else if residual.abs() > RESIDUAL_MAX {
        Some(FailureReason::Energy)
    } else {
        // The error is NaN if the outcome of the reference differs: a failure, too.
        error.filter(|error| error.is_nan() || *error > ERROR_MAX).map(|_| FailureReason::Error)
    }
}

#[cfg(test)]
mod tests;
