//! The ordered parallel map of all studies: pieces go out in order, results come back in order, on however many threads.
//!
//! Whichever thread is free takes the next piece. So many pieces are out at the most, so memory stays constant. The result of a piece
//! depends on nothing but the piece.

use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

/// Pieces that are out for each thread.
const OUT: u64 = 8;

/// How often somebody who waits for a result is asked whether to go on.
const ASKED_EVERY: Duration = Duration::from_millis(20);

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
        let pieces = self.cut(points);
        if self.threads.max(1) == 1 || pieces.count == 1 {
            let mut worker = hire();
            for number in 0..pieces.count {
                take(pieces.at(number), worker(pieces.at(number)))?;
            }
            return ControlFlow::Continue(());
        }
        self.share_out(&pieces, &hire, &mut |news| {
            news.map_or(ControlFlow::Continue(()), |(piece, result)| take(piece, result))
        })
    }

    /// The same on other threads than this one, which asks `hear` also now and then while there is no result (`None`): a piece
    /// may take longer than anybody wants to wait for the word to stop.
    pub fn work_heard<T: Send, W: FnMut(Range<u64>) -> T>(
        self,
        points: Range<u64>,
        hire: impl Fn() -> W + Sync,
        mut hear: impl FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.share_out(&self.cut(points), &hire, &mut hear)
    }

    fn cut(self, points: Range<u64>) -> Pieces {
        let size = self.piece.max(1);
        Pieces { count: points.end.saturating_sub(points.start).div_ceil(size), size, points }
    }

    fn share_out<T: Send, W: FnMut(Range<u64>) -> T>(
        self,
        pieces: &Pieces,
        hire: &(impl Fn() -> W + Sync),
        hear: Hear<'_, T>,
    ) -> ControlFlow<()> {
        let threads = u64::try_from(self.threads.max(1)).unwrap_or(1).min(pieces.count);
        let (order, orders) = channel();
        let (send, results) = channel();
        let orders = Mutex::new(orders);
        let work = |send: Sender<(u64, T)>| {
            let mut worker = hire();
            let next = || orders.lock().unwrap_or_else(PoisonError::into_inner).recv();
            while let Ok(number) = next() {
                // Nobody takes any more: the work was broken off.
                if send.send((number, worker(pieces.at(number)))).is_err() {
                    return;
                }
            }
        };
        thread::scope(|scope| {
            // What the system has threads for.
            let started: Vec<_> = (0..threads)
                .filter_map(|_| {
                    let (work, send) = (&work, send.clone());
                    thread::Builder::new().spawn_scoped(scope, move || work(send)).ok()
                })
                .collect();
            // Both end with this scope: the threads stop, whatever is left to do.
            let (order, results) = (order, results);
            drop(send);
            let (mut own, mut ordered) = (None, 0);
            let mut early = BTreeMap::new();
            for number in 0..pieces.count {
                if started.is_empty() {
                    early.insert(number, own.get_or_insert_with(hire)(pieces.at(number)));
                }
                while ordered < pieces.count.min(number + OUT * threads) {
                    // The orders are there as long as this function.
                    let _ = order.send(ordered);
                    ordered += 1;
                }
                let has_panicked = || started.iter().any(ScopedJoinHandle::is_finished);
                while !early.contains_key(&number) {
                    match results.recv_timeout(ASKED_EVERY) {
                        Ok((done, result)) => drop(early.insert(done, result)),
                        // Who is asked in between stops the workers by a flag of their own: what they have done until then still
                        // comes.
                        Err(RecvTimeoutError::Timeout) if !has_panicked() => drop(hear(None)),
                        // Leaving the scope passes a panic on.
                        Err(_) => return ControlFlow::Break(()),
                    }
                }
                if let Some(result) = early.remove(&number) {
                    hear(Some((pieces.at(number), result)))?;
                }
            }
            ControlFlow::Continue(())
        })
    }
}

/// Whoever takes the results, and is asked in between.
type Hear<'h, T> = &'h mut dyn FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>;

/// How points are cut into pieces.
struct Pieces {
    points: Range<u64>,
    size: u64,
    count: u64,
}

impl Pieces {
    /// The points of a piece, from zero.
    fn at(&self, number: u64) -> Range<u64> {
        let from = self.points.start + number * self.size;
        from..(from + self.size).min(self.points.end)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

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

    #[test]
    fn who_waits_for_a_piece_is_asked_and_stops_it() {
        let stop = AtomicBool::new(false);
        for threads in [1, 2] {
            stop.store(false, Ordering::Relaxed);
            let (mut asked, mut pieces) = (0, Vec::new());
            let hire = || {
                let stop = &stop;
                move |piece: Range<u64>| {
                    // The second piece would never end by itself.
                    while piece.start == 1 && !stop.load(Ordering::Relaxed) {
                        thread::yield_now();
                    }
                    piece.start
                }
            };
            let ended = Crew { threads, piece: 1 }.work_heard(0..1000, hire, |news| {
                asked += usize::from(news.is_none());
                pieces.extend(news.map(|(_, start)| start));
                if asked == 3 {
                    stop.store(true, Ordering::Relaxed);
                }
                let stopped = stop.load(Ordering::Relaxed);
                if stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            assert!(ended.is_break());
            assert_eq!((asked, pieces), (3, vec![0, 1]), "{threads}");
        }
    }
}
