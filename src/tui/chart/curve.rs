//! A curve: where its points come from, how it is told from others, and its value at the crosshair.

use std::borrow::Cow;

use ratatui::text::Span;

use super::scale::{Scale, ViewRange};
use crate::tui::theme::Role;

/// Characters that tell curves apart, the current run's first; none is used by axes, event lines or the crosshair alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

/// Where the points of a curve come from. In drawing order, usually of rising x.
pub enum Points<'a> {
    /// They lie in memory as pairs (x, y).
    Slice(&'a [(f64, f64)]),
    /// They are made when asked for: how many, and the one at an index below that.
    Made(usize, Box<dyn Fn(usize) -> (f64, f64) + 'a>),
}

impl Points<'_> {
    /// How many points.
    pub fn len(&self) -> usize {
        match self {
            Self::Slice(points) => points.len(),
            Self::Made(length, _) => *length,
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All points (x, y).
    pub fn iter(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        (0..self.len()).map(move |index| match self {
            Self::Slice(points) => points[index],
            Self::Made(_, make) => make(index),
        })
    }
}

/// How a curve stands among the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Emphasis {
    /// Of results that a newer computation is about to replace: faint, at the bottom, `(old)` in the legend.
    Stale,
    /// One of many, in the order given.
    #[default]
    Normal,
    /// Drawn last, over the others.
    Selected,
}

/// Which vertical axis a curve belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Side {
    /// The main one.
    #[default]
    Left,
    /// The second one; the legend says `(right)`.
    Right,
}

/// A curve.
pub struct Curve<'a> {
    /// The character it is drawn with in ASCII, and marked with otherwise. One cell wide.
    pub marker: char,
    /// Its name in the legend.
    pub label: Cow<'a, str>,
    /// Its points, in the units of the axes' views.
    pub points: Points<'a>,
    /// Which colour: [`Role::Curve`].
    pub colour: usize,
    /// How it stands among the others.
    pub emphasis: Emphasis,
    /// Which vertical axis it belongs to.
    pub side: Side,
}

impl<'a> Curve<'a> {
    /// A curve through points in memory.
    pub fn new(marker: char, label: impl Into<Cow<'a, str>>, points: &'a [(f64, f64)]) -> Self {
        Self::with(marker, label.into(), Points::Slice(points))
    }

    /// A curve through what `point` makes of each item. A quantity that does not exist for an item is NaN: a gap.
    pub fn of<T>(
        marker: char,
        label: impl Into<Cow<'a, str>>,
        items: &'a [T],
        point: impl Fn(&T) -> (f64, f64) + 'a,
    ) -> Self {
        let make = Box::new(move |index: usize| point(&items[index]));
        Self::with(marker, label.into(), Points::Made(items.len(), make))
    }

    fn with(marker: char, label: Cow<'a, str>, points: Points<'a>) -> Self {
        Self { marker, label, points, colour: 0, emphasis: Emphasis::Normal, side: Side::Left }
    }

    /// In this colour.
    #[must_use]
    pub fn colour(mut self, colour: usize) -> Self {
        self.colour = colour;
        self
    }

    /// With this emphasis.
    #[must_use]
    pub fn emphasis(mut self, emphasis: Emphasis) -> Self {
        self.emphasis = emphasis;
        self
    }

    /// On this axis.
    #[must_use]
    pub fn side(mut self, side: Side) -> Self {
        self.side = side;
        self
    }

    /// The curve's value at an x, linear between points; `None` outside the curve and inside a gap. At a jump (two points of
    /// equal x) the later point counts.
    pub fn value_at(&self, x: f64) -> Option<f64> {
        let mut before: Option<(f64, f64)> = None;
        let mut found = None;
        for point in self.points.iter() {
            if !(point.0.is_finite() && point.1.is_finite()) {
                before = None;
                continue;
            }
            if let Some(value) = between(before.unwrap_or(point), point, x) {
                found = Some(value);
            }
            before = Some(point);
        }
        found
    }

    /// The range of its x values on a scale; `None` without any.
    pub fn x_range(&self, scale: Scale) -> Option<ViewRange> {
        let drawn = self.points.iter().filter(|(_, y)| y.is_finite());
        ViewRange::of(scale, drawn.map(|(x, _)| x))
    }

