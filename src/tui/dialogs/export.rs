//! The export dialog: what, which runs, which columns, and where.

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::atomic::Existing;
use crate::files::export::{Destination, Meta, RunTable};
use crate::files::style::Style;
use crate::report::run::{self, NamedRun, Rows};
use crate::tui::app::status::clip;
use crate::tui::dialogs::{Dialog, ask, frame, wrap};
use crate::tui::message::{Content, FileTask};
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

/// The part that a line belongs to; lines of one part stand together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    File,
    What,
    Rows,
    Runs,
    Columns,
    Style,
    Scene,
}

impl Part {
    /// The text at the left of its first line.
    fn label(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::What => "what",
            Self::Rows => "rows",
            Self::Runs => "runs",
            Self::Columns => "columns",
            Self::Style => "style",
            Self::Scene => "scene",
        }
    }
}

#[derive(Clone, Debug)]
enum Value {
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

#[derive(Clone, Debug)]
pub struct Export {
    lines: Vec<Line>,
    selected: usize,
    /// The file exists: the answer to "overwrite?" is awaited.
    pub(crate) question: bool,
    /// Names that complete the path.
    pub(crate) completions: Vec<String>,
    pub(crate) error: Option<String>,
}

impl Export {
    /// The lines there are now: the grid's number only for a grid, columns only for a series.
    fn shown(&self) -> Vec<usize> {
        let is_shown = |at: &usize| match self.lines[*at].part {
            Part::Rows => self.choice(Part::What) == GRID,
            Part::Columns => self.is_series(),
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
        matches!(self.choice(Part::What), SERIES | GRID)
    }

    /// The columns that are chosen of a series; none of another table.
    fn columns(&self) -> Vec<String> {
        let chosen = if self.is_series() { self.ticked(Part::Columns) } else { Vec::new() };
        chosen.into_iter().map(str::to_owned).collect()
    }

    fn style(&self) -> Style {
        Style::ALL[self.choice(Part::Style)]
    }

    fn meta(&self) -> Meta {
        Meta::ALL[self.choice(Part::Scene)]
    }

    /// The file, as typed.
    pub fn path(&self) -> &str {
        self.text(Part::File)
    }

    /// Put another text in the place of the path.
    pub(super) fn set_path(&mut self, text: String) {
        self.lines[0].value = Value::Text(TextField::new(text));
    }

    pub(super) fn field_mut(&mut self) -> Option<&mut TextField> {
        match &mut self.lines[self.selected].value {
            Value::Text(field) => Some(field),
            Value::Choice(..) | Value::Tick { .. } => None,
        }
    }

    /// Another text or choice: the message about the old one is removed.
    pub(super) fn forget(&mut self) {
        self.question = false;
        self.error = None;
        self.completions.clear();
    }

    /// Change what the selected line chooses, round and round, or tick it.
    fn change(&mut self, by: isize) {
        match &mut self.lines[self.selected].value {
            Value::Choice(at, words) => *at = wrap(*at, by, words.len()),
            Value::Tick { on, .. } => *on = !*on,
            Value::Text(_) => {}
        }
        self.error = None;
    }

    /// All lines like the selected one when one is missing, else none.
    fn all_or_none(&mut self) {
        let part = self.lines[self.selected].part;
        let all = self.of(part).any(|it| matches!(it, Value::Tick { on: false, .. }));
        for line in self.lines.iter_mut().filter(|line| line.part == part) {
            if let Value::Tick { on, .. } = &mut line.value {
                *on = all;
            }
        }
    }

    /// Move the selection, stopping at the ends.
    fn move_by(&mut self, by: isize) {
        let shown = self.shown();
        let here = shown.iter().position(|at| *at == self.selected).unwrap_or(0);
        self.selected = shown[here.saturating_add_signed(by).min(shown.len() - 1)];
    }
}

pub(crate) fn open(app: &mut App) {
    let runs = available(app);
    if runs.is_empty() {
        return app.refuse("nothing to export yet: r runs the scene");
    }
    let about = |name: &str| {
        let pin = app.pins.iter().find(|pin| pin.letter.to_string() == name);
        pin.map_or_else(String::new, |pin| pin.name.clone())
    };
    let line = |part, value| Line { part, value };
    let text = |text: String| Value::Text(TextField::new(text));
    let tick = |name: String, about| Value::Tick { name, about, on: true };
    let mut lines = vec![
        line(Part::File, text(format!("{}.csv", ask::base_stem(app)))),
        line(Part::What, Value::Choice(SERIES, KINDS.map(|kind| kind.words).to_vec())),
        line(Part::Rows, text(GRID_ROWS.to_string())),
    ];
    let runs = runs.into_iter().map(|(name, _)| (about(&name), name));
    lines.extend(runs.map(|(about, name)| line(Part::Runs, tick(name, about))));
    let names = run::columns(Rows::Series, false).into_iter();
    lines.extend(names.map(|it| line(Part::Columns, tick(it.to_owned(), String::new()))));
    lines.push(line(Part::Style, Value::Choice(0, Style::ALL.map(Style::words).to_vec())));
    lines.push(line(Part::Scene, Value::Choice(0, Meta::ALL.map(Meta::words).to_vec())));
    app.dialog = Some(Dialog::Export(Box::new(Export {
        lines,
        selected: 0,
        question: false,
        completions: Vec::new(),
        error: None,
    })));
}

/// The runs that can be exported: the current one and the pins, those with a result.
fn available(app: &App) -> Vec<NamedRun> {
    let now = app.shown.iter().map(|shown| ("now".to_owned(), Arc::clone(&shown.run)));
    let pins = app.pins.iter();
    now.chain(pins.filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)))).collect()
}

