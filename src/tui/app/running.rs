//! The tasks that have not ended, and what has been found.

use std::sync::Arc;
use std::time::Duration;

use crate::model::scene::Scene;
use crate::tui::keymap::{Action, Tab};
use crate::worker::ReportBody;
use crate::worker::studies::{Asked, AskedFor, Finding};

/// A task that has not ended.
#[derive(Clone, Debug)]
pub struct Running {
    pub id: u64,
    /// The tab that requested it.
    pub tab: Tab,
    pub scene: Arc<Scene>,
    pub asked: Asked,
    /// Points done and in all, once known.
    pub points: Option<(usize, usize)>,
    /// Of a run the simulated time reached, s, and the time gone when that was reported, once known.
    pub reached: Option<(f64, Duration)>,
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
    pub current: Option<Running>,
    pub studies: Vec<Running>,
    /// The quiet time after the last edit is over and its result has not landed.
    pub overdue: bool,
    /// Tasks that have been running for so long that leaving asks first.
    pub long: Vec<u64>,
    /// What the person was asked about: doing it again confirms it.
    pub asked: Option<Action>,
    /// Why the last run gave no result.
    pub failure: Option<String>,
}

impl Jobs {
    /// The study of this type that has not ended, with what it was asked.
    pub fn study<S: AskedFor>(&self) -> Option<(&Running, &S)> {
        self.studies.iter().find_map(|running| Some((running, &**S::of(&running.asked)?)))
    }

    /// Forget the study of this type: nothing it reports is shown any more.
    pub fn take<S: AskedFor>(&mut self) -> Option<Running> {
        let at = self.studies.iter().position(|running| S::of(&running.asked).is_some())?;
        Some(self.studies.remove(at))
    }

    /// The study of this type that has not ended.
    pub fn running<S: AskedFor>(&self) -> Option<&Running> {
        self.study::<S>().map(|(running, _)| running)
    }

    /// Whether the result of a study of this type for a scene is neither kept nor under way.
    pub fn lacks<S: AskedFor, T>(&self, kept: &Kept<T>, scene: &Scene) -> bool {
        let is_coming = self.running::<S>().is_some_and(|running| *running.scene == *scene);
        !kept.is_there(scene) && !is_coming
    }
}

/// The result of a study that a page keeps, as far as it is there; that of a study of no scene has the default scene.
#[derive(Clone, Debug)]
pub struct Kept<T> {
    pub scene: Arc<Scene>,
    pub asked: Option<Asked>,
    pub found: Option<Arc<T>>,
    pub is_complete: bool,
    /// How long it took; `None` while more of it follows: it is neither complete nor stopped by a person.
    pub took: Option<Duration>,
}

impl<T> Default for Kept<T> {
    fn default() -> Self {
        let (scene, asked, found, is_complete, took) = Default::default();
        Self { scene, asked, found, is_complete, took }
    }
}

impl<T> Kept<T> {
    /// Keep what a report brings, if it has this type; gives whether it did.
    pub(crate) fn keep(
        &mut self,
        running: &Running,
        news: &ReportBody,
        is_complete: impl FnOnce(&T) -> bool,
    ) -> bool
    where
        T: Finding,
    {
        let Some(found) = news.found::<T>() else { return false };
        let is_complete = is_complete(&found);
        let (scene, asked) = (Arc::clone(&running.scene), Some(running.asked.clone()));
        let took = if let ReportBody::Ended { took, .. } = news { Some(*took) } else { None };
        *self = Self { scene, asked, found: Some(found), is_complete, took };
        true
    }

    /// Whether it belongs to another scene than this one.
    pub fn is_old(&self, scene: &Scene) -> bool {
        self.found.is_some() && *self.scene != *scene
    }

    /// Whether it belongs to a scene and need not be computed: what a person stopped waits for the key that runs it again.
    pub fn is_there(&self, scene: &Scene) -> bool {
        self.found.is_some() && self.took.is_some() && *self.scene == *scene
    }
}
