//! Roots: of polynomials on a step (events), and of functions in a bracket.

use crate::numerics::series::{evaluate, evaluate_slope};

/// Pieces into which a step is cut when an event cannot be excluded at once.
const PIECES: usize = 8;

/// The first s in (0, end] at which the polynomial passes from positive to zero or below; `None` if it does not.
///
/// A polynomial that is zero or negative at 0 has to become positive first: an event that has just been handled does not
/// fire again. Non-finite coefficients give `None`.
pub fn first_down_crossing(c: &[f64], end: f64) -> Option<f64> {
    let mut bound = 0.0;
    let mut power = 1.0;
    for c in &c[1..] {
        power *= end;
        bound += c.abs() * power;
    }
    // Never reaches zero within the step: the common case, decided in one pass.
    if c[0] > bound || !bound.is_finite() || c[0].is_nan() || c[0] < -bound {
        return None;
    }
    let (mut left, mut at_left) = (0.0, c[0]);
    // At the boundary the direction of travel says on which side it is.
    let mut armed = c.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
    for piece in 1..=PIECES {
        let right = end * piece as f64 / PIECES as f64;
        let at_right = evaluate(c, right);
        if armed && at_right <= 0.0 {
            let from = if at_left > 0.0 { left } else { positive_side(c, right) };
            return Some(bracketed(c, from, right));
        }
        let (slope_left, slope_right) = (evaluate_slope(c, left), evaluate_slope(c, right));
        if armed && slope_left < 0.0 && slope_right > 0.0 {
            // A dip between two positive ends.
            let bottom = extremum(c, left, right);
            if evaluate(c, bottom) <= 0.0 {
                return Some(bracketed(c, left, bottom));
            }
        }
        if !armed && at_right <= 0.0 && slope_left > 0.0 && slope_right < 0.0 {
            // A hump between two ends that are not positive.
            let top = extremum(c, left, right);
            if evaluate(c, top) > 0.0 {
                return Some(bracketed(c, top, right));
            }
        }
        armed |= at_right > 0.0;
        (left, at_left) = (right, at_right);
    }
    None
}

/// Every s in (0, end) at which the polynomial passes from positive to zero or below, if it does so no more than once in each of
/// eight parts.
pub fn each_down_crossing(c: &[f64], end: f64, mut visit: impl FnMut(f64)) {
    let (mut left, mut at_left) = (0.0, evaluate(c, 0.0));
    for piece in 1..=PIECES {
        let right = end * piece as f64 / PIECES as f64;
        let at_right = evaluate(c, right);
        if at_left > 0.0 && at_right <= 0.0 {
            visit(bracketed(c, left, right));
        }
        (left, at_left) = (right, at_right);
    }
}

/// A point between 0 and `right` where a polynomial whose first coefficient that is not zero is positive is still positive:
/// there no later term reaches its fraction of the first one.
fn positive_side(c: &[f64], right: f64) -> f64 {
    let Some(first) = (1..c.len()).find(|j| c[*j] != 0.0) else { return 0.0 };
    let mut s = right;
    for j in first + 1..c.len() {
        if c[j] < 0.0 {
            let fraction = c[first] / (-c[j] * c.len() as f64);
            s = s.min(fraction.powf(1.0 / (j - first) as f64));
        }
    }
    s
}

/// Where the slope changes sign between `a` and `b`.
fn extremum(c: &[f64], mut a: f64, mut b: f64) -> f64 {
    let falling = evaluate_slope(c, a) < 0.0;
    for _ in 0..50 {
        let mid = 0.5 * (a + b);
        if (evaluate_slope(c, mid) < 0.0) == falling { a = mid } else { b = mid }
    }
    0.5 * (a + b)
}

/// The root between `a` (positive) and `b` (zero or negative): Newton, safeguarded by bisection.
fn bracketed(c: &[f64], mut a: f64, mut b: f64) -> f64 {
    let mut s = 0.5 * (a + b);
    for _ in 0..60 {
        let value = evaluate(c, s);
        if value > 0.0 {
            a = s;
        } else {
            b = s;
        }
        let slope = evaluate_slope(c, s);
        let newton = s - value / slope;
        let next = if newton > a && newton < b { newton } else { 0.5 * (a + b) };
        if (next - s).abs() <= 2.0 * f64::EPSILON * s.abs() || a >= b {
            return next;
        }
        s = next;
    }
    s
}

/// The root of an increasing or decreasing function between `a` and `b`, where it has opposite signs: regula falsi in the
/// Illinois form, safeguarded by bisection, to full precision of x.
///
/// Returns the end with the smaller absolute value when the signs are equal.
pub fn in_bracket(a: f64, b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    bracketed_root(a, b, &mut f)
}

