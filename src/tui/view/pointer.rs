//! What is under the mouse: the cells of the screen back to what they show.
//!
//! The geometry is that of the drawing itself: charts are drawn into a buffer that nobody sees, and say where everything lies.

use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::Rect;

use super::text::first_row;
use super::{
    accuracy, charts, comparison, limit, popup, rect, rows, runs, search, side, stability, surface,
    sweep, thesis,
};
use crate::study::limit::Shot;
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::app::editor::Row;
use crate::tui::app::layout::{AccuracyPanes, Area, Body, LimitPanes, Panes, SweepPanes};
use crate::tui::app::quantity::Quantity;
use crate::tui::app::search::Row as SearchRow;
use crate::tui::app::sweep::{Picture, SetupRow};
use crate::tui::chart::Layout;
use crate::tui::keymap::Pane;
use crate::tui::message::Target;

/// What is at a column and a row of the screen; `None` where a click means nothing.
pub fn target(app: &App, at: (u16, u16)) -> Option<Target> {
    let screen = Rect::new(0, 0, app.size.0, app.size.1);
    let unseen = || Buffer::empty(screen);
    let layout = app.layout();
    if layout.body == Body::TooSmall {
        return None;
    }
    if app.dialog.is_some() {
        return in_dialog(app, screen, at);
    }
    if at.1 == layout.title.y {
        return rows::tab_at(app, layout.title.width, at.0).map(Target::Tab);
    }
    if layout.pages.is_some_and(|area| area.y == at.1) {
        return rows::page_at(app, at.0).map(Target::Page);
    }
    match &layout.body {
        Body::Run(panes) => in_run(app, panes, at),
        Body::Explore(panes) => in_sweep(app, panes, at),
        Body::Search(setup, found) => in_search(app, (*setup, *found), at),
        Body::Accuracy(panes) => in_accuracy(app, panes, at, &mut unseen()),
        Body::Stability(area) => stability::target(app, rect(*area), at, &mut unseen()),
        Body::Thesis(area) => thesis::row_at(app, rect(*area), at, &mut unseen()).map(Target::Row),
        Body::Limit(panes) => in_limit(app, panes, at, &mut unseen()),
        // The log has nothing to select: the wheel scrolls it wherever it is.
        Body::TooSmall | Body::Log(_) => None,
    }
}

/// The columns of the plot over time or run time, as it is drawn; `None` where none is.
pub fn plot_columns(app: &App) -> Option<u16> {
    let mut unseen = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    let layout = match app.layout().body {
        Body::Run(panes) => {
            let areas: Vec<Rect> = panes.charts.iter().copied().map(rect).collect();
            charts::render(app, &areas, false, &mut unseen).into_iter().next()
        }
        Body::Accuracy(panes) => accuracy::render(app, &panes, &mut unseen).0,
        _ => None,
    };
    layout.map(|layout| layout.plot.width).filter(|width| *width > 1)
}

/// A row of the list in the dialog on top, or beside the dialog.
fn in_dialog(app: &App, screen: Rect, at: (u16, u16)) -> Option<Target> {
    // Whatever the dialog covers is not this any more.
    let beside = Cell::new("\u{1}");
    let mut unseen = Buffer::filled(screen, beside.clone());
    let rows = popup::render(app, screen, &mut unseen, &mut None);
    if unseen.cell(at).is_none_or(|cell| *cell == beside) {
        return Some(Target::Beside);
    }
    rows?.at(at).map(Target::DialogRow)
}

fn in_accuracy(
    app: &App,
    panes: &AccuracyPanes,
    at: (u16, u16),
    unseen: &mut Buffer,
) -> Option<Target> {
    let (chart, methods) = accuracy::render(app, panes, unseen);
    methods
        .at(at)
        .map(Target::Method)
        .or_else(|| chart.and_then(|layout| along(&layout, at)).map(Target::RunTime))
}

