//! Choices of the selected variable.

use crate::tui::app::dialog::Outcome;
use crate::tui::app::edit;
use crate::tui::dialogs::list::{List, Picker, frame, listed};
use crate::tui::prelude::*;
use crate::tui::widgets::text::wrapped;
use cmra_engine::model::variables::{Kind, Value};

/// Opens the list of the selected variable's choices.
pub(crate) fn open(app: &mut App) {
    if let Kind::Choice { get, .. } = app.pages.run.editor.variable().kind {
        app.dialog = Some(listed(ChoiceDialog, get(&app.scene)));
    }
}

#[derive(Debug)]
struct ChoiceDialog;

const WIDTH: u16 = 58;
/// Rows for the meaning below the choices.
const NOTE_ROWS: u16 = 3;

impl List for ChoiceDialog {
    const OPENED_BY: Action = Action::Enter;
    const IS_FILTERED: bool = false;
    const FOOTER: &'static str = "<enter> take it  <down>/<up> move  <quit> close";

    fn count(&self, app: &App, _: &str) -> usize {
        app.pages.run.editor.variable().keys().len()
    }

    /// Sets the choice; a rejected choice leaves the list open, with the reason.
    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome {
        let index = app.pages.run.editor.selected;
        let Some(word) = app.pages.run.editor.variable().keys().get(picker.selected) else {
            return Outcome::Closes;
        };
        match edit::set(app, index, Value::Word(word), None) {
            Ok(()) => Outcome::Closes,
            Err(error) => {
                app.refuse(error);
                Outcome::Stays
            }
        }
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let variable = app.pages.run.editor.variable();
        let words = variable.keys();
        let count = u16::try_from(words.len()).unwrap_or(u16::MAX);
        let size = (WIDTH, count.saturating_add(NOTE_ROWS + 3));
        let pane = PaneFrame::new(variable.symbol);
        let inner = frame(screen, size, pane, canvas);
        let list = Rect { height: inner.height.saturating_sub(NOTE_ROWS + 1).min(count), ..inner };
        let now = variable.value(&app.scene);
        picker.draw_rows(words.len(), list, canvas, |canvas, row, index| {
            let is_now = now == Value::Word(words[index]);
            let role = if refusal(app, words[index]).is_some() { Role::Dim } else { Role::Text };
            let end = canvas.put(row, (2, 0), words[index], role);
            if is_now {
                canvas.put(row, (0, 0), ">", Role::Title);
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
}

/// Returns the reason why the scene makes no sense with this choice; `None` if it does.
fn refusal(app: &App, word: &'static str) -> Option<String> {
    edit::with(&app.scene, app.pages.run.editor.variable(), Value::Word(word)).err()
}
