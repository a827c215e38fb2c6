//! Dialogs that ask for a text: a preset's name, or a path.

use std::fmt::Debug;
use std::path::{Path, PathBuf};

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::list::{frame, is_text};
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
    completions: Vec<String>,
}

/// What a text is asked for.
pub(super) trait Purpose: Clone + Debug + 'static {
    fn footer(&self) -> Footer;

    /// What a key does to the choices beside the field; `None` where it is for the field.
    fn press(&mut self, _action: Option<Action>, _key: KeyEvent) -> Option<Outcome> {
        None
    }

    /// Whether characters go into the field.
    fn types(&self) -> bool {
        true
    }

    /// A click on a row of the choices.
    fn click(&mut self, _row: usize) {}

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

    fn draw(&self, app: &App, ask: &Ask, screen: Rect, canvas: &mut Canvas<'_>) {
        let (title, label) = self.title();
        let inner = frame(screen, (76, 9), PaneFrame::new(title), canvas);
        let start = canvas.put(inner, (0, 1), label, Role::Title);
        let width = inner.width.saturating_sub(start + 1);
        ask.draw_field(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 });
        let lines = ask.found(app, &self.there(app, ask), inner.width);
        let hint = || wrapped(&self.hint(app, ask), inner.width, Role::Dim).collect();
        canvas.put_lines(inner, 3, lines.unwrap_or_else(hint));
    }
}

/// A dialog that asks for a text.
#[derive(Clone, Debug)]
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
    fn footer(&self) -> Footer {
        if self.ask.question { REPLACE } else { self.purpose.footer() }
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let ask = &mut self.ask;
        let typed = self.purpose.types() && is_text(key);
        let action = app.keymap.action(key).filter(|_| !typed);
        let chosen = if ask.question { None } else { self.purpose.press(action, key) };
        if let Some(outcome) = chosen {
            ask.text.error = None;
            return outcome;
        }
        match (ask.question, key.code) {
            (true, KeyCode::Char('y' | 'o')) => self.accept(app, true),
            (true, KeyCode::Char('n')) => ask.question = false,
            (true, KeyCode::Char('r')) => {
                ask.text = TextField::new(next_name(ask.text.value()));
                ask.question = false;
            }
            _ => match action {
                Some(Action::Back) if ask.question => ask.question = false,
                Some(Action::Back) => return Outcome::Closes,
                Some(Action::Enter) if ask.question => {}
                Some(Action::Enter) => {
                    ask.text.all_selected = false;
                    self.accept(app, false);
                }
                Some(Action::FocusNext) => {
                    let typed = ask.text.value().to_owned();
                    app.request(Effect::Files(FileTask::Complete(typed)));
                }
                _ if ask.text.press(key) => ask.forget(),
                _ => {}
            },
        }
        Outcome::Stays
    }

    fn click(&mut self, _: &mut App, row: usize) -> Outcome {
        self.purpose.click(row);
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        self.purpose.types().then_some(&mut self.ask.text)
    }

    fn pasted(&mut self) {
        self.ask.forget();
    }

    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        if let EffectReport::Completions(names) = report {
            self.ask.complete(names);
            return Some(Outcome::Stays);
        }
        let ended = self.purpose.ended(&self.ask, directory, report)?;
        Some(self.ask.ended(ended))
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        self.purpose.draw(app, &self.ask, screen, canvas);
    }
}

/// The keys while the question is open.
const REPLACE: Footer = &[
    (FootKey::As("o"), "overwrite"),
    (FootKey::As("r"), "rename"),
    (FootKey::Of(Action::Back), "back"),
];

impl Ask {
    pub(super) fn value(&self) -> &str {
        self.text.value().trim()
    }

    /// Another text: what was said about the old one is removed.
    fn forget(&mut self) {
        self.question = false;
        self.text.error = None;
        self.completions.clear();
    }

    /// It has ended: the dialog closes, or what stands in the way stands in it.
    fn ended(&mut self, outcome: ExportOutcome) -> Outcome {
        match outcome {
            ExportOutcome::Written(_) => return Outcome::Closes,
            ExportOutcome::Exists(_) => self.question = true,
            ExportOutcome::Failed(text) => {
                self.question = false;
                self.text.error = Some(text);
            }
        }
        Outcome::Stays
    }

    /// Names that complete a path: of one it is taken, of several what they have in common, and the list.
    fn complete(&mut self, names: &[String]) {
        match common_start(names) {
            None => self.text.error = Some("no file or directory begins like this".to_owned()),
            Some(common) => {
                self.text = TextField::new(common);
                self.completions = if names.len() > 1 { names.to_vec() } else { Vec::new() };
            }
        }
    }

    /// Draw the field as it is while it is typed into: why its text is refused stands below.
    pub(super) fn draw_field(&self, canvas: &mut Canvas<'_>, area: Rect) {
        TextField { error: None, ..self.text.clone() }.draw(canvas, area);
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
