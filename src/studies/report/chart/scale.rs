//! Conversion between values and cells: [`Scale`], the displayed range ([`ViewRange`]), and [`Mapping`], the only conversion from a value
//! to a column or row.
//!
//! The first value of a range is at the centre of the first cell, the last value at the centre of the last cell, for every glyph set.
//! Ticks, curves and crosshair at the same value therefore share a column.

use crate::report::steps::{decade, power};

/// Maximum distance of positions from the view, in cells. Large enough to keep the direction of a line, and small enough for exact
/// clipping.
const FAR_CELLS: f64 = 1e9;
/// Distinct positions within a cell.
const GRAINS: f64 = 1e4;
/// Minimum span, as a fraction of the larger bound. Labels cannot show more than twelve digits.
const NARROWEST: f64 = 1e-12;
/// Maximum magnitude of bounds; prevents overflow of differences.
const GREATEST: f64 = 1e300;
/// Relative difference below which values are treated as equal: the accuracy of runs and searches.
const FLAT: f64 = 1e-8;
/// Minimum span of a range around zero; avoids subnormal numbers in the arithmetic of ticks.
const NARROWEST_ABSOLUTE: f64 = 1e-280;
/// Lower bound of a logarithmic axis over its upper bound, if the lower bound is not positive.
const LOG_FLOOR: f64 = 1e-6;

/// Scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Scale {
    /// Linear scale.
    #[default]
    Linear,
    /// Logarithmic scale; represents positive values only.
    Log10,
}

impl Scale {
    /// Returns `true` if the scale can represent a value.
    pub fn shows(self, value: f64) -> bool {
        value.is_finite() && (self == Self::Linear || value > 0.0)
    }

    /// Converts a value to a coordinate that is linear along the axis.
    pub fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log10 => value.log10(),
        }
    }

    /// Converts a coordinate to its value: the inverse of [`Scale::place`].
    pub fn back(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Log10 => 10_f64.powf(place),
        }
    }
}

/// Range of values of an axis. Always finite, never empty, never reversed.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewRange {
    lo: f64,
    hi: f64,
}

impl Default for ViewRange {
    /// Returns the range from 0 to 1.
    fn default() -> Self {
        Self { lo: 0.0, hi: 1.0 }
    }
}

impl ViewRange {
    /// Creates the range between two values, in either order. An empty range is widened by a twentieth at both ends, or to 0 to 1 at zero.
    /// If one value is not finite, the range has width 1 at the other; if both are not, it is 0 to 1.
    pub fn new(a: f64, b: f64) -> Self {
        let (a, b) = match (a.is_finite(), b.is_finite()) {
            (true, true) => (a, b),
            (true, false) => (a, a + 1.0),
            (false, true) => (b - 1.0, b),
            (false, false) => (0.0, 1.0),
        };
        let (a, b) = (a.clamp(-GREATEST, GREATEST), b.clamp(-GREATEST, GREATEST));
        let (lo, hi) = if a <= b { (a, b) } else { (b, a) };
        let greatest = lo.abs().max(hi.abs());
        if hi - lo >= (greatest * NARROWEST).max(NARROWEST_ABSOLUTE) {
            return Self { lo, hi };
        }
        if greatest < NARROWEST_ABSOLUTE {
            return Self::default();
        }
        Self { lo: lo - greatest * 0.05, hi: hi + greatest * 0.05 }
    }

    /// Returns the range of all values that the scale can represent; `None` if there are none.
    pub fn from_values(scale: Scale, values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut bounds: Option<(f64, f64)> = None;
        for value in values.into_iter().filter(|value| scale.shows(*value)) {
            let (lo, hi) = bounds.unwrap_or((value, value));
            bounds = Some((lo.min(value), hi.max(value)));
        }
        let is_flat = |lo: f64, hi: f64| hi - lo <= FLAT * lo.abs().max(hi.abs());
        let bounds = bounds.map(|(lo, hi)| if is_flat(lo, hi) { (lo, lo) } else { (lo, hi) });
        bounds.map(|(lo, hi)| Self::new(lo, hi).on(scale))
    }

