//! Reports of a running task: progress, partial results and the final result. A cancelled task ends with its partial result.

use std::any::Any;
use std::cell::Cell;
use std::error::Error;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::time::Duration;

use super::clock::Clocks;
use super::studies::StudyResult;
use super::{JobProgress, ReportBody, Shared, Task};
use cmra_studies::study::context::{Answer, CancelFlag, Progress, Reach, Threads, WorkClock};

/// Minimum intervals between the partial results of a task.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReportInterval {
    pub first: Duration,
    /// Minimum interval between two partial results.
    pub between: Duration,
}

/// Minimum interval between two reports of progress; short enough to show that the task runs.
pub(super) const BETWEEN: Duration = Duration::from_millis(500);

/// Interface of a computation to the worker: cancel flag, time limit, progress and partial results.
pub(super) struct Reporter<'a> {
    /// Callback for reports of this task.
    pub(super) send: &'a dyn Fn(ReportBody),
    cancel: &'a CancelFlag,
    /// Threads, for work that can be divided.
    pub(super) threads: Threads,
    budget: Option<Duration>,
    tempo: ReportInterval,
    clocks: &'a Clocks,
    started: Duration,
    /// Processor time of this thread at the start, and that of the pieces on other threads.
    thread_started: Duration,
    work: Arc<WorkClock>,
    /// Duration of the computation, if it differs from the time since the start.
    pub(super) elapsed: Cell<Option<Duration>>,
    /// Time of the last progress report, since the start.
    last_progress: Cell<Duration>,
    /// Time of the last partial result, since the start.
    shown: Cell<Option<Duration>>,
    /// Last progress reported.
    progress: Cell<Progress>,
    /// Whether the computation was stopped.
    is_stopped: Cell<bool>,
}

impl<'a> Reporter<'a> {
    /// Creates the interface of a task that starts now.
    pub(super) fn new(
        shared: &'a Shared,
        task: &Task,
        send: &'a dyn Fn(ReportBody),
        cancel: &'a CancelFlag,
    ) -> Self {
        let clocks = &shared.clocks;
        let work = WorkClock::new(Arc::clone(&clocks.thread), Arc::clone(&clocks.process));
        Self {
            send,
            cancel,
            threads: Threads::shared(task.threads, &shared.cores).timed(&work),
            budget: task.budget,
            tempo: task.request.tempo(),
            clocks,
            started: (clocks.wall)(),
            thread_started: (clocks.thread)(),
            work,
            elapsed: Cell::new(None),
            last_progress: Cell::new(Duration::ZERO),
            shown: Cell::new(None),
            progress: Cell::default(),
            is_stopped: Cell::default(),
        }
    }

    /// Returns the time since the start.
    pub(super) fn elapsed(&self) -> Duration {
        (self.clocks.wall)().saturating_sub(self.started)
    }

    /// Returns a clock for the threads of the task: the time since its start, s.
    pub(super) fn clock(&self) -> impl Fn() -> f64 + Sync + use<> {
        let (clock, started) = (Arc::clone(&self.clocks.wall), self.started);
        move || clock().saturating_sub(started).as_secs_f64()
    }

    /// Returns the processor time since the start, of this thread and of the pieces on other threads. Other work of the machine does not
    /// increase it.
    fn processor_time(&self) -> Duration {
        (self.clocks.thread)().saturating_sub(self.thread_started) + self.work.spent()
    }

    /// Returns `Break` if the task is cancelled or its time limit is reached.
    pub(super) fn check_cancelled(&self) -> ControlFlow<()> {
        let is_over = self.budget.is_some_and(|budget| self.processor_time() >= budget);
        if self.cancel.is_set() || is_over {
            self.is_stopped.set(true);
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    /// Reports progress and the partial result, at most once per interval; returns `Break` if the study has to stop.
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

    /// Returns the progress callback of a study without partial results.
    pub(super) fn progress(&self) -> impl FnMut(Progress, Option<&()>) -> ControlFlow<()> {
        |progress, _| self.report_progress(progress, &|| None)
    }

    /// Returns the progress callback of a study, which converts its partial results.
    pub(super) fn watch<P: ?Sized, T: Into<StudyResult>>(
        &self,
        part: impl Fn(&P) -> T,
    ) -> impl FnMut(Progress, Option<&P>) -> ControlFlow<()> {
        move |progress, so_far| {
            self.report_progress(progress, &|| so_far.map(|so_far| part(so_far).into()))
        }
    }

    /// Runs the computation and returns its final report; a panic becomes an error message.
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
