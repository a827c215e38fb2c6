//! Keys in the dialogs that are lists: help, palette, presets, words, options.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::model::variables::{self, Value};
use crate::tui::dialogs::options::{self, OptionRow};
use crate::tui::dialogs::{self, Dialog, List, Picker, ask, frame, palette, presets};
use crate::tui::prelude::*;
use crate::tui::update::{act, edit};
use crate::tui::widgets::RowList;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::wrapped;

pub(crate) fn press(app: &mut App, key: KeyEvent) {
    let types = app.dialog.as_mut().is_some_and(|dialog| dialog.field_mut().is_some());
    let is_text = matches!(key.code, KeyCode::Char(_))
        && !key.modifiers.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT);
    let key = if types && is_text { key } else { app.keymap.original(key) };
    match app.dialog.take() {
        Some(Dialog::List(list, picker)) => in_list(app, list, picker, key),
        Some(Dialog::Ask(state)) => ask::press(app, *state, key),
        None => {}
    }
}

/// A click while a dialog is open: it selects a row, does what the row is for where it was selected, or closes a list.
pub(crate) fn click(app: &mut App, target: Target) {
    match (&mut app.dialog, target) {
        (Some(Dialog::List(_, picker)), Target::DialogRow(row)) => {
            if picker.selected == row {
                return press(app, KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
            }
            (picker.selected, picker.moved) = (row, true);
        }
        (Some(Dialog::List(..)), Target::Beside) => {
            app.dialog = None;
        }
        (Some(Dialog::Ask(state)), Target::DialogRow(row)) => state.choices.click(row),
        // What has been typed is not thrown away by a click.
        _ => {}
    }
}

fn count(app: &App, list: List, typed: &str) -> usize {
    match list {
        List::Help => dialogs::help_rows(app, typed).len(),
        List::Palette => app.palette(typed).len(),
        List::Presets => dialogs::preset_rows(&app.files.presets, typed).len(),
        List::Words => app.pages.run.editor.variable().words().len(),
        List::Options => OptionRow::ALL.len(),
    }
}

/// Keys all lists share; Enter and Space mean what the list is for.
fn in_list(app: &mut App, list: List, mut picker: Picker, key: KeyEvent) {
    let last = count(app, list, picker.filter.value()).saturating_sub(1);
    let letter = !picker.typing && !key.modifiers.contains(KeyModifiers::CONTROL);
    if let Some(by) = moves(key, letter) {
        picker.selected = picker.selected.saturating_add_signed(by).min(last);
        picker.moved = true;
        app.dialog = Some(Dialog::List(list, picker));
        return;
    }
    match (key.code, list) {
        (KeyCode::Esc, List::Palette | List::Presets) => return,
        (KeyCode::Esc, _) if picker.typing => picker = Picker::default(),
        (KeyCode::Esc, _) => return,
        (KeyCode::Char('q'), _)
        | (KeyCode::Char('?'), List::Help)
        | (KeyCode::Char('o'), List::Options)
            if letter =>
        {
            return;
        }
        (KeyCode::Left | KeyCode::Char('h'), List::Options) => {
            options::change(app, OptionRow::ALL[picker.selected.min(last)], false);
        }
        (KeyCode::Enter | KeyCode::Right | KeyCode::Char('l' | ' '), List::Options) => {
            options::change(app, OptionRow::ALL[picker.selected.min(last)], true);
        }
        (KeyCode::Enter, _) => return chosen(app, list, &picker),
        (KeyCode::Char('/'), List::Help | List::Palette) if letter => {
            picker.typing = true;
        }
        (KeyCode::Tab, List::Presets) => presets::pin(app, &picker),
        _ if picker.typing && picker.filter.press(key) => {
            (picker.selected, picker.moved) = (0, false);
        }
        _ => {}
    }
    app.dialog = Some(Dialog::List(list, picker));
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
pub(crate) fn after_typing(app: &mut App) {
    match &mut app.dialog {
        Some(Dialog::List(_, picker)) => (picker.selected, picker.moved) = (0, false),
        Some(Dialog::Ask(ask)) => ask.forget(),
        None => {}
    }
}

fn chosen(app: &mut App, list: List, picker: &Picker) {
    match list {
        List::Help => {
            let rows = dialogs::help_rows(app, picker.filter.value());
            if let Some(action) = rows.get(picker.selected).map(|row| row.action) {
                act::act(app, action);
            }
        }
        List::Palette => palette::chosen(app, picker),
        List::Presets => presets::chosen(app, picker),
        List::Words => take_word(app, picker),
        List::Options => {}
    }
}

/// Set the selected variable to a word; one that is refused leaves the list open, with the reason.
fn take_word(app: &mut App, picker: &Picker) {
    let Some(word) = app.pages.run.editor.variable().words().get(picker.selected) else {
        return;
    };
    match edit::set(app, app.pages.run.editor.selected, Value::Word(word), None) {
        Ok(()) => ask::ask(app, word),
        Err(error) => {
            app.refuse(error);
            app.dialog = Some(Dialog::List(List::Words, picker.clone()));
        }
    }
}

/// Names that complete a path: of one it is taken, of several what they have in common, and the list.
pub(crate) fn complete(app: &mut App, names: Vec<String>) {
    let Some(Dialog::Ask(ask)) = &mut app.dialog else { return };
    match common_start(&names) {
        None => ask.text.error = Some("no file or directory begins like this".to_owned()),
        Some(common) => {
            ask.text = TextField::new(common);
            ask.completions = if names.len() > 1 { names } else { Vec::new() };
        }
    }
}

fn common_start(names: &[String]) -> Option<String> {
    let mut common = names.first()?.clone();
    while names.iter().any(|name| !name.starts_with(&common)) {
        common.pop();
    }
    Some(common)
}

const WIDTH: u16 = 58;
/// Rows for the meaning below the words.
const NOTE_ROWS: u16 = 3;

pub(crate) fn words(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let variable = app.pages.run.editor.variable();
    let words = variable.words();
    let count = u16::try_from(words.len()).unwrap_or(u16::MAX);
    let size = (WIDTH, count.saturating_add(NOTE_ROWS + 3));
    let pane = PaneFrame::new(variable.symbol).right("Enter takes it");
    let inner = frame(screen, size, pane, canvas);
    let list = Rect { height: inner.height.saturating_sub(NOTE_ROWS + 1).min(count), ..inner };
    let now = variable.value(&app.scene);
    let rows = RowList { count: words.len(), selected: picker.selected, painted: true };
    rows.in_dialog(canvas, list, |canvas, row, index| {
        let is_now = now == Value::Word(words[index]);
        let mark = if is_now { "> " } else { "  " };
        let role = if refusal(app, words[index]).is_some() { Role::Dim } else { Role::Text };
        canvas.put(row, (0, 0), mark, Role::Title);
        let end = canvas.put(row, (2, 0), words[index], role);
        if is_now {
            canvas.put(row, (end + 2, 0), "now", Role::Dim);
        }
    });
    let refused = words.get(picker.selected).and_then(|word| refusal(app, word));
    let (text, role) = match refused {
        Some(text) => (text, Role::Warning),
        None => (variable.meaning.to_owned(), Role::Dim),
    };
    canvas.put_lines(inner, list.height + 1, wrapped(&text, inner.width, role));
}

/// Why the scene makes no sense with this word; `None` where it does.
fn refusal(app: &App, word: &'static str) -> Option<String> {
    let mut scene = (*app.scene).clone();
    let set = app.pages.run.editor.variable().set(&mut scene, Value::Word(word));
    set.and_then(|()| variables::validate(&scene)).err().map(|error| error.to_string())
}
