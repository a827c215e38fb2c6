//! The export of the table that a page shows.

use std::path::{Path, PathBuf};

use crate::files::atomic::Existing;
use crate::files::export::Destination;
use crate::files::report::is_report;
use crate::report::svg;
use crate::tui::app::dialog::{Dialog, FootKey, Footer};
use crate::tui::dialogs::ask::{Ask, Asking, Purpose};
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask};
use crate::tui::pages;
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
    Some(Asking::open(ExportTable { title: table.title }, TextField::new(table.file)))
}

#[derive(Clone, Debug)]
struct ExportTable {
    /// What the table is.
    title: &'static str,
}

impl Purpose for ExportTable {
    fn footer(&self) -> Footer {
        &[
            (FootKey::Of(Action::Enter), "write"),
            (FootKey::Of(Action::FocusNext), "complete path"),
            (FootKey::Of(Action::Back), "close"),
        ]
    }

    fn accept(
        &self,
        app: &App,
        ask: &mut Ask,
        overwrite: bool,
    ) -> Result<Option<FileTask>, String> {
        let path = ask.path(app, "table.csv")?;
        export(app, path, overwrite, |app| {
            let table = pages::of(app.tab).table(app).map(Content::Page);
            table.ok_or_else(|| "the result to write no longer exists".to_owned())
        })
    }

    fn ended(&self, ask: &Ask, directory: &Path, report: &EffectReport) -> Option<ExportOutcome> {
        exported(ask, directory, report)
    }

    fn title(&self) -> (&'static str, &'static str) {
        (self.title, "file  ")
    }

    fn hint(&self, app: &App, ask: &Ask) -> String {
        let path = app.files.directory.join(ask.value());
        let other = instead_of_table(&path)
            .unwrap_or("a name that ends in .svg writes the charts on the screen");
        format!("to {}\n{other}", path.display())
    }
}

/// How the export that a dialog asked for has ended.
pub(super) fn exported(
    ask: &Ask,
    directory: &Path,
    report: &EffectReport,
) -> Option<ExportOutcome> {
    match report {
        EffectReport::Exported(path, outcome) if ask.is_of(directory, path) => {
            Some(outcome.clone())
        }
        _ => None,
    }
}

/// Write to a path the charts on the screen, or the table, by its ending.
pub(super) fn export(
    app: &App,
    path: PathBuf,
    overwrite: bool,
    table: impl FnOnce(&App) -> Result<Content, String>,
) -> Result<Option<FileTask>, String> {
    if is_report(&path) {
        return Err(format!(
            "{}: the ending is a report's, and here a .csv table or .svg charts are written: name it so, or save the scene and run \
             `cmra report FILE.toml -o FILE.html`",
            path.display()
        ));
    }
    let existing = Existing::replaced(overwrite);
    let content = if is_svg(&path) {
        let drawn = pages::pictures(pages::of(app.tab), app);
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
    is_svg(path).then_some("the charts on the screen, as SVG")
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}