    /// The range of its y values on a scale, of the part whose x lies in a view; `None` where nothing does.
    pub fn y_range(&self, scale: Scale, part: ViewRange) -> Option<ViewRange> {
        let drawn = self.points.iter().filter(|(x, _)| part.contains(*x));
        let at_bounds = [part.lo(), part.hi()].into_iter().filter_map(|x| self.value_at(x));
        ViewRange::of(scale, drawn.map(|(_, y)| y).chain(at_bounds))
    }

    /// The role that colours it.
    pub(super) fn role(&self) -> Role {
        match self.emphasis {
            Emphasis::Stale => Role::Dim,
            Emphasis::Normal | Emphasis::Selected => Role::Curve(self.colour),
        }
    }

    /// The marker, if it takes exactly one cell; else one that does.
    pub(super) fn cell_marker(&self) -> char {
        let mut bytes = [0; 4];
        let text: &str = self.marker.encode_utf8(&mut bytes);
        if !self.marker.is_control() && Span::raw(text).width() == 1 {
            self.marker
        } else {
            MARKERS[0]
        }
    }
}

/// The value at x on the line from `a` to `b`, if x lies between them.
fn between(a: (f64, f64), b: (f64, f64), x: f64) -> Option<f64> {
    let inside = (a.0 <= x && x <= b.0) || (b.0 <= x && x <= a.0);
    if !inside {
        return None;
    }
    let fraction = (x - a.0) / (b.0 - a.0);
    if fraction.is_finite() && fraction < 1.0 {
        // Weighted, not added: the difference of two huge values may overflow.
        Some(a.1 * (1.0 - fraction) + b.1 * fraction)
    } else {
        Some(b.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAP: f64 = f64::NAN;

    #[test]
    fn values_lie_on_the_line_between_points() {
        let points = [(0.0, 1.0), (2.0, 5.0), (4.0, 5.0)];
        let curve = Curve::new('*', "now", &points);
        assert_eq!(curve.value_at(0.0), Some(1.0));
        assert_eq!(curve.value_at(0.5), Some(2.0));
        assert_eq!(curve.value_at(2.0), Some(5.0));
        assert_eq!(curve.value_at(4.0), Some(5.0));
    }

    #[test]
    fn there_is_no_value_outside_the_curve_or_in_a_gap() {
        let points = [(0.0, 1.0), (1.0, 2.0), (2.0, GAP), (3.0, 4.0), (4.0, 5.0)];
        let curve = Curve::new('*', "now", &points);
        for x in [-0.1, 1.5, 2.0, 2.9, 4.1, GAP, f64::INFINITY] {
            assert_eq!(curve.value_at(x), None, "{x}");
        }
        assert_eq!(curve.value_at(3.5), Some(4.5));
        assert_eq!(Curve::new('*', "none", &[]).value_at(0.0), None);
    }

    #[test]
    fn at_a_jump_the_later_point_counts() {
        let points = [(0.0, 0.0), (1.0, 10.0), (1.0, 20.0), (2.0, 30.0)];
        let curve = Curve::new('*', "now", &points);
        assert_eq!(curve.value_at(1.0), Some(20.0));
        assert_eq!(curve.value_at(0.5), Some(5.0));
        assert_eq!(curve.value_at(1.5), Some(25.0));
    }

    #[test]
    fn the_vertical_range_is_that_of_what_is_in_view() {
        let points = [(0.0, 0.0), (1.0, 10.0), (2.0, GAP), (3.0, 99.0)];
        let curve = Curve::new('*', "now", &points);
        let range = |lo, hi| curve.y_range(Scale::Linear, ViewRange::new(lo, hi));
        assert_eq!(range(0.0, 3.0), Some(ViewRange::new(0.0, 99.0)));
        assert_eq!(range(0.25, 0.75), Some(ViewRange::new(2.5, 7.5)));
        assert_eq!(range(1.5, 2.5), None);
        assert_eq!(curve.x_range(Scale::Linear), Some(ViewRange::new(0.0, 3.0)));
        assert_eq!(curve.x_range(Scale::Log10), Some(ViewRange::new(1.0, 3.0)));
    }

    #[test]
    fn a_lone_point_has_a_value_where_it_is() {
        let points = [(1.0, 3.0)];
        assert_eq!(Curve::new('*', "now", &points).value_at(1.0), Some(3.0));
    }
}
