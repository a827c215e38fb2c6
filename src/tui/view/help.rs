//! The help overlay and the palette: both list the key table.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::Cursor;
use super::popup::{filter, frame};
use super::text::{Rows, first_row, paint_row, put};
use crate::model::variables::Kind;
use crate::tui::app::App;
use crate::tui::app::dialog::{Picker, help_rows, palette_rows};
use crate::tui::app::status::{clip, wrap};
use crate::tui::message::{Binding, Place};
use crate::tui::theme::{Role, columns};

/// Where the pane and the sentence of a row begin.
const PLACE: u16 = 16;
const SENTENCE: u16 = 29;
/// A list keeps so many rows before anything stands below it.
const LEAST_ROWS: u16 = 4;

/// Keys: what the selected variable means on top, then the keys of the focused pane, then the others.
pub(super) fn help(
    app: &App,
    picker: &Picker,
    screen: Rect,
    buffer: &mut Buffer,
    cursor: &mut Cursor,
) -> Rows {
    let inner = frame(app, screen, (92, 48), ("Help", "q closes"), buffer);
    let about = about(app, usize::from(inner.width));
    let mut top = 0;
    for (text, role) in &about {
        put(buffer, inner, (0, top), text, app.theme.style(*role));
        top += 1;
    }
    let rest = Rect {
        y: inner.y + top.min(inner.height),
        height: inner.height.saturating_sub(top),
        ..inner
    };
    filter(app, picker, rest, buffer, cursor);
    let rows = help_rows(app, picker.filter.value());
    list(app, &rows, picker.selected, below(rest), buffer)
}

/// Every action by name.
pub(super) fn palette(
    app: &App,
    picker: &Picker,
    screen: Rect,
    buffer: &mut Buffer,
    cursor: &mut Cursor,
) -> Rows {
    let inner = frame(app, screen, (76, 20), ("Find an action", "Esc closes"), buffer);
    filter(app, picker, inner, buffer, cursor);
    let rows = palette_rows(app, picker.filter.value());
    list(app, &rows, picker.selected, below(inner), buffer)
}

fn below(area: Rect) -> Rect {
    Rect { y: area.y + area.height.min(1), height: area.height.saturating_sub(1), ..area }
}

fn list(app: &App, rows: &[&Binding], selected: usize, area: Rect, buffer: &mut Buffer) -> Rows {
    if rows.is_empty() {
        put(buffer, area, (0, 0), "nothing matches", app.theme.style(Role::Dim));
    }
    let room = usize::from(area.width.saturating_sub(SENTENCE));
    let area = whole(app, rows, (selected, room), area, buffer);
    let first = first_row(selected, usize::from(area.height), rows.len());
    for (row, (index, binding)) in (0..area.height).zip(rows.iter().enumerate().skip(first)) {
        put(
            buffer,
            area,
            (0, row),
            &clip(&binding.keys_in_words(), 15),
            app.theme.style(Role::Key),
        );
        put(buffer, area, (PLACE, row), binding.place.words(), app.theme.style(Role::Dim));
        put(buffer, area, (SENTENCE, row), &clip(binding.help, room), app.theme.style(Role::Text));
        if index == selected {
            paint_row(buffer, area, row, app.theme.style(Role::Selection));
        }
    }
    Rows { area, first, count: rows.len() }
}

/// The whole sentence of the selected row below the list, where some are cut and there is room; gives what is left for the
/// list.
fn whole(
    app: &App,
    rows: &[&Binding],
    (selected, room): (usize, usize),
    area: Rect,
    buffer: &mut Buffer,
) -> Rect {
    let width = usize::from(area.width);
    let cut = rows.iter().filter(|row| columns(row.help) > room);
    let needed = cut.map(|row| wrap(row.help, width).len()).max().unwrap_or(0);
    let needed = u16::try_from(needed).unwrap_or(u16::MAX);
    if needed == 0 || area.height < needed.saturating_add(LEAST_ROWS) {
        return area;
    }
    let list = Rect { height: area.height - needed, ..area };
    let below = Rect { y: list.bottom(), height: needed, ..area };
    let lines = rows.get(selected).map_or_else(Vec::new, |row| wrap(row.help, width));
    for (row, line) in (0..below.height).zip(&lines) {
        put(buffer, below, (0, row), line, app.theme.style(Role::Dim));
    }
    list
}

/// Meaning, allowed values, range and source of the selected variable, while the list of variables has the keys.
fn about(app: &App, width: usize) -> Vec<(String, Role)> {
    if app.place() != Place::Variables {
        return Vec::new();
    }
    let variable = app.editor.variable();
    let mut lines = vec![(format!("{}  {}", variable.symbol, variable.key), Role::Title)];
    let mut text = |text: String| {
        for line in wrap(&text, width.saturating_sub(2)) {
            lines.push((format!("  {line}"), Role::Text));
        }
    };
    text(variable.meaning.to_owned());
    let range = match &variable.kind {
        Kind::Number(number) => number.thesis_range.map_or_else(String::new, |(low, high)| {
            let show = crate::model::units::shortest;
            format!("; the thesis searched {} to {}", show(low), show(high))
        }),
        Kind::Choice(_) | Kind::Switch { .. } => String::new(),
    };
    text(format!("now {}; allowed: {}{range}", variable.show(&app.scene), variable.allowed()));
    text(format!("default: {}", variable.source));
    lines.push((String::new(), Role::Text));
    lines
}
