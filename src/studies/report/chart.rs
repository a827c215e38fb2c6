//! Charts as plain data: axes with units, curves, reference lines and display options. The terminal and SVG output draw these charts with
//! the ticks and bands computed here.

use std::borrow::Cow;

use cmra_engine::model::units::Prefix;

pub mod levels;
pub mod scale;
pub mod ticks;

pub use scale::{Mapping, Scale, ViewRange};
use ticks::{Along, Ticks};

/// Unit of displayed numbers: value times `factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit<'a> {
    /// Displayed number over value; finite and > 0.
    pub factor: f64,
    /// Name of the displayed unit; empty for a pure number.
    pub name: Cow<'a, str>,
}

impl Default for Unit<'_> {
    /// Returns the unit of a pure number.
    fn default() -> Self {
        Self::new("")
    }
}

impl<'a> Unit<'a> {
    /// Creates a unit without a prefix.
    pub fn new(name: impl Into<Cow<'a, str>>) -> Self {
        Self { factor: 1.0, name: name.into() }
    }

    /// Chooses the prefix for which a number of this size is in [1, 1000): mm for 0.0071 m. Units without prefixes (none, `kg`, `deg`, `%`,
    /// powers such as `m^2`) are unchanged.
    pub fn with_prefix(size: f64, unit: &'a str) -> Self {
        let prefix = Prefix::for_unit(size, unit);
        Self { factor: prefix.in_one, name: format!("{}{unit}", prefix.letter).into() }
    }
}

/// Axis of a chart.
#[must_use]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis<'a> {
    /// Quantity of the axis: `t`. In a terminal the chart's title names the quantity of the left axis.
    pub label: Cow<'a, str>,
    /// Unit of displayed numbers. Points, view and lines use the unit of the data.
    pub unit: Unit<'a>,
    /// Scale of the axis.
    pub scale: Scale,
    /// Displayed range, in the unit of the data.
    pub view: ViewRange,
}

impl<'a> Axis<'a> {
    /// Creates a linear axis that displays numbers without a unit.
    pub fn new(label: impl Into<Cow<'a, str>>, view: ViewRange) -> Self {
        Self { label: label.into(), view, ..Self::default() }
    }

    /// Creates an axis over all values that the scale can represent; `None` if there are none.
    pub fn over(
        label: impl Into<Cow<'a, str>>,
        unit: &'a str,
        scale: Scale,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Self> {
        let view = ViewRange::from_values(scale, values)?;
        Some(Self::new(label, view).scale(scale).unit(Unit::with_prefix(view.size(), unit)))
    }

    /// Creates a linear axis with a margin beyond the values.
    pub fn fitted(
        label: impl Into<Cow<'a, str>>,
        unit: &'a str,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Self> {
        Some(Self::over(label, unit, Scale::Linear, values)?.padded(0.05))
    }

    /// Sets the unit of displayed numbers.
    pub fn unit(self, unit: Unit<'a>) -> Self {
        Self { unit, ..self }
    }

    /// Sets the scale.
    pub fn scale(self, scale: Scale) -> Self {
        Self { scale, ..self }
    }

    /// Extends the range to include zero.
    pub fn with_zero(self) -> Self {
        let (lo, hi) = (self.view.lo(), self.view.hi());
        Self { view: ViewRange::new(lo.min(0.0), hi.max(0.0)), ..self }
    }

    /// Extends the range at both ends by a fraction of its length.
    pub fn padded(self, part: f64) -> Self {
        Self { view: self.view.padded(self.scale, part), ..self }
    }

    /// Returns the ticks that fit along a number of cells, in the displayed unit.
    pub fn ticks(&self, cells: u16, along: Along) -> Ticks {
        // Ticks are chosen in the displayed unit. Their cells equal those of the values, because both ranges are the same.
        let view = self.view.on(self.scale);
        let shown = ViewRange::new(view.lo() * self.unit.factor, view.hi() * self.unit.factor);
        ticks::ticks(Mapping::new(self.scale, shown, cells), along)
    }

    /// Returns the vertical axis in rows and its ticks. Extends the range if that centres round numbers on rows. Labels avoid the level
    /// lines at `lines` if possible.
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

    /// Appends the unit to a title, unless the title begins with it: `% of rigid-mount depth`.
    pub fn after(&self, title: &str, exponent: i32) -> String {
        let has_unit = self.unit.name == "%" && title.starts_with('%') && exponent == 0;
        let unit = if has_unit { String::new() } else { self.unit_text(exponent) };
        spaced(title, &unit)
    }
}

/// Returns the first of two values without its unit if the second has the same: `4.27` of `4.27 mm` beside `6.49 mm`.
pub fn without_common_unit(first: String, second: &str) -> String {
    match (first.split_once(' '), second.split_once(' ')) {
        (Some((number, unit)), Some((_, other))) if unit == other => number.to_owned(),
        _ => first,
    }
}

/// Joins two texts with a blank; omits the blank if one is empty.
pub fn spaced(a: &str, b: &str) -> String {
    let gap = if a.is_empty() || b.is_empty() { "" } else { " " };
    format!("{a}{gap}{b}")
}

/// Dotted reference line across the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark<'a> {
    /// Position, in the unit of its axis.
    pub at: f64,
    /// Meaning; may be empty.
    pub name: Cow<'a, str>,
    /// Short name for a terminal, a letter or a word; may be empty.
    pub tag: Cow<'a, str>,
}

