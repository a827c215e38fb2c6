//! Charts as plain data: axes with units, curves, lines to read them by.

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

    /// The other scale.
    #[must_use]
    pub fn toggled(self) -> Self {
        match self {
            Self::Linear => Self::Log10,
            Self::Log10 => Self::Linear,
        }
    }
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures.
    pub label: String,
    /// The unit of the data; empty for a pure number.
    pub unit: String,
    /// How values are spread.
    pub scale: Scale,
    /// The least value shown.
    pub low: f64,
    /// The greatest value shown, above `low`.
    pub high: f64,
    /// The value by which the prefix of the unit is chosen.
    pub size: f64,
}

impl Axis {
    /// An axis over all of these values that have a place on it; `None` where there is none.
    pub fn over(
        label: &str,
        unit: &str,
        scale: Scale,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Self> {
        let (low, high) = values.into_iter().filter(|value| scale.shows(*value)).fold(
            None,
            |found: Option<(f64, f64)>, value| {
                let (low, high) = found.unwrap_or((value, value));
                Some((low.min(value), high.max(value)))
            },
        )?;
        let size = low.abs().max(high.abs());
        // An axis of one value is widened to be an axis at all.
        let room = if size > 0.0 { 0.05 * size } else { 1.0 };
        let is_narrow = high - low <= 1e-12 * size || size <= 0.0;
        let (low, high) = if is_narrow { (low - room, high + room) } else { (low, high) };
        let low = if scale == Scale::Log10 && low <= 0.0 { 1e-6 * high } else { low };
        Some(Self { label: label.to_owned(), unit: unit.to_owned(), scale, low, high, size })
    }

    /// With zero on it.
    #[must_use]
    pub fn with_zero(self) -> Self {
        Self { low: self.low.min(0.0), high: self.high.max(0.0), ..self }
    }

    /// With room at both ends: a part of its length.
    #[must_use]
    pub fn padded(self, part: f64) -> Self {
        if self.scale == Scale::Log10 {
            let room = (self.high / self.low).powf(part);
            return Self { low: self.low / room, high: self.high * room, ..self };
        }
        let room = part * (self.high - self.low);
        Self { low: self.low - room, high: self.high + room, ..self }
    }
}

/// A curve: points, with a gap at each that is not finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name in the legend; may be empty where it is the only one.
    pub name: String,
    /// Its points, in the units of the axes.
    pub points: Vec<(f64, f64)>,
    /// Its letter in a terminal.
    pub letter: char,
    /// Dots instead of a line.
    pub is_dotted: bool,
}

impl Curve {
    /// A line without points yet.
    pub fn new(name: &str, letter: char) -> Self {
        Self { name: name.to_owned(), points: Vec::new(), letter, is_dotted: false }
    }
}

/// A line across the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Where, in the unit of its axis.
    pub at: f64,
    /// What it means.
    pub name: String,
    /// The same in a letter or a word, for a terminal.
    pub tag: String,
}

impl Line {
    /// A line with one name everywhere.
    pub fn new(at: f64, name: &str) -> Self {
        Self { at, name: name.to_owned(), tag: name.to_owned() }
    }
}

/// A chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Vertical lines.
    pub marks: Vec<Line>,
    /// Horizontal lines.
    pub levels: Vec<Line>,
}

impl Chart {
    /// A chart of one curve.
    pub fn of(title: &str, x: Axis, y: Axis, points: Vec<(f64, f64)>) -> Self {
        let curves = vec![Curve { points, ..Curve::new("", '*') }];
        Self { title: title.to_owned(), x, y, curves, marks: Vec::new(), levels: Vec::new() }
    }
}
