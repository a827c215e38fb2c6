//! The greatest value of a function on an interval: samples, and Brent's method around each of their maxima that may exceed what
//! is known (R. P. Brent, *Algorithms for Minimization without Derivatives* (1973), chapter 5).

use crate::numerics::larger;

/// Cells of the interval.
const CELLS: usize = 8;
/// Part of a cell by which the slope of the function at an end of the interval is seen.
const INSIDE: f64 = 1e-3;
/// Part of the interval to which a maximum is located: the value is then right to rounding.
const LOCATED: f64 = 1e-8;
/// Evaluations after which the best place found is taken.
const ROUNDS_MAX: usize = 60;
/// (3 - sqrt 5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// The greatest value of `f` between `from` and `to`, where it has no more than one maximum in each of eight cells. Maxima are
/// located only if they may exceed `known`.
pub(crate) fn greatest(from: f64, to: f64, known: f64, f: impl Fn(f64) -> f64) -> f64 {
    let cell = (to - from) / CELLS as f64;
    let place = |i: usize| if i == CELLS { to } else { from + cell * i as f64 };
    let values: [f64; CELLS + 1] = std::array::from_fn(|i| f(place(i)));
    let mut best = larger(values[0], values[CELLS]);
    for (i, value) in values.iter().enumerate() {
        let (before, after) = (i.saturating_sub(1), if i == CELLS { i } else { i + 1 });
        let (down, up) = (value - values[before], value - values[after]);
        if !(down >= 0.0 && up >= 0.0) || value + larger(down, up) <= larger(known, best) {
            continue;
        }
        let rises_inside = match i {
            0 => f(from + INSIDE * cell) > *value,
            CELLS => f(to - INSIDE * cell) > *value,
            _ => true,
        };
        if rises_inside {
            best = larger(f(in_bracket(place(before), place(after), &f)), best);
        }
    }
    best
}

/// Where `f` has its only maximum between `a` and `b`.
pub fn in_bracket(a: f64, b: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    let (mut a, mut b, tolerance) = (a, b, LOCATED * (b - a));
    let mut x = a + GOLDEN * (b - a);
    let (mut w, mut v) = (x, x);
    let mut at_x = f(x);
    let (mut at_w, mut at_v) = (at_x, at_x);
    let (mut step, mut before_last) = (0.0f64, 0.0f64);
    for _ in 0..ROUNDS_MAX {
        let middle = 0.5 * (a + b);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            break;
        }
        // The vertex of the parabola through the three best places.
        let r = (x - w) * (at_x - at_v);
        let q = (x - v) * (at_x - at_w);
        let (numerator, denominator) = ((x - v) * q - (x - w) * r, 2.0 * (q - r));
        let vertex = -numerator / denominator;
        let fits = vertex.abs() < (0.5 * before_last).abs() && x + vertex > a && x + vertex < b;
        before_last = step;
        step = if fits {
            vertex
        } else {
            before_last = if x < middle { b - x } else { a - x };
            GOLDEN * before_last
        };
        let least = if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let u = x + least;
        let at_u = f(u);
        if at_u >= at_x {
            if u < x {
                b = x;
            } else {
                a = x;
            }
            (v, at_v, w, at_w, x, at_x) = (w, at_w, x, at_x, u, at_u);
        } else {
            if u < x {
                a = u;
            } else {
                b = u;
            }
            if at_u >= at_w || w.to_bits() == x.to_bits() {
                (v, at_v, w, at_w) = (w, at_w, u, at_u);
            } else if at_u >= at_v || v.to_bits() == x.to_bits() || v.to_bits() == w.to_bits() {
                (v, at_v) = (u, at_u);
            }
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::greatest;

    const UNKNOWN: f64 = f64::NEG_INFINITY;

    #[test]
    fn maxima_inside_and_at_the_ends_are_found_to_rounding() {
        let sine = greatest(0.0, 2.0, UNKNOWN, f64::sin);
        assert!((sine - 1.0).abs() < 1e-15, "{sine}");
        // Close to an end, within a cell of it.
        let early = greatest(0.0, 1.0, UNKNOWN, |s| 3.0 - (s - 0.01).powi(2));
        assert!((early - 3.0).abs() < 1e-15, "{early}");
        let late = greatest(0.0, 1.0, UNKNOWN, |s| 3.0 - (s - 0.99).powi(2));
        assert!((late - 3.0).abs() < 1e-15, "{late}");
        assert!((greatest(1.0, 4.0, UNKNOWN, |s| s) - 4.0).abs() < 1e-15);
        assert!((greatest(1.0, 4.0, UNKNOWN, |s| -s) + 1.0).abs() < 1e-15);
    }

    #[test]
    fn of_several_maxima_the_greatest_is_found() {
        // 1.5 at s = 1/4, 2 at s = 3/4.
        let two = |s: f64| {
            1.5 * (-200.0 * (s - 0.25f64).powi(2)).exp() + 2.0 * (-200.0 * (s - 0.75).powi(2)).exp()
        };
        assert!((greatest(0.0, 1.0, UNKNOWN, two) - 2.0).abs() < 1e-14);
        assert!((greatest(0.0, 1.0, UNKNOWN, |s| two(1.0 - s)) - 2.0).abs() < 1e-14);
    }

    #[test]
    fn maxima_below_the_known_one_are_not_located() {
        let evaluations = Cell::new(0);
        let count = |s: f64| {
            evaluations.set(evaluations.get() + 1);
            -(s - 0.5) * (s - 0.5)
        };
        let _ = greatest(0.0, 1.0, 1.0, count);
        assert_eq!(evaluations.get(), 9);
    }
}
