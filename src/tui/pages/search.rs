//! The Search tab: goal seek, Pareto front, sensitivity, Monte Carlo.

pub mod bounds;
pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub mod lines;
pub mod request;
pub mod setup;
pub mod state;

use std::sync::Arc;

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::layout::{NARROW, setup_width, split_left};
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, Part, key};
use crate::tui::message::Effect;
use crate::tui::pages::run::steps::Press;
use crate::tui::pages::{About, Page, Rows, StatusPart, Tab, Table, note};
use crate::tui::update::zoom::Across;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::form::Form;

/// Columns of a search's setup there: its longest row, `stroke at most 1.000 m`, and a frame.
const SEARCH_SETUP: u16 = 30;

/// Where setup and findings stand; where there is no room for both, the one that has the keys has more of it, or all.
pub(in crate::tui) fn panes(app: &App, body: Rect) -> (Rect, Rect) {
    let width = match (app.is_full(), app.pane()) {
        (false, SETUP) if body.width < NARROW => SEARCH_SETUP,
        (false, _) if body.width < NARROW => 0,
        (false, _) => setup_width(body.width),
        (true, SETUP) => body.width,
        (true, _) => 0,
    };
    split_left(body, width)
}
/// What is looked for.
pub const SETUP: Pane = Pane::of(Tab::Search, 0);
/// What was found.
pub const RESULTS: Pane = Pane::of(Tab::Search, 1);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: SETUP, label: "Search setup", has: &[Part::Form], keys: &[
        key(A::Enter, "type", "type a variable, bounds (0.8..7, 1e3..1e6:log, off), a goal or a quantity"),
        key(A::Right, "change", "take the next value, or switch on and off"),
        key(A::Run, "search", "search with this setup"),
        key(A::Down, "move", "move to another row"),
        key(A::Find, "find", "find a row of the setup"),
    ] },
    PaneSpec { pane: RESULTS, label: "Search results", has: &[Part::Chart, Part::Table], keys: &[
        key(A::Down, "move", "move to the next design or solution"),
        key(A::Enter, "load", "load this design into the scene (u undoes)"),
        key(A::Mark, "pin", "pin this design"),
        key(A::Sort, "sort", "sort the table by the next column"),
        key(A::View, "axes", "show the next pair of objectives in the chart"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Search)), "Search tab", "find a design"),
    Command::new(Call::Show(RESULTS, Some(0)), "Goal seek", "seek target solve inverse root"),
    Command::new(Call::Show(RESULTS, Some(1)), "Pareto front", "optimise optimize best designs knee trade-off"),
    Command::new(Call::Show(RESULTS, Some(2)), "Sensitivity", "sobol morris importance ranking"),
    Command::new(Call::Show(RESULTS, Some(3)), "Monte Carlo", "uncertainty scatter spread distribution histogram"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct SearchTab;

impl Page for SearchTab {
    fn about(&self) -> &'static About {
        &About {
            name: "Search",
            pages: &["Goal seek", "Pareto front", "Sensitivity", "Monte Carlo"],
            panes: PANES,
            commands: COMMANDS,
        }
    }

    fn shown(&self, app: &App) -> usize {
        app.pages.search.page.index()
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        keys::turn_to(app, page)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        note(app.search_readout())
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.search_status()
    }

    fn report(&self, app: &mut App, running: &Running, news: &News) {
        keys::report(app, running, news);
    }

    fn table(&self, app: &App) -> Option<Table> {
        let (file, found) = (app.pages.search.page.file(), app.pages.search.shown()?.clone());
        let (name, scene) = (app.name_of(&found.scene), Arc::clone(&found.scene));
        let is_complete = found.is_complete();
        let csv = move || found.csv(&name);
        let title = "Export the results to CSV";
        Some(Table::new(title, file, Some(&scene), csv).complete(is_complete))
    }

    fn is_idle(&self, app: &App, action: Action) -> bool {
        let on_rows = matches!(action, Action::Down | Action::Enter | Action::Mark | Action::Sort);
        let is_front = app.pages.search.page == state::Page::Front;
        let idle =
            (on_rows && app.pages.search.choices() == 0) || (action == Action::View && !is_front);
        app.pane() == RESULTS && idle
    }

    fn form(&self, app: &App) -> Option<Form> {
        (app.pane() == SETUP).then(|| app.search_form())
    }

    fn step(&self, app: &mut App, row: usize, press: Press) -> Result<Vec<Effect>, String> {
        keys::step(app, app.search_choices()[row], press)
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let (tab, shown) = (&app.pages.search, app.list_rows());
        if let Some(form) = self.form(app) {
            return Some(form.rows(shown));
        }
        let (count, selected) = match tab.choices() {
            0 => (keys::hidden_lines(app) + 1, tab.scrolled()),
            choices => (choices, tab.selected()),
        };
        Some(Rows { count, selected, shown })
    }

    fn select(&self, app: &mut App, row: usize) {
        match app.pane() {
            SETUP => app.pages.search.row = app.search_choices()[row],
            _ => app.pages.search.select(row),
        }
    }

    fn after_enter(&self) -> Option<Action> {
        None
    }

    fn take(&self, app: &mut App, row: usize, text: &str) -> Result<Vec<Effect>, String> {
        keys::take(app, app.search_choices()[row], text)
    }

    fn across<'a>(&self, app: &'a mut App) -> Option<Across<'a>> {
        if app.pane() != RESULTS {
            return None;
        }
        let tab = &mut app.pages.search;
        let (x, about) = draw::across(tab)?;
        Some(Across::of(&mut tab.zoomed, x.view, x.scale, about))
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, panes(app, body), canvas);
    }
}
