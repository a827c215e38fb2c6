//! The dialog that writes a tab's table: a path, and the question before a file is replaced.

use std::sync::Arc;

use crossterm::event::KeyEvent;
use tui_input::Input;

use crate::files::sweep;
use crate::report::{accuracy, compare, limit, stability, thesis};
use crate::study::sweep::Axis;
use crate::study::thesis::Row;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::{Dialog, Save, Table, path};
use crate::tui::keymap::Pane;
use crate::tui::message::{Content, Effect};
use crate::tui::pages::run::runs::name_of;

/// Open the dialog on a table, if there is anything in it.
pub(in crate::tui) fn open(app: &mut App, table: Table) {
    let Some(name) = content(app, table).and_then(|_| file(app, table)) else {
        app.say(Severity::Error, "nothing to export yet: press r to compute it");
        return;
    };
    let (all_selected, question) = (false, false);
    let save = Save { input: Input::new(name), all_selected, question, error: None };
    app.dialog = Some(Dialog::ExportTable(table, save));
}

/// Copy a table to the clipboard.
pub(in crate::tui) fn copy(app: &mut App, table: Table) -> Vec<Effect> {
    let text = match content(app, table) {
        Some(Content::Text(text)) => Ok(text),
        Some(Content::Grid(name, grid)) => sweep::grid_csv(&name, &grid)
            .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
            .map_err(|error| error.to_string()),
        Some(Content::Accuracy(found)) => Ok(accuracy::table(std::slice::from_ref(&*found)).csv()),
        None => Err("nothing to copy yet: press r to compute it".to_owned()),
    };
    match text {
        Ok(text) => vec![Effect::Copy(text)],
        Err(why) => {
            app.say(Severity::Error, why);
            Vec::new()
        }
    }
}

/// The file proposed for a table.
fn file(app: &App, table: Table) -> Option<String> {
    Some(match table {
        Table::Explore => {
            let found = app.sweeping.found(app.picture())?;
            let names: Vec<&str> = found.grid.plan().axes().iter().map(Axis::symbol).collect();
            format!("{}-{}.csv", path::base_stem(app), names.join("-"))
        }
        Table::Accuracy => {
            let report = app.accuracy.report.as_ref()?;
            format!("{}-accuracy.csv", path::stem(app, &report.scene))
        }
        Table::Limit => {
            let report = app.limit.report.as_ref()?;
            format!("{}-limit.csv", path::stem(app, &report.scene))
        }
        Table::Comparison => format!("{}-compare.csv", path::base_stem(app)),
        Table::EfficiencyMap => format!("{}-mass-efficiency.csv", path::base_stem(app)),
        Table::Map => {
            let (scene, _) = app.stability.map.as_ref()?;
            format!("{}-map.csv", path::stem(app, scene))
        }
        Table::Battery => "battery.csv".to_owned(),
        Table::Search => app.searching.page.file().to_owned(),
        Table::Thesis => match app.pane() {
            Pane::Principles => "principles.csv",
            Pane::Screening => "screening.csv",
            _ => "claims.csv",
        }
        .to_owned(),
    })
}

/// What there is to be written.
fn content(app: &App, table: Table) -> Option<Content> {
    let name = |scene| name_of(scene, &app.base.name, &app.base.scene);
    let text = match table {
        Table::Explore => {
            let found = app.sweeping.found(app.picture())?;
            let name = name(found.grid.plan().base());
            return Some(Content::Grid(name, Arc::clone(&found.grid)));
        }
        Table::Accuracy => {
            let report = app.accuracy.report.as_ref()?;
            let found = Box::new((name(&report.scene), (**report).clone()));
            return Some(Content::Accuracy(found));
        }
        Table::Limit => {
            let report = app.limit.report.as_ref().filter(|report| !report.shots.is_empty())?;
            limit::shots(&name(&report.scene), report).csv()
        }
        Table::Comparison => {
            let (scene, found) = app.limit.comparison.as_ref()?;
            compare::table(&name(scene), &found.report).csv()
        }
        Table::EfficiencyMap => {
            let (scene, found) = app.limit.comparison.as_ref()?;
            compare::map_table(&name(scene), found.map.as_ref()?).csv()
        }
        Table::Map => {
            let (scene, map) = app.stability.map.as_ref()?;
            stability::map_table(&name(scene), map).csv()
        }
        Table::Battery => {
            let rows = app.stability.rows();
            if rows.is_empty() {
                return None;
            }
            stability::table(rows).csv()
        }
        Table::Search => app.search_csv()?,
        Table::Thesis => thesis_page(app)?,
    };
    Some(Content::Text(text))
}

/// The page of the Thesis tab: of the claims those that are shown, so far as they are checked.
fn thesis_page(app: &App) -> Option<String> {
    Some(match app.pane() {
        Pane::Principles => thesis::principles().csv(),
        Pane::Screening => thesis::screening(&app.thesis.weights).csv(),
        _ => {
            let shown: Vec<Row> = app.claims().into_iter().cloned().collect();
            if shown.is_empty() {
                return None;
            }
            thesis::claims(&shown).csv()
        }
    })
}

/// A key while the dialog is open.
pub(in crate::tui) fn press(
    app: &mut App,
    table: Table,
    state: Save,
    key: KeyEvent,
) -> Vec<Effect> {
    let write = |app: &App, state: &mut Save, overwrite| write(app, table, state, overwrite);
    path::press(app, state, key, write, |state| Dialog::ExportTable(table, state))
}

fn write(app: &App, table: Table, state: &mut Save, overwrite: bool) -> Vec<Effect> {
    let Some(path) = path::typed(app, state, "table.csv") else { return Vec::new() };
    let effect = |content| Effect::ExportTable { path, overwrite, content };
    content(app, table).map(effect).into_iter().collect()
}
