//! The dots of a plot: one, two or eight to a cell, each cell remembering whose dots it has.
//!
//! Coordinates run in dots, x to the right and y upward from the lower left corner of the lower left dot.

use crate::report::chart::scale::whole_below;
use crate::report::chart::{Curve, Emphasis, Mapping};
use crate::tui::theme::{GlyphSet, Role};

/// The bits of a braille character, in rows of two dots: 1 4 / 2 5 / 3 6 / 7 8.
const BRAILLE: [u8; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];

/// Characters that distinguish curves, the current run's first; none is used by axes, event lines or the crosshair alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

/// The role that colours it.
pub(super) fn role(curve: &Curve<'_>) -> Role {
    match curve.emphasis {
        Emphasis::Faint | Emphasis::Stale => Role::Dim,
        Emphasis::Normal | Emphasis::Selected => Role::Curve(curve.colour),
    }
}

pub(super) struct Canvas {
    glyphs: GlyphSet,
    /// Cells across and down.
    cells: (usize, usize),
    /// Dots of each cell, as bits: those of a braille character, or one for each row of dots from the top.
    dots: Vec<u8>,
    /// Who drew last in each cell; meaningless where there are no dots.
    owners: Vec<usize>,
}

impl Canvas {
    pub(super) fn new(glyphs: GlyphSet, width: u16, height: u16) -> Self {
        let cells = (usize::from(width), usize::from(height));
        Self { glyphs, cells, dots: vec![0; cells.0 * cells.1], owners: vec![0; cells.0 * cells.1] }
    }

    /// Dots across and upward.
    pub(super) fn size(&self) -> (usize, usize) {
        let (across, down) = self.glyphs.dots();
        (self.cells.0 * usize::from(across), self.cells.1 * usize::from(down))
    }

    /// A position in cells from the middle of the first one, in dots.
    pub(super) fn in_dots(&self, x: f64, y: f64) -> (f64, f64) {
        let (across, down) = self.glyphs.dots();
        ((x + 0.5) * f64::from(across), (y + 0.5) * f64::from(down))
    }

    /// The middle of what the owner who drew last has in a column of cells: a row of cells from the top.
    pub(super) fn middle(&self, column: usize, owner: usize) -> Option<usize> {
        let is_own = |row: &usize| self.cell(column, *row).is_some_and(|cell| cell.0 == owner);
        let mut rows = (0..self.cells.1).filter(is_own);
        let top = rows.next()?;
        Some(usize::midpoint(top, rows.next_back().unwrap_or(top)))
    }

    /// The owner of a cell (from the top) and its dots, if it has any.
    pub(super) fn cell(&self, column: usize, row: usize) -> Option<(usize, char)> {
        let index = row * self.cells.0 + column;
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

    /// Sets the dot at whole coordinates; outside the grid nothing happens.
    pub(super) fn dot(&mut self, x: usize, y: usize, owner: usize) {
        let (width, height) = self.size();
        if x >= width || y >= height {
            return;
        }
        let (across, down) = self.glyphs.dots();
        let (across, down) = (usize::from(across), usize::from(down));
        let from_top = height - 1 - y;
        let index = from_top / down * self.cells.0 + x / across;
        let place = from_top % down * across + x % across;
        self.dots[index] |=
            if self.glyphs == GlyphSet::Braille { BRAILLE[place] } else { 1 << place };
        self.owners[index] = owner;
    }

    /// Fills a column of dots from one height to another, as far as it lies in the grid.
    pub(super) fn span(&mut self, x: usize, low: f64, high: f64, owner: usize) {
        let height = self.size().1;
        let top = height as f64 - 0.5;
        if low >= height as f64 || high < 0.0 {
            return;
        }
        let ends = (whole_below(low.max(0.0), height), whole_below(high.min(top), height));
        if let (Some(low), Some(high)) = ends {
            for y in low..=high {
                self.dot(x, y, owner);
            }
        }
    }

    /// A straight line, as far as it lies in the grid.
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
        if let (Some(from), Some(to)) = (place(from), place(to)) {
            self.walk(from, to, owner);
        }
    }

