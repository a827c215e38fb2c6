//! The Stability tab: the map of a fixed-step method in letters and colours, or the battery as a table.

use ratatui::layout::Rect;

use crate::report::figures;
use crate::report::map::Map;
use crate::report::stability::table;
use crate::study::stability::map::{Cell, nearest};
use crate::tui::app::App;
use crate::tui::chart::{Draw, heatmap::role};
use crate::tui::message::Target;
use crate::tui::pages::numerics::stability::keys;
use crate::tui::pages::numerics::stability::{StabilityMap, StiffScenes};
use crate::tui::pages::numerics::{STABILITY, STIFF_SCENES};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::{NEEDS_SINGLE, columns, put, put_centred};

/// Draw the map.
pub(in crate::tui) fn map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.stability;
    let old = if app.map_is_old() { ", old" } else { "" };
    let title = match &tab.map {
        Some((_, map)) => {
            format!("{}, up: {}{old}", map.method.name(), map.axis.symbol())
        }
        None => "Map".to_owned(),
    };
    let focused = app.has_focus(STABILITY);
    let Some((_, found)) = &tab.map else {
        let pane = PaneFrame::new(title).right("Tab: stiff scenes").focused(focused);
        let inner = pane.render(area, canvas, app.theme);
        let text = match app.jobs.running::<StabilityMap>() {
            Some(_) => "computing the map",
            None if app.needs_single_plate() => NEEDS_SINGLE,
            None => "no results yet: press r",
        };
        put_centred(canvas, inner, text, app.theme.style(Role::Dim));
        return;
    };
    let cursor = tab.cursor().map(|(row, column)| (column, row));
    let map = Map { title: title.into(), cursor, focused, ..figures::stability::map(found) };
    let above = Rect { height: area.height.saturating_sub(1), ..area };
    let layout = map.render(above, canvas, app.theme);
    legend(app, area, canvas);
    let hint = " Tab: stiff scenes ";
    let column = above.width.saturating_sub(columns(hint) + 1);
    put(canvas, above, (column, above.height.saturating_sub(1)), hint, app.theme.style(Role::Dim));
    canvas.plot(&layout, |dt_s, value| {
        let row = nearest(&found.values, value)?;
        Some(Target::Cell(STABILITY, (row, nearest(&found.dt_s, dt_s)?)))
    });
}

/// What letters and marks mean, in as many words as there is room for.
fn legend(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let cells = [Cell::Accurate, Cell::Inaccurate, Cell::Oscillating, Cell::BlownUp];
    let short = ["1 %", "worse", "rings", "blows up"];
    let marks = ["# analytic limit  + this scene at the thesis's 1e-6 s", "# limit  + 1e-6 s"];
    let width = |words: [&str; 4], marks| {
        // A letter and a space before each, and two spaces behind.
        1 + words.into_iter().map(|text| columns(text) + 4).sum::<u16>() + columns(marks)
    };
    let long = cells.map(Cell::words);
    let choices = [(long, marks[0]), (long, marks[1]), (short, marks[1])];
    let fits = choices.into_iter().find(|(words, marks)| width(*words, marks) <= area.width);
    let (words, marks) = fits.unwrap_or(choices[2]);
    let (style, row) = (app.theme.style(Role::Text), area.height - 1);
    let mut column = 1;
    for (cell, text) in cells.into_iter().zip(words) {
        let letter = cell.letter().to_string();
        put(
            canvas,
            area,
            (column, row),
            &letter,
            app.theme.style(role(figures::stability::tone(cell))),
        );
        column = put(canvas, area, (column + 2, row), text, style) + 2;
    }
    put(canvas, area, (column, row), marks, style);
}

/// Draw the battery.
pub(in crate::tui) fn battery(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.stability;
    let rows = tab.sorted();
    let table = table(rows.iter().copied());
    let keys = keys();
    let mut cells = table.cells(&keys);
    tab.sorting.mark(&keys, &mut cells);
    let grid = Grid::of(cells, area.width.saturating_sub(2), tab.table_page);
    let height = usize::from(area.height.saturating_sub(3));
    let list = List { count: rows.len(), selected: tab.selected, painted: app.dialog.is_none() };
    let first = list.first(area.height.saturating_sub(3));
    let title = if area.width < 70 { "Battery" } else { "Battery of stiff and extreme scenes" };
    let title = if rows.len() > height {
        let last = (first + height).min(rows.len());
        format!("{title} {}-{last}/{}", first + 1, rows.len())
    } else {
        title.to_owned()
    };
    let hint = grid.hint().map_or_else(String::new, |hint| hint + "  ");
    let pane = PaneFrame::new(title).right(hint + "Tab: map").focused(app.dialog.is_none());
    let inner = pane.render(area, canvas, app.theme);
    let dim = app.theme.style(Role::Dim);
    put(canvas, inner, (0, 0), &grid.line(None), dim);
    if rows.is_empty() {
        let text = if app.jobs.running::<StiffScenes>().is_some() {
            "running the first scenes"
        } else {
            "r runs it"
        };
        put(canvas, inner, (1, 2), text, dim);
    }
    let area = Rect { y: inner.y + 1, height: inner.height.saturating_sub(1), ..inner };
    let target = |row| Some(Target::Row(STIFF_SCENES, row));
    list.render(canvas, area, app.theme, target, |canvas, line, index| {
        let style =
            app.theme.style(if rows[index].shortfall.is_some() { Role::Error } else { Role::Text });
        put(canvas, line, (0, 0), &grid.line(Some(index)), style);
    });
}
