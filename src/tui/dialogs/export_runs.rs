//! The export of runs: what, which runs, which columns.

use std::path::Path;
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::export::RunTable;
use crate::report::run::{self, NamedRun, Rows};
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::ask::{Ask, Asking, Purpose};
use crate::tui::dialogs::export_table::{export, exported, instead_of_table};
use crate::tui::dialogs::list::{frame, is_text};
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{clip, columns};
use crate::tui::widgets::{RowList, cycled};

pub(super) fn open(app: &mut App) -> Option<Box<dyn Dialog>> {
    if !app.shows_runs() {
        return None;
    }
    let runs = available(app);
    if runs.is_empty() {
        app.refuse("nothing to export yet: <run> runs the scene");
        return None;
    }
    let tick = |name: String, about: String| Tick { name, about, on: true };
    let about = |name: &str| {
        let pin = app.pins.iter().find(|pin| pin.letter.to_string() == name);
        pin.map_or_else(String::new, |pin| pin.name.clone())
    };
    let runs = runs.into_iter().map(|(name, _)| tick(name.clone(), about(&name)));
    let columns = run::columns(Rows::Series, false).into_iter();
    let columns = columns.map(|name| tick(name.to_owned(), String::new()));
    let (runs, columns) = (runs.collect(), columns.collect());
    let text = TextField::new(format!("{}.csv", app.base_stem()));
    Some(Asking::open(ExportRuns { kind: 0, runs, columns, selected: 0 }, text))
}

/// The kinds of table, with their words.
const KINDS: [(&str, Rows); 3] = [
    ("time series: solver steps and points between", Rows::Series),
    ("results: one row per run", Rows::Results),
    ("events with their times", Rows::Events),
];

/// Rows above the runs and columns: the path, and the kind of table.
const ABOVE: usize = 2;

/// What is chosen beside the file.
#[derive(Clone, Debug)]
struct ExportRuns {
    kind: usize,
    runs: Vec<Tick>,
    /// Those of a series.
    columns: Vec<Tick>,
    /// The selected row; the first one is the path.
    selected: usize,
}

/// Whether a run or a column goes along.
#[derive(Clone, Debug)]
struct Tick {
    name: String,
    /// The text after its name; may be empty.
    about: String,
    on: bool,
}

impl Purpose for ExportRuns {
    fn footer(&self) -> Footer {
        &[
            (FootKey::Of(Action::Enter), "write"),
            (FootKey::As("Up/Down"), "move"),
            (FootKey::Of(Action::Mark), "tick"),
            (FootKey::As("a"), "all or none"),
            (FootKey::Of(Action::FocusNext), "complete path"),
            (FootKey::Of(Action::Back), "close"),
        ]
    }

    fn press(&mut self, action: Option<Action>, key: KeyEvent) -> Option<Outcome> {
        match action {
            Some(Action::Down) => self.move_by(1),
            Some(Action::Up | Action::FocusPrevious) => self.move_by(-1),
            _ if self.types() => return None,
            Some(Action::FocusNext) => self.move_by(1),
            Some(Action::Left) => self.change(-1),
            Some(Action::Right | Action::Mark) => self.change(1),
            Some(Action::Quit) => return Some(Outcome::Closes),
            _ if !is_text(key) => return None,
            _ if key.code == KeyCode::Char('a') => self.all_or_none(),
            _ => {}
        }
        Some(Outcome::Stays)
    }

    fn types(&self) -> bool {
        self.selected == 0
    }

    /// A click selects a row, and ticks or changes what was selected.
    fn click(&mut self, row: usize) {
        if self.selected == row {
            self.change(1);
        }
        self.selected = row;
    }

    fn accept(
        &self,
        app: &App,
        ask: &mut Ask,
        overwrite: bool,
    ) -> Result<Option<FileTask>, String> {
        let path = ask.path(app, "run.csv")?;
        export(app, path, overwrite, |app| self.table(app).map(Content::Runs))
    }

    fn ended(&self, ask: &Ask, directory: &Path, report: &EffectReport) -> Option<ExportOutcome> {
        exported(ask, directory, report)
    }

    fn title(&self) -> (&'static str, &'static str) {
        ("Export to CSV (charts: .svg)", "file")
    }

    fn hint(&self, _: &App, ask: &Ask) -> String {
        let other = instead_of_table(Path::new(ask.value()));
        other.map_or_else(
            || "with a .toml file beside it that reproduces the same digits".to_owned(),
            |what| format!("{what}; choices are for tables"),
        )
    }

    fn draw(&self, app: &App, ask: &Ask, screen: Rect, canvas: &mut Canvas<'_>) {
        let count = self.count();
        let wanted = u16::try_from(count).unwrap_or(u16::MAX).saturating_add(FOOT + 3);
        let inner = frame(screen, (100, wanted), PaneFrame::new(self.title().0), canvas);
        let foot = FOOT.min(inner.height.saturating_sub(4));
        let list = Rect { height: inner.height.saturating_sub(foot), ..inner };
        let rows = RowList { count, selected: self.selected, painted: false };
        let target = |row| Some(Target::DialogRow(row));
        rows.render(canvas, list, target, |canvas, line, at| self.row(ask, at, line, canvas));
        let hidden = count.saturating_sub(rows.first(list.height) + usize::from(list.height));
        if hidden > 0 {
            let more = format!("({hidden} more below)");
            let column = list.width.saturating_sub(columns(&more));
            canvas.put(list, (column, list.height.saturating_sub(1)), &more, Role::Dim);
        }
        self.below(app, ask, Rect { y: list.bottom(), height: foot, ..inner }, canvas);
    }
}

