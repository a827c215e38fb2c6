//! One impact by one loop, one integrator and one locator: the second computation that the error estimate of a run rests on.
//!
//! `equations` has the motion, once; `modes` what holds between events and what follows them, and `events` which events a mode has;
//! `moving` is what the integrator sees of it; `run` is the loop; `outcome` decides by energy when it is over; `record` keeps what is asked for. It shares the law with the
//! first computation (area, springs, dampers) and nothing of its method or its rules.

use std::sync::Arc;

use crate::model::run::{Observer, Run};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::collocation::{Collocation, NINE};
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

/// One impact on a valid scene; `None` where this engine does not know the contact or the spring.
pub(in crate::model) fn run(
    scene: &Arc<Scene>,
    extent: Extent<'_>,
    tolerance: f64,
    observer: Observer<'_>,
) -> Option<Run> {
    if scene.contact.model != ContactModel::Hydrodynamic {
        return None;
    }
    let setup = Setup::of(scene)?;
    let stepper = Collocation { member: &*NINE, tolerance };
    Some(run::run(scene, &setup, &stepper, extent, observer))
}
