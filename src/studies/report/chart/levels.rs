//! Bands of a heat map: at most ten, with round bounds, so that each has a distinct colour and character.

use super::scale::{Scale, ViewRange};
use crate::report::steps::{Step, power};

/// Maximum number of bands: the number of characters in the ramp.
pub const BANDS_MAX: usize = 10;

/// Round bounds in ascending order; band i lies between bounds i and i + 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    bounds: Vec<f64>,
}

impl Levels {
    /// Computes bands over all finite values; `None` if there are none.
    pub fn from_values(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let view = ViewRange::from_values(Scale::Linear, values)?;
        let mut step = Step::at_least(view.span() / BANDS_MAX as f64);
        loop {
            let size = step.size();
            let low = (view.lo() / size + 1e-9).floor();
            let bands = (view.hi() / size - 1e-9).ceil() - low;
            if bands <= BANDS_MAX as f64 {
                let count = (0..=BANDS_MAX).take_while(|band| *band as f64 <= bands.max(1.0));
                // Use multiplication instead of summation: 0.3 is then exact.
                let bounds = count.map(|band| bound(low + band as f64, step)).collect();
                return Some(Self { bounds });
            }
            step = step.next();
        }
    }

    /// Returns the number of bands.
    pub fn bands(&self) -> usize {
        self.bounds.len().saturating_sub(1).max(1)
    }

    /// Returns the bounds of a band.
    pub fn band(&self, index: usize) -> (f64, f64) {
        let at = |index: usize| self.bounds[index.min(self.bounds.len() - 1)];
        (at(index), at(index + 1))
    }

    /// Returns the band of a value; values outside belong to the first or last band.
    pub fn index(&self, value: f64) -> usize {
        let above = self.bounds.partition_point(|bound| *bound <= value);
        above.saturating_sub(1).min(self.bands() - 1)
    }
}

/// Computes a multiple of a step; by division for steps below one, so that the digits are round.
fn bound(multiple: f64, step: Step) -> f64 {
    let whole = multiple * f64::from(step.mantissa);
    if step.exponent < 0 { whole / power(-step.exponent) } else { whole * power(step.exponent) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_round_and_hold_all_values() {
        let bounds = |lo: f64, hi: f64| Levels::from_values([lo, hi]).unwrap().bounds;
        assert_eq!(
            bounds(56.0, 97.5),
            [55.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0, 90.0, 95.0, 100.0]
        );
        assert_eq!(bounds(0.0, 1.0).len(), 11);
        assert_eq!(bounds(0.0, 0.5)[6].to_bits(), 0.3f64.to_bits());
        assert!(Levels::from_values([f64::NAN]).is_none());
    }

    #[test]
    fn every_value_has_a_band() {
        for (lo, hi) in [(0.0, 1.0), (56.0, 97.5), (-3.0, 1e-3), (5.0, 5.0), (1e-9, 1e9)] {
            let levels = Levels::from_values([lo, hi]).unwrap();
            assert!((1..=BANDS_MAX).contains(&levels.bands()), "{levels:?}");
            for fraction in [0.0, 0.1, 0.5, 0.99, 1.0] {
                let value = lo + (hi - lo) * fraction;
                let (from, to) = levels.band(levels.index(value));
                let slack = 1e-9 * (hi - lo).abs() + 1e-12 * value.abs();
                assert!(from <= value + slack && value <= to + slack, "{levels:?} {value}");
            }
        }
    }
}
