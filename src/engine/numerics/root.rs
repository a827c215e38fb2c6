//! Root finding: in a bracket, or from an initial guess.

/// Maximum number of iterations. At least one in six halves the bracket, so that a root of 1e-40 of its width converges.
const ROUNDS_MAX: usize = 1000;

/// Returns the root of a function between `a` and `b` to full precision of x, by the Illinois method.
///
/// A bisection follows if three iterations have not halved the bracket. If the signs at `a` and `b` are equal, returns the end with the
/// smaller absolute value.
pub fn bracketed_root(mut a: f64, mut b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 || (fa > 0.0) == (fb > 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    let mut halved = 0.5 * (b - a).abs();
    // Whether the previous iteration replaced `b`. The value at an end that is retained twice is halved.
    let mut moved_b = None;
    for round in 0..ROUNDS_MAX {
        let secant = (a * fb - b * fa) / (fb - fa);
        let inside = (secant - a) * (secant - b) < 0.0;
        let width = (b - a).abs();
        let is_slow = round % 3 == 2 && width > halved;
        if round % 3 == 2 {
            halved = 0.5 * width;
        }
        let x = if inside && !is_slow { secant } else { 0.5 * (a + b) };
        let fx = f(x);
        if fx == 0.0 || (b - a).abs() <= 2.0 * f64::EPSILON * x.abs() {
            return x;
        }
        let moves_b = (fx > 0.0) == (fb > 0.0);
        let part = if moved_b == Some(moves_b) { 0.5 } else { 1.0 };
        moved_b = Some(moves_b);
        if moves_b {
            (b, fb) = (x, fx);
            fa *= part;
        } else {
            (a, fa) = (x, fx);
            fb *= part;
        }
    }
    0.5 * (a + b)
}

/// Returns the root of a function near `start` to rounding error, by Newton's method. `f` returns the value and the derivative.
pub(crate) fn newton_root(start: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut x = start;
    for _ in 0..10 {
        let (value, slope) = f(x);
        x -= value / slope;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bracket_finds_steep_and_flat_roots_in_few_evaluations() {
        let mut count = 0;
        let cube = bracketed_root(0.0, 10.0, |x| {
            count += 1;
            x * x * x - 2.0
        });
        assert!((cube - 2f64.cbrt()).abs() < 1e-15 && count < 30, "{cube} {count}");
        let steep = bracketed_root(0.0, 1.0, |x| (x - 0.3) * 1e12);
        assert!((steep - 0.3).abs() < 1e-15);
    }

    /// Roots are relative to themselves, however small a part of the bracket they are.
    #[test]
    fn a_root_far_below_the_width_of_its_bracket_is_found() {
        for exponent in [-3, -10, -15, -20, -40] {
            let exact = 3.0 * 10f64.powi(exponent);
            let found = bracketed_root(0.0, 0.03, |x| exact * exact - x * x);
            assert!((found / exact - 1.0).abs() < 1e-15, "{found:e} for {exact:e}");
        }
    }
}
