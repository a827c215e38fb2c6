//! The Stability tab: the map of a fixed-step method in letters and colours, or the battery as a table.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::model::variables::find;
use crate::report::stability::table;
use crate::study::stability::map::{Cell, Map};
use crate::tui::app::App;
use crate::tui::message::Target;
use crate::tui::pages::numerics::stability::keys;
use crate::tui::pages::numerics::{STABILITY, STIFF_SCENES};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::{NEEDS_SINGLE, columns, paint_row, put};

/// Columns left of the map, for the values of its rows.
const GUTTER: u16 = 9;
/// Rows below it: axis, steps, legend.
const FOOT: u16 = 3;

fn role(cell: Cell) -> Role {
    match cell {
        Cell::Accurate => Role::Text,
        Cell::Inaccurate => Role::Warning,
        Cell::Oscillating => Role::Curve(1),
        Cell::BlownUp => Role::Error,
        Cell::TooManySteps | Cell::Unknown | Cell::Waiting => Role::Dim,
    }
}

/// Draw the map.
pub(in crate::tui) fn map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.stability;
    let old = if app.map_is_old() { ", old" } else { "" };
    let title = match &tab.map {
        Some((_, map)) => {
            format!(
                "{}: {}{} over time step{old}",
                map.method.name(),
                map.axis.symbol(),
                unit(map.axis.symbol())
            )
        }
        None => "Map".to_owned(),
    };
    let pane = PaneFrame::new(title).right("Tab: stiff scenes").focused(app.has_focus(STABILITY));
    let inner = pane.render(area, canvas, app.theme);
    let Some((_, map)) = &tab.map else {
        let text = match tab.mapping {
            Some(_) => "computing the map",
            None if app.needs_single_plate() => NEEDS_SINGLE,
            None => "no results yet: press r",
        };
        let column = inner.width.saturating_sub(columns(text)) / 2;
        put(canvas, inner, (column, inner.height / 2), text, app.theme.style(Role::Dim));
        return;
    };
    let plot = Rect {
        x: inner.x + GUTTER.min(inner.width),
        width: inner.width.saturating_sub(GUTTER + 1),
        height: inner.height.saturating_sub(FOOT),
        ..inner
    };
    if plot.width < 10 || plot.height < 4 {
        return;
    }
    cells(app, map, plot, canvas);
    values(app, map, inner, plot, canvas);
    legend(app, inner, canvas);
    let (rows, steps) = (map.values.len(), map.dt_s.len());
    canvas.hit(plot, |at| {
        let row = rows.checked_sub(1 + spread(at.1 - plot.y, plot.height, rows))?;
        Some(Target::Cell(STABILITY, (row, spread(at.0 - plot.x, plot.width, steps))))
    });
}

/// The unit of a variable in brackets.
fn unit(symbol: &str) -> String {
    let unit = find(symbol).map_or("", |found| found.unit().trim_matches('-'));
    if unit.is_empty() { String::new() } else { format!(" [{unit}]") }
}

/// What letters and marks mean, in as many words as there is room for.
fn legend(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let cells = [Cell::Accurate, Cell::Inaccurate, Cell::Oscillating, Cell::BlownUp];
    let short = ["1 %", "worse", "rings", "blows up"];
    let marks = ["| analytic limit  + this scene at the thesis's 1e-6 s", "| limit  + 1e-6 s"];
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
        put(canvas, area, (column, row), &letter, app.theme.style(role(cell)));
        column = put(canvas, area, (column + 2, row), text, style) + 2;
    }
    put(canvas, area, (column, row), marks, style);
}

/// The index of what a cell of the screen shows, of `count` spread over `cells`.
fn spread(cell: u16, cells: u16, count: usize) -> usize {
    (usize::from(cell) * count) / usize::from(cells.max(1))
}

/// The first cell of the screen that shows an index, or would; the inverse of [`spread`].
fn place(index: usize, cells: u16, count: usize) -> u16 {
    let cell = (index * usize::from(cells)).div_ceil(count.max(1));
    u16::try_from(cell).unwrap_or(u16::MAX).min(cells.saturating_sub(1))
}

