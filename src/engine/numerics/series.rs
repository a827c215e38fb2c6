//! Arithmetic on truncated power series, one coefficient at a time.
//!
//! A series is an array of coefficients; index j is the coefficient of s^j. The functions compute coefficient j of a result
//! from coefficients 0..=j of the operands (and 0..j of the result, where it defines itself), so that a differential
//! equation can be expanded term by term. Recurrences: A. Griewank and A. Walther, *Evaluating Derivatives*, 2nd ed.
//! (2008), Tables 13.1 and 13.2; W. Tucker, *Validated Numerics* (2011), section 4.3.

/// Coefficient j of a·b.
#[inline]
pub(crate) fn product<const N: usize>(a: &[f64; N], b: &[f64; N], j: usize) -> f64 {
    let (a, b) = (&a[..=j], &b[..=j]);
    a.iter().zip(b.iter().rev()).map(|(a, b)| a * b).sum()
}

/// Coefficient j of a².
#[inline]
pub(crate) fn square<const N: usize>(a: &[f64; N], j: usize) -> f64 {
    let half = j.div_ceil(2);
    let (front, back) = (&a[..half], &a[j + 1 - half..=j]);
    let twice: f64 = front.iter().zip(back.iter().rev()).map(|(a, b)| a * b).sum();
    if j.is_multiple_of(2) { 2.0 * twice + a[j / 2] * a[j / 2] } else { 2.0 * twice }
}

/// Coefficient j >= 1 of y = x^alpha, given y's coefficients below j; `x[0]` must not be zero.
///
/// With `y[0]` = `sgn(x[0]) |x[0]|^alpha` it is the odd extension sgn(x) |x|^alpha on either side of zero.
#[inline]
pub(crate) fn power<const N: usize>(x: &[f64; N], y: &[f64; N], alpha: f64, j: usize) -> f64 {
    let n = j as f64;
    let mut sum = 0.0;
    for i in 1..=j {
        let i_f = i as f64;
        sum += (i_f * (alpha + 1.0) - n) * x[i] * y[j - i];
    }
    sum / (n * x[0])
}

/// Coefficient j of the square root y of x, given y's coefficients below j; `x[0]` > 0 (for j = 0, `x[0]` >= 0).
#[inline]
pub(crate) fn square_root<const N: usize>(x: &[f64; N], y: &[f64; N], j: usize) -> f64 {
    if j == 0 {
        return x[0].sqrt();
    }
    let mut sum = x[j];
    for i in 1..j {
        sum -= y[i] * y[j - i];
    }
    sum / (2.0 * y[0])
}

/// Coefficient j of y = a/b, given y's coefficients below j; `b[0]` must not be zero.
#[inline]
pub(crate) fn quotient<const N: usize>(a: &[f64; N], b: &[f64; N], y: &[f64; N], j: usize) -> f64 {
    let mut sum = a[j];
    for i in 0..j {
        sum -= y[i] * b[j - i];
    }
    sum / b[0]
}

/// The powers of a series, built one coefficient at a time, for functions of it that are known by their own Taylor series.
///
/// The inner series' constant term is taken as zero: the outer one is expanded about it.
#[derive(Clone, Debug)]
pub(crate) struct Powers<const N: usize> {
    /// Entry k: the inner series to the power k; 0 and 1 are not used.
    powers: [[f64; N]; N],
}

impl<const N: usize> Powers<N> {
    /// Nothing computed yet.
    pub(crate) fn new() -> Self {
        Self { powers: [[0.0; N]; N] }
    }

    /// Coefficient j >= 1 of the sum over k >= 2, up to `degree`, of `outer[k]` inner^k, given the inner coefficients below
    /// j. With `outer[1] inner[j]` added it is coefficient j of outer(inner). To be requested in order of j.
    pub(crate) fn beyond_linear(
        &mut self,
        inner: &[f64; N],
        outer: &[f64; N],
        degree: usize,
        j: usize,
    ) -> f64 {
        let mut sum = 0.0;
        let last = if j < degree { j } else { degree };
        for (k, outer) in outer.iter().enumerate().take(last + 1).skip(2) {
            let mut power = 0.0;
            for i in 1..=j + 1 - k {
                let below = if k == 2 { inner[j - i] } else { self.powers[k - 1][j - i] };
                power += inner[i] * below;
            }
            self.powers[k][j] = power;
            sum += outer * power;
        }
        sum
    }
}

/// The polynomial's value at s (Horner).
#[inline]
pub(crate) fn evaluate(c: &[f64], s: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * s + c)
}

/// The polynomial's derivative at s.
#[inline]
pub(crate) fn evaluate_slope(c: &[f64], s: f64) -> f64 {
    let mut sum = 0.0;
    for (j, c) in c.iter().enumerate().skip(1).rev() {
        sum = sum * s + j as f64 * c;
    }
    sum
}

/// The derivative's coefficients; the last one is zero.
pub(crate) fn slope<const N: usize>(c: &[f64; N]) -> [f64; N] {
    let mut d = [0.0; N];
    for j in 1..N {
        d[j - 1] = j as f64 * c[j];
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;

    const N: usize = 20;

    /// exp(s), and 1 + s, as series.
    fn exponential() -> [f64; N] {
        let mut e = [1.0; N];
        for j in 1..N {
            e[j] = e[j - 1] / j as f64;
        }
        e
    }

    fn assert_close(a: &[f64; N], b: &[f64; N]) {
        for (j, (a, b)) in a.iter().zip(b).enumerate() {
            assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "coefficient {j}: {a} against {b}");
        }
    }

    #[test]
    fn square_is_product_with_itself() {
        let e = exponential();
        for j in 0..N {
            assert!((square(&e, j) - product(&e, &e, j)).abs() < 1e-14);
            // exp(s)² = exp(2s)
            assert!((square(&e, j) - e[j] * 2f64.powi(i32::try_from(j).unwrap())).abs() < 1e-12);
        }
    }

    #[test]
    fn power_of_a_line_is_the_binomial_series() {
        for alpha in [0.1, 0.5, 1.4, 3.0, -2.5] {
            for side in [1.0, -1.0] {
                let mut x = [0.0; N];
                (x[0], x[1]) = (2.0 * side, side);
                let mut y = [0.0; N];
                y[0] = side * 2f64.powf(alpha);
                let mut binomial = [0.0; N];
                binomial[0] = y[0];
                for j in 1..N {
                    y[j] = power(&x, &y, alpha, j);
                    binomial[j] = binomial[j - 1] * (alpha - (j as f64 - 1.0)) / j as f64 / 2.0;
                }
                assert_close(&y, &binomial);
            }
        }
    }

    #[test]
    fn root_and_quotient_undo_square_and_product() {
        let e = exponential();
        let (mut squared, mut root, mut cube, mut back) = ([0.0; N], [0.0; N], [0.0; N], [0.0; N]);
        for j in 0..N {
            squared[j] = square(&e, j);
            root[j] = square_root(&squared, &root, j);
            cube[j] = product(&squared, &e, j);
            back[j] = quotient(&cube, &e, &back, j);
        }
        assert_close(&root, &e);
        assert_close(&back, &squared);
    }

    #[test]
    fn evaluation_and_slope_agree_with_the_exponential() {
        let e = exponential();
        assert!((evaluate(&e, 0.5) - 0.5f64.exp()).abs() < 1e-15);
        assert!((evaluate_slope(&e, 0.5) - 0.5f64.exp()).abs() < 1e-15);
        assert!((evaluate(&slope(&e), 0.5) - 0.5f64.exp()).abs() < 1e-15);
    }
}
