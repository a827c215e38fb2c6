//! Sobol sequence in Gray-code order with 32 binary digits; a point is computed from its index.
//!
//! Direction numbers: S. Joe and F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J.
//! Sci. Comput. 30 (2008), file new-joe-kuo-6.21201.

use std::sync::LazyLock;

use cmra_engine::numerics::random::Random;

/// Number of dimensions in the table of direction numbers.
pub(super) const DIMENSIONS: usize = 24;

/// Primitive polynomial (degree s, coefficients a) and initial direction numbers m of each dimension from the second on.
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
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, 7, &[1, 1, 3, 13, 7, 35, 63]),
    (7, 8, &[1, 3, 5, 9, 1, 25, 53]),
    (7, 14, &[1, 3, 1, 13, 9, 35, 107]),
];

const DIGITS: usize = 32;

/// Direction numbers by dimension and digit.
static DIRECTIONS: LazyLock<[[u32; DIGITS]; DIMENSIONS]> =
    LazyLock::new(|| std::array::from_fn(directions));

fn directions(dimension: usize) -> [u32; DIGITS] {
    let mut directions = std::array::from_fn(|digit| 1 << (DIGITS - 1 - digit));
    if dimension == 0 {
        return directions;
    }
    let (s, a, m) = TABLE[dimension - 1];
    for digit in 0..DIGITS {
        directions[digit] = if digit < s {
            m[digit] << (DIGITS - 1 - digit)
        } else {
            let first = directions[digit - s] ^ (directions[digit - s] >> s);
            (1..s).fold(first, |v, k| v ^ (((a >> (s - 1 - k)) & 1) * directions[digit - k]))
        };
    }
    directions
}

/// Returns a coordinate, in [0, 1), of the point `index`. The `dimension` is below [`DIMENSIONS`]; the sequence repeats after 2^32
/// points. A seed other than 0 applies a random digital shift.
pub(super) fn point_coordinate(index: u64, dimension: usize, seed: u64) -> f64 {
    let of_dimension = Random::new(dimension as u64 + 1).bits();
    let shift = if seed == 0 { 0 } else { Random::new(seed ^ of_dimension).bits() >> 32 };
    (u64::from(bits(index, dimension)) ^ shift) as f64 / 4_294_967_296.0
}

/// Returns the 32 digits of a coordinate.
fn bits(index: u64, dimension: usize) -> u32 {
    let mut gray = index ^ (index >> 1);
    let mut bits = 0;
    for direction in &DIRECTIONS[dimension] {
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
                let found = point_coordinate(index, axis, 0);
                assert_eq!(found.to_bits(), expected.to_bits(), "{index} {axis}");
            }
        }
    }

    /// Sobol's property A: the first 2^d points lie one in each of the 2^d half-cubes, which most tables of initial numbers
    /// fail and Joe and Kuo's were chosen to keep. It holds where the leading digits of the directions are linearly independent.
    #[test]
    fn halves_of_every_dimension_are_independent() {
        for d in 1..=DIMENSIONS {
            // What is left of each row less those before it, of which none has the first digit of one before it.
            let mut basis: Vec<u32> = Vec::new();
            for directions in &DIRECTIONS[..d] {
                let row = (0..d).fold(0, |row, digit| row | (directions[digit] >> 31) << digit);
                let left = basis.iter().fold(row, |left, base| left.min(left ^ base));
                assert_ne!(left, 0, "{d}");
                basis.push(left);
            }
        }
    }

    #[test]
    fn a_shifted_sequence_keeps_one_point_in_each_elementary_interval() {
        for seed in [0, 3] {
            for dimension in 0..DIMENSIONS {
                let mut seen = [false; 64];
                for index in 0..64 {
                    let fraction = point_coordinate(index, dimension, seed);
                    let place = (0..64).rfind(|at| fraction * 64.0 >= f64::from(*at)).unwrap();
                    let place = usize::try_from(place).unwrap();
                    assert!(!std::mem::replace(&mut seen[place], true), "{dimension} {seed}");
                }
            }
        }
        assert_ne!(point_coordinate(3, 1, 2).to_bits(), point_coordinate(3, 1, 1).to_bits());
    }
}
