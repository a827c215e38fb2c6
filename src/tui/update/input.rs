//! Keys and pasted text into a one-line field.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

use crate::tui::app::App;
use crate::tui::app::dialog::{Dialog, ExportRow};
use crate::tui::app::notice::Severity;
use crate::tui::message::Effect;

use super::dialogs;

/// Put a key into a field; whether it was one for a field. While `fresh`, the whole text is selected.
pub(super) fn press(input: &mut Input, fresh: &mut bool, key: KeyEvent) -> bool {
    let Some(request) = request(key) else {
        return false;
    };
    let replaces = matches!(
        request,
        InputRequest::InsertChar(_) | InputRequest::DeletePrevChar | InputRequest::DeleteNextChar
    );
    if *fresh && replaces {
        input.reset();
    }
    *fresh = false;
    input.handle(request);
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
pub(super) fn paste(app: &mut App, text: &str) -> Vec<Effect> {
    app.notice = None;
    let clean: String = text.trim().chars().filter(|c| !c.is_control()).collect();
    let mut never = false;
    let (input, fresh) = match (&mut app.dialog, &mut app.editor.field) {
        (
            Some(
                Dialog::Save(save)
                | Dialog::ExportAccuracy(save)
                | Dialog::ExportSweep(save)
                | Dialog::ExportTable(_, save)
                | Dialog::Curve(_, save),
            ),
            _,
        ) => (&mut save.input, &mut save.fresh),
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
        (None, Some(field)) => {
            field.error = None;
            (&mut field.input, &mut field.fresh)
        }
        (Some(_) | None, _) => {
            app.say(
                Severity::Note,
                "pasted text is ignored here: open a field first (Enter on a variable)",
            );
            return Vec::new();
        }
    };
    if *fresh {
        input.reset();
        *fresh = false;
    }
    for c in clean.chars() {
        input.handle(InputRequest::InsertChar(c));
    }
    dialogs::after_typing(app);
    Vec::new()
}
