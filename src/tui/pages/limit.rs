//! The Limit tab: the ballistic limit, the residual velocity, and the comparison at equal areal mass.

pub mod comparison;
pub(in crate::tui) mod draw;
pub(in crate::tui) mod efficiency_map;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub mod state;

use ratatui::layout::Rect;

use crate::report::{compare, limit};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::ask;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart, Table, jobs, note};
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

    fn table(&self, app: &App) -> Option<Table> {
        let stem = ask::base_stem(app);
        let table = match app.pane() {
            Pane::Residual => {
                let report = app.limit.report.as_ref().filter(|report| !report.shots.is_empty())?;
                let text = limit::shots(&app.name_of(&report.scene), report).csv();
                let file = format!("{}-limit.csv", ask::stem(app, &report.scene));
                Table::text("Export the shots to CSV", file, text)
            }
            Pane::Comparison => {
                let (scene, found) = app.limit.comparison.as_ref()?;
                let text = compare::table(&app.name_of(scene), &found.report).csv();
                Table::text("Export the comparison to CSV", format!("{stem}-compare.csv"), text)
            }
            _ => {
                let (scene, found) = app.limit.comparison.as_ref()?;
                let text = compare::map_table(&app.name_of(scene), found.map.as_ref()?).csv();
                Table::text("Export the map to CSV", format!("{stem}-mass-efficiency.csv"), text)
            }
        };
        Some(table)
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
