//! The list of variables: which rows there are, which is selected, and how a value is shown.

use crate::model::scene::SpringKind;
use crate::model::units;
use crate::model::variables::{self, Group, Kind, VARIABLES, Value, Variable, is_offered};
use crate::tui::app::find::{rank_variable, ranked};
use crate::tui::dialogs::ask::extent;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run;
use crate::tui::widgets::input::Field;
use crate::tui::widgets::table::filtered;

#[derive(Clone, Debug, Default)]
pub struct Editor {
    /// Selected variable, by index into the table.
    pub selected: usize,
    /// The text that the rows shown match.
    pub filter: String,
    /// The arrow step in use: the variable and its decade, kept while the arrows go on.
    pub stepped: Option<(usize, i32)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EditorRow {
    Heading(Group),
    /// A variable, by index into the table.
    Variable(usize),
}

impl Editor {
    /// The rows with a heading over each group; under a filter those that match, best first, without headings.
    pub fn rows(&self, scene: &Scene) -> Vec<EditorRow> {
        if !self.filter.is_empty() {
            let offered = VARIABLES.iter().enumerate().filter(|(_, it)| is_offered(it, scene));
            let found = ranked(offered, |(_, variable)| rank_variable(&self.filter, variable));
            return found.into_iter().map(|(index, _)| EditorRow::Variable(index)).collect();
        }
        let mut rows = Vec::new();
        for group in Group::ALL {
            let start = rows.len();
            for (index, variable) in VARIABLES.iter().enumerate() {
                if variable.group == group && is_offered(variable, scene) {
                    rows.push(EditorRow::Variable(index));
                }
            }
            if rows.len() > start {
                rows.insert(start, EditorRow::Heading(group));
            }
        }
        rows
    }

    /// The variables that pass the filter, in order of the list.
    pub fn listed(&self, scene: &Scene) -> Vec<usize> {
        self.rows(scene)
            .into_iter()
            .filter_map(|row| match row {
                EditorRow::Variable(index) => Some(index),
                EditorRow::Heading(_) => None,
            })
            .collect()
    }

    /// Whether the selected variable is among the rows shown: one that is not cannot be edited.
    pub fn shows(&self, scene: &Scene) -> bool {
        self.listed(scene).contains(&self.selected)
    }

    pub fn variable(&self) -> &'static Variable {
        &VARIABLES[self.selected.min(VARIABLES.len() - 1)]
    }

    /// The first of `height` rows to show so that the selected one is in sight, near the middle of a long list.
    pub fn first_row(&self, scene: &Scene, height: usize) -> usize {
        let rows = self.rows(scene);
        let here =
            rows.iter().position(|row| *row == EditorRow::Variable(self.selected)).unwrap_or(0);
        let most = rows.len().saturating_sub(height);
        here.saturating_sub(height * 2 / 3).min(most)
    }
}

/// Columns that hold six digits of any value.
pub(crate) const WIDE: usize = 24;

/// The value as shown in a row: at most `width` characters, as many of six figures as fit.
pub fn shown_value(variable: &Variable, scene: &Scene, width: usize) -> String {
    match variable.value(scene) {
        Value::Number(number) => shown_number(number, width),
        Value::Switch(true) => "on".to_owned(),
        Value::Switch(false) => "off".to_owned(),
        Value::Absent | Value::Word(_) => variable.show(scene),
    }
}

/// A number in at most `width` characters.
pub fn shown_number(number: f64, width: usize) -> String {
    (1..=6)
        .rev()
        .map(|digits| significant(number, digits))
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("{number:.0e}"))
}

/// Columns within a row: cursor, `*`, symbol, value, flag, unit.
const SYMBOL: u16 = 2;
const VALUE: u16 = 12;
const VALUE_WIDTH: u16 = 8;
/// Columns of a unit after the flag.
const UNIT_WIDTH: u16 = 8;
/// From this width on the meaning stands beside the symbol.
const WITH_MEANING: u16 = 44;

