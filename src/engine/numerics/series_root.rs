//! Zeros of a power series on an interval: the position of a single crossing, and a bound for further ones.
//!
//! Not by `root`: the contact kernel needs a zero in each step, and a series has its first guess and its derivatives at the cost of a value.

/// Maximum number of iterations; bisection alone needs 53.
const ROUNDS_MAX: usize = 60;
/// Relative change of an iterate at which Halley's method stops. Its convergence is cubic: the remaining error is below rounding.
const SETTLED: f64 = 1e-6;

/// Returns the position between 0 and `end` at which an increasing series reaches `level`.
pub(crate) fn rise<const N: usize>(c: &[f64; N], level: f64, end: f64) -> f64 {
    let mut c = *c;
    c[0] -= level;
    zero(&c, end)
}

/// Returns `true` if a series that is positive at 0 and at `end` can have a zero between them.
pub(crate) fn dips<const N: usize>(c: &[f64; N], end: f64) -> bool {
    let mut below = c[0];
    let mut power = 1.0;
    for c in &c[1..] {
        power *= end;
        below -= c.abs() * power;
    }
    below <= 0.0 && c[1] < 0.0 && jet(c, end).1 > 0.0
}

/// Returns the zero between 0 and `end`, where the series has opposite signs.
///
/// Halley's method, safeguarded by bisection. The initial guess is the zero of the quadratic part, corrected for the cubic term to second
/// order.
pub(crate) fn zero<const N: usize>(c: &[f64; N], end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let steep = (c[1] * c[1] - 4.0 * c[0] * c[2]).sqrt().copysign(c[1]);
    let parabola = -2.0 * c[0] / (c[1] + steep);
    let moved = -c[3] / steep * (parabola * parabola);
    let mut s = parabola * (1.0 + moved * (1.0 + 2.5 * moved));
    for _ in 0..ROUNDS_MAX {
        if !(s > low && s < high) {
            s = 0.5 * (low + high);
        }
        let (value, slope, half_bend) = jet(c, s);
        if (value > 0.0) == (c[0] > 0.0) {
            low = s;
        } else {
            high = s;
        }
        let halley = s - value * slope / (slope * slope - value * half_bend);
        // Cubic convergence: the remaining error is below rounding.
        if (halley - s).abs() <= SETTLED * s {
            return halley;
        }
        s = halley;
    }
    s
}

/// Returns the series, its derivative and half its second derivative at `s`.
fn jet<const N: usize>(c: &[f64; N], s: f64) -> (f64, f64, f64) {
    c.iter().rev().fold((0.0, 0.0, 0.0), |(value, slope, half_bend), c| {
        (value * s + c, slope * s + value, half_bend * s + slope)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_rises_to_its_level_wherever_that_is() {
        // s (3 - s²) rises on (0, 1): with s = 2 sin(a) its value is 2 sin(3 a).
        for i in 1..=1000 {
            let third = std::f64::consts::FRAC_PI_6 * f64::from(i) / 1001.0;
            let found = rise(&[0.0, 3.0, 0.0, -1.0], 2.0 * (3.0 * third).sin(), 1.0);
            let exact = 2.0 * third.sin();
            // Digits go where the slope does.
            let lost = 1.0 / (1.0 - exact * exact);
            assert!((found / exact - 1.0).abs() < 8e-16 * lost, "{i}: {found} {exact}");
        }
    }

    #[test]
    fn a_series_without_a_slope_at_zero_rises_too() {
        for level in [1e-30, 1e-9, 0.3, 0.999] {
            let found = rise(&[0.0, 0.0, 0.75, 0.25], level, 1.0);
            let back = found * found * (0.75 + 0.25 * found);
            assert!((back / level - 1.0).abs() < 1e-15, "{level}: {found}");
        }
        // A triple zero behind it: the level is known to a third of the digits.
        let found = rise(&[0.0, 3.0, -3.0, 1.0], 1.0 - 1e-12, 1.0);
        assert!((found - (1.0 - 1e-4)).abs() < 1e-7, "{found}");
    }

    #[test]
    fn a_fall_is_found_and_a_dip_suspected() {
        assert!((zero(&[2.0, -1.0, -1.0, 0.0], 3.0) - 1.0).abs() < 1e-15);
        assert!(dips(&[1.0, -4.0, 4.0, 0.0], 1.0));
        assert!(!dips(&[1.0, -0.5, 0.4, 0.0], 1.0) && !dips(&[1.0, 1.0, 1.0, 0.0], 1.0));
    }
}
