//! Drawing of the Explore tab: an output over one variable, with a curve for each value of a second one, or over two variables as a map.
//! Points without a value are letters on the axis.

use crate::tui::chart::{self, Chart, Curve, Emphasis, MARKERS};
use crate::tui::pages::explore::cursor::{chart_kind, cursor_point, shown_output, sweep_is_old};
use crate::tui::pages::explore::held;
use crate::tui::pages::explore::plan::no_value;
use crate::tui::pages::explore::setup::setup_form;
use crate::tui::pages::explore::state::{self, RESULTS, SETUP, nearest};
use crate::tui::pages::page::draw_setup;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::setup_width;
use crate::tui::widgets::text::{fitting, wrapped};
use crate::worker::studies::PictureSweep;
use cmra_studies::report::figures::{axis_of, column_of, sweeps};
use cmra_studies::report::map::Map;
use cmra_studies::report::svg::Picture;
use cmra_studies::study::sweep::grid::{self, Grid};

/// Minimum rows of a picture with a line of the constant variables above it.
const HELD_FROM: u16 = 10;

/// Draws the setup, and beside it the curves or the map.
pub(crate) fn render(app: &App, body: Rect, canvas: &mut Canvas<'_>) {
    let (setup, area) = split_left(body, setup_width(body.width));
    draw_setup(app, &setup_form(app), SETUP, setup, canvas);
    canvas.pane(area, RESULTS);
    let Some(grid) = app.pages.explore.found() else { return waiting(app, area, canvas) };
    let (line, area) = split_top(area, u16::from(area.height >= HELD_FROM));
    held::draw(app, grid, line, canvas);
    let (output, column) = shown_output(app, grid);
    let old = if is_old(app) { ", of another scene" } else { "" };
    let titles = [column.title(), column.brief_title()].map(|it| it + old);
    let drawn = match chart_kind(app) {
        state::ChartKind::Line => curves(app, grid, output, &titles[0], area, canvas),
        state::ChartKind::Surface => map(app, grid, output, &titles, area, canvas),
    };
    if drawn.is_none() {
        let [title, _] = titles;
        let inner = PaneFrame::new(title).draw(area, canvas);
        let why = app.keymap.shown(&no_value(grid, output).join("\n"));
        let lines = why.lines().flat_map(|text| wrapped(text, inner.width, Role::Dim));
        let lines: Vec<TextLine> = lines.collect();
        let rows = u16::try_from(lines.len()).unwrap_or(u16::MAX);
        canvas.put_lines(inner, inner.height.saturating_sub(rows) / 2, lines);
    }
}

/// Returns `true` if the picture belongs to another scene and none of this scene is being computed.
fn is_old(app: &App) -> bool {
    sweep_is_old(app) && app.jobs.running::<PictureSweep>().is_none()
}

/// Draws a pane without results.
fn waiting(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let title = if chart_kind(app) == state::ChartKind::Line { "Curves" } else { "Map" };
    let inner = PaneFrame::new(title).draw(area, canvas);
    let why = app.pages.explore.problem.as_ref().map(|_| "see the message below");
    let text = nothing::<PictureSweep>(app, "sweeping the first points", why);
    canvas.put_centred(inner, &text);
}

