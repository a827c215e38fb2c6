//! Keys and pasted text into a one-line field.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs;
use crate::tui::dialogs::{Dialog, ExportRow};
use crate::tui::keymap::Pane;
use crate::tui::message::Effect;
use crate::tui::update::find;

/// No field of the workbench takes a longer text: characters that nobody means to type (a paste that came as keys, a book on
/// the keyboard) are dropped.
const TEXT_MAX: usize = 1024;

/// Put a key into a field; whether it was one for a field. While `all_selected`, the whole text is selected.
pub(in crate::tui) fn press(input: &mut Input, all_selected: &mut bool, key: KeyEvent) -> bool {
    let Some(request) = request(key) else {
        return false;
    };
    let replaces = matches!(
        request,
        InputRequest::InsertChar(_) | InputRequest::DeletePrevChar | InputRequest::DeleteNextChar
    );
    if *all_selected && replaces {
        input.reset();
    }
    *all_selected = false;
    let adds = matches!(request, InputRequest::InsertChar(_));
    if !adds || input.value().chars().count() < TEXT_MAX {
        input.handle(request);
    }
    true
}

fn request(key: KeyEvent) -> Option<InputRequest> {
    use InputRequest as R;
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    let alt = key.modifiers.contains(KeyModifiers::ALT);
    match key.code {
        KeyCode::Char('a') if control => Some(R::GoToStart),
        KeyCode::Char('e') if control => Some(R::GoToEnd),
        KeyCode::Char('u') if control => Some(R::DeleteLine),
        KeyCode::Char('k') if control => Some(R::DeleteTillEnd),
        KeyCode::Char('w') if control => Some(R::DeletePrevWord),
        KeyCode::Char('h') if control => Some(R::DeletePrevChar),
        KeyCode::Char(c) if !control && !alt && !c.is_control() => Some(R::InsertChar(c)),
        KeyCode::Backspace => Some(R::DeletePrevChar),
        KeyCode::Delete => Some(R::DeleteNextChar),
        KeyCode::Left if control => Some(R::GoToPrevWord),
        KeyCode::Right if control => Some(R::GoToNextWord),
        KeyCode::Left => Some(R::GoToPrevChar),
        KeyCode::Right => Some(R::GoToNextChar),
        KeyCode::Home => Some(R::GoToStart),
        KeyCode::End => Some(R::GoToEnd),
        _ => None,
    }
}

/// Pasted text goes into the open field, without line breaks and control characters; else it is ignored with a note.
pub(in crate::tui) fn paste(app: &mut App, text: &str) -> Vec<Effect> {
    app.notice = None;
    let clean: String =
        text.trim().chars().filter(|c| !c.is_control()).take(TEXT_MAX + 1).collect();
    if clean.chars().count() > TEXT_MAX {
        let text = format!("pasted text is ignored: it is longer than {TEXT_MAX} characters");
        app.say(Severity::Warning, text);
        return Vec::new();
    }
    let mut never = false;
    let pane = app.pane();
    let setup = app.sweeping.field.as_mut().filter(|_| pane == Pane::ExploreSetup);
    let setup = setup.map(|field| (&mut field.input, &mut field.all_selected, &mut field.error));
    let search = app.searching.field.as_mut().filter(|_| pane == Pane::SearchSetup);
    let search = search.map(|field| (&mut field.input, &mut field.all_selected, &mut field.error));
    let open = app.editor.field.as_mut().filter(|_| pane == Pane::Variables);
    let open = open.map(|field| (&mut field.input, &mut field.all_selected, &mut field.error));
    let (input, all_selected) = match (&mut app.dialog, open.or(setup).or(search)) {
        (Some(Dialog::Save(save) | Dialog::ExportTable(_, save) | Dialog::Curve(_, save)), _) => {
            (&mut save.input, &mut save.all_selected)
        }
        (Some(Dialog::Export(export)), _) if export.row == ExportRow::Path => {
            (&mut export.path, &mut never)
        }
        (Some(Dialog::Export(export)), _) if export.row == ExportRow::GridRows => {
            (&mut export.grid, &mut never)
        }
        (Some(Dialog::Help(picker) | Dialog::Palette(picker) | Dialog::Presets(picker)), _)
            if picker.typing =>
        {
            (&mut picker.filter, &mut never)
        }
        (None, Some((input, all_selected, error))) => {
            *error = None;
            (input, all_selected)
        }
        (None, None) if app.find.field.is_some() => {
            return paste_into_find(app, &clean);
        }
        (Some(_) | None, _) => {
            app.say(
                Severity::Note,
                "pasted text is ignored here: open a field first (Enter on a variable)",
            );
            return Vec::new();
        }
    };
    if *all_selected {
        input.reset();
        *all_selected = false;
    }
    for c in clean.chars() {
        input.handle(InputRequest::InsertChar(c));
    }
    dialogs::keys::after_typing(app);
    Vec::new()
}

/// Into the field of `/`; the list follows.
fn paste_into_find(app: &mut App, text: &str) -> Vec<Effect> {
    if let Some(field) = &mut app.find.field {
        for c in text.chars() {
            field.handle(InputRequest::InsertChar(c));
        }
    }
    find::follow(app);
    Vec::new()
}
