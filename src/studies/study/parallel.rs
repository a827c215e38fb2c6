//! The ordered parallel map of all studies: pieces go out in order, results come back in order, on however many threads.
//!
//! A thread that is free takes the next piece. A few pieces a thread are out at most, so memory stays constant. The result of a
//! piece depends on the piece only.

use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

/// Pieces that are handed out, per thread, before the first of them is taken.
const OUT: u64 = 8;

/// Time between two calls of `take` while no result is ready.
const ASKED_EVERY: Duration = Duration::from_millis(20);

/// Time between two checks of a paused thread whether it may go on.
const PAUSE: Duration = Duration::from_millis(5);

/// The cores that studies running at once have in common.
#[derive(Debug)]
pub struct SharedCores {
    cores: usize,
    users: AtomicUsize,
}

/// A user of the cores; stops counting when it is dropped.
#[derive(Debug)]
pub struct CoreUser(Arc<SharedCores>);

impl SharedCores {
    /// Cores without a user.
    pub fn new(cores: usize) -> Arc<Self> {
        Arc::new(Self { cores, users: AtomicUsize::new(0) })
    }

    /// Counts one more user.
    pub fn enter(self: &Arc<Self>) -> CoreUser {
        self.users.fetch_add(1, Ordering::Relaxed);
        CoreUser(Arc::clone(self))
    }

    /// Threads of each user at present, >= 1.
    fn share(&self) -> usize {
        (self.cores / self.users.load(Ordering::Relaxed).max(1)).max(1)
    }
}

impl Drop for CoreUser {
    fn drop(&mut self) {
        self.0.users.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Number of threads of a study: fixed, or at most its share of the cores at any moment.
#[derive(Clone, Debug)]
pub struct Threads {
    count: usize,
    cores: Option<Arc<SharedCores>>,
}

impl Threads {
    /// At most this many threads, and at most the share of the cores.
    pub fn shared(count: usize, cores: &Arc<SharedCores>) -> Self {
        Self { count, cores: Some(Arc::clone(cores)) }
    }

    /// At most this many threads.
    #[must_use]
    pub fn at_most(self, count: usize) -> Self {
        Self { count: self.count.min(count), ..self }
    }

    /// Threads that may work at present.
    pub(crate) fn now(&self) -> usize {
        self.cores.as_ref().map_or(self.count, |cores| cores.share().min(self.count))
    }
}

impl From<usize> for Threads {
    fn from(count: usize) -> Self {
        Self { count, cores: None }
    }
}

/// Sets a flag when it is dropped, also by a panic.
struct SetOnDrop<'a>(&'a AtomicBool);

impl Drop for SetOnDrop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

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

/// Does work on a number of threads, >= 1: fewer where other studies share the cores. Each gets a worker of its own from `worker`, and `take` is given every result in the
/// order of the points. It is also called regularly (`None`) while no result is ready, so that a study can be cancelled during a long
/// piece. `Break` ends the work; running pieces are dropped.
pub fn map<T: Send, W: FnMut(Range<u64>) -> T>(
    allowed: &Threads,
    work: Work,
    worker: impl Fn() -> W + Sync,
    mut take: impl FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let count = work.count.div_ceil(work.at_once);
    let threads = u64::try_from(allowed.count.max(1)).unwrap_or(1).min(count);
    let out = OUT * threads;
    let is_over = AtomicBool::new(false);
    let (hand_out, next) = mpsc::channel();
    for number in 0..count.min(out) {
        let _ = hand_out.send(number);
    }
    let next = Mutex::new(next);
    let serve = |index: u64, done: Sender<(u64, T)>| {
        let mut make = worker();
        loop {
            // The first thread always works.
            while index > 0 && index >= allowed.now() as u64 && !is_over.load(Ordering::Relaxed) {
                thread::sleep(PAUSE);
            }
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
        let _over = SetOnDrop(&is_over);
        let start = |index| {
            let (serve, done) = (&serve, done.clone());
            thread::Builder::new().spawn_scoped(scope, move || serve(index, done)).ok()
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
                let ended =
                    map(&threads.into(), Work { count: points, at_once: 10 }, worker, |news| {
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
    fn studies_at_once_share_the_cores_and_each_has_a_thread() {
        let cores = SharedCores::new(4);
        let threads = Threads::shared(4, &cores);
        let mut users = Vec::new();
        for expected in [4, 2, 1, 1, 1] {
            users.push(cores.enter());
            assert_eq!(threads.now(), expected, "{} users", users.len());
        }
        users.truncate(1);
        assert_eq!((threads.now(), threads.clone().at_most(3).now()), (4, 3));
        // A paused thread does not keep the work from ending.
        users.push(cores.enter());
        users.push(cores.enter());
        let worker = || |piece: Range<u64>| piece.count();
        let mut pieces = 0;
        let ended = map(&threads, Work { count: 100, at_once: 1 }, worker, |news| {
            pieces += usize::from(news.is_some());
            ControlFlow::Continue(())
        });
        assert!(ended.is_continue() && pieces == 100);
    }
}
