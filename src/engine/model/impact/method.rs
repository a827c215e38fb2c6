//! Integration methods of the loop.

use std::sync::Arc;

use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::run::run;
use crate::model::mechanism::Mechanism;
use crate::model::run::{Observer, Run, Settings};
use crate::model::scene::Scene;
use crate::numerics::collocation::{ELEVEN, RADAU_IIA_17, SEVEN, THREE};
use crate::numerics::explicit::{Dop853, Rk4};
use crate::numerics::larger;

/// Relative tolerance of event location for methods with fixed steps.
const STEPPED: f64 = 1e-12;

/// Tolerance of the steps of the second computation over that of the first: its own error is a hundredth of their difference. Towards the
/// zeros of laws that are not analytic there both take equal steps, of which its two stages more leave less than that; a tighter tolerance
/// would only add steps.
const TIGHTER: f64 = 1e-2;
const TIGHTER_AT_ZEROS: f64 = 1e-1;
/// Least tolerance of its steps: below it there is only rounding.
const LEAST_JUDGING: f64 = 1e-14;

/// Integration method of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IntegrationMethod {
    /// Radau IIA with a tolerance, the method of the engine: seven stages if the laws of the mechanism are analytic, else nine. Seven
    /// stages need less work for a step, but more steps near a singular zero.
    Collocation(f64),
    /// Collocation; the plate is integrated to its turning point even if its energy gives the maximum displacement.
    CollocationInFull(f64),
    /// Collocation with two more stages, for the error estimate of one to this tolerance; its own is tighter. Events force both
    /// computations to the same steps, on which a member with equally many stages would have the same errors.
    Second(f64),
    /// Radau IIA with three stages (order five) and a tolerance.
    Radau5(f64),
    /// DOP853 with a tolerance.
    Dop853(f64),
    /// Classical Runge-Kutta method with this step size, s, and event location.
    Rk4(f64),
    /// Classical Runge-Kutta method with this step size, s; events take effect at the end of a step.
    Rk4WithoutEvents(f64),
}

/// Runs an impact of a valid scene with a method, for every contact model except the listing of the Appendix.
pub(super) fn run_by(
    scene: &Arc<Scene>,
    settings: Settings,
    stepping: IntegrationMethod,
    observer: Observer<'_>,
) -> Run {
    let setup = |tolerance: f64| ImpactParameters::from_scene(scene, tolerance).by(stepping);
    let is_analytic = Mechanism::from_scene(scene).is_analytic();
    match stepping {
        IntegrationMethod::Collocation(tolerance)
        | IntegrationMethod::CollocationInFull(tolerance) => {
            let setup = setup(tolerance);
            if is_analytic {
                run(scene, &setup, &SEVEN.to(tolerance), settings, observer)
            } else {
                run(scene, &setup, &RADAU_IIA_17.to(tolerance), settings, observer)
            }
        }
        IntegrationMethod::Second(judged) => {
            let part = if is_analytic { TIGHTER } else { TIGHTER_AT_ZEROS };
            let tolerance = larger(part * judged, LEAST_JUDGING);
            let setup = setup(tolerance);
            if is_analytic {
                run(scene, &setup, &RADAU_IIA_17.judging(tolerance), settings, observer)
            } else {
                run(scene, &setup, &ELEVEN.judging(tolerance), settings, observer)
            }
        }
        IntegrationMethod::Radau5(tolerance) => {
            run(scene, &setup(tolerance), &THREE.to(tolerance), settings, observer)
        }
        IntegrationMethod::Dop853(tolerance) => {
            run(scene, &setup(tolerance), &Dop853 { tolerance }, settings, observer)
        }
        IntegrationMethod::Rk4(step) => {
            run(scene, &setup(STEPPED), &Rk4 { step, locates: true }, settings, observer)
        }
        IntegrationMethod::Rk4WithoutEvents(step) => {
            run(scene, &setup(STEPPED), &Rk4 { step, locates: false }, settings, observer)
        }
    }
}
