//! The least value of a function of one number: golden section, J. Kiefer, *Proceedings of the AMS* 4 (1953) 502-506.

/// (sqrt 5 - 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_895;
/// Sections: the bracket shrinks to 1e-13 of itself.
const SECTIONS: usize = 62;

/// Where, between `a` and `b`, a function with one valley is least. A value that is not a number counts as greater than any
/// other.
pub fn in_bracket(a: f64, b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut a, mut b) = (a, b);
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_c, mut at_d) = (f(c), f(d));
    for _ in 0..SECTIONS {
        if at_c < at_d || at_d.is_nan() {
            (b, d, at_d) = (d, c, at_c);
            c = b - GOLDEN * (b - a);
            at_c = f(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + GOLDEN * (b - a);
            at_d = f(d);
        }
    }
    0.5 * (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valleys_inside_and_at_the_ends_are_found() {
        let inside = in_bracket(-3.0, 10.0, |x| (x - 2.0).powi(2) + 1.0);
        assert!((inside - 2.0).abs() < 1e-7, "{inside}");
        assert!((in_bracket(1.0, 4.0, |x| x) - 1.0).abs() < 1e-10);
        assert!((in_bracket(1.0, 4.0, |x| -x) - 4.0).abs() < 1e-10);
    }

    #[test]
    fn nan_is_avoided() {
        let found = in_bracket(0.0, 10.0, |x| if x > 5.0 { f64::NAN } else { (x - 1.0).abs() });
        assert!((found - 1.0).abs() < 1e-9, "{found}");
    }
}
