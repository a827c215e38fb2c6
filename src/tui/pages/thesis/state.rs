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
    /// Filter text of the claims.
    pub find: String,
    /// Selected row of Claims, among the displayed ones.
    pub selected: usize,
    /// Selected row of Principles.
    pub principle: usize,
}

impl Thesis {
    pub fn rows(&self) -> &[Row] {
        self.report.result.as_ref().map_or(&[], |report| report)
    }
}
