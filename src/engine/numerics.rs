//! Numerical methods that know no plate, no projectile, no metre and no screen.
//!
//! Map of the folder, in reading order: `series` is arithmetic on truncated power series, from which a model builds the
//! Taylor expansion of its solution; `collocation` is the one method of the new engine for smooth, stiff and steep alike, with its
//! `step` as polynomials and `locate` for the first event on it; `taylor` chooses the step such an expansion is good for; `implicit` is an
//! L-stable collocation method for what is too stiff for that; `explicit` are the Runge-Kutta methods it is compared with; `graded` starts where non-integer powers are singular; `event` locates what happens on an accepted step of any of them but
//! the Taylor steps; [`root`] finds zeros, `crossing` those of which there is one; [`quadrature`] integrates;
//! `maximum` and [`minimum`] search extremes; [`linear`] solves small systems; `monotone` interpolates data; [`random`], [`sobol`] and [`statistics`] serve samples; `exponential` has the functions
//! of closed forms.
//! A step of an integration works on fixed-size arrays and allocates nothing; quadrature, data and samples are vectors. Every loop
//! is bounded.

pub(crate) mod collocation;
pub(crate) mod crossing;
pub(crate) mod explicit;
pub(crate) mod exponential;
pub(crate) mod locate;
pub(crate) mod maximum;
pub mod minimum;
pub(crate) mod monotone;
pub mod quadrature;
pub mod random;
pub mod root;
pub(crate) mod series;
pub mod sobol;
pub mod statistics;
pub(crate) mod step;
pub(crate) mod taylor;

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
