//! The export dialog: what, which runs, which columns, and where.

pub(in crate::tui) mod draw;

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::atomic::Existing;
use crate::files::export::{Destination, Meta, RunTable};
use crate::files::style::Style;
use crate::report::run::{self, NamedRun, Rows};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::{Dialog, Export, ExportRow, What, ask};
use crate::tui::message::{Content, Effect, FileTask};
use crate::tui::widgets::input::TextField;

/// Rows of a grid when nothing else is asked for, and the most there may be.
const GRID_ROWS: (usize, usize) = (1001, 1_000_000);

/// Open the dialog on the runs there are.
pub(in crate::tui) fn open(app: &mut App) {
    let runs = available(app);
    if runs.is_empty() {
        app.say(Severity::Error, "nothing to export yet: r runs the scene");
        return;
    }
    let path = TextField::new(format!("{}.csv", ask::base_stem(app)));
    app.dialog = Some(Dialog::Export(Box::new(Export {
        what: What::Series,
        grid: TextField::new(GRID_ROWS.0.to_string()),
        runs: runs.into_iter().map(|(name, _)| (name, true)).collect(),
        columns: run::columns(Rows::Series, false).into_iter().map(|name| (name, true)).collect(),
        path,
        style: Style::default(),
        meta: Meta::default(),
        row: ExportRow::Path,
        question: false,
        completions: Vec::new(),
        error: None,
    })));
}

/// The runs that can be exported: the current one and the pins, those with a result.
fn available(app: &App) -> Vec<NamedRun> {
    let now = app.shown.iter().map(|shown| ("now".to_owned(), Arc::clone(&shown.run)));
    let pins = app.pins.iter().filter_map(|pin| {
        let run = pin.run.as_ref()?;
        Some((pin.letter.to_string(), Arc::clone(run)))
    });
    now.chain(pins).collect()
}

/// A key while the dialog is open.
pub(in crate::tui) fn press(app: &mut App, mut state: Export, key: KeyEvent) -> Vec<Effect> {
    let typing = matches!(state.row, ExportRow::Path | ExportRow::GridRows);
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Esc => return Vec::new(),
        KeyCode::Char('q') if !typing => return Vec::new(),
        KeyCode::Char('y' | 'o') if state.question => {
            effects = submit(app, &mut state, Existing::Replace);
        }
        KeyCode::Char('r') if state.question => rename(&mut state),
        KeyCode::Enter => effects = submit(app, &mut state, Existing::Keep),
        KeyCode::Tab if state.row == ExportRow::Path => {
            effects = vec![Effect::Files(FileTask::Complete(state.path.value().to_owned()))];
        }
        KeyCode::Down | KeyCode::Tab => state.move_by(1),
        KeyCode::Up | KeyCode::BackTab => state.move_by(-1),
        KeyCode::Char(c @ ('j' | 'k')) if !typing => state.move_by(if c == 'j' { 1 } else { -1 }),
        KeyCode::Left | KeyCode::Char('h') if !typing && state.choose(-1) => {}
        KeyCode::Right | KeyCode::Char('l' | ' ') if !typing && state.choose(1) => {}
        KeyCode::Char(' ') if !typing => toggle(&mut state),
        KeyCode::Char('a') if !typing => all_or_none(&mut state),
        _ => typed(&mut state, key),
    }
    app.dialog = Some(Dialog::Export(Box::new(state)));
    effects
}

/// A click on a row: it selects, and ticks or changes what was selected.
pub(in crate::tui) fn click(app: &mut App, row: usize) -> Vec<Effect> {
    let Some(Dialog::Export(state)) = &mut app.dialog else { return Vec::new() };
    let Some(row) = state.rows().get(row).copied() else { return Vec::new() };
    let again = state.row == row;
    state.row = row;
    match row {
        ExportRow::What | ExportRow::Style | ExportRow::Meta if again => drop(state.choose(1)),
        ExportRow::Run(_) | ExportRow::Column(_) if again => toggle(state),
        _ => {}
    }
    Vec::new()
}

fn typed(state: &mut Export, key: KeyEvent) {
    if state.field_mut().is_some_and(|field| field.press(key)) {
        state.question = false;
        state.error = None;
        state.completions.clear();
    }
}

fn toggle(state: &mut Export) {
    match state.row {
        ExportRow::Run(at) => state.runs[at].1 = !state.runs[at].1,
        ExportRow::Column(at) => state.columns[at].1 = !state.columns[at].1,
        ExportRow::What
        | ExportRow::Style
        | ExportRow::Meta
        | ExportRow::GridRows
        | ExportRow::Path => {}
    }
    state.error = None;
}

/// All runs (or columns) when one is missing, else none.
fn all_or_none(state: &mut Export) {
    match state.row {
        ExportRow::Run(_) => {
            let on = state.runs.iter().any(|(_, on)| !on);
            state.runs.iter_mut().for_each(|run| run.1 = on);
        }
        ExportRow::Column(_) => {
            let on = state.columns.iter().any(|(_, on)| !on);
            state.columns.iter_mut().for_each(|column| column.1 = on);
        }
        ExportRow::What
        | ExportRow::Style
        | ExportRow::Meta
        | ExportRow::GridRows
        | ExportRow::Path => {}
    }
}

/// `NAME.csv` becomes `NAME-2.csv`, and that `NAME-3.csv`.
fn rename(state: &mut Export) {
    state.path = TextField::new(ask::next_name(state.path.value()));
    state.row = ExportRow::Path;
    state.question = false;
}

fn submit(app: &App, state: &mut Export, existing: Existing) -> Vec<Effect> {
    match task(app, state, existing) {
        Ok(task) => {
            state.question = false;
            state.error = None;
            vec![Effect::Files(task)]
        }
        Err(error) => {
            state.error = Some(error);
            Vec::new()
        }
    }
}

fn task(app: &App, state: &Export, existing: Existing) -> Result<FileTask, String> {
    let path = ask::path_of(app, &state.path, "run.csv")?;
    let runs: Vec<NamedRun> = available(app)
        .into_iter()
        .filter(|(name, _)| state.runs.iter().any(|(listed, on)| *on && listed == name))
        .collect();
    if runs.is_empty() {
        return Err("no run is chosen: Space on a run ticks it".to_owned());
    }
    let grid =
        if state.what == What::Grid { grid_rows(state.grid.value(), runs.len())? } else { 0 };
    let mut columns = state.chosen_columns();
    if state.is_series() && columns.is_empty() {
        return Err("no column is chosen: Space on a column ticks it".to_owned());
    }
    if columns.len() == state.columns.len() {
        columns.clear();
    }
    let to = Destination { path, existing, meta: state.meta };
    let rows = state.what.rows(grid);
    Ok(FileTask::Export(to, Content::Runs(RunTable { rows, runs, columns, style: state.style })))
}

/// The number of rows typed; all runs together have no more than [`GRID_ROWS`] allows, since a table is made in memory.
fn grid_rows(text: &str, runs: usize) -> Result<usize, String> {
    let most = GRID_ROWS.1 / runs.max(1);
    let rows = text.trim().parse().ok().filter(|rows| (2..=most).contains(rows));
    rows.ok_or_else(|| {
        let of = if runs > 1 { format!(" for each of {runs} runs") } else { String::new() };
        format!("rows = `{}` is impossible: write a whole number from 2 to {most}{of}", text.trim())
    })
}
