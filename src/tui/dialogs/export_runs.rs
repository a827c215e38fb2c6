//! The export of runs: what, which runs, which columns.

use std::path::Path;
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::export::RunTable;
use crate::report::run::{self, NamedRun, Rows};
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::ask::{Ask, REPLACE, Step};
use crate::tui::dialogs::export_table::{export, exported, instead_of_table};
use crate::tui::dialogs::frame;
use crate::tui::dialogs::list::is_text;
use crate::tui::message::{Content, EffectReport};
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
    let about = |name: &str| {
        let pin = app.pins.iter().find(|pin| pin.letter.to_string() == name);
        pin.map_or_else(String::new, |pin| pin.name.clone())
    };
    let line = |part, value| Line { part, value };
    let tick = |name: String, about, on| Value::Tick { name, about, on };
    let mut lines = vec![
        line(FILE, Value::Path),
        line(WHAT, Value::Choice(0, KINDS.map(|kind| kind.0).to_vec())),
    ];
    let runs = runs.into_iter().map(|(name, _)| (about(&name), name));
    lines.extend(runs.map(|(about, name)| line(RUNS, tick(name, about, true))));
    let names = run::columns(Rows::Series, false).into_iter();
    lines.extend(names.map(|it| line(COLUMNS, tick(it.to_owned(), String::new(), true))));
    let ask = Ask { text: TextField::new(format!("{}.csv", app.base_stem())), ..Ask::default() };
    Some(Box::new(ExportRuns { ask, choices: Choices { lines, selected: 0 } }))
}

#[derive(Clone, Debug)]
struct ExportRuns {
    ask: Ask,
    /// What is chosen beside the file.
    choices: Choices,
}

impl Dialog for ExportRuns {
    fn footer(&self) -> Footer {
        if self.ask.question {
            return REPLACE;
        }
        &[
            (FootKey::Of(Action::Enter), "write"),
            (FootKey::As("Up/Down"), "move"),
            (FootKey::Of(Action::Mark), "tick"),
            (FootKey::As("a"), "all or none"),
            (FootKey::Of(Action::FocusNext), "complete path"),
            (FootKey::Of(Action::Back), "close"),
        ]
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let on_path = self.choices.selected == 0;
        let action = app.keymap.action(key).filter(|_| !(on_path && is_text(key)));
        match action {
            _ if self.ask.question => {}
            Some(Action::Down) => return self.moved(1),
            Some(Action::Up | Action::FocusPrevious) => return self.moved(-1),
            Some(Action::FocusNext) if !on_path => return self.moved(1),
            Some(Action::Left) if !on_path => return self.changed(-1),
            Some(Action::Right | Action::Mark) if !on_path => return self.changed(1),
            Some(Action::Quit) if !on_path => return Outcome::Closes,
            _ if !on_path && is_text(key) => {
                if key.code == KeyCode::Char('a') {
                    self.choices.all_or_none();
                }
                return Outcome::Stays;
            }
            _ => {}
        }
        match self.ask.press(app, key) {
            Step::Accept { overwrite } => {
                let choices = &self.choices;
                let table = |app: &App| table(app, choices).map(Content::Runs);
                let path = self.ask.path(app, "run.csv");
                let task = path.and_then(|path| export(app, path, overwrite, table));
                self.ask.begun(app, task);
            }
            Step::Closes => return Outcome::Closes,
            Step::Stays => {}
        }
        Outcome::Stays
    }

    fn click(&mut self, _: &mut App, row: usize) -> Outcome {
        self.choices.click(row);
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        (self.choices.selected == 0).then_some(&mut self.ask.text)
    }

    fn pasted(&mut self) {
        self.ask.forget();
    }

    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        if let EffectReport::Completions(names) = report {
            return Some(self.ask.complete(names));
        }
        let ended = exported(&self.ask, directory, report)?;
        Some(self.ask.ended(&ended))
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let rows = self.choices.shown();
        let wanted = u16::try_from(rows.len()).unwrap_or(u16::MAX).saturating_add(FOOT + 3);
        let pane = PaneFrame::new("Export to CSV (charts: .svg)");
        let inner = frame(screen, (100, wanted), pane, canvas);
        let foot = FOOT.min(inner.height.saturating_sub(4));
        let list = Rect { height: inner.height.saturating_sub(foot), ..inner };
        let selected = rows.iter().position(|at| *at == self.choices.selected).unwrap_or(0);
        let shown = RowList { count: rows.len(), selected, painted: false };
        let first = shown.first(list.height);
        let target = |row| Some(Target::DialogRow(row));
        shown.render(canvas, list, target, |canvas, line, at| one(self, rows[at], line, canvas));
        let hidden = rows.len().saturating_sub(first + usize::from(list.height));
        if hidden > 0 {
            let more = format!("({hidden} more below)");
            let column = list.width.saturating_sub(columns(&more));
            canvas.put(list, (column, list.height.saturating_sub(1)), &more, Role::Dim);
        }
        let lower = Rect { y: list.bottom(), height: foot, ..inner };
        below(app, self, lower, canvas);
    }
}

impl ExportRuns {
    fn moved(&mut self, by: isize) -> Outcome {
        self.choices.move_by(by);
        Outcome::Stays
    }

    fn changed(&mut self, by: isize) -> Outcome {
        self.choices.change(by);
        self.ask.text.error = None;
        Outcome::Stays
    }
}

