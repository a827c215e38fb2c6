//! The Log tab.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::put;

/// Draw the tab.
pub(in crate::tui) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
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
    let inner = pane.render(area, canvas, app.theme);
    for (row, (role, text)) in inner.rows().zip(lines.iter().skip(first)) {
        let column = if *role == Role::Title { 1 } else { 3 };
        put(canvas, row, (column, 0), text, app.theme.style(*role));
    }
}
