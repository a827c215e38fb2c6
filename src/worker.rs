//! The background threads: tasks in, reports out.
//!
//! Each lane is a thread that does one task at a time, in the order of submission. A newer task of a slot replaces the older one of
//! that slot, running or waiting. A panic in a task is contained and reported. Time is measured here, not in the model. Knows nothing
//! of screens or files.
//!
//! Every task submitted gets exactly one last report: `Ended` or `Failed`.

pub mod clock;
mod runs;
pub mod studies;
pub mod study;

use std::collections::VecDeque;
use std::error::Error;
use std::mem::Discriminant;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use clock::Clock;
use studies::{Asked, Finding, Found};
use study::{Lane, Reporter};

use crate::model::scene::Scene;
use crate::study::context::CancelFlag;

pub use studies::SceneRun;

/// A task that took longer leaves so much free memory behind that giving it back is worth a millisecond; so do the many short ones of
/// a while.
const LONG: Duration = Duration::from_millis(100);
const WHILE: Duration = Duration::from_secs(5);

/// Work for a background thread: a run, or a study.
#[derive(Clone, Debug)]
pub struct Task {
    /// Counts up; reports carry it.
    pub id: u64,
    /// On how many threads, where the work can be divided.
    pub threads: usize,
    pub scene: Arc<Scene>,
    pub asked: Asked,
}

impl Task {
    /// Whose result it is.
    pub fn slot(&self) -> Slot {
        match &self.asked {
            Asked::Run(run) => run.0,
            study => Slot::Study(std::mem::discriminant(study)),
        }
    }
}

/// Whose result a task is: a newer task of a slot replaces an older one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// The scene on the screen.
    Current,
    /// A pinned run, by its letter.
    Pin(char),
    Study(Discriminant<Asked>),
}

#[derive(Clone, Debug)]
pub struct Report {
    /// That of the task.
    pub id: u64,
    pub body: ReportBody,
}

#[derive(Clone, Debug)]
pub enum ReportBody {
    Progress {
        progress: JobProgress,
        /// How long it has been running.
        elapsed: Duration,
    },
    /// It is still running, and this is what it has so far.
    Part(Found),
    /// It is done, or was cancelled and this is what it had; `None` where it had nothing.
    Ended {
        found: Option<Found>,
        /// Wall-clock time of the computation.
        took: Duration,
    },
    /// It could not start, or panicked; the text is for the message row.
    Failed(String),
}

impl ReportBody {
    /// The result, or the partial result, if it has this type.
    pub fn found<T: Finding>(&self) -> Option<Arc<T>> {
        match self {
            Self::Part(found) | Self::Ended { found: Some(found), .. } => T::of(found).cloned(),
            _ => None,
        }
    }

