//! The tasks that have not ended, and what has been found.

use std::sync::Arc;
use std::time::Duration;

use crate::tui::keymap::{Action, Tab};
use crate::worker::studies::{RequestVariant, ResultVariant, StudyRequest};
use crate::worker::{Page, ReportBody};
use cmra_engine::model::scene::Scene;
use cmra_studies::study::context::{Answer, Reach};

/// Cells of the bar of a study's progress, and the time from which on it is shown.
const GAUGE: usize = 8;
const GAUGE_FROM: Duration = Duration::from_secs(1);

/// A task that has not ended.
#[derive(Clone, Debug)]
pub struct Running {
    pub id: u64,
    /// The tab that requested it.
    pub tab: Tab,
    /// Whether opening its page started it.
    pub is_look: bool,
    pub scene: Arc<Scene>,
    pub request: StudyRequest,
    /// Points done and in all, once known.
    pub points: Option<(usize, usize)>,
    /// Elapsed time at the last report of progress, once known.
    pub elapsed: Option<Duration>,
    /// Simulated time reached by a run, s, and the elapsed time at its report, once known.
    pub reached: Option<(f64, Duration)>,
}

impl Running {
    fn is_in_slot(&self, tab: Tab, request: &StudyRequest) -> bool {
        let slot = |tab: Tab, request: &StudyRequest| request.slot(Page(tab.index()));
        slot(self.tab, &self.request) == slot(tab, request)
    }

    /// `: 12 of 30 [###.....] 20 s left`; empty where nothing is known yet.
    pub fn counted(&self, of: &str, what: &str) -> String {
        let Some((done, total)) = self.points else { return String::new() };
        let done = done.min(total);
        let gauge = self.gauge(done, total).unwrap_or_default();
        format!(": {done} {of} {total}{what}{gauge}")
    }

    /// The share that is done as a bar, and the time that the rest takes at the pace so far; `None` for what ends soon.
    fn gauge(&self, done: usize, total: usize) -> Option<String> {
        let elapsed = self.elapsed.filter(|it| *it >= GAUGE_FROM && done > 0)?;
        let full = done * GAUGE / total.max(1);
        let bar = "#".repeat(full) + &".".repeat(GAUGE - full);
        let left_s = elapsed.as_secs() * (total - done) as u64 / done as u64;
        let left =
            if left_s < 100 { format!("{left_s} s") } else { format!("{} min", left_s / 60) };
        Some(format!(" [{bar}] {left} left"))
    }
}

/// The tasks submitted, and how the last run ended.
#[derive(Clone, Debug, Default)]
pub struct Jobs {
    /// The highest number given so far.
    pub last_id: u64,
    /// Counts edits: a `RunDue` with an older number is out of date.
    pub serial: u64,
    /// Counts the times of rest that have begun: a `Rest` with an older number is out of date.
    pub rest: u64,
    /// The run of the scene on the screen.
    pub current: Option<Running>,
    pub studies: Vec<Running>,
    /// The quiet time after the last edit is over and its result has not landed.
    pub overdue: bool,
    /// Tasks that have been running for so long that leaving asks first.
    pub long: Vec<u64>,
    /// Action that waits for a confirmation; repeating it confirms.
    pub awaiting_confirmation: Option<Action>,
    /// Why the last run gave no result.
    pub failure: Option<String>,
}

impl Jobs {
    /// The study of this type that has not ended, with its request.
    pub fn study<S: RequestVariant>(&self) -> Option<(&Running, &S)> {
        self.studies.iter().find_map(|running| Some((running, &**S::downcast(&running.request)?)))
    }

    /// The study in the slot of a request by a tab.
    pub fn slot(&self, tab: Tab, request: &StudyRequest) -> Option<&Running> {
        self.studies.iter().find(|running| running.is_in_slot(tab, request))
    }

    /// Forgets the study in the slot of a request: nothing that it reports is shown any more.
    pub fn take_slot(&mut self, tab: Tab, request: &StudyRequest) {
        self.studies.retain(|running| !running.is_in_slot(tab, request));
    }

    /// Forgets a study: nothing that it reports is shown any more.
    pub fn forget(&mut self, id: u64) {
        self.studies.retain(|running| running.id != id);
    }

    /// Whether a job has been running for so long that it is ended only after a question.
    pub fn is_long(&self, id: u64) -> bool {
        self.long.contains(&id)
    }

    /// The study of this type that has not ended.
    pub fn running<S: RequestVariant>(&self) -> Option<&Running> {
        self.study::<S>().map(|(running, _)| running)
    }

    /// Whether the result of a study of this type for a scene is neither kept nor under way.
    pub fn lacks<S: RequestVariant, T>(&self, kept: &CachedResult<T>, scene: &Scene) -> bool {
        let is_coming = self.running::<S>().is_some_and(|running| *running.scene == *scene);
        !kept.is_settled(scene) && !is_coming
    }
}

/// The result of a study that a page keeps, as far as it is there; that of a study of no scene has the default scene.
#[derive(Clone, Debug)]
pub struct CachedResult<T> {
    pub scene: Arc<Scene>,
    pub request: Option<StudyRequest>,
    pub result: Option<Arc<T>>,
    pub reach: Reach,
    /// Whether opening its page started it.
    pub is_look: bool,
    /// Run time; `None` while more of it follows: it is neither complete nor stopped.
    pub elapsed: Option<Duration>,
}

impl<T> Default for CachedResult<T> {
    fn default() -> Self {
        let (scene, request, result, reach, is_look, elapsed) = Default::default();
        Self { scene, request, result, reach, is_look, elapsed }
    }
}

impl<T> CachedResult<T> {
    /// Keeps the answer of a report, if it has this type; returns whether it did.
    pub(crate) fn keep(&mut self, running: &Running, news: &ReportBody) -> bool
    where
        T: ResultVariant,
    {
        let Some(Answer { report, reach, elapsed }) = news.found::<T>() else { return false };
        let (scene, request) = (Arc::clone(&running.scene), Some(running.request.clone()));
        let (result, elapsed) = (Some(report), news.is_last().then_some(elapsed));
        *self = Self { scene, request, result, reach, is_look: running.is_look, elapsed };
        true
    }

    /// Whether all of it is there.
    pub fn is_complete(&self) -> bool {
        self.result.is_some() && self.reach.is_complete()
    }

    /// Whether it belongs to another scene than this one.
    pub fn is_stale(&self, scene: &Scene) -> bool {
        self.result.is_some() && *self.scene != *scene
    }

    /// Whether no more of it is computed by looking at its page: a study that a person stopped waits for the key that runs it again.
    pub fn is_over(&self) -> bool {
        self.elapsed.is_some() && (self.is_complete() || !self.is_look)
    }

    /// Returns whether looking at the page computes no more of it: it is complete, or this time was used up.
    pub fn has_been_looked_at(&self, time: Duration) -> bool {
        self.elapsed.is_some_and(|took| self.is_over() || took >= time)
    }

    /// Returns whether the result for a scene is settled.
    pub fn is_settled(&self, scene: &Scene) -> bool {
        self.result.is_some() && self.is_over() && *self.scene == *scene
    }
}
