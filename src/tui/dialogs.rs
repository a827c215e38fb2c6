//! What lies on top of the panes: help, palette, preset picker, list of edits, saving, exporting.

pub(in crate::tui) mod ask;
pub(in crate::tui) mod curve;
pub(in crate::tui) mod export;
pub(in crate::tui) mod help;
pub(in crate::tui) mod history;
pub(in crate::tui) mod list;
pub mod options;
pub mod palette;
pub(in crate::tui) mod popup;
pub(in crate::tui) mod presets;
pub(in crate::tui) mod words;

use crate::files::export::Meta;
use crate::files::style::Style;
use crate::report::run::Rows;
use crate::tui::app::App;
use crate::tui::app::find::{rank, ranked};
use crate::tui::keymap::{Action, LINES, Line, Scope};
use crate::tui::message::PresetEntry;
use crate::tui::pages;
use crate::tui::widgets::input::TextField;

/// The dialog on top.
#[derive(Clone, Debug)]
pub enum Dialog {
    /// A list to choose from.
    List(List, Picker),
    /// A question that a text answers.
    Ask(Ask),
    /// What to export and where.
    Export(Box<Export>),
}

impl Dialog {
    /// The field that takes characters, if one does.
    pub fn field_mut(&mut self) -> Option<&mut TextField> {
        match self {
            Self::List(_, picker) => picker.typing.then_some(&mut picker.filter),
            Self::Ask(ask) => Some(&mut ask.text),
            Self::Export(export) => export.field_mut(),
        }
    }
}

/// What a list is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// Keys, and what the selected variable means.
    Help,
    /// Every action by name.
    Palette,
    /// Presets to load.
    Presets,
    /// The edits of this session.
    History,
    /// The words the selected variable can be.
    Words,
    /// The options.
    Options,
}

impl List {
    /// The dialog with this row selected.
    pub fn at(self, selected: usize) -> Dialog {
        Dialog::List(self, Picker { selected, ..Picker::default() })
    }

    /// The dialog whose filter takes characters at once.
    pub fn typing(self) -> Dialog {
        Dialog::List(self, Picker { typing: true, ..Picker::default() })
    }
}

/// The state of a list with a filter.
#[derive(Clone, Debug, Default)]
pub struct Picker {
    /// The filter.
    pub filter: TextField,
    /// Characters go into the filter.
    pub typing: bool,
    /// The selected row of those that pass the filter.
    pub selected: usize,
}

/// A dialog for one text: a preset's name, or a path.
#[derive(Clone, Debug)]
pub struct Ask {
    /// What the text is for.
    pub purpose: Purpose,
    /// The text.
    pub text: TextField,
    /// A preset or file of this name exists: the answer to "overwrite?" is awaited.
    pub question: bool,
}

/// What a text is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The name to save the scene under.
    Preset,
    /// The file to write the page's table to; what the table is.
    Table(&'static str),
    /// The file that has a spring's measured curve (of the second spring: true).
    Curve(bool),
}

/// The rows of the export dialog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportRow {
    /// Which rows: four kinds.
    What,
    /// CSV dialect.
    Style,
    /// Where the scene goes.
    Meta,
    /// Number of rows of a uniform grid.
    GridRows,
    /// A run, by its row in the table of runs.
    Run(usize),
    /// A column, by index.
    Column(usize),
    /// The file.
    Path,
}

/// The kinds of export.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// The solver's steps and enough between them.
    Series,
    /// A uniform grid.
    Grid,
    /// One row a run.
    Results,
    /// The events.
    Events,
}

impl What {
    /// All kinds, in order.
    pub const ALL: [Self; 4] = [Self::Series, Self::Grid, Self::Results, Self::Events];

    /// What it is, in words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Series => "time series: solver steps and points between",
            Self::Grid => "time series on a uniform grid",
            Self::Results => "results: one row per run",
            Self::Events => "events with their times",
        }
    }

    /// The rows; so many of a grid.
    pub(in crate::tui) fn rows(self, grid: usize) -> Rows {
        match self {
            Self::Series => Rows::Series,
            Self::Grid => Rows::Grid(grid),
            Self::Results => Rows::Results,
            Self::Events => Rows::Events,
        }
    }
}

