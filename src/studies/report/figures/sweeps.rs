//! Pictures of a sweep: a curve for each output over one axis, or a map over two.

use crate::report::chart::levels::Levels;
use crate::report::chart::{Axis, Chart, Curve};
use crate::report::figures::{axis_of, map_over};
use crate::report::map::{Cell, Map, MapMark, Tone};
use crate::report::svg::Picture;
use crate::study::quantities::Quantity;
use crate::study::statistics::sorted_by;
use crate::study::sweep::grid::{self, Grid};
use crate::study::sweep::{self, PointOutcome};
use cmra_engine::model::run::Outcome;

/// Creates the picture of an output over a full grid of one or two axes; `None` if the output exists at no point.
pub fn picture(grid: &Grid, output: usize) -> Option<Picture> {
    match grid.plan().axes() {
        [x] => curve(grid, x, output).map(Picture::Chart),
        [x, y] => map(grid, x, y, output).map(Picture::Map),
        _ => None,
    }
}

/// Iterates over the points of a grid in order.
pub fn points(grid: &Grid, output: usize) -> impl Iterator<Item = grid::Cell> + '_ {
    let (across, up) = grid.counts();
    (0..across).flat_map(move |x| (0..up).map(move |y| grid.cell(x, y, output)))
}

fn curve(grid: &Grid, axis: &sweep::Axis, output: usize) -> Option<Chart<'static>> {
    let column = grid.plan().outputs()[output];
    let values = points(grid, output).map(|point| point.value().unwrap_or(f64::NAN));
    let points = (0..).map(|index| axis.value(index)).zip(values);
    let points = sorted_by(points.collect(), |point: &(f64, f64)| point.0);
    let values = points.iter().map(|point| point.1);
    let y = Axis::fitted(column.title(), column.unit(), values)?;
    let curve = Curve::new('*', "", points);
    Some(Chart::new(column.title(), axis_of(axis), y, vec![curve]))
}

fn map(grid: &Grid, x: &sweep::Axis, y: &sweep::Axis, output: usize) -> Option<Map<'static>> {
    let column = grid.plan().outputs()[output];
    let at = |at_x: usize, at_y: usize| cell(grid.cell(at_x, at_y, output));
    let marks = marks(column, points(grid, output));
    let values = points(grid, output).filter_map(grid::Cell::value);
    let levels = Levels::from_values(values)?;
    let marks = marks.into_iter().map(|(letter, _, label)| MapMark::new(letter, label)).collect();
    Some(Map { unit: column.unit(), marks, ..map_over(column.title(), x, y, Some(levels), at) })
}

/// Converts a point of a grid to a cell of a map.
pub fn cell(point: grid::Cell) -> Cell {
    match point {
        grid::Cell::Value(value) => Cell::Value(value),
        grid::Cell::Outcome(outcome) => Cell::Mark(outcome.letter(), tone(outcome)),
        grid::Cell::Waiting => Cell::Empty,
    }
}

/// Returns the distinct letters of some points with their meanings.
pub fn marks(
    column: &Quantity,
    points: impl Iterator<Item = grid::Cell>,
) -> Vec<(char, Tone, &'static str)> {
    let mut list: Vec<(char, Tone, &'static str)> = Vec::new();
    for point in points {
        let grid::Cell::Outcome(outcome) = point else { continue };
        let letter = outcome.letter();
        if list.iter().all(|mark| mark.0 != letter) {
            list.push((letter, tone(outcome), outcome.without_value(column)));
        }
    }
    list.sort_unstable_by_key(|mark| mark.0);
    list
}

/// Returns the emphasis of the letter for a point without a value.
pub fn tone(outcome: PointOutcome) -> Tone {
    match outcome {
        PointOutcome::Ended(Outcome::Arrested | Outcome::Separated) => Tone::Faint,
        PointOutcome::Ended(Outcome::Perforated) | PointOutcome::Failed(_) => Tone::Error,
        PointOutcome::Ended(Outcome::Moving | Outcome::Unmeasured) => Tone::Warning,
    }
}
