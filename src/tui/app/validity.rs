//! The rules of the model's validity that the scene on the screen does not keep.

use crate::model::run::envelope::{self, Breach, Check};
use crate::tui::app::notice::{StatusPart, outside};
use crate::tui::prelude::*;

impl App {
    /// The rules of the model's validity that the scene does not keep: by its run where that is there, with every plate struck.
    pub(crate) fn breaches(&self) -> Vec<Breach> {
        let run = self.shown.as_ref().map(|shown| &shown.run).filter(|_| !self.shows_old());
        run.map_or_else(|| envelope::of_scene(&self.scene), |run| envelope::of_run(run))
    }

    /// The same for the status row.
    pub(crate) fn validity_part(&self) -> Option<StatusPart> {
        let found = self.breaches();
        // The status row of a run has the load of the interface already, with its number.
        let of_run = matches!(self.tab, Tab::Run | Tab::Log);
        let is_shown = |check: &Check| *check == Check::Interface && of_run;
        let checks = found.iter().map(|breach| breach.check);
        outside(checks.filter(|check| !is_shown(check)), "")
    }
}
