//! The background thread: jobs in, reports out.
//!
//! One job runs at a time. A job for a slot replaces the older one of the same slot, running or waiting. A panic in a job is
//! contained and reported. Time is measured here, not in the model.

use std::sync::Arc;
use std::time::Duration;

use crate::model::run::Run;
use crate::model::scene::Scene;

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
    /// It has begun.
    Started,
    /// It is still running and has reached this time, s (sent at most twice a second).
    Progress {
        /// Simulated time reached, s.
        t_s: f64,
    },
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
