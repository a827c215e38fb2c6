//! The open field of a variable.

use crossterm::event::{KeyCode, KeyEvent};
use tui_input::Input;

use crate::model::units::Bare;
use crate::model::variables::{Kind, VARIABLES};
use crate::tui::app::App;
use crate::tui::dialogs::{Dialog, Picker};
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::run::editor::Field;
use crate::tui::pages::run::steps::Size;
use crate::tui::update::{act, edit};
use crate::tui::widgets::input;

/// Words from which on a list is clearer than going to the next one.
const WORDS_LISTED: usize = 3;

/// Open the selected variable's field with its old value selected, or the list of its words; of two words, the other one is taken.
pub(in crate::tui) fn open(app: &mut App) -> Vec<Effect> {
    let variable = app.editor.variable();
    match &variable.kind {
        Kind::Choice(choice) if choice.words.len() >= WORDS_LISTED => {
            let now = (choice.get)(&app.scene);
            app.dialog = Some(Dialog::Words(Picker::at(now)));
            Vec::new()
        }
        Kind::Choice(_) | Kind::Switch { .. } => edit::step(app, true, Size::Plain),
        Kind::Number(_) => {
            app.editor.field = Some(Field {
                variable: app.editor.selected,
                input: Input::new(variable.show(&app.scene)),
                all_selected: true,
                error: None,
            });
            Vec::new()
        }
    }
}

/// A key while the field is open.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match key.code {
        KeyCode::Esc => {
            app.editor.field = None;
            Vec::new()
        }
        KeyCode::Enter | KeyCode::Down => commit(app, |app| app.editor.move_by(&app.scene, 1)),
        KeyCode::Up => commit(app, |app| app.editor.move_by(&app.scene, -1)),
        KeyCode::Tab => commit(app, |app| {
            act::act(app, Action::FocusNext);
        }),
        KeyCode::BackTab => commit(app, |app| {
            act::act(app, Action::FocusPrevious);
        }),
        _ => {
            if let Some(field) = &mut app.editor.field
                && input::press(&mut field.input, &mut field.all_selected, key)
            {
                field.error = None;
            }
            Vec::new()
        }
    }
}

/// Take the text as the new value and go on; a text that is no value stays, with the reason, and nothing else changes.
fn commit(app: &mut App, then: impl FnOnce(&mut App)) -> Vec<Effect> {
    let Some(field) = app.editor.field.take() else {
        return Vec::new();
    };
    let variable = &VARIABLES[field.variable];
    let text = field.input.value();
    let unchanged = field.all_selected || text.trim() == variable.show(&app.scene);
    let result = if unchanged {
        Ok(Vec::new())
    } else {
        variable
            .parse(&app.scene, text, Bare::Stored)
            .map_err(|error| error.to_string())
            .and_then(|value| edit::set(app, field.variable, value, None))
    };
    match result {
        Ok(effects) => {
            then(app);
            effects
        }
        Err(error) => {
            app.editor.field = Some(Field { error: Some(error), ..field });
            Vec::new()
        }
    }
}
