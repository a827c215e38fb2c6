//! The list of edits, oldest first; Enter goes back (or forth) to the state after one.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::dialogs::Picker;
use crate::tui::dialogs::popup::frame;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::put;

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
    let list = List { count: edits.len() + 1, selected: picker.selected, painted: true };
    list.in_dialog(canvas, inner, app.theme, |canvas, row, index| {
        let label = index.checked_sub(1).map_or("the start", |at| &edits[at].label);
        let (mark, role, undone) = match index.cmp(&app.history.done) {
            std::cmp::Ordering::Less => (' ', Role::Text, ""),
            std::cmp::Ordering::Equal => ('>', Role::Title, ""),
            std::cmp::Ordering::Greater => (' ', Role::Dim, "  (undone)"),
        };
        let line = format!("{mark} {index:>3}  {label}{undone}");
        put(canvas, row, (0, 0), &clip(&line, usize::from(row.width)), app.theme.style(role));
    });
}
