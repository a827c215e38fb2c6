//! Log tab: messages of this session, and all information on the current run.

use crate::tui::app::notice::Notice;
use crate::tui::app::pins::DisplayedRun;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::table::filtered;
use crate::tui::widgets::text::{broken, counted};
use cmra_engine::model::run::envelope;
use cmra_studies::report::run::page::{
    computation, energy, events, labelled, of_first, results, sentence,
};

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

/// Returns all lines of the Log tab, wrapped for a screen of this width.
pub fn log_lines(app: &App, columns: usize) -> Vec<TextLine> {
    let message = |notice: &Notice| {
        let word = notice.severity.word();
        (format!("{word:<8} {}", notice.text), notice.severity.role())
    };
    let mut messages: Vec<TextLine> = app.pages.log.messages.iter().rev().map(message).collect();
    let older = messages.split_off(NEWEST.min(messages.len()));
    let mut lines = Vec::new();
    section(&mut lines, "Messages of this session, newest first", messages);
    match &app.shown {
        Some(shown) => of_run(&mut lines, shown, app.is_stale()),
        None => section(&mut lines, "Run", [("no run yet".to_owned(), Role::Dim)]),
    }
    let explore = app.pages.explore.found();
    let explore = explore.map_or(&[][..], |grid| &grid.outside_at_ends);
    let search = app.pages.search.answer();
    let search = search.map_or(&[][..], |answer| answer.outside_at_ends());
    for (heading, ends) in [("Explore", explore), ("Search", search)] {
        if !ends.is_empty() {
            let ends = ends.iter().map(|end| (format!("! {}", end.1), Role::Warning));
            section(&mut lines, &format!("Warnings at the ends of an axis: {heading}"), ends);
        }
    }
    if !older.is_empty() {
        section(&mut lines, "Older messages", older);
    }
    let wanted = app.pages.log.find.trim().to_lowercase();
    lines.retain(|line| line.0.to_lowercase().contains(&wanted));
    // Two borders, and three columns of indentation with one blank.
    broken(lines, columns.saturating_sub(6).max(10))
}

/// Appends a heading and the lines below it, after a blank line.
fn section(lines: &mut Vec<TextLine>, heading: &str, body: impl IntoIterator<Item = TextLine>) {
    if !lines.is_empty() {
        lines.push((String::new(), Role::Text));
    }
    lines.push((heading.to_owned(), Role::Title));
    let before = lines.len();
    lines.extend(body);
    if lines.len() == before {
        lines.push(("none".to_owned(), Role::Dim));
    }
}

fn of_run(lines: &mut Vec<TextLine>, shown: &DisplayedRun, is_stale: bool) {
    let run = &shown.run;
    let plain = |texts: Vec<String>| texts.into_iter().map(|text| (text, Role::Text));
    let which = if is_stale { " (of another scene)" } else { "" };
    let warnings = envelope::warnings(run).into_iter();
    let warnings = warnings.map(|warning| (format!("! {warning}"), Role::Warning));
    section(lines, &format!("Warnings of the run{which}"), warnings);
    if let Some(stack) = &run.stack {
        section(
            lines,
            "Stack: plate by plate",
            plain(cmra_studies::study::stack::table(run, stack)),
        );
    }
    let first = of_first(run);
    section(lines, &format!("Events{first}"), plain(events(run)));
    let heading = format!("Energy{first}: where it was at the start, and where it went");
    section(lines, &heading, plain(energy(run)));
    let results = plain([vec![sentence(run)], labelled(results(run))].concat());
    section(lines, &format!("Results{first}"), results);
    let took_s = shown.elapsed.map(|took| took.as_secs_f64());
    section(lines, &format!("Computation{first}"), plain(labelled(computation(run, took_s))));
}
