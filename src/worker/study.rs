//! Studies: work of seconds on threads of its own, so that the run of an edited scene never waits. A study that is cancelled keeps
//! its results so far.

use std::any::Any;
use std::cell::Cell;
use std::error::Error;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::time::Duration;

use super::clock::Clock;
use super::studies::Found;
use super::{JobProgress, ReportBody, Shared, Task};
use crate::study::context::{CancelFlag, Progress};

/// A thread that does one task at a time. Half a minute of measurements or of stiff scenes must not keep a limit waiting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    Runs,
    Sweeps,
    /// Studies of half a minute.
    Studies,
    /// Studies of seconds.
    Searches,
}

impl Lane {
    /// All of them, with the names of their threads.
    pub(super) const ALL: [(Self, &str); 4] = [
        (Self::Runs, "runs"),
        (Self::Sweeps, "sweeps"),
        (Self::Studies, "studies"),
        (Self::Searches, "searches"),
    ];
}

/// When a task shows what it has so far.
#[derive(Clone, Copy, Debug)]
pub struct Tempo {
    pub first: Duration,
    /// Least time between two parts.
    pub between: Duration,
}

/// Rows of a study, all or those computed so far.
#[derive(Clone, Debug)]
pub struct RowsSoFar<R> {
    pub rows: Vec<R>,
    pub is_complete: bool,
}

impl<R: Clone> RowsSoFar<R> {
    pub fn part(rows: &[R]) -> Self {
        Self { rows: rows.to_vec(), is_complete: false }
    }

    pub fn ended(rows: Vec<R>, count: usize) -> Self {
        Self { is_complete: rows.len() == count, rows }
    }
}

/// Least time between two reports of progress.
pub(super) const BETWEEN: Duration = Duration::from_millis(500);

/// A running task, as its computation sees it.
pub struct Reporter<'a> {
    /// Reports.
    pub(super) send: &'a dyn Fn(ReportBody),
    cancel: &'a CancelFlag,
    /// Threads to run on, where the work can be divided.
    pub(super) threads: usize,
    tempo: Tempo,
    clock: &'a Clock,
    started: Duration,
    /// How long the computation took, where that is not the time since the start.
    pub(super) took: Cell<Option<Duration>>,
    /// When progress was reported last, and a part, counted from the start.
    told: Cell<Duration>,
    shown: Cell<Option<Duration>>,
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
            threads: task.threads,
            tempo: task.asked.tempo(),
            clock: &shared.clock,
            started: (shared.clock)(),
            took: Cell::new(None),
            told: Cell::new(Duration::ZERO),
            shown: Cell::new(None),
        }
    }

    /// How long it has been running.
    pub(super) fn elapsed(&self) -> Duration {
        (self.clock)().saturating_sub(self.started)
    }

    /// The time it has been running, s, for all of its threads.
    pub fn clock(&self) -> impl Fn() -> f64 + Sync + use<> {
        let (clock, started) = (Arc::clone(self.clock), self.started);
        move || clock().saturating_sub(started).as_secs_f64()
    }

    pub(super) fn goes_on(&self) -> ControlFlow<()> {
        self.cancel.flow()
    }

    /// Report the progress and the results of now, unless the last report has just been made. Gives whether the study goes on.
    pub fn tell(&self, progress: Progress, part: &dyn Fn() -> Option<Found>) -> ControlFlow<()> {
        self.goes_on()?;
        let elapsed = self.elapsed();
        let since = |at: Duration| elapsed.saturating_sub(at);
        let is_due = match self.shown.get() {
            None => elapsed >= self.tempo.first,
            Some(at) => since(at) >= self.tempo.between,
        };
        let part = if is_due { part() } else { None };
        if part.is_some() || since(self.told.get()) >= BETWEEN {
            self.told.set(elapsed);
            let progress = JobProgress::Points(progress.done, progress.total);
            (self.send)(ReportBody::Progress { progress, elapsed });
        }
        if let Some(part) = part {
            self.shown.set(Some(elapsed));
            (self.send)(ReportBody::Part(part));
        }
        ControlFlow::Continue(())
    }

    /// Watches a study that has no parts.
    pub fn progress(&self) -> impl FnMut(Progress, Option<&()>) -> ControlFlow<()> {
        |progress, _| self.tell(progress, &|| None)
    }

    /// Watches a study, and makes findings of its parts.
    pub fn watch<P: ?Sized, T: Into<Found>>(
        &self,
        part: impl Fn(&P) -> T,
    ) -> impl FnMut(Progress, Option<&P>) -> ControlFlow<()> {
        move |progress, so_far| self.tell(progress, &|| so_far.map(|so_far| part(so_far).into()))
    }

    /// Do the work; a panic becomes an error text.
    pub(super) fn finish(
        &self,
        work: impl FnOnce() -> Result<Found, Box<dyn Error>>,
    ) -> ReportBody {
        let text = match panic::catch_unwind(AssertUnwindSafe(work)) {
            Ok(Ok(found)) => {
                let took = self.took.get().unwrap_or_else(|| self.elapsed());
                return ReportBody::Ended { found: Some(found), took };
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
