//! The tasks of the background threads: what is asked, and what their reports do.

use std::mem::discriminant;
use std::sync::Arc;
use std::time::Duration;

use crate::model::run::{EndReason, Run, Warning};
use crate::model::scene::Scene;
use crate::study::parallel::cores;
use crate::tui::app::notice::Notice;
use crate::tui::app::pins::{Pin, Shown};
use crate::tui::app::running::Running;
use crate::tui::message::Message;
use crate::tui::prelude::*;
use crate::worker::studies::{Asked, AskedFor, Found};
use crate::worker::{JobProgress, Report, ReportBody, SceneRun, Slot, Task};

/// Quiet time after an edit: then a run that still goes on is replaced, and what is on the screen is called old.
const QUIET: Duration = Duration::from_millis(30);

/// From this on, counted from its first report, a job is too long to be dropped without confirmation.
pub(crate) const LONG: Duration = Duration::from_secs(5);

/// The message about a study that a person stopped.
pub(crate) const CANCELLED: &str = "cancelled: partial results are shown, <run> runs again";

/// After an edit: run at once when nothing is in flight, else when the edits have paused.
pub(crate) fn after_edit(app: &mut App) {
    await_quiet(app);
    if app.jobs.current.is_none() {
        submit(app);
    }
}

/// Run the scene now, whatever is in flight.
pub(crate) fn run_now(app: &mut App) {
    await_quiet(app);
    submit(app);
}

/// From now on the quiet time is counted, after which the old result is called old.
fn await_quiet(app: &mut App) {
    app.jobs.serial += 1;
    app.jobs.overdue = false;
    app.jobs.failure = None;
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

/// Submit a study of the scene for the tab shown; an older one of its type is replaced.
pub(crate) fn study<S: AskedFor + Into<Asked>>(app: &mut App, study: S) {
    study_of(app, &Arc::clone(&app.scene), study);
}

pub(crate) fn study_of<S: AskedFor + Into<Asked>>(app: &mut App, scene: &Arc<Scene>, study: S) {
    app.jobs.take::<S>();
    let running = task(app, app.tab, scene, study.into());
    app.request(Effect::After(LONG, Message::LongJob(running.id)));
    app.jobs.studies.push(running);
}

/// Submit a task.
fn task(app: &mut App, tab: Tab, scene: &Arc<Scene>, asked: Asked) -> Running {
    app.jobs.last_id += 1;
    let (id, scene) = (app.jobs.last_id, Arc::clone(scene));
    // A run cannot be divided.
    let threads = if matches!(asked, Asked::Run(_)) { 1 } else { cores() };
    let task = Task { id, threads, scene: Arc::clone(&scene), asked: asked.clone() };
    app.request(Effect::Submit(task));
    Running { id, tab, scene, asked, points: None, reached: None }
}

/// A report of a study, with the study as it is now.
fn study_report(app: &mut App, at: usize, body: &ReportBody) -> Running {
    if let ReportBody::Failed(text) = body {
        app.refuse(text);
    }
    if body.is_last() {
        return app.jobs.studies.remove(at);
    }
    let running = &mut app.jobs.studies[at];
    if let ReportBody::Progress { progress: JobProgress::Points(done, total), .. } = *body {
        running.points = Some((done, total));
    }
    running.clone()
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

/// A report of a task; those of replaced ones are dropped. Gives the study that its page is to hear of.
pub(crate) fn report(app: &mut App, report: Report) -> Option<(Running, ReportBody)> {
    if report.body.is_last() {
        app.jobs.long.retain(|id| *id != report.id);
    }
    let Report { id, body } = report;
    if app.jobs.current.as_ref().is_some_and(|job| job.id == id) {
        run_report(app, id, body);
    } else if let Some(at) = app.pins.iter().position(|pin| pin.job == Some(id)) {
        pin(app, at, body);
    } else if let Some(at) = app.jobs.studies.iter().position(|running| running.id == id) {
        return Some((study_report(app, at, &body), body));
    }
    None
}

fn run_report(app: &mut App, id: u64, body: ReportBody) {
    match body {
        ReportBody::Progress { progress: JobProgress::Time(t_s), elapsed } => {
            // The first report says that the run takes a while.
            let begins = t_s == 0.0;
            if let Some(job) = &mut app.jobs.current {
                job.reached = (!begins).then_some((t_s, elapsed));
            }
            if begins {
                app.request(Effect::After(LONG, Message::LongJob(id)));
            }
            return;
        }
        ReportBody::Part(Found::Run(run)) => {
            app.shown = Some(Shown { run, took: None });
            return;
        }
        ReportBody::Progress { .. } | ReportBody::Part(_) => return,
        ReportBody::Failed(text) => {
            app.jobs.failure = Some(text.clone());
            app.refuse(text);
        }
        ReportBody::Ended { found: Some(Found::Run(run)), took } => {
            let took = Some(took).filter(|_| run.end != EndReason::Cancelled);
            if took.is_none() {
                app.tell(CANCELLED);
            }
            show(app, &run, took);
        }
        ReportBody::Ended { .. } => app.tell("cancelled: <run> runs again"),
    }
    let finished = app.jobs.current.take();
    app.jobs.overdue = false;
    if finished.is_some_and(|job| job.scene != app.scene) {
        run_now(app);
    }
}

fn show(app: &mut App, run: &Arc<Run>, took: Option<Duration>) {
    let before = app.shown.replace(Shown { run: Arc::clone(run), took });
    let known = before.as_ref().map_or(&[][..], |shown| &shown.run.warnings);
    let is_known = |it: &&Warning| known.iter().any(|old| discriminant(old) == discriminant(*it));
    // The status row has the new ones in a few words: their sentences are for the Log tab. What comes after the run stands there anyway.
    let is_later = |it: &&Warning| matches!(it, Warning::InterfaceRebound { .. });
    for warning in run.warnings.iter().filter(|it| !is_later(it) && !is_known(it)) {
        let text = app.keymap.shown(&warning.to_string());
        app.keep(Notice { severity: Severity::Warning, text });
    }
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
