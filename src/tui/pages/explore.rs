//! The Explore tab: curves or a map of a quantity over one variable or two.

pub(in crate::tui) mod curves;
pub(in crate::tui) mod gaps;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub(in crate::tui) mod map;
pub(in crate::tui) mod plan;
pub(in crate::tui) mod progress;
pub mod setup;
pub mod state;

use std::sync::Arc;

use crossterm::event::KeyEvent;
use ratatui::layout::Rect;

use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::ask;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::{Content, Effect};
use crate::tui::pages::explore::state::Picture;
use crate::tui::pages::{Job, Page, StatusPart, Table, jobs, note};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::worker::Report;

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::ExploreSetup, Pane::Explore]
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        note(match app.pane() {
            Pane::ExploreSetup => Some(app.setup_readout(app.picture())),
            _ => app.sweep_readout(room),
        })
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.sweep_status(app.picture())
    }

    fn running(&self, app: &App) -> Vec<Job> {
        jobs("2:Explore", [app.sweeping.computing.as_ref().map(|job| job.id)])
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        keys::report(app, report.body);
        Vec::new()
    }

    fn table(&self, app: &App) -> Option<Table> {
        let found = app.sweeping.found(app.picture())?;
        let plan = found.grid.plan();
        let names: Vec<&str> = plan.axes().iter().map(Axis::symbol).collect();
        let content = Content::Grid(app.name_of(plan.base()), Arc::clone(&found.grid));
        Some(Table {
            title: "Export the sweep to CSV",
            file: format!("{}-{}.csv", ask::base_stem(app), names.join("-")),
            content,
        })
    }

    fn field<'a>(&self, app: &'a App) -> Option<&'a TextField> {
        let field = app.sweeping.field.as_ref().filter(|_| app.pane() == Pane::ExploreSetup);
        field.map(|field| &field.text)
    }

    fn field_mut<'a>(&self, app: &'a mut App) -> Option<&'a mut TextField> {
        let has_keys = app.pane() == Pane::ExploreSetup;
        app.sweeping.field.as_mut().filter(|_| has_keys).map(|field| &mut field.text)
    }

    fn press(&self, app: &mut App, key: KeyEvent) -> Vec<Effect> {
        setup::keys::press(app, key)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.setup {
            setup::draw::render(app, app.picture(), area, canvas);
        }
        match app.picture() {
            Picture::Line => curves::render(app, &panes, canvas),
            Picture::Surface => map::render(app, &panes, canvas),
        }
    }
}
