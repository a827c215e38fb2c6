//! Sweeps on the screen: coarse pictures come first, and what is finished is kept.

use std::cell::Cell;
use std::sync::Arc;
use std::time::Duration;

use super::reporter::{BETWEEN, Reporter};
use super::{Finding, Progress, ReportBody};
use crate::study::sweep::Plan;
use crate::study::sweep::crew::Crew;
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
    let (pictured, told) = (Cell::new(None), Cell::new(Duration::ZERO));
    let mut watch = |grid: &Grid, finished: bool| {
        let elapsed = reporter.elapsed();
        let since = |at: Duration| elapsed.saturating_sub(at);
        let due = pictured.get().is_none_or(|at| since(at) >= BETWEEN_PASSES);
        let shows = finished && due && elapsed >= QUIET && !grid.is_complete();
        if shows || since(told.get()) >= BETWEEN {
            told.set(elapsed);
            let (done, total) = grid.progress();
            let progress = Progress::Points(done, total);
            reporter.report(ReportBody::Progress { progress, elapsed });
        }
        if shows {
            pictured.set(Some(elapsed));
            reporter.report(ReportBody::Part(Finding::Grid(Arc::new(grid.clone()))));
        }
        reporter.goes_on()
    };
    let crew = Crew { threads, ..Crew::of_machine() };
    reporter.finish(|| Ok(Finding::Grid(Arc::new(grid.fill(crew, reporter.cancel(), &mut watch)))))
}