fn cells(app: &App, map: &Map, plot: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.stability;
    let (rows, steps) = (map.values.len(), map.dt_s.len());
    for y in 0..plot.height {
        let row = rows - 1 - spread(y, plot.height, rows);
        for x in 0..plot.width {
            let cell = map.cell(row, spread(x, plot.width, steps));
            put(canvas, plot, (x, y), &cell.letter().to_string(), app.theme.style(role(cell)));
        }
        if let Some(column) = map.limit_column(row) {
            let x = place(column, plot.width, steps);
            put(canvas, plot, (x, y), "|", app.theme.style(Role::Event));
        }
    }
    let at = |(row, column): (usize, usize)| {
        (place(column, plot.width, steps), place(rows - 1 - row, plot.height, rows))
    };
    if let Some(present) = tab.present() {
        put(canvas, plot, at(present), "+", app.theme.style(Role::Title));
    }
    if let Some(cursor) = tab.cursor() {
        let (x, y) = at(cursor);
        let cell = Rect { x: plot.x + x, y: plot.y + y, width: 1, height: 1 };
        paint_row(canvas, cell, 0, app.theme.style(Role::Selection));
    }
}

/// The columns of a plot that are nearest to powers of ten among the steps shown, and those powers.
fn decades(steps: &[f64], width: u16) -> Vec<(u16, String)> {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else {
        return Vec::new();
    };
    (-30..30)
        .map(|exponent| (10_f64.powi(exponent), format!("1e{exponent}")))
        .filter(|(value, _)| (*first..=*last).contains(value))
        .filter_map(|(value, text)| {
            let away = |at: &usize| (steps[*at] / value).ln().abs();
            let nearest = (0..steps.len()).min_by(|a, b| away(a).total_cmp(&away(b)))?;
            Some((place(nearest, width, steps.len()), text))
        })
        .collect()
}

/// The values of rows and columns.
fn values(app: &App, map: &Map, inner: Rect, plot: Rect, canvas: &mut Canvas<'_>) {
    let style = app.theme.style(Role::Text);
    let rows = map.values.len();
    let every = if plot.height < 24 { 3 } else { 6 };
    let value = |y: u16| map.values[rows - 1 - spread(y, plot.height, rows)];
    // Over many decades powers of ten, equally far apart; else the values of every few rows.
    let exponent = |value: f64| value.log10();
    let (low, high) = (exponent(value(plot.height - 1)), exponent(value(0)));
    let is_wide = (high - low).is_finite() && high - low > 4.0;
    let labels: Vec<(u16, String)> = if is_wide {
        let most = f64::from(plot.height / every).max(2.0);
        let apart =
            [1, 2, 3, 4, 6].into_iter().find(|apart| (high - low) / f64::from(*apart) <= most);
        let apart = apart.unwrap_or(6);
        let powers = (-30..31).filter(|power| power % apart == 0);
        let within = powers.filter(|power| (low..=high).contains(&f64::from(*power)));
        let row = |power: i32| {
            let away = |y: &u16| (exponent(value(*y)) - f64::from(power)).abs();
            (0..plot.height).min_by(|a, b| away(a).total_cmp(&away(b)))
        };
        within.filter_map(|power| Some((row(power)?, format!("1e{power}")))).collect()
    } else {
        let rows = (0..plot.height).filter(|y| y % every == 0);
        rows.map(|y| (y, significant(value(y), 2))).collect()
    };
    for (y, text) in labels {
        let column = GUTTER.saturating_sub(columns(&text) + 1);
        put(canvas, inner, (column, y), &text, style);
    }
    let below = plot.height;
    // The name of the axis stands before the first.
    let mut free = GUTTER;
    for (x, text) in decades(&map.dt_s, plot.width) {
        put(canvas, inner, (GUTTER + x, below), "|", app.theme.style(Role::Border));
        // Centred below its mark, as far as there is room on both sides.
        let last = inner.width.saturating_sub(columns(&text));
        let start = (GUTTER + x).saturating_sub(columns(&text) / 2).max(free).min(last);
        if (free..=GUTTER + x).contains(&start) {
            free = put(canvas, inner, (start, below + 1), &text, style) + 2;
        }
    }
    put(canvas, inner, (1, below + 1), "dt [s]", style);
    put(canvas, inner, (1, below), map.axis.symbol(), style);
}

/// Draw the battery.
pub(in crate::tui) fn battery(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.stability;
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
        let text = if tab.running.is_some() { "running the first scenes" } else { "r runs it" };
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