    /// Returns the lower bound.
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Returns the upper bound.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Returns upper less lower bound, > 0.
    pub fn span(self) -> f64 {
        self.hi - self.lo
    }

    /// Returns the maximum magnitude of the bounds.
    pub fn size(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// Returns `true` if a value lies in the range, bounds included.
    pub fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// Restricts the range to the values that a scale can represent: positive values for a logarithmic scale.
    pub fn on(self, scale: Scale) -> Self {
        match scale {
            Scale::Linear => self,
            Scale::Log10 if self.hi <= 1e-290 => Self { lo: 0.1, hi: 10.0 },
            Scale::Log10 => {
                let lo = if self.lo > 1e-300 { self.lo } else { self.hi * LOG_FLOOR };
                Self { lo, hi: self.hi }
            }
        }
    }

    /// Extends the range by a fraction of its span at both ends, in the coordinates of the scale. Unchanged if the result would be too
    /// narrow.
    pub fn padded(self, scale: Scale, fraction: f64) -> Self {
        let view = self.on(scale);
        let (lo, hi) = (scale.place(view.lo), scale.place(view.hi));
        let more = (hi - lo) * fraction;
        let (lo, hi) = (scale.back(lo - more), scale.back(hi + more));
        let greatest = lo.abs().max(hi.abs());
        let sane = lo.is_finite() && hi.is_finite() && greatest <= GREATEST;
        let positive = scale == Scale::Linear || lo > 1e-300;
        if sane && positive && hi - lo > (greatest * NARROWEST).max(NARROWEST_ABSOLUTE) {
            Self { lo, hi }
        } else {
            view
        }
    }

    /// Extends the range to whole decades, so that small changes of the data do not move a logarithmic axis.
    pub fn in_decades(self) -> Self {
        let view = self.on(Scale::Log10);
        let top = decade(view.hi);
        let above = if power(top) < view.hi { top + 1 } else { top };
        Self::new(power(decade(view.lo)), power(above)).on(Scale::Log10)
    }
}

/// Conversion between values and cells along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapping {
    /// Scale of the axis.
    pub scale: Scale,
    /// Displayed range.
    pub view: ViewRange,
    /// Number of cells.
    pub cells: u16,
    /// Lower bound and span of the view, in the coordinates of the scale.
    from: f64,
    span: f64,
}

impl Mapping {
    /// Creates the mapping of a range to a number of cells.
    pub fn new(scale: Scale, view: ViewRange, cells: u16) -> Self {
        let view = view.on(scale);
        let from = scale.place(view.lo);
        Self { scale, view, cells, from, span: scale.place(view.hi) - from }
    }

    /// Returns the position of a value, in cells from the centre of the first one; `None` if the scale cannot represent it. Positions are
    /// limited to a billion cells outside the view.
    pub fn position(self, value: f64) -> Option<f64> {
        if !self.scale.shows(value) {
            return None;
        }
        let fraction = (self.scale.place(value) - self.from) / self.span;
        let last = f64::from(self.cells.saturating_sub(1));
        // Round positions, so that rounding errors do not move values that lie on the edge of two cells by construction, such as a padded
        // upper end.
        let grained = (fraction * last * GRAINS).round() / GRAINS;
        Some(grained.clamp(-FAR_CELLS, FAR_CELLS))
    }

    /// Returns the cell of a value, starting at 0; `None` outside the view.
    pub fn cell(self, value: f64) -> Option<u16> {
        let cells = usize::from(self.cells);
        let index = whole_below(self.position(value)? + 0.5, cells)?;
        u16::try_from(index).ok()
    }

