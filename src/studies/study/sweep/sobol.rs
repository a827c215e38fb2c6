//! Sobol's sequence to the digit, any point from its index: 32 binary digits, Gray-code order.
//!
//! Direction numbers: S. Joe and F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J.
//! Sci. Comput. 30 (2008), file new-joe-kuo-6.21201.

/// Axes the table is good for.
pub(super) const DIMENSIONS: usize = 12;

/// Degree s and coefficients a of the primitive polynomial, and the first s odd numbers m, of dimensions 2 and on.
const TABLE: [(usize, u32, &[u32]); DIMENSIONS - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
];

const DIGITS: usize = 32;

/// Each digit's direction, dimension by dimension.
const DIRECTIONS: [[u32; DIGITS]; DIMENSIONS] = directions();

const fn directions() -> [[u32; DIGITS]; DIMENSIONS] {
    let mut all = [[0; DIGITS]; DIMENSIONS];
    let mut digit = 0;
    while digit < DIGITS {
        all[0][digit] = 1 << (DIGITS - 1 - digit);
        digit += 1;
    }
    let mut dimension = 1;
    while dimension < DIMENSIONS {
        let (s, a, m) = TABLE[dimension - 1];
        let mut digit = 0;
        while digit < DIGITS {
            all[dimension][digit] = if digit < s {
                m[digit] << (DIGITS - 1 - digit)
            } else {
                let mut v = all[dimension][digit - s] ^ (all[dimension][digit - s] >> s);
                let mut k = 1;
                while k < s {
                    v ^= ((a >> (s - 1 - k)) & 1) * all[dimension][digit - k];
                    k += 1;
                }
                v
            };
            digit += 1;
        }
        dimension += 1;
    }
    all
}

/// The 32 digits of point `index` in dimension `axis` (from 0, below [`DIMENSIONS`]); the sequence repeats after 2^32 points.
pub(super) fn bits(index: u64, axis: usize) -> u32 {
    let mut gray = index ^ (index >> 1);
    let mut bits = 0;
    for direction in &DIRECTIONS[axis] {
        if gray & 1 == 1 {
            bits ^= direction;
        }
        gray >>= 1;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first points as Joe and Kuo's own program prints them.
    #[test]
    fn valid_first_points_of_joe_and_kuo() {
        let points: [[f64; 3]; 10] = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
            [0.1875, 0.3125, 0.9375],
            [0.6875, 0.8125, 0.4375],
        ];
        for (index, point) in (0..).zip(points) {
            for (axis, expected) in point.into_iter().enumerate() {
                let found = f64::from(bits(index, axis)) / 4_294_967_296.0;
                assert_eq!(found.to_bits(), expected.to_bits(), "{index} {axis}");
            }
        }
    }

    /// Sobol's property A: the first 2^d points lie one in each of the 2^d half-cubes, which most tables of initial numbers
    /// fail and Joe and Kuo's were chosen to keep.
    #[test]
    fn halves_of_every_axis_are_independent() {
        let d = DIMENSIONS;
        let mut seen = vec![false; 1 << d];
        for index in 0..1u64 << d {
            let corner = (0..d).fold(0, |at, axis| at << 1 | (bits(index, axis) >> 31) as usize);
            assert!(!std::mem::replace(&mut seen[corner], true), "{index}");
        }
    }
}
