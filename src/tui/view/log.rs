//! The Log tab.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::text::put;
use crate::tui::app::App;
use crate::tui::app::log::LineKind;
use crate::tui::theme::{PaneFrame, Role};

/// Draw the tab.
pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let lines = app.log_lines(usize::from(area.width));
    let height = usize::from(area.height.saturating_sub(2));
    let first = app.log_scroll.min(lines.len().saturating_sub(height));
    let end = (first + height).min(lines.len());
    let counter = if lines.len() > height {
        format!("{}-{}/{}", first + 1, end, lines.len())
    } else {
        String::new()
    };
    let pane = PaneFrame::new("Log of this run and this session")
        .right(counter)
        .focused(app.dialog.is_none());
    let inner = pane.render(area, buffer, app.theme);
    for (row, line) in (0..inner.height).zip(lines.iter().skip(first)) {
        let role = match line.kind {
            LineKind::Heading => Role::Title,
            LineKind::Text => Role::Text,
            LineKind::Dim => Role::Dim,
            LineKind::Warning => Role::Warning,
            LineKind::Error => Role::Error,
        };
        let column = if line.kind == LineKind::Heading { 1 } else { 3 };
        put(buffer, inner, (column, row), &line.text, app.theme.style(role));
    }
}
