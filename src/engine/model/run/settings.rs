//! Settings of a run: what it keeps besides its results, and how much it may compute.

use crate::model::scene::RunSettings;

/// Optional output of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Whether to keep the time series.
    pub series: bool,
    /// Interval of the rows, s, > 0; by default rows are at the steps of the solver. At most [`EVERY_ROWS_MAX`] rows.
    pub every_s: Option<f64>,
    /// Whether to compute the error estimate (from a closed form or a second computation).
    pub estimate: bool,
    /// Work after which a run ends undecided, as [`Cost::work`](super::Cost::work) counts it; `None` for [`WORK_MAX`], and more at a tight tolerance.
    pub work_max: Option<usize>,
}

impl Settings {
    /// Results only.
    pub const BARE: Self = Self { series: false, every_s: None, estimate: false, work_max: None };
    /// Results and time series.
    pub const SERIES: Self = Self { series: true, ..Self::BARE };

    /// Returns the evaluation budget for a tolerance: half as much again below the default one, for smaller steps and more resolved events.
    pub(in crate::model) fn most_work(&self, tolerance: f64) -> usize {
        let is_tight = tolerance < RunSettings::default().tolerance;
        self.work_max.unwrap_or(if is_tight { WORK_MAX / 2 * 3 } else { WORK_MAX })
    }
}

/// Work after which a run ends undecided at the default tolerance, as [`Cost::work`](super::Cost::work) counts it: about 0.1 s, at 0.05 us each.
pub const WORK_MAX: usize = 2_200_000;

/// Maximum number of rows at equal intervals; they take about half a gigabyte.
pub const EVERY_ROWS_MAX: usize = 5_000_000;

impl Default for Settings {
    fn default() -> Self {
        Self { estimate: true, ..Self::SERIES }
    }
}
