//! Screen: five regions, panes, and a dialog on top. Reads the state and does not change it.

mod message;

use ratatui::buffer::Buffer;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Widget};

use crate::tui::app::notice::StatusPart;
use crate::tui::keymap::PaneKey;
use crate::tui::pages::page::pair;
use crate::tui::pages::{self, PageSpec};
use crate::tui::prelude::*;
use crate::tui::theme::{GlyphSet, ascii_pass};
pub use crate::tui::widgets::Targets;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::layout::SMALLEST;
use crate::tui::widgets::text::{self, clip, columns};

/// Draws the screen into a buffer of its size. Returns the position and visibility of the cursor: visible in a field; hidden on the
/// selected row, where a screen reader follows it. Records the mouse targets of the cells, if wanted.
pub fn view(
    app: &App,
    buffer: &mut Buffer,
    targets: Option<&mut Targets>,
) -> Option<((u16, u16), bool)> {
    let area = buffer.area;
    let theme = app.settings.theme;
    let mut canvas = match targets {
        Some(targets) => Canvas::recorded(buffer, theme, targets),
        None => Canvas::new(buffer, theme),
    };
    draw(app, area, &mut canvas);
    let field = canvas.cursor.map(|at| (at, true));
    let cursor = field.or_else(|| canvas.selected.map(|at| (at, false)));
    if app.settings.theme.glyphs == GlyphSet::Ascii {
        ascii_pass(buffer);
    }
    cursor
}

fn draw(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let layout = app.layout();
    let Some(body) = layout.body else { return too_small(app, area, canvas) };
    pages::page(app.tab).draw(app, body, canvas);
    title(app, layout.title, canvas);
    if let Some(area) = layout.pages {
        pages(app, area, canvas);
    }
    status(app, layout.status, canvas);
    footer(app, layout.keys, canvas);
    if let Some(dialog) = &app.dialog {
        dialog.draw(app, area, canvas);
    }
    // Also on top of a dialog, because the reason of a rejected text may exceed the area.
    message(app, layout.message, canvas);
}

fn too_small(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let (columns, rows) = SMALLEST;
    let needed = format!("{columns}x{rows}, here {}x{}", area.width, area.height);
    let lines = ["too small".to_owned(), needed, app.keymap.shown("<quit> quits")];
    let top = area.height.saturating_sub(3) / 2;
    for (row, line) in (top..area.height).zip(lines) {
        let column = area.width.saturating_sub(text::columns(&line)) / 2;
        canvas.put(area, (column, row), &line, Role::Text);
    }
}

/// Draws as many of the useful keys as fit.
fn footer(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    if let Some(field) = app.find().filter(|_| app.dialog.is_none()) {
        let lead = format!("/ find in {}: ", pages::spec(app.pane()).label);
        return typed(&lead, "Enter keep  Esc show all", field, area, canvas);
    }
    if let Some(field) = app.place().filter(|_| app.dialog.is_none()) {
        let places = pages::page(app.tab).places(app);
        let names: Vec<&str> = places.iter().map(|place| &*place.0).collect();
        let lead = format!("cursor to {}: ", names.join(", "));
        let units = places.iter().filter(|place| !place.1.is_empty());
        let units: Vec<String> = units.map(|(name, unit)| format!("{name} in {unit}")).collect();
        let hint = format!("{}  Enter go  Esc leave", units.join(", "));
        return typed(&lead, hint.trim_start(), field, area, canvas);
    }
    let (entries, last) = match (&app.dialog, app.field()) {
        (Some(dialog), _) => (keys_of(app, dialog.footer()), ""),
        (None, Some(_)) => {
            let quantity = pages::page(app.tab).field_quantity(app);
            let bare = quantity.map(|it| unit_of_bare(&it.unit)).unwrap_or_default();
            (keys_of(app, &format!("{WORD}{bare}")), "")
        }
        (None, None) => (from_table(app), LAST),
    };
    let last = keys_of(app, last);
    let size = |entry: &(String, String)| columns(&entry.0) + columns(&entry.1) + GAP + 1;
    // No gap after the last key.
    let mut room = (area.width + GAP - 1).saturating_sub(last.iter().map(size).sum());
    let fits = |entry: &(String, String)| {
        let has_room = size(entry) <= room;
        room = room.saturating_sub(size(entry));
        has_room
    };
    let mut spans = vec![Span::raw(" ")];
    let shown: Vec<(String, String)> = entries.into_iter().take_while(fits).collect();
    for (key, what) in shown.into_iter().chain(last) {
        spans.push(Span::styled(key, app.settings.theme.style(Role::Key)));
        spans.push(Span::raw(format!(" {what}  ")));
    }
    canvas.put_line(area, &Line::from(spans));
}

