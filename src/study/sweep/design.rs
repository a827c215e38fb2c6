//! Which points a sweep visits: the full grid, a Latin hypercube, or Sobol's sequence. Every point is found from its index
//! alone, so that a design of 10^8 points needs no memory and any part of it can be made anywhere.

use crate::numerics::random::Random;
use crate::study::sweep::sobol;

/// A design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Design {
    /// Every combination of the axes' values; the last axis varies fastest.
    Factorial,
    /// A given number of points, one in each of as many slices of every axis (`McKay`, Beckman and Conover 1979).
    LatinHypercube {
        /// How many, >= 2.
        points: u64,
        /// Seed of the design: the same seed gives the same points.
        seed: u64,
    },
    /// A given number of points of Sobol's low-discrepancy sequence with the direction numbers of Joe and Kuo (2008); a seed other than
    /// 0 shifts it digit by digit.
    Sobol {
        /// How many, >= 2.
        points: u64,
        /// 0: the sequence itself.
        seed: u64,
    },
}

impl Design {
    /// The word of the command line and of files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Factorial => "factorial",
            Self::LatinHypercube { .. } => "lhs",
            Self::Sobol { .. } => "sobol",
        }
    }

    /// The seed, where there is one.
    pub fn seed(self) -> Option<u64> {
        match self {
            Self::Factorial => None,
            Self::LatinHypercube { seed, .. } | Self::Sobol { seed, .. } => Some(seed),
        }
    }
}

/// How far along axis `axis` point `index` of a Latin hypercube of `points` lies, in (0, 1).
pub(super) fn hypercube(index: u64, points: u64, axis: u64, seed: u64) -> f64 {
    let key = mix(seed ^ mix(axis.wrapping_add(1)));
    let slice = permuted(index, points, key);
    let within = unit(mix(key ^ mix(index)));
    (slice as f64 + within) / points as f64
}

/// How far along axis `axis` point `index` of Sobol's sequence lies, in [0, 1).
pub(in crate::study) fn sequence(index: u64, axis: usize, seed: u64) -> f64 {
    let shift = if seed == 0 { 0 } else { mix(seed ^ mix(axis as u64 + 1)) >> 32 };
    let bits = u64::from(sobol::bits(index, axis)) ^ shift;
    bits as f64 / 4_294_967_296.0
}

/// A permutation of `0..count`, one for each key: a Feistel network of four rounds over the least even number of bits that
/// holds the count, walked until it lands inside.
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = 64 - (count - 1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1u64 << half) - 1;
    let mut at = index;
    loop {
        let (mut left, mut right) = (at >> half, at & mask);
        for round in 0..4 {
            let turned = left ^ (mix(key ^ mix(right ^ (round << 56))) & mask);
            (left, right) = (right, turned);
        }
        at = (left << half) | right;
        if at < count {
            return at;
        }
    }
}

/// The first random bits of a seed.
fn mix(seed: u64) -> u64 {
    Random::new(seed).bits()
}

/// A number in (0, 1) from random bits.
fn unit(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_latin_hypercube_has_one_point_in_each_slice_of_each_axis() {
        for points in [2, 3, 7, 100, 1000] {
            for seed in [0, 1, 42] {
                for axis in 0..4 {
                    let mut seen = vec![false; usize::try_from(points).unwrap()];
                    for index in 0..points {
                        let share = hypercube(index, points, axis, seed);
                        assert!(share > 0.0 && share < 1.0);
                        let slice = (share * points as f64).floor();
                        let place = (0..seen.len()).find(|at| *at as f64 >= slice).unwrap();
                        assert!(!std::mem::replace(&mut seen[place], true), "{points} {seed}");
                    }
                    assert!(seen.into_iter().all(|seen| seen));
                }
            }
        }
    }

    #[test]
    fn seeds_and_axes_give_different_designs() {
        let column = |axis, seed| -> Vec<u64> {
            (0..50).map(|index| hypercube(index, 50, axis, seed).to_bits()).collect()
        };
        assert_eq!(column(0, 7), column(0, 7));
        assert_ne!(column(0, 7), column(1, 7));
        assert_ne!(column(0, 7), column(0, 8));
        let shifted = |seed| -> Vec<u64> {
            (0..50).map(|index| sequence(index, 1, seed).to_bits()).collect()
        };
        assert_ne!(shifted(0), shifted(1));
        assert_ne!(shifted(2), shifted(1));
    }

    #[test]
    fn a_point_far_down_a_great_design_is_found_at_once() {
        let (points, index) = (100_000_000, 99_999_999);
        let share = hypercube(index, points, 3, 5);
        assert!(share > 0.0 && share < 1.0);
        assert!(sequence(index, 9, 5) < 1.0);
    }

    #[test]
    fn a_shifted_sequence_keeps_one_point_in_each_elementary_interval() {
        for seed in [0, 3] {
            for axis in 0..sobol::DIMENSIONS {
                let mut seen = [false; 64];
                for index in 0..64 {
                    let share = sequence(index, axis, seed);
                    let place = (0..64).rfind(|at| share * 64.0 >= f64::from(*at)).unwrap();
                    let place = usize::try_from(place).unwrap();
                    assert!(!std::mem::replace(&mut seen[place], true), "{axis} {seed}");
                }
            }
        }
    }
}
