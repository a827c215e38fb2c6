//! The background jobs: tasks in, reports out.
//!
//! Each task runs on a thread of its own, from its submission on; studies share the cores. A newer task of a slot replaces the older
//! one of that slot. A panic in a task is contained and reported. Time is measured here, not in the model. Does not depend on the
//! terminal or the file system.
//!
//! Every task submitted gets exactly one last report: `Ended` or `Failed`.

pub mod clock;
mod reporter;
mod runs;
pub mod studies;

use std::error::Error;
use std::mem::Discriminant;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use clock::Clock;
use reporter::Reporter;
use studies::{ResultVariant, SearchRequest, StudyRequest, StudyResult};

use cmra_engine::model::scene::Scene;
use cmra_studies::study::context::{Answer, CancelFlag, SharedCores};
use cmra_studies::study::parallel::cores;

pub use studies::SceneRun;

/// Duration of a task that leaves so much free memory behind that returning it is worth a millisecond; the same for the many short
/// tasks within `WHILE`.
const LONG: Duration = Duration::from_millis(100);
const WHILE: Duration = Duration::from_secs(5);

/// Work for a background thread: a run, or a study.
#[derive(Clone, Debug)]
pub struct Task {
    /// Counts up; reports carry it.
    pub id: u64,
    /// Page that shows the result: the same study of two pages is two tasks.
    pub page: Page,
    /// On how many threads, where the work can be divided.
    pub threads: usize,
    /// Time after which the task ends with the part done so far; `None`: runs to its end.
    pub budget: Option<Duration>,
    pub scene: Arc<Scene>,
    pub request: StudyRequest,
}

impl Task {
    /// Whose result it is.
    pub fn slot(&self) -> Slot {
        self.request.slot(self.page)
    }
}

/// Number of a page that asks for studies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Page(pub usize);

/// Whose result a task is: a newer task of a slot replaces an older one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// The scene on the screen.
    Current,
    /// A pinned run, by its letter.
    Pin(char),
    /// A study of a page.
    Study(Page, StudyKind),
}

/// Type of a study, without its request.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StudyKind(Discriminant<StudyRequest>, Option<Discriminant<SearchRequest>>);

impl StudyRequest {
    /// Whose result it is when a page asks for it.
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
        /// How long it has been running.
        elapsed: Duration,
    },
    /// Partial result of a running task.
    Part(Answer<StudyResult>),
    /// Final result, or the partial result of a stopped task; `None` if it had none.
    Ended(Option<Answer<StudyResult>>),
    /// Failure to start, or a panic; the text is for the message row.
    Failed(String),
}

impl ReportBody {
    /// The result, or the partial result, if it has this type.
    pub fn found<T: ResultVariant>(&self) -> Option<Answer<Arc<T>>> {
        match self {
            Self::Part(answer) | Self::Ended(Some(answer)) => {
                let report = Arc::clone(T::downcast(&answer.report)?);
                Some(Answer { report, reach: answer.reach, elapsed: answer.elapsed })
            }
            _ => None,
        }
    }

    /// Whether no further report of this task will follow.
    pub fn is_last(&self) -> bool {
        matches!(self, Self::Ended(_) | Self::Failed(_))
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JobProgress {
    /// Simulated time reached, s; 0 when it has begun.
    Time(f64),
    Points(usize, usize),
}

/// Where reports go; called on the threads and on the submitting one.
type Sink = dyn Fn(TaskReport) + Send + Sync;

/// Does a task.
type Make = fn(&Task, &Reporter<'_>) -> Result<StudyResult, Box<dyn Error>>;

/// The owner of the jobs, which are cancelled when this is dropped.
pub struct Worker {
    shared: Arc<Shared>,
}

/// The state shared by the threads and their owner.
struct Shared {
    jobs: Mutex<Jobs>,
    cores: Arc<SharedCores>,
    clock: Clock,
    make: Make,
    sink: Box<Sink>,
}

#[derive(Default)]
struct Jobs {
    running: Vec<(u64, Slot, CancelFlag)>,
    /// When free memory was returned to the system last.
    trimmed: Duration,
}

impl Jobs {
    /// Cancels the jobs that are selected.
    fn cancel(&self, is_selected: impl Fn(u64, Slot) -> bool) {
        for (_, _, flag) in self.running.iter().filter(|job| is_selected(job.0, job.1)) {
            flag.store(true);
        }
    }
}

impl Worker {
    /// Start without a job; `sink` is given every report.
    pub fn spawn(sink: impl Fn(TaskReport) + Send + Sync + 'static) -> Self {
        Self::with(clock::wall(), |task, reporter| task.request.make(&task.scene, reporter), sink)
    }

    /// Builds a worker with another clock, which times progress and partial results, and another function for tasks.
    fn with(clock: Clock, make: Make, sink: impl Fn(TaskReport) + Send + Sync + 'static) -> Self {
        let (jobs, cores) = (Mutex::default(), SharedCores::new(cores()));
        Self { shared: Arc::new(Shared { jobs, cores, clock, make, sink: Box::new(sink) }) }
    }

    /// Starts a task; the older one of its slot is cancelled.
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

    /// Cancel the task of this number; others go on.
    pub fn cancel(&self, id: u64) {
        self.shared.lock().cancel(|other, _| other == id);
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Not joined: a computation that asks too seldom must not hold up leaving.
        self.shared.lock().cancel(|_, _| true);
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Jobs> {
        // No code that can panic runs under this lock, so a poisoned one is still sound.
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn run(&self, task: &Task, cancel: &CancelFlag) {
        let begun = (self.clock)();
        let send = |body| (self.sink)(TaskReport { id: task.id, body });
        // The run of the edited scene takes a core of its own from the studies.
        let user = self.cores.enter();
        let reporter = Reporter::new(self, task, &send, cancel);
        let body = reporter.finish(|| (self.make)(task, &reporter));
        drop(user);
        // Free before the report: its receiver may submit at once.
        self.lock().running.retain(|job| job.0 != task.id);
        send(body);
        let now = (self.clock)();
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

/// Give back every free page, of all threads: a millisecond for a heap of 100 MB. GNU's C library keeps what a thread has freed
/// between pieces still in use: in an hour of searches and sweeps the process would grow to ten times of what it holds.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "a call of the C library, which no crate wraps")]
fn trim_heap() {
    // SAFETY: it takes the locks of the heap by itself, and what is in use stays where it is.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Nothing to do: these heaps do not grow so.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn trim_heap() {}
