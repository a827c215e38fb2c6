//! The Sweep tab: an output, or two, over one variable, with a curve for each value of a second one; what has no value is a
//! letter on the axis, never a number.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::report::figures::axis_of;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::{Cell, Grid};
use crate::tui::app::App;
use crate::tui::app::status::wrap;
use crate::tui::chart::{
    self, Chart, Curve, Draw, Emphasis, Layout, MARKERS, Scale, Unit, ViewRange,
};
use crate::tui::message::Target;
use crate::tui::pages::explore::RESULTS;
use crate::tui::pages::explore::layout::SweepPanes;
use crate::tui::pages::explore::plan::PictureSweep;
use crate::tui::pages::explore::state::{Found, Picture, no_value};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, put, put_centred};

/// Draw the charts.
pub(in crate::tui) fn render(app: &App, panes: &SweepPanes, canvas: &mut Canvas<'_>) {
    panes.plots.iter().for_each(|area| canvas.pane(*area, RESULTS));
    let picture = Picture::Line;
    let Some(found) = app.pages.explore.found(picture) else {
        if let Some(area) = panes.plots.first() {
            nothing(app, "Curves", *area, canvas);
        }
        return;
    };
    let outputs = found.grid.plan().outputs().len();
    let (shown, _) = app.shown_output(&found.grid);
    for (place, area) in panes.plots.iter().enumerate() {
        // The shown output first, then the ones after it.
        let output = (shown + place) % outputs;
        if place > 0 && place >= outputs {
            nothing(app, "", *area, canvas);
            continue;
        }
        curves(app, found, output, place == 0, *area, canvas);
    }
}

/// A pane that has nothing to show yet.
pub(in crate::tui) fn nothing(app: &App, title: &str, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new(title.to_owned()).render(area, canvas, app.theme);
    let text = match (app.jobs.running::<PictureSweep>(), &app.pages.explore.problem) {
        (Some(_), _) => "sweeping the first points",
        (None, Some(_)) => "see the message below",
        (None, None) => "no results yet: press r",
    };
    put_centred(canvas, inner, text, app.theme.style(Role::Dim));
}

/// An axis of the sweep of which a part is in view.
fn zoomed_axis(axis: &Axis, view: ViewRange) -> chart::Axis<'static> {
    let unit = axis.variable().unit().trim_matches('-');
    chart::Axis { view, ..axis_of(axis) }.unit(Unit::with_prefix(view.size(), unit))
}

/// The scale of values on the screen.
pub(in crate::tui) fn value_scale(app: &App) -> Scale {
    if app.pages.explore.log_values { Scale::Log10 } else { Scale::Linear }
}

/// The number of a point to draw; NaN where there is none.
fn drawn(grid: &Grid, (x, y): (usize, usize), output: usize) -> f64 {
    match grid.cell(x, y, output) {
        Cell::Value(value) => value,
        Cell::Outcome(_) | Cell::Waiting => f64::NAN,
    }
}

fn at(axis: &Axis, index: usize) -> f64 {
    axis.value(u64::try_from(index).unwrap_or(u64::MAX))
}

