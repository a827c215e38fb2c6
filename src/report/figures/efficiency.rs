//! The map of the mass efficiency with the line of 1.

use crate::report::figures::{axis_of, places};
use crate::report::map::{Cell, Map};
use crate::study::compare::map::Map as Efficiency;

/// What the line means.
pub const LINE: &str = "line of 1: above 1 the armour is lighter than the solid plate";

/// The map as a picture.
pub fn map(found: &Efficiency) -> Option<Map> {
    let (across, up) = (places(found.x()), places(found.y()));
    let cell = |x: usize, y: usize| match found.cell(x as u64, y as u64) {
        Some(Ok(value)) => Cell::Value(value),
        Some(Err(absence)) => Cell::Mark(absence.letter()),
        None => Cell::Empty,
    };
    let cells = up.iter().flat_map(|y| across.iter().map(move |x| (*x, *y)));
    let absences = found.cells.iter().filter_map(|cell| cell.err());
    let mut marks: Vec<(char, String)> =
        absences.map(|absence| (absence.letter(), absence.words())).collect();
    marks.sort();
    marks.dedup_by_key(|mark| mark.0);
    Some(Map {
        title: "mass efficiency".to_owned(),
        unit: String::new(),
        x: axis_of(found.x())?,
        y: axis_of(found.y())?,
        counts: (across.len(), up.len()),
        cells: cells.map(|(x, y)| cell(x, y)).collect(),
        contour: Some((1.0, LINE.to_owned())),
        marks,
    })
}
