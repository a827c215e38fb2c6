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

/// Announces the time that runs of this number of designs within the bounds will take, if it is long: tries some of them, in the way and
/// on the threads all of them will take.
pub(super) fn announce_if_long(space: &Plan, runs: u64, what: &str, threads: usize) {
    // An interrupt of the trial counts for the study after it.
    interruptible();
    let start = Instant::now();
    let is_time = || start.elapsed() < TRYING;
    let watch = &mut |_, _: Option<&()>| {
        if is_time() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    // Shares that do not fall on one line through the box.
    let share = |at: u64, axis: usize| (0.5 + 0.618_034 * (at * (axis as u64 + 1)) as f64).fract();
    let design = |at: u64| {
        let axes = space.axes().iter().enumerate();
        axes.map(|(number, axis)| axis.at_share(share(at, number))).collect()
    };
    let (mut tried, mut done) = (0, 0);
    for batch in batches(runs).take_while(|_| is_time()) {
        tried = batch.end;
        let designs: Vec<Vec<f64>> = batch.map(design).collect();
        done += space.evaluate(&designs, &mut Context::new(threads, watch)).len();
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
            "{runs} {what} will take up to about {} (estimated from {done} of them); an interrupt keeps what is finished",
            duration(takes_s)
        ));
    }
}

/// The numbers of the runs to be tried at once.
fn batches(runs: u64) -> impl Iterator<Item = Range<u64>> {
    let (mut from, mut size) = (0, FIRST);
    std::iter::from_fn(move || {
        let batch = from..(from + size).min(runs / SPARED);
        (from, size) = (batch.end, size * GROWTH);
        (!batch.is_empty()).then_some(batch)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_grow_and_end_at_a_quarter() {
        assert_eq!(batches(100).collect::<Vec<_>>(), [0..8, 8..25]);
        assert_eq!(batches(3).count(), 0);
    }
}