/// Draws the curves; `None` if there are no values.
fn curves(
    app: &App,
    grid: &Grid,
    output: usize,
    title: &str,
    area: Rect,
    canvas: &mut Canvas<'_>,
) -> Option<()> {
    let column = grid.plan().outputs()[output];
    let axes = grid.plan().axes();
    let (along, repeats) = grid.counts();
    let line = |y: usize| -> Vec<(f64, f64)> {
        let point = |x: usize| (grid.coordinate((x, y), 0), number(grid.cell(x, y, output)));
        (0..along).map(point).collect()
    };
    let lines: Vec<Vec<(f64, f64)>> = (0..repeats).map(line).collect();
    let printed = printed(app, grid, output);
    let values = lines.iter().chain(&printed).flatten().map(|point| point.1);
    let y = chart::Axis::fitted("", column.unit(), values)?;
    let (x, selected) = cursor_point(app, grid);
    let curves = lines.iter().enumerate().map(|(index, points)| {
        let name = axes.get(1);
        let name = name.map_or_else(String::new, |axis| held::legend(app, axis, index as u64));
        let emphasis = chart::emphasis(is_old(app), index == selected);
        let marker = MARKERS[index % MARKERS.len()];
        Curve::new(marker, name, points).colour(index).emphasis(emphasis)
    });
    let printed = printed.iter().enumerate().map(|(index, points)| {
        // The first curve names the series, also in exported pictures.
        let name = if index == 0 { "as printed" } else { "" };
        Curve::new('.', name, points).emphasis(Emphasis::Faint)
    });
    let chart = Chart {
        crosshair: Some(grid.coordinate((x, selected), 0)),
        focused: app.has_focus(RESULTS),
        ..Chart::new(title, axis_of(&axes[0]), y, printed.chain(curves).collect())
    };
    let layout = canvas.draw(&chart, area);
    // Draw a letter at the foot of the plot at each gap of the selected curve.
    for x in 0..along {
        if let grid::Cell::Outcome(outcome) = grid.cell(x, selected, output) {
            canvas.put_gap(&layout, grid.coordinate((x, selected), 0), outcome.letter());
        }
    }
    canvas.plot(&layout, |x, _| Some(Target::Cell(RESULTS, (nearest(&axes[0], x)?, selected))));
    Some(())
}

/// Approximate width of a line, as a fraction of the range of a chart.
const LINE: f64 = 0.02;

/// Returns the curves of a figure by the printed scheme of the thesis, where they differ from the corrected curves by more than a line
/// width.
pub(crate) fn printed(app: &App, grid: &Grid, output: usize) -> Vec<Vec<(f64, f64)>> {
    let found = app.pages.explore.printed.as_ref();
    let is_same = |it: &&Arc<Grid>| it.plan().axes() == grid.plan().axes();
    let Some(found) = found.filter(is_same) else { return Vec::new() };
    let (along, repeats) = grid.counts();
    let value = |grid: &Grid, at: (usize, usize)| number(grid.cell(at.0, at.1, output));
    let all = sweeps::points(grid, output).map(|it| number(it).abs());
    let size = all.filter(|it| it.is_finite()).fold(0.0, f64::max);
    let curve = |y: usize| {
        let differs = |x: usize| (value(grid, (x, y)) - value(found, (x, y))).abs() > LINE * size;
        let point = |x: usize| (found.coordinate((x, y), 0), value(found, (x, y)));
        (0..along).any(differs).then(|| (0..along).map(point).collect())
    };
    (0..repeats).filter_map(curve).collect()
}

/// Draws the map with the first of the titles that fits; `None` if there are no values.
fn map(
    app: &App,
    grid: &Grid,
    output: usize,
    titles: &[String; 2],
    area: Rect,
    canvas: &mut Canvas<'_>,
) -> Option<()> {
    let Some(Picture::Map(map)) = sweeps::picture(grid, output) else { return None };
    let axes = grid.plan().axes();
    let (across, up) = (&map.x, &map.y);
    // The line also contains the name of the horizontal axis with its unit, the unit of the vertical axis, brackets and the ends of the
    // frame.
    let taken = across.label.len() + across.unit.name.len() + up.unit.name.len() + 13;
    let titles = titles.iter().map(|it| format!("{it}, up: {}", up.label));
    let titles = titles.chain([format!("up: {}", up.label)]);
    let title = fitting(titles, usize::from(area.width).saturating_sub(taken)).into();
    let (x, y) = cursor_point(app, grid);
    let cursor = column_of(&axes[0], x).zip(column_of(&axes[1], y));
    let map = Map { title, cursor, focused: app.has_focus(RESULTS), ..map };
    let layout = canvas.draw_map(&map, area);
    canvas.plot(&layout, |x, y| {
        Some(Target::Cell(RESULTS, (nearest(&axes[0], x)?, nearest(&axes[1], y)?)))
    });
    Some(())
}

/// Returns the value of a point to draw; NaN if there is none.
fn number(point: grid::Cell) -> f64 {
    point.value().unwrap_or(f64::NAN)
}
