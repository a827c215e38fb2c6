//! Dots of a plot: one, two or eight per cell, each cell with the owner of its dots.
//!
//! Coordinates are in dots from the lower left corner of the lower left dot, x to the right and y upward.

use crate::tui::theme::{GlyphSet, Role};
use cmra_studies::report::chart::scale::whole_below;
use cmra_studies::report::chart::{Curve, Emphasis, Mapping};

/// Bits of a braille character, in rows of two dots: 1 4 / 2 5 / 3 6 / 7 8.
const BRAILLE: [u8; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];

/// Markers of curves, the current run's first. Axes, event lines and the crosshair use none of them alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

/// Returns the role that determines the colour of a curve.
pub(super) fn role(curve: &Curve<'_>) -> Role {
    match curve.emphasis {
        Emphasis::Faint | Emphasis::Stale => Role::Dim,
        Emphasis::Normal | Emphasis::Selected => Role::Curve(curve.colour),
    }
}

/// Position in dots.
type Place = (f64, f64);

pub(super) struct Canvas {
    glyphs: GlyphSet,
    /// Number of columns and rows of cells.
    cells: (u16, u16),
    /// Dots of each cell, as bits: those of a braille character, or one for each row of dots from the top.
    dots: Vec<u8>,
    /// Owner of the last dot in each cell; meaningless for cells without dots.
    owners: Vec<usize>,
}

impl Canvas {
    pub(super) fn new(glyphs: GlyphSet, width: u16, height: u16) -> Self {
        let count = usize::from(width) * usize::from(height);
        Self { glyphs, cells: (width, height), dots: vec![0; count], owners: vec![0; count] }
    }

    /// Returns the number of dots, horizontally and vertically.
    pub(super) fn size(&self) -> (usize, usize) {
        let (across, down) = self.glyphs.dots();
        let size = |cells: u16, dots: u16| usize::from(cells) * usize::from(dots);
        (size(self.cells.0, across), size(self.cells.1, down))
    }

    /// Converts a position in cells from the centre of the first one to dots.
    pub(super) fn in_dots(&self, x: f64, y: f64) -> (f64, f64) {
        let (across, down) = self.glyphs.dots();
        ((x + 0.5) * f64::from(across), (y + 0.5) * f64::from(down))
    }

    /// Returns the middle row, from the top, of the cells that an owner has in a column.
    pub(super) fn middle(&self, column: u16, owner: usize) -> Option<u16> {
        let is_own = |row: &u16| self.cell(column, *row).is_some_and(|cell| cell.0 == owner);
        let mut rows = (0..self.cells.1).filter(is_own);
        let top = rows.next()?;
        Some(u16::midpoint(top, rows.next_back().unwrap_or(top)))
    }

    /// Returns the owner and the character of a cell (row from the top); `None` for an empty cell.
    pub(super) fn cell(&self, column: u16, row: u16) -> Option<(usize, char)> {
        let index = usize::from(row) * usize::from(self.cells.0) + usize::from(column);
        let dots = *self.dots.get(index)?;
        (dots != 0).then(|| (self.owners[index], self.character(dots)))
    }

    fn character(&self, dots: u8) -> char {
        match self.glyphs {
            GlyphSet::Ascii => '*',
            GlyphSet::Block => match dots {
                0b01 => '▀',
                0b10 => '▄',
                _ => '█',
            },
            GlyphSet::Braille => char::from_u32(0x2800 + u32::from(dots)).unwrap_or(' '),
        }
    }

    /// Sets the dot at integer coordinates; ignores dots outside the grid.
    pub(super) fn dot(&mut self, x: usize, y: usize, owner: usize) {
        let (width, height) = self.size();
        if x >= width || y >= height {
            return;
        }
        let (across, down) = self.glyphs.dots();
        let (across, down) = (usize::from(across), usize::from(down));
        let from_top = height - 1 - y;
        let index = from_top / down * usize::from(self.cells.0) + x / across;
        let place = from_top % down * across + x % across;
        self.dots[index] |=
            if self.glyphs == GlyphSet::Braille { BRAILLE[place] } else { 1 << place };
        self.owners[index] = owner;
    }

