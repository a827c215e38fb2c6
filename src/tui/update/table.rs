//! The dialog that writes a tab's table: a path, and the question before a file is replaced.

use crossterm::event::KeyEvent;
use tui_input::Input;

use super::path;
use crate::files::error::FileError;
use crate::files::{limit, stability, thesis};
use crate::study::thesis::Row;
use crate::tui::app::App;
use crate::tui::app::dialog::{Dialog, Save, Table};
use crate::tui::app::notice::Severity;
use crate::tui::app::runs::name_of;
use crate::tui::app::thesis::Page;
use crate::tui::message::Effect;

/// Open the dialog on a table, if there is anything in it.
pub(super) fn open(app: &mut App, table: Table) {
    if text(app, table).is_none() {
        app.say(Severity::Error, "nothing to export yet: r computes it");
        return;
    }
    let name = match table {
        Table::Limit => {
            let Some(report) = &app.limit.report else { return };
            format!("{}-limit.csv", path::stem(app, &report.scene))
        }
        Table::Map => {
            let Some((scene, _)) = &app.stability.map else { return };
            format!("{}-map.csv", path::stem(app, scene))
        }
        Table::Battery => "battery.csv".to_owned(),
        Table::Search => app.searching.page.file().to_owned(),
        Table::Thesis => match app.thesis.page {
            Page::Claims => "claims.csv",
            Page::Principles => "principles.csv",
            Page::Screening => "screening.csv",
        }
        .to_owned(),
    };
    let (fresh, question) = (false, false);
    let save = Save { input: Input::new(name), fresh, question, error: None };
    app.dialog = Some(Dialog::ExportTable(table, save));
}

/// What there is to be written.
fn text(app: &App, table: Table) -> Option<Result<String, FileError>> {
    match table {
        Table::Limit => {
            let report = app.limit.report.as_ref().filter(|report| !report.shots.is_empty())?;
            let name = name_of(&report.scene, &app.base.name, &app.base.scene);
            Some(limit::shots(&name, report).csv())
        }
        Table::Map => {
            let (scene, map) = app.stability.map.as_ref()?;
            let name = name_of(scene, &app.base.name, &app.base.scene);
            Some(stability::map_rows(&name, map).csv())
        }
        Table::Battery => {
            let rows = app.stability.rows();
            (!rows.is_empty()).then(|| stability::csv(rows))
        }
        Table::Search => app.search_csv(),
        Table::Thesis => thesis_page(app),
    }
}

/// The page of the Thesis tab: of the claims those that are shown, so far as they are checked.
fn thesis_page(app: &App) -> Option<Result<String, FileError>> {
    let tab = &app.thesis;
    Some(match tab.page {
        Page::Claims => {
            let shown: Vec<Row> = tab.shown().into_iter().cloned().collect();
            if shown.is_empty() {
                return None;
            }
            thesis::rows(&shown).csv()
        }
        Page::Principles => thesis::principles().csv(),
        Page::Screening => thesis::screening(&tab.weights).csv(),
    })
}

/// A key while the dialog is open.
pub(super) fn press(app: &mut App, table: Table, state: Save, key: KeyEvent) -> Vec<Effect> {
    let write = |app: &App, state: &mut Save, overwrite| write(app, table, state, overwrite);
    path::press(app, state, key, write, |state| Dialog::ExportTable(table, state))
}

fn write(app: &App, table: Table, state: &mut Save, overwrite: bool) -> Vec<Effect> {
    let Some(path) = path::typed(app, state, "table.csv") else { return Vec::new() };
    match text(app, table) {
        Some(Ok(text)) => return vec![Effect::ExportTable { path, overwrite, text }],
        Some(Err(error)) => state.error = Some(error.to_string()),
        None => {}
    }
    Vec::new()
}
