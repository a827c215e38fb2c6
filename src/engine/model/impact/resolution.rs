//! Tolerances and thresholds that several rules of an impact share.

/// Relative difference below which two results count as equal, and a velocity, relative to that of the impact, as zero: the default
/// tolerance of a run.
pub(super) const RESOLUTION: f64 = 1e-9;
/// Relative change of depth or displacement that is negligible, and tolerance of event location for methods with fixed steps: a thousandth
/// of the default tolerance.
pub(super) const NEGLIGIBLE: f64 = 1e-12;
/// Relative threshold for a negligible displacement (of the tip radius), momentum or energy at a singular zero or a stop: 1e-4 of the
/// default tolerance.
pub(super) const NEGLIGIBLE_AT_ZERO: f64 = 1e-13;
/// Error of a step per tolerance of a run: the errors of its steps add up, and grow a little.
pub(super) const STEP_TOLERANCE_FACTOR: f64 = 1e-2;
/// Tolerance of the steps and thresholds of the second computation of an error estimate, relative to those of the first: its own error is
/// a hundredth of their difference.
pub(super) const SECOND_FACTOR: f64 = 1e-2;
/// Relative deviation from the balance of spring and contact up to which first-order terms describe it; the next order is a hundredth.
pub(super) const FIRST_ORDER: f64 = 0.1;
