//! The methods that the loop can step by.

use std::sync::Arc;

use crate::model::impact::equations::Setup;
use crate::model::impact::run::run;
use crate::model::run::{Observer, Run, Settings};
use crate::model::scene::Scene;
use crate::numerics::collocation::{Collocation, NINE, SEVEN, THREE};
use crate::numerics::explicit::{Dop853, Rk4};

/// What steps of a given length are taken to be off by.
const STEPPED: f64 = 1e-12;

/// A method that the loop can step by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// Radau IIA with nine stages, the engine's own, to a tolerance.
    Collocation(f64),
    /// The same; the plate is followed to its turn also where its energy says how far it goes.
    CollocationInFull(f64),
    /// Radau IIA with seven stages, to a tolerance, for the estimate of errors: of the loads only the push through the joined interface, of
    /// which alone the error is estimated.
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

/// One impact on a valid scene by a method, whatever its contact model but the listing of the Appendix.
pub(super) fn run_by(
    scene: &Arc<Scene>,
    settings: Settings,
    stepping: Stepping,
    observer: Observer<'_>,
) -> Run {
    let mut setup = Setup::of(scene, stepping.tolerance());
    setup.stepping = stepping;
    let setup = &setup;
    match stepping {
        Stepping::Collocation(tolerance) | Stepping::CollocationInFull(tolerance) => {
            let stepper = Collocation { member: &*NINE, tolerance };
            run(scene, setup, &stepper, settings, observer)
        }
        Stepping::Second(tolerance) => {
            let stepper = Collocation { member: &*SEVEN, tolerance };
            run(scene, setup, &stepper, settings, observer)
        }
        Stepping::Radau5(tolerance) => {
            let stepper = Collocation { member: &*THREE, tolerance };
            run(scene, setup, &stepper, settings, observer)
        }
        Stepping::Dop853(tolerance) => run(scene, setup, &Dop853 { tolerance }, settings, observer),
        Stepping::Rk4(step) => run(scene, setup, &Rk4 { step, locates: true }, settings, observer),
        Stepping::Rk4WithoutEvents(step) => {
            run(scene, setup, &Rk4 { step, locates: false }, settings, observer)
        }
    }
}
