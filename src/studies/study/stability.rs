//! Numerical stability: a battery of stiff and extreme scenes, and a map of where a fixed-step method is stable.
//!
//! The requirements on `auto` are the constants below. Must not know files, threads, screens or the clock itself.

use crate::study::accuracy::method::answer_of;
use crate::study::accuracy::reference::{Reference, ReferenceSource, References};
use crate::study::context::{CancelFlag, Context};
use cases::Case;
use cmra_engine::model::run::Run;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::VariableError;

pub mod cases;
pub mod map;

/// Greatest relative energy residual a row of `auto` may have.
pub const RESIDUAL_MAX: f64 = 1e-8;
/// Greatest relative error of any result a row of `auto` may have.
pub const ERROR_MAX: f64 = 1e-8;

enumeration! {
    /// Why a row falls short.
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

/// Result of one scene of the battery.
#[derive(Clone, Debug)]
pub struct Row {
    /// The scene.
    pub case: &'static Case,
    /// The run by `auto`.
    pub run: Run,
    /// Time of that run, s.
    pub took_s: f64,
    /// The greatest error of its results: depth, times, displacement, velocity, forces; NaN where its outcome is not the reference's.
    pub error: Option<f64>,
    /// Source of the reference; `None` if undecided, or if no other method finished.
    pub basis: Option<ReferenceSource>,
    /// Why `auto` falls short, if it does.
    pub shortfall: Option<FailureReason>,
}

/// The cases of a battery; the quick one has every fifth.
pub fn battery(quick: bool) -> Vec<&'static Case> {
    cases::CASES.iter().step_by(if quick { 5 } else { 1 }).collect()
}

/// Run these cases, each measured by the clock `now_s`, and show the rows as they come, in the order of the cases. Fewer than those
/// when stopped.
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

/// Run one scene of the battery; `None` when stopped, or for a case that is not a scene, which a test rules out.
fn examine(
    case: &'static Case,
    now_s: &(dyn Fn() -> f64 + Sync),
    stop: &CancelFlag,
) -> Option<Row> {
    let scene = case.scene().ok()?;
    let start_s = now_s();
    let run = simulate(&scene, &Settings::BARE, &mut |_| stop.flow()).ok()?;
    let took_s = now_s() - start_s;
    let references = References::from_scene(&scene);
    let reference = references.other.or(references.engine);
    let error = reference.and_then(|reference| error_of(&run, &reference));
    let basis = reference.filter(|_| error.is_some()).map(|reference| reference.basis);
    let shortfall = shortfall(&run, error);
    let row = Row { case, run, took_s, error, basis, shortfall };
    (!stop.is_set()).then_some(row)
}

/// The greatest error of a run's results; nothing while undecided.
fn error_of(run: &Run, reference: &Reference) -> Option<f64> {
    let answer = answer_of(run).ok()?;
    if answer.outcome != reference.outcome {
        return Some(f64::NAN);
    }
    Some(reference.error_of_all(&run.scene, &answer.results))
}

fn shortfall(run: &Run, error: Option<f64>) -> Option<FailureReason> {
    let residual = run.ledger.residual();
    let results = [
        run.final_penetration_m,
        run.exit_time_s,
        run.residual_velocity_m_s,
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
        // A reference that ends otherwise makes the error NaN, which is no less short.
        error.filter(|error| error.is_nan() || *error > ERROR_MAX).map(|_| FailureReason::Error)
    }
}

#[cfg(test)]
mod tests;