/// The same, compiled once for all functions.
fn bracketed_root(mut a: f64, mut b: f64, f: &mut dyn FnMut(f64) -> f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 || (fa > 0.0) == (fb > 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    for round in 0..200 {
        let secant = (a * fb - b * fa) / (fb - fa);
        let inside = (secant - a) * (secant - b) < 0.0;
        let x = if inside && round % 3 != 2 { secant } else { 0.5 * (a + b) };
        let fx = f(x);
        if fx == 0.0 || (b - a).abs() <= 2.0 * f64::EPSILON * x.abs() {
            return x;
        }
        if (fx > 0.0) == (fb > 0.0) {
            (b, fb) = (x, fx);
            fa *= 0.5;
        } else {
            (a, fa) = (x, fx);
            fb *= 0.5;
        }
    }
    0.5 * (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_simple_fall_is_found_to_rounding() {
        // 1 - s²/4 falls through zero at s = 2.
        let root = first_down_crossing(&[1.0, 0.0, -0.25], 3.0).unwrap();
        assert!((root - 2.0).abs() < 1e-15);
        assert_eq!(first_down_crossing(&[1.0, 0.0, -0.25], 1.9), None);
    }

    #[test]
    fn an_event_just_handled_does_not_fire_again() {
        assert_eq!(first_down_crossing(&[0.0, -1.0], 1.0), None);
        // Zero and rising is armed: s - s² falls at 1.
        assert!((first_down_crossing(&[0.0, 1.0, -1.0], 2.0).unwrap() - 1.0).abs() < 1e-14);
        assert!((first_down_crossing(&[0.0, 0.0, 1.0, -1.0], 2.0).unwrap() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn dips_and_humps_between_samples_are_seen() {
        // (s - 0.53)² - 1e-6: a dip narrower than a piece.
        let dip = [0.53 * 0.53 - 1e-6, -1.06, 1.0];
        assert!((first_down_crossing(&dip, 1.0).unwrap() - 0.529).abs() < 1e-9);
        let hump = [-0.53 * 0.53 + 1e-6, 1.06, -1.0];
        assert!((first_down_crossing(&hump, 1.0).unwrap() - 0.531).abs() < 1e-9);
    }

    #[test]
    fn five_roots_at_step_ends_fire_once_each() {
        // cos-like polynomial restarted at each root: count the down-crossings of a quintic with known roots.
        let roots = [0.1, 0.3, 0.5, 0.7, 0.9];
        let mut c = vec![1.0];
        for r in roots {
            let mut next = vec![0.0; c.len() + 1];
            for (i, c) in c.iter().enumerate() {
                next[i] += r * c;
                next[i + 1] -= c;
            }
            c = next;
        }
        let mut found = Vec::new();
        let mut from = 0.0;
        while from < 1.0 {
            // Put exactly on the zero it comes from, as states are.
            let mut shifted = shift(&c, from);
            shifted[0] = if from > 0.0 { 0.0 } else { shifted[0] };
            let Some(s) = first_down_crossing(&shifted, 1.0 - from) else {
                break;
            };
            found.push(from + s);
            from += s;
        }
        let down_crossings = [0.1, 0.5, 0.9];
        assert_eq!(found.len(), down_crossings.len(), "{found:?}");
        for (found, fall) in found.iter().zip(down_crossings) {
            assert!((found - fall).abs() < 1e-12);
        }
    }

    fn shift(c: &[f64], by: f64) -> Vec<f64> {
        let mut out = vec![0.0; c.len()];
        for c in c.iter().rev() {
            for i in (1..out.len()).rev() {
                out[i] = out[i] * by + out[i - 1];
            }
            out[0] = out[0] * by + c;
        }
        out
    }

    #[test]
    fn every_fall_of_a_polynomial_is_visited() {
        // (s - 0.2)(s - 0.5)(s - 0.9) falls through zero at 0.5; its negative at 0.2 and 0.9.
        let c = [-0.09, 0.73, -1.6, 1.0];
        let down_crossings = |c: &[f64]| {
            let mut found = Vec::new();
            each_down_crossing(c, 1.0, |s| found.push(s));
            found
        };
        let near = |found: &[f64], exact: &[f64]| {
            found.len() == exact.len()
                && found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-14)
        };
        assert!(near(&down_crossings(&c), &[0.5]));
        assert!(near(&down_crossings(&c.map(|c| -c)), &[0.2, 0.9]));
    }

    #[test]
    fn non_finite_coefficients_give_no_event() {
        assert_eq!(first_down_crossing(&[1.0, f64::NAN], 1.0), None);
        assert_eq!(first_down_crossing(&[f64::NAN, -1.0], 1.0), None);
    }

    #[test]
    fn bracket_finds_steep_and_flat_roots() {
        let cube = in_bracket(0.0, 10.0, |x| x * x * x - 2.0);
        assert!((cube - 2f64.cbrt()).abs() < 1e-15);
        let steep = in_bracket(0.0, 1.0, |x| (x - 0.3) * 1e12);
        assert!((steep - 0.3).abs() < 1e-15);
    }
}
