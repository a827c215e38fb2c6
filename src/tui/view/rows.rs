//! The title row, the message row and the status row.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::text::{columns, put, put_line};
use crate::tui::app::notice::Severity;
use crate::tui::app::status::clip;
use crate::tui::app::{App, Tab};
use crate::tui::theme::Role;

/// The role of a message.
fn role(severity: Severity) -> Role {
    match severity {
        Severity::Note => Role::Text,
        Severity::Warning => Role::Warning,
        Severity::Error => Role::Error,
    }
}

/// Tabs at the left; preset, whether it is modified, and auto-run at the right.
pub(super) fn title(app: &App, area: Rect, buffer: &mut Buffer) {
    let style = |role| app.theme.style(role);
    let mut column = 1;
    let (named, titles) = tabs(app, area.width);
    if named {
        column = put(buffer, area, (1, 0), "cmra", style(Role::Title)) + 2;
    }
    for (tab, text) in Tab::ALL.into_iter().zip(&titles) {
        let role = if tab == app.tab { Role::Selection } else { Role::Text };
        column = put(buffer, area, (column, 0), text, style(role)) + 1;
    }
    let room = usize::from(area.width.saturating_sub(column + 2));
    // Everything in words where that leaves room for the name.
    let wide = room >= usize::from(columns(&app.base.name)) + 32;
    let changed = match (app.is_modified(), wide) {
        (false, _) => "",
        (true, false) => " *",
        (true, true) => " (modified)",
    };
    let auto = match (app.auto_run, wide) {
        (true, false) => "",
        (true, true) => "  auto-run on",
        (false, _) => "  auto-run off",
    };
    let mouse = if app.mouse { "  mouse on" } else { "" };
    let preset = if wide { "preset " } else { "" };
    let fixed = columns(preset) + columns(changed) + columns(auto) + columns(mouse);
    let name = clip(&app.base.name, room.saturating_sub(usize::from(fixed)).max(6));
    let text = format!("{preset}{name}{changed}{auto}{mouse}");
    let start = area.width.saturating_sub(columns(&text) + 1).max(column);
    put(buffer, area, (start, 0), &text, style(Role::Text));
}

/// The tab whose title is at a column of the title row.
pub(super) fn tab_at(app: &App, width: u16, column: u16) -> Option<Tab> {
    let (named, titles) = tabs(app, width);
    let mut start = if named { 7 } else { 1 };
    Tab::ALL.into_iter().zip(&titles).find_map(|(tab, title)| {
        let end = start + columns(title);
        let hit = (start..end).contains(&column);
        start = end + 1;
        hit.then_some(tab)
    })
}

/// Whether the program's name is shown, and the titles of the tabs: the longest that leave the scene's name in full.
fn tabs(app: &App, width: u16) -> (bool, Vec<String>) {
    let titles = |shown: usize, full: bool, active_full: bool| -> Vec<String> {
        let title = |tab: Tab| {
            let is_shown = tab == app.tab;
            let long = if is_shown { active_full } else { full };
            let title = if long { tab.title() } else { tab.short_title() };
            if is_shown { format!("[{title}]") } else { title.chars().take(shown).collect() }
        };
        Tab::ALL.into_iter().map(title).collect()
    };
    if width < 74 {
        // Not even the tabs have room: only the one shown has its name.
        return (width >= 66, titles(1, false, true));
    }
    let changed = if app.is_modified() { 2 } else { 0 };
    let name = usize::from(columns(&app.base.name)) + changed;
    let fits = |named: bool, titles: &[String]| {
        let tabs: usize = titles.iter().map(|title| title.chars().count() + 1).sum();
        tabs + name + if named { 9 } else { 3 } <= usize::from(width)
    };
    for (named, full) in [(true, true), (false, true), (true, false), (false, false)] {
        let titles = titles(usize::MAX, full, true);
        if fits(named, &titles) {
            return (named, titles);
        }
    }
    // No titles leave a very long name whole.
    let roomy = width >= 100;
    (roomy, titles(usize::MAX, roomy, roomy))
}

/// The newest message with its mark, or what stands in its place.
pub(super) fn message(app: &App, area: Rect, buffer: &mut Buffer) {
    let lines = app.message_lines(usize::from(area.width));
    for (row, (severity, text)) in (0..area.height).zip(&lines) {
        let style = app.theme.style(role(*severity));
        if row == 0 {
            put(buffer, area, (1, row), severity.mark(), style);
        }
        let column = if *severity == Severity::Note { 1 } else { 3 };
        put(buffer, area, (column, row), text, style);
    }
}

/// What the run is and cost; the parts at the right go first when there is little room.
pub(super) fn status(app: &App, area: Rect, buffer: &mut Buffer) {
    let parts = app.status();
    let room = usize::from(area.width.saturating_sub(2));
    let total = |texts: &[&str]| texts.iter().map(|text| text.chars().count() + 3).sum::<usize>();
    let long: Vec<&str> = parts.iter().map(|part| part.1.as_str()).collect();
    let short: Vec<&str> = parts.iter().map(|part| part.2.as_str()).collect();
    let mut texts = if total(&long) <= room + 3 { long } else { short };
    while texts.len() > 1 && total(&texts) > room + 3 {
        texts.pop();
    }
    let mut spans = vec![Span::raw(" ")];
    for (index, (text, part)) in texts.iter().zip(&parts).enumerate() {
        if index > 0 {
            spans.push(Span::styled(" | ", app.theme.style(Role::Border)));
        }
        spans.push(Span::styled((*text).to_owned(), app.theme.style(role(part.0))));
    }
    put_line(buffer, area, 0, &Line::from(spans));
}