/// Column the values begin in.
const VALUE: u16 = 11;
/// Rows below the list: absolute path, note or question, preview.
const FOOT: u16 = 8;

impl ExportRuns {
    fn is_series(&self) -> bool {
        KINDS[self.kind].1 == Rows::Series
    }

    /// Rows there are now: columns only for a series.
    fn count(&self) -> usize {
        ABOVE + self.runs.len() + if self.is_series() { self.columns.len() } else { 0 }
    }

    /// The runs or the columns, whichever have a row, and its place among them.
    fn group(&mut self, row: usize) -> Option<(&mut [Tick], usize)> {
        let (at, runs) = (row.checked_sub(ABOVE)?, self.runs.len());
        Some(match at.checked_sub(runs) {
            None => (&mut self.runs, at),
            Some(at) => (&mut self.columns, at),
        })
    }

    fn move_by(&mut self, by: isize) {
        self.selected = self.selected.saturating_add_signed(by).min(self.count() - 1);
    }

    /// Another kind of table, round and round, or another tick.
    fn change(&mut self, by: isize) {
        if self.selected == 1 {
            self.kind = cycled(self.kind, by, KINDS.len());
        } else if let Some((ticks, at)) = self.group(self.selected) {
            ticks[at].on = !ticks[at].on;
        }
    }

    /// All like the selected one when one is missing, else none.
    fn all_or_none(&mut self) {
        if let Some((ticks, _)) = self.group(self.selected) {
            let all = ticks.iter().any(|tick| !tick.on);
            for tick in ticks {
                tick.on = all;
            }
        }
    }

    /// The columns that are chosen of a series; none of another table.
    fn chosen(&self) -> Vec<String> {
        let chosen = self.columns.iter().filter(|tick| tick.on && self.is_series());
        chosen.map(|tick| tick.name.clone()).collect()
    }

    /// The table of what is chosen.
    fn table(&self, app: &App) -> Result<RunTable, String> {
        let is_chosen = |name: &str| self.runs.iter().any(|tick| tick.on && tick.name == name);
        let runs = available(app).into_iter().filter(|(name, _)| is_chosen(name));
        let runs: Vec<NamedRun> = runs.collect();
        if runs.is_empty() {
            return Err("no run is chosen: Space on a run ticks it".to_owned());
        }
        let mut columns = self.chosen();
        if self.is_series() && columns.is_empty() {
            return Err("no column is chosen: Space on a column ticks it".to_owned());
        }
        if columns.len() == self.columns.len() {
            columns.clear();
        }
        Ok(RunTable { rows: KINDS[self.kind].1, runs, columns })
    }

    fn row(&self, ask: &Ask, at: usize, line: Rect, canvas: &mut Canvas<'_>) {
        let columns = ABOVE + self.runs.len();
        let parts = [(0, "file"), (1, "what"), (ABOVE, "runs"), (columns, "columns")];
        if let Some((_, part)) = parts.iter().find(|(first, _)| *first == at) {
            canvas.put(line, (2, 0), part, Role::Title);
        }
        let here = self.selected == at;
        if here {
            canvas.put(line, (0, 0), ">", Role::Title);
        }
        let role = if here { Role::Selection } else { Role::Text };
        let ticks = self.runs.iter().chain(&self.columns);
        let text = match at {
            0 => {
                let width = line.width.saturating_sub(VALUE + 1);
                let area = Rect { x: line.x + VALUE, width, ..line };
                if here {
                    ask.draw_field(canvas, area);
                } else {
                    ask.text.put(canvas, area, role);
                }
                return;
            }
            1 => format!("< {} >", KINDS[self.kind].0),
            _ => ticks.skip(at - ABOVE).take(1).map(Tick::shown).collect(),
        };
        canvas.put(line, (VALUE, 0), &text, role);
    }

    /// The absolute path, then the question, error or completions, else the first lines.
    fn below(&self, app: &App, ask: &Ask, area: Rect, canvas: &mut Canvas<'_>) {
        let width = usize::from(area.width);
        let path = self.there(app, ask);
        canvas.put(area, (0, 1), &clip(&format!("to {path}"), width), Role::Text);
        canvas.put(area, (0, 2), &clip(&self.hint(app, ask), width), Role::Dim);
        let lines = ask.found(app, &path, area.width).unwrap_or_else(|| {
            let is_table = instead_of_table(Path::new(ask.value())).is_none();
            let preview = if is_table { self.preview(app) } else { String::new() };
            preview.lines().take(3).map(|line| (line.to_owned(), Role::Dim)).collect()
        });
        let lines = lines.into_iter().map(|(line, role)| (clip(&line, width), role));
        canvas.put_lines(area, 4, lines);
    }

    /// The first lines as they would be written.
    fn preview(&self, app: &App) -> String {
        let Some(shown) = &app.shown else { return String::new() };
        let named = [("now".to_owned(), Arc::clone(&shown.run))];
        run::csv(KINDS[self.kind].1, &named, &self.chosen(), 2).unwrap_or_default()
    }
}

impl Tick {
    fn shown(&self) -> String {
        let tick = if self.on { "[x]" } else { "[ ]" };
        format!("{tick} {} {}", self.name, self.about).trim_end().to_owned()
    }
}

/// The runs that can be exported: the current one and the pins, those with a result.
fn available(app: &App) -> Vec<NamedRun> {
    let now = app.shown.iter().map(|shown| ("now".to_owned(), Arc::clone(&shown.run)));
    let pins = app.pins.iter();
    now.chain(pins.filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)))).collect()
}
