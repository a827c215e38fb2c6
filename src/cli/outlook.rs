//! How long a great number of runs will take, said before they begin where that is long: estimated from a few of them.

use std::ops::{ControlFlow, Range};
use std::time::{Duration, Instant};

use crate::cli::output;
use crate::cli::progress::interruptible;
use crate::cli::sweep::page::duration;
use crate::study::context::Context;
use crate::study::sweep::Plan;

/// Computations longer than this are announced.
const LONG: Duration = Duration::from_secs(60);
/// How long the trial may take.
const TRYING: Duration = Duration::from_millis(250);
/// At most one run in this many is tried.
const SPARED: u64 = 4;
/// Runs of the first batch, and how much larger each further one is: what a batch costs to begin is small against the last one.
const FIRST: u64 = 8;
const GROWTH: u64 = 4;

/// Checked by a trial regularly: `Break` when it takes too long.
type GoOn<'a> = &'a mut dyn FnMut() -> ControlFlow<()>;

/// Announces the time that runs of this number of designs within the bounds will take, if it is long.
pub(super) fn say_if_long(space: &Plan, runs: u64, what: &str, threads: usize) {
    // An interrupt of the trial counts for the study after it.
    interruptible();
    by_batches(runs, what, |tried, go_on| {
        // Shares that do not fall on one line through the box.
        let share =
            |at: u64, axis: usize| (0.5 + 0.618_034 * (at * (axis as u64 + 1)) as f64).fract();
        let design = |at: u64| {
            let axes = space.axes().iter().enumerate();
            axes.map(|(number, axis)| axis.at_share(share(at, number))).collect()
        };
        let designs: Vec<Vec<f64>> = tried.map(design).collect();
        let watch = &mut |_, _: Option<&()>| go_on();
        space.evaluate(&designs, &mut Context::new(threads, watch)).len() as u64
    });
}

/// Try batches of a given number of runs, the way and on the threads all of them will take. `attempt` makes the runs of these numbers, and
/// gives how many it finished.
fn by_batches(runs: u64, what: &str, mut attempt: impl FnMut(Range<u64>, GoOn<'_>) -> u64) {
    let start = Instant::now();
    let is_time = || start.elapsed() < TRYING;
    let go_on = &mut || if is_time() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let (mut tried, mut size, mut done) = (0, FIRST, 0);
    while tried < runs / SPARED && is_time() {
        let until = (tried + size).min(runs / SPARED);
        done += attempt(tried..until, go_on);
        (tried, size) = (until, size * GROWTH);
    }
    if done == 0 {
        if tried > 0 {
            output::note(&format!(
                "none of the {what} was finished in {} ms, all {runs} will take long; an interrupt keeps what is finished",
                TRYING.as_millis()
            ));
        }
        return;
    }
    let takes_s = start.elapsed().as_secs_f64() * runs as f64 / done as f64;
    if takes_s > LONG.as_secs_f64() {
        output::note(&format!(
            "{runs} {what} will take about {} (estimated from {done} of them); an interrupt keeps what is finished",
            duration(takes_s)
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every number is tried once, batches grow, and a quarter of the runs is the most.
    #[test]
    fn batches_grow_and_end_at_a_quarter() {
        let mut seen = Vec::new();
        by_batches(100, "runs", |numbers, _| {
            seen.push(numbers.clone());
            numbers.end - numbers.start
        });
        assert_eq!(seen, [0..8, 8..25]);
        seen.clear();
        by_batches(3, "runs", |numbers, _| {
            seen.push(numbers);
            1
        });
        assert!(seen.is_empty());
    }
}
