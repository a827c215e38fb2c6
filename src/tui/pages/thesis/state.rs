//! State of the Thesis tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use cmra_studies::study::thesis::{self, Row};

pub const CLAIMS: Pane = Pane::new(Tab::Thesis, 0);
pub const PRINCIPLES: Pane = Pane::new(Tab::Thesis, 1);
pub const CONCEPTS: Pane = Pane::new(Tab::Thesis, 2);
pub const MEASURED: Pane = Pane::new(Tab::Thesis, 3);

#[derive(Clone, Debug)]
pub struct Thesis {
    pub report: CachedResult<Vec<Row>>,
    /// Selected row of Claims.
    pub selected: usize,
    /// Selected row of Principles.
    pub principle: usize,
}

impl Default for Thesis {
    /// Selects the first claim that a preset shows; the claims before it are counts of tables.
    fn default() -> Self {
        let first = thesis::claims().position(|claim| claim.preset.is_some());
        Self { report: CachedResult::default(), selected: first.unwrap_or(0), principle: 0 }
    }
}

impl Thesis {
    pub fn rows(&self) -> &[Row] {
        self.report.result.as_ref().map_or(&[], |report| report)
    }

    /// Returns the selected claim.
    pub fn claim(&self) -> Option<&Row> {
        self.rows().get(self.selected_row())
    }

    /// Returns the index of the selected claim; the last one of fewer checked claims.
    pub fn selected_row(&self) -> usize {
        self.selected.min(self.rows().len().saturating_sub(1))
    }
}
