//! What the status lines say of the model's validity.

use crate::model::run::envelope::{self, Check};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::pages::StatusPart;

impl App {
    /// Which rules of the model's validity the scene does not keep, in full and short: by its run where that is there.
    pub(in crate::tui) fn validity_part(&self) -> Option<StatusPart> {
        let run = self.shown.as_ref().map(|shown| &shown.run).filter(|_| !self.is_stale());
        let found =
            run.map_or_else(|| envelope::of_scene(&self.scene), |run| envelope::of_run(run));
        // What the interface was asked for stands there already, with its number.
        let labels: Vec<&str> = found
            .iter()
            .filter(|breach| breach.check != Check::Interface)
            .map(|breach| breach.check.label())
            .collect();
        let long = format!("! outside validity: {} (7:Log)", labels.join(", "));
        let short = format!("! validity {}", labels.len());
        (!labels.is_empty()).then_some((Severity::Warning, long, short))
    }
}
