//! Active tasks and cached results.

use std::sync::Arc;
use std::time::Duration;

use crate::tui::keymap::{Action, Tab};
use crate::worker::studies::{RequestVariant, ResultVariant, StudyRequest};
use crate::worker::{Page, ReportBody};
use cmra_engine::model::scene::Scene;
use cmra_studies::study::context::{Answer, Reach};

/// Cells of the progress bar of a study, and the elapsed time from which it is shown.
const GAUGE: usize = 8;
const GAUGE_FROM: Duration = Duration::from_secs(1);

/// Active task.
#[derive(Clone, Debug)]
pub struct Running {
    pub id: u64,
    /// Tab that requested the task.
    pub tab: Tab,
    /// Whether the task started because its page was shown.
    pub is_look: bool,
    /// Whether a key ended the task before its time limit.
    pub is_ended: bool,
    pub scene: Arc<Scene>,
    pub request: StudyRequest,
    /// Computed and total number of points, if known.
    pub points: Option<(usize, usize)>,
    /// Elapsed time at the last progress report, if known.
    pub elapsed: Option<Duration>,
    /// Simulated time of a run, s, and the elapsed time at its report, if known.
    pub reached: Option<(f64, Duration)>,
}

impl Running {
    fn is_in_slot(&self, tab: Tab, request: &StudyRequest) -> bool {
        let slot = |tab: Tab, request: &StudyRequest| request.slot(Page(tab.index()));
        slot(self.tab, &self.request) == slot(tab, request)
    }

    /// Formats the progress: `: 12 of 30 [###.....] 20 s left`; empty if unknown.
    pub fn counted(&self, of: &str, what: &str) -> String {
        let Some((done, total)) = self.points else { return String::new() };
        let gauge = self.gauge(GAUGE).map_or_else(String::new, |gauge| format!(" {gauge}"));
        format!(": {} {of} {total}{what}{gauge}", done.min(total))
    }

    /// Formats the completed fraction as a bar of this many cells, with the estimated remaining time; `None` if the task ends soon.
    pub fn gauge(&self, cells: usize) -> Option<String> {
        let (done, total) = self.points.map(|(done, total)| (done.min(total), total))?;
        let elapsed = self.elapsed.filter(|it| *it >= GAUGE_FROM && done > 0)?;
        let full = done * cells / total.max(1);
        let bar = "#".repeat(full) + &".".repeat(cells - full);
        let left_s = elapsed.as_secs() * (total - done) as u64 / done as u64;
        let left =
            if left_s < 100 { format!("{left_s} s") } else { format!("{} min", left_s / 60) };
        Some(format!("[{bar}] {left} left"))
    }
}

/// Submitted tasks: the run of the current scene, and the serial numbers by which outdated messages are recognised.
#[derive(Clone, Debug, Default)]
pub struct Jobs {
    /// Last assigned task number.
    pub last_id: u64,
    /// Serial number of the latest edit; a `RunDue` with an older number is outdated.
    pub serial: u64,
    /// Serial number of the latest idle time; a `Rest` with an older number is outdated.
    pub rest: u64,
    /// Run of the current scene.
    pub current: Option<Running>,
    pub studies: Vec<Running>,
    /// Whether the quiet time after the last edit is over and its result is still missing.
    pub overdue: bool,
    /// Long-running tasks, which need confirmation before the workbench quits.
    pub long: Vec<u64>,
    /// Action that waits for a confirmation; repeating it confirms.
    pub awaiting_confirmation: Option<Action>,
    /// Reason why the last run gave no result.
    pub failure: Option<String>,
}

impl Jobs {
    /// Returns the active study of this type with its request.
    pub fn study<S: RequestVariant>(&self) -> Option<(&Running, &S)> {
        self.studies.iter().find_map(|running| Some((running, &**S::downcast(&running.request)?)))
    }

    /// Returns the active study in the slot of a tab's request.
    pub fn slot(&self, tab: Tab, request: &StudyRequest) -> Option<&Running> {
        self.studies.iter().find(|running| running.is_in_slot(tab, request))
    }

    /// Removes the study in the slot of a request; its reports are ignored from now on.
    pub fn take_slot(&mut self, tab: Tab, request: &StudyRequest) {
        self.studies.retain(|running| !running.is_in_slot(tab, request));
    }

    /// Removes a study; its reports are ignored from now on.
    pub fn forget(&mut self, id: u64) {
        self.studies.retain(|running| running.id != id);
    }

    /// Returns `true` if a job has run for so long that cancelling it needs confirmation.
    pub fn is_long(&self, id: u64) -> bool {
        self.long.contains(&id)
    }

    /// Returns the active study of this type.
    pub fn running<S: RequestVariant>(&self) -> Option<&Running> {
        self.study::<S>().map(|(running, _)| running)
    }

    /// Returns `true` if the result of a study of this type for a scene is neither cached nor being computed.
    pub fn lacks<S: RequestVariant, T>(&self, kept: &CachedResult<T>, scene: &Scene) -> bool {
        let is_coming = self.running::<S>().is_some_and(|running| *running.scene == *scene);
        !kept.is_settled(scene) && !is_coming
    }
}

/// Cached result of a study, possibly partial. A study without a scene has the default scene.
#[derive(Clone, Debug)]
pub struct CachedResult<T> {
    pub scene: Arc<Scene>,
    pub request: Option<StudyRequest>,
    pub result: Option<Arc<T>>,
    pub reach: Reach,
    /// Whether the study started because its page was shown.
    pub is_look: bool,
    /// Whether a key ended the study before its time limit.
    pub is_ended: bool,
    /// Run time; `None` while the study is active.
    pub elapsed: Option<Duration>,
}

impl<T> Default for CachedResult<T> {
    fn default() -> Self {
        let (scene, request, result, reach, is_look, is_ended, elapsed) = Default::default();
        Self { scene, request, result, reach, is_look, is_ended, elapsed }
    }
}

impl<T> CachedResult<T> {
    /// Stores the result of a report if it has this type; returns whether it has.
    pub(crate) fn keep(&mut self, running: &Running, news: &ReportBody) -> bool
    where
        T: ResultVariant,
    {
        let Some(Answer { report, reach, elapsed }) = news.found::<T>() else { return false };
        let (scene, request) = (Arc::clone(&running.scene), Some(running.request.clone()));
        let (result, elapsed) = (Some(report), news.is_last().then_some(elapsed));
        let Running { is_look, is_ended, .. } = *running;
        *self = Self { scene, request, result, reach, is_look, is_ended, elapsed };
        true
    }

    /// Returns `true` if the result is complete.
    pub fn is_complete(&self) -> bool {
        self.result.is_some() && self.reach.is_complete()
    }

    /// Returns `true` if the result belongs to another scene.
    pub fn is_stale(&self, scene: &Scene) -> bool {
        self.result.is_some() && *self.scene != *scene
    }

    /// Returns `true` if showing the page does not continue the study. A study that the user stopped restarts on request only.
    pub fn is_over(&self) -> bool {
        self.elapsed.is_some() && (self.is_complete() || !self.is_look)
    }

    /// Returns `true` if showing the page computes no more of the result: it is complete, or the time limit is used up.
    pub fn has_been_looked_at(&self) -> bool {
        self.elapsed.is_some() && (self.is_over() || !self.is_ended)
    }

    /// Returns `true` if the result for a scene is final.
    pub fn is_settled(&self, scene: &Scene) -> bool {
        self.result.is_some() && self.is_over() && *self.scene == *scene
    }
}
