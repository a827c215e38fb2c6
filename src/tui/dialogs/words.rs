//! The words a variable can be, one a row; below them what the variable means, or why the selected word is refused here.

use ratatui::layout::Rect;

use crate::model::variables::{self, Value};
use crate::tui::app::App;
use crate::tui::dialogs::Picker;
use crate::tui::dialogs::popup::frame;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::{put, put_lines, wrapped};

/// Columns of the dialog.
const WIDTH: u16 = 58;
/// Rows for the meaning below the words.
const NOTE_ROWS: u16 = 3;

/// Draw it.
pub(in crate::tui) fn render(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let variable = app.editor.variable();
    let words = variable.words();
    let count = u16::try_from(words.len()).unwrap_or(u16::MAX);
    let size = (WIDTH, count.saturating_add(NOTE_ROWS + 3));
    let inner = frame(app, screen, size, (variable.symbol, "Enter takes it"), canvas);
    let list = Rect { height: inner.height.saturating_sub(NOTE_ROWS + 1).min(count), ..inner };
    let now = variable.value(&app.scene);
    let rows = List { count: words.len(), selected: picker.selected, painted: true };
    rows.in_dialog(canvas, list, app.theme, |canvas, row, index| {
        let is_now = now == Value::Word(words[index]);
        let mark = if is_now { "> " } else { "  " };
        let role = if refusal(app, words[index]).is_some() { Role::Dim } else { Role::Text };
        put(canvas, row, (0, 0), mark, app.theme.style(Role::Title));
        let end = put(canvas, row, (2, 0), words[index], app.theme.style(role));
        if is_now {
            put(canvas, row, (end + 2, 0), "now", app.theme.style(Role::Dim));
        }
    });
    let refused = words.get(picker.selected).and_then(|word| refusal(app, word));
    let (text, role) = match refused {
        Some(text) => (text, Role::Warning),
        None => (variable.meaning.to_owned(), Role::Dim),
    };
    put_lines(canvas, inner, list.height + 1, app.theme, wrapped(&text, inner.width, role));
}

/// Why the scene makes no sense with this word; `None` where it does.
fn refusal(app: &App, word: &'static str) -> Option<String> {
    let mut scene = (*app.scene).clone();
    let set = app.editor.variable().set(&mut scene, Value::Word(word));
    set.and_then(|()| variables::validate(&scene)).err().map(|error| error.to_string())
}
