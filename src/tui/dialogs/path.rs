//! Dialogs for a name or a path: to save the scene, and to export the content of a page.

use std::path::{Path, PathBuf};

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::atomic::OverwritePolicy;
use crate::files::export::Destination;
use crate::files::preset;
use crate::files::report::is_report;
use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::dialogs::list::{frame, is_text};
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask};
use crate::tui::pages;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{TextLine, wrapped};
use cmra_studies::report::run::NamedRun;
use cmra_studies::report::svg;

/// Purpose of the path.
#[derive(Clone, Copy, Debug)]
enum Purpose {
    /// Save the scene: by name as a user preset, or by path as a file.
    Save,
    /// Export the content of a page (table or runs as CSV, or charts as SVG); with the title of the dialog.
    Export(&'static str),
    /// Read traces for the charts; an empty text removes them.
    Beside,
}

/// Hint on the content of a file of traces.
const BESIDE: &str = "a CSV file: a column of time (s, ms, us) and any of penetration, plate displacement, plate or projectile velocity, \
                      contact or mount force, acceleration, with units in the headings; no name: none";

/// Dialog for a name or a path.
#[derive(Debug)]
struct PathDialog {
    purpose: Purpose,
    text: TextField,
    /// Whether the dialog waits for the answer to "overwrite?", because the preset or file exists.
    question: bool,
}

/// Opens the dialog to save the scene.
pub(super) fn save(app: &mut App) -> Box<dyn Dialog> {
    app.list_presets();
    let text = TextField::selected(proposed_name(app));
    Box::new(PathDialog { purpose: Purpose::Save, text, question: false })
}

/// Opens the dialog to export the content of the page; `None` if it is empty.
pub(super) fn export(app: &mut App) -> Option<Box<dyn Dialog>> {
    let (title, file) = match content(app) {
        None => {
            app.refuse(pages::nothing_yet(app, "export"));
            return None;
        }
        Some(Content::Page(table)) => (table.title, table.file),
        Some(_) => ("Export the runs to CSV", format!("{}.csv", app.base_stem())),
    };
    // Typed text replaces the whole name, as in every field.
    let text = TextField::selected(file);
    Some(Box::new(PathDialog { purpose: Purpose::Export(title), text, question: false }))
}

/// Opens the dialog to read traces.
pub(super) fn beside(app: &App) -> Box<dyn Dialog> {
    let text = app.pages.run.beside.as_ref().map_or_else(String::new, |traces| traces.name.clone());
    Box::new(PathDialog {
        purpose: Purpose::Beside,
        text: TextField::selected(text),
        question: false,
    })
}

impl Dialog for PathDialog {
    fn footer(&self) -> &'static str {
        match self.purpose {
            _ if self.question => "o overwrite  <back> back",
            Purpose::Save => "<enter> save  <back> do not save",
            Purpose::Export(_) => "<enter> write  <back> close",
            Purpose::Beside => "<enter> open  <back> close",
        }
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let action = app.keymap.action(key).filter(|_| !is_text(key));
        match (action, self.question) {
            (Some(Action::Back), false) => return Outcome::Closes,
            (Some(Action::Back), true) => self.question = false,
            (Some(Action::Enter), false) => {
                self.text.all_selected = false;
                self.accept(app, false);
                if matches!(self.purpose, Purpose::Beside) && self.value().is_empty() {
                    return Outcome::Closes;
                }
            }
            (_, true) if matches!(key.code, KeyCode::Char('y' | 'o')) => self.accept(app, true),
            (Some(Action::Enter), true) => {}
            _ => {
                if self.text.press(key) {
                    self.question = false;
                }
            }
        }
        Outcome::Stays
    }

    fn paste(&mut self, text: &str) -> bool {
        self.text.insert(text);
        self.question = false;
        true
    }

    /// Handles the end of the effect: closes the dialog, or shows the obstacle.
    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        let outcome = match (self.purpose, report) {
            (Purpose::Beside, EffectReport::Traces(path, read))
                if directory.join(self.value()) == *path =>
            {
                let Err(why) = read else { return Some(Outcome::Closes) };
                self.text.error = Some(why.clone());
                return Some(Outcome::Stays);
            }
            (Purpose::Save, EffectReport::Saved(name, outcome)) if self.value() == name => outcome,
            (Purpose::Export(_), EffectReport::Exported(path, outcome))
                if directory.join(self.value()) == *path =>
            {
                outcome
            }
            _ => return None,
        };
        match outcome {
            ExportOutcome::Written(_) => return Some(Outcome::Closes),
            ExportOutcome::Exists(_) => self.question = true,
            ExportOutcome::Failed(text) => {
                self.question = false;
                self.text.error = Some(text.clone());
            }
        }
        Some(Outcome::Stays)
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let (title, label) = match self.purpose {
            Purpose::Save => ("Save the scene", "name  "),
            Purpose::Export(title) => (title, "file  "),
            Purpose::Beside => ("Open a measured trace", "file  "),
        };
        let inner = frame(screen, (76, 9), PaneFrame::new(title), canvas);
        let start = canvas.put(inner, (0, 1), label, Role::Title);
        let width = inner.width.saturating_sub(start + 1);
        // The error is displayed below the field.
        let field = TextField { error: None, ..self.text.clone() };
        field.draw(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 });
        canvas.put_lines(inner, 3, self.below(app, inner.width));
    }
}

