//! The export dialog: file, kind, runs and columns, with the absolute path and the first lines as they would be.

use std::sync::Arc;

use ratatui::layout::Rect;

use crate::files::export::Meta;
use crate::report::run;
use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::dialogs::popup::frame;
use crate::tui::dialogs::{Export, ExportRow};
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::{put, put_lines, window, wrapped};

/// Column the values begin in.
const VALUE: u16 = 9;
/// Rows below the list: absolute path, note or question, preview.
const FOOT: u16 = 8;

/// Draw it.
pub(in crate::tui) fn render(app: &App, state: &Export, screen: Rect, canvas: &mut Canvas<'_>) {
    let rows = state.rows();
    let wanted = u16::try_from(rows.len()).unwrap_or(u16::MAX).saturating_add(FOOT + 3);
    let inner = frame(app, screen, (100, wanted), ("Export to CSV", "Enter writes"), canvas);
    let foot = FOOT.min(inner.height.saturating_sub(4));
    let list = Rect { height: inner.height.saturating_sub(foot), ..inner };
    let selected = rows.iter().position(|row| *row == state.row).unwrap_or(0);
    let shown = List { count: rows.len(), selected, painted: false };
    let first = shown.first(list.height);
    shown.in_dialog(canvas, list, app.theme, |canvas, line, at| {
        one(app, state, rows[at], line, canvas);
    });
    let hidden = rows.len().saturating_sub(first + usize::from(list.height));
    if hidden > 0 {
        let more = format!("({hidden} more below)");
        let column = list.width.saturating_sub(crate::tui::widgets::text::columns(&more));
        put(
            canvas,
            list,
            (column, list.height.saturating_sub(1)),
            &more,
            app.theme.style(Role::Dim),
        );
    }
    let lower = Rect { y: list.bottom(), height: foot, ..inner };
    below(app, state, lower, canvas);
}

fn one(app: &App, state: &Export, row: ExportRow, line: Rect, canvas: &mut Canvas<'_>) {
    let here = state.row == row;
    let tick = |on: bool| if on { "[x]" } else { "[ ]" };
    let (lead, text) = match row {
        ExportRow::Path => ("  file", String::new()),
        ExportRow::GridRows => ("  rows", String::new()),
        ExportRow::What => ("  what", format!("< {} >", state.what.label())),
        ExportRow::Style => ("  style", format!("< {} >", state.style.words())),
        ExportRow::Meta => ("  scene", format!("< {} >", state.meta.words())),
        ExportRow::Run(index) => {
            let (name, on) = &state.runs[index];
            let lead = if index == 0 { "  runs" } else { "" };
            (lead, format!("{} {}", tick(*on), run_name(app, name)))
        }
        ExportRow::Column(index) => {
            let (name, on) = &state.columns[index];
            let lead = if index == 0 { "  columns" } else { "" };
            (lead, format!("{} {name}", tick(*on)))
        }
    };
    put(canvas, line, (0, 0), lead, app.theme.style(Role::Title));
    if here {
        put(canvas, line, (0, 0), ">", app.theme.style(Role::Title));
    }
    let column = VALUE + 2;
    let style = app.theme.style(if here { Role::Selection } else { Role::Text });
    let field: Option<&TextField> = match row {
        ExportRow::Path => Some(&state.path),
        ExportRow::GridRows => Some(&state.grid),
        ExportRow::What
        | ExportRow::Style
        | ExportRow::Meta
        | ExportRow::Run(_)
        | ExportRow::Column(_) => None,
    };
    let Some(field) = field else {
        put(canvas, line, (column, 0), &text, style);
        return;
    };
    let room = line.width.saturating_sub(column + 1);
    if here {
        field.draw(canvas, Rect { x: line.x + column, width: room, ..line }, app.theme);
    } else {
        let (shown, _) = window(&field.input, room);
        put(canvas, line, (column, 0), &shown, app.theme.style(Role::Text));
    }
}

fn run_name(app: &App, name: &str) -> String {
    let pin = app.pins.iter().find(|pin| pin.letter.to_string() == name);
    pin.map_or_else(|| name.to_owned(), |pin| format!("{name} {}", pin.name))
}

/// The absolute path, then the question, error or completions, else the first lines.
fn below(app: &App, state: &Export, area: Rect, canvas: &mut Canvas<'_>) {
    let width = usize::from(area.width);
    let path = app.directory.join(state.path.value().trim());
    let dim = app.theme.style(Role::Dim);
    let text = format!("to {}", path.display());
    put(canvas, area, (0, 1), &clip(&text, width), app.theme.style(Role::Text));
    let note = match state.meta {
        Meta::Beside => "and beside it a .toml that runs it again to the same digits",
        Meta::Inline => "with the scene in # lines at its head, which not every program skips",
    };
    put(canvas, area, (0, 2), &clip(note, width), dim);
    let lines: Vec<(String, Role)> = if state.question {
        vec![(
            "! this file exists: o overwrite, r rename to -2, Esc back".to_owned(),
            Role::Warning,
        )]
    } else if let Some(error) = &state.error {
        wrapped(&format!("x {error}"), area.width, Role::Error).collect()
    } else if state.completions.is_empty() {
        preview(app, state).into_iter().map(|line| (line, Role::Dim)).collect()
    } else {
        wrapped(&state.completions.join("  "), area.width, Role::Note).collect()
    };
    let lines = lines.into_iter().map(|(line, role)| (clip(&line, width), role));
    put_lines(canvas, area, 4, app.theme, lines);
}

/// The first three lines as they would be written.
fn preview(app: &App, state: &Export) -> Vec<String> {
    let Some(shown) = &app.shown else {
        return Vec::new();
    };
    let named = [("now".to_owned(), Arc::clone(&shown.run))];
    let text = run::csv(state.what.rows(3), &named, &state.chosen_columns(), 2).unwrap_or_default();
    let text = state.style.file("", &text).unwrap_or_default();
    text.trim_start_matches(state.style.head()).lines().take(3).map(str::to_owned).collect()
}
