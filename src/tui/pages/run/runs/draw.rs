//! The table of runs: the current one and the pins, and what the scene differs from the first pin in.

use ratatui::layout::Rect;

use crate::model::run::Run;
use crate::model::variables::VARIABLES;
use crate::report::run::no_depth;
use crate::tui::app::App;
use crate::tui::app::status::{clip, wrap};
use crate::tui::chart::MARKERS;
use crate::tui::message::Target;
use crate::tui::pages::run::RUNS;
use crate::tui::pages::run::runs::Pin;
use crate::tui::pages::run::summary::results;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::{columns, paint_row, put, put_lines};

/// Columns of marker, letter and a blank before the name.
const LEAD: u16 = 5;

/// Draw the pane.
pub(in crate::tui) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    canvas.pane(area, RUNS);
    let right = match (app.pins.is_empty(), focused) {
        (true, _) => "Space pins",
        (false, true) => "Enter load  Space unpin",
        (false, false) => "",
    };
    let inner =
        PaneFrame::new("Runs").right(right).focused(focused).render(area, canvas, app.theme);
    let table = app.compared_runs();
    let mut cells = table.cells(&table.keys());
    app.runs_sorted.mark(&table.keys(), &mut cells);
    let grid = Grid::shortened(cells, inner.width.saturating_sub(LEAD));
    put(canvas, inner, (LEAD, 0), &grid.line(None), app.theme.style(Role::Dim));
    let mut row = 1;
    for index in app.runs_sorted.order(&table) {
        let compared = &table.rows[index];
        let pin = index.checked_sub(1).map(|at| &app.pins[at]);
        let visible = pin.map_or(app.current_visible, |pin| pin.visible);
        let letter = pin.map_or_else(|| "now".to_owned(), |pin| pin.letter.to_string());
        let marker = if visible { MARKERS[index % MARKERS.len()] } else { ' ' };
        let style = |role| app.theme.style(if visible { role } else { Role::Dim });
        put(canvas, inner, (0, row), &format!("{marker}{letter}"), style(Role::Curve(index)));
        let line = grid.line(Some(index));
        put(canvas, inner, (LEAD, row), &line, style(Role::Text));
        let words = compared.run.and_then(no_depth);
        if let Some((words, at)) = words.and_then(|words| Some((words, line.rfind(words)?))) {
            let at = LEAD + columns(&line[..at]);
            put(canvas, inner, (at, row), words, style(Role::Warning));
        }
        if focused && index == app.selected_run {
            paint_row(canvas, inner, row, app.theme.style(Role::Selection));
        }
        row += 1;
    }
    below(app, inner, row, canvas);
    let count = app.pins.len() + 1;
    let area = Rect { y: inner.y + 1, height: inner.height.saturating_sub(1), ..inner };
    canvas.rows(area, (0, count), |run| Some(Target::Row(RUNS, run)));
}

/// Below the rows: the difference to the selected pin (the first, where the current run is selected), or how to pin; then,
/// where there is room, the results of the selected run in words.
fn below(app: &App, inner: Rect, row: u16, canvas: &mut Canvas<'_>) {
    let width = usize::from(inner.width);
    let mut lines: Vec<(String, Role)> = match app.pins.get(app.selected_run.saturating_sub(1)) {
        Some(pin) => difference(app, pin, width),
        None => vec![("Space pins this run to compare with".to_owned(), Role::Dim)],
    };
    let run = match app.selected_run.checked_sub(1) {
        None => app.shown.as_ref().map(|shown| &shown.run),
        Some(at) => app.pins.get(at).and_then(|pin| pin.run.as_ref()),
    };
    let details: Vec<String> = run.map_or_else(Vec::new, |run| results(run));
    let free = usize::from(inner.height.saturating_sub(row)).saturating_sub(lines.len());
    if !details.is_empty() && free > details.len() + 1 {
        lines.push((String::new(), Role::Text));
        let whose = match app.selected_run.checked_sub(1).and_then(|at| app.pins.get(at)) {
            None => "now".to_owned(),
            Some(pin) => format!("{} {}", pin.letter, pin.name),
        };
        lines.push((clip(&format!("{whose}:"), width), Role::Title));
        lines.extend(details.into_iter().map(|line| (clip(&line, width), Role::Text)));
    }
    put_lines(canvas, inner, row, app.theme, lines);
}

/// What the current run gained on a pin, and what was changed for it.
fn difference(app: &App, pin: &Pin, width: usize) -> Vec<(String, Role)> {
    let depth = |run: &Run| run.first_arrest.map(|arrest| arrest.penetration_m);
    let pair = app.shown.as_ref().zip(pin.run.as_ref());
    let difference = pair.and_then(|(now, pin)| Some((depth(&now.run)?, depth(pin)?)));
    let difference = difference.map_or_else(
        || "no first arrest to compare".to_owned(),
        |(now, then)| {
            let percent = 100.0 * (now - then) / then;
            format!("p_1st {:+.4} mm ({percent:+.1} %)", (now - then) * 1e3)
        },
    );
    let mut lines = vec![(format!("now - {}: {difference}", pin.letter), Role::Title)];
    let words: Vec<String> = App::differing(&pin.scene, &app.scene)
        .into_iter()
        .map(|index| {
            let variable = &VARIABLES[index];
            let (then, now) = (variable.show(&pin.scene), variable.show(&app.scene));
            format!("{} {then} -> {now}", variable.symbol)
        })
        .collect();
    let text = if words.is_empty() { "same scene".to_owned() } else { words.join(", ") };
    lines.extend(wrap(&text, width).into_iter().map(|line| (line, Role::Text)));
    lines
}
