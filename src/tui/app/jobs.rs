//! The tasks of the background threads: what is asked, what has been found, and what their reports do.

use std::sync::Arc;
use std::time::Duration;

use crate::model::run::{EndReason, Run, Warning};
use crate::model::scene::Scene;
use crate::tui::app::notice::Notice;
use crate::tui::app::status::warning_text;
use crate::tui::message::Message;
use crate::tui::pages;
use crate::tui::pages::run::runs::{Pin, Shown};
use crate::tui::prelude::*;
use crate::worker::studies::{Asked, AskedFor, Finding, Found};
use crate::worker::{JobProgress, Report, ReportBody, SceneRun, Slot, Task};

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
    /// The person was asked whether to stop a long task.
    pub stop_confirmation_shown: bool,
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
    pub found: Option<Arc<T>>,
    pub is_complete: bool,
    /// No more of it follows: it is complete, or a person stopped it.
    has_ended: bool,
}

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self { scene: Arc::default(), found: None, is_complete: false, has_ended: false }
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
        let (scene, has_ended) = (Arc::clone(&running.scene), news.is_last());
        *self = Self { scene, found: Some(found), is_complete, has_ended };
        true
    }

    /// Whether it belongs to another scene than this one.
    pub fn is_old(&self, scene: &Scene) -> bool {
        self.found.is_some() && *self.scene != *scene
    }

    /// Whether it belongs to a scene and need not be computed: what a person stopped waits for the key that runs it again.
    pub fn is_there(&self, scene: &Scene) -> bool {
        self.found.is_some() && self.has_ended && *self.scene == *scene
    }
}

/// Quiet time after an edit: then a run that still goes on is replaced, and what is on the screen is called old.
const QUIET: Duration = Duration::from_millis(30);

/// From this on, counted from its first report, a job is too long to be dropped without confirmation.
pub(crate) const LONG: Duration = Duration::from_secs(5);

/// The message about a study that a person stopped.
pub(crate) const CANCELLED: &str = "cancelled: partial results are shown, <run> runs again";

/// After an edit: run at once when nothing is in flight, else when the edits have paused.
pub(crate) fn after_edit(app: &mut App) {
    app.jobs.serial += 1;
    app.jobs.failure = None;
    if !app.settings.auto_run {
        return;
    }
    app.jobs.overdue = false;
    let due = Effect::After(QUIET, Message::RunDue(app.jobs.serial));
    if app.jobs.current.is_none() {
        submit(app);
    }
    app.request(due);
}

/// Run the scene now, whatever is in flight.
pub(crate) fn run_now(app: &mut App) {
    app.jobs.serial += 1;
    submit_now(app);
}

/// Submit the scene, with the moment after which the old result is called old.
pub(crate) fn submit_now(app: &mut App) {
    app.jobs.overdue = false;
    app.jobs.failure = None;
    submit(app);
    app.request(Effect::After(QUIET, Message::RunDue(app.jobs.serial)));
}

fn submit(app: &mut App) {
    let scene = Arc::clone(&app.scene);
    app.jobs.current = Some(task(app, Tab::Run, &scene, SceneRun(Slot::Current).into()));
}

/// Submit every pin that has neither result nor job.
pub(crate) fn submit_pins(app: &mut App) {
    for at in 0..app.pins.len() {
        let Pin { letter, scene, run: None, job: None, .. } = &app.pins[at] else { continue };
        let (letter, scene) = (*letter, Arc::clone(scene));
        let job = task(app, Tab::Run, &scene, SceneRun(Slot::Pin(letter)).into());
        app.pins[at].job = Some(job.id);
    }
}

/// Submit a study of the scene for a tab; an older one of its type is replaced.
pub(crate) fn study<S: AskedFor + Into<Asked>>(app: &mut App, tab: Tab, study: S) {
    study_of(app, tab, &Arc::clone(&app.scene), study);
}

pub(crate) fn study_of<S>(app: &mut App, tab: Tab, scene: &Arc<Scene>, study: S)
where
    S: AskedFor + Into<Asked>,
{
    app.jobs.take::<S>();
    let running = task(app, tab, scene, study.into());
    app.request(Effect::After(LONG, Message::LongJob(running.id)));
    app.jobs.studies.push(running);
}

/// Submit a task.
fn task(app: &mut App, tab: Tab, scene: &Arc<Scene>, asked: Asked) -> Running {
    app.jobs.last_id += 1;
    let (id, scene) = (app.jobs.last_id, Arc::clone(scene));
    // A run cannot be divided.
    let threads = if matches!(asked, Asked::Run(_)) { 1 } else { app.crew() };
    let task = Task { id, threads, scene: Arc::clone(&scene), asked: asked.clone() };
    app.request(Effect::Submit(task));
    Running { id, tab, scene, asked, points: None, reached_s: None, elapsed: Duration::ZERO }
}

