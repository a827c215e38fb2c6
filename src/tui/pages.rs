//! The pages: for every tab its panes and their keys, the names of its pages, what it computes when it is shown, what keys do in
//! it, and what it says. The loop of the workbench knows only this.

pub mod explore;
pub mod limit;
pub mod log;
pub mod numerics;
pub mod run;
pub mod search;
pub mod thesis;

/// What the files of the pages have in common.
pub(crate) mod prelude {
    pub(crate) use std::error::Error;
    pub(crate) use std::sync::Arc;

    pub(crate) use super::{BEING_COMPUTED, note, nothing, old, part, progress};
    pub(crate) use super::{LabelledScene, Page, PageSpec, Progress, Rows, StatusPart};
    pub(crate) use crate::model::scene::Scene;
    pub(crate) use crate::model::units::significant;
    pub(crate) use crate::study::context::Context;
    pub(crate) use crate::tui::app::jobs::{Kept, Running};
    pub(crate) use crate::tui::app::layout::{split_bottom, split_left, split_top};
    pub(crate) use crate::tui::app::status::{clip, wrap};
    pub(crate) use crate::tui::chart::{Scale, ViewRange};
    pub(crate) use crate::tui::keymap::{Action as A, Call, Command, PaneSpec, Part, key};
    pub(crate) use crate::tui::message::PageTable;
    pub(crate) use crate::tui::prelude::*;
    pub(crate) use crate::tui::update::zoom::{Across, Span};
    pub(crate) use crate::tui::update::{edit, jobs};
    pub(crate) use crate::tui::widgets::RowList;
    pub(crate) use crate::tui::widgets::text::{TextLine, columns};
    pub(crate) use crate::worker::study::{Lane, Reporter, RowsSoFar, Study};
    pub(crate) use crate::worker::{Finding, ReportBody};
}

use crate::model::scene::Scene;
use crate::tui::app::jobs::{Kept, Running};
use crate::tui::keymap::{Bound, Command, Keymap, PaneSpec};
use crate::tui::message::PageTable;
use crate::tui::pages::run::steps::Input;
use crate::tui::prelude::*;
use crate::tui::update::zoom::Across;
use crate::tui::widgets::form::Form;
use crate::worker::ReportBody;
use crate::worker::study::Study;

/// A scene that can be loaded or pinned, and what it is in words.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelledScene {
    pub scene: Scene,
    pub label: String,
}

/// A part of the status row: how serious, the text, and a shorter form of it.
pub type StatusPart = (Severity, String, String);

pub(crate) fn part(severity: Severity, text: impl Into<String>) -> StatusPart {
    let text = text.into();
    (severity, text.clone(), text)
}

/// The words of a pane, and of its row of status, before anything was computed.
pub(crate) const NO_RESULTS: &str = "no results yet: press <run>";

/// The refusal of what needs results that are under way.
pub(crate) const BEING_COMPUTED: &str = "being computed";

/// The words for results that belong to another scene or setup than the one on the screen.
pub(crate) fn old(whose: &str) -> String {
    format!("another {whose}'s results: press <run>")
}

/// The words of a pane that has nothing to show: while its study runs, else why there is nothing.
pub(crate) fn nothing<S: Study>(
    app: &App,
    running: &'static str,
    why: Option<&'static str>,
) -> String {
    let waits = app.jobs.running::<S>().is_some();
    app.keymap.shown(if waits { running } else { why.unwrap_or(NO_RESULTS) })
}

/// How what a page computes stands: its words in the status row are the same on every page.
pub(crate) enum Progress<'a> {
    /// Under way; what is done, and how much of it.
    Running(String),
    Nothing,
    /// The display belongs to another object.
    Old(&'a str),
    /// Stopped before its end; how far it came.
    Cut(String),
    Done(String),
}

impl Progress<'_> {
    pub(crate) fn part(self) -> StatusPart {
        let (severity, text) = match self {
            Self::Running(what) => (Severity::Note, format!("{what} (<back> cancels)")),
            Self::Nothing => (Severity::Note, NO_RESULTS.to_owned()),
            Self::Old(whose) => (Severity::Warning, old(whose)),
            Self::Cut(after) => (Severity::Warning, format!("cancelled{after}: press <run>")),
            Self::Done(text) => (Severity::Note, text),
        };
        part(severity, text)
    }
}

