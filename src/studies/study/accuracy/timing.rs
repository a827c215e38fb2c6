//! Timing of short computations, repeated in batches that are long compared with the resolution of the clock.

use std::hint::black_box;

use cmra_engine::numerics::smaller;

/// Clock: returns the time since any fixed instant, s.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// Minimum duration of a batch, s: about a thousand times the resolution of a clock.
const BATCH_S: f64 = 5e-5;
/// Maximum number of repetitions in a batch; ends the loop if the clock does not advance.
const BATCH_MAX: usize = 4096;
/// Minimum and maximum number of batches of a repeated computation.
const BATCHES: (usize, usize) = (3, 31);
/// Duration above which a computation is not repeated, relative to the time limit of its repetitions.
const ONCE: f64 = 8.0;

/// Returns the minimum run time of a computation, s: the best estimate without interruptions.
///
/// The computation is repeated for at most `point_s` beyond the minimum number of batches. The caller has run it once before.
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
