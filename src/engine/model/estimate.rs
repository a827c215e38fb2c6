//! Error estimates of the results of a run: the difference of each from its closed form, or from a second computation of the same scene.
//!
//! An estimate is relative to the quantity itself. It is never below the rounding error of the quantity, which is larger for
//! a small difference of large numbers: a velocity far below that of the impact, a displacement far below the cocking distance.

use crate::model::run::{EstimateBasis, LeftOut, Outcome, Run, RunResult};
use crate::numerics::larger;

/// Rounding of a closed form, relative: a few units of the last place of each of its terms.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Least estimate from a second computation, relative. Rounding adds up over the steps of both and does not show in their difference.
const LEAST: f64 = 1e-12;
/// Factor on the difference from a more accurate second computation, for the errors that both have in common.
const SHARED: f64 = 3.0;
/// How many times its difference from the other a computation may be off that passed through another number of events: the least error of
/// each sends it another way, and the two may have come out close to each other by chance.
const EVENT_MISMATCH_FACTOR: f64 = 10.0;

/// Reference size of errors that both computations share, besides the quantity's own size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scale {
    Own,
    ImpactVelocity,
    /// Just above the ballistic limit what is left is the difference of the squares of two velocities.
    LimitVelocity,
    CockingDistance,
}

/// The size that the rounding of a result is relative to.
fn scale(of: RunResult) -> Scale {
    match of {
        RunResult::ArrestPlateDisplacement
        | RunResult::MaxPlateDisplacement
        | RunResult::Stroke => Scale::CockingDistance,
        RunResult::ArrestPlateVelocity | RunResult::SeparationVelocity => Scale::ImpactVelocity,
        RunResult::ResidualVelocity | RunResult::ExitTime => Scale::LimitVelocity,
        RunResult::ArrestPenetration
        | RunResult::ArrestTime
        | RunResult::FinalPenetration
        | RunResult::PeakContactForce
        | RunResult::SeparationTime
        | RunResult::InterfaceDemand
        | RunResult::InterfaceTension
        | RunResult::PeakMountForce
        | RunResult::StoredEnergy
        | RunResult::RotationalEnergy => Scale::Own,
    }
}

/// Returns what the free oscillation that both computations damp changes in a result.
fn left_out(of: RunResult, second: &Run, value: f64) -> f64 {
    let LeftOut { arrest_m, arrest_m_s, farthest_m, force_n, energy_j, .. } =
        second.estimate.left_out;
    match of {
        RunResult::ArrestPenetration
        | RunResult::ArrestPlateDisplacement
        | RunResult::FinalPenetration => arrest_m,
        RunResult::ArrestPlateVelocity => arrest_m_s,
        RunResult::MaxPlateDisplacement | RunResult::Stroke => farthest_m,
        RunResult::PeakMountForce => force_n,
        // Fused bodies start with the spring's force at the arrest.
        RunResult::InterfaceDemand | RunResult::InterfaceTension => {
            let at_peak = second.mechanism.peak_mount_n.map_or(0.0, |peak_n| force_n / peak_n);
            let at_arrest = second.first_arrest.map_or(0.0, |arrest| {
                let moved_m = arrest.plate_displacement_m.abs();
                if arrest_m > 0.0 { arrest_m / moved_m } else { 0.0 }
            });
            larger(value * larger(at_peak, at_arrest), second.estimate.left_out.demand_ratio)
        }
        RunResult::StoredEnergy => energy_j,
        RunResult::SeparationTime => second.estimate.left_out.separation_s,
        RunResult::ArrestTime => second.estimate.left_out.arrest_s,
        RunResult::ExitTime
        | RunResult::PeakContactForce
        | RunResult::ResidualVelocity
        | RunResult::RotationalEnergy
        | RunResult::SeparationVelocity => 0.0,
    }
}

/// Sets a run's estimates from another computation of the same scene. They are infinite if the outcomes differ.
pub fn set(run: &mut Run, second: &Run, basis: EstimateBasis) {
    if run.outcome != second.outcome {
        run.estimate.basis = Some(EstimateBasis::OutcomeDiffers(second.outcome));
        run.estimate.main = Some(f64::INFINITY);
        return;
    }
    let (factor, floor) = match basis {
        // First order: half the step leaves half of the error.
        EstimateBasis::HalfStep => (2.0, ROUNDING),
        EstimateBasis::SecondComputation if run.cost.events != second.cost.events => {
            (EVENT_MISMATCH_FACTOR, LEAST)
        }
        EstimateBasis::SecondComputation => (SHARED, LEAST),
        EstimateBasis::ClosedForm | EstimateBasis::OutcomeDiffers(_) => (1.0, ROUNDING),
    };
    let struck = run.scene.projectile.velocity_m_s;
    // Omitted slips can deepen the hole of an arrest, and push harder there.
    let interval = |run: &Run| Some(run.penetration.at_most_m? - run.penetration.final_m?);
    let width = interval(run).unwrap_or(0.0);
    run.estimate.by_result = RunResult::ALL
        .into_iter()
        .filter_map(|of| {
            let value = |run: &Run| of.value(run).filter(|value| value.is_finite());
            let (value, other) = (value(run)?, value(second)?);
            let rounding = match scale(of) {
                Scale::Own => 0.0,
                Scale::ImpactVelocity => ROUNDING * struck / value.abs(),
                Scale::LimitVelocity => {
                    f64::EPSILON * (struck / run.departure.residual_velocity_m_s?).powi(2)
                }
                Scale::CockingDistance => ROUNDING * run.scene.start_m().abs() / value.abs(),
            };
            let interval = match of {
                RunResult::FinalPenetration => width,
                // The area grows at most as fast as the depth.
                RunResult::PeakContactForce if width > 0.0 => {
                    width * value / run.penetration.final_m?
                }
                _ => 0.0,
            };
            let off = larger(factor * (value - other).abs(), interval);
            let off = off + left_out(of, second, other).abs();
            Some((of.key(), relative(off, value, larger(floor, rounding))?))
        })
        .collect();
    // The depth of a perforation is the plate's own: what was computed is when it is reached.
    let main_result = match run.outcome {
        Outcome::Perforated => RunResult::ExitTime,
        Outcome::Arrested | Outcome::Separated | Outcome::Moving | Outcome::Unmeasured => {
            RunResult::FinalPenetration
        }
    };
    let found = run.estimate.by_result.iter().find(|error| error.0 == main_result.key());
    run.estimate.main = found.map(|error| error.1);
    run.estimate.basis = found.map(|_| basis);
}

/// Returns the error relative to the value, at least a floor; `None` for zero.
fn relative(off: f64, value: f64, floor: f64) -> Option<f64> {
    Some(larger(off / value.abs(), floor)).filter(|relative| relative.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_relative_and_not_below_its_floor() {
        assert_eq!(relative(0.0, 1.0, 1e-15), Some(1e-15));
        assert!((relative(0.01, -2.0, 1e-15).unwrap() - 0.005).abs() < 1e-15);
        assert_eq!(relative(0.0, 0.0, 1e-15), None);
        assert_eq!(relative(1.0, 0.0, 1e-15), None);
    }
}
