//! Charts as plain data: axes with units, curves, reference lines, and how a chart is shown. The terminal and SVG draw these charts
//! with the ticks and bands computed here.

use std::borrow::Cow;

use cmra_engine::model::units::Prefix;

pub mod levels;
pub mod scale;
pub mod ticks;

pub use scale::{Mapping, Scale, ViewRange};
use ticks::{Along, Ticks};

/// How to show a quantity: numbers times `factor` are in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit<'a> {
    /// Shown number = value * factor; finite and > 0.
    pub factor: f64,
    /// Name of the shown unit; empty for a pure number.
    pub name: Cow<'a, str>,
}

impl Default for Unit<'_> {
    /// Returns the unit of a pure number.
    fn default() -> Self {
        Self::new("")
    }
}

impl<'a> Unit<'a> {
    /// A unit as it is.
    pub fn new(name: impl Into<Cow<'a, str>>) -> Self {
        Self { factor: 1.0, name: name.into() }
    }

    /// The prefix under which a number of this size is from 1 to below 1000: 0.0071 m gives mm. Units that take
    /// no prefix (none, `kg`, `deg`, `%`, powers such as `m^2`) are left alone.
    pub fn with_prefix(size: f64, unit: &'a str) -> Self {
        let prefix = Prefix::for_unit(size, unit);
        Self { factor: prefix.in_one, name: format!("{}{unit}", prefix.letter).into() }
    }
}

/// An axis.
#[must_use]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis<'a> {
    /// Quantity of the axis: `t`. In a terminal the chart's title names the quantity of the left axis.
    pub label: Cow<'a, str>,
    /// The unit numbers are shown in; points, views and lines stay in the unit of the data.
    pub unit: Unit<'a>,
    /// How values are spread.
    pub scale: Scale,
    /// Range of values shown, in the unit of the data.
    pub view: ViewRange,
}

impl<'a> Axis<'a> {
    /// A linear axis that shows numbers as they are, without a unit.
    pub fn new(label: impl Into<Cow<'a, str>>, view: ViewRange) -> Self {
        Self { label: label.into(), view, ..Self::default() }
    }

    /// An axis over all of these values that have a place on it; `None` where there is none.
    pub fn over(
        label: impl Into<Cow<'a, str>>,
        unit: &'a str,
        scale: Scale,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Self> {
        let view = ViewRange::from_values(scale, values)?;
        Some(Self::new(label, view).scale(scale).unit(Unit::with_prefix(view.size(), unit)))
    }

    /// A linear one with some room beyond the values.
    pub fn fitted(
        label: impl Into<Cow<'a, str>>,
        unit: &'a str,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Self> {
        Some(Self::over(label, unit, Scale::Linear, values)?.padded(0.05))
    }

    /// With numbers in this unit.
    pub fn unit(self, unit: Unit<'a>) -> Self {
        Self { unit, ..self }
    }

    /// With this scale.
    pub fn scale(self, scale: Scale) -> Self {
        Self { scale, ..self }
    }

    /// With zero on it.
    pub fn with_zero(self) -> Self {
        let (lo, hi) = (self.view.lo(), self.view.hi());
        Self { view: ViewRange::new(lo.min(0.0), hi.max(0.0)), ..self }
    }

    /// With room at both ends: a part of its length.
    pub fn padded(self, part: f64) -> Self {
        Self { view: self.view.padded(self.scale, part), ..self }
    }

    /// The ticks that have room along a given number of cells, in the unit shown.
    pub fn ticks(&self, cells: u16, along: Along) -> Ticks {
        // Ticks are chosen in the unit shown; their cells are those of the values, because both ranges are the same.
        let view = self.view.on(self.scale);
        let shown = ViewRange::new(view.lo() * self.unit.factor, view.hi() * self.unit.factor);
        ticks::ticks(Mapping::new(self.scale, shown, cells), along)
    }

    /// The axis upward in rows, a little longer where that puts round numbers in the middle of rows, and its ticks.
    /// Lines across at these values keep clear of labels of other values where they can.
    pub fn on_rows(&self, rows: u16, lines: &[f64]) -> Option<(Mapping, Ticks)> {
        let factor = self.unit.factor;
        let view = self.view.on(self.scale);
        let shown = ViewRange::new(view.lo() * factor, view.hi() * factor);
        let lines: Vec<f64> = lines.iter().map(|line| line * factor).collect();
        let (shown, ticks) = ticks::on_rows(self.scale, shown, rows, &lines)?;
        let view = ViewRange::new(shown.lo() / factor, shown.hi() / factor);
        Some((Mapping::new(self.scale, view, rows), ticks))
    }

    /// Formats the unit in brackets, with the power of ten that is factored out of the labels.
    pub fn unit_text(&self, exponent: i32) -> String {
        let unit = &self.unit.name;
        match (exponent, unit.is_empty()) {
            (0, true) => String::new(),
            (0, false) => format!("[{unit}]"),
            (_, true) => format!("[1e{exponent}]"),
            (_, false) => format!("[1e{exponent} {unit}]"),
        }
    }

    /// Formats quantity and unit.
    pub fn text(&self, exponent: i32) -> String {
        self.after(&self.label, exponent)
    }

    /// A title of its values and their unit, unless the title begins with it: `% of rigid-mount depth`.
    pub fn after(&self, title: &str, exponent: i32) -> String {
        let has_unit = self.unit.name == "%" && title.starts_with('%') && exponent == 0;
        let unit = if has_unit { String::new() } else { self.unit_text(exponent) };
        spaced(title, &unit)
    }
}

/// Two texts with a blank between, where there are two.
pub fn spaced(a: &str, b: &str) -> String {
    let gap = if a.is_empty() || b.is_empty() { "" } else { " " };
    format!("{a}{gap}{b}")
}

/// A dotted line across the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark<'a> {
    /// Where, in the unit of its axis.
    pub at: f64,
    /// Meaning; may be empty.
    pub name: Cow<'a, str>,
    /// Short name for a terminal, a letter or a word; may be empty.
    pub tag: Cow<'a, str>,
}

