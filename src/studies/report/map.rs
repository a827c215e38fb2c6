//! Maps as plain data: a value or a letter at every point of a grid, bands of equal values, a contour.

use std::borrow::Cow;

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
    pub contour: Option<(f64, Cow<'a, str>)>,
    /// Values with their texts, written where neighbouring values lie on both sides, those first that come first.
    pub labels: Vec<(f64, String)>,
    /// A point to be seen, and its letter.
    pub present: Option<((usize, usize), char)>,
    /// The meaning of the letters.
    pub marks: Vec<(char, String)>,
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
