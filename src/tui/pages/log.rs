//! Log tab: messages of this session, and all information on the current run.

use crate::tui::app::notice::Notice;
use crate::tui::pages::page::prelude::*;
use crate::tui::plain::{TextStyle, block_lines};
use crate::tui::theme::Theme;
use crate::tui::widgets::table::filtered;
use crate::tui::widgets::text::{broken, counted};
use cmra_studies::report::Remark;
use cmra_studies::report::page::{Block, Page as Report};
use cmra_studies::report::run::page::log;

pub const LOG: Pane = Pane::new(Tab::Log, 0);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: LOG, label: "Log", keys: &[
        key(A::Down, "scroll", "scroll"),
        key(A::Find, "find", "show only the lines that contain a text"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Log)), "Log tab", "messages warnings events energy paths"),
];

pub(crate) struct LogTab;

impl Page for LogTab {
    fn about(&self) -> About {
        About { pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        app.pages.log.scroll = 0;
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let shown = app.list_rows();
        let count = log_lines(app, usize::from(app.size.0)).len().saturating_sub(shown) + 1;
        Some(Rows { count, selected: app.pages.log.scroll, shown })
    }

    fn select(&self, app: &mut App, row: usize) {
        app.pages.log.scroll = row;
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        Some(&mut app.pages.log.find)
    }

    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let lines = log_lines(app, usize::from(area.width));
        let height = usize::from(area.height.saturating_sub(2));
        let first = app.pages.log.scroll.min(lines.len().saturating_sub(height));
        let counter = counted(first, height, lines.len());
        let title = filtered("Log of this run and this session", &app.pages.log.find);
        let pane = PaneFrame::new(title).right(counter).focused(app.dialog.is_none());
        let inner = pane.draw(area, canvas);
        for (row, (text, role)) in inner.rows().zip(lines.iter().skip(first)) {
            let column = if *role == Role::Title { 1 } else { 3 };
            canvas.put(row, (column, 0), text, *role);
        }
    }
}

/// Number of messages above the report of the run.
const NEWEST: usize = 5;
/// Columns of the borders and of the indentation, and a blank.
const AROUND: usize = 6;

/// Returns all lines of the Log tab, wrapped for a screen of this width.
pub fn log_lines(app: &App, columns: usize) -> Vec<TextLine> {
    let width = columns.saturating_sub(AROUND).max(10);
    let wanted = app.pages.log.find.trim().to_lowercase();
    let is_wanted = |text: &str| text.to_lowercase().contains(&wanted);
    let mut messages: Vec<TextLine> = app.pages.log.messages.iter().rev().map(message).collect();
    messages.retain(|line| is_wanted(&line.0));
    let older = messages.split_off(NEWEST.min(messages.len()));
    let mut report = Vec::new();
    if let Some(shown) = &app.shown {
        let took_s = shown.elapsed.map(|took| took.as_secs_f64());
        report.extend(log(&shown.run, took_s, app.is_stale()).blocks);
    } else {
        report.extend([Block::Heading("Run".to_owned()), Block::Line("no run yet".to_owned())]);
    }
    report.extend(ends_of_axes(app));
    let style = TextStyle { width, theme: Theme::PLAIN, is_brief: false };
    // A text of several lines is kept whole; of a table each line is one.
    let lines = report.iter().flat_map(|block| {
        let lines = block_lines(block, style);
        let whole: Vec<&str> = lines.iter().map(|line| line.0.trim()).collect();
        let is_whole = !matches!(block, Block::Table(_)) && is_wanted(&whole.join(" "));
        lines.into_iter().filter(|line| is_whole || is_wanted(&line.0)).collect::<Vec<TextLine>>()
    });
    let mut all = Vec::new();
    let heading = |text: &str| (text.to_owned(), Role::Title);
    let newest = "Messages of this session, newest first";
    all.extend(is_wanted(newest).then(|| heading(newest)));
    if messages.is_empty() && wanted.is_empty() {
        messages.push(("none".to_owned(), Role::Dim));
    }
    all.extend(broken(messages, width));
    all.extend(lines);
    if !older.is_empty() {
        all.extend([(String::new(), Role::Text), heading("Older messages")]);
        all.extend(broken(older, width));
    }
    all
}

/// Formats a message after the word for its severity.
fn message(notice: &Notice) -> TextLine {
    let word = notice.severity.word();
    (format!("{word:<8} {}", notice.text), notice.severity.role())
}

/// Lists what the ends of an axis of the pages' studies are outside of.
fn ends_of_axes(app: &App) -> Vec<Block> {
    let explore = app.pages.explore.found();
    let explore = explore.map_or(&[][..], |grid| &grid.outside_at_ends);
    let search = app.pages.search.answer();
    let search = search.map_or(&[][..], |answer| answer.outside_at_ends());
    let mut page = Report::default();
    for (heading, ends) in [("Explore", explore), ("Search", search)] {
        if !ends.is_empty() {
            page.heading(format!("Warnings at the ends of an axis: {heading}"));
            let ends = ends.iter().map(|end| Remark::caution("! ", end.1.to_string()));
            page.remarks(ends, 2);
        }
    }
    page.blocks
}