/// Where the parts of a row stand in a list of this width.
#[derive(Clone, Copy)]
struct Columns {
    /// Columns for the meaning, after the symbol.
    meaning: u16,
    value: u16,
    flag: u16,
    unit: u16,
}

impl Columns {
    fn of(width: u16) -> Self {
        let meaning =
            if width < WITH_MEANING { 0 } else { width - VALUE - VALUE_WIDTH - UNIT_WIDTH - 1 };
        let value = VALUE + meaning;
        let flag = value + VALUE_WIDTH;
        Self { meaning, value, flag, unit: flag + 1 }
    }
}

pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let rows = app.editor.rows(&app.scene);
    let height = usize::from(area.height.saturating_sub(3));
    let first = app.editor.first_row(&app.scene, height);
    let pane = PaneFrame::new(filtered("Variables", &app.editor.filter))
        .right(counter(app, &rows, first, height))
        .focused(focused);
    let inner = pane.draw(area, canvas);
    if inner.height < 2 {
        return;
    }
    let list = Rect { height: inner.height - 1, ..inner };
    canvas.pane(area, run::VARIABLES);
    canvas.rows(list, (first, rows.len()), |row| {
        let above = rows[..row].iter().filter(|row| matches!(row, EditorRow::Variable(_)));
        matches!(rows[row], EditorRow::Variable(_))
            .then(|| Target::Row(run::VARIABLES, above.count()))
    });
    let breaches = app.breaches();
    let outside: Vec<&str> = breaches.iter().map(|breach| breach.check.symbol()).collect();
    for (line, row) in list.rows().zip(rows.iter().skip(first)) {
        match row {
            EditorRow::Heading(group) => {
                canvas.put(line, (0, 0), group.title(), Role::Title);
            }
            EditorRow::Variable(index) => {
                let is_outside = outside.contains(&VARIABLES[*index].symbol);
                variable(app, *index, is_outside, line, canvas);
            }
        }
    }
    if rows.is_empty() {
        canvas.put(list, (1, 0), "no variable matches", Role::Dim);
    }
    let foot = app.editor.shows(&app.scene).then(|| foot(app, usize::from(inner.width)));
    canvas.put(inner, (0, inner.height - 1), &foot.unwrap_or_default(), Role::Dim);
}

/// Which of the variables are in sight, where not all are.
fn counter(app: &App, rows: &[EditorRow], first: usize, height: usize) -> String {
    let all = VARIABLES.iter().filter(|variable| is_offered(variable, &app.scene)).count();
    let number = |rows: &[EditorRow]| {
        rows.iter().filter(|row| matches!(row, EditorRow::Variable(_))).count()
    };
    let end = (first + height).min(rows.len());
    if rows.len() <= height && number(rows) == all {
        return String::new();
    }
    let above = number(&rows[..first.min(rows.len())]);
    let seen = number(&rows[first.min(rows.len())..end]);
    if seen == 0 {
        return format!("0/{all}");
    }
    format!("{}-{}/{}", above + 1, above + seen, number(rows))
}

