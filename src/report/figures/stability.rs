//! Where a fixed-step method is stable: a letter for each step and value, the analytic limit as a line.

use crate::model::variables::find;
use crate::report::chart::{Axis, Scale, Unit, ViewRange};
use crate::report::map::{Cell, LINE, Map, Tone};
use crate::study::stability::map as study;

/// The map as a picture.
pub fn map(found: &study::Map) -> Map<'static> {
    let symbol = found.axis.symbol();
    let unit = find(symbol).map_or("", |variable| variable.unit().trim_matches('-'));
    let axis = |label: &'static str, unit: &'static str, values: &[f64]| {
        let ends = values.first().zip(values.last());
        let view = ends.map_or_else(ViewRange::default, |(low, high)| ViewRange::new(*low, *high));
        Axis::new(label, view).scale(Scale::Log10).unit(Unit::new(unit))
    };
    let axes = (axis("dt", "s", &found.dt_s), axis(symbol, unit, &found.values));
    let counts = (found.dt_s.len(), found.values.len());
    let cell = |column: usize, row: usize| {
        let cell = found.cell(row, column);
        Cell::Mark(cell.letter(), tone(cell))
    };
    let named = study::Cell::ALL.into_iter().filter(|cell| *cell != study::Cell::Waiting);
    let mut marks: Vec<(char, String)> =
        named.map(|cell| (cell.letter(), cell.words().to_owned())).collect();
    marks.push((LINE, "analytic limit of stability".to_owned()));
    marks.push(('+', "the scene with dt = 1e-6 s".to_owned()));
    Map {
        line: (0..counts.1).map(|row| found.limit_column(row)).collect(),
        present: found.present_at().map(|(row, column)| ((column, row), '+')),
        marks,
        ..Map::new(found.method.name(), axes, counts, None, cell)
    }
}

/// How a cell's letter stands out.
pub fn tone(cell: study::Cell) -> Tone {
    match cell {
        study::Cell::Accurate => Tone::Plain,
        study::Cell::Inaccurate => Tone::Warning,
        study::Cell::Oscillating => Tone::Notable,
        study::Cell::BlownUp => Tone::Error,
        study::Cell::TooManySteps | study::Cell::Unknown | study::Cell::Waiting => Tone::Faint,
    }
}
