//! The Limit tab: the ballistic limit, the residual velocity, and the comparison at equal areal mass.

pub mod comparison;
pub(in crate::tui) mod draw;
pub(in crate::tui) mod efficiency_map;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub mod state;

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart, jobs, note};
use crate::tui::widgets::Canvas;
use crate::worker::{Report, Slot};

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Residual, Pane::Comparison, Pane::EfficiencyMap]
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Residual => app.limit_readout(),
            Pane::Comparison => note(app.comparison_readout()),
            _ => note(app.efficiency_readout()),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.limit_status()
    }

    fn running(&self, app: &App) -> Vec<Job> {
        let running = [&app.limit.finding, &app.limit.comparing];
        jobs("3:Limit", running.map(|job| job.as_ref().map(|job| job.id)))
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        if report.slot == Slot::Compare {
            keys::report_comparison(app, report.body);
        } else {
            keys::report(app, report.body);
        }
        Vec::new()
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.comparison {
            comparison::draw::render(app, area, canvas);
        }
        if let Some(area) = panes.residual {
            draw::render(app, area, canvas);
        }
        if let Some(area) = panes.map {
            comparison::draw::map(app, area, canvas);
        }
    }
}
