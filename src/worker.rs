//! Background tasks: [`Worker::submit`] takes a [`Task`], a callback receives its [`TaskReport`]s.
//!
//! Each task starts at once on its own thread; studies use fewer threads while other tasks run. A new task cancels the running task of the same
//! [`Slot`]. A panic in a task becomes a report. Each task ends with exactly one final report: `Ended` or `Failed`.
//!
//! Elapsed time is measured here, not in the model. This module depends on neither the terminal nor the file system.

pub mod clock;
mod reporter;
mod runs;
pub mod studies;

use std::error::Error;
use std::mem::Discriminant;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use clock::Clocks;
use reporter::Reporter;
use studies::{ResultVariant, SearchRequest, StudyRequest, StudyResult};

use cmra_engine::model::scene::Scene;
use cmra_studies::study::context::{Answer, CancelFlag, SharedCores};
use cmra_studies::study::parallel::cores;

pub use studies::SceneRun;

/// Minimum duration of a task after which the heap is trimmed; trimming takes about 1 ms.
const LONG: Duration = Duration::from_millis(100);
/// Minimum interval between trims after shorter tasks.
const WHILE: Duration = Duration::from_secs(5);

/// Input of a background thread: a run or a study.
#[derive(Clone, Debug)]
pub struct Task {
    /// Identifier, increasing with each task; its reports contain it.
    pub id: u64,
    /// Page that shows the result. Two pages with the same study have two tasks.
    pub page: Page,
    /// Number of threads, for work that can be divided.
    pub threads: usize,
    /// Limit of processor time, after which the task ends with its partial result; unlimited if `None`.
    pub budget: Option<Duration>,
    pub scene: Arc<Scene>,
    pub request: StudyRequest,
}

impl Task {
    /// Returns the slot of the result.
    pub fn slot(&self) -> Slot {
        self.request.slot(self.page)
    }
}

/// Number of a page that submits studies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Page(pub usize);

/// Destination of a result. A new task cancels the running task with the same destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// Run of the scene on the screen.
    Current,
    /// Pinned run with this letter.
    Pin(char),
    /// Study of a page.
    Study(Page, StudyKind),
}

/// Type of a study, without its request.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StudyKind(Discriminant<StudyRequest>, Option<Discriminant<SearchRequest>>);

impl StudyRequest {
    /// Returns the slot of the result on a page.
    pub fn slot(&self, page: Page) -> Slot {
        match self {
            Self::Run(run) => run.0,
            Self::Search(request) => {
                let search = Some(std::mem::discriminant(&**request));
                Slot::Study(page, StudyKind(std::mem::discriminant(self), search))
            }
            study => Slot::Study(page, StudyKind(std::mem::discriminant(study), None)),
        }
    }
}

#[derive(Clone, Debug)]
pub struct TaskReport {
    /// Identifier of the task.
    pub id: u64,
    pub body: ReportBody,
}

#[derive(Clone, Debug)]
pub enum ReportBody {
    Progress {
        progress: JobProgress,
        /// Time since the start of the task.
        elapsed: Duration,
    },
    /// Partial result of a running task.
    Part(Answer<StudyResult>),
    /// Final result, or the partial result of a stopped task; `None` if it had none.
    Ended(Option<Answer<StudyResult>>),
    /// Message for the user: the request was invalid, the thread could not start, or the task panicked.
    Failed(String),
}

impl ReportBody {
    /// Returns the final or partial result if it has this type.
    pub fn found<T: ResultVariant>(&self) -> Option<Answer<Arc<T>>> {
        match self {
            Self::Part(answer) | Self::Ended(Some(answer)) => {
                let report = Arc::clone(T::downcast(&answer.report)?);
                Some(Answer { report, reach: answer.reach, elapsed: answer.elapsed })
            }
            _ => None,
        }
    }