impl<'a> Mark<'a> {
    /// Creates a line with the same name everywhere.
    pub fn new(at: f64, name: impl Into<Cow<'a, str>>) -> Self {
        let name = name.into();
        Self { at, tag: name.clone(), name }
    }

    /// Sets the short name for a terminal.
    #[must_use]
    pub fn tag(self, tag: impl Into<Cow<'a, str>>) -> Self {
        Self { tag: tag.into(), ..self }
    }
}

/// Emphasis of a curve relative to the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Emphasis {
    /// Reference for the other curves: faint, drawn first.
    Faint,
    /// Outdated results of a running computation: faint, drawn first, marked `(old)` in the legend.
    Stale,
    /// Normal curve, drawn in the given order.
    #[default]
    Normal,
    /// Selected curve, drawn last.
    Selected,
}

/// Curve of a chart.
#[must_use]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve<'a> {
    /// Character of the curve in ASCII charts, and its marker in others. One cell wide.
    pub marker: char,
    /// Name in the legend; a curve with an empty name is omitted there.
    pub label: Cow<'a, str>,
    /// Points in the units of the axes' views, in drawing order; a non-finite number makes a gap.
    pub points: Cow<'a, [(f64, f64)]>,
    /// Index into the palette of curves.
    pub colour: usize,
    /// Emphasis relative to the other curves.
    pub emphasis: Emphasis,
}

impl<'a> Curve<'a> {
    /// Creates a line through points.
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

    /// Sets the colour.
    pub fn colour(self, colour: usize) -> Self {
        Self { colour, ..self }
    }

    /// Sets the emphasis.
    pub fn emphasis(self, emphasis: Emphasis) -> Self {
        Self { emphasis, ..self }
    }

    /// Creates a curve of separate points, each drawn as its marker.
    pub fn points(
        marker: char,
        label: impl Into<Cow<'a, str>>,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let apart = |point| [point, (f64::NAN, f64::NAN)];
        Self::new(marker, label, points.into_iter().flat_map(apart).collect::<Vec<_>>())
    }

    /// Returns `true` if the curve has no line: each point is enclosed by gaps.
    pub fn is_dotted(&self) -> bool {
        let is_point = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
        !self.points.windows(2).any(|pair| pair.iter().all(is_point))
    }
}

/// Frame and title of a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Frame {
    /// Box with the title in its top line; axes and labels inside.
    #[default]
    Boxed,
    /// Chart that shares a box with others.
    Stacked {
        /// Whether the chart is the first of its box.
        begins: bool,
        /// Lower border of the chart.
        below: Below,
    },
}

/// Lower border of a chart that shares a box. The axis and its labels are on this line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Below {
    /// No border: the next chart has the same axis.
    Nothing,
    /// Line across the box, followed by another chart.
    Across,
    /// Lower line of the box.
    End,
}

/// Visibility of the legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Legend {
    /// In the title line, or in a row above the plot if the title line is too short. Never over data.
    #[default]
    Shown,
    /// No legend; another chart names the curves.
    Hidden,
}

/// Chart. Create it with [`Chart::new`] and set further fields: `Chart { crosshair: Some(t), ..Chart::new(title, x, y, curves) }`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart<'a> {
    /// Title; the unit of the left axis is appended.
    pub title: Cow<'a, str>,
    /// Horizontal axis.
    pub x: Axis<'a>,
    /// Left axis.
    pub y: Axis<'a>,
    /// Curves; later ones are drawn over earlier ones.
    pub curves: Vec<Curve<'a>>,
    /// Vertical lines, drawn below the curves.
    pub marks: Vec<Mark<'a>>,
    /// Horizontal lines at values of the left axis, drawn below the curves.
    pub levels: Vec<Mark<'a>>,
    /// Position of the crosshair, in the unit of the data.
    pub crosshair: Option<f64>,
    /// Frame and title of the chart.
    pub frame: Frame,
    /// Visibility of the legend.
    pub legend: Legend,
    /// Short note at the right of the title line of a stacked chart; omitted if it does not fit.
    pub note: Cow<'a, str>,
    /// Minimum number of columns for the labels of the left axis.
    pub gutter: u16,
    /// Whether the chart has the keyboard focus.
    pub focused: bool,
}

impl<'a> Chart<'a> {
    /// Creates a chart with curves and axes only.
    pub fn new(
        title: impl Into<Cow<'a, str>>,
        x: Axis<'a>,
        y: Axis<'a>,
        curves: Vec<Curve<'a>>,
    ) -> Self {
        Self { title: title.into(), x, y, curves, ..Self::default() }
    }
}