/// How a study of a scene stands that is so far kept as this; nothing to say where all of it is there.
pub(crate) fn progress<S: Study, T>(
    app: &App,
    kept: &Kept<T>,
    scene: &Scene,
    words: impl FnOnce(&Running) -> String,
) -> Option<Progress<'static>> {
    match app.jobs.running::<S>() {
        Some(running) => Some(Progress::Running(words(running))),
        None if kept.is_old(scene) => Some(Progress::Old("scene")),
        None if kept.found.is_none() => Some(Progress::Nothing),
        None => (!kept.is_complete).then(|| Progress::Cut(String::new())),
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rows {
    pub count: usize,
    pub selected: usize,
    pub shown: usize,
}

/// A page of a tab that has several.
pub(crate) struct PageSpec {
    pub name: &'static str,
    pub panes: &'static [Pane],
}

/// The constants of a tab.
pub(crate) struct About {
    pub name: &'static str,
    /// Its pages, where it has several.
    pub pages: &'static [PageSpec],
    /// All of its panes; the first one has the focus at the start.
    pub panes: &'static [PaneSpec],
    /// The entries of the palette.
    pub commands: &'static [Command],
}

/// A tab of the workbench. What applies to a pane applies to the focused one, which is one of the page's own.
pub(crate) trait Page: Sync {
    /// The panes shown, in the order in which Tab goes through them.
    fn shown_panes(&self, app: &App) -> Vec<Pane> {
        let About { panes, pages, .. } = app.tab.about();
        let all = || panes.iter().map(|spec| spec.pane).collect();
        pages.get(self.shown(app)).map_or_else(all, |page| page.panes.to_vec())
    }

    /// The page shown, by its place: the first one that has the pane with the keys.
    fn shown(&self, app: &App) -> usize {
        let pages = app.tab.about().pages.iter();
        pages.take_while(|page| !page.panes.contains(&app.pane())).count()
    }

    /// Show another page; it computes what it has not.
    fn turn_to(&self, app: &mut App, page: usize) {
        if let Some(page) = app.tab.about().pages.get(page) {
            app.focus_on(page.panes[0]);
            self.enter(app);
        }
    }

    /// The tab is shown: it computes what it has not, for the scene there is.
    fn enter(&self, _app: &mut App) {}

    /// Another of its panes has been given the keys.
    fn focused(&self, _app: &mut App) {}

    /// Do what a key means here; `false` where the page has no meaning of its own for it.
    fn act(&self, _app: &mut App, _action: Action) -> bool {
        false
    }

    /// Whether a key that the pane lists has nothing to act on as things are.
    fn is_idle(&self, _app: &App, _action: Action) -> bool {
        false
    }

    /// What stands under the cursor, or what the selected row means.
    fn readout(&self, _app: &App, _room: usize) -> Option<(Severity, String)> {
        None
    }

    /// The status row, the most important part first.
    fn status(&self, app: &App) -> Vec<StatusPart>;

    fn report(&self, _app: &mut App, _running: &Running, _news: &ReportBody) {}

    /// The table shown, once there is anything in it.
    fn table(&self, _app: &App) -> Option<PageTable> {
        None
    }

    fn form(&self, _app: &App) -> Option<Form> {
        None
    }

    /// The rows of the pane, where it is a list or a form.
    fn rows(&self, app: &App) -> Option<Rows> {
        self.form(app).map(|form| form.rows(app.list_rows()))
    }

    fn select(&self, _app: &mut App, _row: usize) {}

    /// The text of a row that `/` searches; `None` if the pane has no search.
    fn row_name(&self, app: &App, row: usize) -> Option<String> {
        Some(self.form(app)?.row(row)?.label.clone())
    }

    /// The text that the rows of the pane are filtered by, where `/` filters them.
    fn filter<'a>(&self, _app: &'a mut App) -> Option<&'a mut String> {
        None
    }

    /// The text that the field of a row opens with.
    fn text(&self, app: &App, row: usize) -> String {
        let text = || self.form(app)?.row(row)?.text.clone();
        text().unwrap_or_default()
    }

    /// Whether the open field takes a number with a unit.
    fn takes_unit(&self, app: &App) -> bool {
        self.form(app).is_some_and(|form| form.line().is_some_and(|line| line.takes_unit))
    }

    /// Whether a text differs from that of the row; a dim value has no effect at present, and gets one when it is typed again.
    fn is_new(&self, app: &App, row: usize, text: &str) -> bool {
        let form = self.form(app);
        let is_dim = form.is_some_and(|form| form.row(row).is_some_and(|it| it.role == Role::Dim));
        is_dim || text != self.text(app, row)
    }

    /// Change the value of a row of the pane.
    fn change(&self, _app: &mut App, _row: usize, _input: Input<'_>) -> Result<(), String> {
        Ok(())
    }

    /// Put the cursor on a cell of the map in the pane.
    fn go_to_cell(&self, _app: &mut App, _cell: (usize, usize)) {}

    /// The axis across of the chart in the pane, where a part of it can be chosen.
    fn across<'a>(&self, _app: &'a mut App) -> Option<Across<'a>> {
        None
    }

    /// Put the crosshair of a chart of the pane on a value of its axis across.
    fn go_to_value(&self, _app: &mut App, _chart: usize, _value: f64) {}

    /// Draw its panes into the body of the screen.
    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>);
}