/// Draws a field in the footer between its label and the keys that close it.
fn typed(lead: &str, hint: &str, field: &TextField, area: Rect, canvas: &mut Canvas<'_>) {
    let start = canvas.put(area, (1, 0), lead, Role::Key);
    let room = area.width.saturating_sub(start + columns(hint) + 2);
    field.draw(canvas, Rect { x: area.x + start, width: room, ..area });
    let hint_at = area.width.saturating_sub(columns(hint) + 1);
    canvas.put(area, (hint_at, 0), hint, Role::Dim);
}

/// Describes the unit of a bare number, and other allowed notation.
fn unit_of_bare(unit: &str) -> String {
    let alone =
        if unit.is_empty() { String::new() } else { format!("  a number alone is in {unit}") };
    format!("{alone}  also 1/3 *2 +5%")
}

/// Keys while a text is edited.
const WORD: &str = "<enter> ok  <back> old value  Up/Down ok and move";

/// Returns the keys of a footer with their labels: `<enter> load  <back> close`.
fn keys_of(app: &App, footer: &str) -> Vec<(String, String)> {
    let footer = app.keymap.shown(footer);
    let entries = footer.split("  ").filter_map(|entry| entry.split_once(' '));
    entries.map(|(key, what)| (key.to_owned(), what.to_owned())).collect()
}

/// Columns between two keys of the footer.
const GAP: u16 = 2;

/// Most useful keys of all panes, and the last keys of the footer.
const COMMON: &str = "<palette> find  <next-pane> pane  <presets> presets  <export> export";
/// Key that is useful after an edit only.
const UNDO: &str = "  <undo> undo";
const LAST: &str = "<help> keys  <quit> quit";

/// Returns the keys of the pane, the most useful first, then those of all panes.
fn from_table(app: &App) -> Vec<(String, String)> {
    let page = pages::page(app.tab);
    let is_shown = |row: &&PaneKey| !row.short.is_empty() && page.is_of_use(app, row.action);
    let own = pages::spec(app.pane()).keys.iter().filter(is_shown);
    let own = own.map(|row| (pair(app, row.action), row.short.to_owned()));
    let mut entries: Vec<(String, String)> = own.filter(|entry| !entry.0.is_empty()).collect();
    let undo = if app.history.done > 0 { UNDO } else { "" };
    for entry in keys_of(app, &format!("{COMMON}{undo}")) {
        if !entries.contains(&entry) {
            entries.push(entry);
        }
    }
    entries
}

/// Draws the title row: tabs at the left; preset and whether it is modified at the right.
pub(crate) fn title(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    // Use all columns on the narrowest screen.
    let mut column = u16::from(area.width > SMALLEST.0);
    for tab in Tab::ALL {
        let (title, target) = (tab.title(&app.keymap), Target::Tab(tab));
        column = name(canvas, area, column, &title, tab == app.tab, target) + 1;
    }
    let room = usize::from(area.width.saturating_sub(column + 1));
    if room < 6 {
        return;
    }
    let changed = if app.is_modified() { " *" } else { "" };
    let text = text::clip_words(&app.base.name, room.saturating_sub(changed.len())) + changed;
    let start = area.width.saturating_sub(columns(&text) + 1).max(column);
    canvas.put(area, (start, 0), &text, Role::Text);
}

/// Draws a clickable name, in brackets if it is shown; returns the column after it.
fn name(
    canvas: &mut Canvas<'_>,
    area: Rect,
    column: u16,
    name: &str,
    is_shown: bool,
    target: Target,
) -> u16 {
    let (text, role) = if is_shown {
        (format!("[{name}]"), Role::Selection)
    } else {
        (name.to_owned(), Role::Text)
    };
    let end = canvas.put(area, (column, 0), &text, role);
    canvas.hit(Rect { x: area.x + column, width: columns(&text), ..area }, |_| Some(target));
    end
}