    /// Returns `true` for the final report of a task.
    pub fn is_last(&self) -> bool {
        matches!(self, Self::Ended(_) | Self::Failed(_))
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JobProgress {
    /// Simulated time reached, s; 0 at the start.
    Time(f64),
    Points(usize, usize),
}

/// Callback for reports, called on the threads of the tasks and on the submitting thread.
type Sink = dyn Fn(TaskReport) + Send + Sync;

/// Function that computes the result of a task.
type Make = fn(&Task, &Reporter<'_>) -> Result<StudyResult, Box<dyn Error>>;

/// Owner of the running tasks; dropping it cancels them.
pub struct Worker {
    shared: Arc<Shared>,
}

/// State shared by [`Worker`] and the threads of the tasks.
struct Shared {
    jobs: Mutex<Jobs>,
    cores: Arc<SharedCores>,
    clocks: Clocks,
    make: Make,
    sink: Box<Sink>,
}

#[derive(Default)]
struct Jobs {
    running: Vec<(u64, Slot, CancelFlag)>,
    /// Time at which free memory was last returned to the system.
    trimmed: Duration,
}

impl Jobs {
    /// Cancels the running tasks for which `is_selected` returns `true`.
    fn cancel(&self, is_selected: impl Fn(u64, Slot) -> bool) {
        for (_, _, flag) in self.running.iter().filter(|job| is_selected(job.0, job.1)) {
            flag.store(true);
        }
    }
}

impl Worker {
    /// Creates a worker without tasks; `sink` receives every report.
    pub fn spawn(sink: impl Fn(TaskReport) + Send + Sync + 'static) -> Self {
        Self::with(clock::system(), |task, reporter| task.request.make(&task.scene, reporter), sink)
    }

    /// Creates a worker with given clocks and a given function that computes tasks.
    fn with(clocks: Clocks, make: Make, sink: impl Fn(TaskReport) + Send + Sync + 'static) -> Self {
        let (jobs, cores) = (Mutex::default(), SharedCores::new(cores()));
        Self { shared: Arc::new(Shared { jobs, cores, clocks, make, sink: Box::new(sink) }) }
    }

    /// Starts a task and cancels the running task of its slot.
    pub fn submit(&self, task: Task) {
        let (id, slot, flag) = (task.id, task.slot(), CancelFlag::default());
        let mut jobs = self.shared.lock();
        jobs.cancel(|_, other| other == slot);
        jobs.running.push((id, slot, flag.clone()));
        drop(jobs);
        let shared = Arc::clone(&self.shared);
        let run = move || shared.run(&task, &flag);
        if let Err(error) = thread::Builder::new().name(format!("job {id}")).spawn(run) {
            self.shared.lock().running.retain(|job| job.0 != id);
            let text = format!("the system starts no more threads: {error}");
            (self.shared.sink)(TaskReport { id, body: ReportBody::Failed(text) });
        }
    }

    /// Cancels the task with this identifier.
    pub fn cancel(&self, id: u64) {
        self.shared.lock().cancel(|other, _| other == id);
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // The threads are not joined: a task that polls its cancel flag too rarely would delay the exit.
        self.shared.lock().cancel(|_, _| true);
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Jobs> {
        // No code that can panic runs under this lock: the state is valid even if the lock is poisoned.
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn run(&self, task: &Task, cancel: &CancelFlag) {
        let begun = (self.clocks.wall)();
        let send = |body| (self.sink)(TaskReport { id: task.id, body });
        // Each running task counts as a user of the cores: studies use fewer threads meanwhile.
        let user = self.cores.enter();
        let reporter = Reporter::new(self, task, &send, cancel);
        let body = reporter.finish(|| (self.make)(task, &reporter));
        drop(user);
        // The slot is free before the final report, whose receiver may submit the next task.
        self.lock().running.retain(|job| job.0 != task.id);
        send(body);
        let now = (self.clocks.wall)();
        let mut jobs = self.lock();
        if now.saturating_sub(begun) > LONG || now.saturating_sub(jobs.trimmed) > WHILE {
            jobs.trimmed = now;
            drop(jobs);
            trim_heap();
        }
    }
}

#[cfg(test)]
mod tests;

/// Returns the free pages of all threads to the system; about 1 ms for a heap of 100 MB.
///
/// The GNU C library keeps memory that a thread has freed between blocks in use. Without this call an hour of searches and sweeps occupies
/// ten times the memory that is in use.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "a call of the C library, which no crate wraps")]
fn trim_heap() {
    // SAFETY: `malloc_trim` locks the heap itself and does not move blocks in use.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Does nothing: other allocators return free memory themselves.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn trim_heap() {}
