//! The open field of a variable.

use crossterm::event::KeyEvent;

use crate::model::units::Bare;
use crate::model::variables::{Kind, VARIABLES};
use crate::tui::app::App;
use crate::tui::dialogs::List;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::run::steps::Size;
use crate::tui::update::{act, edit};
use crate::tui::widgets::input::{Field, Typed};

/// Words from which on a list is clearer than going to the next one.
const WORDS_LISTED: usize = 3;

/// Open the selected variable's field with its old value selected, or the list of its words; of two words, the other one is taken.
pub(in crate::tui) fn open(app: &mut App) -> Vec<Effect> {
    let variable = app.editor.variable();
    match &variable.kind {
        Kind::Choice(choice) if choice.words.len() >= WORDS_LISTED => {
            let now = (choice.get)(&app.scene);
            app.dialog = Some(List::Words.at(now));
            Vec::new()
        }
        Kind::Choice(_) | Kind::Switch { .. } => edit::step(app, true, Size::Plain),
        Kind::Number(_) => {
            let text = variable.show(&app.scene);
            app.editor.field = Some(Field::new(app.editor.selected, text));
            Vec::new()
        }
    }
}

/// A key while the field is open.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    let Some(field) = &mut app.editor.field else { return Vec::new() };
    match field.typed(key, 1) {
        Typed::Nothing => Vec::new(),
        Typed::Close => {
            app.editor.field = None;
            Vec::new()
        }
        Typed::Commit(by) => commit(app, |app| app.editor.move_by(&app.scene, by)),
        Typed::Leave(forward) => commit(app, |app| {
            act::act(app, if forward { Action::FocusNext } else { Action::FocusPrevious });
        }),
    }
}

/// Take the text as the new value and go on; a text that is no value stays, with the reason, and nothing else changes.
fn commit(app: &mut App, then: impl FnOnce(&mut App)) -> Vec<Effect> {
    let Some(mut field) = app.editor.field.take() else { return Vec::new() };
    let variable = &VARIABLES[field.row];
    let text = field.value();
    let unchanged = field.all_selected || text.trim() == variable.show(&app.scene);
    let result = if unchanged {
        Ok(Vec::new())
    } else {
        variable
            .parse(&app.scene, text, Bare::Stored)
            .map_err(|error| error.to_string())
            .and_then(|value| edit::set(app, field.row, value, None))
    };
    match result {
        Ok(effects) => {
            then(app);
            effects
        }
        Err(error) => {
            field.error = Some(error);
            app.editor.field = Some(field);
            Vec::new()
        }
    }
}
