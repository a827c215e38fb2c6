//! Where the panes of the Run tab stand.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{ROOMY, WIDE, split_bottom, split_left};
use crate::tui::keymap::Pane;
use crate::tui::pages::run::{CHARTS, RUNS};

/// From this width on: events and energy beside the charts.
const WIDEST: u16 = 160;
/// From this height on: the table of runs is always there.
const TALL: u16 = 34;

/// The panes of the Run tab.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Panes {
    /// The list of variables.
    pub variables: Option<Rect>,
    /// One chart (the selected one) or all three, from top to bottom.
    pub charts: Vec<Rect>,
    /// The table of runs.
    pub runs: Option<Rect>,
    /// The events of the current run.
    pub events: Option<Rect>,
    /// Its energy ledger.
    pub ledger: Option<Rect>,
    /// The drawing of the mechanism.
    pub mechanism: Option<Rect>,
}

/// Where they stand on the screen as it is.
pub(crate) fn panes(app: &App, body: Rect) -> Panes {
    let (focus, pins) = (app.pane(), app.pins.len());
    if app.is_full() {
        full(body, focus)
    } else if body.width < WIDE {
        narrow(body, app.size.1, focus, pins)
    } else {
        wide(body, app.size.1, focus, pins)
    }
}

/// Rows of the list of variables.
pub(crate) fn variable_rows(app: &App) -> usize {
    let variables = app.layout().body.and_then(|body| panes(app, body).variables);
    variables.map_or(10, |area| usize::from(area.height.saturating_sub(3)))
}

fn full(body: Rect, focus: Pane) -> Panes {
    match focus {
        CHARTS => Panes { charts: stacked(body), ..Panes::default() },
        RUNS => Panes { runs: Some(body), ..Panes::default() },
        _ => Panes { variables: Some(body), ..Panes::default() },
    }
}

fn narrow(body: Rect, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, right) = split_left(body, 31);
    let mut panes = Panes { variables: Some(left), ..Panes::default() };
    if height >= TALL {
        let (top, bottom) = split_bottom(right, runs_height(pins));
        panes.runs = Some(bottom);
        panes.charts = if top.height >= 36 { stacked(top) } else { vec![top] };
    } else if focus == RUNS {
        panes.runs = Some(right);
    } else {
        panes.charts = vec![right];
    }
    panes
}

fn wide(body: Rect, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, mut right) = split_left(body, if body.width >= ROOMY { 52 } else { 48 });
    let mut panes = Panes::default();
    if height >= TALL || focus == RUNS {
        let wanted = runs_height(pins).min(body.height / 2);
        let (top, bottom) = split_bottom(left, wanted);
        panes.variables = Some(top);
        panes.runs = Some(bottom);
    } else {
        panes.variables = Some(left);
    }
    if body.width >= WIDEST {
        let (middle, column) = split_left(right, right.width - 42);
        right = middle;
        let (events, ledger) = split_bottom(column, 14.min(column.height / 2));
        panes.events = Some(events);
        panes.ledger = Some(ledger);
    }
    if right.height >= DRAWN {
        let (charts, drawing) = split_bottom(right, DRAWING_ROWS);
        right = charts;
        panes.mechanism = Some(drawing);
    }
    panes.charts = stacked(right);
    panes
}

/// Rows of the drawing of the mechanism, frame included, and from what height on it stands below the charts.
const DRAWING_ROWS: u16 = 5;
const DRAWN: u16 = 19;

/// Header, the current run, the pins, and what differs from the first pin.
fn runs_height(pins: usize) -> u16 {
    let rows = u16::try_from(pins.min(8)).unwrap_or(8);
    if rows == 0 { 6 } else { 7 + rows }
}

/// As many of the three charts as can be read: six rows each, and two more for the common axis.
fn stacked(area: Rect) -> Vec<Rect> {
    let count = match area.height {
        0..=13 => 1,
        14..=19 => 2,
        _ => 3,
    };
    // Short charts share the time axis of the lowest, which needs two rows more for it.
    let extra = if count > 1 && area.height / count < 11 { 2 } else { 0 };
    let each = (area.height - extra) / count;
    let mut areas = Vec::new();
    let mut y = area.y;
    for index in 0..count {
        let rest = area.y + area.height - y;
        let height = if index + 1 == count { rest } else { each };
        areas.push(Rect { y, height, ..area });
        y += height;
    }
    areas
}
