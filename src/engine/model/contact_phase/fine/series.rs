//! Power series with coefficients of some 31 digits: products, values, roots, and how far they may be trusted.
//! Knows no motion.

use crate::numerics::double_double::DoubleDouble;

pub(super) type Number = DoubleDouble;
pub(super) type Series = [Number; TERMS];

/// Newton steps to an event: more than double the digits need.
const NEWTON: usize = 12;
/// A factor on the step that the last terms suggest.
const CAUTION: f64 = 0.8;
/// Terms of the expansions.
pub(super) const TERMS: usize = 34;

/// Coefficient j of a b.
pub(super) fn product(a: &Series, b: &Series, j: usize) -> Number {
    (0..=j).fold(Number::ZERO, |sum, i| sum + a[i] * b[j - i])
}

/// The polynomial's value.
pub(super) fn at(c: &Series, s: Number) -> Number {
    c.iter().rev().fold(Number::ZERO, |sum, c| sum * s + *c)
}

/// Where the polynomial takes a value, near the end of a step.
pub(super) fn root(c: &Series, value: Number, end: Number) -> Number {
    let mut s = end;
    let (mut low, mut high) = (Number::ZERO, end);
    let rises = value > c[0];
    // Bisection into Newton's reach, then Newton.
    for round in 0..60 + NEWTON {
        let off = at(c, s) - value;
        if (off > Number::ZERO) == rises {
            high = s;
        } else {
            low = s;
        }
        let slope =
            (1..TERMS).rev().fold(Number::ZERO, |sum, j| sum * s + Number::from(j as f64) * c[j]);
        let newton = s - off / slope;
        let inside = newton >= low && newton <= high;
        let next = if inside { newton } else { Number::from(0.5) * (low + high) };
        let moved = (next - s).abs();
        s = next;
        if round > 2 && moved <= Number::from(1e-31) * s.abs() {
            break;
        }
    }
    s
}

/// The part of the unit within which the last terms stay below the truncation, relative to each component's own size: what a
/// plate has done in the first instants is tiny, and decides the power laws all the same.
pub(super) fn trusted(series: &[Series; 4], truncation: f64) -> f64 {
    let mut least = f64::INFINITY;
    for c in series {
        let scale: f64 = c.iter().take(4).map(|c| c.nearest().abs()).sum();
        for order in [TERMS - 1, TERMS - 2] {
            let term = c[order].nearest().abs();
            if term.is_nan() {
                return f64::NAN;
            }
            if term > 0.0 {
                let reach = (truncation * scale / term).powf(1.0 / order as f64);
                least = if reach < least { reach } else { least };
            }
        }
    }
    if least < f64::INFINITY { CAUTION * least } else { 1.0 }
}
