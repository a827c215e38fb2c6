//! What the Run tab keeps.

use std::sync::Arc;

use crate::model::run::Run;
use crate::report::series::Channel;
use crate::report::traces::Traces;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::pages::run::editor::Editor;
use crate::tui::pages::run::matters::Matters;

pub const VARIABLES: Pane = Pane::of(Tab::Run, 0);
pub const CHARTS: Pane = Pane::of(Tab::Run, 1);
pub const RUNS: Pane = Pane::of(Tab::Run, 2);

#[derive(Clone, Debug, Default)]
pub struct RunPage {
    pub editor: Editor,
    pub charts: Charts,
    /// Bars of what matters, in the place of words.
    pub matters: Matters,
    /// Traces drawn beside the runs.
    pub beside: Option<Arc<Traces>>,
    /// Differences of the current run from these traces.
    pub differences: Differences,
    /// The row selected in the table of runs: 0 is the current run.
    pub selected: usize,
    /// The pane that has the keys fills the body.
    pub is_full: bool,
}

/// The greatest differences of a run from traces, by quantity: computed once for each pair.
#[derive(Clone, Debug, Default)]
pub struct Differences {
    pair: Option<(Arc<Run>, Arc<Traces>)>,
    greatest: Vec<(Channel, f64)>,
}

impl Differences {
    /// The greatest difference of a quantity; `None` without a trace of it.
    pub fn of(&self, channel: Channel) -> Option<f64> {
        self.greatest.iter().find(|one| one.0 == channel).map(|one| one.1)
    }

    /// Computes the differences where run or traces are others than before.
    pub(crate) fn follow(&mut self, run: Option<&Arc<Run>>, traces: Option<&Arc<Traces>>) {
        let Some((run, traces)) = run.zip(traces) else {
            *self = Self::default();
            return;
        };
        let is_same = |pair: &(Arc<Run>, Arc<Traces>)| {
            Arc::ptr_eq(&pair.0, run) && Arc::ptr_eq(&pair.1, traces)
        };
        if self.pair.as_ref().is_some_and(is_same) {
            return;
        }
        let greatest = |channel| Some((channel, traces.greatest(channel, run)?));
        self.greatest = Channel::ALL.into_iter().filter_map(greatest).collect();
        self.pair = Some((Arc::clone(run), Arc::clone(traces)));
    }
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
