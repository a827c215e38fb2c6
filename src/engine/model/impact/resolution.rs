//! Tolerances, thresholds and limits that several rules of an impact share.

/// Relative difference below which two results count as equal, and a velocity, relative to that of the impact, as zero: the default
/// tolerance of a run.
pub(super) const RESOLUTION: f64 = 1e-9;
/// Relative change of depth or displacement that is negligible, and tolerance of event location for methods with fixed steps: a thousandth
/// of the default tolerance.
pub(super) const NEGLIGIBLE: f64 = 1e-12;
/// Relative rounding error of a force: areas of oblique sections are differences of terms. No step has a tighter tolerance. At a singular
/// zero or a stop, a smaller displacement (relative to the tip radius), momentum or energy is negligible.
pub(super) const ROUNDING: f64 = 1e-13;
/// Tolerance of a computation, relative to that of the result that depends on it: of the steps to that of the run, because their errors add
/// up, and of the second computation of an error estimate to the first, so that its own error is a hundredth of their difference. Its other
/// thresholds, and its step from a singular start, are in the same ratio.
pub(super) const TOLERANCE_RATIO: f64 = 1e-2;
/// Relative deviation from the balance of spring and contact up to which first-order terms describe it; the next order is a hundredth.
pub(super) const FIRST_ORDER: f64 = 0.1;
/// Number of contact changes from which a run counts as a long oscillation: the depth of a slipping projectile is then an interval, whose
/// width decreases with the square of the number, and an exhausted budget is due to the changes, not to the steps between them.
pub(super) const CHANGES_MANY: usize = 64;
