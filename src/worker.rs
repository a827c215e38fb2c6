//! The background thread: jobs in, reports out.
//!
//! One job runs at a time. A job for a slot replaces the older one of the same slot, running or waiting. A panic in a job is
//! contained and reported. Time is measured here, not in the model. Knows nothing of screens or files.
//!
//! Every job submitted gets exactly one last report: `Done`, `Failed` or `Cancelled`.

pub mod battery;
pub mod cache;
pub mod clock;
mod job;
pub mod quiet;
pub mod searches;
pub mod studies;
pub mod sweeps;

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use crate::model::impact::window::Window;
use crate::model::run::Run;
use crate::model::scene::Scene;
use crate::model::simulate::{self, Settings};

/// Work for the background thread.
#[derive(Clone, Debug)]
pub struct Job {
    /// Counts up; reports carry it.
    pub id: u64,
    /// Whose result it is.
    pub slot: Slot,
    /// What to run.
    pub scene: Arc<Scene>,
}

/// Whose result a job is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// The scene on the screen.
    Current,
    /// A pinned run, by its letter.
    Pin(char),
}

/// What the background thread says.
#[derive(Clone, Debug)]
pub struct Report {
    /// The job.
    pub id: u64,
    /// Its slot.
    pub slot: Slot,
    /// What about it.
    pub body: ReportBody,
}

/// What a report says.
#[derive(Clone, Debug)]
pub enum ReportBody {
    /// It has begun and will take a moment (a job done within 20 ms does not say so).
    Started,
    /// It is still running and has reached this time, s (sent at most twice a second).
    Progress {
        /// Simulated time reached, s.
        t_s: f64,
        /// How long it has been running.
        elapsed: Duration,
    },
    /// It is still running, and this is what it has so far (at most twice a second; the scene on the screen only).
    Part(Arc<Run>),
    /// It is done.
    Done {
        /// The result.
        run: Arc<Run>,
        /// Wall-clock time of the computation.
        took: Duration,
    },
    /// It could not start, or panicked; the text is for the message row.
    Failed(String),
    /// It was cancelled; what it had is kept.
    Cancelled {
        /// The partial result, if the job had begun.
        partial: Option<Arc<Run>>,
    },
}

impl ReportBody {
    /// Whether no further report of this job will follow.
    pub fn is_last(&self) -> bool {
        match self {
            Self::Started | Self::Progress { .. } | Self::Part(_) => false,
            Self::Done { .. } | Self::Failed(_) | Self::Cancelled { .. } => true,
        }
    }
}

