//! A curve onto the dots: first, lowest, highest and last point of each column of dots, joined by lines.
//!
//! Costs O(points + dots) and allocates nothing for a point; a spike of one sample among a hundred thousand is still drawn. A
//! point without a place (not a number, infinite, not positive on a logarithmic axis) is a gap.

use super::Mapping;
use super::canvas::Canvas;
use super::{Curve, Scale};
use crate::report::chart::scale::whole_below;

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

/// Draws a curve and counts the points a logarithmic axis had to leave out.
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

/// How many points have finite values but no place on a logarithmic axis.
pub(super) fn left_out(curve: &Curve<'_>, x_scale: Scale, y_scale: Scale) -> usize {
    if x_scale == Scale::Linear && y_scale == Scale::Linear {
        return 0;
    }
    let finite = curve.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite());
    finite.filter(|(x, y)| !(x_scale.shows(*x) && y_scale.shows(*y))).count()
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
