//! Asking the worker for runs, and what its reports do.

use std::sync::Arc;
use std::time::Duration;

use crate::model::run::{Run, Warning};
use crate::model::scene::Scene;
use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::notice::Severity;
use crate::tui::app::runs::{InFlight, Shown};
use crate::tui::app::status::warning_text;
use crate::tui::message::{Effect, Message};
use crate::worker::studies::{Study, StudyKind};
use crate::worker::{Job, Report, ReportBody, Slot};

/// Quiet time after an edit: then a run that still goes on is replaced, and what is on the screen is called old.
const QUIET: Duration = Duration::from_millis(30);

/// From this on, counted from its first report, a job is too long to be dropped unasked.
pub(super) const LONG: Duration = Duration::from_secs(5);

/// After an edit: run at once when nothing is in flight, else when the edits have paused.
pub(super) fn after_edit(app: &mut App) -> Vec<Effect> {
    app.jobs.serial += 1;
    app.jobs.failure = None;
    app.jobs.cancelled = false;
    if !app.auto_run {
        return Vec::new();
    }
    app.jobs.overdue = false;
    let due = Effect::After(QUIET, Message::RunDue(app.jobs.serial));
    let mut effects = if app.jobs.current.is_none() { submit(app) } else { Vec::new() };
    effects.push(due);
    effects
}

/// Run the scene now, whatever is in flight.
pub(super) fn run_now(app: &mut App) -> Vec<Effect> {
    app.jobs.serial += 1;
    submit_now(app)
}

/// Submit the scene, with the moment after which the old result is called old.
pub(super) fn submit_now(app: &mut App) -> Vec<Effect> {
    app.jobs.overdue = false;
    app.jobs.failure = None;
    app.jobs.cancelled = false;
    let mut effects = submit(app);
    effects.push(Effect::After(QUIET, Message::RunDue(app.jobs.serial)));
    effects
}

fn submit(app: &mut App) -> Vec<Effect> {
    let id = app.jobs.next_id();
    app.jobs.current =
        Some(InFlight { id, scene: Arc::clone(&app.scene), reached: None, long: false });
    vec![Effect::Submit(Job { id, slot: Slot::Current, scene: Arc::clone(&app.scene) })]
}

/// Submit every pin that has neither result nor job.
pub(super) fn submit_pins(app: &mut App) -> Vec<Effect> {
    let mut effects = Vec::new();
    for pin in &mut app.pins {
        if pin.run.is_none() && pin.job.is_none() {
            let id = app.jobs.next_id();
            pin.job = Some(id);
            effects.push(Effect::Submit(Job {
                id,
                slot: Slot::Pin(pin.letter),
                scene: Arc::clone(&pin.scene),
            }));
        }
    }
    effects
}

/// Ask for a study of a scene; what is to be kept of it while it runs, and the effects.
pub(super) fn study(app: &mut App, kind: StudyKind, scene: Arc<Scene>) -> (Measuring, Vec<Effect>) {
    let (id, threads) = (app.jobs.next_id(), app.crew());
    let measuring = Measuring { id, scene: Arc::clone(&scene), points: None, long: false };
    let study = Study { id, scene, kind, threads };
    (measuring, vec![Effect::Study(study), Effect::After(LONG, Message::LongJob(id))])
}

/// The quiet time after an edit is over.
pub(super) fn run_due(app: &mut App, serial: u64) -> Vec<Effect> {
    let Some(job) = app.jobs.current.as_ref().filter(|_| serial == app.jobs.serial) else {
        return Vec::new();
    };
    app.jobs.overdue = true;
    if job.scene == app.scene { Vec::new() } else { submit(app) }
}

