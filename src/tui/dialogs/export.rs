//! The export of what a page shows: its table or its runs as CSV, its charts as SVG.

use std::path::Path;

use crate::files::atomic::Existing;
use crate::files::export::Destination;
use crate::files::report::is_report;
use crate::report::run::NamedRun;
use crate::report::svg;
use crate::tui::app::dialog::Dialog;
use crate::tui::dialogs::ask::{Ask, Asking, Purpose};
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask};
use crate::tui::pages;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

/// Ask for the file to write what is shown to, if there is anything in it.
pub(super) fn open(app: &mut App) -> Option<Box<dyn Dialog>> {
    let (title, file) = match content(app) {
        None => {
            app.refuse(pages::nothing_yet(app, "export"));
            return None;
        }
        Some(Content::Page(table)) => (table.title, table.file),
        Some(_) => ("Export the runs to CSV", format!("{}.csv", app.base_stem())),
    };
    Some(Asking::open(Export { title }, TextField::new(file)))
}

/// What the page shows as a table: of runs the current one and the pins, those with a result.
fn content(app: &App) -> Option<Content> {
    if !app.shows_runs() {
        return pages::of(app.tab).table(app).map(Content::Page);
    }
    let now = app.shown.iter().map(|shown| ("now".to_owned(), shown.run.clone()));
    let pins = app.pins.iter().filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)));
    let runs: Vec<NamedRun> = now.chain(pins).collect();
    (!runs.is_empty()).then_some(Content::Runs(runs))
}

#[derive(Debug)]
struct Export {
    /// What the table is.
    title: &'static str,
}

impl Purpose for Export {
    const FOOTER: &'static str = "<enter> write  <back> close";

    fn accept(
        &self,
        app: &App,
        ask: &mut Ask,
        overwrite: bool,
    ) -> Result<Option<FileTask>, String> {
        let path = ask.path(app, "table.csv")?;
        if is_report(&path) {
            return Err(format!(
                "{}: the ending is a report's, and here a .csv table or .svg charts are written: name it so, or save the scene and run \
                 `cmra report FILE.toml -o FILE.html`",
                path.display()
            ));
        }
        let content = if is_svg(&path) {
            let drawn = pages::pictures(pages::of(app.tab), app);
            let none = "no chart on the screen can be drawn as SVG: write the table to a .csv file";
            (!drawn.is_empty()).then(|| Content::Text(svg::file(&drawn))).ok_or(none)?
        } else {
            content(app).ok_or("the result to write no longer exists")?
        };
        let existing = Existing::replaced(overwrite);
        Ok(Some(FileTask::Export(Destination { path, existing }, content)))
    }

    fn ended(&self, ask: &Ask, directory: &Path, report: &EffectReport) -> Option<ExportOutcome> {
        match report {
            EffectReport::Exported(path, outcome) if ask.is_of(directory, path) => {
                Some(outcome.clone())
            }
            _ => None,
        }
    }

    fn title(&self) -> (&'static str, &'static str) {
        (self.title, "file  ")
    }

    fn hint(&self, app: &App, ask: &Ask) -> String {
        let path = app.files.directory.join(ask.value());
        let what = if is_svg(&path) {
            "the charts on the screen, as SVG"
        } else {
            "a name that ends in .svg writes the charts on the screen"
        };
        format!("to {}\n{what}", path.display())
    }
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}
