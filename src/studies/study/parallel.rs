//! The ordered parallel map of all studies: pieces go out in order, results come back in order, on however many threads.
//!
//! A thread that is free takes the next piece. A few pieces a thread are out at most, so memory stays constant. The result of a
//! piece depends on the piece only.

use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};
use std::sync::mpsc::{self, Sender};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

/// Pieces that are handed out, per thread, before the first of them is taken.
const OUT: u64 = 8;

/// Time between two calls of `take` while no result is ready.
const ASKED_EVERY: Duration = Duration::from_millis(20);

/// How much work there is.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    /// Points of it.
    pub count: u64,
    /// Points that a thread does before it hands in their results, >= 1: a few milliseconds of work at most, since cancelling
    /// waits for the running pieces.
    pub at_once: u64,
}

impl Work {
    /// The points of a piece, from zero.
    fn piece(self, number: u64) -> Range<u64> {
        let from = number * self.at_once;
        from..(from + self.at_once).min(self.count)
    }
}

/// One thread for each core.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Does work on a number of threads, >= 1: each gets a worker of its own from `worker`, and `take` is given every result in the
/// order of the points. It is also called regularly (`None`) while no result is ready, so that a study can be cancelled during a long
/// piece. `Break` ends the work; running pieces are dropped.
pub fn map<T: Send, W: FnMut(Range<u64>) -> T>(
    threads: usize,
    work: Work,
    worker: impl Fn() -> W + Sync,
    mut take: impl FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let count = work.count.div_ceil(work.at_once);
    let threads = u64::try_from(threads.max(1)).unwrap_or(1).min(count);
    let out = OUT * threads;
    let (hand_out, next) = mpsc::channel();
    for number in 0..count.min(out) {
        let _ = hand_out.send(number);
    }
    let next = Mutex::new(next);
    let serve = |done: Sender<(u64, T)>| {
        let mut make = worker();
        loop {
            let number = next.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let Ok(number) = number else { return };
            if done.send((number, make(work.piece(number)))).is_err() {
                return;
            }
        }
    };
    thread::scope(|scope| {
        let (done, told) = mpsc::channel();
        // Closed with this scope, also when a panic ends it: that ends the threads.
        let hand_out = hand_out;
        let start = |_| {
            let (serve, done) = (&serve, done.clone());
            thread::Builder::new().spawn_scoped(scope, move || serve(done)).ok()
        };
        // As many threads as the system has.
        let started: Vec<_> = (0..threads).filter_map(start).collect();
        let mut own = started.is_empty().then(&worker);
        let mut waiting = BTreeMap::new();
        for number in 0..count {
            if let Some(make) = &mut own {
                waiting.insert(number, make(work.piece(number)));
            }
            let result = loop {
                if let Some(result) = waiting.remove(&number) {
                    break result;
                }
                match told.recv_timeout(ASKED_EVERY) {
                    Ok((other, result)) => _ = waiting.insert(other, result),
                    // Leaving the scope passes a worker's panic on.
                    Err(_) if started.iter().any(ScopedJoinHandle::is_finished) => {
                        return ControlFlow::Break(());
                    }
                    // Who breaks off here stops the workers by a flag of their own: what they have done until then still comes.
                    Err(_) => _ = take(None),
                }
            };
            take(Some((work.piece(number), result)))?;
            if number + out < count {
                let _ = hand_out.send(number + out);
            }
        }
        ControlFlow::Continue(())
    })
}

#[cfg(test)]
mod tests {

    use super::*;

    #[test]
    fn results_come_in_order_whoever_works() {
        for threads in [1, 2, 3, 7] {
            for points in [0, 1, 9, 10, 11, 1000] {
                let mut seen = Vec::new();
                let worker = || |piece: Range<u64>| piece.collect::<Vec<u64>>();
                let ended = map(threads, Work { count: points, at_once: 10 }, worker, |news| {
                    if let Some((piece, found)) = news {
                        assert_eq!(piece.collect::<Vec<u64>>(), found);
                        seen.extend(found);
                    }
                    ControlFlow::Continue(())
                });
                assert!(ended.is_continue());
                assert_eq!(seen, (0..points).collect::<Vec<u64>>(), "{threads} {points}");
            }
        }
    }
}
