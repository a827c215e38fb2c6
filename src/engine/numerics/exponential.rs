//! Functions of the exponential and of the logarithm as closed forms need them: without cancellation near zero, and quick.
//!
//! The Bernoulli function x/(exp(x) - 1), 1 at zero, is given as a fraction (above, below): whoever divides it by something
//! else divides once.

/// Up to here the quotient of [`bernoulli_near`] is exact to some roundings.
pub(crate) const NEAR: f64 = 1.0;

/// x/(exp(x) - 1) for 0 <= x <= [`NEAR`], without a branch or a call, so that many are computed in vectors: the
/// diagonal Padé approximant of the exponential of degree 7, whose error there is at most 3e-16 (Baker and Graves-Morris,
/// *Padé Approximants*, 2nd ed., section 1.2).
#[inline]
pub(crate) fn bernoulli_near(x: f64) -> (f64, f64) {
    let square = x * x;
    let even = 17_297_280.0 + square * (1_995_840.0 + square * (25_200.0 + square * 56.0));
    let odd = 8_648_640.0 + square * (277_200.0 + square * (1_512.0 + square));
    (even - x * odd, 2.0 * odd)
}

/// x/(exp(x) - 1) for any x > 0.
#[inline]
pub(crate) fn bernoulli(x: f64) -> (f64, f64) {
    (x, x.exp_m1())
}

/// ln(1 + x) for x >= 0, to a few roundings: the logarithm of the rounded sum, scaled by what rounding did to x (Goldberg,
/// *What every computer scientist should know about floating-point arithmetic*, 1991, theorem 4). Half as long in coming as
/// `f64::ln_1p`.
#[inline]
pub(crate) fn ln_one_plus(x: f64) -> f64 {
    let sum = 1.0 + x;
    let taken = sum - 1.0;
    if taken == 0.0 || sum.is_infinite() { x } else { sum.ln() * (x / taken) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quotient((above, below): (f64, f64)) -> f64 {
        above / below
    }

    #[test]
    fn near_zero_and_everywhere_it_is_the_same_function() {
        assert!((quotient(bernoulli_near(0.0)) - 1.0).abs() < 1e-16);
        for i in 1..=1000 {
            let x = NEAR * f64::from(i) / 1000.0;
            let (near, exact) = (quotient(bernoulli_near(x)), quotient(bernoulli(x)));
            assert!((near / exact - 1.0).abs() < 1e-15, "{x}: {near} {exact}");
        }
    }

    #[test]
    fn its_series_begins_with_the_bernoulli_numbers() {
        // B1/1! = -1/2, B2/2! = 1/12, B4/4! = -1/720.
        let x: f64 = 0.01;
        let series = 1.0 - x / 2.0 + x * x / 12.0 - x.powi(4) / 720.0;
        assert!((quotient(bernoulli_near(x)) - series).abs() < 1e-15);
    }

    #[test]
    fn the_logarithm_near_one_is_the_standard_librarys() {
        for x in [0.0, 1e-300, f64::INFINITY] {
            assert_eq!(ln_one_plus(x).to_bits(), x.to_bits());
        }
        assert!(ln_one_plus(f64::NAN).is_nan());
        for i in -1700..=3000 {
            let x = 10f64.powf(f64::from(i) / 100.0);
            let (found, exact) = (ln_one_plus(x), x.ln_1p());
            assert!((found / exact - 1.0).abs() < 5.0 * f64::EPSILON, "{x}: {found} {exact}");
        }
    }
}
