//! The Numerics tab: accuracy and stability of the methods.

pub mod accuracy;
pub mod stability;

use ratatui::layout::Rect;

use crate::report::stability as stability_table;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::ask;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::{Content, Effect};
use crate::tui::pages::{Job, Page, StatusPart, Table, jobs, note};
use crate::tui::widgets::Canvas;
use crate::worker::{Report, Slot};

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, app: &App) -> &'static [Pane] {
        if app.pane() == Pane::Accuracy {
            &[Pane::Accuracy]
        } else {
            &[Pane::StabilityMap, Pane::Battery]
        }
    }

    fn names(&self) -> &'static [&'static str] {
        &["Accuracy", "Stability"]
    }

    fn shown(&self, app: &App) -> usize {
        usize::from(app.pane() != Pane::Accuracy)
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        app.focus_on(if page == 0 { Pane::Accuracy } else { Pane::StabilityMap });
        self.enter(app)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        match app.pane() {
            Pane::Accuracy => accuracy::keys::enter(app),
            _ => stability::keys::enter(app),
        }
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        match app.pane() {
            Pane::Accuracy => accuracy::keys::act(app, action),
            _ => stability::keys::act(app, action),
        }
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Accuracy => note(app.accuracy_readout()),
            Pane::StabilityMap => note(app.map_readout()),
            _ => app.battery_readout(),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        match app.pane() {
            Pane::Accuracy => app.accuracy_status(),
            _ => app.stability_status(),
        }
    }

    fn running(&self, app: &App) -> Vec<Job> {
        let stability = &app.stability;
        let running = [&app.accuracy.measuring, &stability.mapping, &stability.running];
        jobs("5:Numerics", running.map(|job| job.as_ref().map(|job| job.id)))
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        match report.slot {
            Slot::Accuracy => accuracy::keys::report(app, report.body),
            Slot::Map => stability::keys::report_map(app, report.body),
            _ => stability::keys::report_battery(app, report.body),
        }
        Vec::new()
    }

    fn table(&self, app: &App) -> Option<Table> {
        Some(match app.pane() {
            Pane::Accuracy => {
                let report = app.accuracy.report.as_ref()?;
                let found = Box::new((app.name_of(&report.scene), (**report).clone()));
                Table {
                    title: "Export the measurements to CSV",
                    file: format!("{}-accuracy.csv", ask::stem(app, &report.scene)),
                    content: Content::Accuracy(found),
                }
            }
            Pane::Battery => {
                let rows = app.stability.rows();
                let text = (!rows.is_empty()).then(|| stability_table::table(rows).csv())?;
                Table::text("Export the stiff scenes to CSV", "battery.csv".to_owned(), text)
            }
            _ => {
                let (scene, map) = app.stability.map.as_ref()?;
                let text = stability_table::map_table(&app.name_of(scene), map).csv();
                let file = format!("{}-map.csv", ask::stem(app, scene));
                Table::text("Export the map to CSV", file, text)
            }
        })
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        match app.pane() {
            Pane::Accuracy => accuracy::draw::render(app, body, canvas),
            Pane::StabilityMap => stability::draw::map(app, body, canvas),
            _ => stability::draw::battery(app, body, canvas),
        }
    }
}
