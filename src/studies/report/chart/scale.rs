//! From values to cells and back: [`Scale`], the shown range ([`ViewRange`]), and [`Mapping`], the only place where a value
//! becomes a column or a row.
//!
//! The first value of a range lies in the middle of the first cell, the last one in the middle of the last, whatever the glyph
//! set: a tick, a curve and the crosshair at the same value are always in the same column.

use crate::report::steps::{decade, power};

/// Positions are kept within this many cells of the view: far enough that the direction of a line is right, near enough that
/// clipping it loses nothing.
const FAR_CELLS: f64 = 1e9;
/// Positions within a cell that are distinguished.
const GRAINS: f64 = 1e4;
/// The narrowest range, as a fraction of its greatest bound: twelve digits are what a label can still distinguish.
const NARROWEST: f64 = 1e-12;
/// Bounds stay within this, so that a difference of two never overflows.
const GREATEST: f64 = 1e300;
/// Values that differ by less than this fraction are one: runs and searches are no better.
const FLAT: f64 = 1e-8;
/// The narrowest range about zero; keeps the arithmetic of ticks away from subnormal numbers.
const NARROWEST_ABSOLUTE: f64 = 1e-280;
/// A logarithmic axis whose lower bound is not positive starts this fraction below its upper bound.
const LOG_FLOOR: f64 = 1e-6;

/// How values are spread over an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Scale {
    /// Evenly.
    #[default]
    Linear,
    /// By decades; values that are not positive have no place.
    Log10,
}

impl Scale {
    /// Whether a value has a place.
    pub fn shows(self, value: f64) -> bool {
        value.is_finite() && (self == Self::Linear || value > 0.0)
    }

    /// Where a value lies, as a number that grows evenly along the axis.
    pub fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log10 => value.log10(),
        }
    }

    /// The value at a place: the inverse of [`Scale::place`].
    pub fn back(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Log10 => 10_f64.powf(place),
        }
    }
}

/// The range of values an axis shows. Always finite, never empty, never reversed.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewRange {
    lo: f64,
    hi: f64,
}

impl Default for ViewRange {
    /// From 0 to 1.
    fn default() -> Self {
        Self { lo: 0.0, hi: 1.0 }
    }
}

impl ViewRange {
    /// The range between two values, in either order. Where it would be empty it is widened, by a twentieth at both ends
    /// or, at zero, to 0 to 1. A value that is not finite is replaced: both, by 0 to 1; one, by a range of width 1 at the other.
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

    /// The range of all values that have a place on the scale; `None` when there is none.
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

    /// The lower bound.
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The upper bound.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Upper less lower bound, > 0.
    pub fn span(self) -> f64 {
        self.hi - self.lo
    }

    /// The greatest magnitude in it.
    pub fn size(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// Whether a value lies in the range, bounds included.
    pub fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// The range as a scale can show it: positive for a logarithmic one.
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

    /// Grown by a fraction of its span at both ends, in the space of the scale. Where the result would be too narrow to show it is as it
    /// was.
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

    /// Grown to whole decades, so that small changes of the data do not move a logarithmic axis.
    pub fn in_decades(self) -> Self {
        let view = self.on(Scale::Log10);
        let top = decade(view.hi);
        let above = if power(top) < view.hi { top + 1 } else { top };
        Self::new(power(decade(view.lo)), power(above)).on(Scale::Log10)
    }
}

/// Values to cells along one axis and back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapping {
    /// The scale.
    pub scale: Scale,
    /// The range as shown.
    pub view: ViewRange,
    /// How many cells there are.
    pub cells: u16,
    /// The view's lower bound and span in the space of the scale.
    from: f64,
    span: f64,
}

impl Mapping {
    /// A range spread over a given number of cells.
    pub fn new(scale: Scale, view: ViewRange, cells: u16) -> Self {
        let view = view.on(scale);
        let from = scale.place(view.lo);
        Self { scale, view, cells, from, span: scale.place(view.hi) - from }
    }

    /// Where a value lies, in cells from the middle of the first one; `None` where the scale has no place for it. Values far
    /// outside are held within a billion cells.
    pub fn position(self, value: f64) -> Option<f64> {
        if !self.scale.shows(value) {
            return None;
        }
        let fraction = (self.scale.place(value) - self.from) / self.span;
        let last = f64::from(self.cells.saturating_sub(1));
        // What lies on the edge of two cells by construction (a padded top does) must not flip with the last digit.
        let grained = (fraction * last * GRAINS).round() / GRAINS;
        Some(grained.clamp(-FAR_CELLS, FAR_CELLS))
    }

    /// The cell a value lies in, from 0; `None` outside the view.
    pub fn cell(self, value: f64) -> Option<u16> {
        let cells = usize::from(self.cells);
        let index = whole_below(self.position(value)? + 0.5, cells)?;
        u16::try_from(index).ok()
    }

    /// The value in the middle of a cell; cells beyond the last one count as the last.
    pub fn value(self, cell: u16) -> f64 {
        let last = self.cells.saturating_sub(1);
        if last == 0 || cell == 0 {
            return self.view.lo;
        }
        if cell >= last {
            return self.view.hi;
        }
        // Multiplied before divided: the value at a tick comes out as it is written there.
        let from_start = self.span * f64::from(cell) / f64::from(last);
        self.scale.back(self.from + from_start)
    }
}

/// The whole number just below a position, if it is one of `count` places from 0. The one conversion from floating point to
/// a cell or dot.
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

    use super::*;

    /// A hundred times the width to which a mass efficiency is searched, and the noise of one.
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
