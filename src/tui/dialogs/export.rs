//! The export of runs: what, which runs, which columns.

use std::path::Path;
use std::sync::Arc;

use crate::files::export::RunTable;
use crate::report::run::{self, NamedRun, Rows};
use crate::tui::app::status::clip;
use crate::tui::dialogs::{Ask, Purpose, ask, frame, wrap};
use crate::tui::prelude::*;
use crate::tui::widgets::RowList;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{TextLine, columns, wrapped};

/// Rows of a grid by default.
const GRID_ROWS: usize = 1001;
/// The most rows of grids that a table may have, since it is made in memory.
const GRID_ROWS_MAX: usize = 1_000_000;

/// A kind of table.
struct Kind {
    words: &'static str,
    /// Its rows; this many for a grid.
    rows: fn(usize) -> Rows,
}

const KINDS: [Kind; 4] = [
    Kind { words: "time series: solver steps and points between", rows: |_| Rows::Series },
    Kind { words: "time series on a uniform grid", rows: Rows::Grid },
    Kind { words: "results: one row per run", rows: |_| Rows::Results },
    Kind { words: "events with their times", rows: |_| Rows::Events },
];
const SERIES: usize = 0;
const GRID: usize = 1;

/// The part that a line belongs to, which stands at the left of its first line; lines of one part stand together.
type Part = &'static str;
const FILE: Part = "file";
const WHAT: Part = "what";
const ROWS: Part = "rows";
const RUNS: Part = "runs";
const COLUMNS: Part = "columns";

#[derive(Clone, Debug)]
enum Value {
    /// What the dialog asks for.
    Path,
    Text(TextField),
    /// One of some words.
    Choice(usize, Vec<&'static str>),
    /// Whether a run or a column goes along.
    Tick {
        name: String,
        /// The text after its name; may be empty.
        about: String,
        on: bool,
    },
}

#[derive(Clone, Debug)]
struct Line {
    part: Part,
    value: Value,
}

/// What is chosen beside the file; nothing for other files.
#[derive(Clone, Debug, Default)]
pub struct Choices {
    lines: Vec<Line>,
    /// The selected line; the first one is the path.
    pub(super) selected: usize,
}

impl Choices {
    /// The lines there are now: the grid's number only for a grid, columns only for a series.
    fn shown(&self) -> Vec<usize> {
        let is_shown = |at: &usize| match self.lines[*at].part {
            ROWS => self.choice(WHAT) == GRID,
            COLUMNS => self.is_series(),
            _ => true,
        };
        (0..self.lines.len()).filter(is_shown).collect()
    }

    fn of(&self, part: Part) -> impl Iterator<Item = &Value> {
        self.lines.iter().filter(move |line| line.part == part).map(|line| &line.value)
    }

    fn choice(&self, part: Part) -> usize {
        self.of(part)
            .find_map(|it| if let Value::Choice(at, _) = it { Some(*at) } else { None })
            .unwrap_or(0)
    }

    fn text(&self, part: Part) -> &str {
        self.of(part)
            .find_map(|it| if let Value::Text(field) = it { Some(field.value()) } else { None })
            .unwrap_or("")
    }

    fn ticked(&self, part: Part) -> Vec<&str> {
        self.of(part)
            .filter_map(|it| {
                if let Value::Tick { name, on: true, .. } = it { Some(&**name) } else { None }
            })
            .collect()
    }

    fn is_series(&self) -> bool {
        matches!(self.choice(WHAT), SERIES | GRID)
    }

    /// The columns that are chosen of a series; none of another table.
    fn columns(&self) -> Vec<String> {
        let chosen = if self.is_series() { self.ticked(COLUMNS) } else { Vec::new() };
        chosen.into_iter().map(str::to_owned).collect()
    }

    /// The field of the selected line, where that is not the path.
    pub(super) fn field_mut(&mut self) -> Option<&mut TextField> {
        match &mut self.lines.get_mut(self.selected)?.value {
            Value::Text(field) => Some(field),
            Value::Path | Value::Choice(..) | Value::Tick { .. } => None,
        }
    }

    /// Change what the selected line chooses, round and round, or tick it.
    pub(super) fn change(&mut self, by: isize) {
        match &mut self.lines[self.selected].value {
            Value::Choice(at, words) => *at = wrap(*at, by, words.len()),
            Value::Tick { on, .. } => *on = !*on,
            Value::Path | Value::Text(_) => {}
        }
    }

