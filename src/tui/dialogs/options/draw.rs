//! The options menu: a line each, with its present value; below them what the selected one is about.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::status::wrap;
use crate::tui::dialogs::Picker;
use crate::tui::dialogs::options::OptionRow;
use crate::tui::dialogs::popup::frame;
use crate::tui::message::Target;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{paint_row, put};

/// Where the values begin.
const VALUE: u16 = 18;

/// Draw it.
pub(in crate::tui) fn render(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let count = OptionRow::ALL.len();
    let rows = u16::try_from(count).unwrap_or(u16::MAX);
    let inner = frame(app, screen, (58, rows + 6), ("Options", "h/l changes"), canvas);
    for (at, row) in (0..inner.height).zip(OptionRow::ALL) {
        let (name, value) = row.shown(app);
        put(canvas, inner, (1, at), name, app.theme.style(Role::Text));
        put(canvas, inner, (VALUE, at), &format!("< {value} >"), app.theme.style(Role::Title));
        if usize::from(at) == picker.selected {
            paint_row(canvas, inner, at, app.theme.style(Role::Selection));
        }
    }
    let meaning = OptionRow::ALL.get(picker.selected).map_or("", |row| row.meaning());
    let lines = wrap(meaning, usize::from(inner.width.saturating_sub(2)));
    for (row, line) in (rows + 1..inner.height).zip(lines) {
        put(canvas, inner, (1, row), &line, app.theme.style(Role::Dim));
    }
    let area = Rect { height: rows.min(inner.height), ..inner };
    canvas.rows(area, (0, count), |row| Some(Target::DialogRow(row)));
}
