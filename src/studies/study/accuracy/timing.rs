//! Measuring a short computation: repeated in batches long enough for the clock. The clock comes in from outside.

use std::hint::black_box;

use cmra_engine::numerics::smaller;

/// Gives the time, s, from any origin.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A batch is at least this long, s: some thousand times the resolution of a clock.
const BATCH_S: f64 = 5e-5;
/// Maximum number of repeats in a batch: a clock that stands still must not hang the program.
const BATCH_MAX: usize = 4096;
/// Fewest and most batches of a computation that is repeated.
const BATCHES: (usize, usize) = (3, 31);
/// A computation that takes so many times as long as its batches may take is not repeated.
const ONCE: f64 = 8.0;

/// The least time of a computation that has just been warmed up, s: the best estimate of its cost without interruptions. Beyond the fewest
/// batches it is repeated for `point_s` at most.
pub fn time<T>(clock: Clock<'_>, point_s: f64, mut run: impl FnMut() -> T) -> f64 {
    let mut batch_of = |repeats: usize| {
        let start = clock();
        for _ in 0..repeats {
            black_box(run());
        }
        (clock() - start) / repeats as f64
    };
    let once = batch_of(1);
    if once.is_nan() || once >= ONCE * point_s {
        return once;
    }
    let mut size = 1;
    while size < BATCH_MAX && size as f64 * once < BATCH_S {
        size *= 2;
    }
    let (least, most) = BATCHES;
    let mut batches = least;
    while batches < most && (batches * size) as f64 * once < point_s {
        batches += 1;
    }
    (0..batches).map(|_| batch_of(size)).fold(f64::INFINITY, smaller)
}