    /// Whether no further report of this task will follow.
    pub fn is_last(&self) -> bool {
        matches!(self, Self::Ended { .. } | Self::Failed(_))
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JobProgress {
    /// Simulated time reached, s; 0 when it has begun.
    Time(f64),
    Points(usize, usize),
}

/// Where reports go; called on the threads and on the submitting one.
type Sink = dyn Fn(Report) + Send + Sync;

/// Does a task.
type Make = fn(&Task, &Reporter<'_>) -> Result<Found, Box<dyn Error>>;

/// The owner of the threads, which end when this is dropped.
pub struct Worker {
    shared: Arc<Shared>,
}

/// The state shared by the threads and their owner.
struct Shared {
    lanes: [Queue; Lane::ALL.len()],
    clock: Clock,
    make: Make,
    sink: Box<Sink>,
}

#[derive(Default)]
struct Queue {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    waiting: VecDeque<Task>,
    running: Option<(u64, Slot, CancelFlag)>,
    closing: bool,
}

impl Queue {
    fn lock(&self) -> MutexGuard<'_, State> {
        // No code that can panic runs under this lock, so a poisoned one is still sound.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wait for a task and mark it as the running one; `None` when the owner is gone.
    fn next(&self) -> Option<(Task, CancelFlag)> {
        let mut state = self.lock();
        loop {
            if state.closing {
                return None;
            }
            if let Some(task) = state.waiting.pop_front() {
                let cancel = CancelFlag::default();
                state.running = Some((task.id, task.slot(), cancel.clone()));
                return Some((task, cancel));
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Cancel the running task if it is wanted so, and give the waiting one that is.
    fn take_out(&self, wanted: impl Fn(u64, Slot) -> bool) -> Option<Task> {
        let mut state = self.lock();
        if let Some((_, _, cancel)) = state.running.as_ref().filter(|it| wanted(it.0, it.1)) {
            cancel.store(true);
        }
        let at = state.waiting.iter().position(|task| wanted(task.id, task.slot()))?;
        state.waiting.remove(at)
    }
}

impl Worker {
    /// Start the threads; `sink` is given every report.
    pub fn spawn(sink: impl Fn(Report) + Send + Sync + 'static) -> std::io::Result<Self> {
        Self::with(clock::wall(), |task, reporter| task.asked.make(&task.scene, reporter), sink)
    }

    /// The same with another clock, by whose time progress and parts come, and another way to do a task.
    fn with(
        clock: Clock,
        make: Make,
        sink: impl Fn(Report) + Send + Sync + 'static,
    ) -> std::io::Result<Self> {
        let sink = Box::new(sink);
        let lanes = Default::default();
        let shared = Arc::new(Shared { lanes, clock, make, sink });
        for (lane, name) in Lane::ALL {
            let shared = Arc::clone(&shared);
            let serve = move || shared.serve(lane);
            thread::Builder::new().name(name.to_owned()).spawn(serve)?;
        }
        Ok(Self { shared })
    }

    /// Queue a task; the older one of its slot is cancelled. The scene on the screen goes before pinned ones.
    pub fn submit(&self, task: Task) {
        let slot = task.slot();
        let lane = &self.shared.lanes[task.asked.lane() as usize];
        let older = lane.take_out(|_, other| other == slot);
        let mut state = lane.lock();
        match slot {
            Slot::Current => state.waiting.push_front(task),
            _ => state.waiting.push_back(task),
        }
        drop(state);
        lane.changed.notify_one();
        self.shared.never_started(older);
    }

    /// Cancel the task of this number, running or waiting; others go on.
    pub fn cancel(&self, id: u64) {
        for lane in &self.shared.lanes {
            self.shared.never_started(lane.take_out(|other, _| other == id));
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        for lane in &self.shared.lanes {
            let mut state = lane.lock();
            state.closing = true;
            state.waiting.clear();
            if let Some((_, _, cancel)) = &state.running {
                cancel.store(true);
            }
            drop(state);
            // Not joined: a computation that asks too seldom must not hold up leaving.
            lane.changed.notify_one();
        }
    }
}

impl Shared {
    fn never_started(&self, task: Option<Task>) {
        if let Some(task) = task {
            let body = ReportBody::Ended { found: None, took: Duration::ZERO };
            (self.sink)(Report { id: task.id, body });
        }
    }

    fn serve(&self, lane: Lane) {
        let queue = &self.lanes[lane as usize];
        let mut given_back = (self.clock)();
        while let Some((task, cancel)) = queue.next() {
            let begun = (self.clock)();
            let send = |body| (self.sink)(Report { id: task.id, body });
            let reporter = Reporter::new(self, &task, &send, &cancel);
            let body = reporter.finish(|| (self.make)(&task, &reporter));
            // Free before the report: its receiver may submit at once.
            queue.lock().running = None;
            send(body);
            let now = (self.clock)();
            if now.saturating_sub(begun) > LONG || now.saturating_sub(given_back) > WHILE {
                give_back();
                given_back = now;
            }
        }
    }
}

#[cfg(test)]
mod tests;

/// Give back every free page, of all threads: a millisecond for a heap of 100 MB. GNU's C library keeps what a thread has freed
/// between pieces still in use: in an hour of searches and sweeps the process would grow to ten times of what it holds.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "a call of the C library, which no crate wraps")]
fn give_back() {
    // SAFETY: it takes the locks of the heap by itself, and what is in use stays where it is.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Nothing to do: these heaps do not grow so.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn give_back() {}
