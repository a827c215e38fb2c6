//! What the background threads have been asked to do.

use std::sync::Arc;
use std::time::Duration;

use crate::model::scene::Scene;

/// The run of the scene on the screen, while it has not ended.
#[derive(Clone, Debug)]
pub struct InFlight {
    /// Its number.
    pub id: u64,
    /// What it runs.
    pub scene: Arc<Scene>,
    /// Simulated time reached, s, and how long that took.
    pub reached: Option<(f64, Duration)>,
}

/// A study that has not ended.
#[derive(Clone, Debug)]
pub struct Running {
    /// Its number.
    pub id: u64,
    /// Of which scene.
    pub scene: Arc<Scene>,
    /// Points done and in all, once known.
    pub points: Option<(usize, usize)>,
}

impl Running {
    /// `: 12 of 30`; empty where nothing is known yet.
    pub fn counted(&self, of: &str, what: &str) -> String {
        let count =
            |(done, total): (usize, usize)| format!(": {} {of} {total}{what}", done.min(total));
        self.points.map_or_else(String::new, count)
    }
}

/// The tasks submitted, and how the last run ended.
#[derive(Clone, Debug, Default)]
pub struct Jobs {
    /// The highest number given so far.
    pub last_id: u64,
    /// Counts edits: a `RunDue` with an older number is out of date.
    pub serial: u64,
    /// The run of the scene on the screen.
    pub current: Option<InFlight>,
    /// The quiet time after the last edit is over and its result has not landed.
    pub overdue: bool,
    /// Tasks that have been running for so long that leaving asks first.
    pub long: Vec<u64>,
    /// The person was asked whether to leave while a long task runs.
    pub asked_to_quit: bool,
    /// Why the last run gave no result.
    pub failure: Option<String>,
    /// The last run was cancelled.
    pub cancelled: bool,
}

impl Jobs {
    /// A new number.
    pub fn next_id(&mut self) -> u64 {
        self.last_id += 1;
        self.last_id
    }
}
