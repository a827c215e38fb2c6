//! Progress of long computations, and interrupts.
//!
//! After half a second a line on standard error shows the progress, on a terminal only; the result replaces it. The first interrupt or
//! hang-up stops the computation and keeps the finished part. A second Ctrl-C, half a second later or more, ends the process.

use std::io::{self, IsTerminal as _};
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
use signal_hook::flag;
use signal_hook::iterator::Signals;

use crate::cli::output;
use crate::cli::sweep::page::duration;
use crate::worker::clock::{Clock, wall};
use cmra_engine::model::run::{EndReason, Run};
use cmra_studies::study::context::{CancelFlag, Context, Progress, Reach};

/// Flag set by the first interrupt; global, as signals are.
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Clock of the progress line; global, as the terminal is.
static CLOCK: OnceLock<Clock> = OnceLock::new();

/// Delay before the first progress line, and interval between updates.
const SHOWN_AFTER: Duration = Duration::from_millis(500);
const UPDATED_EVERY: Duration = Duration::from_millis(200);

/// Time within which further interrupts belong to the first one. Some programs send a signal twice, to the process and to its group; a
/// second Ctrl-C by hand comes later.
const SAME_REQUEST: Duration = Duration::from_millis(500);

/// Progress line on the terminal.
pub(super) struct ProgressLine {
    start: Duration,
    last_shown: Duration,
    shown: bool,
    wanted: bool,
    stop: CancelFlag,
}

impl ProgressLine {
    /// Starts the clock and the handling of interrupts.
    pub(super) fn begin() -> Self {
        let now = now();
        let dumb = std::env::var("TERM").is_ok_and(|term| term == "dumb");
        let wanted = io::stderr().is_terminal() && !dumb;
        Self { start: now, last_shown: now, shown: false, wanted, stop: interruptible() }
    }

    /// Updates the line if an update is due, with a text of the elapsed seconds; returns `Break` after an interrupt.
    pub(super) fn update(&mut self, text: impl FnOnce(f64) -> String) -> ControlFlow<()> {
        if self.wanted
            && self.elapsed() > SHOWN_AFTER
            && now().saturating_sub(self.last_shown) > UPDATED_EVERY
        {
            self.last_shown = now();
            self.shown = true;
            output::progress(&text(self.elapsed().as_secs_f64()));
        }
        self.stop.flow()
    }

    /// Returns the time since the start.
    fn elapsed(&self) -> Duration {
        now().saturating_sub(self.start)
    }

    /// Removes the line.
    pub(super) fn clear(&self) {
        if self.shown {
            output::progress("");
        }
    }
}

/// Completeness of a study: the number of finished items.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) reach: Reach,
    items: &'static str,
}

impl Extent {
    /// Extent of a computation without interrupts.
    pub(super) const WHOLE: Self = Self { reach: Reach::Complete, items: "" };

    /// Returns the extent of several runs, each of which may have been interrupted.
    pub(super) fn of_runs<'r>(runs: impl ExactSizeIterator<Item = &'r Run>) -> Self {
        let total = runs.len();
        let done = runs.filter(|run| run.end != EndReason::Cancelled).count();
        Self { reach: Reach::new(done < total, Progress { done, total }), items: "runs" }
    }

    /// Formats an incomplete extent: `not complete: interrupted after 30 of 49 rows`; `None` for a complete study.
    pub(super) fn missing(self) -> Option<String> {
        let after = self.reach.counted(self.items)?;
        Some(format!("not complete: interrupted after {after}"))
    }

    /// Returns the exit code: 0 for success, 1 for failure or after an interrupt, which it also reports.
    pub(super) fn exit_code(self, good: bool) -> ExitCode {
        let is_complete = self.reach.is_complete();
        if !is_complete {
            output::note("interrupted: partial results are shown");
        }
        if good && is_complete { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }

    /// Prints failures and returns the exit code: 0 without failures.
    pub(super) fn exit_code_after(self, failures: impl IntoIterator<Item = String>) -> ExitCode {
        let failures = failures.into_iter().inspect(|failure| output::note(failure)).count();
        self.exit_code(failures == 0)
    }
}

/// Runs a study on a number of threads and shows finished items and remaining time. Returns the result and its extent.
pub(super) fn study<P: ?Sized, T>(
    threads: usize,
    items: &'static str,
    study: impl FnOnce(&mut Context<'_, P>) -> T,
) -> (T, Extent) {
    let mut line = ProgressLine::begin();
    let mut reached = Progress::default();
    let watch = &mut |now: Progress, _: Option<&P>| {
        reached = now;
        let Progress { done, total } = now;
        line.update(|elapsed_s| {
            let percent = 100.0 * done as f64 / total.max(1) as f64;
            let left = duration(elapsed_s * (total - done) as f64 / done.max(1) as f64);
            format!("{percent:.0} %: {done} of {total} {items}, {left} left")
        })
    };
    let mut context = Context::new(threads, watch);
    let found = study(&mut context);
    let is_stopped = context.is_stopped();
    line.clear();
    (found, Extent { reach: Reach::new(is_stopped, reached), items })
}

/// Sets the clock of the progress line; only the first call has an effect.
pub(super) fn use_clock(clock: Clock) {
    let _ = CLOCK.set(clock);
}

fn now() -> Duration {
    CLOCK.get_or_init(wall)()
}

/// Returns a flag that the first interrupt or hang-up sets; a later Ctrl-C ends the process.
pub(super) fn interruptible() -> CancelFlag {
    let stop = STOP.get_or_init(|| {
        let stop = Arc::new(AtomicBool::new(false));
        if let Ok(interrupts) = Signals::new([SIGINT]) {
            let _ = thread::Builder::new().spawn(move || end_by_a_later_one(interrupts));
        }
        let hangup = (!is_ignored(SIGHUP)).then_some(SIGHUP);
        for signal in [SIGINT, SIGTERM].into_iter().chain(hangup) {
            // If the registration fails, an interrupt ends the process.
            let _ = flag::register(signal, Arc::clone(&stop));
        }
        stop
    });
    CancelFlag::from(Arc::clone(stop))
}

/// Ends the process at a second interrupt.
#[expect(clippy::exit, reason = "a person does not want to wait for the result")]
fn end_by_a_later_one(mut interrupts: Signals) {
    let mut first = None;
    for _ in interrupts.forever() {
        if first.get_or_insert_with(Instant::now).elapsed() > SAME_REQUEST {
            std::process::exit(128 + SIGINT);
        }
    }
}

/// Makes a file above the size limit (`ulimit -f`) a write error, as on a full disk; by default the signal ends the process.
pub(super) fn survive_large_files() {
    // If the registration fails, the signal ends the process, as by default.
    let _ = flag::register(SIGXFSZ, Arc::default());
}

/// Returns `true` after an interrupt: the result is incomplete.
pub(super) fn was_interrupted() -> bool {
    STOP.get().is_some_and(|stop| stop.load(Ordering::Relaxed))
}

/// Returns `true` if the process was started with a signal ignored, as by `nohup`, or if this is unknown.
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_none_or(|mask| mask >> (signal - 1) & 1 == 1)
}
