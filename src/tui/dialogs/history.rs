//! The list of edits, oldest first; Enter goes back (or forth) to the state after one.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::dialogs::Picker;
use crate::tui::dialogs::popup::frame;
use crate::tui::message::Target;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{first_row, paint_row, put};

/// Draw it.
pub(in crate::tui) fn render(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let edits = &app.history.edits;
    let height = u16::try_from(edits.len() + 3).unwrap_or(u16::MAX);
    let inner = frame(
        app,
        screen,
        (70, height.max(6)),
        ("Edits of this session", "Enter goes there"),
        canvas,
    );
    let first = first_row(picker.selected, usize::from(inner.height), edits.len() + 1);
    for (row, index) in (0..inner.height).zip(first..=edits.len()) {
        let text = match index.checked_sub(1) {
            None => "the start".to_owned(),
            Some(at) => edits[at].label.clone(),
        };
        let (mark, role) = match index.cmp(&app.history.done) {
            std::cmp::Ordering::Less => (' ', Role::Text),
            std::cmp::Ordering::Equal => ('>', Role::Title),
            std::cmp::Ordering::Greater => (' ', Role::Dim),
        };
        let undone = if index > app.history.done { "  (undone)" } else { "" };
        let line = format!("{mark} {index:>3}  {text}{undone}");
        let line = clip(&line, usize::from(inner.width));
        put(canvas, inner, (0, row), &line, app.theme.style(role));
        if index == picker.selected {
            paint_row(canvas, inner, row, app.theme.style(Role::Selection));
        }
    }
    canvas.rows(inner, (first, edits.len() + 1), |row| Some(Target::DialogRow(row)));
}
