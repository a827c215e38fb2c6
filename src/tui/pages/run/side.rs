//! Beside the charts on a very wide screen: the events and the energy ledger of the current run.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::message::Target;
use crate::tui::pages::log::state::{energy_lines, event_lines};
use crate::tui::pages::run::CHARTS;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{paint_row, put};

/// The events.
pub(in crate::tui) fn events(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new("Events").right("n N").render(area, canvas, app.theme);
    let Some(shown) = &app.shown else { return };
    let lines = event_lines(&shown.run);
    if lines.is_empty() {
        put(canvas, inner, (1, 0), "none", app.theme.style(Role::Dim));
    }
    for (row, (line, event)) in (0..inner.height).zip(lines.iter().zip(&shown.run.events)) {
        put(canvas, inner, (1, row), line, app.theme.style(Role::Text));
        if app.charts.cursor_s.is_some_and(|t_s| t_s.to_bits() == event.t_s.to_bits()) {
            paint_row(canvas, inner, row, app.theme.style(Role::Selection));
        }
    }
    let chart = app.charts.selected;
    canvas.rows(inner, (0, lines.len()), |event| {
        let value = shown.run.events.get(event)?.t_s;
        Some(Target::Value { pane: CHARTS, chart, value })
    });
}

/// The energy ledger.
pub(in crate::tui) fn ledger(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new("Energy").render(area, canvas, app.theme);
    let Some(shown) = &app.shown else {
        return;
    };
    for (row, line) in (0..inner.height).zip(energy_lines(&shown.run.ledger)) {
        put(canvas, inner, (1, row), &line, app.theme.style(Role::Text));
    }
}
