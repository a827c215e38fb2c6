//! Maps as plain data: a value or a letter at every point of a grid, bands of values, and a contour.

use std::borrow::Cow;
use std::fmt;

use crate::report::chart::Axis;
use crate::report::chart::levels::Levels;

/// Emphasis of a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Faint: the value does not exist.
    Faint,
    /// Plain text.
    Plain,
    /// Warning.
    Warning,
    /// Error.
    Error,
}

/// Content of a point of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// Value at the point.
    Value(f64),
    /// Letter for the reason why there is no value.
    Mark(char, Tone),
    /// Point not computed.
    Empty,
}

/// Letter of a map with its meaning.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct MapMark {
    /// Letter; a blank for points left blank.
    pub letter: char,
    /// Meaning in a few words.
    pub label: Cow<'static, str>,
    /// Rest of the meaning for the printed page, starting with its punctuation mark; may be empty.
    pub more: &'static str,
}

impl MapMark {
    /// Creates a mark with a complete label.
    pub fn new(letter: char, label: impl Into<Cow<'static, str>>) -> Self {
        Self { letter, label: label.into(), more: "" }
    }

    /// Returns the full meaning.
    pub fn meaning(&self) -> String {
        format!("{}{}", self.label, self.more)
    }
}

impl fmt::Display for MapMark {
    /// Writes the letter and the full meaning.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Write a blank as a word.
        let blank = if self.letter == ' ' { "blank: " } else { "" };
        write!(f, "{} {blank}{}", self.letter, self.meaning())
    }
}

/// Map on a regular grid. Points are evenly spaced along both axes, from lower to upper bound.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map<'a> {
    /// Title of the map.
    pub title: Cow<'a, str>,
    /// Unit of the values; empty for pure numbers.
    pub unit: &'static str,
    /// Horizontal axis.
    pub x: Axis<'a>,
    /// Vertical axis.
    pub y: Axis<'a>,
    /// Numbers of points along the two axes.
    pub counts: (usize, usize),
    /// Points, starting at the lower left; the horizontal axis varies fastest.
    pub cells: Vec<Cell>,
    /// Bands of the values; `None` if there are none.
    pub levels: Option<Levels>,
    /// Value of the contour, and its meaning.
    pub contour: Option<(f64, MapMark)>,
    /// Values with texts, written where neighbouring values lie on both sides; earlier entries have priority.
    pub labels: Vec<(f64, String)>,
    /// Highlighted point, and its letter.
    pub present: Option<((usize, usize), char)>,
    /// Meanings of the letters.
    pub marks: Vec<MapMark>,
    /// Point under the cursor.
    pub cursor: Option<(usize, usize)>,
    /// Whether the map has the keyboard focus.
    pub focused: bool,
}

impl<'a> Map<'a> {
    /// Creates a map from points, starting at the lower left, with these bands of values.
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

    /// Returns the point in a column and row, counted from the lower left.
    pub fn cell(&self, column: usize, row: usize) -> Cell {
        self.cells.get(row * self.counts.0 + column).copied().unwrap_or(Cell::Empty)
    }

    /// Iterates over all values.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.cells.iter().filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value).filter(|value| value.is_finite()),
            Cell::Mark(..) | Cell::Empty => None,
        })
    }
}
