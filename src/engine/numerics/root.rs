//! The root of a function in a bracket, or close by.

/// The root of an increasing or decreasing function between `a` and `b`, where it has opposite signs: regula falsi in the
/// Illinois form, with a bisection where three rounds have not halved the bracket, to full precision of x.
///
/// Returns the end with the smaller absolute value when the signs are equal.
pub fn bracketed_root(mut a: f64, mut b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 || (fa > 0.0) == (fb > 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    let mut halved = 0.5 * (b - a).abs();
    // The end that the round before has moved: the other has to move too.
    let mut moved_b = None;
    for round in 0..200 {
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

/// The root of a function close to a value: Newton's method to rounding. `f` gives the function and its slope.
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
}
