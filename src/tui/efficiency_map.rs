//! The map of the mass efficiency as a heat map with the line of 1: the same on the command line and in the workbench.

use super::chart::{Axis, HeatCell, Heatmap, Levels, Scale, Unit, ViewRange};
use super::theme::Role;
use crate::study::compare::Absence;
use crate::study::compare::map::Map;
use crate::study::sweep::{self, Spacing};

/// What the line means.
pub const LINE: &str = "O line of 1: above 1 the armour is lighter than the solid plate";

/// The bands of a map; `None` where no point has a mass efficiency.
pub fn levels(map: &Map) -> Option<Levels> {
    Levels::of(Scale::Linear, map.cells.iter().filter_map(|cell| cell.ok()))
}

/// Hand the heat map of a map to whoever draws it.
pub fn with_heatmap<T>(map: &Map, levels: &Levels, draw: impl FnOnce(&Heatmap<'_>) -> T) -> T {
    let (x, y) = (map.x(), map.y());
    let from_lower_left = |at: usize, axis: &sweep::Axis| {
        let (at, last) = (at as u64, axis.count() - 1);
        if axis.ends().0 > axis.ends().1 { last - at } else { at }
    };
    let cell = |across: usize, up: usize| match map
        .cell(from_lower_left(across, x), from_lower_left(up, y))
    {
        Some(Ok(value)) => HeatCell::Value(value),
        Some(Err(absence)) => HeatCell::Mark(letter(absence), Role::Dim),
        None => HeatCell::Empty,
    };
    let counts = |axis: &sweep::Axis| usize::try_from(axis.count()).unwrap_or(usize::MAX);
    draw(&Heatmap {
        title: format!("mass efficiency, up: {}", y.symbol()).into(),
        x: chart_axis(x),
        y: chart_axis(y),
        counts: (counts(x), counts(y)),
        cell: &cell,
        levels,
        contour: Some(1.0),
        cursor: None,
        focused: false,
    })
}

fn chart_axis(axis: &sweep::Axis) -> Axis<'static> {
    let (from, to) = axis.ends();
    let view = ViewRange::new(from, to);
    let scale = match axis.spacing() {
        Spacing::Linear | Spacing::Listed => Scale::Linear,
        Spacing::Log => Scale::Log10,
    };
    let unit = axis.variable().unit().trim_matches('-');
    Axis::new(axis.symbol(), view).scale(scale).unit(Unit::with_prefix(view, unit))
}

/// The letters of points without a mass efficiency, and what they mean.
pub fn absences(map: &Map) -> Vec<(char, String)> {
    let absences = map.cells.iter().filter_map(|cell| cell.err());
    let mut letters: Vec<(char, String)> =
        absences.map(|absence| (letter(absence), absence.words())).collect();
    letters.sort();
    letters.dedup_by_key(|entry| entry.0);
    letters
}

/// The letter of a point without a mass efficiency.
fn letter(absence: Absence) -> char {
    match absence {
        Absence::NoSolid => 'N',
        Absence::NoThickness => 'T',
        Absence::NoSpringMass => 'M',
        Absence::Fails(_) => 'F',
    }
}
