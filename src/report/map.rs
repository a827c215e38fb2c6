//! Maps as plain data: a value at every point of a grid, bands of equal values, a contour.

use crate::report::chart::Axis;

/// What is at a point of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A value.
    Value(f64),
    /// No value, and the letter that says why.
    Mark(char),
    /// Not computed.
    Empty,
}

/// A map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// What it shows.
    pub title: String,
    /// The unit of the values; empty for pure numbers.
    pub unit: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Points along them.
    pub counts: (usize, usize),
    /// The points, from the lower left one; the horizontal axis runs fastest.
    pub cells: Vec<Cell>,
    /// A contour at this value, and what it means.
    pub contour: Option<(f64, String)>,
    /// What the letters mean.
    pub marks: Vec<(char, String)>,
}

impl Map {
    /// The point in a column and a row from the lower left one.
    pub fn cell(&self, column: usize, row: usize) -> Cell {
        self.cells.get(row * self.counts.0 + column).copied().unwrap_or(Cell::Empty)
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.cells.iter().filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value).filter(|value| value.is_finite()),
            Cell::Mark(_) | Cell::Empty => None,
        })
    }
}
