//! The title row, the message row and the status row.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Widget};

use crate::tui::app::App;
use crate::tui::app::layout::SMALLEST;
use crate::tui::app::notice::Severity;
use crate::tui::app::status::clip;
use crate::tui::message::Target;
use crate::tui::pages;
use crate::tui::pages::Tab;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, put, put_line, text_role};

/// From this width on the title row has the name of the program.
const ROOMY: u16 = 100;

/// Tabs at the left; preset, whether it is modified, and auto-run at the right.
pub(in crate::tui) fn title(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let style = |role| app.theme.style(role);
    let (named, titles) = tabs(app, area.width);
    let mut column = lead(area.width);
    if named {
        column = put(canvas, area, (1, 0), "cmra", style(Role::Title)) + 2;
    }
    for (tab, text) in Tab::ALL.into_iter().zip(&titles) {
        let role = if tab == app.tab { Role::Selection } else { Role::Text };
        let start = column;
        column = put(canvas, area, (column, 0), text, style(role)) + 1;
        let title = Rect { x: area.x + start, width: columns(text), ..area };
        canvas.hit(title, |_| Some(Target::Tab(tab)));
    }
    let room = usize::from(area.width.saturating_sub(column + 2));
    if room < 6 {
        return;
    }
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
    put(canvas, area, (start, 0), &text, style(Role::Text));
}

/// The first column of the tabs: none is left free on the narrowest screen.
fn lead(width: u16) -> u16 {
    u16::from(width > SMALLEST.0)
}

/// Whether the program's name is shown, and the titles of the tabs, the one shown in brackets.
fn tabs(app: &App, width: u16) -> (bool, Vec<String>) {
    let title = |tab: Tab| {
        let title = tab.title();
        if tab == app.tab { format!("[{title}]") } else { title }
    };
    (width >= ROOMY, Tab::ALL.into_iter().map(title).collect())
}

/// The names of the tab's pages, the one shown in brackets, and how to get to the next.
pub(in crate::tui) fn pages(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let mut column = 1;
    let page = pages::of(app.tab);
    for (at, name) in page.about().pages.iter().enumerate() {
        let is_shown = at == page.shown(app);
        let text = if is_shown { format!("[{name}]") } else { (*name).to_owned() };
        let role = if is_shown { Role::Selection } else { Role::Text };
        let start = area.x + column;
        column = put(canvas, area, (column, 0), &text, app.theme.style(role)) + 2;
        let name = Rect { x: start, width: columns(&text), ..area };
        canvas.hit(name, |_| Some(Target::Page(at)));
    }
    let number = app.tab.index() + 1;
    let hint = format!("{number}: next page");
    let start = area.width.saturating_sub(columns(&hint) + 1);
    if start > column {
        put(canvas, area, (start, 0), &hint, app.theme.style(Role::Dim));
    }
}

/// What stands under the cursor and the newest message, each with its mark. What has no room in the area covers what stands above
/// it: the panes keep their places.
pub(in crate::tui) fn message(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let lines = app.message_lines(usize::from(area.width));
    let count = u16::try_from(lines.len()).unwrap_or(u16::MAX);
    let above = count.saturating_sub(area.height).min(area.y);
    let area = Rect { y: area.y - above, height: area.height + above, ..area };
    if above > 0 {
        Clear.render(area, canvas);
    }
    let mut before = None;
    for (row, (severity, text)) in (0..area.height).zip(&lines) {
        let style = app.theme.style(text_role(*severity));
        if before != Some(*severity) {
            put(canvas, area, (1, row), severity.mark(), style);
        }
        before = Some(*severity);
        let column = if *severity == Severity::Note { 1 } else { 3 };
        put(canvas, area, (column, row), text, style);
    }
}

/// What the run is and cost; the parts at the right go first when there is little room.
pub(in crate::tui) fn status(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
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
        spans.push(Span::styled((*text).to_owned(), app.theme.style(text_role(part.0))));
    }
    put_line(canvas, area, 0, &Line::from(spans));
}
