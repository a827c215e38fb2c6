//! Keys in the dialogs that are lists: help, palette, presets, edits, words, options.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::model::variables::Value;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::options::{self, OptionRow};
use crate::tui::dialogs::{self, Dialog, List, Picker, ask, curve, export, palette, presets};
use crate::tui::message::{Effect, Target};
use crate::tui::update::{act, edit};
use crate::tui::widgets::input::TextField;

/// A key while a dialog is open.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match app.dialog.take() {
        Some(Dialog::List(list, picker)) => in_list(app, list, picker, key),
        Some(Dialog::Ask(state)) => ask::press(app, state, key),
        Some(Dialog::Export(state)) => export::press(app, *state, key),
        None => Vec::new(),
    }
}

/// A click while a dialog is open: it selects a row, does what the row is for where it was selected, or closes a list.
pub(in crate::tui) fn click(app: &mut App, target: Target) -> Vec<Effect> {
    match (&mut app.dialog, target) {
        (Some(Dialog::List(_, picker)), Target::DialogRow(row)) => {
            if picker.selected == row {
                return press(app, KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
            }
            picker.selected = row;
            Vec::new()
        }
        (Some(Dialog::List(..)), Target::Beside) => {
            app.dialog = None;
            Vec::new()
        }
        (Some(Dialog::Export(_)), Target::DialogRow(row)) => export::click(app, row),
        // What has been typed is not thrown away by a click.
        _ => Vec::new(),
    }
}

/// How many rows a list has.
fn count(app: &App, list: List, typed: &str) -> usize {
    match list {
        List::Help => dialogs::help_rows(app, typed).len(),
        List::Palette => app.palette(typed).len(),
        List::Presets => dialogs::preset_rows(&app.presets, typed).len(),
        List::History => app.history.edits.len() + 1,
        List::Words => app.editor.variable().words().len(),
        List::Options => OptionRow::ALL.len(),
    }
}

/// Keys all lists share; Enter and Space mean what the list is for.
fn in_list(app: &mut App, list: List, mut picker: Picker, key: KeyEvent) -> Vec<Effect> {
    let last = count(app, list, picker.filter.value()).saturating_sub(1);
    let letter = !picker.typing && !key.modifiers.contains(KeyModifiers::CONTROL);
    if let Some(by) = moves(key, letter) {
        picker.selected = picker.selected.saturating_add_signed(by).min(last);
        app.dialog = Some(Dialog::List(list, picker));
        return Vec::new();
    }
    let mut effects = Vec::new();
    match (key.code, list) {
        (KeyCode::Esc, List::Palette) => return effects,
        (KeyCode::Esc, _) if picker.typing => picker = Picker::default(),
        (KeyCode::Esc, _) => return effects,
        (KeyCode::Char('q'), _) if letter => return effects,
        (KeyCode::Char('?'), List::Help) | (KeyCode::Char('o'), List::Options) if letter => {
            return effects;
        }
        (KeyCode::Left | KeyCode::Char('h'), List::Options) => {
            effects = options::change(app, OptionRow::ALL[picker.selected.min(last)], false);
        }
        (KeyCode::Enter | KeyCode::Right | KeyCode::Char('l' | ' '), List::Options) => {
            effects = options::change(app, OptionRow::ALL[picker.selected.min(last)], true);
        }
        (KeyCode::Enter, _) => return chosen(app, list, &picker),
        (KeyCode::Char('/'), List::Help | List::Palette | List::Presets) if letter => {
            picker.typing = true;
        }
        (KeyCode::Char(' '), List::Presets) if letter => effects = presets::pin(app, &picker),
        _ if picker.typing && picker.filter.press(key) => picker.selected = 0,
        _ => {}
    }
    app.dialog = Some(Dialog::List(list, picker));
    effects
}

/// How far a key moves the selection: arrows always, letters while none go into the filter.
fn moves(key: KeyEvent, letter: bool) -> Option<isize> {
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    match key.code {
        KeyCode::Up => Some(-1),
        KeyCode::Down => Some(1),
        KeyCode::PageUp => Some(-10),
        KeyCode::PageDown => Some(10),
        KeyCode::Char('p' | 'k') if control => Some(-1),
        KeyCode::Char('n' | 'j') if control => Some(1),
        KeyCode::Char('k') if letter => Some(-1),
        KeyCode::Char('j') if letter => Some(1),
        KeyCode::Home | KeyCode::Char('g') if letter => Some(isize::MIN / 2),
        KeyCode::End | KeyCode::Char('G') if letter => Some(isize::MAX / 2),
        _ => None,
    }
}

/// After text came into a dialog: what is selected may not be there any more.
pub(in crate::tui) fn after_typing(app: &mut App) {
    match &mut app.dialog {
        Some(Dialog::List(_, picker)) => picker.selected = 0,
        Some(Dialog::Ask(ask)) => ask.question = false,
        Some(Dialog::Export(export)) => {
            export.question = false;
            export.error = None;
            export.completions.clear();
        }
        None => {}
    }
}

fn chosen(app: &mut App, list: List, picker: &Picker) -> Vec<Effect> {
    match list {
        List::Help => {
            let rows = dialogs::help_rows(app, picker.filter.value());
            let action = rows.get(picker.selected).map(|row| row.action);
            action.map_or_else(Vec::new, |action| act::act(app, action))
        }
        List::Palette => palette::chosen(app, picker),
        List::Presets => presets::chosen(app, picker),
        List::History => edit::travel(app, picker.selected),
        List::Words => take_word(app, picker),
        List::Options => Vec::new(),
    }
}

/// Set the selected variable to a word; one that is refused leaves the list open, with the reason.
fn take_word(app: &mut App, picker: &Picker) -> Vec<Effect> {
    let Some(word) = app.editor.variable().words().get(picker.selected) else {
        return Vec::new();
    };
    match edit::set(app, app.editor.selected, Value::Word(word), None) {
        Ok(effects) => {
            curve::ask(app, word);
            effects
        }
        Err(error) => {
            app.say(Severity::Error, error);
            app.dialog = Some(Dialog::List(List::Words, picker.clone()));
            Vec::new()
        }
    }
}

/// Names that complete a path: of one it is taken, of several what they have in common, and the list.
pub(in crate::tui) fn complete(app: &mut App, names: Vec<String>) {
    let common = common_start(&names);
    let Some(dialog) = &mut app.dialog else { return };
    let Some(common) = common else {
        let error = Some("no file or directory begins like this".to_owned());
        match dialog {
            Dialog::Export(export) => export.error = error,
            Dialog::Ask(ask) => ask.text.error = error,
            Dialog::List(..) => {}
        }
        return;
    };
    match dialog {
        Dialog::Export(export) => {
            export.path = TextField::new(common);
            export.completions = if names.len() > 1 { names } else { Vec::new() };
        }
        Dialog::Ask(ask) => ask.text = TextField::new(common),
        Dialog::List(..) => {}
    }
}

fn common_start(names: &[String]) -> Option<String> {
    let first = names.first()?;
    let mut length = first.len();
    for name in names {
        let same = first
            .char_indices()
            .zip(name.chars())
            .take_while(|((_, a), b)| a == b)
            .map(|((at, a), _)| at + a.len_utf8())
            .last()
            .unwrap_or(0);
        length = length.min(same);
    }
    Some(first[..length].to_owned())
}