/// A job has been running for a long time; of one that has ended nothing is said.
pub(super) fn long(app: &mut App, id: u64) {
    if let Some(job) = app.jobs.current.as_mut().filter(|job| job.id == id) {
        job.long = true;
    }
    if let Some(sweep) = app.sweeping.computing.as_mut().filter(|sweep| sweep.id == id) {
        sweep.long = true;
    }
    let (accuracy, stability) = (&mut app.accuracy, &mut app.stability);
    let (thesis, limit) = (&mut app.thesis.running, &mut app.limit.finding);
    let (mapping, battery) = (&mut stability.mapping, &mut stability.running);
    let search = &mut app.searching.running;
    for study in [&mut accuracy.measuring, mapping, battery, thesis, limit, search] {
        if let Some(study) = study.as_mut().filter(|study| study.id == id) {
            study.long = true;
        }
    }
}

/// A report from the worker; those of replaced jobs are dropped.
pub(super) fn report(app: &mut App, report: Report) -> Vec<Effect> {
    match report.slot {
        Slot::Current if app.jobs.is_newest(report.slot, report.id) => current(app, report.body),
        Slot::Current => Vec::new(),
        Slot::Pin(letter) => {
            pin(app, letter, report.id, report.body);
            Vec::new()
        }
    }
}

fn current(app: &mut App, body: ReportBody) -> Vec<Effect> {
    match body {
        ReportBody::Started => {
            let job = app.jobs.current.as_ref();
            return job
                .map(|job| Effect::After(LONG, Message::LongJob(job.id)))
                .into_iter()
                .collect();
        }
        ReportBody::Progress { t_s, elapsed } => {
            if let Some(job) = &mut app.jobs.current {
                job.reached = Some((t_s, elapsed));
            }
            return Vec::new();
        }
        ReportBody::Part(run) => {
            app.note_run(&run);
            app.shown = Some(Shown { run, took: None });
            return Vec::new();
        }
        ReportBody::Done { run, took } => show(app, run, Some(took)),
        ReportBody::Failed(text) => {
            app.jobs.failure = Some(text.clone());
            app.say(Severity::Error, text);
        }
        ReportBody::Cancelled { partial } => {
            app.jobs.cancelled = true;
            app.say(
                Severity::Note,
                match partial {
                    Some(_) => "cancelled: what was finished is shown",
                    None => "cancelled: r runs again",
                },
            );
            if let Some(run) = partial {
                show(app, run, None);
            }
        }
    }
    let finished = app.jobs.current.take();
    app.jobs.overdue = false;
    let outdated = finished.is_some_and(|job| job.scene != app.scene);
    if outdated && app.auto_run { submit_now(app) } else { Vec::new() }
}

fn show(app: &mut App, run: Arc<Run>, took: Option<Duration>) {
    let before = app.shown.take();
    let known: Vec<Warning> = before.map_or_else(Vec::new, |shown| shown.run.warnings.clone());
    let same_kind =
        |a: &Warning, b: &Warning| std::mem::discriminant(a) == std::mem::discriminant(b);
    let new: Vec<String> = run
        .warnings
        .iter()
        .filter(|warning| !known.iter().any(|old| same_kind(old, warning)))
        .map(warning_text)
        .collect();
    for text in new {
        // A message about the edit itself stays; the warning is in the status row and the Log tab.
        let kept = app.notice.take();
        app.say(Severity::Warning, text);
        if kept.is_some() {
            app.notice = kept;
        }
    }
    app.note_run(&run);
    app.shown = Some(Shown { run, took });
}

fn pin(app: &mut App, letter: char, id: u64, body: ReportBody) {
    let found = app.pins.iter_mut().find(|pin| pin.letter == letter && pin.job == Some(id));
    let Some(pin) = found else {
        return;
    };
    match body {
        ReportBody::Started | ReportBody::Progress { .. } | ReportBody::Part(_) => {}
        ReportBody::Done { run, .. } => {
            pin.run = Some(Arc::clone(&run));
            pin.job = None;
            app.note_run(&run);
        }
        ReportBody::Failed(text) => {
            pin.job = None;
            app.say(Severity::Error, format!("pinned run {letter}: {text}"));
        }
        ReportBody::Cancelled { partial } => {
            pin.run.clone_from(&partial);
            pin.job = None;
            if let Some(run) = &partial {
                app.note_run(run);
            }
        }
    }
}
