//! State of the Limit tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use cmra_studies::study::compare::{self, map::Map as EfficiencyMap};
use cmra_studies::study::limit::LimitReport;
use cmra_studies::study::monte_carlo;

/// Pane of the mass efficiency over impact velocity and the plate's size, and of its slices.
pub const EFFICIENCY_MAP: Pane = Pane::new(Tab::Limit, 0);
/// Pane of the candidates with equal areal mass.
pub const CANDIDATES: Pane = Pane::new(Tab::Limit, 1);
/// Pane of the residual over the impact velocity, in place of the map and the candidates.
pub const RESIDUAL: Pane = Pane::new(Tab::Limit, 2);

#[derive(Clone, Debug, Default)]
pub struct Ballistic {
    /// Limit with its residual-velocity curve.
    pub report: CachedResult<LimitReport>,
    /// V50 and its spread, once requested.
    pub spread: CachedResult<monte_carlo::MonteCarloReport>,
    /// Comparison of the current scene.
    pub own: CachedResult<compare::ComparisonReport>,
    /// Comparison of the design under the cursor.
    pub design: CachedResult<compare::ComparisonReport>,
    pub map: CachedResult<EfficiencyMap>,
    /// Point of the map under the cursor; `None` for the scene itself.
    pub cursor: Option<(usize, usize)>,
    /// First visible line of the candidates.
    pub scrolled: usize,
}
