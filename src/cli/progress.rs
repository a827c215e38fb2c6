//! How far a long computation is, and whether somebody wants it to end.
//!
//! After half a second there is one line on standard error, on a terminal only, taken away when the result comes. The first
//! interrupt, or a dropped connection, keeps what is finished; a Ctrl-C half a second later ends the process.

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

/// Set by the first interrupt. Global, as signals are.
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// The clock that decides when progress is shown. Global, as the terminal is.
static CLOCK: OnceLock<Clock> = OnceLock::new();

/// Time before the progress of a computation is shown first, and between updates.
const SHOWN_AFTER: Duration = Duration::from_millis(500);
const UPDATED_EVERY: Duration = Duration::from_millis(200);

/// Time within which further interrupts are those of the first request: programs that end others send their signal twice, to the
/// process and to its group. A person's second one comes later.
const SAME_REQUEST: Duration = Duration::from_millis(500);

/// The line on the terminal that says how far a computation is.
pub(super) struct ProgressLine {
    start: Duration,
    last_shown: Duration,
    shown: bool,
    wanted: bool,
    stop: CancelFlag,
}

impl ProgressLine {
    /// Starts now; an interrupt is noted from now on.
    pub(super) fn begin() -> Self {
        let now = now();
        let dumb = std::env::var("TERM").is_ok_and(|term| term == "dumb");
        let wanted = io::stderr().is_terminal() && !dumb;
        Self { start: now, last_shown: now, shown: false, wanted, stop: interruptible() }
    }

    /// Shows the progress regularly, by a text made from the elapsed seconds; `Break` after an interrupt.
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

    /// How long the computation has lasted.
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

/// Extent of the study of a command, counted in its items.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) reach: Reach,
    items: &'static str,
}

impl Extent {
    /// Extent of what cannot be interrupted.
    pub(super) const WHOLE: Self = Self { reach: Reach::Complete, items: "" };

    /// Extent of some runs, each of which an interrupt may have stopped.
    pub(super) fn of_runs<'r>(runs: impl ExactSizeIterator<Item = &'r Run>) -> Self {
        let total = runs.len();
        let done = runs.filter(|run| run.end != EndReason::Cancelled).count();
        Self { reach: Reach::new(done < total, Progress { done, total }), items: "runs" }
    }

    /// `not complete: interrupted after 30 of 49 rows`; `None` for a complete study.
    pub(super) fn missing(self) -> Option<String> {
        let after = self.reach.counted(self.items)?;
        Some(format!("not complete: interrupted after {after}"))
    }

    /// Exit status 0 for success, 1 for failure or after an interrupt, which is reported below the result.
    pub(super) fn exit_code(self, good: bool) -> ExitCode {
        let is_complete = self.reach.is_complete();
        if !is_complete {
            output::note("interrupted: partial results are shown");
        }
        if good && is_complete { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }

    /// Prints failures and returns the exit code: 0 if there are none.
    pub(super) fn exit_code_after(self, failures: impl IntoIterator<Item = String>) -> ExitCode {
        let failures = failures.into_iter().inspect(|failure| output::note(failure)).count();
        self.exit_code(failures == 0)
    }
}

/// Runs a study on this number of threads, and shows how many of its items are done, and the remaining time at this rate. Returns its
/// result and how far it came.
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

/// Lets this clock decide when progress is shown. The first one handed in stays.
pub(super) fn use_clock(clock: Clock) {
    let _ = CLOCK.set(clock);
}

fn now() -> Duration {
    CLOCK.get_or_init(wall)()
}

/// A flag that the first interrupt, or a dropped connection, sets; a later Ctrl-C ends the process.
pub(super) fn interruptible() -> CancelFlag {
    let stop = STOP.get_or_init(|| {
        let stop = Arc::new(AtomicBool::new(false));
        if let Ok(interrupts) = Signals::new([SIGINT]) {
            let _ = thread::Builder::new().spawn(move || end_by_a_later_one(interrupts));
        }
        let hangup = (!is_ignored(SIGHUP)).then_some(SIGHUP);
        for signal in [SIGINT, SIGTERM].into_iter().chain(hangup) {
            // Where it cannot be done, the interrupt just ends the process.
            let _ = flag::register(signal, Arc::clone(&stop));
        }
        stop
    });
    CancelFlag::from(Arc::clone(stop))
}

/// Ends the process at the first interrupt that is a request of its own after another one.
#[expect(clippy::exit, reason = "a person does not want to wait for the result")]
fn end_by_a_later_one(mut interrupts: Signals) {
    let mut first = None;
    for _ in interrupts.forever() {
        if first.get_or_insert_with(Instant::now).elapsed() > SAME_REQUEST {
            std::process::exit(128 + SIGINT);
        }
    }
}

/// A file beyond the limit of its size (`ulimit -f`) is an error of writing, as on a full disk, and not the end of the process.
pub(super) fn survive_large_files() {
    // Where it cannot be done, the signal ends the process, as it does by default.
    let _ = flag::register(SIGXFSZ, Arc::default());
}

/// Whether a computation was interrupted: its result is not complete.
pub(super) fn was_interrupted() -> bool {
    STOP.get().is_some_and(|stop| stop.load(Ordering::Relaxed))
}

/// Whether the program was started so that it outlives a signal, as `nohup` does. Assumed where the system does not tell.
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_none_or(|mask| mask >> (signal - 1) & 1 == 1)
}
