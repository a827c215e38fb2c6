//! Drawing of the list of variables.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::editor::{
    ANALYSIS, DESIGN, Editor, EditorRow, is_main, number_in, short_label, shown_in, shown_value,
};
use crate::tui::pages::run::matters::{matters_bar, matters_title};
use crate::tui::pages::run::state::VARIABLES as PANE;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::table::filtered;
use crate::tui::widgets::text::{counted, fitting};
use cmra_engine::model::units;
use cmra_engine::model::variables::{self, VARIABLES, is_listed};
use cmra_studies::report::chart::{Below, Frame};
use cmra_studies::report::sensitivity::CELLS;

/// Columns of a field.
const FIELD_WIDTH: u16 = 9;
/// Columns within a row: cursor, mark of a change, symbol, label, value with its unit at the right end.
const SYMBOL: u16 = 2;
const LABEL: u16 = 9;
/// Minimum number of visible rows of More for unfolding.
const UNFOLDED: u16 = 4;

pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let editor = &app.pages.run.editor;
    // The main variables with their heading take 15 rows, and the frame two.
    let main = 15;
    let is_unfolded = area.height >= main + 2 + UNFOLDED || !is_main(editor.variable());
    let mut rows = editor.rows(&app.scene, is_unfolded);
    let is_folded = !is_unfolded && editor.filter.is_empty();
    let height = usize::from(area.height.saturating_sub(2));
    // A heading gives way if all variables fit without it.
    let has_headings = !is_folded || rows.len() != height + 1;
    rows.retain(|row| has_headings || row.variable().is_some());
    let selected = rows.iter().position(|row| row.variable() == Some(editor.selected));
    let first = selected.unwrap_or(0).saturating_sub(height * 2 / 3);
    let first = first.min(rows.len().saturating_sub(height));
    let title = match (editor.filter.is_empty(), first) {
        (true, _) if app.pages.run.matters.output.is_some() => {
            matters_title(app).unwrap_or_default()
        }
        (true, 0) if has_headings => "Design variables".to_owned(),
        (true, _) => "Variables".to_owned(),
        (false, _) => filtered("Variables", &editor.filter),
    };
    let pane = PaneFrame::new(title).right(counted(first, height, rows.len()));
    let frame = Frame::Stacked { begins: true, below: Below::End };
    let inner = pane.focused(focused).frame(frame).draw(area, canvas);
    canvas.pane(area, PANE);
    if is_folded {
        let line = Rect { y: area.bottom() - 1, height: 1, ..area };
        let room = usize::from(area.width.saturating_sub(4));
        canvas.put(line, (1, 0), &format!(" {} ", more_words(app, room)), Role::Text);
        canvas.rows(line, (0, 1), |_| Some(Target::Row(PANE, DESIGN.len() + ANALYSIS.len())));
    }
    canvas.rows(inner, (first, rows.len()), |row| {
        let above = rows[..row].iter().filter(|row| row.variable().is_some());
        rows[row].variable().map(|_| Target::Row(PANE, above.count()))
    });
    let breaches = app.breaches();
    let outside: Vec<&str> = breaches.iter().map(|breach| breach.check.symbol()).collect();
    for (line, row) in inner.rows().zip(rows.iter().skip(first)) {
        match row {
            EditorRow::Heading(_) | EditorRow::More => {
                let text = match row {
                    EditorRow::Heading(title) => (*title).to_owned(),
                    _ => more_words(app, usize::from(area.width.saturating_sub(5))),
                };
                let line = Rect { x: area.x, width: area.width, ..line };
                let frame = Frame::Stacked { begins: false, below: Below::Nothing };
                PaneFrame::new(text).frame(frame).draw(line, canvas);
            }
            EditorRow::Variable(index) => {
                let is_outside = outside.contains(&VARIABLES[*index].symbol);
                variable(app, *index, is_outside, line, canvas);
            }
        }
    }
    if rows.is_empty() {
        canvas.put(inner, (1, 0), "no variable matches", Role::Dim);
    }
}

/// Returns the heading of More: the number of variables, and those that differ from their defaults.
fn more_words(app: &App, room: usize) -> String {
    let usual = Scene::default();
    let differs = |index: &usize| {
        let variable = &VARIABLES[*index];
        variable.value(&app.scene) != variable.value(&usual)
    };
    let changed: Vec<String> = Editor::more(&app.scene)
        .filter(differs)
        .map(|index| {
            let variable = &VARIABLES[index];
            format!("{} {}", variable.symbol, shown_value(variable, &app.scene))
        })
        .collect();
    let count = Editor::more(&app.scene).count();
    let number = if changed.is_empty() { "none".to_owned() } else { changed.len().to_string() };
    let number = format!("More: {count}, {number} changed");
    let list = format!("More: {count}, {}", changed.join(", "));
    let list = if changed.is_empty() { number.clone() } else { list };
    fitting([list, number, format!("More: {count}")], room)
}

