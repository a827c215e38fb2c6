//! Gauss-Legendre quadrature.

/// The integral of `f` from `a` to `b` with the sixteen-point rule on each of `panels` equal parts.
pub fn gauss(a: f64, b: f64, panels: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    let half = 0.5 * (b - a) / panels as f64;
    let mut sum = 0.0;
    for panel in 0..panels {
        let middle = a + half * (2 * panel + 1) as f64;
        for (at, weight) in GAUSS_16 {
            sum += weight * (f(middle - half * at) + f(middle + half * at));
        }
    }
    sum * half
}

/// Halves into which [`resolved`] may cut an interval in all.
const PANELS_MAX: usize = 200;

/// The integral of `f` from `a` to `b` with the sixteen-point rule, on halves of halves until on each of them the integrand's
/// last Legendre coefficients are no more than `resolution` of the first. For an analytic integrand the rule's error is about the
/// square of that, since the coefficients go on falling at the same rate up to degree 32.
pub(crate) fn resolved(a: f64, b: f64, resolution: f64, f: impl Fn(f64) -> f64) -> f64 {
    let mut open = vec![(a, b)];
    let (mut sum, mut panels) = (0.0, 0);
    while let Some((a, b)) = open.pop() {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let (mut whole, mut even, mut odd) = (0.0, 0.0, 0.0);
        for (at, weight) in GAUSS_16 {
            let (left, right) = (f(middle - half * at), f(middle + half * at));
            // With the Legendre polynomials there the integrand's last coefficients follow from the same values as the integral.
            let p = legendre::<16>(at);
            whole += weight * (left + right);
            even += weight * (left + right) * p[14];
            odd += weight * (right - left) * p[15];
        }
        let last = LAST_NORM * if even.abs() > odd.abs() { even.abs() } else { odd.abs() };
        panels += 1;
        if last > resolution * whole.abs() && panels + open.len() < PANELS_MAX {
            open.extend([(middle, b), (a, middle)]);
        } else {
            sum += half * whole;
        }
    }
    sum
}

/// What turns the integral of f times a Legendre polynomial of degree 14 into its coefficient, relative to that of f: 2 n + 1.
const LAST_NORM: f64 = 29.0;

/// The positive nodes of the sixteen-point rule on (-1, 1) and their weights, which are the same at the negative ones: exact for
/// polynomials of degree 31 (Abramowitz and Stegun, Table 25.4, n = 16).
pub(crate) const GAUSS_16: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_58),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_88),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// The reciprocals of whole numbers, which cost less than divisions.
const RECIPROCALS: [f64; 16] = {
    let mut all = [0.0; 16];
    let mut number = 1;
    while number < all.len() {
        all[number] = 1.0 / number as f64;
        number += 1;
    }
    all
};

/// The first N Legendre polynomials, by Bonnet's recurrence (n + 1) P(n+1) = (2n + 1) x P(n) - n P(n-1).
pub(crate) fn legendre<const N: usize>(x: f64) -> [f64; N] {
    let (mut p, mut before) = ([1.0; N], 0.0);
    for n in 0..N - 1 {
        let k = n as f64;
        p[n + 1] = ((2.0 * k + 1.0) * x * p[n] - k * before) * RECIPROCALS[n + 1];
        before = p[n];
    }
    p
}

#[cfg(test)]
mod tests {
    use super::{gauss, resolved};

    /// The integral of 1/sqrt(a² + y²) from 0 to 1 is asinh(1/a): for a small `a` the integrand has a singularity close by.
    #[test]
    fn an_integrand_with_a_singularity_close_by_is_resolved() {
        for a in [1.0f64, 1e-1, 1e-3, 1e-6] {
            let found = resolved(0.0, 1.0, 1e-8, |y| 1.0 / a.hypot(y));
            let exact = (1.0 / a).asinh();
            assert!((found / exact - 1.0).abs() < 1e-14, "{a}: {found}, not {exact}");
        }
    }

    #[test]
    fn an_integral_that_does_not_exist_ends() {
        assert!(resolved(0.0, 1.0, 1e-8, |y| 1.0 / y) > 10.0);
        assert!(resolved(0.0, 1.0, 1e-8, |_| f64::NAN).is_nan());
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
