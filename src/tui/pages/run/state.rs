//! What the Run tab keeps.

use crate::report::series::Channel;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::pages::run::editor::Editor;

pub const VARIABLES: Pane = Pane::of(Tab::Run, 0);
pub const CHARTS: Pane = Pane::of(Tab::Run, 1);
pub const RUNS: Pane = Pane::of(Tab::Run, 2);

#[derive(Clone, Debug, Default)]
pub struct RunPage {
    pub editor: Editor,
    pub charts: Charts,
    /// The row selected in the table of runs: 0 is the current run.
    pub selected: usize,
    /// The pane that has the keys fills the body.
    pub is_full: bool,
}

/// Which part of the time is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// From first contact to a little after the last change of the depth.
    Contact,
    Whole,
}

#[derive(Clone, Debug)]
pub struct Charts {
    /// Their quantities, from top to bottom.
    pub quantities: [Channel; 3],
    /// Which part of the time each shows.
    pub windows: [Window; 3],
    /// The chart the keys act on.
    pub selected: usize,
    /// The crosshair, s since first contact.
    pub cursor_s: Option<f64>,
    /// The crosshair moves by itself.
    pub is_playing: bool,
    /// Number of the latest playing: the ticks of earlier ones are out of date.
    pub serial: u64,
}

impl Default for Charts {
    fn default() -> Self {
        Self {
            quantities: [Channel::Penetration, Channel::ContactForce, Channel::PlateDisplacement],
            windows: [Window::Contact, Window::Contact, Window::Whole],
            selected: 0,
            cursor_s: None,
            is_playing: false,
            serial: 0,
        }
    }
}
