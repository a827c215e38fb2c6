//! How far a Taylor expansion may be trusted.
//!
//! The last two coefficients of each component tell the radius within which the truncated series is good to a
//! tolerance: À. Jorba and M. Zou, "A software package for the numerical integration of ODEs by means of high-order Taylor
//! methods", *Experimental Mathematics* 14 (2005) 99-117, section 3. No step is ever rejected: the coefficients do not depend
//! on the step.

/// Greatest growth of the step from one expansion to the next.
const GROWTH_MAX: f64 = 50.0;

/// The step, in units of the expansion's own time unit, that keeps the truncation error of every component below
/// `tolerance` times its scale.
///
/// `components` are (coefficients, scale) with scale > 0. Larger scales allow larger steps. A component whose last coefficients
/// vanish does not limit the step. Returns 0 when a coefficient is not finite.
pub(crate) fn trusted_step<const N: usize>(components: &[(&[f64; N], f64)], tolerance: f64) -> f64 {
    let (mut last, mut before) = (0.0f64, 0.0f64);
    for (c, scale) in components {
        let (a, b) = (c[N - 1].abs() / scale, c[N - 2].abs() / scale);
        if !(a.is_finite() && b.is_finite()) {
            return 0.0;
        }
        last = if a > last { a } else { last };
        before = if b > before { b } else { before };
    }
    let reach = |term: f64, order: usize| {
        if term == 0.0 { GROWTH_MAX } else { ((tolerance / term).ln() / order as f64).exp() }
    };
    let (a, b) = (reach(last, N - 1), reach(before, N - 2));
    let step = if a < b { a } else { b };
    if step < GROWTH_MAX { step } else { GROWTH_MAX }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::series::evaluate;

    /// y' = y, expanded with time unit h.
    fn expand<const N: usize>(y: f64, h: f64) -> [f64; N] {
        let mut c = [y; N];
        for j in 1..N {
            c[j] = c[j - 1] * h / j as f64;
        }
        c
    }

    fn integrate<const N: usize>(tolerance: f64) -> (f64, usize) {
        let (mut y, mut t, mut h, mut steps) = (1.0, 0.0, 0.1, 0);
        while t < 2.0 {
            let c: [f64; N] = expand(y, h);
            let s = trusted_step(&[(&c, y)], tolerance).min((2.0 - t) / h);
            y = evaluate(&c, s);
            t += s * h;
            h *= s;
            steps += 1;
            assert!(steps < 1000);
        }
        ((y / 2f64.exp() - 1.0).abs(), steps)
    }

    #[test]
    fn the_error_follows_the_tolerance() {
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let (error, steps) = integrate::<17>(tolerance);
            assert!(error < 10.0 * tolerance, "{tolerance}: {error} in {steps} steps");
        }
    }

    #[test]
    fn higher_order_takes_fewer_steps_for_the_same_tolerance() {
        let (_, low) = integrate::<9>(1e-13);
        let (_, high) = integrate::<21>(1e-13);
        assert!(high < low, "{high} against {low}");
    }

    #[test]
    fn a_polynomial_does_not_limit_the_step_and_a_nan_stops_it() {
        let mut c = [0.0; 17];
        c[1] = 1.0;
        assert!((trusted_step(&[(&c, 1.0)], 1e-12) - GROWTH_MAX).abs() < 1e-12);
        c[16] = f64::NAN;
        assert_eq!(trusted_step(&[(&c, 1.0)], 1e-12).to_bits(), 0);
    }
}