    /// Draws a straight line, clipped to the grid.
    pub(super) fn line(&mut self, from: (f64, f64), to: (f64, f64), owner: usize) {
        let (width, height) = self.size();
        let Some((from, to)) = clip(from, to, (width as f64, height as f64)) else {
            return;
        };
        let place = |(x, y): (f64, f64)| {
            let x = whole_below(x.clamp(0.0, width as f64 - 0.5), width)?;
            let y = whole_below(y.clamp(0.0, height as f64 - 0.5), height)?;
            Some((x, y))
        };
        let Some((from, to)) = place(from).zip(place(to)) else { return };
        // Bresenham's line including both ends: one dot per column if flat, one dot per row if steep.
        let (dx, dy) = (from.0.abs_diff(to.0), from.1.abs_diff(to.1));
        let steps = dx.max(dy);
        for step in 0..=steps {
            // Round to the nearest dot, halves away from the start.
            let part = |from: usize, to: usize, length: usize| {
                let by = (step * length + steps / 2).checked_div(steps).unwrap_or(0);
                if to >= from { from + by } else { from - by }
            };
            let (x, y) = (part(from.0, to.0, dx), part(from.1, to.1, dy));
            self.dot(x, y, owner);
        }
    }
}

/// Clips a line to `0..=size` (Liang and Barsky 1984); `None` if it lies outside.
fn clip(from: (f64, f64), to: (f64, f64), size: (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let edges = [(-dx, from.0), (dx, size.0 - from.0), (-dy, from.1), (dy, size.1 - from.1)];
    for (toward, distance) in edges {
        if toward == 0.0 {
            if distance < 0.0 {
                return None;
            }
            continue;
        }
        let at = distance / toward;
        if toward < 0.0 {
            enter = enter.max(at);
        } else {
            leave = leave.min(at);
        }
    }
    let point = |t: f64| (from.0 + t * dx, from.1 + t * dy);
    (enter <= leave).then(|| (point(enter), point(leave)))
}

/// Draws a curve; breaks its line at points that the axes cannot represent.
pub(super) fn trace(
    curve: &Curve<'_>,
    owner: usize,
    maps: (Mapping, Mapping),
    canvas: &mut Canvas,
) {
    let place = |(x, y): &(f64, f64)| {
        let (x, y) = maps.0.position(*x).zip(maps.1.position(*y))?;
        Some(canvas.in_dots(x, y))
    };
    let places: Vec<Option<Place>> = curve.points.iter().map(place).collect();
    let width = canvas.size().0;
    let column = |place: &Place| whole_below(place.0, width);
    for line in places.split(Option::is_none) {
        let line: Vec<Place> = line.iter().flatten().copied().collect();
        let mut previous = None;
        for points in line.chunk_by(|a, b| column(a).is_some() && column(a) == column(b)) {
            let (enter, leave, (low, high)) = through(points);
            if let Some(previous) = previous {
                canvas.line(previous, enter, owner);
            }
            if let Some(column) = column(&enter) {
                let middle = column as f64 + 0.5;
                canvas.line((middle, low), (middle, high), owner);
            }
            previous = Some(leave);
        }
    }
}

/// Returns where a curve enters and leaves a column of dots with these points, and its vertical range there. A curve that passes from one
/// row of dots to the next gets a single dot, because two would thicken every step of a gentle slope.
fn through(points: &[Place]) -> (Place, Place, (f64, f64)) {
    let (first, last) = (points[0], points[points.len() - 1]);
    let low = points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|point| point.1).fold(f64::NEG_INFINITY, f64::max);
    let passes = low >= first.1.min(last.1) && high <= first.1.max(last.1);
    if passes && high.floor() - low.floor() <= 1.0 {
        let middle = (f64::midpoint(first.0, last.0), f64::midpoint(first.1, last.1));
        return (middle, middle, (middle.1, middle.1));
    }
    (first, last, (low, high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(canvas: &Canvas) -> Vec<String> {
        let (width, height) = canvas.cells;
        let row = |y| (0..width).map(move |x| canvas.cell(x, y).map_or(' ', |(_, c)| c));
        (0..height).map(|y| row(y).collect()).collect()
    }

    #[test]
    fn lines_are_cut_at_the_edges_however_long_they_are() {
        let mut canvas = Canvas::new(GlyphSet::Ascii, 4, 3);
        canvas.line((-1e9, 1.5), (1e9, 1.5), 0);
        assert_eq!(picture(&canvas), ["    ", "****", "    "]);
        canvas.line((-5.0, -5.0), (-1.0, 9.0), 0);
        assert_eq!(picture(&canvas), ["    ", "****", "    "]);
    }

    #[test]
    fn every_braille_dot_is_where_unicode_has_it() {
        // Unicode 15, block "Braille Patterns": dots 1 2 3 7 go down the left side, 4 5 6 8 down the right.
        let expected = ["⠁", "⠂", "⠄", "⡀", "⠈", "⠐", "⠠", "⢀"];
        for (index, character) in expected.iter().enumerate() {
            let mut canvas = Canvas::new(GlyphSet::Braille, 1, 1);
            canvas.dot(index / 4, 3 - index % 4, 0);
            assert_eq!(picture(&canvas), [*character]);
        }
    }
}
