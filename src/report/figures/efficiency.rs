//! The map of the mass efficiency with the line of 1.

use crate::report::chart::Scale;
use crate::report::chart::levels::Levels;
use crate::report::figures::map_over;
use crate::report::map::{Cell, Map, Tone};
use crate::study::compare::map::Map as Efficiency;

/// The meaning of the line.
pub const LINE: &str = "line of 1: above 1 the armour is lighter than the solid plate";

/// The map as a picture; `None` where no point has a mass efficiency.
pub fn map(found: &Efficiency) -> Option<Map<'static>> {
    let cell = |x: usize, y: usize| match found.cell(x as u64, y as u64) {
        Some(Ok(value)) => Cell::Value(value),
        Some(Err(absence)) => Cell::Mark(absence.letter(), Tone::Faint),
        None => Cell::Empty,
    };
    let absences = found.cells.iter().filter_map(|cell| cell.err());
    let mut marks: Vec<(char, String)> =
        absences.map(|absence| (absence.letter(), absence.words())).collect();
    marks.sort();
    marks.dedup_by_key(|mark| mark.0);
    let levels = Levels::of(Scale::Linear, found.cells.iter().filter_map(|cell| cell.ok()))?;
    Some(Map {
        contour: Some((1.0, LINE.into())),
        marks,
        ..map_over("mass efficiency", found.x(), found.y(), Some(levels), cell)
    })
}
