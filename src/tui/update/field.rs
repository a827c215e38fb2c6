//! The field of a row of a list or a form: opened, typed into, taken or left.

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::app::App;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages;
use crate::tui::update::act;
use crate::tui::widgets::input::Field;

/// Open the field of a row, its old text selected.
pub(in crate::tui) fn open(app: &mut App, row: usize) -> Vec<Effect> {
    let text = pages::of(app.tab).text(app, row);
    app.field = Some(Field::new(row, text));
    Vec::new()
}

/// A key while the field is open.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    let then = match key.code {
        KeyCode::Esc => {
            app.field = None;
            return Vec::new();
        }
        KeyCode::Enter => pages::of(app.tab).after_enter(),
        KeyCode::Down => Some(Action::Down),
        KeyCode::Up => Some(Action::Up),
        KeyCode::Tab => Some(Action::FocusNext),
        KeyCode::BackTab => Some(Action::FocusPrevious),
        _ => {
            if let Some(field) = &mut app.field {
                field.press(key);
            }
            return Vec::new();
        }
    };
    let mut effects = commit(app);
    if let Some(action) = then.filter(|_| app.field.is_none()) {
        effects.extend(act::act(app, action));
    }
    effects
}

/// Take the text; one that is refused stays, with the reason, and nothing else changes.
fn commit(app: &mut App) -> Vec<Effect> {
    let Some(mut field) = app.field.take() else { return Vec::new() };
    let page = pages::of(app.tab);
    let text = field.value().trim().to_owned();
    if field.all_selected || !page.is_new(app, field.row, &text) {
        return Vec::new();
    }
    page.take(app, field.row, &text).unwrap_or_else(|error| {
        field.error = Some(error);
        app.field = Some(field);
        Vec::new()
    })
}