fn variable(app: &App, index: usize, is_outside: bool, line: Rect, canvas: &mut Canvas<'_>) {
    let variable = &VARIABLES[index];
    let selected = app.editor.selected == index;
    let used = variables::is_used(variable, &app.scene);
    let warned = used && (is_outside || variable.range_warning(&app.scene).is_some());
    let differs = variable.value(&app.scene) != variable.value(&app.base.scene);
    let role = if used { Role::Text } else { Role::Dim };
    let field = app.field.as_ref().filter(|_| selected && app.pane() == run::VARIABLES);

    if differs {
        canvas.put(line, (1, 0), "*", Role::Note);
    }
    let columns_of = Columns::of(line.width);
    canvas.put(line, (SYMBOL, 0), variable.symbol, role);
    if columns_of.meaning > 0 {
        let text = clip(variable.label, usize::from(columns_of.meaning - 1));
        canvas.put(line, (VALUE, 0), &text, Role::Dim);
    }
    if let Some(field) = field {
        open_field(variable, field, line, canvas);
    } else {
        let text = shown_value(variable, &app.scene, usize::from(VALUE_WIDTH));
        let Columns { value, flag, unit, .. } = columns_of;
        let start = flag.saturating_sub(columns(&text)).max(value);
        let end = canvas.put(line, (start, 0), &text, role);
        if matches!(variable.value(&app.scene), Value::Number(_)) && end <= flag {
            canvas.put(line, (unit, 0), variable.unit(), Role::Dim);
        }
    }
    if warned {
        canvas.put(line, (columns_of.flag, 0), "!", Role::Warning);
    }
    if selected {
        canvas.put(line, (0, 0), ">", Role::Title);
        if field.is_none() {
            canvas.paint_row(line, 0);
        }
    }
}

/// `[ 1.25_  ]`, wider where the text needs it.
fn open_field(variable: &Variable, field: &Field, line: Rect, canvas: &mut Canvas<'_>) {
    let long = columns(field.text.value()) >= VALUE_WIDTH;
    let Columns { value, unit, .. } = Columns::of(line.width);
    let room = if long { line.width.saturating_sub(value + 1) } else { VALUE_WIDTH };
    field.draw_boxed(canvas, line, value, room);
    if !long {
        canvas.put(line, (unit + 1, 0), variable.unit(), Role::Dim);
    }
}

/// `[--|----]`: where the value stands in the range the thesis searched; `<` and `>` outside it.
fn range_bar(variable: &Variable, app: &App, width: usize) -> Option<String> {
    let Kind::Number(number) = &variable.kind else {
        return None;
    };
    let (low, high) = number.thesis_range?;
    let value = (number.get)(&app.scene)?;
    let cells = width.checked_sub(2).filter(|cells| *cells > 2)?;
    let mut bar: Vec<char> = vec!['-'; cells];
    if value < low {
        bar[0] = '<';
    } else if value > high {
        bar[cells - 1] = '>';
    } else {
        // The place among the cells by comparison, not by conversion: few cells, no rounding to argue about.
        let share = (value - low) / (high - low);
        let at = (1..cells).filter(|cell| share * cells as f64 >= *cell as f64).count();
        bar[at] = '|';
    }
    Some(format!("[{}]", bar.into_iter().collect::<String>()))
}

/// The points of the spring whose kind this is, where it is a table.
fn measured<'a>(variable: &Variable, app: &'a App) -> Option<&'a [[f64; 2]]> {
    let spring = &app.scene.mechanism.spring;
    let is_kind = variable.key == "mechanism.spring.kind";
    (is_kind && spring.kind == SpringKind::Table).then_some(&spring.table.points)
}

/// Below the list: the selected variable's range of Table 9.2 with its bar, or what it may be.
fn foot(app: &App, width: usize) -> String {
    let variable = app.editor.variable();
    if let Kind::Number(number) = &variable.kind
        && let Some((low, high)) = number.thesis_range
    {
        let (low, high) = (units::shortest(low), units::shortest(high));
        let table = if width > 34 { "Table 9.2" } else { "T9.2" };
        let rest = low.len() + high.len() + table.len() + 4;
        let bar = range_bar(variable, app, width.saturating_sub(rest).min(40));
        if let Some(bar) = bar {
            return format!("{low} {bar} {high} {table}");
        }
    }
    if let Some(points) = measured(variable, app) {
        return clip(&app.keymap.shown(&format!("{}: <enter>", extent(points))), width);
    }
    let allowed = variable.allowed();
    let words = variable.words().len();
    if words > 2 && usize::from(columns(&allowed)) > width {
        let text = app.keymap.shown(&format!("one of {words} words: <enter> lists them"));
        return clip(&text, width);
    }
    clip(&allowed, width)
}
