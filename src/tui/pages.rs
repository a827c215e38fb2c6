//! The pages: for every tab its panes, the names of its pages, what it computes when it is shown, what keys do in it, and what it
//! says. The loop of the workbench knows only this.

pub mod explore;
pub mod limit;
pub mod log;
pub mod numerics;
pub mod run;
pub mod search;
pub mod thesis;

use crossterm::event::KeyEvent;
use ratatui::layout::Rect;

use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Tab};
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::{Content, Effect};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::worker::Report;

/// A part of the status row: how serious, the text, and a shorter form of it.
pub type StatusPart = (Severity, String, String);

/// A task of a page that has not ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::tui) struct Job {
    /// Its number.
    pub id: u64,
    /// What it is, for the status row of other tabs.
    pub label: &'static str,
}

/// A table of a page, to be written to a file or copied.
pub(in crate::tui) struct Table {
    /// What is written, for the dialog's frame.
    pub title: &'static str,
    /// The file proposed.
    pub file: String,
    /// What there is.
    pub content: Content,
}

impl Table {
    /// A table that is a text already.
    pub(in crate::tui) fn text(title: &'static str, file: String, text: String) -> Self {
        Self { title, file, content: Content::Text(text) }
    }
}

/// A tab of the workbench.
pub(in crate::tui) trait Page {
    /// The panes of the page shown, in the order in which Tab goes through them.
    fn panes(&self, app: &App) -> &'static [Pane];

    /// The names of its pages, where it has several.
    fn names(&self) -> &'static [&'static str] {
        &[]
    }

    /// The page shown, by its place among the names.
    fn shown(&self, _app: &App) -> usize {
        0
    }

    /// Show another page; it computes what it has not.
    fn turn_to(&self, _app: &mut App, _page: usize) -> Vec<Effect> {
        Vec::new()
    }

    /// The tab is shown: it computes what it has not, for the scene there is.
    fn enter(&self, _app: &mut App) -> Vec<Effect> {
        Vec::new()
    }

    /// What a key does here; `None` where the page has no meaning for it.
    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>>;

    /// What stands under the cursor, or what the selected row means.
    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)>;

    /// The status row, the most important part first.
    fn status(&self, app: &App) -> Vec<StatusPart>;

    /// What it is computing.
    fn running(&self, app: &App) -> Vec<Job>;

    /// A report of one of its tasks.
    fn report(&self, _app: &mut App, _report: Report) -> Vec<Effect> {
        Vec::new()
    }

    /// The table shown, once there is anything in it.
    fn table(&self, _app: &App) -> Option<Table> {
        None
    }

    /// The field that takes characters in the pane that has the keys.
    fn field<'a>(&self, _app: &'a App) -> Option<&'a TextField> {
        None
    }

    /// The same field, to type into.
    fn field_mut<'a>(&self, _app: &'a mut App) -> Option<&'a mut TextField> {
        None
    }

    /// A key while that field is open.
    fn press(&self, _app: &mut App, _key: KeyEvent) -> Vec<Effect> {
        Vec::new()
    }

    /// Draw its panes into the body of the screen.
    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>);
}

/// The page of a tab.
pub(in crate::tui) fn of(tab: Tab) -> &'static dyn Page {
    match tab {
        Tab::Run => &run::Tab,
        Tab::Explore => &explore::Tab,
        Tab::Limit => &limit::Tab,
        Tab::Search => &search::Tab,
        Tab::Numerics => &numerics::Tab,
        Tab::Thesis => &thesis::Tab,
        Tab::Log => &log::Tab,
    }
}

pub(in crate::tui) fn note(text: Option<String>) -> Option<(Severity, String)> {
    text.map(|text| (Severity::Note, text))
}

/// The jobs of a page by their numbers.
pub(in crate::tui) fn jobs(
    label: &'static str,
    ids: impl IntoIterator<Item = Option<u64>>,
) -> Vec<Job> {
    ids.into_iter().flatten().map(|id| Job { id, label }).collect()
}

/// The jobs of all pages.
pub(in crate::tui) fn all_jobs(app: &App) -> impl Iterator<Item = (Tab, Job)> {
    let of = |tab: Tab| of(tab).running(app).into_iter().map(move |job| (tab, job));
    Tab::ALL.into_iter().flat_map(of)
}