/// A report of a study: its page hears what it brings.
fn study_report(app: &mut App, at: usize, body: &ReportBody) {
    let running = if body.is_last() {
        app.jobs.studies.remove(at)
    } else {
        let running = &mut app.jobs.studies[at];
        if let ReportBody::Progress { progress: JobProgress::Points(done, total), elapsed } = *body
        {
            (running.points, running.elapsed) = (Some((done, total)), elapsed);
        }
        running.clone()
    };
    if let ReportBody::Failed(text) = body {
        app.refuse(text);
    }
    pages::of(running.tab).report(app, &running, body);
}

/// The quiet time after an edit is over.
pub(crate) fn run_due(app: &mut App, serial: u64) {
    let Some(job) = app.jobs.current.as_ref().filter(|_| serial == app.jobs.serial) else {
        return;
    };
    app.jobs.overdue = true;
    if job.scene != app.scene {
        submit(app);
    }
}

/// A report of a task; those of replaced ones are dropped.
pub(crate) fn report(app: &mut App, report: Report) {
    if report.body.is_last() {
        app.jobs.long.retain(|id| *id != report.id);
    }
    let Report { id, body } = report;
    if app.jobs.current.as_ref().is_some_and(|job| job.id == id) {
        run_report(app, id, body);
    } else if let Some(at) = app.pins.iter().position(|pin| pin.job == Some(id)) {
        pin(app, at, body);
    } else if let Some(at) = app.jobs.studies.iter().position(|running| running.id == id) {
        study_report(app, at, &body);
    }
}

fn run_report(app: &mut App, id: u64, body: ReportBody) {
    match body {
        ReportBody::Progress { progress: JobProgress::Time(t_s), elapsed } => {
            // The first report says that the run takes a while.
            let begins = t_s == 0.0;
            if let Some(job) = &mut app.jobs.current {
                (job.reached_s, job.elapsed) = ((!begins).then_some(t_s), elapsed);
            }
            if begins {
                app.request(Effect::After(LONG, Message::LongJob(id)));
            }
            return;
        }
        ReportBody::Progress { .. } => return,
        ReportBody::Part(found) => {
            if let Found::Run(run) = found {
                app.shown = Some(Shown { run, took: None });
            }
            return;
        }
        ReportBody::Failed(text) => {
            app.jobs.failure = Some(text.clone());
            app.refuse(text);
        }
        ReportBody::Ended { found, took } => {
            if let Some(Found::Run(run)) = found {
                ended(app, run, took);
            } else {
                app.tell("cancelled: <run> runs again");
            }
        }
    }
    let finished = app.jobs.current.take();
    app.jobs.overdue = false;
    let outdated = finished.is_some_and(|job| job.scene != app.scene);
    if outdated && app.settings.auto_run {
        submit_now(app);
    }
}

fn ended(app: &mut App, run: Arc<Run>, took: Duration) {
    if run.end != EndReason::Cancelled {
        return show(app, run, Some(took));
    }
    app.tell(CANCELLED);
    show(app, run, None);
}

fn show(app: &mut App, run: Arc<Run>, took: Option<Duration>) {
    let before = app.shown.take();
    let known: Vec<Warning> = before.map_or_else(Vec::new, |shown| shown.run.warnings.clone());
    let same_kind =
        |a: &Warning, b: &Warning| std::mem::discriminant(a) == std::mem::discriminant(b);
    let new: Vec<String> = run
        .warnings
        .iter()
        // What comes after the run is for the status row and the Log tab: it would take the place of the answer.
        .filter(|warning| !matches!(warning, Warning::InterfaceRebound { .. }))
        .filter(|warning| !known.iter().any(|old| same_kind(old, warning)))
        .map(warning_text)
        .collect();
    // The status row has them in a few words, and would lie under their sentences: those are for the Log tab.
    for text in new {
        let text = app.keymap.shown(&text);
        app.keep(Notice { severity: Severity::Warning, text });
    }
    app.shown = Some(Shown { run, took });
}

fn pin(app: &mut App, at: usize, body: ReportBody) {
    let pin = &mut app.pins[at];
    if body.is_last() {
        pin.job = None;
    }
    match body {
        ReportBody::Ended { found: Some(Found::Run(run)), .. } => {
            // A part would be taken for the result, and never computed again.
            pin.run = Some(run).filter(|run| run.end != EndReason::Cancelled);
        }
        ReportBody::Failed(text) => {
            let text = format!("pinned run {}: {text}", pin.letter);
            app.refuse(text);
        }
        ReportBody::Progress { .. } | ReportBody::Part(_) | ReportBody::Ended { .. } => {}
    }
}
