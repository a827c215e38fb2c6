//! Maximum of a function on an interval by sampling and Brent's method (R. P. Brent, *Algorithms for Minimization without Derivatives*
//! (1973), chapter 5).

use crate::numerics::larger;

/// Number of equal subintervals between the samples.
const CELLS: usize = 8;
/// Distance from an end of the interval, relative to its length, at which the sign of the derivative is determined. The end itself is
/// unsuitable: for a piecewise function it can belong to the next piece.
const INSIDE: f64 = 1e-6;
/// Tolerance of the position of a maximum, relative to the interval. The error of the value is its square, which is rounding error.
const LOCATED: f64 = 1e-8;
/// Maximum number of iterations; afterwards the best point is returned.
const ROUNDS_MAX: usize = 60;
/// (3 - sqrt 5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// Returns the maximum of `f` on (0, 1).
///
/// `values` are samples at the ends of eight subintervals, each with at most one local maximum. Only a maximum that can exceed `known` is
/// located. `rate` has the sign of the derivative of `f`; without it a difference of two values is used.
pub(crate) fn greatest(
    values: &[f64; CELLS + 1],
    known: f64,
    f: &dyn Fn(f64) -> f64,
    rate: Option<&dyn Fn(f64) -> f64>,
) -> f64 {
    let place = |i: usize| i as f64 / CELLS as f64;
    let falls = |near: f64, beyond: f64| match rate {
        Some(rate) => rate(near) * (beyond - near) < 0.0,
        None => f(near) > f(beyond),
    };
    let mut best = larger(values[0], values[CELLS]);
    for (i, value) in values.iter().enumerate() {
        let (before, after) = (i.saturating_sub(1), if i == CELLS { i } else { i + 1 });
        let (down, up) = (value - values[before], value - values[after]);
        if !(down >= 0.0 && up >= 0.0) || value + larger(down, up) <= larger(known, best) {
            continue;
        }
        let rises_inside = match i {
            0 => falls(2.0 * INSIDE, INSIDE),
            CELLS => falls(1.0 - 2.0 * INSIDE, 1.0 - INSIDE),
            _ => true,
        };
        if rises_inside {
            best = larger(f(in_bracket(place(before), place(after), &f)), best);
        }
    }
    best
}

/// Returns the position of the only maximum of `f` between `a` and `b`.
pub fn in_bracket(a: f64, b: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    let (mut a, mut b, tolerance) = (a, b, LOCATED * (b - a));
    let first = a + GOLDEN * (b - a);
    // The three best points with their values, best first.
    let mut best = [(first, f(first)); 3];
    let (mut step, mut before_last) = (0.0f64, 0.0f64);
    for _ in 0..ROUNDS_MAX {
        let [(x, at_x), (w, at_w), (v, at_v)] = best;
        let middle = 0.5 * (a + b);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            break;
        }
        // Vertex of the parabola through the three best points.
        let r = (x - w) * (at_x - at_v);
        let q = (x - v) * (at_x - at_w);
        let vertex = -((x - v) * q - (x - w) * r) / (2.0 * (q - r));
        let fits = vertex.abs() < (0.5 * before_last).abs() && x + vertex > a && x + vertex < b;
        before_last = step;
        step = if fits {
            vertex
        } else {
            before_last = if x < middle { b - x } else { a - x };
            GOLDEN * before_last
        };
        let least = if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        // The smallest step can lead beyond an end.
        let u = if x + least > a && x + least < b { x + least } else { x - least };
        let at_u = f(u);
        let is_best = at_u >= at_x;
        let end = if is_best { x } else { u };
        (a, b) = if is_best == (u < x) { (a, end) } else { (end, b) };
        let is_same = |one: f64, other: f64| one.to_bits() == other.to_bits();
        let is_second = at_u >= at_w || is_same(w, x);
        let is_third = at_u >= at_v || is_same(v, x) || is_same(v, w);
        if let Some(rank) = [is_best, is_second, is_third].iter().position(|it| *it) {
            best[rank..].rotate_right(1);
            best[rank] = (u, at_u);
        }
    }
    best[0].0
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    fn max_of(known: f64, f: impl Fn(f64) -> f64) -> f64 {
        let values = std::array::from_fn(|i| f(i as f64 / CELLS as f64));
        greatest(&values, known, &f, None)
    }

    fn is_near(f: impl Fn(f64) -> f64, exact: f64) -> bool {
        (max_of(f64::NEG_INFINITY, f) - exact).abs() < 1e-14
    }

    #[test]
    fn maxima_inside_and_at_the_ends_are_found_to_rounding() {
        assert!(is_near(|s| (2.0 * s).sin(), 1.0));
        // Close to an end, within a cell of it.
        assert!(is_near(|s| 3.0 - (s - 0.01).powi(2), 3.0));
        assert!(is_near(|s| 3.0 - (s - 0.99).powi(2), 3.0));
        assert!(is_near(|s| 3.0 - (s - (1.0 - 3e-5)).powi(2), 3.0));
        assert!(is_near(|s| s, 1.0) && is_near(|s| -s, 0.0));
        // Beside an end that has the value of another piece.
        let beside = |s: f64| 3.0 - 1e-3 * (s - (1.0 - 4e-5)).powi(2) - 1e-12;
        assert!(is_near(|s| if s < 1.0 { beside(s) } else { 3.0 - 1.8e-12 }, 3.0 - 1e-12));
        assert!(is_near(|s| if s > 0.0 { beside(1.0 - s) } else { 3.0 - 1.8e-12 }, 3.0 - 1e-12));
        // 1.5 at s = 1/4, 2 at s = 3/4.
        let two = |s: f64| {
            1.5 * (-200.0 * (s - 0.25f64).powi(2)).exp() + 2.0 * (-200.0 * (s - 0.75).powi(2)).exp()
        };
        assert!(is_near(two, 2.0) && is_near(|s| two(1.0 - s), 2.0));
    }

    /// A maximum closer to an end than the tolerance of its position.
    #[test]
    fn no_point_outside_the_bracket_is_tried() {
        for i in 0..1000 {
            let (at, bend) = (2e-11 * f64::from(i), 1e-3 * f64::from(i));
            let f = |s: f64| {
                assert!((0.0..=1.0).contains(&s), "{at:e}: {s:e}");
                -(s - at).powi(2) * (1.0 + bend * s)
            };
            in_bracket(0.0, 1.0, &f);
            in_bracket(0.0, 1.0, &|s| f(1.0 - s));
        }
    }

    /// By 1e-12 over the end, of which rounding leaves a step.
    #[test]
    fn a_maximum_that_only_the_rate_shows_is_found() {
        let f = |s: f64| 1.0 - 1e-2 * (s - (1.0 - 1e-5)).powi(2);
        let values = std::array::from_fn(|i| f(i as f64 / CELLS as f64));
        let found = |rate: f64| greatest(&values, f64::NEG_INFINITY, &f, Some(&|_| rate));
        assert_eq!((found(-1.0) > values[CELLS], found(1.0) > values[CELLS]), (true, false));
    }

    #[test]
    fn maxima_below_the_known_one_are_not_located() {
        let evaluations = Cell::new(0);
        let count = |s: f64| {
            evaluations.set(evaluations.get() + 1);
            -(s - 0.5) * (s - 0.5)
        };
        let _ = max_of(1.0, count);
        assert_eq!(evaluations.get(), CELLS + 1);
    }
}
