//! How long a great number of runs will take, said before they begin where that is long: estimated from a few of them.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::cli::output;
use crate::cli::sweep::page::duration;

/// What is expected to take longer is announced.
const LONG: Duration = Duration::from_secs(60);
/// Runs tried for that, and how long they may take together.
const TRIED: u64 = 48;
const TRYING: Duration = Duration::from_millis(250);
/// At the most one run for so many is tried: nobody asks how long fewer will take.
const SPARED: u64 = 4;

/// Asked by a trial now and then: `Break` when it takes too long.
pub(super) type GoOn<'a> = &'a mut dyn FnMut() -> ControlFlow<()>;

/// Try a few of so many runs, and say how long all will take on so many threads where that is long. `attempt` makes the trial of
/// this number, of so many; `Break` when it was cut short.
pub(super) fn say_if_long(
    (runs, what): (u64, &str),
    threads: usize,
    mut attempt: impl FnMut(u64, u64, GoOn<'_>) -> ControlFlow<()>,
) {
    let most = TRIED.min(runs / SPARED);
    let start = Instant::now();
    let is_time = || start.elapsed() < TRYING;
    let (mut tried, mut cut_short) = (0, false);
    while tried < most && is_time() {
        let go_on =
            &mut || if is_time() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        cut_short = attempt(tried, most, go_on).is_break();
        tried += 1;
    }
    let each_s = start.elapsed().as_secs_f64() / tried.max(1) as f64;
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let takes_s = each_s * runs as f64 / threads.min(cores) as f64;
    if cut_short {
        output::note(&format!(
            "one of the {what} takes more than {} ms, all {runs} of them more than {}; an interrupt keeps what is finished",
            TRYING.as_millis() / u128::from(tried),
            duration(takes_s),
        ));
    } else if takes_s > LONG.as_secs_f64() {
        output::note(&format!(
            "{runs} {what} will take about {} (estimated from {tried} of them); an interrupt keeps what is finished",
            duration(takes_s)
        ));
    }
}
