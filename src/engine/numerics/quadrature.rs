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

/// Parts into which [`converged`] may cut an interval in all.
const PARTS_MAX: usize = 200;
/// Part of an integral by which its halves may change it: what they are off by themselves is about the square of that.
const CONVERGED: f64 = 1e-10;

/// The integral of `f` from `a` to `b` to rounding, on halves of halves until those change nothing.
pub(crate) fn converged(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut open, mut sum, mut parts) = (vec![(a, b)], 0.0, 0);
    while let Some((a, b)) = open.pop() {
        let (whole, halves) = (gauss(a, b, 1, &f), gauss(a, b, 2, &f));
        parts += 1;
        if (whole - halves).abs() > CONVERGED * halves.abs() && parts + open.len() < PARTS_MAX {
            let middle = 0.5 * (a + b);
            open.extend([(middle, b), (a, middle)]);
        } else {
            sum += halves;
        }
    }
    sum
}

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

/// The first N Legendre polynomials, by Bonnet's recurrence (n + 1) P(n+1) = (2n + 1) x P(n) - n P(n-1).
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
