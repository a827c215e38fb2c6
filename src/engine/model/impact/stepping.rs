//! The methods that the loop can step by.

use std::sync::Arc;

use crate::model::impact::equations::Setup;
use crate::model::impact::run::run;
use crate::model::run::{Observer, Run, Settings};
use crate::model::scene::Scene;
use crate::numerics::collocation::{NINE, SEVEN, THREE};
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

/// One impact on a valid scene by a method, whatever its contact model but the listing of the Appendix.
pub(super) fn run_by(
    scene: &Arc<Scene>,
    settings: Settings,
    stepping: Stepping,
    observer: Observer<'_>,
) -> Run {
    let setup = |tolerance: f64| Setup::of(scene, tolerance).by(stepping);
    match stepping {
        Stepping::Collocation(tolerance) | Stepping::CollocationInFull(tolerance) => {
            run(scene, &setup(tolerance), &NINE.to(tolerance), settings, observer)
        }
        Stepping::Second(tolerance) => {
            run(scene, &setup(tolerance), &SEVEN.to(tolerance), settings, observer)
        }
        Stepping::Radau5(tolerance) => {
            run(scene, &setup(tolerance), &THREE.to(tolerance), settings, observer)
        }
        Stepping::Dop853(tolerance) => {
            run(scene, &setup(tolerance), &Dop853 { tolerance }, settings, observer)
        }
        Stepping::Rk4(step) => {
            run(scene, &setup(STEPPED), &Rk4 { step, locates: true }, settings, observer)
        }
        Stepping::Rk4WithoutEvents(step) => {
            run(scene, &setup(STEPPED), &Rk4 { step, locates: false }, settings, observer)
        }
    }
}