macro_rules! pages {
    ($($tab:ident, $module:ident::$page:ident, $id:literal, $key:literal, $about:literal $(, $field:ident: $state:ty)?;)*) => {
        #[derive(Clone, Debug, Default)]
        pub struct States {
            $($(#[doc = $about] pub $field: $state,)?)*
        }

        /// The tabs, in the order of the title row.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Tab {
            $(#[doc = $about] $tab,)*
        }

        impl Tab {
            pub const ALL: [Self; [$($key),*].len()] = [$(Self::$tab),*];

            pub(crate) fn about(self) -> &'static About {
                match self {
                    $(Self::$tab => &const {
                        use $module::{COMMANDS as commands, PAGES as pages, PANES as panes};
                        About { name: stringify!($tab), pages, panes, commands }
                    },)*
                }
            }
        }

        /// The keys that lead to the tabs.
        pub(crate) const TAB_KEYS: &[Bound] = &[
            $((Action::Tab(Tab::$tab), $id, $key),)*
        ];

        pub(crate) fn of(tab: Tab) -> &'static dyn Page {
            match tab {
                $(Tab::$tab => &$module::$page,)*
            }
        }
    };
}

pages! {
    Run, run::RunTab, "tab-run", "1", "One impact: variables, charts, runs.", run: run::RunPage;
    Explore, explore::ExploreTab, "tab-explore", "2", "Curves or a map of a quantity over one variable or two.", explore: explore::state::Sweeping;
    Limit, limit::LimitTab, "tab-limit", "3", "The ballistic limit, and the comparison at equal areal mass.", limit: limit::state::Ballistic;
    Search, search::SearchTab, "tab-search", "4", "Goal seek, Pareto front, sensitivity, Monte Carlo.", search: search::state::Searching;
    Numerics, numerics::NumericsTab, "tab-numerics", "5", "Accuracy and stability of the methods.", numerics: numerics::Numerics;
    Thesis, thesis::ThesisTab, "tab-thesis", "6", "The thesis: what is computed of it, its principles, its concepts.", thesis: thesis::Thesis;
    Log, log::LogTab, "tab-log", "7", "Warnings, events, energy, cost and messages.", log: log::Log;
}

impl Default for Tab {
    fn default() -> Self {
        Self::ALL[0]
    }
}

impl Tab {
    /// Its place in the title row, from 0.
    pub fn index(self) -> usize {
        self as usize
    }

    /// The text in the title row, with the key that leads there.
    pub(crate) fn title(self, keys: &Keymap) -> String {
        let (key, name) = (keys.label(Action::Tab(self)), self.about().name);
        if key.is_empty() { name.to_owned() } else { format!("{key}:{name}") }
    }
}

/// All panes, in the order of the tabs.
pub fn all_panes() -> impl Iterator<Item = &'static PaneSpec> {
    Tab::ALL.into_iter().flat_map(|tab| tab.about().panes)
}

pub fn spec(pane: Pane) -> &'static PaneSpec {
    let panes = pane.tab.about().panes;
    panes.iter().find(|spec| spec.pane == pane).unwrap_or(&panes[0])
}

pub(crate) fn note(text: Option<String>) -> Option<(Severity, String)> {
    text.map(|text| (Severity::Note, text))
}

/// The tasks that have not ended: the tab that requested each, and its number.
pub(crate) fn all_jobs(app: &App) -> impl Iterator<Item = (Tab, u64)> {
    let current = app.jobs.current.as_ref().map(|job| job.id);
    let runs = current.into_iter().chain(app.pins.iter().filter_map(|pin| pin.job));
    let studies = app.jobs.studies.iter().map(|running| (running.tab, running.id));
    runs.map(|id| (Tab::Run, id)).chain(studies)
}

#[cfg(test)]
mod tests;
