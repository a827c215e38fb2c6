//! The Log tab: messages of this session, and all about the run on the screen.

pub(in crate::tui) mod draw;
pub mod state;

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, key};
use crate::tui::message::Effect;
use crate::tui::pages::{About, Page, Rows, StatusPart, Tab};
use crate::tui::widgets::Canvas;

/// The log.
pub const LOG: Pane = Pane::of(Tab::Log, 0);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: LOG, label: "Log", has: &[], keys: &[
        key(A::Down, "scroll", "scroll"),
        key(A::Find, "find", "show only the lines that contain a text"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Log)), "Log tab", "messages warnings events energy paths"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct LogTab;

impl Page for LogTab {
    fn about(&self) -> &'static About {
        &About { name: "Log", pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn act(&self, _app: &mut App, _action: Action) -> Option<Vec<Effect>> {
        None
    }

    fn readout(&self, _app: &App, _room: usize) -> Option<(Severity, String)> {
        None
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let shown = app.list_rows();
        let count = app.log_lines(usize::from(app.size.0)).len().saturating_sub(shown) + 1;
        Some(Rows { count, selected: app.log_scroll, shown })
    }

    fn select(&self, app: &mut App, row: usize) {
        app.log_scroll = row;
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        Some(&mut app.find.log)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}