fn in_limit(app: &App, panes: &LimitPanes, at: (u16, u16), unseen: &mut Buffer) -> Option<Target> {
    let hit = |area: Option<Area>| area.map(rect).filter(|area| area.contains(at.into()));
    if let Some(area) = hit(panes.residual) {
        let layout = limit::render(app, area, unseen);
        let shot = layout.and_then(|layout| nearest_shot(app, &layout, at));
        return Some(shot.map_or(Target::Pane(Pane::Residual), Target::Shot));
    }
    if let Some(area) = hit(panes.map) {
        let beside = Target::Pane(Pane::EfficiencyMap);
        let Some(layout) = comparison::map(app, area, unseen) else { return Some(beside) };
        let map = app.comparison().and_then(|found| found.map.as_ref())?;
        if !layout.plot.contains(at.into()) {
            return Some(beside);
        }
        let (x, up) = (at.0 - layout.plot.x, layout.plot.bottom() - 1 - at.1);
        let nearest = |axis: &Axis, value: f64| usize::try_from(axis.nearest(value)).ok();
        let cell = nearest(map.x(), layout.x.value(x)).zip(nearest(map.y(), layout.y.value(up)));
        return Some(cell.map_or(beside, |(x, y)| Target::Efficiency(x, y)));
    }
    hit(panes.comparison).map(|_| Target::Pane(Pane::Comparison))
}

/// The shot that is drawn nearest to a cell of the plot.
fn nearest_shot(app: &App, layout: &Layout, at: (u16, u16)) -> Option<usize> {
    let place = |shot: &Shot| Some((shot.impact_m_s, shot.residual_m_s.unwrap_or(0.0)));
    nearest(layout, at, app.limit.shots().iter().map(place))
}

/// Which of some points of a chart is drawn nearest to a cell of its plot.
fn nearest(
    layout: &Layout,
    at: (u16, u16),
    points: impl Iterator<Item = Option<(f64, f64)>>,
) -> Option<usize> {
    let plot = layout.plot;
    if !plot.contains(at.into()) {
        return None;
    }
    let (across, up) = (f64::from(at.0 - plot.x), f64::from(plot.bottom() - 1 - at.1));
    let away = |(x, y): (f64, f64)| {
        let (x, y) = layout.x.position(x).zip(layout.y.position(y))?;
        // A cell is twice as high as wide.
        Some((x - across).powi(2) + 4.0 * (y - up).powi(2))
    };
    let near = points.enumerate().filter_map(|(index, point)| Some((index, away(point?)?)));
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}

/// The row of a framed list that a cell lies in, counted from its first one shown.
fn row_of(area: Area, at: (u16, u16)) -> Option<usize> {
    let inner = Rect::new(
        area.x + 1,
        area.y + 1,
        area.width.saturating_sub(2),
        area.height.saturating_sub(2),
    );
    inner.contains(at.into()).then(|| usize::from(at.1 - inner.y))
}

fn in_run(app: &App, panes: &Panes, at: (u16, u16)) -> Option<Target> {
    if let Some(area) = panes.variables
        && rect(area).contains(at.into())
    {
        // The lowest row belongs to no variable.
        let height = usize::from(area.height.saturating_sub(3));
        let first = app.editor.first_row(&app.scene, height);
        let rows = app.editor.rows(&app.scene);
        let row =
            row_of(area, at).filter(|row| *row < height).and_then(|row| rows.get(first + row));
        return Some(match row {
            Some(Row::Variable(index)) => Target::Variable(*index),
            Some(Row::Heading(_)) | None => Target::Pane(Pane::Variables),
        });
    }
    let mut unseen = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    if let Some(area) = panes.runs.map(rect).filter(|area| area.contains(at.into())) {
        let rows = runs::render(app, area, false, &mut unseen);
        return Some(rows.at(at).map_or(Target::Pane(Pane::Runs), Target::Run));
    }
    if let Some(area) = panes.events.map(rect).filter(|area| area.contains(at.into())) {
        return side::events(app, area, &mut unseen).at(at).map(Target::Event);
    }
    let areas: Vec<Rect> = panes.charts.iter().copied().map(rect).collect();
    let place = areas.iter().position(|area| area.contains(at.into()))?;
    let layouts = charts::render(app, &areas, false, &mut unseen);
    let chart = if areas.len() == 1 { app.charts.selected } else { place };
    let over_time = app.charts.quantities[chart] != Quantity::MountForce;
    let time = layouts.get(place).filter(|_| over_time).and_then(|layout| along(layout, at));
    Some(time.map_or(Target::Pane(Pane::Charts), |t_s| Target::Time { chart, t_s }))
}

/// The value of a chart's horizontal axis at a cell of its plot.
fn along(layout: &Layout, at: (u16, u16)) -> Option<f64> {
    layout.plot.contains(at.into()).then(|| layout.x.value(at.0 - layout.plot.x))
}

