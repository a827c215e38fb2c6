//! Tuning and timing: tolerances by measured error, times by alternating batches.

use std::hint::black_box;
use std::time::Instant;

use crate::solvers::{Job, Outcome};

/// Measured error everyone is tuned to.
pub(crate) const TARGET: f64 = 1e-8;
/// Half powers of ten tried, from loose to tight: 1e-3 to 1e-13.
const HALF_POWERS: std::ops::RangeInclusive<i32> = 6..=26;
/// Rounds of alternating batches.
const ROUNDS: usize = 60;
/// Length of a batch, s.
const BATCH_S: f64 = 3e-4;
/// A run longer than this is not worth tuning at tighter tolerances, s.
const HOPELESS_S: f64 = 0.1;

/// A solver at its tolerance.
pub(crate) struct Tuned {
    /// The tolerance.
    pub(crate) tolerance: f64,
    /// Measured error there.
    pub(crate) error: f64,
    /// Whether the target is met.
    pub(crate) meets: bool,
    job: Job,
}

/// The loosest tolerance from which on every answer meets the target; where none does, the most accurate one.
pub(crate) fn tune(
    mut prepare: impl FnMut(f64) -> Job,
    error: impl Fn((f64, f64)) -> f64,
) -> Option<Tuned> {
    let mut meeting: Option<Tuned> = None;
    let mut best: Option<Tuned> = None;
    for half in HALF_POWERS {
        let tolerance = 10f64.powf(-0.5 * f64::from(half));
        let mut job = prepare(tolerance);
        let start = Instant::now();
        let outcome = job();
        let took = start.elapsed().as_secs_f64();
        match outcome {
            Outcome::Answer(end) => {
                let error = error(end);
                if error <= TARGET {
                    meeting.get_or_insert(Tuned { tolerance, error, meets: true, job });
                } else {
                    meeting = None;
                    if best.as_ref().is_none_or(|best| error < best.error) {
                        best = Some(Tuned { tolerance, error, meets: false, job });
                    }
                }
            }
            Outcome::Failed => {}
        }
        if took > HOPELESS_S {
            break;
        }
    }
    meeting.or(best)
}

/// Times of one run, s.
pub(crate) struct Times {
    rounds: Vec<f64>,
}

impl Times {
    /// The least.
    pub(crate) fn min_s(&self) -> f64 {
        self.rounds.iter().copied().min_by(f64::total_cmp).unwrap_or(f64::NAN)
    }

    /// How far the median lies above the least, relative.
    pub(crate) fn spread(&self) -> f64 {
        quartile(self.rounds.clone(), 2) / self.min_s() - 1.0
    }

    /// Quarters of the ratio to another's times, round by round: drift of the machine cancels.
    pub(crate) fn ratio_quarters(&self, other: &Self) -> (f64, f64) {
        let ratios: Vec<f64> =
            self.rounds.iter().zip(&other.rounds).map(|(own, other)| own / other).collect();
        (quartile(ratios.clone(), 1), quartile(ratios, 3))
    }
}

fn quartile(mut values: Vec<f64>, quarter: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() * quarter / 4).copied().unwrap_or(f64::NAN)
}

/// Time all of them in turn, batch by batch.
pub(crate) fn alternate(solvers: &mut [Tuned]) -> Vec<Times> {
    let mut sizes = Vec::new();
    for solver in solvers.iter_mut() {
        let once = batch(&mut solver.job, 1);
        let mut size = 1;
        while size < 4096 && f64::from(size) * once < BATCH_S {
            size *= 2;
        }
        sizes.push(size);
    }
    let mut times: Vec<Times> = solvers.iter().map(|_| Times { rounds: Vec::new() }).collect();
    for _ in 0..ROUNDS {
        for ((solver, times), size) in solvers.iter_mut().zip(&mut times).zip(&sizes) {
            times.rounds.push(batch(&mut solver.job, *size));
        }
    }
    times
}

/// Time of one run in a batch, s.
fn batch(job: &mut Job, size: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..size {
        black_box(job());
    }
    start.elapsed().as_secs_f64() / f64::from(size)
}
