//! What lies on top of the panes: help, palette, preset picker, list of edits, saving, exporting.

use tui_input::Input;

use super::App;
use crate::files::export::Meta;
use crate::files::style::Style;
use crate::tui::message::{BINDINGS, Binding, Place, PresetEntry};

/// The dialog on top.
#[derive(Clone, Debug)]
pub enum Dialog {
    /// Keys, and what the selected variable means.
    Help(Picker),
    /// Every action by name.
    Palette(Picker),
    /// Presets to load.
    Presets(Picker),
    /// The edits of this session.
    History(Picker),
    /// The words the selected variable can be.
    Words(Picker),
    /// A name to save under.
    Save(Save),
    /// What to export and where.
    Export(Box<Export>),
    /// Where to write what was measured of the methods: a path.
    ExportAccuracy(Save),
    /// Where to write what a sweep found: a path.
    ExportSweep(Save),
    /// Where to write another table: a path.
    ExportTable(Table, Save),
    /// Which file a spring's measured curve is in (of the second spring: true): a path.
    Curve(bool, Save),
}

/// A table that a tab writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// The shots of the Limit tab.
    Limit,
    /// The map of the Stability tab.
    Map,
    /// Its battery.
    Battery,
    /// What the Search tab shows.
    Search,
    /// The page of the Thesis tab.
    Thesis,
}

impl Table {
    /// What is written, for the dialog's frame.
    pub fn title(self) -> &'static str {
        match self {
            Self::Limit => "Export the shots to CSV",
            Self::Map => "Export the map to CSV",
            Self::Battery => "Export the battery to CSV",
            Self::Search => "Export what was found to CSV",
            Self::Thesis => "Export this page to CSV",
        }
    }
}

/// A list with a filter.
#[derive(Clone, Debug, Default)]
pub struct Picker {
    /// The filter's text.
    pub filter: Input,
    /// Characters go into the filter.
    pub typing: bool,
    /// The selected row of those that pass the filter.
    pub selected: usize,
}

impl Picker {
    /// A list whose filter takes characters at once.
    pub fn typing() -> Self {
        Self { typing: true, ..Self::default() }
    }

    /// A list with a row selected.
    pub fn at(selected: usize) -> Self {
        Self { selected, ..Self::default() }
    }
}

/// A dialog for one text: a preset's name, or a path.
#[derive(Clone, Debug)]
pub struct Save {
    /// The text.
    pub input: Input,
    /// The text is the proposed one: the first character replaces it.
    pub fresh: bool,
    /// A preset or file of this name exists: the answer to "overwrite?" is awaited.
    pub question: bool,
    /// Why the text is no good, or saving failed.
    pub error: Option<String>,
}

/// The rows of the export dialog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportRow {
    /// Which rows: four kinds.
    What,
    /// How the table is spelt.
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
    pub fn words(self) -> &'static str {
        match self {
            Self::Series => "time series: solver steps and points between",
            Self::Grid => "time series on a uniform grid",
            Self::Results => "results: one row per run",
            Self::Events => "events with their times",
        }
    }
}