pub(crate) fn press(app: &mut App, mut state: Export, key: KeyEvent) {
    let typing = state.field_mut().is_some();
    let chooses = matches!(state.lines[state.selected].value, Value::Choice(..));
    match key.code {
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Esc => return,
        KeyCode::Char('q') if !typing => return,
        KeyCode::Char('y' | 'o') if state.question => submit(app, &mut state, Existing::Replace),
        KeyCode::Char('r') if state.question => {
            state.set_path(ask::next_name(state.path()));
            (state.selected, state.question) = (0, false);
        }
        KeyCode::Enter => submit(app, &mut state, Existing::Keep),
        KeyCode::Tab if state.selected == 0 => {
            app.request(Effect::Files(FileTask::Complete(state.path().to_owned())));
        }
        KeyCode::Down | KeyCode::Tab => state.move_by(1),
        KeyCode::Up | KeyCode::BackTab => state.move_by(-1),
        KeyCode::Char('j') if !typing => state.move_by(1),
        KeyCode::Char('k') if !typing => state.move_by(-1),
        KeyCode::Left | KeyCode::Char('h') if chooses => state.change(-1),
        KeyCode::Right | KeyCode::Char('l') if chooses => state.change(1),
        KeyCode::Char(' ') if !typing => state.change(1),
        KeyCode::Char('a') if !typing => state.all_or_none(),
        _ => {
            if state.field_mut().is_some_and(|field| field.press(key)) {
                state.forget();
            }
        }
    }
    app.dialog = Some(Dialog::Export(Box::new(state)));
}

/// A click on a row: it selects, and ticks or changes what was selected.
pub(crate) fn click(state: &mut Export, row: usize) {
    let Some(row) = state.shown().get(row).copied() else { return };
    if state.selected == row {
        state.change(1);
    }
    state.selected = row;
}

fn submit(app: &mut App, state: &mut Export, existing: Existing) {
    match task(app, state, existing) {
        Ok(task) => {
            (state.question, state.error) = (false, None);
            app.request(Effect::Files(task));
        }
        Err(error) => state.error = Some(error),
    }
}

