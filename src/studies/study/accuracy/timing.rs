//! Measuring a short computation: repeated in batches long enough for the clock. The clock comes in from outside.

use std::hint::black_box;

/// Gives the time, s, from any origin.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A batch is at least this long, s: some thousand times the resolution of a clock.
const BATCH_S: f64 = 5e-5;
/// Maximum number of repeats in a batch: a clock that stands still must not hang the program.
const BATCH_MAX: usize = 4096;
/// Largest number of batches, and the smallest number for short computations.
const BATCHES: (usize, usize) = (3, 31);

/// How much time may be spent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patience {
    /// On repeats of one point, s.
    pub point_s: f64,
    /// A point that takes longer is run once, and finer ones of its method not at all, s.
    pub slow_s: f64,
}

/// Measured run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The least, s: the best estimate of the cost without interruptions.
    pub min_s: f64,
    /// The median over batches, s.
    pub median_s: f64,
    /// Median absolute deviation from the median, s; `None` for a single run.
    pub mad_s: Option<f64>,
    /// Runs timed.
    pub repeats: usize,
}

impl Timing {
    /// How far batches differ: the deviation over the median; `None` for a single run.
    pub fn spread(&self) -> Option<f64> {
        self.mad_s.map(|mad_s| mad_s / self.median_s)
    }
}

/// Time a computation that has just been warmed up.
pub fn time<T>(clock: Clock<'_>, patience: Patience, mut run: impl FnMut() -> T) -> Timing {
    let mut batch_of = |repeats: usize| {
        let start = clock();
        for _ in 0..repeats {
            black_box(run());
        }
        (clock() - start) / repeats as f64
    };
    let once = batch_of(1);
    if once.is_nan() || once >= patience.slow_s {
        return Timing { min_s: once, median_s: once, mad_s: None, repeats: 1 };
    }
    let mut size = 1;
    while size < BATCH_MAX && size as f64 * once < BATCH_S {
        size *= 2;
    }
    let (least, most) = BATCHES;
    let mut batches = least;
    while batches < most && (batches * size) as f64 * once < patience.point_s {
        batches += 1;
    }
    let mut times: Vec<f64> = (0..batches).map(|_| batch_of(size)).collect();
    let median_s = median(&mut times);
    let min_s = times[0];
    let mut deviations: Vec<f64> = times.iter().map(|time| (time - median_s).abs()).collect();
    let mad_s = Some(median(&mut deviations));
    Timing { min_s, median_s, mad_s, repeats: batches * size }
}

/// Sorts, and gives the middle value; of an even number, the greater of the two.
fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    const PATIENCE: Patience = Patience { point_s: 1e-3, slow_s: 0.1 };

    /// A clock that moves on with each run.
    fn timed(cost_s: f64) -> (Timing, usize) {
        let (now, runs) = (Cell::new(0.0), Cell::new(0));
        let timing = time(&mut || now.get(), PATIENCE, || {
            runs.set(runs.get() + 1);
            now.set(now.get() + cost_s);
        });
        (timing, runs.get())
    }

    #[test]
    fn short_runs_are_batched_and_slow_ones_run_once() {
        let (timing, runs) = timed(1e-6);
        assert!((timing.min_s / 1e-6 - 1.0).abs() < 1e-6 && timing.min_s <= timing.median_s);
        assert!(timing.mad_s.is_some_and(|mad| mad < 1e-12));
        assert_eq!(runs, timing.repeats + 1);
        assert!(timing.repeats as f64 * 1e-6 < 3e-3);
        let (timing, runs) = timed(0.5);
        assert_eq!((timing.repeats, timing.mad_s, runs), (1, None, 1));
    }

    #[test]
    fn a_clock_that_stands_still_does_not_hang() {
        let (timing, _) = timed(0.0);
        assert!(timing.repeats <= BATCH_MAX * BATCHES.1);
    }
}