/// The export dialog.
#[derive(Clone, Debug)]
pub struct Export {
    /// Which rows.
    pub what: What,
    /// Rows of a uniform grid, as typed.
    pub grid: Input,
    /// The runs: name, and whether it goes along.
    pub runs: Vec<(String, bool)>,
    /// The columns of a series: name, and whether it goes along.
    pub columns: Vec<(&'static str, bool)>,
    /// The file.
    pub path: Input,
    /// How the table is spelt.
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
        if matches!(self.what, What::Series | What::Grid) {
            rows.extend((0..self.columns.len()).map(ExportRow::Column));
        }
        rows.extend([ExportRow::Style, ExportRow::Meta]);
        rows
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

/// The bindings the help overlay lists: the focused pane first, then those that work anywhere, then those of the other panes,
/// the tab's own before all others.
pub fn help_rows(app: &App, filter: &str) -> Vec<&'static Binding> {
    let wanted = filter.to_lowercase();
    let mut places = vec![app.place(), Place::Anywhere];
    places.extend(beside(app));
    in_order(&places)
        .filter(|row| {
            row.help.to_lowercase().contains(&wanted)
                || row.short.to_lowercase().contains(&wanted)
                || row.keys.iter().any(|key| key.words().to_lowercase() == wanted)
        })
        .collect()
}

/// The actions that match what was typed in the palette, best first, each once: as the focused pane has it, or another pane
/// of the tab, where one has it.
pub fn palette_rows(app: &App, typed: &str) -> Vec<&'static Binding> {
    let mut places = vec![app.place()];
    places.extend(beside(app));
    let mut seen = Vec::new();
    let mut ranked: Vec<(usize, &'static Binding)> = Vec::new();
    for row in in_order(&places) {
        if row.is_movement() || seen.contains(&row.action) {
            continue;
        }
        let text = format!("{} {}", row.short, row.help);
        if let Some(rank) = fuzzy(typed, &text) {
            seen.push(row.action);
            ranked.push((rank, row));
        }
    }
    ranked.sort_by_key(|(rank, _)| *rank);
    ranked.into_iter().map(|(_, row)| row).collect()
}

/// The other panes of the tab.
fn beside(app: &App) -> impl Iterator<Item = Place> {
    let here = app.place();
    app.panes().iter().copied().filter(move |place| *place != here)
}

/// All bindings: those of some places in their order, then the others as they stand in the table.
fn in_order(places: &[Place]) -> impl Iterator<Item = &'static Binding> {
    let last = places.len();
    let mut rows: Vec<&'static Binding> = BINDINGS.iter().collect();
    rows.sort_by_key(|row| places.iter().position(|place| *place == row.place).unwrap_or(last));
    rows.into_iter()
}

/// The presets whose name or origin matches, best first; all of them in their order when nothing is typed.
pub fn preset_rows<'a>(presets: &'a [PresetEntry], typed: &str) -> Vec<&'a PresetEntry> {
    let mut ranked: Vec<(usize, &PresetEntry)> = presets
        .iter()
        .filter_map(|entry| {
            let text = format!("{} {} {}", entry.name, entry.origin, entry.scene.title);
            fuzzy(typed, &text).map(|rank| (rank, entry))
        })
        .collect();
    ranked.sort_by_key(|(rank, _)| *rank);
    ranked.into_iter().map(|(_, entry)| entry).collect()
}

/// Whether the characters of `typed` occur in `text` in order, and how far apart (smaller is better).
pub fn fuzzy(typed: &str, text: &str) -> Option<usize> {
    let wanted: Vec<char> = typed.to_lowercase().chars().filter(|c| !c.is_whitespace()).collect();
    let text: Vec<char> = text.to_lowercase().chars().collect();
    let Some(first) = wanted.first() else {
        return Some(0);
    };
    let starts = text.iter().enumerate().filter(|(_, c)| *c == first);
    starts
        .filter_map(|(start, _)| {
            let mut at = start;
            for (place, c) in wanted.iter().enumerate() {
                let rest = &text[at..];
                let step = rest.iter().position(|other| other == c)?;
                at += step + usize::from(place + 1 < wanted.len());
            }
            if at - start > 4 * wanted.len() {
                return None;
            }
            let begins_word = start == 0 || !text[start - 1].is_alphanumeric();
            Some((at - start) * 4 + usize::from(!begins_word) * 8 + start / 4)
        })
        .min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fuzzy_matches_a_subsequence_and_prefers_word_starts() {
        assert_eq!(fuzzy("", "anything"), Some(0));
        assert_eq!(fuzzy("xyz", "export runs to CSV"), None);
        assert!(fuzzy("exp", "export runs") < fuzzy("exp", "next pane"));
        assert!(fuzzy("pin", "pin this run") < fuzzy("pin", "unpin this run"));
    }
}
