//! Sweeps on the screen: coarse pictures come first, and what is finished is kept.

use std::sync::Arc;
use std::time::Duration;

use super::reporter::{BETWEEN, Reporter};
use super::{Finding, Progress, ReportBody};
use crate::study::context::{self as study, Context};
use crate::study::sweep::Plan;
use crate::study::sweep::grid::{self, Grid};

/// A sweep that ends before this shows nothing on the way: no picture is drawn twice for it.
const QUIET: Duration = Duration::from_millis(25);
/// Least time between two pictures of passes.
const BETWEEN_PASSES: Duration = Duration::from_millis(120);

/// Compute the grid of a plan.
pub(super) fn fill(plan: &Arc<Plan>, threads: usize, reporter: &Reporter<'_>) -> ReportBody {
    if let Err(error) = grid::fits(plan) {
        return ReportBody::Failed(error.to_string());
    }
    let Some(grid) = Grid::new(Arc::clone(plan)) else {
        return ReportBody::Failed("a picture has one axis or two: take fewer axes".to_owned());
    };
    let (mut pictured, mut told) = (None, Duration::ZERO);
    let watch = &mut |study::Progress { done, total }, pass: Option<&Grid>| {
        let elapsed = reporter.elapsed();
        let since = |at: Duration| elapsed.saturating_sub(at);
        let due = elapsed >= QUIET && pictured.is_none_or(|at| since(at) >= BETWEEN_PASSES);
        let shown = pass.filter(|grid| due && !grid.is_complete());
        if shown.is_some() || since(told) >= BETWEEN {
            told = elapsed;
            let progress = Progress::Points(done, total);
            reporter.report(ReportBody::Progress { progress, elapsed });
        }
        if let Some(grid) = shown {
            pictured = Some(elapsed);
            reporter.report(ReportBody::Part(Finding::Grid(Arc::new(grid.clone()))));
        }
        reporter.goes_on()
    };
    let context = &mut Context::new(threads, watch);
    reporter.finish(|| Ok(Finding::Grid(Arc::new(grid.fill(grid::PIECE, context)))))
}
