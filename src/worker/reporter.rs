//! Reports of a running task: progress, parts and the answer. A task that is stopped keeps its results so far.

use std::any::Any;
use std::cell::Cell;
use std::error::Error;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::time::Duration;

use super::clock::Clock;
use super::studies::StudyResult;
use super::{JobProgress, ReportBody, Shared, Task};
use cmra_studies::study::context::{Answer, CancelFlag, Progress, Reach, Threads};

/// When a task shows what it has so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReportInterval {
    pub first: Duration,
    /// Least time between two parts.
    pub between: Duration,
}

/// Least time between two reports of progress.
pub(super) const BETWEEN: Duration = Duration::from_millis(500);

/// A running task, as its computation sees it.
pub(super) struct Reporter<'a> {
    /// Reports.
    pub(super) send: &'a dyn Fn(ReportBody),
    cancel: &'a CancelFlag,
    /// Threads to run on, where the work can be divided.
    pub(super) threads: Threads,
    budget: Option<Duration>,
    tempo: ReportInterval,
    clock: &'a Clock,
    started: Duration,
    /// How long the computation took, where that is not the time since the start.
    pub(super) elapsed: Cell<Option<Duration>>,
    /// When progress was reported last, and a part, counted from the start.
    last_progress: Cell<Duration>,
    shown: Cell<Option<Duration>>,
    /// Progress reported last, and whether the computation was told to stop.
    progress: Cell<Progress>,
    is_stopped: Cell<bool>,
}

impl<'a> Reporter<'a> {
    /// The task starts now.
    pub(super) fn new(
        shared: &'a Shared,
        task: &Task,
        send: &'a dyn Fn(ReportBody),
        cancel: &'a CancelFlag,
    ) -> Self {
        Self {
            send,
            cancel,
            threads: Threads::shared(task.threads, &shared.cores),
            budget: task.budget,
            tempo: task.request.tempo(),
            clock: &shared.clock,
            started: (shared.clock)(),
            elapsed: Cell::new(None),
            last_progress: Cell::new(Duration::ZERO),
            shown: Cell::new(None),
            progress: Cell::default(),
            is_stopped: Cell::default(),
        }
    }

    /// How long it has been running.
    pub(super) fn elapsed(&self) -> Duration {
        (self.clock)().saturating_sub(self.started)
    }

    /// The time it has been running, s, for all of its threads.
    pub(super) fn clock(&self) -> impl Fn() -> f64 + Sync + use<> {
        let (clock, started) = (Arc::clone(self.clock), self.started);
        move || clock().saturating_sub(started).as_secs_f64()
    }

    /// Returns `Break` once the task is cancelled or its time is used up.
    pub(super) fn check_cancelled(&self) -> ControlFlow<()> {
        let is_over = self.budget.is_some_and(|budget| self.elapsed() >= budget);
        if self.cancel.is_set() || is_over {
            self.is_stopped.set(true);
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    /// Report the progress and the results of now, unless the last report has just been made. Gives whether the study goes on.
    pub(super) fn report_progress(
        &self,
        progress: Progress,
        part: &dyn Fn() -> Option<StudyResult>,
    ) -> ControlFlow<()> {
        self.progress.set(progress);
        self.check_cancelled()?;
        let elapsed = self.elapsed();
        let since = |at: Duration| elapsed.saturating_sub(at);
        let is_due = match self.shown.get() {
            None => elapsed >= self.tempo.first,
            Some(at) => since(at) >= self.tempo.between,
        };
        let part = if is_due { part() } else { None };
        if part.is_some() || since(self.last_progress.get()) >= BETWEEN {
            self.last_progress.set(elapsed);
            let progress = JobProgress::Points(progress.done, progress.total);
            (self.send)(ReportBody::Progress { progress, elapsed });
        }
        if let Some(part) = part {
            self.shown.set(Some(elapsed));
            let reach = Reach::Partial(progress);
            (self.send)(ReportBody::Part(Answer { report: part, reach, elapsed }));
        }
        ControlFlow::Continue(())
    }

    /// Watches a study that has no parts.
    pub(super) fn progress(&self) -> impl FnMut(Progress, Option<&()>) -> ControlFlow<()> {
        |progress, _| self.report_progress(progress, &|| None)
    }

    /// Watches a study, and makes findings of its parts.
    pub(super) fn watch<P: ?Sized, T: Into<StudyResult>>(
        &self,
        part: impl Fn(&P) -> T,
    ) -> impl FnMut(Progress, Option<&P>) -> ControlFlow<()> {
        move |progress, so_far| {
            self.report_progress(progress, &|| so_far.map(|so_far| part(so_far).into()))
        }
    }

    /// Do the work; a panic becomes an error text.
    pub(super) fn finish(
        &self,
        work: impl FnOnce() -> Result<StudyResult, Box<dyn Error>>,
    ) -> ReportBody {
        let text = match panic::catch_unwind(AssertUnwindSafe(work)) {
            Ok(Ok(report)) => {
                let elapsed = self.elapsed.get().unwrap_or_else(|| self.elapsed());
                let reach = Reach::new(self.is_stopped.get(), self.progress.get());
                return ReportBody::Ended(Some(Answer { report, reach, elapsed }));
            }
            Ok(Err(error)) => error.to_string(),
            Err(payload) => format!(
                "internal error: {}; its state directory has the details (panic-*.txt), please report them",
                panic_text(payload.as_ref())
            ),
        };
        ReportBody::Failed(text)
    }
}

fn panic_text(payload: &(dyn Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("a panic without a text")
}
