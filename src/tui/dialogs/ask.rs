//! Dialogs that ask for a text: a preset's name, or a path.

use std::fmt::Debug;
use std::path::{Path, PathBuf};

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::dialogs::list::{frame, is_text};
use crate::tui::message::{EffectReport, ExportOutcome, FileTask};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{TextLine, wrapped};

/// The field of a text, and what was found of it.
#[derive(Debug, Default)]
pub(super) struct Ask {
    text: TextField,
    /// A preset or file of this name exists: the answer to "overwrite?" is awaited.
    pub question: bool,
}

/// What a text is asked for.
pub(super) trait Purpose: Debug + 'static {
    const FOOTER: &'static str;

    /// Do what the text was typed for; a file or preset of this name may be replaced. None: something comes first.
    fn accept(&self, app: &App, ask: &mut Ask, overwrite: bool)
    -> Result<Option<FileTask>, String>;

    /// How an effect ended, where it is the one that was asked for.
    fn ended(&self, ask: &Ask, directory: &Path, report: &EffectReport) -> Option<ExportOutcome>;

    /// The title, and the word before the field.
    fn title(&self) -> (&'static str, &'static str);

    /// What stands below the field.
    fn hint(&self, app: &App, ask: &Ask) -> String;

    /// What stands in the way where it exists already.
    fn there(&self, app: &App, ask: &Ask) -> String {
        app.files.directory.join(ask.value()).display().to_string()
    }
}

/// A dialog that asks for a text.
#[derive(Debug)]
pub(super) struct Asking<P> {
    ask: Ask,
    purpose: P,
}

impl<P: Purpose> Asking<P> {
    pub(super) fn open(purpose: P, text: TextField) -> Box<dyn Dialog> {
        Box::new(Self { ask: Ask { text, ..Ask::default() }, purpose })
    }

    /// Do it; why it cannot be done stands in the dialog.
    fn accept(&mut self, app: &mut App, overwrite: bool) {
        self.ask.text.error = None;
        match self.purpose.accept(app, &mut self.ask, overwrite) {
            Ok(task) => app.effects.extend(task.map(Effect::Files)),
            Err(error) => self.ask.text.error = Some(error),
        }
    }
}

impl<P: Purpose> Dialog for Asking<P> {
    fn footer(&self) -> &'static str {
        if self.ask.question { "o overwrite  <back> back" } else { P::FOOTER }
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let action = app.keymap.action(key).filter(|_| !is_text(key));
        match (action, self.ask.question) {
            (Some(Action::Back), false) => return Outcome::Closes,
            (Some(Action::Back), true) => self.ask.question = false,
            (Some(Action::Enter), false) => {
                self.ask.text.all_selected = false;
                self.accept(app, false);
            }
            (_, true) if matches!(key.code, KeyCode::Char('y' | 'o')) => self.accept(app, true),
            (Some(Action::Enter), true) => {}
            _ if self.ask.text.press(key) => self.pasted(),
            _ => {}
        }
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        Some(&mut self.ask.text)
    }

    /// Another text: what was said about the old one is removed.
    fn pasted(&mut self) {
        self.ask.question = false;
        self.ask.text.error = None;
    }

    /// It has ended: the dialog closes, or what stands in the way stands in it.
    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        match self.purpose.ended(&self.ask, directory, report)? {
            ExportOutcome::Written(_) => return Some(Outcome::Closes),
            ExportOutcome::Exists(_) => self.ask.question = true,
            ExportOutcome::Failed(text) => {
                self.ask.question = false;
                self.ask.text.error = Some(text);
            }
        }
        Some(Outcome::Stays)
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let (title, label) = self.purpose.title();
        let inner = frame(screen, (76, 9), PaneFrame::new(title), canvas);
        let start = canvas.put(inner, (0, 1), label, Role::Title);
        let width = inner.width.saturating_sub(start + 1);
        // Why its text is refused stands below.
        let field = TextField { error: None, ..self.ask.text.clone() };
        field.draw(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 });
        canvas.put_lines(inner, 3, self.below(app, inner.width));
    }
}

impl<P: Purpose> Asking<P> {
    /// The question, the error or the hint.
    fn below(&self, app: &App, width: u16) -> Vec<TextLine> {
        let (text, role) = if self.ask.question {
            let there = self.purpose.there(app, &self.ask);
            (format!("! {there} exists: o overwrite, Esc back"), Role::Warning)
        } else if let Some(error) = &self.ask.text.error {
            (app.keymap.shown(&format!("error: {error}")), Role::Error)
        } else {
            (self.purpose.hint(app, &self.ask), Role::Dim)
        };
        wrapped(&text, width, role).collect()
    }
}

impl Ask {
    pub(super) fn value(&self) -> &str {
        self.text.value().trim()
    }

    /// The path that was typed.
    pub(super) fn path(&self, app: &App, example: &str) -> Result<PathBuf, String> {
        let text = self.value();
        if text.is_empty() || text.ends_with('/') {
            return Err(format!("the path needs a file name, for example `{example}`"));
        }
        Ok(app.files.directory.join(text))
    }

    /// Whether it asks for this path.
    pub(super) fn is_of(&self, directory: &Path, path: &Path) -> bool {
        directory.join(self.value()) == path
    }
}
