//! Maps as plain data: a value or a letter at every point of a grid, bands of equal values, a contour.

use std::borrow::Cow;
use std::fmt;

use crate::report::chart::Axis;
use crate::report::chart::levels::Levels;

/// How a letter stands out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Little: there is just no value.
    Faint,
    /// As other text.
    Plain,
    /// As a warning.
    Warning,
    /// As an error.
    Error,
}

/// The content of a point of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A value.
    Value(f64),
    /// No value, and the letter that says why.
    Mark(char, Tone),
    /// Not computed.
    Empty,
}

/// Letter of a map, and what it means.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct MapMark {
    /// The letter; a blank where the point is left blank.
    pub letter: char,
    /// Meaning in a few words.
    pub label: Cow<'static, str>,
    /// Rest of the meaning, from its punctuation mark on, for the printed page; may be empty.
    pub more: &'static str,
}

impl MapMark {
    /// Creates a mark whose label says all.
    pub fn new(letter: char, label: impl Into<Cow<'static, str>>) -> Self {
        Self { letter, label: label.into(), more: "" }
    }

    /// The whole meaning.
    pub fn meaning(&self) -> String {
        format!("{}{}", self.label, self.more)
    }
}

impl fmt::Display for MapMark {
    /// Formats letter and whole meaning.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A blank is named.
        let blank = if self.letter == ' ' { "blank: " } else { "" };
        write!(f, "{} {blank}{}", self.letter, self.meaning())
    }
}

/// A map. Points are spread evenly over both axes, from their lower to their upper bound.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map<'a> {
    /// Title of the map.
    pub title: Cow<'a, str>,
    /// The unit of the values; empty for pure numbers.
    pub unit: &'static str,
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The vertical axis.
    pub y: Axis<'a>,
    /// Points along them.
    pub counts: (usize, usize),
    /// The points, from the lower left one; the horizontal axis runs fastest.
    pub cells: Vec<Cell>,
    /// The bands of the values; `None` where there is no value.
    pub levels: Option<Levels>,
    /// A contour at this value, and what it means.
    pub contour: Option<(f64, MapMark)>,
    /// Values with their texts, written where neighbouring values lie on both sides, those first that come first.
    pub labels: Vec<(f64, String)>,
    /// A point to be seen, and its letter.
    pub present: Option<((usize, usize), char)>,
    /// The meaning of the letters.
    pub marks: Vec<MapMark>,
    /// The point under the cursor.
    pub cursor: Option<(usize, usize)>,
    /// Whether it has the keys.
    pub focused: bool,
}

impl<'a> Map<'a> {
    /// A map of points counted from the lower left one, with these bands of values.
    pub fn new(
        title: impl Into<Cow<'a, str>>,
        (x, y): (Axis<'a>, Axis<'a>),
        counts: (usize, usize),
        levels: Option<Levels>,
        cell: impl Fn(usize, usize) -> Cell,
    ) -> Self {
        let points = (0..counts.1).flat_map(|row| (0..counts.0).map(move |column| (column, row)));
        let cells = points.map(|(column, row)| cell(column, row)).collect();
        Self { title: title.into(), x, y, counts, cells, levels, ..Self::default() }
    }

    /// The point in a column and a row from the lower left one.
    pub fn cell(&self, column: usize, row: usize) -> Cell {
        self.cells.get(row * self.counts.0 + column).copied().unwrap_or(Cell::Empty)
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.cells.iter().filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value).filter(|value| value.is_finite()),
            Cell::Mark(..) | Cell::Empty => None,
        })
    }
}
