//! State of the Thesis tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use cmra_studies::study::thesis::Row;

pub const CLAIMS: Pane = Pane::new(Tab::Thesis, 0);
pub const PRINCIPLES: Pane = Pane::new(Tab::Thesis, 1);
pub const CONCEPTS: Pane = Pane::new(Tab::Thesis, 2);
pub const MEASURED: Pane = Pane::new(Tab::Thesis, 3);

#[derive(Clone, Debug, Default)]
pub struct Thesis {
    pub report: CachedResult<Vec<Row>>,
    /// Selected row of Claims.
    pub selected: usize,
    /// Selected row of Principles.
    pub principle: usize,
}

impl Thesis {
    pub fn rows(&self) -> &[Row] {
        self.report.result.as_ref().map_or(&[], |report| report)
    }

    /// Returns the selected claim.
    pub fn claim(&self) -> Option<&Row> {
        self.rows().get(self.selected)
    }
}
