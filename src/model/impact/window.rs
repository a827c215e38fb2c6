//! A window into a run that goes on: its own rows so far, for whoever watches. Nobody who does not ask pays for it.

use std::cell::{Cell, RefCell};

use crate::model::run::Run;

/// Asked for by the observer, filled by the run at its next step.
#[derive(Debug, Default)]
pub struct Window {
    wanted: Cell<bool>,
    run: RefCell<Option<Run>>,
}

impl Window {
    /// Ask for the run so far.
    pub fn ask(&self) {
        self.wanted.set(true);
    }

    /// What was put in since it was asked for: the run as if it had been cancelled there, or whole but for its error estimate.
    pub fn take(&self) -> Option<Run> {
        self.run.take()
    }

    /// Put in the run so far, if somebody has asked.
    pub(super) fn show(&self, so_far: impl FnOnce() -> Run) {
        if self.wanted.replace(false) {
            self.run.replace(Some(so_far()));
        }
    }
}