/// Computes one scene, asking the observer after every step and showing it what there is so far.
type Compute = dyn Fn(&Arc<Scene>, Settings, simulate::Observer<'_>, &Window) -> Result<Run, String>
    + Send
    + Sync;

/// Where reports go; called on the worker's thread and on the submitting one.
type Sink = dyn Fn(Report) + Send + Sync;

/// The worker: owns its thread, which ends when this is dropped.
pub struct Worker {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

/// What the thread and its owner share.
struct Shared {
    queue: Mutex<Queue>,
    changed: Condvar,
    sink: Box<Sink>,
}

#[derive(Default)]
struct Queue {
    waiting: VecDeque<Job>,
    running: Option<(Slot, Arc<AtomicBool>)>,
    closing: bool,
}

impl Worker {
    /// Start the thread; `sink` is given every report.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn(sink: impl Fn(Report) + Send + Sync + 'static) -> std::io::Result<Self> {
        Self::spawn_with(sink, |scene, settings, observer, window| {
            simulate::simulate_openly(scene, &settings, observer, window)
                .map_err(|error| error.to_string())
        })
    }

    /// Start the thread with another computation than the simulation.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn_with(
        sink: impl Fn(Report) + Send + Sync + 'static,
        compute: impl Fn(&Arc<Scene>, Settings, simulate::Observer<'_>, &Window) -> Result<Run, String>
        + Send
        + Sync
        + 'static,
    ) -> std::io::Result<Self> {
        let shared = Arc::new(Shared {
            queue: Mutex::new(Queue::default()),
            changed: Condvar::new(),
            sink: Box::new(sink),
        });
        let for_thread = Arc::clone(&shared);
        let thread = thread::Builder::new()
            .name("worker".to_owned())
            .spawn(move || for_thread.serve(&compute))?;
        Ok(Self { shared, thread: Some(thread) })
    }

    /// Queue a job. The scene on the screen goes before pinned ones; an older job of the same slot is cancelled.
    pub fn submit(&self, job: Job) {
        let mut queue = self.shared.lock();
        let older = queue
            .waiting
            .iter()
            .position(|waiting| waiting.slot == job.slot)
            .and_then(|at| queue.waiting.remove(at));
        if let Some((slot, cancel)) = &queue.running
            && *slot == job.slot
        {
            cancel.store(true, Ordering::Relaxed);
        }
        match job.slot {
            Slot::Current => queue.waiting.push_front(job),
            Slot::Pin(_) => queue.waiting.push_back(job),
        }
        drop(queue);
        self.shared.changed.notify_one();
        if let Some(older) = older {
            self.shared.cancelled_unstarted(&older);
        }
    }

    /// Cancel the running job and all that wait.
    pub fn cancel(&self) {
        let mut queue = self.shared.lock();
        let dropped = std::mem::take(&mut queue.waiting);
        if let Some((_, cancel)) = &queue.running {
            cancel.store(true, Ordering::Relaxed);
        }
        drop(queue);
        for job in &dropped {
            self.shared.cancelled_unstarted(job);
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let mut queue = self.shared.lock();
        queue.closing = true;
        queue.waiting.clear();
        if let Some((_, cancel)) = &queue.running {
            cancel.store(true, Ordering::Relaxed);
        }
        drop(queue);
        self.shared.changed.notify_one();
        // Not joined: a computation that asks its observer too seldom must not hold up leaving.
        drop(self.thread.take());
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Queue> {
        // No code that can panic runs under this lock, so a poisoned one is still sound.
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn report(&self, job: &Job, body: ReportBody) {
        (self.sink)(Report { id: job.id, slot: job.slot, body });
    }

    fn cancelled_unstarted(&self, job: &Job) {
        self.report(job, ReportBody::Cancelled { partial: None });
    }

    fn serve(&self, compute: &Compute) {
        let mut cache = cache::Cache::default();
        while let Some((job, cancel)) = self.next_job() {
            let body = match cache.find(&job.scene) {
                Some((run, took)) => ReportBody::Done { run, took },
                None => self.run(&job, &cancel, compute, &mut cache),
            };
            // Free before the report: whoever acts on it may submit at once.
            self.lock().running = None;
            self.report(&job, body);
        }
    }

    /// Wait for a job and mark it as the running one; `None` when the owner is gone.
    fn next_job(&self) -> Option<(Job, Arc<AtomicBool>)> {
        let mut queue = self.lock();
        loop {
            if queue.closing {
                return None;
            }
            if let Some(job) = queue.waiting.pop_front() {
                let cancel = Arc::new(AtomicBool::new(false));
                queue.running = Some((job.slot, Arc::clone(&cancel)));
                return Some((job, cancel));
            }
            queue = self.changed.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn run(
        &self,
        job: &Job,
        cancel: &AtomicBool,
        compute: &Compute,
        cache: &mut cache::Cache,
    ) -> ReportBody {
        let mut pulse = job::Pulse::start();
        let window = Window::default();
        let mut observer = |t_s: f64| {
            if cancel.load(Ordering::Relaxed) {
                return ControlFlow::Break(());
            }
            if let Some(run) = window.take() {
                pulse.part_came();
                self.report(job, ReportBody::Part(Arc::new(run)));
            }
            if let Some(body) = pulse.beat(t_s) {
                self.report(job, body);
            }
            if job.slot == Slot::Current && pulse.part_is_due() {
                window.ask();
            }
            ControlFlow::Continue(())
        };
        let settings = Settings::default();
        let (ended, took) =
            job::contained(|| compute(&job.scene, settings, &mut observer, &window));
        match ended {
            Err(text) => ReportBody::Failed(text),
            Ok(run) => {
                let cut_short = run.end == crate::model::run::EndReason::Cancelled;
                let run = Arc::new(run);
                if cut_short {
                    return ReportBody::Cancelled { partial: Some(run) };
                }
                // One that was stopped while its error was estimated is not worth keeping.
                if !cancel.load(Ordering::Relaxed) {
                    cache.keep(Arc::clone(&run), took);
                }
                ReportBody::Done { run, took }
            }
        }
    }
}

#[cfg(test)]
mod tests;
