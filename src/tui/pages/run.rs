//! The Run tab: one impact, with its variables, its charts and the runs to compare with.

pub mod charts;
pub mod editor;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub(in crate::tui) mod mechanism;
pub mod quantity;
pub mod runs;
pub(in crate::tui) mod side;
pub mod steps;
pub mod summary;

use crossterm::event::KeyEvent;
use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart, jobs, note};
use crate::tui::update;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::worker::Report;

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Variables, Pane::Charts, Pane::Runs]
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Charts if app.charts.cursor_s.is_some() => note(Some(app.readout())),
            Pane::Variables => note(Some(app.variable_words(room))),
            _ => None,
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn running(&self, app: &App) -> Vec<Job> {
        let current = app.jobs.current.as_ref().map(|job| job.id);
        let pins = app.pins.iter().map(|pin| pin.job);
        jobs("1:Run", std::iter::once(current).chain(pins))
    }

    fn report(&self, app: &mut App, report: Report) -> Vec<Effect> {
        update::jobs::report(app, report)
    }

    fn field<'a>(&self, app: &'a App) -> Option<&'a TextField> {
        let field = app.editor.field.as_ref().filter(|_| app.pane() == Pane::Variables);
        field.map(|field| &field.text)
    }

    fn field_mut<'a>(&self, app: &'a mut App) -> Option<&'a mut TextField> {
        let has_keys = app.pane() == Pane::Variables;
        app.editor.field.as_mut().filter(|_| has_keys).map(|field| &mut field.text)
    }

    fn press(&self, app: &mut App, key: KeyEvent) -> Vec<Effect> {
        editor::field::press(app, key)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.variables {
            editor::draw::render(app, area, app.has_focus(Pane::Variables), canvas);
        }
        charts::draw::render(app, &panes.charts, app.has_focus(Pane::Charts), canvas);
        if let Some(area) = panes.runs {
            runs::draw::render(app, area, app.has_focus(Pane::Runs), canvas);
        }
        if let Some(area) = panes.events {
            side::events(app, area, canvas);
        }
        if let Some(area) = panes.mechanism {
            mechanism::render(app, area, canvas);
        }
        if let Some(area) = panes.ledger {
            side::ledger(app, area, canvas);
        }
    }
}
