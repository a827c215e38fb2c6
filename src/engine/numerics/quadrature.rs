//! Gauss-Legendre quadrature.

use std::array;
use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::numerics::root::newton_root;

/// Returns the integral of `f` from `a` to `b` by the sixteen-point rule on each of `panels` equal subintervals.
pub fn gauss(a: f64, b: f64, panels: usize, f: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * (b - a) / panels as f64;
    let middle = |panel: usize| a + half * (2 * panel + 1) as f64;
    (0..panels).map(|panel| by_rule(&*GAUSS_16, middle(panel), half, &f)).sum()
}

/// Returns the integral of `f` from `middle - half` to `middle + half` by a rule.
fn by_rule(rule: &[(f64, f64)], middle: f64, half: f64, f: impl Fn(f64) -> f64) -> f64 {
    half * rule.iter().map(|(at, weight)| weight * f(middle + half * at)).sum::<f64>()
}

/// Maximum number of subintervals of [`converged`].
const PARTS_MAX: usize = 200;
/// Tolerance of the difference of the rules with ten and sixteen points, relative to the integral. The error of the latter is far smaller.
const CONVERGED: f64 = 1e-10;

/// Returns the integral of `f` from `a` to `b` to about rounding error, by adaptive bisection with the rules of ten and sixteen points.
pub(crate) fn converged(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut open, mut sum, mut parts) = (vec![(a, b)], 0.0, 0);
    while let Some((a, b)) = open.pop() {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let rough = by_rule(&*GAUSS_10, middle, half, &f);
        let fine = by_rule(&*GAUSS_16, middle, half, &f);
        parts += 1;
        if (rough - fine).abs() > CONVERGED * fine.abs() && parts + open.len() < PARTS_MAX {
            open.extend([(middle, b), (a, middle)]);
        } else {
            sum += fine;
        }
    }
    sum
}

/// Ten-point rule.
pub(crate) static GAUSS_10: LazyLock<[(f64, f64); 10]> = LazyLock::new(rule);
/// Sixteen-point rule.
static GAUSS_16: LazyLock<[(f64, f64); 16]> = LazyLock::new(rule);

/// Returns nodes in (-1, 1) and weights of the rule with N <= 19 points, exact for polynomials of degree 2 N - 1. The nodes are the roots
/// of P(N); Newton's method starts from the roots of a cosine.
pub(crate) fn rule<const N: usize>() -> [(f64, f64); N] {
    array::from_fn(|i| {
        let guess = ((i as f64 + 0.75) / (N as f64 + 0.5) * PI).cos();
        let x = newton_root(guess, |x| legendre_and_slope(N, x));
        let slope = legendre_and_slope(N, x).1;
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Returns the Legendre polynomial of degree n (1 to 19) and its derivative.
pub(crate) fn legendre_and_slope(n: usize, x: f64) -> (f64, f64) {
    let p = legendre::<20>(x);
    (p[n], n as f64 * (p[n - 1] - x * p[n]) / (1.0 - x * x))
}

/// Returns the first N Legendre polynomials, by Bonnet's recurrence (n + 1) P(n+1) = (2n + 1) x P(n) - n P(n-1).
pub(crate) fn legendre<const N: usize>(x: f64) -> [f64; N] {
    let (mut p, mut before) = ([1.0; N], 0.0);
    for n in 0..N - 1 {
        let k = n as f64;
        p[n + 1] = ((2.0 * k + 1.0) * x * p[n] - k * before) * (1.0 / (k + 1.0));
        before = p[n];
    }
    p
}

#[cfg(test)]
mod tests {
    use super::{converged, gauss};

    /// The integral of 1/sqrt(a² + y²) from 0 to 1 is asinh(1/a): for a small `a` the integrand has a singularity close by.
    #[test]
    fn an_integrand_with_a_singularity_close_by_converges() {
        for a in [1.0f64, 1e-1, 1e-3, 1e-6] {
            let found = converged(0.0, 1.0, |y| 1.0 / a.hypot(y));
            let exact = (1.0 / a).asinh();
            assert!((found / exact - 1.0).abs() < 1e-14, "{a}: {found}, not {exact}");
        }
    }

    #[test]
    fn an_integral_that_does_not_exist_ends() {
        assert!(converged(0.0, 1.0, |y| 1.0 / y) > 10.0);
        assert!(converged(0.0, 1.0, |_| f64::NAN).is_nan());
    }

    #[test]
    fn sixteen_points_are_exact_up_to_degree_31() {
        for degree in 0..32 {
            let integral = gauss(0.0, 2.0, 1, |x| x.powi(degree));
            let exact = 2f64.powi(degree + 1) / f64::from(degree + 1);
            assert!((integral / exact - 1.0).abs() < 4e-15, "degree {degree}: {integral}");
        }
    }

    #[test]
    fn panels_converge_on_a_smooth_function() {
        assert!((gauss(0.0, 3.0, 3, f64::exp) - 3f64.exp_m1()).abs() < 1e-14);
    }
}
