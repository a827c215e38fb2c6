//! What a running task reports: at most so often, and never after it was cancelled.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::{Finding, Progress, ReportBody};
use crate::study::context as study;

/// Least time between two reports of a task.
pub(super) const BETWEEN: Duration = Duration::from_millis(500);

/// A running task, as its computation sees it.
pub(super) struct Reporter<'a> {
    send: &'a dyn Fn(ReportBody),
    cancel: &'a Arc<AtomicBool>,
    started: Instant,
    last: Cell<Instant>,
    between: Duration,
}

impl<'a> Reporter<'a> {
    /// The task starts now.
    pub(super) fn new(send: &'a dyn Fn(ReportBody), cancel: &'a Arc<AtomicBool>) -> Self {
        let started = Instant::now();
        Self { send, cancel, started, last: Cell::new(started), between: BETWEEN }
    }

    /// The same with a report at every occasion.
    #[cfg(test)]
    pub(super) fn eager(send: &'a dyn Fn(ReportBody), cancel: &'a Arc<AtomicBool>) -> Self {
        Self { between: Duration::ZERO, ..Self::new(send, cancel) }
    }

    /// How long it has been running.
    pub(super) fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }

    /// The flag that cancels it.
    pub(super) fn cancel(&self) -> &'a Arc<AtomicBool> {
        self.cancel
    }

    /// Whether to go on.
    pub(super) fn goes_on(&self) -> ControlFlow<()> {
        if self.cancel.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Report this, whenever.
    pub(super) fn report(&self, body: ReportBody) {
        self.last.set(Instant::now());
        (self.send)(body);
    }

    /// Report how far it is and what there is so far, where the last report is long enough ago; whether to go on.
    pub(super) fn tell(
        &self,
        done: usize,
        total: usize,
        part: &dyn Fn() -> Option<Finding>,
    ) -> ControlFlow<()> {
        self.goes_on()?;
        if self.last.get().elapsed() >= self.between {
            let progress = Progress::Points(done, total);
            self.report(ReportBody::Progress { progress, elapsed: self.elapsed() });
            if let Some(part) = part() {
                self.report(ReportBody::Part(part));
            }
        }
        ControlFlow::Continue(())
    }

    /// Watches a study, and makes findings of its parts.
    pub(super) fn watch<P: ?Sized>(
        &self,
        part: impl Fn(&P) -> Finding,
    ) -> impl FnMut(study::Progress, Option<&P>) -> ControlFlow<()> {
        move |progress, so_far| self.tell(progress.done, progress.total, &|| so_far.map(&part))
    }

    /// Do the work; a panic becomes an error text.
    pub(super) fn finish(&self, work: impl FnOnce() -> Result<Finding, String>) -> ReportBody {
        let caught = panic::catch_unwind(AssertUnwindSafe(work));
        let took = self.elapsed();
        let ended = caught.unwrap_or_else(|payload| {
            Err(format!(
                "internal error: {}; the log has the details, please report it",
                panic_text(payload.as_ref())
            ))
        });
        match ended {
            Ok(found) => ReportBody::Ended { found: Some(found), took },
            Err(text) => ReportBody::Failed(text),
        }
    }
}

/// The text of a panic.
fn panic_text(payload: &(dyn std::any::Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("a panic without a text")
}
