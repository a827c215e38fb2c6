//! The options menu: a line each, with its present value; below them what the selected one is about.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::popup::frame;
use super::text::{Rows, paint_row, put};
use crate::tui::app::App;
use crate::tui::app::dialog::Picker;
use crate::tui::app::options::OptionRow;
use crate::tui::app::status::wrap;
use crate::tui::theme::Role;

/// Where the values begin.
const VALUE: u16 = 18;

/// Draw it.
pub(super) fn render(app: &App, picker: &Picker, screen: Rect, buffer: &mut Buffer) -> Rows {
    let count = OptionRow::ALL.len();
    let rows = u16::try_from(count).unwrap_or(u16::MAX);
    let inner = frame(app, screen, (58, rows + 6), ("Options", "h/l changes"), buffer);
    for (at, row) in (0..inner.height).zip(OptionRow::ALL) {
        let (name, value) = row.shown(app);
        put(buffer, inner, (1, at), name, app.theme.style(Role::Text));
        put(buffer, inner, (VALUE, at), &format!("< {value} >"), app.theme.style(Role::Title));
        if usize::from(at) == picker.selected {
            paint_row(buffer, inner, at, app.theme.style(Role::Selection));
        }
    }
    let meaning = OptionRow::ALL.get(picker.selected).map_or("", |row| row.meaning());
    let lines = wrap(meaning, usize::from(inner.width.saturating_sub(2)));
    for (row, line) in (rows + 1..inner.height).zip(lines) {
        put(buffer, inner, (1, row), &line, app.theme.style(Role::Dim));
    }
    let area = Rect { height: rows.min(inner.height), ..inner };
    Rows { area, first: 0, count }
}
