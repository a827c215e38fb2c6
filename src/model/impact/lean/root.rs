//! Where the lean contact's series rise to a level or fall to zero. They know no ballistics.

use crate::numerics::series::evaluate_slope;

/// Rounds at the most.
const ROUNDS_MAX: usize = 60;

/// Where a rising series reaches `level`, between 0 and `end`.
pub(super) fn rise<const N: usize>(c: &[f64; N], level: f64, end: f64) -> f64 {
    let mut c = *c;
    c[0] -= level;
    crossing(&c, end)
}

/// Where a falling series reaches zero, between 0 and `end`.
pub(super) fn fall<const N: usize>(c: &[f64; N], end: f64) -> f64 {
    crossing(c, end)
}

/// Whether a series that is positive at both ends may have touched zero between them.
pub(super) fn dips<const N: usize>(c: &[f64; N], end: f64) -> bool {
    let mut below = c[0];
    let mut power = 1.0;
    for c in &c[1..] {
        power *= end;
        below -= c.abs() * power;
    }
    below <= 0.0 && c[1] < 0.0 && evaluate_slope(c, end) > 0.0
}

/// The zero between 0 and `end`, where the series has opposite signs: Halley's method from the parabola's, kept inside the
/// bracket by bisection.
fn crossing<const N: usize>(c: &[f64; N], end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let inside = c[1] * c[1] - 4.0 * c[0] * c[2];
    let mut s = -2.0 * c[0] / (c[1] + inside.sqrt().copysign(c[1]));
    if !(s > low && s < high) {
        s = 0.5 * end;
    }
    for _ in 0..ROUNDS_MAX {
        let (value, slope, half_bend) = jet(c, s);
        if (value > 0.0) == (c[0] > 0.0) {
            low = s;
        } else {
            high = s;
        }
        let halley = s - value * slope / (slope * slope - value * half_bend);
        // The method triples the digits: a move this small leaves rounding alone.
        if (halley - s).abs() <= 1e-6 * s {
            return halley;
        }
        s = if halley > low && halley < high { halley } else { 0.5 * (low + high) };
    }
    s
}

/// The series, its slope and half its second derivative at `s`.
fn jet<const N: usize>(c: &[f64; N], s: f64) -> (f64, f64, f64) {
    let (mut value, mut slope, mut half_bend) = (0.0, 0.0, 0.0);
    for c in c.iter().rev() {
        half_bend = half_bend * s + slope;
        slope = slope * s + value;
        value = value * s + c;
    }
    (value, slope, half_bend)
}
