//! State of the Limit tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use crate::worker::studies::Comparison;
use cmra_studies::study::limit::LimitReport;
use cmra_studies::study::monte_carlo;

/// The residual velocity over the impact velocity.
pub const RESIDUAL: Pane = Pane::new(Tab::Limit, 0);
/// The comparison at equal areal mass.
pub const COMPARISON: Pane = Pane::new(Tab::Limit, 1);
pub const EFFICIENCY_MAP: Pane = Pane::new(Tab::Limit, 2);

#[derive(Clone, Debug, Default)]
pub struct Ballistic {
    pub report: CachedResult<LimitReport>,
    /// V50 and its spread, once they were asked for.
    pub spread: CachedResult<monte_carlo::MonteCarloReport>,
    /// The comparison at equal areal mass.
    pub comparison: CachedResult<Comparison>,
    /// The first line shown of the comparison.
    pub scrolled: usize,
    /// Where curve and words have no room together: the first line of the words shown, counted from 1, or 0 for the curve.
    pub word: usize,
}
