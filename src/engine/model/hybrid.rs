//! One impact by one loop, one integrator and one locator: the second computation that the error estimate of a run rests on.
//!
//! `equations` has the motion, once; `modes` what holds between events and what follows them, and `events` which events a mode has;
//! `moving` is what the integrator sees of it; `run` is the loop; `outcome` decides by energy when it is over, `horizon` when it is
//! at the latest; `record` keeps rows, work and greatest forces, and `report` makes the run of them. It shares the law with the first
//! computation (area, springs, dampers) and nothing of its method or its rules.

use std::sync::Arc;

use crate::model::run::{Observer, Run};
use crate::model::scene::Scene;
use crate::numerics::collocation::{Collocation, NINE, SEVEN, THREE};
use crate::numerics::explicit::{Dop853, Rk4};
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

/// What steps of a given length are taken to be off by.
const STEPPED: f64 = 1e-12;

/// A method that the loop can step by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// Radau IIA with nine stages, the engine's own, to a tolerance.
    Collocation(f64),
    /// The same; the plate is followed to its turn also where its energy says how far it goes.
    CollocationInFull(f64),
    /// Radau IIA with seven stages, for the estimate of errors, to a tolerance.
    Second(f64),
    /// Radau IIA with three stages, of order five, to a tolerance.
    Radau5(f64),
    /// DOP853 to a tolerance.
    Dop853(f64),
    /// The classical Runge-Kutta method with steps of this length, s; events are located.
    Rk4(f64),
    /// The same; events are only noticed after the step in which they happened.
    Rk4WithoutEvents(f64),
}

impl Stepping {
    /// The error of a step relative to what moves; of steps of a given length that of the engine's own.
    fn tolerance(self) -> f64 {
        match self {
            Self::Collocation(tolerance)
            | Self::CollocationInFull(tolerance)
            | Self::Second(tolerance)
            | Self::Radau5(tolerance)
            | Self::Dop853(tolerance) => tolerance,
            Self::Rk4(_) | Self::Rk4WithoutEvents(_) => STEPPED,
        }
    }
}

/// One impact on a valid scene by a method.
pub(in crate::model) fn run(
    scene: &Arc<Scene>,
    extent: Extent<'_>,
    stepping: Stepping,
    observer: Observer<'_>,
) -> Run {
    let mut setup = Setup::of(scene, stepping.tolerance());
    setup.in_full = matches!(stepping, Stepping::CollocationInFull(_));
    let setup = &setup;
    match stepping {
        Stepping::Collocation(tolerance) | Stepping::CollocationInFull(tolerance) => {
            let stepper = Collocation { member: &*NINE, tolerance };
            run::run(scene, setup, &stepper, extent, observer)
        }
        Stepping::Second(tolerance) => {
            let stepper = Collocation { member: &*SEVEN, tolerance };
            run::run(scene, setup, &stepper, extent, observer)
        }
        Stepping::Radau5(tolerance) => {
            let stepper = Collocation { member: &*THREE, tolerance };
            run::run(scene, setup, &stepper, extent, observer)
        }
        Stepping::Dop853(tolerance) => {
            run::run(scene, setup, &Dop853 { tolerance }, extent, observer)
        }
        Stepping::Rk4(step) => {
            run::run(scene, setup, &Rk4 { step, locates: true }, extent, observer)
        }
        Stepping::Rk4WithoutEvents(step) => {
            run::run(scene, setup, &Rk4 { step, locates: false }, extent, observer)
        }
    }
}
