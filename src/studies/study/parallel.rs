//! The ordered parallel map of all studies: pieces go out in order, results come back in order, on however many threads.
//!
//! A thread that is free takes the next piece. A few pieces a thread are out at most, so memory stays constant. The result of a
//! piece depends on the piece only.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Sender};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

/// Pieces that are handed out, per thread, before the first of them is taken.
const OUT: u64 = 8;

/// Time between two calls of `take` while no result is ready.
const ASKED_EVERY: Duration = Duration::from_millis(20);

/// The cores that studies running at once have in common.
#[derive(Debug)]
pub struct SharedCores {
    cores: usize,
    users: Mutex<usize>,
    /// Wakes the threads that wait for a greater share, or for the end of their work.
    changed: Condvar,
}

/// A user of the cores; stops counting when it is dropped.
#[derive(Debug)]
pub struct CoreUser(Arc<SharedCores>);

impl SharedCores {
    /// Cores without a user.
    pub fn new(cores: usize) -> Arc<Self> {
        Arc::new(Self { cores, users: Mutex::new(0), changed: Condvar::new() })
    }

    /// Counts one more user.
    pub fn enter(self: &Arc<Self>) -> CoreUser {
        *self.lock() += 1;
        CoreUser(Arc::clone(self))
    }

    /// Number of users.
    fn lock(&self) -> MutexGuard<'_, usize> {
        // No code that can panic runs under this lock, so a poisoned one is still sound.
        self.users.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Threads of each of a number of users, >= 1.
    fn share(&self, users: usize) -> usize {
        (self.cores / users.max(1)).max(1)
    }

    /// Blocks a thread, counted from zero, while its user's share does not include it and the work is not over.
    fn wait(&self, index: usize, is_over: &AtomicBool) {
        let surplus =
            |users: &mut usize| index >= self.share(*users) && !is_over.load(Ordering::Relaxed);
        drop(self.changed.wait_while(self.lock(), surplus));
    }
}

impl Drop for CoreUser {
    fn drop(&mut self) {
        *self.0.lock() -= 1;
        self.0.changed.notify_all();
    }
}

/// Function that returns the time since a fixed instant.
pub type Clock = Arc<dyn Fn() -> Duration + Send + Sync>;

/// Processor time of the pieces of a study, which run on threads of their own.
pub struct WorkClock {
    /// Processor time of the calling thread, and of the process.
    clocks: [Clock; 2],
    state: Mutex<WorkTime>,
}

#[derive(Debug, Default)]
struct WorkTime {
    /// Processor time of the finished pieces.
    spent: Duration,
    /// Number of running pieces.
    running: usize,
    /// Processor time of the process when the last piece began or ended.
    since: Duration,
}

impl WorkClock {
    /// Creates a clock that reads the processor time of the calling thread and that of the process.
    pub fn new(thread: Clock, process: Clock) -> Arc<Self> {
        Arc::new(Self { clocks: [thread, process], state: Mutex::default() })
    }

    fn change(&self, by: impl FnOnce(&mut WorkTime)) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        by(&mut state);
        state.since = (self.clocks[1])();
    }

    /// Does a piece on the calling thread and counts its time.
    fn count<T>(&self, piece: impl FnOnce() -> T) -> T {
        self.change(|state| state.running += 1);
        let begun = (self.clocks[0])();
        let result = piece();
        let took = (self.clocks[0])().saturating_sub(begun);
        self.change(|state| {
            state.running -= 1;
            state.spent += took;
        });
        result
    }

    /// Returns the processor time of all pieces so far. A thread cannot read the time of another one, so a running piece counts with the
    /// time of the whole process since it began.
    pub fn spent(&self) -> Duration {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let running = (self.clocks[1])().saturating_sub(state.since);
        state.spent + if state.running > 0 { running } else { Duration::ZERO }
    }
}

impl fmt::Debug for WorkClock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.state.fmt(f)
    }
}

/// Number of threads of a study: fixed, or at most its share of the cores at any moment.
#[derive(Clone, Debug)]
pub struct Threads {
    count: usize,
    cores: Option<Arc<SharedCores>>,
    clock: Option<Arc<WorkClock>>,
}

impl Threads {
    /// At most this many threads, and at most the share of the cores.
    pub fn shared(count: usize, cores: &Arc<SharedCores>) -> Self {
        Self { count, cores: Some(Arc::clone(cores)), clock: None }
    }

    /// At most this many threads.
    #[must_use]
    pub fn at_most(self, count: usize) -> Self {
        Self { count: self.count.min(count), ..self }
    }

    /// Counts the processor time of the pieces on a clock.
    #[must_use]
    pub fn timed(self, clock: &Arc<WorkClock>) -> Self {
        Self { clock: Some(Arc::clone(clock)), ..self }
    }

    /// Does a piece, and counts its time if there is a clock.
    fn counted<T>(&self, piece: impl FnOnce() -> T) -> T {
        match &self.clock {
            Some(clock) => clock.count(piece),
            None => piece(),
        }
    }

    /// Threads at most.
    #[cfg(test)]
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// Blocks a surplus thread, counted from zero; the first always works.
    fn wait(&self, index: usize, is_over: &AtomicBool) {
        if let Some(cores) = &self.cores {
            cores.wait(index, is_over);
        }
    }

