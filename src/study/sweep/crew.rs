//! The threads of a sweep: pieces go out in order, results come back in order, however many hands there are.
//!
//! Thread t of T does the pieces t, t + T, ... and keeps at most a few results waiting, so memory stays constant; the caller
//! takes them in turn. The result of a piece depends on nothing but the piece.

use std::ops::{ControlFlow, Range};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

/// Results of one thread that may wait to be taken.
const WAITING: usize = 8;

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
        thread::scope(|scope| {
            let mut lines = Vec::new();
            for first in 0..threads {
                let (send, receive) = sync_channel(WAITING);
                let stride = usize::try_from(threads).unwrap_or(1);
                let work = move || {
                    let mut worker = hire();
                    for number in (first..pieces.count).step_by(stride) {
                        // Nobody takes any more: the work was broken off.
                        if send.send(worker(pieces.at(number))).is_err() {
                            return;
                        }
                    }
                };
                // A system that has no more threads to give leaves the rest of the work to this one.
                let started = thread::Builder::new().spawn_scoped(scope, work);
                lines.push(started.ok().map(|_| receive));
            }
            let mut own = None;
            for (number, line) in (0..pieces.count).zip(lines.iter().cycle()) {
                let result = match line {
                    Some(line) => wait(line, hear),
                    None => Some(own.get_or_insert_with(hire)(pieces.at(number))),
                };
                // A thread that ended without its result panicked; leaving the scope passes that on.
                let Some(result) = result else { break };
                if hear(Some((pieces.at(number), result))).is_break() {
                    drop(lines);
                    return ControlFlow::Break(());
                }
            }
            ControlFlow::Continue(())
        })
    }
}

/// Whoever takes the results, and is asked in between.
type Hear<'h, T> = &'h mut dyn FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>;

/// The next result of a thread; `None` when it ends without one. Who is asked in between stops the workers by a flag of their own:
/// what they have done until then still comes.
fn wait<T>(line: &Receiver<T>, hear: Hear<'_, T>) -> Option<T> {
    loop {
        match line.recv_timeout(ASKED_EVERY) {
            Ok(result) => return Some(result),
            Err(RecvTimeoutError::Disconnected) => return None,
            Err(RecvTimeoutError::Timeout) => {
                let _ = hear(None);
            }
        }
    }
}

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
