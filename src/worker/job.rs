//! One job: containing its panic, measuring its time, and deciding when it says that it is still running.

use std::panic::{self, AssertUnwindSafe};
use std::time::{Duration, Instant};

use super::ReportBody;

/// A job that ends before this says only that it is done: no frame is spent on the news that it began.
const QUIET: Duration = Duration::from_millis(20);

/// Least time between two progress reports.
const BETWEEN_PROGRESS: Duration = Duration::from_millis(500);

/// A person waits for the curve of a job that runs for so long.
const SLOW: Duration = Duration::from_millis(200);

/// Least time between two curves, and how many times as long as one took to make.
const BETWEEN_PARTS: Duration = Duration::from_millis(500);
const PART_SHARE: u32 = 20;

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
    /// When the curve so far was asked for last, and how long the next one has to wait from then on.
    last_part: Instant,
    part_pause: Duration,
}

impl Pulse {
    /// The job starts now.
    pub(super) fn start() -> Self {
        let now = Instant::now();
        Self {
            steps: 0,
            started: now,
            seen: now,
            said_started: false,
            last_progress: now,
            last_part: now,
            part_pause: SLOW,
        }
    }

    /// Whether it is time, by the last look at the clock, for a person to see the curve so far; it then counts as asked for.
    pub(super) fn part_is_due(&mut self) -> bool {
        let is_due = self.seen.duration_since(self.last_part) >= self.part_pause;
        if is_due {
            (self.last_part, self.part_pause) = (self.seen, BETWEEN_PARTS);
        }
        is_due
    }

    /// The curve that was asked for has come: the run is not to spend more than a small part of its time on them.
    pub(super) fn part_came(&mut self) {
        self.part_pause = BETWEEN_PARTS.max(PART_SHARE * self.last_part.elapsed());
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
