//! The Search tab: goal seek, Pareto front, sensitivity, Monte Carlo.

pub mod bounds;
pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub mod lines;
pub mod setup;
pub mod state;

use crossterm::event::KeyEvent;
use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{NARROW, setup_width, split_left};
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart, Table, jobs, note};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;

/// Columns of a search's setup there: its longest row, `stroke at most 1.000 m`, and a frame.
const SEARCH_SETUP: u16 = 30;

/// Where setup and findings stand; where there is no room for both, the one that has the keys has more of it, or all.
pub(in crate::tui) fn panes(app: &App, body: Rect) -> (Rect, Rect) {
    let width = match (app.is_full(), app.pane()) {
        (false, Pane::SearchSetup) if body.width < NARROW => SEARCH_SETUP,
        (false, _) if body.width < NARROW => 0,
        (false, _) => setup_width(body.width),
        (true, Pane::SearchSetup) => body.width,
        (true, _) => 0,
    };
    split_left(body, width)
}
use crate::worker::Report;

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::SearchSetup, Pane::Search]
    }

    fn names(&self) -> &'static [&'static str] {
        &["Goal seek", "Pareto front", "Sensitivity", "Monte Carlo"]
    }

    fn shown(&self, app: &App) -> usize {
        app.searching.page.index()
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

    fn running(&self, app: &App) -> Vec<Job> {
        jobs("4:Search", [app.searching.running.as_ref().map(|job| job.id)])
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        keys::report(app, report.body);
        Vec::new()
    }

    fn table(&self, app: &App) -> Option<Table> {
        let file = app.searching.page.file().to_owned();
        Some(Table::text("Export the results to CSV", file, app.search_csv()?))
    }

    fn field<'a>(&self, app: &'a App) -> Option<&'a TextField> {
        let field = app.searching.field.as_ref().filter(|_| app.pane() == Pane::SearchSetup);
        field.map(|field| &field.text)
    }

    fn field_mut<'a>(&self, app: &'a mut App) -> Option<&'a mut TextField> {
        let has_keys = app.pane() == Pane::SearchSetup;
        app.searching.field.as_mut().filter(|_| has_keys).map(|field| &mut field.text)
    }

    fn press(&self, app: &mut App, key: KeyEvent) -> Vec<Effect> {
        keys::press(app, key)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, panes(app, body), canvas);
    }
}
