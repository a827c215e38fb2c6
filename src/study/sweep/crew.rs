//! The threads of a sweep: pieces go out in order, results come back in order, however many hands there are.
//!
//! Thread t of T does the pieces t, t + T, ... and keeps at most a few results waiting, so memory stays constant; the caller
//! takes them in turn. The result of a piece depends on nothing but the piece.

use std::ops::{ControlFlow, Range};
use std::sync::mpsc::sync_channel;
use std::thread;

/// Results of one thread that may wait to be taken.
const WAITING: usize = 8;

/// How the work is cut and who does it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crew {
    /// Threads, >= 1.
    pub threads: usize,
    /// Points a piece has, >= 1: a few milliseconds of work at most, since cancelling waits for the running pieces.
    pub piece: u64,
}

impl Crew {
    /// One thread for each core, and pieces of the usual size.
    pub fn of_machine() -> Self {
        Self { threads: thread::available_parallelism().map_or(1, usize::from), piece: 64 }
    }

    /// Work through `points`: each thread gets a worker of its own from `hire`, and `take` is given every result in the order
    /// of the points. `Break` from `take` ends it; pieces under way are dropped.
    pub fn work<T: Send, W: FnMut(Range<u64>) -> T>(
        self,
        points: Range<u64>,
        hire: impl Fn() -> W + Sync,
        mut take: impl FnMut(Range<u64>, T) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let piece = self.piece.max(1);
        let pieces = (points.end.saturating_sub(points.start)).div_ceil(piece);
        let at = |number: u64| {
            let from = points.start + number * piece;
            from..(from + piece).min(points.end)
        };
        let threads = u64::try_from(self.threads.max(1)).unwrap_or(1).min(pieces.max(1));
        if threads == 1 {
            let mut worker = hire();
            for number in 0..pieces {
                take(at(number), worker(at(number)))?;
            }
            return ControlFlow::Continue(());
        }
        let (hire, at) = (&hire, &at);
        thread::scope(|scope| {
            let mut lines = Vec::new();
            for first in 0..threads {
                let (send, receive) = sync_channel(WAITING);
                let stride = usize::try_from(threads).unwrap_or(1);
                let work = move || {
                    let mut worker = hire();
                    for number in (first..pieces).step_by(stride) {
                        // Nobody takes any more: the work was broken off.
                        if send.send(worker(at(number))).is_err() {
                            return;
                        }
                    }
                };
                // A system that has no more threads to give leaves the rest of the work to this one.
                let started = thread::Builder::new().spawn_scoped(scope, work);
                lines.push(started.ok().map(|_| receive));
            }
            let mut own = None;
            for (number, line) in (0..pieces).zip(lines.iter().cycle()) {
                let result = match line {
                    Some(line) => line.recv().ok(),
                    None => Some(own.get_or_insert_with(hire)(at(number))),
                };
                // A thread that ended without its result panicked; leaving the scope passes that on.
                let Some(result) = result else { break };
                if take(at(number), result).is_break() {
                    drop(lines);
                    return ControlFlow::Break(());
                }
            }
            ControlFlow::Continue(())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_whoever_works() {
        for threads in [1, 2, 3, 7] {
            for points in [0, 1, 9, 10, 11, 1000] {
                let crew = Crew { threads, piece: 10 };
                let mut seen = Vec::new();
                let hire = || |piece: Range<u64>| piece.collect::<Vec<u64>>();
                let ended = crew.work(5..5 + points, hire, |piece, found: Vec<u64>| {
                    assert_eq!(piece.clone().collect::<Vec<u64>>(), found);
                    seen.extend(found);
                    ControlFlow::Continue(())
                });
                assert!(ended.is_continue());
                assert_eq!(seen, (5..5 + points).collect::<Vec<u64>>(), "{threads} {points}");
            }
        }
    }

    #[test]
    fn breaking_off_ends_a_sweep_that_would_never_end() {
        for threads in [1, 2] {
            let crew = Crew { threads, piece: 1 };
            let mut taken = 0;
            let ended = crew.work(
                0..u64::MAX >> 1,
                || |piece: Range<u64>| piece.start,
                |_, start| {
                    assert_eq!(start, taken);
                    taken += 1;
                    if taken == 100 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                },
            );
            assert!(ended.is_break());
        }
    }
}