    /// Returns the value at the centre of a cell; larger indices give the last cell.
    pub fn value(self, cell: u16) -> f64 {
        let last = self.cells.saturating_sub(1);
        if last == 0 || cell == 0 {
            return self.view.lo;
        }
        if cell >= last {
            return self.view.hi;
        }
        // Multiply before dividing: the value at a tick then equals its label.
        let from_start = self.span * f64::from(cell) / f64::from(last);
        self.scale.back(self.from + from_start)
    }
}

/// Rounds a position down to a cell; `None` outside 0..`count`. The only conversion from floating point to a cell or dot.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the value is checked to be in 0..count first; NaN fails the check"
)]
pub fn whole_below(position: f64, count: usize) -> Option<usize> {
    (position >= 0.0 && position < count as f64).then_some(position as usize)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    use super::*;

    /// Where the failures of all packages are kept.
    const REGRESSIONS: &str = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../proptest-regressions/studies/report/chart/scale.txt"
    );

    /// Difference of a hundred times the search width of a mass efficiency, and the noise of one.
    #[test]
    fn values_that_differ_by_noise_alone_are_one() {
        let span = |values: [f64; 2]| ViewRange::from_values(Scale::Linear, values).unwrap().span();
        assert!(span([1.006_541_778, 1.006_541_780]) > 0.09);
        assert!((span([1.0, 1.000_000_1]) - 1e-7).abs() < 1e-15);
    }

    #[test]
    fn bounds_are_put_in_order_and_never_empty() {
        assert_eq!(ViewRange::new(3.0, 1.0), ViewRange::new(1.0, 3.0));
        assert_eq!(ViewRange::new(f64::NAN, f64::INFINITY), ViewRange::default());
        assert_eq!(ViewRange::new(2.0, f64::NAN), ViewRange { lo: 2.0, hi: 3.0 });
        assert_eq!(ViewRange::new(0.0, 0.0), ViewRange::default());
        assert_eq!(ViewRange::new(10.0, 10.0), ViewRange { lo: 9.5, hi: 10.5 });
    }

    #[test]
    fn decades_hold_the_range() {
        let log = |lo, hi| ViewRange::new(lo, hi).in_decades();
        assert_eq!(log(3e-7, 0.2), ViewRange::new(1e-7, 1.0));
        assert_eq!(log(1.0, 1000.0), ViewRange::new(1.0, 1000.0));
    }

    fn any_f64() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => -1e6..1e6_f64,
            1 => any::<f64>(),
            1 => prop::sample::select(vec![
                0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN,
                f64::MIN_POSITIVE, 5e-324, 1.0,
            ]),
        ]
    }

    fn any_scale() -> impl Strategy<Value = Scale> {
        prop::sample::select(vec![Scale::Linear, Scale::Log10])
    }

    fn sane(view: ViewRange) -> bool {
        view.lo().is_finite() && view.hi().is_finite() && view.lo() < view.hi()
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            failure_persistence: Some(Box::new(FileFailurePersistence::Direct(REGRESSIONS))),
            ..ProptestConfig::default()
        })]

        #[test]
        fn ranges_stay_sane_under_any_operation(
            a in any_f64(), b in any_f64(), scale in any_scale(),
        ) {
            let view = ViewRange::new(a, b);
            let all = [
                view, view.on(scale), view.padded(scale, 0.1),
                view.in_decades(),
            ];
            for range in all {
                prop_assert!(sane(range), "{:?}", range);
                prop_assert!(range.on(Scale::Log10).lo() > 0.0, "{:?}", range);
            }
        }

        #[test]
        fn a_cell_and_its_value_return_to_each_other(
            a in any_f64(), b in any_f64(), scale in any_scale(), cells in 1_u16..400, pick in 0.0..1.0_f64,
        ) {
            let map = Mapping::new(scale, ViewRange::new(a, b), cells);
            let cell = whole_below(pick * f64::from(cells), usize::from(cells)).unwrap();
            let cell = u16::try_from(cell).unwrap();
            prop_assert_eq!(map.cell(map.value(cell)), Some(cell));
        }
    }
}
