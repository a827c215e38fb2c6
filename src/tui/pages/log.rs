//! The Log tab: messages of this session, and all about the run on the screen.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub mod state;

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::{Job, Page, StatusPart};
use crate::tui::widgets::Canvas;

/// What the workbench asks of this tab.
pub(in crate::tui) struct Tab;

impl Page for Tab {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Log]
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, _app: &App, _room: usize) -> Option<(Severity, String)> {
        None
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn running(&self, _app: &App) -> Vec<Job> {
        Vec::new()
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}