fn variable(app: &App, index: usize, is_outside: bool, line: Rect, canvas: &mut Canvas<'_>) {
    let variable = &VARIABLES[index];
    let selected = app.pages.run.editor.selected == index;
    let used = variables::is_used(variable, &app.scene) && is_listed(variable, &app.scene);
    let warned = used && (is_outside || variable.range_warning(&app.scene).is_some());
    let differs = variable.value(&app.scene) != variable.value(&app.base.scene);
    let role = if used { Role::Text } else { Role::Dim };
    if differs {
        canvas.put(line, (1, 0), "*", Role::Note);
    }
    let end = canvas.put(line, (SYMBOL, 0), variable.symbol, role);
    if let Some(field) = app.field().filter(|_| selected && app.pane() == PANE) {
        canvas.put(line, (0, 0), ">", Role::Title);
        return open_field(app.pages.run.editor.unit(index), field, line, canvas);
    }
    let bar = matters_bar(app, variable);
    let bar_from = LABEL.max(end + 1);
    let width = u16::try_from(CELLS).unwrap_or(u16::MAX);
    let end = if bar.is_some() { bar_from + width } else { end };
    // Leave a blank at the right end, so that the frame is not taken for a part of the unit.
    let has_flag = warned && bar.is_none();
    let room = line.width.saturating_sub(end + 2 + if has_flag { 2 } else { 0 });
    let text = value_text(app, index, usize::from(room));
    let start = line.width.saturating_sub(columns(&text) + 1).max(end + 1);
    // Left of a bar the flag leaves the room for the unit.
    let flag = match (warned, bar.is_some()) {
        (true, true) => bar_from - 1,
        (true, false) => start.saturating_sub(2),
        (false, _) => start,
    };
    let from = LABEL.max(end + 1);
    if let Some(bar) = &bar {
        canvas.put(line, (bar_from, 0), &bar.text, role);
    }
    let labels = [Some(variable.label), short_label(variable)].into_iter().flatten();
    let mut labels = labels.filter(|_| bar.is_none());
    if let Some(label) =
        labels.find(|label| from + columns(label) < flag && *label != variable.symbol)
    {
        canvas.put(line, (from, 0), label, Role::Dim);
    }
    canvas.put(line, (start, 0), &text, role);
    if warned {
        canvas.put(line, (flag, 0), "!", Role::Warning);
    }
    if selected {
        canvas.put(line, (0, 0), ">", Role::Title);
        canvas.paint_row(line);
    }
    if let Some(own) = bar.and_then(|bar| u16::try_from(bar.own?).ok()) {
        canvas.invert(line, bar_from + own);
    }
}

/// Formats the value with its unit, with as many of six digits as fit; adds the plate mass to the mass ratio.
fn value_text(app: &App, index: usize, room: usize) -> String {
    let (variable, unit) = (&VARIABLES[index], app.pages.run.editor.unit(index));
    let digits = (2..=6).rev();
    let plain = digits.map(|digits| shown_in(variable, &app.scene, unit, digits));
    // Without room for the unit the number stands alone: half a unit could be taken for another one.
    let bare = number_in(variable, &app.scene, unit, 3);
    let mass =
        (variable.symbol == "gamma" && variables::is_used(variable, &app.scene)).then(|| {
            let mass = units::engineering(app.scene.plate_mass_kg(), "kg", 3);
            format!("{} ({mass})", shown_in(variable, &app.scene, unit, 6))
        });
    fitting(mass.into_iter().chain(plain).chain([bare]), room)
}

/// Draws the field as `[ 1.25_  ] mm`, wider if the text needs it.
fn open_field(unit: &str, field: &TextField, line: Rect, canvas: &mut Canvas<'_>) {
    let behind = columns(unit) + 2;
    let most = line.width.saturating_sub(behind + LABEL + 1);
    let room = (columns(field.value()) + 1).max(FIELD_WIDTH).min(most);
    let start = line.width.saturating_sub(behind + room + 1);
    field.draw_boxed(canvas, line, start, room);
    canvas.put(line, (start + room + 2, 0), unit, Role::Dim);
}
