//! The workbench: options, and the loop that everything passes through.
//!
//! The terminal, the worker, the I/O thread and signals send messages to one queue. The loop takes all waiting messages, lets `update`
//! change the state, starts the effects, and draws once. While idle it draws nothing, and checks the terminal four times a second. It does
//! not depend on drawing and keys.

pub mod app;
pub mod chart;
pub mod dialogs;
pub mod keymap;
pub mod message;
pub mod pages;
pub(crate) mod plain;
pub mod preset;
pub mod theme;
pub mod update;
pub mod view;
pub(crate) mod widgets;

mod backlog;
mod effects;
mod event_loop;
mod frame_scheduler;
mod input;
mod signals;
mod start;
mod terminal;

/// The common imports of pages, dialogs and updates.
mod prelude {
    pub(crate) use ratatui::layout::Rect;

    pub(crate) use super::app::App;
    pub(crate) use super::app::notice::{NO_RESULTS, Severity};
    pub(crate) use super::keymap::{Action, Pane, Tab, Target};
    pub(crate) use super::message::Effect;
    pub(crate) use super::theme::{PaneFrame, Role};
    pub(crate) use super::widgets::Canvas;
}

use std::io::{self, Write};

use crate::files::paths::Paths;
use crate::files::preset::Preset;
use cmra_studies::report::traces::Traces;
use event_loop::{EventLoop, ExitReason};

#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The scene to open; `None`: the last session, or the thesis baseline.
    pub scene: Option<Preset>,
    /// Traces to draw beside the runs.
    pub with: Option<Traces>,
    /// Leave the last session alone: start from the scene, or from the baseline.
    pub fresh: bool,
    /// The characters of charts; `None`: what the terminal can show.
    pub glyphs: Option<theme::GlyphSet>,
}

/// Run the workbench on the terminal of standard output until the person leaves. Returns the exit status: 0, or 128 + the
/// signal that ended it.
pub fn run(options: Options) -> io::Result<u8> {
    let paths = Paths::of_user().ok();
    terminal::hook::install(paths.as_ref().map(|paths| paths.state.clone()));
    let mut shell = EventLoop::start(options, paths)?;
    let ending = shell.run();
    if let Some(text) = shell.leave(&ending) {
        // The reader of standard error may be gone; the workbench is over either way.
        let _ = writeln!(io::stderr().lock(), "{text}");
    }
    match ending {
        ExitReason::Quit => Ok(0),
        ExitReason::Signal(status) => Ok(status),
        ExitReason::Broken(error) => Err(error),
    }
}