    /// Bresenham's line between two dots, both drawn: one dot a column where it is flat, one a row where it is steep.
    fn walk(&mut self, from: (usize, usize), to: (usize, usize), owner: usize) {
        let (dx, dy) = (from.0.abs_diff(to.0), from.1.abs_diff(to.1));
        let steps = dx.max(dy);
        for step in 0..=steps {
            // Rounded to the nearest dot, halves away from the start.
            let part = |from: usize, to: usize, length: usize| {
                let by = (step * length + steps / 2).checked_div(steps).unwrap_or(0);
                if to >= from { from + by } else { from - by }
            };
            let (x, y) = (part(from.0, to.0, dx), part(from.1, to.1, dy));
            self.dot(x, y, owner);
        }
    }
}

/// The part of a line inside `0..=size` (Liang and Barsky 1984), if any.
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

/// The points of one column of dots.
#[derive(Clone, Copy)]
struct Column {
    index: usize,
    first: (f64, f64),
    last: (f64, f64),
    lowest: f64,
    highest: f64,
}

impl Column {
    fn new(index: usize, point: (f64, f64)) -> Self {
        Self { index, first: point, last: point, lowest: point.1, highest: point.1 }
    }

    fn add(&mut self, point: (f64, f64)) {
        self.last = point;
        self.lowest = self.lowest.min(point.1);
        self.highest = self.highest.max(point.1);
    }

    /// Where the curve enters and leaves the column. A curve that only passes from one row of dots to the next gets one dot,
    /// or every step of a gentle slope would be two dots thick.
    fn ends(&self) -> ((f64, f64), (f64, f64)) {
        let (low, high) = (self.first.1.min(self.last.1), self.first.1.max(self.last.1));
        let passes = self.lowest >= low && self.highest <= high;
        if passes && (high.floor() - low.floor()) <= 1.0 {
            let middle = (
                f64::midpoint(self.first.0, self.last.0),
                f64::midpoint(self.first.1, self.last.1),
            );
            (middle, middle)
        } else {
            (self.first, self.last)
        }
    }
}

/// Draws a curve; its line breaks at points that have no place on the axes.
pub(super) fn trace(
    curve: &Curve<'_>,
    owner: usize,
    maps: (Mapping, Mapping),
    canvas: &mut Canvas,
) {
    let mut pen = Pen { canvas, owner, previous: None, column: None };
    let width = pen.canvas.size().0;
    for (x, y) in curve.points.iter().copied() {
        if let (Some(x), Some(y)) = (maps.0.position(x), maps.1.position(y)) {
            let point = pen.canvas.in_dots(x, y);
            pen.point(point, whole_below(point.0, width));
        } else {
            pen.lift();
        }
    }
    pen.lift();
}

struct Pen<'a> {
    canvas: &'a mut Canvas,
    owner: usize,
    /// Where the line has come to.
    previous: Option<(f64, f64)>,
    /// The column being gathered.
    column: Option<Column>,
}

impl Pen<'_> {
    fn point(&mut self, point: (f64, f64), column: Option<usize>) {
        match (&mut self.column, column) {
            (Some(gathered), Some(index)) if gathered.index == index => gathered.add(point),
            (_, Some(index)) => {
                self.flush();
                self.column = Some(Column::new(index, point));
            }
            (_, None) => {
                self.flush();
                self.line_to(point);
            }
        }
    }

    /// Ends the line: the next point begins a new one.
    fn lift(&mut self) {
        self.flush();
        self.previous = None;
    }

    fn flush(&mut self) {
        if let Some(column) = self.column.take() {
            let (enter, leave) = column.ends();
            self.line_to(enter);
            let (low, high) =
                if enter == leave { (enter.1, enter.1) } else { (column.lowest, column.highest) };
            self.canvas.span(column.index, low, high, self.owner);
            self.previous = Some(leave);
        }
    }

    fn line_to(&mut self, point: (f64, f64)) {
        if let Some(previous) = self.previous {
            self.canvas.line(previous, point, self.owner);
        }
        self.previous = Some(point);
    }
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
