//! The tasks of the background threads.

use std::sync::Arc;
use std::time::Duration;

use crate::model::scene::Scene;
use crate::tui::pages::Tab;
use crate::worker::study::Study;

/// A task that has not ended.
#[derive(Clone, Debug)]
pub struct Running {
    pub id: u64,
    /// The tab that requested it.
    pub tab: Tab,
    pub scene: Arc<Scene>,
    pub study: Arc<dyn Study>,
    /// Points done and in all, once known.
    pub points: Option<(usize, usize)>,
    /// Of a run the simulated time reached, s, once known.
    pub reached_s: Option<f64>,
    /// Time gone when that was reported.
    pub elapsed: Duration,
}

impl Running {
    /// `: 12 of 30`; empty where nothing is known yet.
    pub fn counted(&self, of: &str, what: &str) -> String {
        let count =
            |(done, total): (usize, usize)| format!(": {} {of} {total}{what}", done.min(total));
        self.points.map_or_else(String::new, count)
    }

    /// The time left, by the points done so far.
    pub fn left(&self) -> Option<Duration> {
        let (done, total) = self.points.filter(|points| points.0 > 0)?;
        let share = total.saturating_sub(done) as f64 / done as f64;
        Duration::try_from_secs_f64(self.elapsed.as_secs_f64() * share).ok()
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
    pub current: Option<Running>,
    pub studies: Vec<Running>,
    /// The quiet time after the last edit is over and its result has not landed.
    pub overdue: bool,
    /// Tasks that have been running for so long that leaving asks first.
    pub long: Vec<u64>,
    /// The person was asked whether to leave while a long task runs.
    pub quit_confirmation_shown: bool,
    /// Why the last run gave no result.
    pub failure: Option<String>,
}

impl Jobs {
    pub fn next_id(&mut self) -> u64 {
        self.last_id += 1;
        self.last_id
    }

    /// The study of this type that has not ended, with what it was asked.
    pub fn study<S: Study>(&self) -> Option<(&Running, &S)> {
        self.studies.iter().find_map(|running| Some((running, running.study.of()?)))
    }

    /// Forget the study of this type: nothing it reports is shown any more.
    pub fn take<S: Study>(&mut self) -> Option<Running> {
        let at = self.studies.iter().position(|running| running.study.of::<S>().is_some())?;
        Some(self.studies.remove(at))
    }

    /// The study of this type that has not ended.
    pub fn running<S: Study>(&self) -> Option<&Running> {
        self.study::<S>().map(|(running, _)| running)
    }

    /// Whether a study of this type is under way for a scene.
    pub fn is_coming<S: Study>(&self, scene: &Scene) -> bool {
        self.running::<S>().is_some_and(|running| *running.scene == *scene)
    }
}
