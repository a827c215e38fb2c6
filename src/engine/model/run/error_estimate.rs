//! Error estimates of a run.

use crate::model::run::outcome::Outcome;

/// Relative error estimates of the results of a run.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ErrorEstimate {
    /// Estimate of the final depth (for a perforation of the exit time); infinite if unknown.
    pub main: Option<f64>,
    /// Source of the estimates.
    pub basis: Option<EstimateBasis>,
    /// Estimates of the results, by name.
    pub by_result: Vec<(&'static str, f64)>,
    /// Free oscillation of the plate that the method damped; of the second computation of an estimate only.
    pub left_out: LeftOut,
}

/// Source of an error estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EstimateBasis {
    /// Difference from a second computation of higher order and tighter tolerance, times a safety factor.
    SecondComputation,
    /// Difference from the closed form.
    ClosedForm,
    /// Unknown: the second computation has this other outcome.
    OutcomeDiffers(Outcome),
    /// Twice the difference from the same first-order scheme with half the step size: the error relative to the limit of the scheme.
    HalfStep,
}

/// Amplitudes of a free oscillation about the balance of contact and spring that a computation leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct LeftOut {
    /// Displacement of the plate at the first arrest, m.
    pub arrest_m: f64,
    /// Velocity of the plate at the first arrest, m/s.
    pub arrest_m_s: f64,
    /// Time of the first arrest, s.
    pub arrest_s: f64,
    /// Displacement of the plate at its maximum, m.
    pub farthest_m: f64,
    /// Force of the spring there, N.
    pub force_n: f64,
    /// Energy of the spring there, J.
    pub energy_j: f64,
    /// Load of a plastic interface relative to its limit load in compression, which the oscillation during a slip decides.
    pub demand_ratio: f64,
    /// Time before the separation from which on the force of a lumped contact is within its error, s.
    pub separation_s: f64,
}
