//! Numbers of some 31 digits: unevaluated sums of two doubles, for references that must be better than what is compared with
//! them.
//!
//! Sum and product after T. J. Dekker, "A floating-point technique for extending the available precision", *Numerische
//! Mathematik* 18 (1971) 224-242, and Y. Hida, X. S. Li and D. H. Bailey, "Algorithms for quad-double precision floating point
//! arithmetic", *ARITH-15* (2001), sections 2 and 3: a sum or product is good to a few times 2^-104. Without a fused
//! multiply-add, so that results are the same on every machine. Written here because the crates there are leave non-finite values
//! undefined; these carry a NaN through. Exact splitting limits magnitudes to about 1e-250 to 1e290.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number as the sum of two doubles, the second at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// Dekker's constant: 2^27 + 1 splits a double into halves of 26 bits.
const SPLIT: f64 = 134_217_729.0;
/// Terms of the exponential's series after its argument has been reduced below 1e-3: the next one is below 1e-34.
const TERMS: u32 = 11;
/// Halvings of the exponential's argument below ln 2 / 2.
const HALVINGS: u32 = 9;

/// a + b and its rounding error, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The same for |a| >= |b|.
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

fn split(a: f64) -> (f64, f64) {
    let scaled = SPLIT * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// a b and its rounding error, exactly.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

impl DoubleDouble {
    /// 0.
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };
    /// 1.
    pub const ONE: Self = Self { high: 1.0, low: 0.0 };
    /// The circle's number.
    pub const PI: Self = Self { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };
    /// The natural logarithm of 2.
    pub const LN_2: Self = Self { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };

    /// The nearest double.
    pub fn nearest(self) -> f64 {
        self.high
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    /// e to this power; infinite or zero beyond the range of a double.
    #[must_use]
    pub fn exp(self) -> Self {
        if !self.high.is_finite() || self.high.abs() > 700.0 {
            return Self::from(self.high.exp());
        }
        let twos = (self.high / Self::LN_2.high).round();
        let rest = (self - Self::LN_2 * Self::from(twos)).scaled(-f64::from(HALVINGS));
        // e^r - 1 by its series; (1 + y)² - 1 = 2 y + y² undoes a halving without losing the small part.
        let mut term = rest;
        let mut sum = rest;
        for i in 2..=TERMS {
            term = term * rest / Self::from(f64::from(i));
            sum = sum + term;
        }
        for _ in 0..HALVINGS {
            sum = sum + sum + sum * sum;
        }
        (sum + Self::ONE).scaled(twos)
    }

    /// Times this power of two, at most 1100.
    fn scaled(self, twos: f64) -> Self {
        // In two steps: the factor itself may be beyond the range.
        let half = (0.5 * twos).trunc();
        let (a, b) = (half.exp2(), (twos - half).exp2());
        Self { high: self.high * a * b, low: self.low * a * b }
    }

    /// The natural logarithm; NaN of what is not positive.
    #[must_use]
    pub fn ln(self) -> Self {
        let first = self.high.ln();
        if !first.is_finite() {
            return Self::from(if self.high > 0.0 { first } else { f64::NAN });
        }
        // Twos apart, lest the exponential below leave the range in which products are exact.
        let twos = (first / Self::LN_2.high).round();
        let near = self.scaled(-twos);
        // Newton's method on the exponential doubles the digits.
        let mut y = Self::from(near.high.ln());
        for _ in 0..2 {
            y = y + near * (-y).exp() - Self::ONE;
        }
        y + Self::LN_2 * Self::from(twos)
    }

    /// A positive number to a power; NaN of what is not positive.
    #[must_use]
    pub fn powf(self, exponent: Self) -> Self {
        (exponent * self.ln()).exp()
    }
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, more) = two_sum(self.low, other.low);
        let (high, error) = quick_two_sum(high, error + low);
        let (high, low) = quick_two_sum(high, error + more);
        Self { high, low }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let (high, low) =
            quick_two_sum(high, error + (self.high * other.low + self.low * other.high));
        Self { high, low }
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        let (high, low) = quick_two_sum(first, second);
        Self { high, low } + Self::from(rest.high / other.high)
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high)? {
            Ordering::Equal => self.low.partial_cmp(&other.low),
            unequal => Some(unequal),
        }
    }
}

/// Decimal digits, with an exponent or a sign if there is one.
#[cfg(test)]
pub(crate) fn digits(text: &str) -> DoubleDouble {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let ten = DoubleDouble::from(10.0);
    let (mut value, mut shift, mut after) =
        (DoubleDouble::ZERO, power.parse::<i32>().expect("an exponent"), false);
    for c in mantissa.trim_start_matches('-').chars() {
        if let Some(digit) = c.to_digit(10) {
            value = value * ten + DoubleDouble::from(f64::from(digit));
            shift -= i32::from(after);
        }
        after |= c == '.';
    }
    for _ in 0..shift.abs() {
        value = if shift < 0 { value / ten } else { value * ten };
    }
    if mantissa.starts_with('-') { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(value: f64) -> DoubleDouble {
        DoubleDouble::from(value)
    }

    fn assert_close(a: DoubleDouble, b: DoubleDouble) {
        let off = ((a - b) / b).nearest().abs();
        assert!(off < 1e-30, "{a:?} {b:?}: {off:e}");
    }

    #[test]
    fn valid_constants_against_their_decimals() {
        // Abramowitz and Stegun, table 1.1.
        assert_close(DoubleDouble::PI, digits("3.14159265358979323846264338327950288"));
        assert_close(DoubleDouble::LN_2, digits("0.69314718055994530941723212145817657"));
        assert_close(of(1.0).exp(), digits("2.71828182845904523536028747135266250"));
        assert_close(of(2.0).powf(of(0.5)), digits("1.41421356237309504880168872420969808"));
        assert_close(of(10.0).ln(), digits("2.30258509299404568401799145468436421"));
        assert_close(
            of(2.0).powf(of(1.0) / of(3.0)),
            digits("1.25992104989487316476721060727822835"),
        );
    }

    #[test]
    fn sums_and_products_keep_the_digits_that_doubles_lose() {
        let tiny = of(1e-20);
        assert_eq!(((of(1.0) + tiny) - of(1.0)).nearest().to_bits(), 1e-20f64.to_bits());
        let third = of(1.0) / of(3.0);
        assert_close(third * of(3.0), of(1.0));
        assert_close((third + tiny) * (third - tiny), third * third);
        assert!(of(1.0) + tiny > of(1.0) && of(1.0) - tiny < of(1.0));
    }

    #[test]
    fn exponential_and_logarithm_undo_each_other_over_the_range() {
        for x in [-600.0, -40.3, -1e-3, 1e-12, 0.7, 5.0, 690.0] {
            let back = of(x).exp().ln();
            assert!(((back - of(x)).nearest()).abs() < 1e-29 * (1.0 + x.abs()), "{x}");
        }
    }

    #[test]
    fn nan_stays_none() {
        let nan = of(f64::NAN);
        for value in [nan + of(1.0), nan * of(2.0), of(1.0) / nan, nan.exp(), nan.ln()] {
            assert!(value.nearest().is_nan());
        }
        assert!(of(-1.0).ln().nearest().is_nan());
        assert!(of(0.0).ln().nearest().is_nan());
        assert!(nan.partial_cmp(&of(1.0)).is_none());
        assert!(!of(800.0).exp().nearest().is_finite());
        assert!(!(of(1.0) / of(0.0)).nearest().is_finite());
    }
}
