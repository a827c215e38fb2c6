//! State of the Limit tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use cmra_studies::study::compare::{self, map::Map as EfficiencyMap};
use cmra_studies::study::limit::LimitReport;
use cmra_studies::study::monte_carlo;

/// Mass efficiency over impact velocity and the plate's size, and its slices.
pub const EFFICIENCY_MAP: Pane = Pane::new(Tab::Limit, 0);
/// The candidates of equal areal mass.
pub const CANDIDATES: Pane = Pane::new(Tab::Limit, 1);
/// The residual velocity over the impact velocity, in the place of the map and the candidates.
pub const RESIDUAL: Pane = Pane::new(Tab::Limit, 2);

#[derive(Clone, Debug, Default)]
pub struct Ballistic {
    /// The limit with its curve of residual velocities.
    pub report: CachedResult<LimitReport>,
    /// V50 and its spread, once they were asked for.
    pub spread: CachedResult<monte_carlo::MonteCarloReport>,
    /// The comparison of the scene on the screen.
    pub own: CachedResult<compare::ComparisonReport>,
    /// The comparison of the design under the cursor.
    pub design: CachedResult<compare::ComparisonReport>,
    pub map: CachedResult<EfficiencyMap>,
    /// The point of the map under the cursor; `None`: the scene itself.
    pub cursor: Option<(usize, usize)>,
    /// The first line shown of the candidates.
    pub scrolled: usize,
    /// Where curve and words have no room together: the first line of the words shown, counted from 1, or 0 for the curve.
    pub word: usize,
}
