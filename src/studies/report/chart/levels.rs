//! The steps of a heat map's scale: round bounds, at most ten bands, so that colours and characters stay few and can be named.

use super::scale::{Scale, ViewRange};
use crate::report::steps::{Step, decade, power};

/// The most bands: as many as there are characters in the ramp.
pub const BANDS_MAX: usize = 10;

const DECADE: f64 = 10.0;

/// Round bounds in rising order; band i is from bound i to bound i + 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    bounds: Vec<f64>,
}

impl Levels {
    /// Bands over all values that the scale can show; `None` when there is none.
    pub fn of(scale: Scale, values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let view = ViewRange::of(scale, values)?;
        Some(match scale {
            // Within a decade there are too few of 1, 2 and 5.
            Scale::Log10 if view.hi() > DECADE * view.lo() => Self::logarithmic(view),
            Scale::Linear | Scale::Log10 => Self::linear(view),
        })
    }

    fn linear(view: ViewRange) -> Self {
        let mut step = Step::at_least(view.span() / BANDS_MAX as f64);
        loop {
            let size = step.size();
            let low = (view.lo() / size + 1e-9).floor();
            let bands = (view.hi() / size - 1e-9).ceil() - low;
            if bands <= BANDS_MAX as f64 {
                let count = (0..=BANDS_MAX).take_while(|band| *band as f64 <= bands.max(1.0));
                // Multiplied, not added up: 0.3 is then 0.3.
                return Self { bounds: count.map(|band| bound(low + band as f64, step)).collect() };
            }
            step = step.next();
        }
    }

    /// Decades; 1, 2 and 5 of them where there is room, only every few where there is not.
    fn logarithmic(view: ViewRange) -> Self {
        let (first, last) = (decade(view.lo()), decade(view.hi()));
        let bounds = |every: i32, mantissas: &[f64]| {
            let from = first.div_euclid(every) * every;
            let all = (0..).map(|index| from + index * every);
            let all = all.take_while(|exponent| *exponent < last + 1 + every).map(power);
            let all = all.flat_map(|decade| mantissas.iter().map(move |it| it * decade));
            around(all.collect(), view)
        };
        let fine = (last - first <= 2).then(|| bounds(1, &[1.0, 2.0, 5.0]));
        let coarse = (1..).map(|every| bounds(every, &[1.0]));
        let mut fitting = fine.into_iter().chain(coarse).filter(|it| it.len() <= BANDS_MAX + 1);
        Self { bounds: fitting.next().expect("every so many decades are few enough") }
    }

    /// How many bands there are.
    pub fn bands(&self) -> usize {
        self.bounds.len().saturating_sub(1).max(1)
    }

    /// The bounds of a band.
    pub fn band(&self, index: usize) -> (f64, f64) {
        let at = |index: usize| self.bounds[index.min(self.bounds.len() - 1)];
        (at(index), at(index + 1))
    }

    /// The band a value lies in; values outside count to the first or last one.
    pub fn index(&self, value: f64) -> usize {
        let above = self.bounds.partition_point(|bound| *bound <= value);
        above.saturating_sub(1).min(self.bands() - 1)
    }
}

/// A multiple of a step; by division where the step is below one, so that the digits are round.
fn bound(multiple: f64, step: Step) -> f64 {
    let whole = multiple * f64::from(step.mantissa);
    if step.exponent < 0 { whole / power(-step.exponent) } else { whole * power(step.exponent) }
}

/// The bounds from the last one at or below a range to the first one at or above it.
fn around(all: Vec<f64>, view: ViewRange) -> Vec<f64> {
    let first = all.partition_point(|bound| *bound <= view.lo() * (1.0 + 1e-12)).saturating_sub(1);
    let last = all.partition_point(|bound| *bound < view.hi() * (1.0 - 1e-12));
    let kept = &all[first..=last.min(all.len() - 1)];
    if kept.len() < 2 { all } else { kept.to_vec() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bounds(scale: Scale, lo: f64, hi: f64) -> Vec<f64> {
        Levels::of(scale, [lo, hi]).unwrap().bounds
    }

    #[test]
    fn bounds_are_round_and_hold_all_values() {
        assert_eq!(
            bounds(Scale::Linear, 56.0, 97.5),
            [55.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0, 90.0, 95.0, 100.0]
        );
        assert_eq!(bounds(Scale::Linear, 0.0, 1.0).len(), 11);
        assert_eq!(bounds(Scale::Linear, 0.0, 0.5)[6].to_bits(), 0.3f64.to_bits());
        assert_eq!(bounds(Scale::Log10, 1e-6, 0.5).len(), 7);
        assert_eq!(bounds(Scale::Log10, 3.0, 40.0), [2.0, 5.0, 10.0, 20.0, 50.0]);
        assert!(bounds(Scale::Log10, 1e-30, 1.0).len() <= BANDS_MAX + 1);
        assert_eq!(bounds(Scale::Log10, 56.0, 97.5), bounds(Scale::Linear, 56.0, 97.5));
        assert!(Levels::of(Scale::Linear, [f64::NAN]).is_none());
        assert!(Levels::of(Scale::Log10, [0.0]).is_none());
    }

    #[test]
    fn every_value_has_a_band() {
        for (lo, hi) in [(0.0, 1.0), (56.0, 97.5), (-3.0, 1e-3), (5.0, 5.0), (1e-9, 1e9)] {
            for scale in [Scale::Linear, Scale::Log10] {
                let Some(levels) = Levels::of(scale, [lo, hi]).filter(|_| scale.shows(lo)) else {
                    continue;
                };
                assert!((1..=BANDS_MAX).contains(&levels.bands()), "{levels:?}");
                for share in [0.0, 0.1, 0.5, 0.99, 1.0] {
                    let value = lo + (hi - lo) * share;
                    if !scale.shows(value) {
                        continue;
                    }
                    let (from, to) = levels.band(levels.index(value));
                    let slack = 1e-9 * (hi - lo).abs() + 1e-12 * value.abs();
                    assert!(from <= value + slack && value <= to + slack, "{levels:?} {value}");
                }
            }
        }
    }
}
