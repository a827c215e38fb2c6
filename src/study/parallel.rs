//! The ordered parallel map of all studies: pieces go out in order, results come back in order, on however many threads.
//!
//! A thread that is free takes the next piece. A few pieces a thread are out at most, so memory stays constant. The result of a
//! piece depends on the piece only.

use std::collections::BTreeSet;
use std::ops::{ControlFlow, Range};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

/// Pieces that are out for each thread.
const OUT: u64 = 8;

/// How often somebody who waits for a result is asked whether to go on.
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
    fn pieces(self) -> u64 {
        self.count.div_ceil(self.at_once)
    }

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
/// order of the points. It is also asked regularly while there is no result (`None`): a piece may take longer than anybody wants
/// to wait for the word to stop. `Break` ends it; pieces under way are dropped.
pub fn map<T: Send, W: FnMut(Range<u64>) -> T>(
    threads: usize,
    work: Work,
    worker: impl Fn() -> W + Sync,
    mut take: impl FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let threads = u64::try_from(threads.max(1)).unwrap_or(1).min(work.pieces());
    // Each result waits in a slot of its own until those before it are taken.
    let slots: Vec<Mutex<Option<T>>> = (0..OUT * threads).map(|_| Mutex::new(None)).collect();
    let slot = |number: u64| {
        let place = usize::try_from(number).unwrap_or(0) % slots.len();
        slots[place].lock().unwrap_or_else(PoisonError::into_inner)
    };
    let worker = || -> Box<dyn FnMut(u64) + '_> {
        let mut make = worker();
        Box::new(move |number| *slot(number) = Some(make(work.piece(number))))
    };
    let queue =
        Queue { count: work.pieces(), threads, state: Mutex::default(), changed: Condvar::new() };
    queue.run(&worker, &mut |number| {
        take(number.and_then(|number| Some((work.piece(number), slot(number).take()?))))
    })
}

/// The numbers of the pieces, on their way to the threads and back.
struct Queue {
    count: u64,
    threads: u64,
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    /// The piece that is worked on next, and the first that must wait.
    next: u64,
    end: u64,
    /// Pieces that are done and not taken yet.
    done: BTreeSet<u64>,
    is_closed: bool,
}

/// Ends the threads when it goes, also when a panic takes it.
struct Closing<'q>(&'q Queue);

impl Drop for Closing<'_> {
    fn drop(&mut self) {
        self.0.state().is_closed = true;
        self.0.changed.notify_all();
    }
}

impl Queue {
    /// Call `take` with every number in order, once a worker has done it, and with `None` regularly in between.
    fn run<'w>(
        &self,
        worker: &(dyn Fn() -> Box<dyn FnMut(u64) + 'w> + Sync),
        take: &mut dyn FnMut(Option<u64>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        thread::scope(|scope| {
            let _closing = Closing(self);
            // As many threads as the system has.
            let start = |_| thread::Builder::new().spawn_scoped(scope, || self.work(worker())).ok();
            let started: Vec<_> = (0..self.threads).filter_map(start).collect();
            let mut own = started.is_empty().then(worker);
            for number in 0..self.count {
                if let Some(own) = &mut own {
                    own(number);
                } else {
                    let has_panicked = || started.iter().any(ScopedJoinHandle::is_finished);
                    self.wait_for(number, &has_panicked, take)?;
                }
                take(Some(number))?;
            }
            ControlFlow::Continue(())
        })
    }

    /// Take one piece after another until the queue is closed.
    fn work(&self, mut worker: Box<dyn FnMut(u64) + '_>) {
        loop {
            let must_wait = |state: &mut State| state.next >= state.end && !state.is_closed;
            let waiting = self.changed.wait_while(self.state(), must_wait);
            let mut state = waiting.unwrap_or_else(PoisonError::into_inner);
            if state.is_closed {
                return;
            }
            let number = state.next;
            state.next += 1;
            drop(state);
            worker(number);
            self.state().done.insert(number);
            self.changed.notify_all();
        }
    }

    /// Wait until a piece is done. Leaving the scope passes a worker's panic on.
    fn wait_for(
        &self,
        number: u64,
        has_panicked: &dyn Fn() -> bool,
        take: &mut dyn FnMut(Option<u64>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut state = self.state();
        state.end = self.count.min(number + OUT * self.threads);
        self.changed.notify_all();
        loop {
            let is_missing = |state: &mut State| !state.done.contains(&number);
            let waiting = self.changed.wait_timeout_while(state, ASKED_EVERY, is_missing);
            let (mut now, waited) = waiting.unwrap_or_else(PoisonError::into_inner);
            if !waited.timed_out() {
                now.done.remove(&number);
                return ControlFlow::Continue(());
            }
            drop(now);
            if has_panicked() {
                return ControlFlow::Break(());
            }
            // Who breaks off here stops the workers by a flag of their own: what they have done until then still comes.
            let _ = take(None);
            state = self.state();
        }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
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

    #[test]
    fn breaking_off_ends_a_sweep_that_would_never_end() {
        for threads in [1, 2] {
            let mut taken = 0;
            let ended = map(
                threads,
                Work { count: u64::MAX >> 1, at_once: 1 },
                || |piece: Range<u64>| piece.start,
                |news| {
                    if let Some((_, start)) = news {
                        assert_eq!(start, taken);
                        taken += 1;
                    }
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
            let worker = || {
                let stop = &stop;
                move |piece: Range<u64>| {
                    // The second piece would never end by itself.
                    while piece.start == 1 && !stop.load(Ordering::Relaxed) {
                        thread::yield_now();
                    }
                    piece.start
                }
            };
            let ended = map(threads, Work { count: 1000, at_once: 1 }, worker, |news| {
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
