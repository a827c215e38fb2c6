//! Point under the cursor of the Explore tab, as a design and as text.

use crate::tui::pages::explore::plan::sweep_plan;
use crate::tui::pages::explore::state::{ChartKind, nearest, placed};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::place::{self, on_axis};
use crate::tui::widgets::text::fitting;
use crate::worker::studies::PictureSweep;
use cmra_engine::model::units::{self, Bare, Dimension};
use cmra_studies::study::quantities::Quantity;
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::sweep::grid::{Cell, Grid};

/// Returns the display of Explore: curves or a map.
pub fn chart_kind(app: &App) -> ChartKind {
    app.pages.explore.picture
}

/// Returns `true` if the displayed result belongs to other axes or constant variables than the present ones.
pub fn sweep_is_old(app: &App) -> bool {
    let wanted = sweep_plan(app).ok();
    let shown = app.pages.explore.found().map(|grid| &**grid.plan());
    shown.is_some() && shown != wanted.as_ref()
}

pub fn shown_output(app: &App, grid: &Grid) -> (usize, &'static Quantity) {
    let outputs = grid.plan().outputs();
    let at = app.pages.explore.output.min(outputs.len().saturating_sub(1));
    (at, outputs[at])
}

/// Returns the grid point under the cursor; before it is moved, the point nearest to the scene.
pub fn cursor_point(app: &App, grid: &Grid) -> (usize, usize) {
    let (across, up) = grid.counts();
    if let Some(at) = app.pages.explore.cursor.filter(|(x, y)| *x < across && *y < up) {
        return at;
    }
    let along = |axis: Option<&Axis>| {
        let axis = axis?;
        nearest(axis, axis.own_value(&app.scene)?)
    };
    let axes = grid.plan().axes();
    (along(axes.first()).unwrap_or(0), along(axes.get(1)).unwrap_or(0))
}

/// Describes the point under the cursor in at most this many columns; only the output shown if the others do not fit.
pub fn sweep_readout(app: &App, width: usize) -> Option<String> {
    let grid = app.pages.explore.found()?;
    let (x, y) = cursor_point(app, grid);
    let values = || values_at(grid, (x, y));
    let is_here = |(axis, value): (&Axis, f64)| axis.own_value(&app.scene) == Some(value);
    let near = if values().all(is_here) { "" } else { "near " };
    let place =
        values().map(|(axis, value)| format!("{} {}", axis.symbol(), axis.display(value, 5)));
    let place = place.collect::<Vec<_>>().join(" ");
    let (shown, _) = shown_output(app, grid);
    let outputs = grid.plan().outputs().iter().enumerate();
    let mut words: Vec<String> =
        outputs.map(|(at, output)| cell_words(output, grid.cell(x, y, at))).collect();
    let own = words[shown].clone();
    // For a point without values all outputs have the same text.
    words.dedup();
    let all = format!("{near}{place}: {}", words.join(", "));
    Some(fitting([all, format!("{near}{place}: {own}")], width))
}

/// Returns the design under the cursor as a scene, labelled with the values of the axes.
pub fn sweep_design(app: &App) -> Result<LabelledScene, String> {
    let Some(grid) = app.pages.explore.found() else {
        return Err(no_sweep(app));
    };
    if sweep_is_old(app) {
        return Err(old("setup"));
    }
    let point = cursor_point(app, grid);
    Ok(placed((*app.scene).clone(), values_at(grid, point)))
}

/// Returns the text for a missing sweep.
pub(crate) fn no_sweep(app: &App) -> String {
    nothing::<PictureSweep>(app, BEING_COMPUTED, None)
}

/// Returns the grid point nearest to a typed position; axes that are not named keep their index.
pub(super) fn place(app: &App, text: &str) -> Result<(usize, usize), String> {
    let Some(grid) = app.pages.explore.found() else { return Err(no_sweep(app)) };
    place_on(app, grid.plan().axes(), cursor_point(app, grid), text)
}

/// Returns the point of some axes nearest to a typed position, starting from a point.
pub(crate) fn place_on(
    app: &App,
    axes: &[Axis],
    (mut x, mut y): (usize, usize),
    text: &str,
) -> Result<(usize, usize), String> {
    let names: Vec<&str> = axes.iter().map(Axis::symbol).collect();
    let read = |at: usize, text: &str| {
        let number = axes[at].variable().number();
        let quantity = number.map_or(Dimension::Number, |number| number.quantity);
        let value = units::parse(text, quantity, Bare::In(app.unit_of(names[at])))?;
        let values = (0..axes[at].count()).map(|index| axes[at].value(index));
        let ends = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        on_axis(names[at], value, ends, |value| axes[at].show(value, 5))
    };
    let values = place::values(text, &names, read)?;
    for (at, value) in values.into_iter().enumerate() {
        if let Some(near) = value.and_then(|value| nearest(&axes[at], value)) {
            *(if at == 0 { &mut x } else { &mut y }) = near;
        }
    }
    Ok((x, y))
}

/// Iterates over the axes with the units of bare numbers, for the field of a position.
pub(crate) fn places_of<'a>(
    app: &App,
    axes: impl IntoIterator<Item = &'a Axis>,
) -> Vec<(String, String)> {
    let place = |axis: &Axis| (axis.symbol().to_owned(), app.unit_of(axis.symbol()).to_owned());
    axes.into_iter().map(place).collect()
}

/// Formats an output at a point: its value, or the reason why there is none.
fn cell_words(output: &Quantity, cell: Cell) -> String {
    let name = match output.name {
        "max_plate_displacement_m" => "plate".to_owned(),
        "final_penetration_m" | "first_arrest_penetration_m" => "depth".to_owned(),
        _ => output.title(),
    };
    match cell {
        Cell::Value(value) if output.unit() == "%" => {
            format!("{} of rigid mount", output_value(output, value))
        }
        Cell::Value(value) => format!("{name} {}", output_value(output, value)),
        Cell::Outcome(outcome) if outcome.is_stopped() => {
            format!("{name}: {}", outcome.without_value(output))
        }
        Cell::Outcome(outcome) => outcome.without_value(output).to_owned(),
        Cell::Waiting => "not computed yet".to_owned(),
    }
}

/// Iterates over the axes of a grid with their values at a point.
fn values_at(grid: &Grid, point: (usize, usize)) -> impl Iterator<Item = (&Axis, f64)> {
    let axes = grid.plan().axes().iter().enumerate();
    axes.map(move |(place, axis)| (axis, grid.coordinate(point, place)))
}

/// Formats an output with its unit: `64.27 %`, `37.98 mm`.
fn output_value(output: &Quantity, value: f64) -> String {
    if output.unit().is_empty() { significant(value, 5) } else { output.show_all_digits(value, 4) }
}
