//! Stability page: map, stiff scenes and selected item, as text and drawing.

use crate::tui::pages::numerics::state::{STABILITY, STIFF_SCENES};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::cursor_moved;
use crate::tui::widgets::place::{self, on_axis};
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::counted;
use crate::worker::studies::{StabilityMap, StiffScenes};
use cmra_engine::model::units::{self, Bare, Dimension, engineering};
use cmra_studies::report;
use cmra_studies::report::chart::spaced;
use cmra_studies::report::stability::{HOW_IT_RAN, picture, table, title};
use cmra_studies::study::accuracy::reference::ReferenceSource;
use cmra_studies::study::stability::map::{self, StabilityMapRequest};
use cmra_studies::study::sweep::Axis;

/// Explains the columns of the stiff scenes, for `?`.
pub(crate) fn stiff_scenes_words() -> String {
    let computed = [ReferenceSource::Dop853, ReferenceSource::Radau, ReferenceSource::Engine];
    let bases = computed.map(|it| format!("{}: {}", it.letter(), it.label())).join(", ");
    let stored = ReferenceSource::Stored("").letter();
    format!(
        "The letter behind an error names what it is measured against: {stored}: stored digits, {bases}."
    )
}

/// Returns the columns of the table of stiff scenes.
fn keys() -> Vec<&'static str> {
    ["scene", "shortfall"].into_iter().chain(HOW_IT_RAN).chain(["reference"]).collect()
}

/// Describes the cell at the crosshair.
pub fn map_readout(app: &App) -> Option<String> {
    let tab = &app.pages.numerics.stability;
    let (map, (column, row)) = tab.map.result.as_ref().zip(tab.cursor())?;
    // Use one row of 80 columns, because a second one would move the map.
    let here = if tab.present() == Some((column, row)) { "the scene: " } else { "" };
    Some(format!(
        "{here}dt {} s, {} {}: {}",
        significant(map.dt.value(column as u64), 2),
        map.variable.symbol(),
        significant(map.variable.value(row as u64), 2),
        map.cell(row, column).words(),
    ))
}

pub fn battery_readout(app: &App) -> Option<(Severity, String)> {
    let tab = &app.pages.numerics.stability;
    let row = tab.rows().get(tab.selected)?;
    let name = &row.case.name;
    if let Some(shortfall) = row.shortfall {
        let text = format!("{name}: fails: {}; {}", shortfall.words(), row.run.end.words());
        return Some((Severity::Error, text));
    }
    note(Some(format!("{name}: {}", row.case.why)))
}

pub fn stability_status(app: &App) -> Vec<StatusPart> {
    let tab = &app.pages.numerics.stability;
    let mut parts = Vec::new();
    if app.pane() == STIFF_SCENES {
        let short = tab.rows().iter().filter(|row| row.shortfall.is_some()).count();
        let holds = format!("{} of {} scenes pass", tab.rows().len() - short, tab.rows().len());
        let severity = if short > 0 { Severity::Warning } else { Severity::Note };
        let words = |it: &Running| format!("checking the stiff scenes{}", it.counted("of", ""));
        let running = progress::<StiffScenes, _>(app, &tab.battery, &Scene::default(), words, "");
        parts.extend(running);
        if !tab.rows().is_empty() {
            parts.push(part(severity, holds));
        }
        return parts;
    }
    let words = |it: &Running| format!("computing the map{}", it.counted("of", " rows"));
    let mapping = progress::<StabilityMap, _>(app, &tab.map, &app.scene, words, "rows");
    parts.extend(mapping);
    if let Some(map) = &tab.map.result {
        parts.push(part(Severity::Note, map.method.name().to_owned()));
    }
    parts
}

/// Stores a result; resets the cursor for a map of another variable.
pub(crate) fn report(app: &mut App, running: &Running, news: &ReportBody) {
    let tab = &mut app.pages.numerics.stability;
    let before = tab.map.result.clone();
    tab.battery.keep(running, news);
    if tab.map.keep(running, news)
        && let Some(map) = &tab.map.result
    {
        tab.cursor.take_if(|_| before.is_none_or(|before| before.variable != map.variable));
    }
}

/// Starts the computation of the view shown, unless it is finished or running.
pub(crate) fn enter(app: &mut App) {
    let tab = &app.pages.numerics.stability;
    if app.pane() == STIFF_SCENES {
        if app.jobs.lacks::<StiffScenes, _>(&tab.battery, &Scene::default()) {
            jobs::look_at(app, jobs::LOOK, &Arc::default(), StiffScenes);
        }
        return;
    }
    let is_other = tab.map.result.as_ref().is_some_and(|map| {
        (map.method, map.variable.symbol()) != (tab.method(), tab.variable().symbol())
            && app.jobs.running::<StabilityMap>().is_none()
    });
    if is_other || app.jobs.lacks::<StabilityMap, _>(&tab.map, &app.scene) {
        jobs::look(app, jobs::LOOK, map_of(app));
    }
}

