//! The map of the mass efficiency as a heat map with the line of 1.

use crate::study::compare::map::Map;
use crate::study::sweep;
use crate::tui::chart::{HeatCell, Heatmap, Levels, Scale};
use crate::tui::pages::explore::curves::chart_axis;
use crate::tui::theme::Role;

/// The bands of a map; `None` where no point has a mass efficiency.
pub(in crate::tui) fn levels(map: &Map) -> Option<Levels> {
    Levels::of(Scale::Linear, map.cells.iter().filter_map(|cell| cell.ok()))
}

/// Calls `draw` with the heat map of a map.
pub(in crate::tui) fn with_heatmap<T>(
    map: &Map,
    levels: &Levels,
    draw: impl FnOnce(&Heatmap<'_>) -> T,
) -> T {
    let (x, y) = (map.x(), map.y());
    let from_lower_left = |at: usize, axis: &sweep::Axis| {
        let (at, last) = (at as u64, axis.count() - 1);
        if axis.ends().0 > axis.ends().1 { last - at } else { at }
    };
    let cell = |across: usize, up: usize| match map
        .cell(from_lower_left(across, x), from_lower_left(up, y))
    {
        Some(Ok(value)) => HeatCell::Value(value),
        Some(Err(absence)) => HeatCell::Mark(absence.letter(), Role::Dim),
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