    /// Says that the work is over, and wakes the threads that wait.
    fn end(&self, is_over: &AtomicBool) {
        // Set under the lock: a thread that has just found the work unfinished waits already.
        let users = self.cores.as_ref().map(|cores| cores.lock());
        is_over.store(true, Ordering::Relaxed);
        drop(users);
        if let Some(cores) = &self.cores {
            cores.changed.notify_all();
        }
    }
}

impl From<usize> for Threads {
    fn from(count: usize) -> Self {
        Self { count, cores: None, clock: None }
    }
}

/// Ends the work when it is dropped, also by a panic.
struct EndOnDrop<'a>(&'a Threads, &'a AtomicBool);

impl Drop for EndOnDrop<'_> {
    fn drop(&mut self) {
        self.0.end(self.1);
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

/// Returns the number of cores.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Does work on a number of threads, >= 1: fewer where other studies share the cores. Each gets a worker of its own from `worker`, and
/// `take` is given every result in the order of the points. It is also called regularly (`None`) while no result is ready, so that a
/// study can be cancelled during a long piece. `Break` ends the work; running pieces are dropped.
pub fn map<T: Send, W: FnMut(Range<u64>) -> T>(
    allowed: &Threads,
    work: Work,
    worker: impl Fn() -> W + Sync,
    mut take: impl FnMut(Option<(Range<u64>, T)>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let count = work.count.div_ceil(work.at_once);
    let threads = allowed.count.max(1).min(usize::try_from(count).unwrap_or(usize::MAX));
    let out = OUT * threads as u64;
    let is_over = AtomicBool::new(false);
    let (hand_out, next) = mpsc::channel();
    for number in 0..count.min(out) {
        let _ = hand_out.send(number);
    }
    let next = Mutex::new(next);
    let serve = |index: usize, done: Sender<(u64, T)>| {
        let mut make = worker();
        loop {
            allowed.wait(index, &is_over);
            let number = next.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let Ok(number) = number else { return };
            let result = allowed.counted(|| make(work.piece(number)));
            if done.send((number, result)).is_err() {
                return;
            }
        }
    };
    thread::scope(|scope| {
        let (done, told) = mpsc::channel();
        // Closed with this scope, also when a panic ends it: that ends the threads.
        let hand_out = hand_out;
        let _over = EndOnDrop(allowed, &is_over);
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

    /// A thread's clock shows a second more with each look at it; that of the process is read while a piece runs.
    #[test]
    fn the_time_of_pieces_on_other_threads_is_counted() {
        let looks = Arc::new(Mutex::new(0_u64));
        let thread: Clock = Arc::new(move || {
            let mut looks = looks.lock().unwrap();
            *looks += 1;
            Duration::from_secs(*looks)
        });
        let clock = WorkClock::new(thread, Arc::new(|| Duration::from_secs(5)));
        let threads = Threads::from(1).timed(&clock);
        let worker = || |piece: Range<u64>| piece.count();
        let take = |_: Option<(Range<u64>, usize)>| ControlFlow::Continue(());
        assert!(map(&threads, Work { count: 7, at_once: 1 }, worker, take).is_continue());
        assert_eq!(clock.spent(), Duration::from_secs(7));
        let process: Clock = Arc::new(|| Duration::from_secs(5));
        let clock = WorkClock::new(Arc::new(|| Duration::ZERO), process);
        clock.count(|| {
            clock.state.lock().unwrap().since = Duration::from_secs(2);
            assert_eq!(clock.spent(), Duration::from_secs(3));
        });
        assert_eq!(clock.spent(), Duration::ZERO);
    }

    #[test]
    fn studies_at_once_share_the_cores_and_each_has_a_thread() {
        let cores = SharedCores::new(4);
        let threads = Threads::shared(4, &cores);
        let mut users = Vec::new();
        for expected in [4, 2, 1, 1, 1] {
            users.push(cores.enter());
            assert_eq!(cores.share(*cores.lock()), expected, "{} users", users.len());
        }
        users.truncate(1);
        assert_eq!((cores.share(*cores.lock()), threads.clone().at_most(3).count), (4, 3));
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

    #[test]
    fn a_surplus_thread_goes_on_when_another_study_ends() {
        let cores = SharedCores::new(2);
        let threads = Threads::shared(2, &cores);
        let _own = cores.enter();
        let mut other = Some(cores.enter());
        let is_over = AtomicBool::new(false);
        thread::scope(|scope| {
            let (done, told) = mpsc::channel();
            let (threads, is_over) = (&threads, &is_over);
            let waits = |index: usize| {
                let done = done.clone();
                scope.spawn(move || {
                    threads.wait(index, is_over);
                    let _ = done.send(index);
                });
            };
            waits(0);
            assert_eq!(told.recv(), Ok(0), "the first thread always works");
            waits(1);
            assert_eq!(told.try_recv(), Err(mpsc::TryRecvError::Empty));
            other.take();
            assert_eq!(told.recv(), Ok(1));
            waits(2);
            threads.end(is_over);
            assert_eq!(told.recv(), Ok(2));
        });
    }
}
