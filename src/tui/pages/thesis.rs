//! The Thesis tab: its claims, its principles, its screening matrix.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub mod state;

use ratatui::layout::Rect;

use crate::report::thesis;
use crate::study::thesis::Row;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart, Table, jobs, note};
use crate::tui::widgets::Canvas;
use crate::worker::Report;

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

/// The panes of the Thesis tab, page by page.
const PAGES: [&[Pane]; 3] = [&[Pane::Claims], &[Pane::Principles], &[Pane::Screening]];

impl Page for Tab {
    fn panes(&self, app: &App) -> &'static [Pane] {
        PAGES[self.shown(app)]
    }

    fn names(&self) -> &'static [&'static str] {
        &["Claims", "Principles", "Screening"]
    }

    fn shown(&self, app: &App) -> usize {
        PAGES.iter().position(|panes| panes.contains(&app.pane())).unwrap_or(0)
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        app.focus_on(PAGES[page.min(PAGES.len() - 1)][0]);
        self.enter(app)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        note(app.thesis_readout())
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.thesis_status()
    }

    fn running(&self, app: &App) -> Vec<Job> {
        jobs("6:Thesis", [app.thesis.running.as_ref().map(|job| job.id)])
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        keys::report(app, report.body);
        Vec::new()
    }

    fn table(&self, app: &App) -> Option<Table> {
        let (file, text) = match app.pane() {
            Pane::Principles => ("principles.csv", thesis::principles().csv()),
            Pane::Screening => ("screening.csv", thesis::screening(&app.thesis.weights).csv()),
            _ => {
                // Of the claims those that are shown, as far as they are checked.
                let shown: Vec<Row> = app.claims().into_iter().cloned().collect();
                ("claims.csv", (!shown.is_empty()).then(|| thesis::claims(&shown).csv())?)
            }
        };
        Some(Table::text("Export this page to CSV", file.to_owned(), text))
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}
