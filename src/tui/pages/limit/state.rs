//! What the Limit tab keeps.

use crate::study::compare::map::Map;
use crate::study::limit::{Report, Shot};
use crate::study::monte_carlo;
use crate::tui::app::running::{Kept, Running};
use crate::tui::keymap::{Pane, Tab};
use crate::worker::ReportBody;
use crate::worker::studies::Comparison;

/// The residual velocity over the impact velocity.
pub const RESIDUAL: Pane = Pane::of(Tab::Limit, 0);
/// The comparison at equal areal mass.
pub const COMPARISON: Pane = Pane::of(Tab::Limit, 1);
pub const EFFICIENCY_MAP: Pane = Pane::of(Tab::Limit, 2);

#[derive(Clone, Debug, Default)]
pub struct Ballistic {
    pub report: Kept<Report>,
    /// V50 and its spread, once they were asked for.
    pub spread: Kept<monte_carlo::Report>,
    /// The shot the crosshair stands on, by its place in the curve.
    pub cursor: Option<usize>,
    /// The comparison at equal areal mass.
    pub comparison: Kept<Comparison>,
    /// The first line shown of the comparison.
    pub scrolled: usize,
    /// The cell under the cursor of the map of mass efficiency; `None`: the scene's.
    pub map_cursor: Option<(usize, usize)>,
    /// Where curve and words have no room together: the page of words that is shown, 0 for the curve.
    pub page: usize,
}

impl Ballistic {
    /// Keep what was found; another curve has its shots elsewhere, and a map of another scene its axes.
    pub(crate) fn keep(&mut self, running: &Running, news: &ReportBody) {
        let (before, is_old) = (self.report.clone(), self.comparison.is_old(&running.scene));
        let shots = |kept: &Kept<Report>| kept.found.as_ref().map(|report| report.shots.clone());
        if self.report.keep(running, news, |report| report.is_complete)
            && shots(&before) != shots(&self.report)
        {
            self.cursor = None;
        }
        self.spread.keep(running, news, |spread| spread.is_complete);
        let is_whole =
            |it: &Comparison| it.report.is_complete && it.map.as_ref().is_none_or(Map::is_complete);
        if self.comparison.keep(running, news, is_whole) {
            self.map_cursor.take_if(|_| is_old);
        }
    }

    pub fn shots(&self) -> &[Shot] {
        self.report.found.as_ref().map_or(&[], |report| &report.shots)
    }

    pub fn shot(&self) -> Option<&Shot> {
        self.shots().get(self.cursor?)
    }

    /// The place of the shot the crosshair stands on; without one, of the first that goes through.
    pub fn shot_at(&self) -> usize {
        let first = || self.shots().iter().position(|shot| shot.residual_m_s.is_some());
        self.cursor.or_else(first).unwrap_or(0)
    }

    /// Move the crosshair by shots; its first move sets it on the first shot that goes through.
    pub fn move_cursor(&mut self, by: isize) {
        let Some(last) = self.shots().len().checked_sub(1) else { return };
        let by = if self.cursor.is_some() { by } else { 0 };
        self.cursor = Some(self.shot_at().saturating_add_signed(by).min(last));
    }
}
