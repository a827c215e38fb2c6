//! One impact by one loop, one integrator and one locator: the second computation that the error estimate of a run rests on.
//!
//! `equations` has the motion, once; `modes` what holds between events and what follows them, and `events` which events a mode has;
//! `moving` is what the integrator sees of it; `run` is the loop; `outcome` decides by energy when it is over; `record` keeps what is asked for. It shares the law with the
//! first computation (area, springs, dampers) and nothing of its method or its rules.

use std::sync::Arc;

use crate::model::run::{Observer, Run};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::collocation::{Collocation, NINE, SEVEN};
use crate::numerics::larger;
use equations::Setup;
pub(in crate::model) use run::Extent;

mod equations;
mod events;
mod horizon;
mod modes;
mod moving;
mod outcome;
mod record;
mod report;
mod run;
#[cfg(test)]
mod tests;

/// Error of a step per tolerance of a run: its steps' errors add up, and grow a little. Below the least there is only rounding.
const LOCAL: f64 = 1e-3;
const LEAST: f64 = 1e-13;
/// How much looser the second computation is, and the part of the first one's tolerance that an estimate admits at least.
const LOOSER: f64 = 10.0;
const FLOOR: f64 = 1.0 / 30.0;

/// Error of each step for the tolerance of a scene.
fn tolerance(scene: &Scene) -> f64 {
    larger(LOCAL * scene.run.tolerance, LEAST)
}

/// What no second computation can see of an error, relative.
pub(in crate::model) fn floor(scene: &Scene) -> f64 {
    FLOOR * tolerance(scene)
}

/// One impact on a valid scene; `None` where this engine does not know the contact or the spring.
pub(in crate::model) fn run(
    scene: &Arc<Scene>,
    extent: Extent<'_>,
    observer: Observer<'_>,
) -> Option<Run> {
    let setup = setup(scene)?;
    let stepper = Collocation { member: &*NINE, tolerance: tolerance(scene) };
    Some(run::run(scene, &setup, &stepper, extent, observer))
}

/// The same by another member of the family, which shares nothing with it but the law.
pub(in crate::model) fn second(scene: &Arc<Scene>, observer: Observer<'_>) -> Option<Run> {
    let setup = setup(scene)?;
    let stepper = Collocation { member: &*SEVEN, tolerance: LOOSER * tolerance(scene) };
    Some(run::run(scene, &setup, &stepper, Extent::BARE, observer))
}

fn setup(scene: &Scene) -> Option<Setup> {
    let is_known = scene.contact.model == ContactModel::Hydrodynamic;
    is_known.then(|| Setup::of(scene)).flatten()
}