fn curves(
    app: &App,
    found: &Found,
    output: usize,
    is_first: bool,
    area: Rect,
    canvas: &mut Canvas<'_>,
) {
    let grid = &found.grid;
    let column = grid.plan().outputs()[output];
    let old = app.sweep_is_old(Picture::Line) && app.jobs.running::<PictureSweep>().is_none();
    let axes = grid.plan().axes();
    let (along, repeats) = grid.counts();
    let scale = value_scale(app);
    let line = |y: usize| -> Vec<(f64, f64)> {
        let point = |x: usize| (grid.coordinate((x, y), 0), drawn(grid, (x, y), output));
        if grid.is_full() {
            return (0..along).map(point).collect();
        }
        // Dots: the points of a design are no neighbours.
        (0..along).flat_map(|x| [point(x), (f64::NAN, f64::NAN)]).collect()
    };
    let lines: Vec<Vec<(f64, f64)>> = (0..repeats).map(line).collect();
    let values = lines.iter().flatten().map(|point| point.1);
    let title = column.title() + if old { ", of another scene" } else { "" };
    let Some(y) = chart::Axis::fitted("", column.unit(), scale, values) else {
        return nothing_exists(app, &title, grid, output, area, canvas);
    };
    let (x, selected) = app.cursor_point(grid);
    let named = axes.get(1).filter(|_| grid.is_full());
    let curves = lines.iter().enumerate().map(|(index, points)| {
        let name = named.map_or_else(String::new, |axis| {
            // The first of the family also says what is repeated.
            let value = significant(at(axis, index), 3);
            if index == 0 { format!("{}={value}", axis.symbol()) } else { value }
        });
        let emphasis = match (old, index == selected) {
            (true, _) => Emphasis::Stale,
            (false, true) => Emphasis::Selected,
            (false, false) => Emphasis::Normal,
        };
        let marker = MARKERS[index % MARKERS.len()];
        Curve::new(marker, name, points).colour(index).emphasis(emphasis)
    });
    let along_axis = match app.pages.explore.zoomed {
        Some(view) => zoomed_axis(&axes[0], view),
        None => axis_of(&axes[0]),
    };
    let chart = Chart {
        crosshair: Some(grid.coordinate((x, selected), 0)),
        focused: is_first && app.has_focus(RESULTS),
        ..Chart::new(title, along_axis, y, curves.collect())
    };
    let layout = chart.render(area, canvas, app.theme);
    marks(app, grid, output, &layout, canvas);
    if grid.is_full() {
        canvas.plot(&layout, |x, _| {
            Some(Target::Cell(RESULTS, (usize::try_from(axes[0].nearest(x)).ok()?, selected)))
        });
    } else {
        canvas.plot(&layout, |x, _| nearest_point(grid, &layout, x));
    }
}

/// The point of a design whose variable along is drawn nearest to a value.
fn nearest_point(grid: &Grid, layout: &Layout, x: f64) -> Option<Target> {
    let here = layout.x.position(x)?;
    let away = |index: usize| {
        let there = layout.x.position(grid.coordinate((index, 0), 0));
        there.map_or(f64::INFINITY, |there| (there - here).abs())
    };
    let nearest = (0..grid.counts().0).min_by(|a, b| away(*a).total_cmp(&away(*b)))?;
    Some(Target::Cell(RESULTS, (nearest, 0)))
}

/// A letter at the foot of the plot wherever the selected curve has a gap.
fn marks(app: &App, grid: &Grid, output: usize, layout: &Layout, canvas: &mut Canvas<'_>) {
    let (along, _) = grid.counts();
    let (_, selected) = app.cursor_point(grid);
    for x in 0..along {
        let gap = match grid.cell(x, selected, output) {
            Cell::Outcome(outcome) => Some(outcome),
            Cell::Value(_) | Cell::Waiting => None,
        };
        let Some((outcome, cell)) = gap.zip(layout.x.cell(grid.coordinate((x, selected), 0)))
        else {
            continue;
        };
        let place = (cell, layout.plot.height.saturating_sub(1));
        let letter = outcome.letter().to_string();
        put(canvas, layout.plot, place, &letter, app.theme.style(Role::Warning));
    }
}

/// No point of the sweep has this output: say why, and what to do.
pub(in crate::tui) fn nothing_exists(
    app: &App,
    title: &str,
    grid: &Grid,
    output: usize,
    area: Rect,
    canvas: &mut Canvas<'_>,
) {
    let inner = PaneFrame::new(title.to_owned()).render(area, canvas, app.theme);
    let room = usize::from(inner.width.saturating_sub(2)).max(8);
    let texts = no_value(grid, output);
    let said: Vec<(bool, String)> = texts
        .iter()
        .enumerate()
        .flat_map(|(at, text)| wrap(text, room).into_iter().map(move |line| (at == 0, line)))
        .collect();
    let rows = u16::try_from(said.len()).unwrap_or(u16::MAX);
    let top = inner.height.saturating_sub(rows) / 2;
    for (row, (is_case, text)) in (top..inner.height).zip(&said) {
        let column = inner.width.saturating_sub(columns(text)) / 2;
        let role = if *is_case { Role::Text } else { Role::Dim };
        put(canvas, inner, (column, row), text, app.theme.style(role));
    }
}
