//! Measuring a short computation: repeated in batches long enough for the clock. The clock comes in from outside.

use std::hint::black_box;

use crate::numerics::smaller;

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

impl Patience {
    /// Whether a point of this run time is too slow to be repeated, s.
    pub fn is_slow(self, once_s: f64) -> bool {
        once_s.is_nan() || once_s >= self.slow_s
    }
}

/// The least time of a computation that has just been warmed up, s: the best estimate of its cost without interruptions.
pub fn time<T>(clock: Clock<'_>, patience: Patience, mut run: impl FnMut() -> T) -> f64 {
    let mut batch_of = |repeats: usize| {
        let start = clock();
        for _ in 0..repeats {
            black_box(run());
        }
        (clock() - start) / repeats as f64
    };
    let once = batch_of(1);
    if patience.is_slow(once) {
        return once;
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
    (0..batches).map(|_| batch_of(size)).fold(f64::INFINITY, smaller)
}