impl PathDialog {
    fn value(&self) -> &str {
        self.text.value().trim()
    }

    /// Returns the typed path.
    fn path(&self, app: &App, example: &str) -> Result<PathBuf, String> {
        let text = self.value();
        if text.is_empty() || text.ends_with('/') {
            return Err(format!("the path needs a file name, for example `{example}`"));
        }
        Ok(app.files.directory.join(text))
    }

    /// Performs the purpose of the dialog; shows the reason if that fails.
    fn accept(&mut self, app: &mut App, overwrite: bool) {
        self.text.error = None;
        let task = match self.purpose {
            Purpose::Save => self.saving(app, overwrite),
            Purpose::Export(_) => self.exporting(app, overwrite).map(Some),
            Purpose::Beside if self.value().is_empty() => {
                app.pages.run.beside = None;
                Ok(None)
            }
            Purpose::Beside => self.path(app, "trace.csv").map(|path| Some(FileTask::Traces(path))),
        };
        match task {
            Ok(task) => app.effects.extend(task.map(Effect::Files)),
            Err(error) => self.text.error = Some(error),
        }
    }

    /// Returns the task to save the scene; `None` if a file or user preset exists and the user must confirm first.
    fn saving(&mut self, app: &App, overwrite: bool) -> Result<Option<FileTask>, String> {
        let name = self.value().to_owned();
        if name.is_empty() {
            return Err("a preset needs a name: letters, digits, - and _".to_owned());
        }
        let path = if preset::is_path(&name) { Some(self.path(app, "scene.toml")?) } else { None };
        let same = app.files.presets.iter().filter(|it| it.part.is_none() && it.name == name);
        let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
        if path.is_none() && origins.contains(&"bundled") {
            return Err(format!(
                "`{name}` is a built-in preset and stays as it is: choose another name"
            ));
        }
        if path.is_none() && origins.contains(&"mine") && !overwrite {
            self.question = true;
            return Ok(None);
        }
        let scene = Box::new((*app.scene).clone());
        Ok(Some(FileTask::SaveScene { name, path, scene, overwrite }))
    }

    fn exporting(&self, app: &App, overwrite: bool) -> Result<FileTask, String> {
        let path = self.path(app, "table.csv")?;
        if is_report(&path) {
            return Err(format!(
                "{}: the ending is a report's, and here a .csv table or .svg charts are written: name it so, or save the scene and run \
                 `cmra report FILE.toml -o FILE.html`",
                path.display()
            ));
        }
        let content = if is_svg(&path) {
            let drawn = pages::pictures(app);
            let none = "no chart on the screen can be drawn as SVG: write the table to a .csv file";
            (!drawn.is_empty()).then(|| Content::Text(svg::file(&drawn))).ok_or(none)?
        } else {
            content(app).ok_or("the result to write no longer exists")?
        };
        let existing = OverwritePolicy::replaced(overwrite);
        Ok(FileTask::Export(Destination { path, existing }, content))
    }

    /// Returns the lines below the field: the question, the error or a hint.
    fn below(&self, app: &App, width: u16) -> Vec<TextLine> {
        let path = app.files.directory.join(self.value());
        let is_name = matches!(self.purpose, Purpose::Save) && !preset::is_path(self.value());
        let (text, role) = if self.question {
            let there = if is_name {
                format!("your preset `{}`", self.value())
            } else {
                path.display().to_string()
            };
            (format!("! {there} exists: o overwrite, Esc back"), Role::Warning)
        } else if let Some(error) = &self.text.error {
            (app.keymap.shown(&format!("error: {error}")), Role::Error)
        } else {
            let what = match self.purpose {
                Purpose::Save | Purpose::Beside => "",
                Purpose::Export(_) if is_svg(&path) => "\nthe charts on the screen, as SVG",
                Purpose::Export(_) => "\na name that ends in .svg writes the charts on the screen",
            };
            if matches!(self.purpose, Purpose::Beside) {
                return wrapped(BESIDE, width, Role::Dim).collect();
            }
            let preset = "kept with your own presets; a path (./my.toml) writes a file".to_owned();
            (if is_name { preset } else { format!("to {}{what}", path.display()) }, Role::Dim)
        };
        wrapped(&text, width, role).collect()
    }
}

/// Returns the content of the page: its table; on Run, the current run and the pins with a result.
fn content(app: &App) -> Option<Content> {
    if !app.shows_runs() {
        return pages::page(app.tab).table(app).map(Content::Page);
    }
    let now = app.shown.iter().map(|shown| ("now".to_owned(), shown.run.clone()));
    let pins = app.pins.iter().filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)));
    let runs: Vec<NamedRun> = now.chain(pins).collect();
    (!runs.is_empty()).then_some(Content::Runs(runs))
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// Proposes a name: the present one for a user preset or file, else that name with the first free number.
fn proposed_name(app: &App) -> String {
    let name = &app.base.name;
    // Scenes stored by the program are also files, but were not opened by path.
    let files = &app.files;
    let is_file = preset::is_path(name) && files.recent.contains(&files.directory.join(name));
    if app.base.is_mine || is_file {
        return name.clone();
    }
    let taken =
        |name: &str| files.presets.iter().any(|entry| entry.part.is_none() && entry.name == name);
    let stem = app.base_stem();
    (2..100)
        .map(|number| format!("{stem}-{number}"))
        .find(|name| !taken(name))
        .unwrap_or_else(|| "my-scene".to_owned())
}
