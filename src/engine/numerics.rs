//! Numerical methods, independent of the physics and of the user interface.
//!
//! `collocation` holds the implicit method that integrates smooth, stiff and singular equations; `explicit` holds the Runge-Kutta methods
//! it is compared with. Both return a `step` with dense output, on which `event_location` finds the first event. [`root`] finds a zero in
//! a bracket, `series_root` the zero of a power series, [`quadrature`] integrates, [`maximum`] maximises, `monotone` interpolates tables and
//! `incomplete_beta` is the integral of that name. [`random`] draws samples.
//!
//! An integration step uses fixed-size arrays and allocates nothing; quadrature and tables use vectors. Every loop is bounded.

pub(crate) mod collocation;
pub(crate) mod event_location;
pub(crate) mod explicit;
pub(crate) mod incomplete_beta;
pub mod maximum;
pub(crate) mod monotone;
pub mod quadrature;
pub mod random;
pub mod root;
pub(crate) mod series_root;
pub(crate) mod step;

/// The larger of two numbers; NaN when either is NaN (unlike `f64::max`, which hides it).
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// The smaller of two numbers; NaN when either is NaN.
pub fn smaller(a: f64, b: f64) -> f64 {
    if a < b || a.is_nan() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::{larger, smaller};

    #[test]
    fn nan_is_never_hidden() {
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
        assert!(smaller(f64::NAN, 1.0).is_nan() && smaller(1.0, f64::NAN).is_nan());
        assert_eq!((larger(1.0, 2.0), smaller(1.0, 2.0)), (2.0, 1.0));
    }
}
