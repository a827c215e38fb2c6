//! What a running task reports: at most so often, and never after it was cancelled.

use std::any::Any;
use std::cell::Cell;
use std::error::Error;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::quiet::Quiet;
use super::study::{Study, Tempo};
use super::{Finding, Progress, ReportBody};
use crate::study::context as study;

/// Least time between two reports of progress.
pub(super) const BETWEEN: Duration = Duration::from_millis(500);

/// A running task, as its computation sees it.
pub struct Reporter<'a> {
    send: &'a dyn Fn(ReportBody),
    cancel: &'a Arc<AtomicBool>,
    threads: usize,
    tempo: Tempo,
    /// Where run times are measured: between two points others have their turn.
    measured: Option<&'a Quiet>,
    started: Instant,
    /// When progress was reported last, and a part, counted from the start.
    told: Cell<Duration>,
    shown: Cell<Option<Duration>>,
}

impl<'a> Reporter<'a> {
    /// The task starts now.
    pub(super) fn new(
        send: &'a dyn Fn(ReportBody),
        cancel: &'a Arc<AtomicBool>,
        threads: usize,
    ) -> Self {
        Self {
            send,
            cancel,
            threads,
            tempo: Tempo { first: BETWEEN, between: BETWEEN },
            measured: None,
            started: Instant::now(),
            told: Cell::new(Duration::ZERO),
            shown: Cell::new(None),
        }
    }

    /// The same for a study.
    pub(super) fn of(self, study: &dyn Study, quiet: &'a Quiet) -> Self {
        let measured = study.measures().then_some(quiet);
        Self { tempo: study.tempo(), measured, ..self }
    }

    /// Threads to run on, where the work can be divided.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// How long it has been running.
    pub(super) fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }

    /// The time it has been running, s, for all of its threads.
    pub fn clock(&self) -> impl Fn() -> f64 + Sync + use<> {
        let started = self.started;
        move || started.elapsed().as_secs_f64()
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
        (self.send)(body);
    }

    /// Report how far it is and what there is so far, where the last report is long enough ago; whether to go on.
    pub fn tell(
        &self,
        progress: study::Progress,
        part: &dyn Fn() -> Option<Finding>,
    ) -> ControlFlow<()> {
        if let Some(quiet) = self.measured {
            quiet.end();
            quiet.begin(self.cancel);
        }
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
            let progress = Progress::Points(progress.done, progress.total);
            self.report(ReportBody::Progress { progress, elapsed });
        }
        if let Some(part) = part {
            self.shown.set(Some(elapsed));
            self.report(ReportBody::Part(part));
        }
        ControlFlow::Continue(())
    }

    /// Watches a study that has no parts.
    pub fn progress(&self) -> impl FnMut(study::Progress, Option<&()>) -> ControlFlow<()> {
        |progress, _| self.tell(progress, &|| None)
    }

    /// Watches a study, and makes findings of its parts.
    pub fn watch<P: ?Sized, T: Any + Send + Sync>(
        &self,
        part: impl Fn(&P) -> T,
    ) -> impl FnMut(study::Progress, Option<&P>) -> ControlFlow<()> {
        move |progress, so_far| {
            self.tell(progress, &|| so_far.map(|so_far| Finding::new(part(so_far))))
        }
    }

    /// Do the work; a panic becomes an error text.
    pub(super) fn finish(
        &self,
        work: impl FnOnce() -> Result<Finding, Box<dyn Error>>,
    ) -> ReportBody {
        let text = match panic::catch_unwind(AssertUnwindSafe(work)) {
            Ok(Ok(found)) => {
                return ReportBody::Ended { found: Some(found), took: self.elapsed() };
            }
            Ok(Err(error)) => error.to_string(),
            Err(payload) => format!(
                "internal error: {}; the log has the details, please report it",
                panic_text(payload.as_ref())
            ),
        };
        ReportBody::Failed(text)
    }
}

/// The text of a panic.
fn panic_text(payload: &(dyn Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("a panic without a text")
}
