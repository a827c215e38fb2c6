//! One job: containing its panic, measuring its time, and deciding when it says that it is still running.

use std::panic::{self, AssertUnwindSafe};
use std::time::{Duration, Instant};

use super::ReportBody;

/// A job that ends before this says only that it is done: no frame is spent on the news that it began.
const QUIET: Duration = Duration::from_millis(20);

/// Least time between two progress reports.
const BETWEEN_PROGRESS: Duration = Duration::from_millis(500);

/// Steps between two looks at the clock (a look costs about as much as a tenth of a step).
const STEPS_PER_LOOK: u32 = 8;

/// When a running job speaks.
pub(super) struct Pulse {
    steps: u32,
    started: Instant,
    /// The last look at the clock.
    seen: Instant,
    said_started: bool,
    last_progress: Instant,
}

impl Pulse {
    /// The job starts now.
    pub(super) fn start() -> Self {
        let now = Instant::now();
        Self { steps: 0, started: now, seen: now, said_started: false, last_progress: now }
    }

    /// Whether it has been running for so long that a person waits for its curve.
    pub(super) fn is_slow(&self) -> bool {
        self.seen.duration_since(self.started) >= super::preview::SLOW
    }

    /// After a step that reached `t_s`: what to report, if anything.
    pub(super) fn beat(&mut self, t_s: f64) -> Option<ReportBody> {
        self.steps = self.steps.wrapping_add(1);
        if !self.steps.is_multiple_of(STEPS_PER_LOOK) {
            return None;
        }
        let now = Instant::now();
        self.seen = now;
        if !self.said_started {
            if now.duration_since(self.started) < QUIET {
                return None;
            }
            self.said_started = true;
            return Some(ReportBody::Started);
        }
        if now.duration_since(self.last_progress) < BETWEEN_PROGRESS {
            return None;
        }
        self.last_progress = now;
        Some(ReportBody::Progress { t_s, elapsed: now.duration_since(self.started) })
    }
}

/// Run `work`, turn a panic into an error text, and measure how long it took.
pub(super) fn contained<T>(
    work: impl FnOnce() -> Result<T, String>,
) -> (Result<T, String>, Duration) {
    let started = Instant::now();
    let caught = panic::catch_unwind(AssertUnwindSafe(work));
    let took = started.elapsed();
    let ended = caught.unwrap_or_else(|payload| {
        Err(format!(
            "internal error: {}; the log has the details, please report it",
            panic_text(payload.as_ref())
        ))
    });
    (ended, took)
}

/// What a panic said.
fn panic_text(payload: &(dyn std::any::Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("a panic without a text")
}