impl<'a> Mark<'a> {
    /// A line with one name everywhere.
    pub fn new(at: f64, name: impl Into<Cow<'a, str>>) -> Self {
        let name = name.into();
        Self { at, tag: name.clone(), name }
    }

    /// With this letter or word in a terminal.
    #[must_use]
    pub fn tag(self, tag: impl Into<Cow<'a, str>>) -> Self {
        Self { tag: tag.into(), ..self }
    }
}

/// How a curve stands among the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Emphasis {
    /// Reference of the other curves: faint, at the bottom.
    Faint,
    /// Results that a newer computation will replace: faint, at the bottom, `(old)` in the legend.
    Stale,
    /// Curve in the order given.
    #[default]
    Normal,
    /// Drawn last, over the others.
    Selected,
}

/// A curve.
#[must_use]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve<'a> {
    /// The character it is drawn with in ASCII, and marked with otherwise. One cell wide.
    pub marker: char,
    /// Name in the legend; a curve with an empty name is omitted there.
    pub label: Cow<'a, str>,
    /// Points in the units of the axes' views, in drawing order; a non-finite number makes a gap.
    pub points: Cow<'a, [(f64, f64)]>,
    /// Index into the colours of curves.
    pub colour: usize,
    /// How it stands among the others.
    pub emphasis: Emphasis,
}

impl<'a> Curve<'a> {
    /// A line through points.
    pub fn new(
        marker: char,
        label: impl Into<Cow<'a, str>>,
        points: impl Into<Cow<'a, [(f64, f64)]>>,
    ) -> Self {
        Self { marker, label: label.into(), points: points.into(), ..Self::default() }
    }

    /// Borrows the curve without copying its points.
    pub fn borrowed(&self) -> Curve<'_> {
        Curve { label: Cow::Borrowed(&self.label), points: Cow::Borrowed(&self.points), ..*self }
    }

    /// In this colour.
    pub fn colour(self, colour: usize) -> Self {
        Self { colour, ..self }
    }

    /// With this emphasis.
    pub fn emphasis(self, emphasis: Emphasis) -> Self {
        Self { emphasis, ..self }
    }

    /// Points without a line between them, each drawn as its marker.
    pub fn points(
        marker: char,
        label: impl Into<Cow<'a, str>>,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let apart = |point| [point, (f64::NAN, f64::NAN)];
        Self::new(marker, label, points.into_iter().flat_map(apart).collect::<Vec<_>>())
    }

    /// Whether it has no line: each point has gaps beside it.
    pub fn is_dotted(&self) -> bool {
        let is_point = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
        !self.points.windows(2).any(|pair| pair.iter().all(is_point))
    }
}

/// The frame and title of a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Frame {
    /// A box with the title in its top line, the axis and its numbers inside.
    #[default]
    Boxed,
    /// Chart in a box of several.
    Stacked {
        /// Whether the chart is the first of its box.
        begins: bool,
        /// Lower line of the chart.
        below: Below,
    },
}

/// The lower line of a chart in a box of several. A line has the axis and its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Below {
    /// None: the next chart has the same axis.
    Nothing,
    /// A line across the box: another chart follows.
    Across,
    /// The line that closes the box.
    End,
}

/// Whether the curves are named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Legend {
    /// In the title line, or in a row above the plot where that is too short. Never over data.
    #[default]
    Shown,
    /// Not: another chart names them.
    Hidden,
}

/// A chart. Build it with [`Chart::new`] and set the rest: `Chart { crosshair: Some(t), ..Chart::new(title, x, y, curves) }`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart<'a> {
    /// Title; the unit of the left axis is appended.
    pub title: Cow<'a, str>,
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The left axis.
    pub y: Axis<'a>,
    /// The curves, later ones over earlier ones.
    pub curves: Vec<Curve<'a>>,
    /// Vertical lines under the curves.
    pub marks: Vec<Mark<'a>>,
    /// Horizontal lines under the curves, by the left axis.
    pub levels: Vec<Mark<'a>>,
    /// Where the crosshair stands, in the unit of the data.
    pub crosshair: Option<f64>,
    /// Frame and title of the chart.
    pub frame: Frame,
    /// Whether the curves are named.
    pub legend: Legend,
    /// Something short at the right of the title line of a stacked chart; omitted where it has no room.
    pub note: Cow<'a, str>,
    /// Least columns for the labels of the left axis.
    pub gutter: u16,
    /// Whether it has the keys.
    pub focused: bool,
}

impl<'a> Chart<'a> {
    /// A chart with curves and axes and nothing else.
    pub fn new(
        title: impl Into<Cow<'a, str>>,
        x: Axis<'a>,
        y: Axis<'a>,
        curves: Vec<Curve<'a>>,
    ) -> Self {
        Self { title: title.into(), x, y, curves, ..Self::default() }
    }
}