/// The export dialog.
#[derive(Clone, Debug)]
pub struct Export {
    /// Which rows.
    pub what: What,
    /// Rows of a uniform grid, as typed.
    pub grid: TextField,
    /// The runs: name, and whether it goes along.
    pub runs: Vec<(String, bool)>,
    /// The columns of a series: name, and whether it goes along.
    pub columns: Vec<(&'static str, bool)>,
    /// The file.
    pub path: TextField,
    /// CSV dialect.
    pub style: Style,
    /// Where the scene goes.
    pub meta: Meta,
    /// The selected row.
    pub row: ExportRow,
    /// The file exists: the answer to "overwrite?" is awaited.
    pub question: bool,
    /// Names that complete the path.
    pub completions: Vec<String>,
    /// Why it cannot be done.
    pub error: Option<String>,
}

impl Export {
    /// The rows there are now, in order: the grid's number only for a grid, columns only for a series.
    pub fn rows(&self) -> Vec<ExportRow> {
        let mut rows = vec![ExportRow::Path, ExportRow::What];
        if self.what == What::Grid {
            rows.push(ExportRow::GridRows);
        }
        rows.extend((0..self.runs.len()).map(ExportRow::Run));
        if self.is_series() {
            rows.extend((0..self.columns.len()).map(ExportRow::Column));
        }
        rows.extend([ExportRow::Style, ExportRow::Meta]);
        rows
    }

    /// Whether the columns can be chosen.
    pub(in crate::tui) fn is_series(&self) -> bool {
        matches!(self.what, What::Series | What::Grid)
    }

    /// The columns that are chosen of a series; none of another table.
    pub(in crate::tui) fn chosen_columns(&self) -> Vec<String> {
        let chosen = self.columns.iter().filter(|(_, on)| *on && self.is_series());
        chosen.map(|(name, _)| (*name).to_owned()).collect()
    }

    /// The field of the selected row, if it has one.
    pub fn field_mut(&mut self) -> Option<&mut TextField> {
        match self.row {
            ExportRow::Path => Some(&mut self.path),
            ExportRow::GridRows => Some(&mut self.grid),
            _ => None,
        }
    }

    /// Change what the selected row chooses, round and round; whether it chooses anything.
    pub fn choose(&mut self, by: isize) -> bool {
        match self.row {
            ExportRow::What => self.what = around(&What::ALL, self.what, by),
            ExportRow::Style => self.style = around(&Style::ALL, self.style, by),
            ExportRow::Meta => self.meta = around(&Meta::ALL, self.meta, by),
            ExportRow::GridRows | ExportRow::Run(_) | ExportRow::Column(_) | ExportRow::Path => {
                return false;
            }
        }
        self.error = None;
        true
    }

    /// Move the selection, stopping at the ends.
    pub fn move_by(&mut self, by: isize) {
        let rows = self.rows();
        let here = rows.iter().position(|row| *row == self.row).unwrap_or(0);
        self.row = rows[here.saturating_add_signed(by).min(rows.len() - 1)];
    }
}

/// The one by this many places further on, round and round.
fn around<T: Copy + PartialEq>(all: &[T], one: T, by: isize) -> T {
    let at = all.iter().position(|other| *other == one).unwrap_or(0);
    all[wrap(at, by, all.len())]
}

/// `at` moved by `by` within `0..count`, round and round.
pub fn wrap(at: usize, by: isize, count: usize) -> usize {
    let count = isize::try_from(count.max(1)).unwrap_or(1);
    let at = isize::try_from(at).unwrap_or(0);
    usize::try_from((at + by).rem_euclid(count)).unwrap_or(0)
}

/// A row of help.
#[derive(Clone, Debug)]
pub struct HelpRow {
    /// Its keys.
    pub keys: String,
    /// The pane they belong to; empty where they work everywhere.
    pub pane: &'static str,
    /// What they do.
    pub help: &'static str,
    /// What Enter calls.
    pub action: Action,
}

/// What help lists: the keys of the focused pane first, with what they do there, then those that work everywhere.
pub fn help_rows(app: &App, typed: &str) -> Vec<HelpRow> {
    let pane = pages::spec(app.pane());
    let own = pane.keys.iter().map(|row| HelpRow {
        keys: app.keymap.label(row.action),
        pane: pane.label,
        help: row.help,
        action: row.action,
    });
    let lines = |everywhere: bool| {
        let scoped = move |line: &&Line| (line.scope == Scope::Everywhere) == everywhere;
        let label = if everywhere { "" } else { pane.label };
        LINES.iter().filter(|line| line.works_in(pane)).filter(scoped).map(move |line| HelpRow {
            keys: app.keymap.line_label(line),
            pane: label,
            help: line.meaning,
            action: line.keys[0].0,
        })
    };
    let rows = own.chain(lines(false)).chain(lines(true));
    ranked(rows, |row| rank(typed, &[&row.keys], row.help))
}

/// The presets that match, best first; all of them in their order when nothing is typed.
pub fn preset_rows<'a>(presets: &'a [PresetEntry], typed: &str) -> Vec<&'a PresetEntry> {
    ranked(presets.iter(), |entry| {
        rank(typed, &[&entry.name], &format!("{} {}", entry.origin, entry.scene.title))
    })
}
