//! Dialogs that ask for a text: a preset's name, or a path.

use std::fmt::Debug;
use std::path::{Path, PathBuf};

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::frame;
use crate::tui::dialogs::list::is_text;
use crate::tui::message::{EffectReport, ExportOutcome, FileTask};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{TextLine, wrapped};

/// The field of a text, and what was found of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Ask {
    pub text: TextField,
    /// A preset or file of this name exists: the answer to "overwrite?" is awaited.
    pub question: bool,
    /// Names that complete the path.
    pub completions: Vec<String>,
}

/// What a text is asked for.
pub(super) trait Purpose: Clone + Debug + 'static {
    fn footer(&self) -> Footer;

    /// Do what the text was typed for; a file or preset of this name may be replaced. None: something comes first.
    fn accept(
        &self,
        app: &mut App,
        ask: &mut Ask,
        overwrite: bool,
    ) -> Result<Option<FileTask>, String>;

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
#[derive(Clone, Debug)]
pub(super) struct Asking<P> {
    pub ask: Ask,
    pub purpose: P,
}

impl<P: Purpose> Asking<P> {
    pub(super) fn open(purpose: P, text: TextField) -> Box<dyn Dialog> {
        Box::new(Self { ask: Ask { text, ..Ask::default() }, purpose })
    }
}

impl<P: Purpose> Dialog for Asking<P> {
    fn footer(&self) -> Footer {
        if self.ask.question { REPLACE } else { self.purpose.footer() }
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        match self.ask.press(app, key) {
            Step::Accept { overwrite } => {
                let task = self.purpose.accept(app, &mut self.ask, overwrite);
                self.ask.begun(app, task);
            }
            Step::Closes => return Outcome::Closes,
            Step::Stays => {}
        }
        Outcome::Stays
    }

    fn click(&mut self, _: &mut App, _: usize) -> Outcome {
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        Some(&mut self.ask.text)
    }

    fn pasted(&mut self) {
        self.ask.forget();
    }

    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        if let EffectReport::Completions(names) = report {
            return Some(self.ask.complete(names));
        }
        let ended = self.purpose.ended(&self.ask, directory, report)?;
        Some(self.ask.ended(&ended))
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let (title, label) = self.purpose.title();
        let inner = frame(screen, (76, 9), PaneFrame::new(title), canvas);
        let start = canvas.put(inner, (0, 1), label, Role::Title);
        let width = inner.width.saturating_sub(start + 1);
        let field = TextField { error: None, ..self.ask.text.clone() };
        field.draw(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 });
        let lines = self.ask.found(app, &self.purpose.there(app, &self.ask), inner.width);
        let hint = || wrapped(&self.purpose.hint(app, &self.ask), inner.width, Role::Dim).collect();
        canvas.put_lines(inner, 3, lines.unwrap_or_else(hint));
    }
}

/// What a key in the field comes to.
pub(super) enum Step {
    /// The text is taken; a file or preset of this name may be replaced.
    Accept {
        overwrite: bool,
    },
    Closes,
    Stays,
}

/// The keys while the question is open.
pub(super) const REPLACE: Footer = &[
    (FootKey::As("o"), "overwrite"),
    (FootKey::As("r"), "rename"),
    (FootKey::Of(Action::Back), "back"),
];

impl Ask {
    pub(super) fn value(&self) -> &str {
        self.text.value().trim()
    }

    pub(super) fn press(&mut self, app: &mut App, key: KeyEvent) -> Step {
        match (self.question, key.code) {
            (true, KeyCode::Char('y' | 'o')) => return Step::Accept { overwrite: true },
            (true, KeyCode::Char('n')) => self.question = false,
            (true, KeyCode::Char('r')) => {
                self.text = TextField::new(next_name(self.text.value()));
                self.question = false;
            }
            _ => match app.keymap.action(key).filter(|_| !is_text(key)) {
                Some(Action::Back) if self.question => self.question = false,
                Some(Action::Back) => return Step::Closes,
                Some(Action::Enter) if self.question => {}
                Some(Action::Enter) => {
                    self.text.all_selected = false;
                    return Step::Accept { overwrite: false };
                }
                Some(Action::FocusNext) => {
                    let typed = self.text.value().to_owned();
                    app.request(Effect::Files(FileTask::Complete(typed)));
                }
                _ => {
                    if self.text.press(key) {
                        self.forget();
                    }
                }
            },
        }
        Step::Stays
    }

    /// Another text: what was said about the old one is removed.
    pub(super) fn forget(&mut self) {
        self.question = false;
        self.text.error = None;
        self.completions.clear();
    }

    /// What the text was taken for has begun, or cannot be done: that stands in the dialog.
    pub(super) fn begun(&mut self, app: &mut App, task: Result<Option<FileTask>, String>) {
        match task {
            Ok(task) => {
                self.text.error = None;
                app.effects.extend(task.map(Effect::Files));
            }
            Err(error) => self.text.error = Some(error),
        }
    }

    /// It has ended: the dialog closes, or what stands in the way stands in it.
    pub(super) fn ended(&mut self, outcome: &ExportOutcome) -> Outcome {
        match outcome {
            ExportOutcome::Written(_) => return Outcome::Closes,
            ExportOutcome::Exists(_) => self.question = true,
            ExportOutcome::Failed(text) => {
                self.question = false;
                self.text.error = Some(text.clone());
            }
        }
        Outcome::Stays
    }

    /// Names that complete a path: of one it is taken, of several what they have in common, and the list.
    pub(super) fn complete(&mut self, names: &[String]) -> Outcome {
        match common_start(names) {
            None => self.text.error = Some("no file or directory begins like this".to_owned()),
            Some(common) => {
                self.text = TextField::new(common);
                self.completions = if names.len() > 1 { names.to_vec() } else { Vec::new() };
            }
        }
        Outcome::Stays
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

    /// The question, where this exists, the error or the completions, if there are some.
    pub(super) fn found(&self, app: &App, there: &str, width: u16) -> Option<Vec<TextLine>> {
        let (text, role) = if self.question {
            (format!("! {there} exists: o overwrite, r rename, Esc back"), Role::Warning)
        } else if let Some(error) = &self.text.error {
            (app.keymap.shown(&format!("x {error}")), Role::Error)
        } else if !self.completions.is_empty() {
            (self.completions.join("  "), Role::Note)
        } else {
            return None;
        };
        Some(wrapped(&text, width, role).collect())
    }
}

fn common_start(names: &[String]) -> Option<String> {
    let mut common = names.first()?.clone();
    while names.iter().any(|name| !name.starts_with(&common)) {
        common.pop();
    }
    Some(common)
}

/// The next name of a series: `run.csv`, `run-2.csv`, `run-3.csv`.
fn next_name(text: &str) -> String {
    let (stem, ending) = match text.rsplit_once('.') {
        Some((stem, ending)) if !ending.contains('/') => (stem, format!(".{ending}")),
        _ => (text, String::new()),
    };
    match stem.rsplit_once('-') {
        Some((front, number)) => match number.parse::<u32>() {
            Ok(number) => format!("{front}-{}{ending}", number.saturating_add(1)),
            Err(_) => format!("{stem}-2{ending}"),
        },
        None => format!("{stem}-2{ending}"),
    }
}
