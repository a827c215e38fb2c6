//! Polynomials by their coefficients, that of s^j at index j.

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

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 + 2 s + 3 s² is 2.75 at a half, and rises by 5 there.
    #[test]
    fn valid_value_and_slope_of_a_parabola() {
        let c = [1.0, 2.0, 3.0];
        assert!((evaluate(&c, 0.5) - 2.75).abs() < 1e-15);
        assert!((evaluate_slope(&c, 0.5) - 5.0).abs() < 1e-15);
    }
}
