//! The simulation by one of its methods only, for comparison: [`run`](super::run) chooses by itself.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::impact::TERMS;
use crate::model::impact::problem::Problem;
use crate::model::impact::report;
use crate::model::impact::simulation::Simulation;
use crate::model::run::Observer;
use crate::model::run::Run;
use crate::model::scene::Scene;
use crate::model::variables::{self, VariableError};

/// Which method alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forced {
    /// To Taylor steps, also where a closed form exists.
    Taylor,
    /// To the general path: whichever step is right where it is, but neither closed form nor bound in place of one.
    General,
}

/// Simulate one impact in this way, without series or error estimate. `None` when Taylor steps had to be left before the end of
/// the contact: on a stiff stretch.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn simulate_by(forced: Forced, scene: &Arc<Scene>) -> Result<Option<Run>, VariableError> {
    variables::validate(scene)?;
    let problem = Problem::of(scene);
    let mut simulation = Simulation::new(&problem, scene.run.tolerance, false);
    simulation.control.unit_s = 0.1 * problem.time_scales().contact_s;
    simulation.start();
    if simulation.control.stiff && forced == Forced::Taylor {
        return Ok(None);
    }
    let observer: Observer<'_> = &mut |_| ControlFlow::Continue(());
    let end = simulation.run::<TERMS>(observer);
    let gave_way = forced == Forced::Taylor && simulation.control.stiff_steps > 0;
    Ok((!gave_way).then(|| report::gather(&problem, simulation, end)))
}
