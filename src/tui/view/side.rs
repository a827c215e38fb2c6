//! Beside the charts on a very wide screen: the events and the energy ledger of the current run.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::text::{Rows, paint_row, put};
use crate::tui::app::App;
use crate::tui::app::log::{energy_lines, event_lines};
use crate::tui::theme::{PaneFrame, Role};

/// The events; gives where they stand.
pub(super) fn events(app: &App, area: Rect, buffer: &mut Buffer) -> Rows {
    let inner = PaneFrame::new("Events").right("n N").render(area, buffer, app.theme);
    let Some(shown) = &app.shown else {
        return Rows { area: inner, first: 0, count: 0 };
    };
    let lines = event_lines(&shown.run);
    if lines.is_empty() {
        put(buffer, inner, (1, 0), "none", app.theme.style(Role::Dim));
    }
    for (row, (line, event)) in (0..inner.height).zip(lines.iter().zip(&shown.run.events)) {
        put(buffer, inner, (1, row), line, app.theme.style(Role::Text));
        if app.charts.cursor_s.is_some_and(|t_s| t_s.to_bits() == event.t_s.to_bits()) {
            paint_row(buffer, inner, row, app.theme.style(Role::Selection));
        }
    }
    Rows { area: inner, first: 0, count: lines.len() }
}

/// The energy ledger.
pub(super) fn ledger(app: &App, area: Rect, buffer: &mut Buffer) {
    let inner = PaneFrame::new("Energy").render(area, buffer, app.theme);
    let Some(shown) = &app.shown else {
        return;
    };
    for (row, line) in (0..inner.height).zip(energy_lines(&shown.run.ledger)) {
        put(buffer, inner, (1, row), &line, app.theme.style(Role::Text));
    }
}