fn in_sweep(app: &App, panes: &SweepPanes, at: (u16, u16)) -> Option<Target> {
    let picture = app.picture();
    if let Some(area) = panes.setup
        && rect(area).contains(at.into())
    {
        let rows = app.setup_rows(picture);
        let here = rows.iter().position(|row| *row == app.setup_row(picture)).unwrap_or(0);
        let height = usize::from(area.height.saturating_sub(2));
        let first =
            if app.pane() == Pane::ExploreSetup { first_row(here, height, rows.len()) } else { 0 };
        let row = row_of(area, at).and_then(|row| rows.get(first + row));
        let row = row.filter(|row| !matches!(row, SetupRow::Heading(_)));
        return Some(row.map_or(Target::Pane(Pane::ExploreSetup), |row| Target::Setup(*row)));
    }
    let panes_of = panes.plots.iter().chain(&panes.scale).chain(&panes.slices);
    if !panes_of.copied().any(|area| rect(area).contains(at.into())) {
        return None;
    }
    let beside = Some(Target::Pane(Pane::Explore));
    let Some(found) = app.sweeping.found(picture) else { return beside };
    let grid = &found.grid;
    let mut unseen = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    let layouts = match picture {
        Picture::Line => sweep::render(app, panes, &mut unseen),
        Picture::Surface => surface::render(app, panes, &mut unseen).into_iter().collect(),
    };
    let Some(layout) = layouts.into_iter().find(|layout| layout.plot.contains(at.into())) else {
        return beside;
    };
    let axes = grid.plan().axes();
    let (x, up) = (at.0 - layout.plot.x, layout.plot.bottom() - 1 - at.1);
    if !grid.is_full() {
        // The nearest dot; on curves only along counts.
        let away = |index: usize| {
            let cells = |value: Option<f64>, cell: u16| {
                value.map_or(0.0, |value| (value - f64::from(cell)).powi(2))
            };
            let along = layout.x.position(grid.coordinate((index, 0), 0));
            let upward = axes.get(1).filter(|_| picture == Picture::Surface);
            let upward = upward.and_then(|_| layout.y.position(grid.coordinate((index, 0), 1)));
            // A cell is twice as high as wide.
            cells(along, x) + 4.0 * cells(upward, up)
        };
        let nearest = (0..grid.counts().0).min_by(|a, b| away(*a).total_cmp(&away(*b)))?;
        return Some(Target::Point((nearest, 0)));
    }
    let nearest = |axis: usize, value: f64| {
        axes.get(axis).and_then(|axis| usize::try_from(axis.nearest(value)).ok())
    };
    let x = nearest(0, layout.x.value(x))?;
    let y = match picture {
        Picture::Line => app.cursor_point(grid).1,
        Picture::Surface => nearest(1, layout.y.value(up))?,
    };
    Some(Target::Point((x, y)))
}

/// The design of a front that is drawn nearest to a cell of its chart.
fn nearest_design(app: &App, (setup, found): (Area, Area), at: (u16, u16)) -> Option<usize> {
    let mut unseen = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    let layout = search::render(app, (rect(setup), rect(found)), &mut unseen, &mut None)?;
    let (_, task) = app.searching.front()?;
    let (across, up) = app.searching.across(task);
    let places = app.searching.designs().into_iter().map(|design| {
        let value = |measure: usize| design.measures.get(measure).copied().flatten();
        value(across).zip(value(up))
    });
    nearest(&layout, at, places)
}

fn in_search(app: &App, (setup, found): (Area, Area), at: (u16, u16)) -> Option<Target> {
    if rect(found).contains(at.into()) {
        let design = nearest_design(app, (setup, found), at);
        return design.map(Target::Design).or(Some(Target::Pane(Pane::Search)));
    }
    if !rect(setup).contains(at.into()) {
        return None;
    }
    let rows = app.search_rows();
    let here = rows.iter().position(|row| *row == app.search_row()).unwrap_or(0);
    let height = usize::from(setup.height.saturating_sub(2));
    let first =
        if app.pane() == Pane::SearchSetup { first_row(here, height, rows.len()) } else { 0 };
    let row = row_of(setup, at).and_then(|row| rows.get(first + row));
    let row = row.filter(|row| !matches!(row, SearchRow::Heading(_)));
    Some(row.map_or(Target::Pane(Pane::SearchSetup), |row| Target::SearchSetup(*row)))
}
