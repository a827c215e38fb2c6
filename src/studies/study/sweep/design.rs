//! Which points a sweep visits: the full grid, a Latin hypercube, or Sobol's sequence. Every point is found from its index
//! alone, so that a design of 10^8 points needs no memory and any part of it can be made anywhere.

use std::fmt;

use crate::numerics::random::Random;
use crate::study::sweep::POINTS_MAX;

enumeration! {
    /// How the points of a sweep are chosen.
    #[derive(Default)]
    pub enum Sampling in SamplingRow {
        /// The word of the command line and of files.
        word: &'static str,
        /// The word of forms.
        label: &'static str,
        /// Its description.
        about: &'static str,
        /// Maximum number of points.
        points_max: u64,
    }
    /// Every combination of the axes' values.
    #[default]
    Factorial {
        word: "factorial", label: "grid", points_max: POINTS_MAX,
        about: "Every combination of the axes' values; the last axis varies fastest"
    }
    /// One point in each of as many slices of every axis as points (`McKay`, Beckman and Conover 1979).
    LatinHypercube {
        word: "lhs", label: "lhs", points_max: POINTS_MAX,
        about: "Latin hypercube: as many slices of every axis as points, one point in each"
    }
    /// Sobol's low-discrepancy sequence with the direction numbers of Joe and Kuo (2008), which repeats itself after its greatest
    /// number of points; a seed other than 0 shifts it digit by digit.
    Sobol {
        word: "sobol", label: "sobol", points_max: 1 << 32,
        about: "Sobol's sequence, which fills the space evenly"
    }
}

/// A design; of a full grid, whose axes have counts, points and seed are 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Design {
    /// How its points are chosen.
    pub sampling: Sampling,
    /// How many there are, >= 2.
    pub points: u64,
    /// The same seed gives the same points.
    pub seed: u64,
}

impl Design {
    /// The full grid.
    pub const FACTORIAL: Self = Self { sampling: Sampling::Factorial, points: 0, seed: 0 };

    /// A design; the full grid has no use for points and seed.
    pub fn new(sampling: Sampling, points: u64, seed: u64) -> Self {
        if sampling == Sampling::Factorial {
            return Self::FACTORIAL;
        }
        Self { sampling, points, seed }
    }

    /// Whether it is the full grid.
    pub fn is_full(self) -> bool {
        self.sampling == Sampling::Factorial
    }

    /// The seed, where there is one.
    pub fn seed(self) -> Option<u64> {
        (!self.is_full()).then_some(self.seed)
    }
}

impl fmt::Display for Design {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.sampling.word())?;
        if self.is_full() {
            return Ok(());
        }
        write!(f, ", {} points, seed {}", self.points, self.seed)
    }
}

/// How far along axis `axis` point `index` of a Latin hypercube of `points` lies, in (0, 1).
pub(super) fn hypercube(index: u64, points: u64, axis: u64, seed: u64) -> f64 {
    let key = mix(seed ^ mix(axis.wrapping_add(1)));
    let slice = permuted(index, points, key);
    let within = unit(mix(key ^ mix(index)));
    (slice as f64 + within) / points as f64
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
    }

    #[test]
    fn a_point_far_down_a_great_design_is_found_at_once() {
        let (points, index) = (100_000_000, 99_999_999);
        let share = hypercube(index, points, 3, 5);
        assert!(share > 0.0 && share < 1.0);
    }
}