pub(crate) fn act(app: &mut App, action: Action) -> bool {
    let on_scenes = app.pane() == STIFF_SCENES;
    let tab = &mut app.pages.numerics.stability;
    match action {
        Action::Run if on_scenes => jobs::study_of(app, action, &Arc::default(), StiffScenes),
        _ if on_scenes => return false,
        Action::Run => jobs::study(app, action, map_of(app)),
        Action::View => {
            tab.view += 1;
            jobs::look(app, jobs::LOOK, map_of(app));
        }
        _ => match cursor_moved(action) {
            Some(by) => tab.move_cursor(by),
            None => return false,
        },
    }
    true
}

/// Returns the cell nearest to a typed position; axes that are not named keep their index.
pub(super) fn place(app: &App, text: &str) -> Result<Option<(usize, usize)>, String> {
    let tab = &app.pages.numerics.stability;
    let Some((map, (column, row))) = tab.map.result.as_ref().zip(tab.cursor()) else {
        return Ok(None);
    };
    let axes = [&map.dt, &map.variable];
    let names = axes.map(Axis::symbol);
    let read = |at: usize, text: &str| {
        let number = axes[at].variable().number();
        let quantity = number.map_or(Dimension::Number, |number| number.quantity);
        let value = units::parse(text, quantity, Bare::Stored)?;
        on_axis(names[at], value, axes[at].ends(), |value| engineering(value, quantity.unit(), 3))
    };
    let values = place::values(text, &names, read)?;
    let at =
        |axis: usize, kept: usize| values[axis].unwrap_or_else(|| axes[axis].value(kept as u64));
    Ok(map.nearest(at(0, column), at(1, row)))
}

/// Returns the request of the selected map.
fn map_of(app: &App) -> StabilityMap {
    let tab = &app.pages.numerics.stability;
    StabilityMap(StabilityMapRequest {
        method: tab.method(),
        variable: tab.variable(),
        size: map::SIZE,
    })
}

pub(crate) fn draw_map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.stability;
    let old = if tab.map.is_stale(&app.scene) { ", old" } else { "" };
    let focused = app.has_focus(STABILITY);
    let Some(found) = &tab.map.result else {
        let pane = PaneFrame::new("Map").right(app.keymap.shown("<next-pane>: stiff scenes"));
        let pane = pane.focused(focused);
        let inner = pane.draw(area, canvas);
        return canvas.put_centred(inner, &nothing::<StabilityMap>(app, "computing the map", None));
    };
    // The vertical axis has no label here.
    let title = format!("{}; up: {}{old}", title(found), found.variable.symbol());
    let cursor = tab.cursor();
    let map = report::map::Map { title: title.into(), cursor, focused, ..picture(found) };
    let layout = canvas.draw_map(&map, area);
    let (low, high) = (map.y.view.lo(), map.y.view.hi());
    canvas.plot(&layout, |dt_s, value| {
        // Rows extend half a point beyond the map, and more if that makes their values round.
        Some(Target::Cell(STABILITY, found.nearest(dt_s, value.clamp(low, high))?))
    });
}

pub(crate) fn draw_battery(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.stability;
    let rows = tab.rows();
    let grid = Grid::new(table(rows).cells(&keys()), area.width.saturating_sub(2), u16::MAX);
    let height = usize::from(area.height.saturating_sub(3));
    let list = RowList { count: rows.len(), selected: tab.selected, painted: app.dialog.is_none() };
    let first = list.first(area.height.saturating_sub(3));
    let title = if area.width < 70 { "Battery" } else { "Stiff and extreme scenes" };
    let title = spaced(title, &counted(first, height, rows.len()));
    let hint = app.keymap.shown("<next-pane>: map");
    let pane = PaneFrame::new(title).right(hint).focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    canvas.put(inner, (0, 0), &grid.line(None), Role::Dim);
    if rows.is_empty() {
        let text = nothing::<StiffScenes>(app, "running the first scenes", None);
        canvas.put(inner, (1, 2), &text, Role::Dim);
    }
    let area = Rect { y: inner.y + 1, height: inner.height.saturating_sub(1), ..inner };
    let target = |row| Some(Target::Row(STIFF_SCENES, row));
    list.render(canvas, area, target, |canvas, line, index| {
        let role = if rows[index].shortfall.is_some() { Role::Error } else { Role::Text };
        canvas.put(line, (0, 0), &grid.line(Some(index)), role);
    });
}
