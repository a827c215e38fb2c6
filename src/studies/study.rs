//! Work made of many runs.
//!
//! Knows the model and its methods; must not know files, screens or the command line, and threads only in `parallel.rs`.
//! Whoever wants a time measured passes the clock in.

pub mod accuracy;
pub mod compare;
pub mod context;
pub mod csv;
pub mod design;
pub mod envelope;
pub mod error;
mod first_contact;
pub mod library;
pub mod limit;
pub mod load;
pub mod measured;
pub mod monte_carlo;
pub mod outcome;
pub mod parallel;
pub mod principles;
pub mod quantities;
pub mod search;
pub mod sensitivity;
mod sobol;
pub mod stability;
pub mod statistics;
pub mod sweep;
#[cfg(test)]
pub(crate) mod testing;
pub mod thesis;
pub mod validation;
pub mod validity;
pub mod verdict;

use std::fmt::Display;
use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::{changed, changed_free_plate};

/// An option of a command: ` --samples 64`; nothing where it has no value.
fn option(name: &str, value: Option<impl Display>) -> String {
    value.map_or_else(String::new, |value| format!(" --{name} {value}"))
}

/// A run to its end; `None` for a scene that makes no physical sense.
pub(crate) fn run_with(scene: &Scene, settings: Settings) -> Option<Run> {
    simulate(&Arc::new(scene.clone()), &settings, &mut |_| ControlFlow::Continue(())).ok()
}

/// Runs a scene for its results alone, without error estimate.
pub(crate) fn plain_run(scene: &Scene) -> Option<Run> {
    run_with(scene, Settings::BARE)
}