    /// All lines like the selected one when one is missing, else none.
    pub(super) fn all_or_none(&mut self) {
        let part = self.lines[self.selected].part;
        let all = self.of(part).any(|it| matches!(it, Value::Tick { on: false, .. }));
        for line in self.lines.iter_mut().filter(|line| line.part == part) {
            if let Value::Tick { on, .. } = &mut line.value {
                *on = all;
            }
        }
    }

    /// Move the selection, stopping at the ends.
    pub(super) fn move_by(&mut self, by: isize) {
        let shown = self.shown();
        let here = shown.iter().position(|at| *at == self.selected).unwrap_or(0);
        let next = here.saturating_add_signed(by).min(shown.len().saturating_sub(1));
        self.selected = shown.get(next).copied().unwrap_or(0);
    }

    /// A click on a row: it selects, and ticks or changes what was selected.
    pub(super) fn click(&mut self, row: usize) {
        let Some(row) = self.shown().get(row).copied() else { return };
        if self.selected == row {
            self.change(1);
        }
        self.selected = row;
    }
}

pub(crate) fn open(app: &mut App) {
    let runs = available(app);
    if runs.is_empty() {
        return app.refuse("nothing to export yet: <run> runs the scene");
    }
    let about = |name: &str| {
        let pin = app.pins.iter().find(|pin| pin.letter.to_string() == name);
        pin.map_or_else(String::new, |pin| pin.name.clone())
    };
    let line = |part, value| Line { part, value };
    let text = |text: String| Value::Text(TextField::new(text));
    let tick = |name: String, about, on| Value::Tick { name, about, on };
    let listed: Vec<String> = app.run_order().into_iter().map(|run| app.run_label(run)).collect();
    let mut lines = vec![
        line(FILE, Value::Path),
        line(WHAT, Value::Choice(SERIES, KINDS.map(|kind| kind.words).to_vec())),
        line(ROWS, text(GRID_ROWS.to_string())),
    ];
    let runs = runs.into_iter().map(|(name, _)| (about(&name), name));
    // Of the runs those that the table lists.
    lines.extend(runs.map(|(about, name)| {
        let on = listed.contains(&name);
        line(RUNS, tick(name, about, on))
    }));
    let names = run::columns(Rows::Series, false).into_iter();
    lines.extend(names.map(|it| line(COLUMNS, tick(it.to_owned(), String::new(), true))));
    let path = TextField::new(format!("{}.csv", ask::base_stem(app)));
    ask::open(app, Purpose::Runs, path, Choices { lines, selected: 0 });
}

/// The runs that can be exported: the current one and the pins, those with a result.
fn available(app: &App) -> Vec<NamedRun> {
    let now = app.shown.iter().map(|shown| ("now".to_owned(), Arc::clone(&shown.run)));
    let pins = app.pins.iter();
    now.chain(pins.filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)))).collect()
}

/// The table of what is chosen.
pub(super) fn table(app: &App, choices: &Choices) -> Result<RunTable, String> {
    let chosen = choices.ticked(RUNS);
    let runs = available(app).into_iter().filter(|(name, _)| chosen.contains(&&**name));
    let runs: Vec<NamedRun> = runs.collect();
    if runs.is_empty() {
        return Err("no run is chosen: Space on a run ticks it".to_owned());
    }
    let what = choices.choice(WHAT);
    let grid = if what == GRID { grid_rows(choices.text(ROWS), runs.len())? } else { 0 };
    let mut columns = choices.columns();
    if choices.is_series() && columns.is_empty() {
        return Err("no column is chosen: Space on a column ticks it".to_owned());
    }
    if columns.len() == choices.of(COLUMNS).count() {
        columns.clear();
    }
    let rows = (KINDS[what].rows)(grid);
    Ok(RunTable { rows, runs, columns })
}

/// The number of rows typed; all runs together have no more than [`GRID_ROWS_MAX`].
fn grid_rows(text: &str, runs: usize) -> Result<usize, String> {
    let most = GRID_ROWS_MAX / runs.max(1);
    let rows = text.trim().parse().ok().filter(|rows| (2..=most).contains(rows));
    rows.ok_or_else(|| {
        let of = if runs > 1 { format!(" for each of {runs} runs") } else { String::new() };
        format!("rows = `{}` is impossible: write a whole number from 2 to {most}{of}", text.trim())
    })
}

/// Column the values begin in.
const VALUE: u16 = 11;
/// Rows below the list: absolute path, note or question, preview.
const FOOT: u16 = 8;

