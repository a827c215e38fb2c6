//! The pictures of a sweep: a curve of each output over one axis, a map over two.

use crate::numerics::statistics::sorted_by;
use crate::report::chart::levels::Levels;
use crate::report::chart::{Axis, Chart, Curve, Scale};
use crate::report::figures::{axis_of, map_over};
use crate::report::map::{Cell, Map, Tone};
use crate::report::svg::Picture;
use crate::study::quantities::Quantity;
use crate::study::sweep::grid::{self, tells};
use crate::study::sweep::{self, Plan, PointOutcome, Rows};

/// The outcome of a point, and its outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its outcome.
    pub outcome: PointOutcome,
    /// The outputs of the plan.
    pub values: Vec<Option<f64>>,
}

impl Row {
    /// The rows that came out of a sweep.
    pub fn all(rows: &Rows) -> impl Iterator<Item = Self> {
        let values = |row| (0..rows.outputs()).map(|output| rows.value(row, output)).collect();
        (0..rows.len()).map(move |row| Self { outcome: rows.outcome(row), values: values(row) })
    }

    /// The number to draw, if one tells anything.
    pub fn shown(&self, output: usize, column: &Quantity) -> Option<f64> {
        self.values[output].filter(|_| tells(column, self.outcome))
    }
}

/// The picture of an output over all points of a sweep of one or two axes; `None` where it exists nowhere.
pub fn picture(plan: &Plan, output: usize, rows: &[Row]) -> Option<Picture> {
    match plan.axes() {
        [x] => curve(plan, x, output, rows).map(Picture::Chart),
        [x, y] => map(plan, x, y, output, rows).map(Picture::Map),
        _ => None,
    }
}

fn curve(plan: &Plan, axis: &sweep::Axis, output: usize, rows: &[Row]) -> Option<Chart<'static>> {
    let column = plan.outputs()[output];
    let value = |row: &Row| row.shown(output, column).unwrap_or(f64::NAN);
    let points = (0..).map(|index| axis.value(index)).zip(rows.iter().map(value));
    let points = sorted_by(points.collect(), |point: &(f64, f64)| point.0);
    let values = points.iter().map(|point| point.1);
    let y = Axis::fitted(column.title(), column.unit(), Scale::Linear, values)?;
    let curve = Curve::new('*', "", points);
    Some(Chart::new(column.title(), axis_of(axis), y, vec![curve]))
}

fn map(
    plan: &Plan,
    x: &sweep::Axis,
    y: &sweep::Axis,
    output: usize,
    rows: &[Row],
) -> Option<Map<'static>> {
    let column = plan.outputs()[output];
    let height = usize::try_from(y.count()).ok()?;
    let point = |row: &Row| {
        row.shown(output, column).map_or(grid::Cell::Outcome(row.outcome), grid::Cell::Value)
    };
    let at = |at_x: usize, at_y: usize| {
        rows.get(at_x * height + at_y).map_or(Cell::Empty, |row| cell(point(row), Scale::Linear))
    };
    let marks = marks(column, rows.iter().map(point), Scale::Linear);
    let values = rows.iter().filter_map(|row| row.shown(output, column));
    let levels = Levels::of(Scale::Linear, values)?;
    let marks = marks.into_iter().map(|(letter, _, words)| (letter, words.to_owned())).collect();
    Some(Map { unit: column.unit(), marks, ..map_over(column.title(), x, y, Some(levels), at) })
}

/// What a map shows at a point: what the scale has no place for is a letter, too.
pub fn cell(point: grid::Cell, scale: Scale) -> Cell {
    match point {
        grid::Cell::Value(value) if scale.shows(value) => Cell::Value(value),
        grid::Cell::Value(_) => Cell::Mark('0', Tone::Faint),
        grid::Cell::Outcome(outcome) => Cell::Mark(outcome.letter(), tone(outcome)),
        grid::Cell::Waiting => Cell::Empty,
    }
}

/// The letters among some points, each once, with what they mean.
pub fn marks(
    column: &Quantity,
    points: impl Iterator<Item = grid::Cell>,
    scale: Scale,
) -> Vec<(char, Tone, &'static str)> {
    let mut list: Vec<(char, Tone, &'static str)> = Vec::new();
    for point in points {
        let Cell::Mark(letter, tone) = cell(point, scale) else { continue };
        if list.iter().all(|mark| mark.0 != letter) {
            let words = match point {
                grid::Cell::Outcome(outcome) => outcome.without_value(column),
                grid::Cell::Value(_) | grid::Cell::Waiting => "zero or less: not on a log",
            };
            list.push((letter, tone, words));
        }
    }
    list.sort_unstable_by_key(|mark| mark.0);
    list
}

/// How the letter of a point without a value stands out.
pub fn tone(outcome: PointOutcome) -> Tone {
    match outcome {
        PointOutcome::Arrested | PointOutcome::Separated => Tone::Faint,
        PointOutcome::Perforated | PointOutcome::Failed(_) => Tone::Error,
        PointOutcome::Moving => Tone::Warning,
    }
}