fn task(app: &App, state: &Export, existing: Existing) -> Result<FileTask, String> {
    let path = ask::path_of(app, state.path(), "run.csv")?;
    let chosen = state.ticked(Part::Runs);
    let runs = available(app).into_iter().filter(|(name, _)| chosen.contains(&&**name));
    let runs: Vec<NamedRun> = runs.collect();
    if runs.is_empty() {
        return Err("no run is chosen: Space on a run ticks it".to_owned());
    }
    let what = state.choice(Part::What);
    let grid = if what == GRID { grid_rows(state.text(Part::Rows), runs.len())? } else { 0 };
    let mut columns = state.columns();
    if state.is_series() && columns.is_empty() {
        return Err("no column is chosen: Space on a column ticks it".to_owned());
    }
    if columns.len() == state.of(Part::Columns).count() {
        columns.clear();
    }
    let to = Destination { path, existing, meta: state.meta() };
    let rows = (KINDS[what].rows)(grid);
    Ok(FileTask::Export(to, Content::Runs(RunTable { rows, runs, columns, style: state.style() })))
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

pub(crate) fn render(app: &App, state: &Export, screen: Rect, canvas: &mut Canvas<'_>) {
    let rows = state.shown();
    let wanted = u16::try_from(rows.len()).unwrap_or(u16::MAX).saturating_add(FOOT + 3);
    let pane = PaneFrame::new("Export to CSV").right("Enter writes");
    let inner = frame(screen, (100, wanted), pane, canvas);
    let foot = FOOT.min(inner.height.saturating_sub(4));
    let list = Rect { height: inner.height.saturating_sub(foot), ..inner };
    let selected = rows.iter().position(|at| *at == state.selected).unwrap_or(0);
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

fn one(state: &Export, at: usize, line: Rect, canvas: &mut Canvas<'_>) {
    let (here, shown) = (state.selected == at, &state.lines[at]);
    if at == 0 || state.lines[at - 1].part != shown.part {
        canvas.put(line, (2, 0), shown.part.label(), Role::Title);
    }
    if here {
        canvas.put(line, (0, 0), ">", Role::Title);
    }
    let room = line.width.saturating_sub(VALUE + 1);
    let role = if here { Role::Selection } else { Role::Text };
    let text = match &shown.value {
        Value::Text(field) => {
            let area = Rect { x: line.x + VALUE, width: room, ..line };
            if here {
                field.draw(canvas, area);
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
fn below(app: &App, state: &Export, area: Rect, canvas: &mut Canvas<'_>) {
    let width = usize::from(area.width);
    let text = format!("to {}", app.directory.join(state.path().trim()).display());
    canvas.put(area, (0, 1), &clip(&text, width), Role::Text);
    let note = match state.meta() {
        Meta::Beside => "with a .toml file beside it that reproduces the same digits",
        Meta::Inline => "with the scene in # lines at the top, which some programs cannot read",
    };
    canvas.put(area, (0, 2), &clip(note, width), Role::Dim);
    let lines: Vec<TextLine> = if state.question {
        let text = "! this file exists: o overwrite, r rename to -2, Esc back";
        vec![(text.to_owned(), Role::Warning)]
    } else if let Some(error) = &state.error {
        wrapped(&format!("x {error}"), area.width, Role::Error).collect()
    } else if state.completions.is_empty() {
        preview(app, state).into_iter().map(|line| (line, Role::Dim)).collect()
    } else {
        wrapped(&state.completions.join("  "), area.width, Role::Note).collect()
    };
    let lines = lines.into_iter().map(|(line, role)| (clip(&line, width), role));
    canvas.put_lines(area, 4, lines);
}

/// The first three lines as they would be written.
fn preview(app: &App, state: &Export) -> Vec<String> {
    let Some(shown) = &app.shown else { return Vec::new() };
    let named = [("now".to_owned(), Arc::clone(&shown.run))];
    let rows = (KINDS[state.choice(Part::What)].rows)(3);
    let text = run::csv(rows, &named, &state.columns(), 2).unwrap_or_default();
    let text = state.style().file("", &text).unwrap_or_default();
    text.trim_start_matches(state.style().head()).lines().take(3).map(str::to_owned).collect()
}
