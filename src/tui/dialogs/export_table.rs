//! The export of the table that a page shows.

use std::path::{Path, PathBuf};

use crossterm::event::KeyEvent;

use crate::files::atomic::Existing;
use crate::files::export::Destination;
use crate::files::report::is_report;
use crate::report::svg;
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::ask::{Ask, REPLACE, Step};
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask};
use crate::tui::pages;
use crate::tui::pages::run::report;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

/// Ask for the file to write the table shown to, if there is anything in it.
pub(super) fn open(app: &mut App) -> Option<Box<dyn Dialog>> {
    if app.shows_runs() {
        return None;
    }
    let Some(table) = pages::of(app.tab).table(app) else {
        app.refuse(pages::nothing_yet(app, "export"));
        return None;
    };
    let ask = Ask::new(TextField::new(table.file));
    Some(Box::new(ExportTable { ask, title: table.title }))
}

#[derive(Clone, Debug)]
struct ExportTable {
    ask: Ask,
    /// What the table is.
    title: &'static str,
}

impl Dialog for ExportTable {
    fn footer(&self) -> Footer {
        if self.ask.question {
            return REPLACE;
        }
        &[
            (FootKey::Of(Action::Enter), "write"),
            (FootKey::Of(Action::FocusNext), "complete path"),
            (FootKey::Of(Action::Back), "close"),
        ]
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        match self.ask.press(app, key, true) {
            Step::Accept { overwrite } => {
                let table = |app: &App| {
                    let table = pages::of(app.tab).table(app).map(Content::Page);
                    table.ok_or_else(|| "the result to write no longer exists".to_owned())
                };
                let path = self.ask.path(app, "table.csv");
                let task = path.and_then(|path| export(app, path, overwrite, table));
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
        exported(&mut self.ask, directory, report)
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let path = app.files.directory.join(self.ask.value());
        let other = instead_of_table(&path).unwrap_or(
            "a name that ends in .svg writes the charts on the screen, .html the report of the scene",
        );
        let hint = format!("to {}\n{other}", path.display());
        self.ask.draw(app, (PaneFrame::new(self.title), "file  ", hint), screen, canvas);
    }
}

/// What a report of an effect is to a dialog that exports.
pub(super) fn exported(ask: &mut Ask, directory: &Path, report: &EffectReport) -> Option<Outcome> {
    match report {
        EffectReport::Exported(path, outcome) if ask.is_of(directory, path) => {
            Some(match outcome {
                ExportOutcome::Written(_) => Outcome::Closes,
                ExportOutcome::Failed(text) => ask.ended::<()>(&Err(text.clone())),
                ExportOutcome::Exists(_) => {
                    ask.question = true;
                    Outcome::Stays
                }
            })
        }
        EffectReport::Completions(names) => Some(ask.complete(names)),
        _ => None,
    }
}

/// Write a path: the report of the scene, which is computed first, the charts on the screen, or the table, by its ending.
pub(super) fn export(
    app: &mut App,
    path: PathBuf,
    overwrite: bool,
    table: impl FnOnce(&App) -> Result<Content, String>,
) -> Result<Option<FileTask>, String> {
    let existing = Existing::replaced(overwrite);
    if is_report(&path) {
        let to = Destination { path, existing, has_scene: false };
        return report::write(app, to).map(|()| None);
    }
    let content = if is_svg(&path) {
        let drawn = pages::pictures(app);
        if drawn.is_empty() {
            return Err(
                "no chart on the screen can be drawn as SVG: write the table to a .csv file"
                    .to_owned(),
            );
        }
        Content::Text(svg::file(&drawn))
    } else {
        table(app)?
    };
    Ok(Some(FileTask::Export(Destination { path, existing, has_scene: true }, content)))
}

/// What is written to a path instead of the table, by its ending.
pub(super) fn instead_of_table(path: &Path) -> Option<&'static str> {
    if is_svg(path) {
        return Some("the charts on the screen, as SVG");
    }
    is_report(path).then_some("the report: inputs, results, charts, limit, sweep")
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}