/// Draws the names of the tab's pages, the shown one in brackets, and the key to the next page.
pub(crate) fn pages(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let mut column = 1;
    let page = pages::page(app.tab);
    for (at, PageSpec { name: title, .. }) in page.about().pages.iter().enumerate() {
        let is_shown = at == page.shown(app);
        column = name(canvas, area, column, title, is_shown, Target::Page(at)) + 2;
    }
    let key = app.keymap.label(Action::Tab(app.tab));
    let hint = if key.is_empty() { key } else { format!("{key}: next page") };
    let start = area.width.saturating_sub(columns(&hint) + 1);
    if start > column {
        canvas.put(area, (start, 0), &hint, Role::Dim);
    }
}

/// Draws the readout of the cursor and the newest message, each with its mark. Text that exceeds the area covers the rows above it; the
/// panes keep their places.
pub(crate) fn message(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let lines = app.message_lines(usize::from(area.width));
    let count = u16::try_from(lines.len()).unwrap_or(u16::MAX);
    let above = count.saturating_sub(area.height).min(area.y);
    let area = Rect { y: area.y - above, height: area.height + above, ..area };
    let mut before = None;
    let with_text = (0..area.height).zip(&lines).filter(|(_, (_, text))| !text.is_empty());
    for (row, (severity, text)) in with_text {
        Clear.render(Rect { y: area.y + row, height: 1, ..area }, canvas);
        let role = severity.role();
        if before != Some(*severity) {
            canvas.put(area, (1, row), severity.mark(), role);
        }
        before = Some(*severity);
        let column = if *severity == Severity::Note { 1 } else { 2 + columns(severity.mark()) };
        canvas.put(area, (column, row), text, role);
    }
}

/// Minimum columns of a shortened warning in the status row.
const WARNING_LEAST: usize = 14;
/// Columns between two parts of the status row.
const BETWEEN: usize = 3;

/// Draws the status row: state and cost of the run.
pub(crate) fn status(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let mut spans = vec![Span::raw(" ")];
    let parts = fitted(app.status(), usize::from(area.width.saturating_sub(1)));
    for (index, (severity, text)) in parts.into_iter().enumerate() {
        if index > 0 {
            spans.push(Span::styled(" | ", app.settings.theme.style(Role::Border)));
        }
        spans.push(Span::styled(text, app.settings.theme.style(severity.role())));
    }
    canvas.put_line(area, &Line::from(spans));
}

/// Fits the parts of a status row into this many columns. If necessary, drops the notes after the last warning, then shortens warnings,
/// then drops other notes except the first part. Warnings are never dropped.
fn fitted(mut parts: Vec<StatusPart>, room: usize) -> Vec<StatusPart> {
    let width = |part: &StatusPart| usize::from(columns(&part.1)) + BETWEEN;
    let least = |part: &StatusPart| match part.0 {
        Severity::Note => width(part),
        _ => width(part).min(WARNING_LEAST + BETWEEN),
    };
    while let Some(note) = parts.iter().rposition(|part| part.0 == Severity::Note) {
        let is_last = note + 1 == parts.len();
        let needed: usize =
            parts.iter().map(|part| if is_last { width(part) } else { least(part) }).sum();
        if note == 0 || needed <= room + BETWEEN {
            break;
        }
        parts.remove(note);
    }
    let mut left = room;
    for at in 0..parts.len() {
        let later: usize = parts[at + 1..].iter().map(least).sum();
        parts[at].1 = clip(&parts[at].1, left.saturating_sub(later));
        left = left.saturating_sub(width(&parts[at]));
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_stay_in_the_status_row_and_notes_give_way() {
        let part = |severity, text: &str| (severity, text.to_owned());
        let warning = |letter: &str| part(Severity::Warning, &letter.repeat(30));
        let note = |text| part(Severity::Note, text);
        let row = |room| {
            let parts = vec![
                note("arrested"),
                warning("a"),
                note("between"),
                warning("b"),
                note("at the end"),
                warning("c"),
                note("10 steps"),
            ];
            fitted(parts, room).into_iter().map(|part| part.1).collect::<Vec<_>>().join(" | ")
        };
        assert_eq!(row(200).matches(" | ").count(), 6);
        for room in [60, 80, 100, 120] {
            let text = row(room);
            assert!(text.len() <= room, "{room}: {text}");
            assert!(["aa", "bb", "cc"].iter().all(|word| text.contains(word)), "{room}: {text}");
            assert!(text.starts_with("arrested"), "{text}");
        }
        assert!(row(120).contains("between") && !row(60).contains("between"), "{}", row(120));
    }
}
