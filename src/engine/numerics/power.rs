//! Powers of positive numbers without a branch, so that the compiler computes them in vectors.
//!
//! z^e = 2^(e log2 z), with log2 z split into a whole part and the logarithm of a number between 1/sqrt 2 and sqrt 2 (its series
//! in (m - 1)/(m + 1)), and the power of two into a whole one and one between -1/2 and 1/2 (the exponential's series). The whole
//! part times e is exact but for a part that is kept apart: nothing is lost where z is far from one.

use std::f64::consts::{LN_2, LOG2_E};

/// Bits of 1/sqrt 2, and the mantissa's.
const HALF_ROOT: u64 = 0x3fe6_a09e_667f_3bcd;
const MANTISSA: u64 = (1 << 52) - 1;
/// Bits of one, and 2^52 and 1.5 · 2^52, to which whole numbers are added to read them off the mantissa.
const ONE: u64 = 0x3ff0_0000_0000_0000;
const WHOLE: u64 = 0x4330_0000_0000_0000;
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;
const BIASED: f64 = 4_503_599_627_370_496.0 + 1023.0;
/// All but the last bits of an exponent: what is left times a whole number below 2^11 is exact.
const HIGH: u64 = !0x7ff;
/// Least power of two that is returned, and the greatest.
const LEAST: f64 = -1022.0;
const GREATEST: f64 = 1023.0;

/// z^exponent for z >= 0 and an exponent above zero, relative error below 4e-16 times the greater of 1 and the exponent; powers
/// beyond 2^±1022 stay there. NaN for a NaN or an infinite z.
#[inline(always)]
pub(crate) fn power(z: f64, exponent: f64) -> f64 {
    let shifted = z.to_bits().wrapping_add(ONE - HALF_ROOT);
    let whole = f64::from_bits(shifted >> 52 | WHOLE) - BIASED;
    let m = f64::from_bits((shifted & MANTISSA).wrapping_add(HALF_ROOT));
    let s = (m - 1.0) / (m + 1.0);
    let t = s * s;
    // The last coefficients are those of the series: 0.0295^11/23 is below rounding.
    let mut sum = 1.0 / 21.0;
    for odd in [19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
        sum = sum * t + 1.0 / odd;
    }
    let log2 = (2.0 * LOG2_E) * (s + s * (t * sum));
    let high = f64::from_bits(exponent.to_bits() & HIGH);
    let (exact, rest) = (high * whole, (exponent - high) * whole + exponent * log2);
    let two = exact + rest + TO_WHOLE - TO_WHOLE;
    // A NaN or an infinity would pass for a number by its bits; for any other z this adds nothing.
    let x = ((exact - two) + rest + 0.0 * z) * LN_2;
    let mut exp = 1.0 / 6_227_020_800.0;
    for factorial in FACTORIALS {
        exp = exp * x + 1.0 / factorial;
    }
    let two = if two < LEAST { LEAST } else { two };
    let two = if two > GREATEST { GREATEST } else { two };
    let scaled = exp * f64::from_bits((two + BIASED).to_bits() << 52);
    if z == 0.0 { 0.0 } else { scaled }
}

/// 12!, 11!, ..., 0!.
const FACTORIALS: [f64; 13] = [
    479_001_600.0,
    39_916_800.0,
    3_628_800.0,
    362_880.0,
    40_320.0,
    5_040.0,
    720.0,
    120.0,
    24.0,
    6.0,
    2.0,
    1.0,
    1.0,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::larger;

    #[test]
    fn powers_are_those_of_the_standard_library() {
        let mut worst = 0.0f64;
        for exponent in [0.05, 0.1, 1.0 / 3.0, 0.5, 0.999, 1.0, 1.4, 2.0, 2.5, 3.0, 6.0] {
            for i in -4000..=4000 {
                let z = 10f64.powf(f64::from(i) * 0.01);
                for z in [z, z * (1.0 + f64::EPSILON), 1.0 + 1e-3 * z] {
                    let error = (power(z, exponent) / z.powf(exponent) - 1.0).abs();
                    worst = larger(worst, error / larger(exponent, 1.0));
                }
            }
        }
        assert!(worst < 4e-16, "{worst:e}");
    }

    #[test]
    fn whole_powers_of_two_are_exact() {
        for k in -300..300 {
            let bits = [power(2f64.powi(k), 3.0).to_bits(), 2f64.powi(3 * k).to_bits()];
            assert_eq!(bits[0], bits[1], "{k}");
        }
    }

    #[test]
    fn the_ends_of_the_range_do_not_pass_for_numbers() {
        assert_eq!(power(0.0, 0.3).to_bits(), 0);
        assert!(power(f64::NAN, 0.3).is_nan());
        assert!(power(f64::INFINITY, 0.3).is_nan());
        assert!(power(1e300, 6.0) > 1e307 && power(1e-300, 6.0) < 1e-307);
    }
}