pub(super) fn render(app: &App, state: &Ask, screen: Rect, canvas: &mut Canvas<'_>) {
    let choices = &state.choices;
    let rows = choices.shown();
    let wanted = u16::try_from(rows.len()).unwrap_or(u16::MAX).saturating_add(FOOT + 3);
    let pane = PaneFrame::new("Export to CSV (charts: .svg, report: .html)").right("Enter writes");
    let inner = frame(screen, (100, wanted), pane, canvas);
    let foot = FOOT.min(inner.height.saturating_sub(4));
    let list = Rect { height: inner.height.saturating_sub(foot), ..inner };
    let selected = rows.iter().position(|at| *at == choices.selected).unwrap_or(0);
    let shown = RowList { count: rows.len(), selected, painted: false };
    let first = shown.first(list.height);
    shown.in_dialog(canvas, list, |canvas, line, at| one(state, rows[at], line, canvas));
    let hidden = rows.len().saturating_sub(first + usize::from(list.height));
    if hidden > 0 {
        let more = format!("({hidden} more below)");
        let column = list.width.saturating_sub(columns(&more));
        canvas.put(list, (column, list.height.saturating_sub(1)), &more, Role::Dim);
    }
    let lower = Rect { y: list.bottom(), height: foot, ..inner };
    below(app, state, lower, canvas);
}

fn one(state: &Ask, at: usize, line: Rect, canvas: &mut Canvas<'_>) {
    let lines = &state.choices.lines;
    let (here, shown) = (state.choices.selected == at, &lines[at]);
    if at == 0 || lines[at - 1].part != shown.part {
        canvas.put(line, (2, 0), shown.part, Role::Title);
    }
    if here {
        canvas.put(line, (0, 0), ">", Role::Title);
    }
    let room = line.width.saturating_sub(VALUE + 1);
    let role = if here { Role::Selection } else { Role::Text };
    let text = match &shown.value {
        Value::Path | Value::Text(_) => {
            let field = if let Value::Text(field) = &shown.value { field } else { &state.text };
            let area = Rect { x: line.x + VALUE, width: room, ..line };
            if here {
                TextField { error: None, ..field.clone() }.draw(canvas, area);
            } else {
                field.put(canvas, area, role);
            }
            return;
        }
        Value::Choice(at, words) => format!("< {} >", words[*at]),
        Value::Tick { name, about, on } => {
            let tick = if *on { "[x]" } else { "[ ]" };
            format!("{tick} {name} {about}").trim_end().to_owned()
        }
    };
    canvas.put(line, (VALUE, 0), &text, role);
}

/// The absolute path, then the question, error or completions, else the first lines.
fn below(app: &App, state: &Ask, area: Rect, canvas: &mut Canvas<'_>) {
    let width = usize::from(area.width);
    let text = format!("to {}", app.files.directory.join(state.text.value().trim()).display());
    canvas.put(area, (0, 1), &clip(&text, width), Role::Text);
    let other = ask::instead_of_table(Path::new(state.text.value().trim()));
    let of_tables = other.map(|what| format!("{what}; choices are for tables"));
    let beside = "with a .toml file beside it that reproduces the same digits";
    canvas.put(area, (0, 2), &clip(of_tables.as_deref().unwrap_or(beside), width), Role::Dim);
    let lines: Vec<TextLine> = if state.question {
        wrapped(&ask::question(app, state), area.width, Role::Warning).collect()
    } else if let Some(error) = &state.text.error {
        wrapped(&app.keymap.shown(&format!("x {error}")), area.width, Role::Error).collect()
    } else if state.completions.is_empty() && other.is_some() {
        Vec::new()
    } else if state.completions.is_empty() {
        preview(app, &state.choices).into_iter().map(|line| (line, Role::Dim)).collect()
    } else {
        wrapped(&state.completions.join("  "), area.width, Role::Note).collect()
    };
    let lines = lines.into_iter().map(|(line, role)| (clip(&line, width), role));
    canvas.put_lines(area, 4, lines);
}

/// The first three lines as they would be written.
fn preview(app: &App, choices: &Choices) -> Vec<String> {
    let Some(shown) = &app.shown else { return Vec::new() };
    let named = [("now".to_owned(), Arc::clone(&shown.run))];
    let rows = (KINDS[choices.choice(WHAT)].rows)(3);
    let text = run::csv(rows, &named, &choices.columns(), 2).unwrap_or_default();
    text.lines().take(3).map(str::to_owned).collect()
}