/// The kinds of table, with their words.
const KINDS: [(&str, Rows); 4] = [
    ("time series: solver steps and points between", Rows::Series),
    ("time series on a uniform grid of 1001 rows", Rows::Grid(1001)),
    ("results: one row per run", Rows::Results),
    ("events with their times", Rows::Events),
];

/// The part that a line belongs to, which stands at the left of its first line; lines of one part stand together.
type Part = &'static str;
const FILE: Part = "file";
const WHAT: Part = "what";
const RUNS: Part = "runs";
const COLUMNS: Part = "columns";

#[derive(Clone, Debug)]
enum Value {
    /// What the dialog asks for.
    Path,
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
struct Choices {
    lines: Vec<Line>,
    /// The selected line; the first one is the path.
    selected: usize,
}

impl Choices {
    /// The lines there are now: columns only for a series.
    fn shown(&self) -> Vec<usize> {
        let is_shown = |at: &usize| match self.lines[*at].part {
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

    fn ticked(&self, part: Part) -> Vec<&str> {
        self.of(part)
            .filter_map(|it| {
                if let Value::Tick { name, on: true, .. } = it { Some(&**name) } else { None }
            })
            .collect()
    }

    fn is_series(&self) -> bool {
        matches!(KINDS[self.choice(WHAT)].1, Rows::Series | Rows::Grid(_))
    }

    /// The columns that are chosen of a series; none of another table.
    fn columns(&self) -> Vec<String> {
        let chosen = if self.is_series() { self.ticked(COLUMNS) } else { Vec::new() };
        chosen.into_iter().map(str::to_owned).collect()
    }

    /// Change what the selected line chooses, round and round, or tick it.
    fn change(&mut self, by: isize) {
        match &mut self.lines[self.selected].value {
            Value::Choice(at, words) => *at = cycled(*at, by, words.len()),
            Value::Tick { on, .. } => *on = !*on,
            Value::Path => {}
        }
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
        let next = here.saturating_add_signed(by).min(shown.len().saturating_sub(1));
        self.selected = shown.get(next).copied().unwrap_or(0);
    }

    /// A click on a row: it selects, and ticks or changes what was selected.
    fn click(&mut self, row: usize) {
        let Some(row) = self.shown().get(row).copied() else { return };
        if self.selected == row {
            self.change(1);
        }
        self.selected = row;
    }
}

/// The runs that can be exported: the current one and the pins, those with a result.
fn available(app: &App) -> Vec<NamedRun> {
    let now = app.shown.iter().map(|shown| ("now".to_owned(), Arc::clone(&shown.run)));
    let pins = app.pins.iter();
    now.chain(pins.filter_map(|pin| Some((pin.letter.to_string(), pin.run.clone()?)))).collect()
}

/// The table of what is chosen.
fn table(app: &App, choices: &Choices) -> Result<RunTable, String> {
    let chosen = choices.ticked(RUNS);
    let runs = available(app).into_iter().filter(|(name, _)| chosen.contains(&&**name));
    let runs: Vec<NamedRun> = runs.collect();
    if runs.is_empty() {
        return Err("no run is chosen: Space on a run ticks it".to_owned());
    }
    let mut columns = choices.columns();
    if choices.is_series() && columns.is_empty() {
        return Err("no column is chosen: Space on a column ticks it".to_owned());
    }
    if columns.len() == choices.of(COLUMNS).count() {
        columns.clear();
    }
    let rows = KINDS[choices.choice(WHAT)].1;
    Ok(RunTable { rows, runs, columns })
}

/// Column the values begin in.
const VALUE: u16 = 11;
/// Rows below the list: absolute path, note or question, preview.
const FOOT: u16 = 8;

fn one(state: &ExportRuns, at: usize, line: Rect, canvas: &mut Canvas<'_>) {
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
        Value::Path => {
            let area = Rect { x: line.x + VALUE, width: room, ..line };
            if here {
                TextField { error: None, ..state.ask.text.clone() }.draw(canvas, area);
            } else {
                state.ask.text.put(canvas, area, role);
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
fn below(app: &App, state: &ExportRuns, area: Rect, canvas: &mut Canvas<'_>) {
    let width = usize::from(area.width);
    let path = app.files.directory.join(state.ask.value()).display().to_string();
    canvas.put(area, (0, 1), &clip(&format!("to {path}"), width), Role::Text);
    let other = instead_of_table(Path::new(state.ask.value()));
    let of_tables = other.map(|what| format!("{what}; choices are for tables"));
    let beside = "with a .toml file beside it that reproduces the same digits";
    canvas.put(area, (0, 2), &clip(of_tables.as_deref().unwrap_or(beside), width), Role::Dim);
    let lines = state.ask.found(app, &path, area.width).unwrap_or_else(|| match other {
        Some(_) => Vec::new(),
        None => preview(app, &state.choices).into_iter().map(|line| (line, Role::Dim)).collect(),
    });
    let lines = lines.into_iter().map(|(line, role)| (clip(&line, width), role));
    canvas.put_lines(area, 4, lines);
}

/// The first three lines as they would be written.
fn preview(app: &App, choices: &Choices) -> Vec<String> {
    let Some(shown) = &app.shown else { return Vec::new() };
    let named = [("now".to_owned(), Arc::clone(&shown.run))];
    let rows = match KINDS[choices.choice(WHAT)].1 {
        Rows::Grid(_) => Rows::Grid(3),
        rows => rows,
    };
    let text = run::csv(rows, &named, &choices.columns(), 2).unwrap_or_default();
    text.lines().take(3).map(str::to_owned).collect()
}
