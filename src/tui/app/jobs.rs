//! Tasks of the background threads: requests, and handling of their reports.

use std::mem::discriminant;
use std::sync::Arc;
use std::time::Duration;

use crate::tui::app::notice::Notice;
use crate::tui::app::pins::{DisplayedRun, Pin};
use crate::tui::app::running::Running;
use crate::tui::message::Message;
use crate::tui::prelude::*;
use crate::worker::studies::{RequestVariant, StudyRequest, StudyResult};
use crate::worker::{JobProgress, Page, ReportBody, SceneRun, Slot, Task, TaskReport};
use cmra_engine::model::run::{EndReason, Run, RunWarning};
use cmra_engine::model::scene::Scene;
use cmra_studies::study::context::Answer;
use cmra_studies::study::parallel::cores;

/// Quiet time after an edit. A run that takes longer is replaced, and the displayed result is marked as old.
const QUIET: Duration = Duration::from_millis(30);

/// Duration of a job, from its first report, above which it is discarded only after confirmation.
pub(crate) const LONG: Duration = Duration::from_secs(5);

/// Limit of processor time of a study that starts when its page is shown. With one thread and 20 ms between checks it takes less than
/// 0.2 s. The rest is computed on request.
pub(crate) const LOOK: Duration = Duration::from_millis(160);

/// Idle time after which a page computes its deferred results.
const REST: Duration = Duration::from_millis(300);

/// Message for a study that the user stopped.
pub(crate) const CANCELLED: &str = "cancelled: partial results are shown, <run> runs again";

/// Requests a run after an edit: immediately if no run is active, else after the quiet time.
pub(crate) fn after_edit(app: &mut App) {
    await_quiet(app);
    if app.jobs.current.is_none() {
        submit(app);
    }
}

/// Runs the scene immediately, replacing an active run.
pub(crate) fn run_now(app: &mut App) {
    await_quiet(app);
    submit(app);
}

/// Starts the quiet time, after which the old result is marked as old.
fn await_quiet(app: &mut App) {
    app.jobs.serial += 1;
    app.jobs.overdue = false;
    app.jobs.failure = None;
    app.request(Effect::After(QUIET, Message::RunDue(app.jobs.serial)));
}

fn submit(app: &mut App) {
    let scene = Arc::clone(&app.scene);
    app.jobs.current = Some(task(app, Tab::Run, &scene, SceneRun(Slot::Current).into(), None));
}

/// Submits every pin that has neither result nor job.
pub(crate) fn submit_pins(app: &mut App) {
    for at in 0..app.pins.len() {
        let Pin { letter, scene, run: None, job: None, .. } = &app.pins[at] else { continue };
        let (letter, scene) = (*letter, Arc::clone(scene));
        let job = task(app, Tab::Run, &scene, SceneRun(Slot::Pin(letter)).into(), None);
        app.pins[at].job = Some(job.id);
    }
}

/// Runs the scene again on request; replaces a long run only after confirmation.
pub(crate) fn rerun(app: &mut App, action: Action) {
    let id = app.jobs.current.as_ref().map(|job| job.id);
    if may_end(app, id, action) {
        run_now(app);
    }
}

/// Submits a study of the scene for the shown tab, on request.
pub(crate) fn study<S: RequestVariant + Into<StudyRequest>>(
    app: &mut App,
    action: Action,
    study: S,
) {
    study_of(app, action, &Arc::clone(&app.scene), study);
}

/// Submits a study of another scene. Replaces the older study of its slot, a long one only after confirmation.
pub(crate) fn study_of<S>(app: &mut App, action: Action, scene: &Arc<Scene>, study: S)
where
    S: RequestVariant + Into<StudyRequest>,
{
    let request = study.into();
    let id = app.jobs.slot(app.tab, &request).map(|running| running.id);
    if may_end(app, id, action) {
        begin(app, scene, request, None);
    }
}

/// Submits several studies that a page shows together, with a single confirmation.
pub(crate) fn studies(app: &mut App, action: Action, all: Vec<(Arc<Scene>, StudyRequest)>) {
    let slots = all.iter().filter_map(|(_, asked)| app.jobs.slot(app.tab, asked));
    let long = slots.map(|running| running.id).find(|id| app.jobs.is_long(*id));
    if may_end(app, long, action) {
        for (scene, asked) in all {
            begin(app, &scene, asked, None);
        }
    }
}

/// Submits a study of the scene because its page is shown. It has a time limit and one thread, and does not replace a long study.
pub(crate) fn look<S: RequestVariant + Into<StudyRequest>>(
    app: &mut App,
    time: Duration,
    study: S,
) {
    look_at(app, time, &Arc::clone(&app.scene), study);
}

/// Submits a study of another scene because its page is shown, with this time limit.
pub(crate) fn look_at<S>(app: &mut App, time: Duration, scene: &Arc<Scene>, study: S)
where
    S: RequestVariant + Into<StudyRequest>,
{
    let request = study.into();
    let id = app.jobs.slot(app.tab, &request).map(|running| running.id);
    if !id.is_some_and(|id| app.jobs.is_long(id)) {
        begin(app, scene, request, Some(time));
    }
}

/// Starts the idle time, after which the page computes its deferred results.
pub(crate) fn begin_rest(app: &mut App) {
    app.jobs.rest += 1;
    app.request(Effect::After(REST, Message::Rest(app.jobs.rest)));
}

/// Cancels the studies that started when their page was shown, because a key was pressed.
pub(crate) fn end_looks(app: &mut App) {
    for running in app.jobs.studies.iter_mut().filter(|running| running.is_look) {
        running.is_ended = true;
        app.effects.push(Effect::Cancel(running.id));
    }
}

/// Returns `true` if this key may cancel a job; a long job only if the key is repeated.
pub(crate) fn may_end(app: &mut App, id: Option<u64>, action: Action) -> bool {
    let is_long = id.is_some_and(|id| app.jobs.is_long(id));
    if is_long && app.jobs.awaiting_confirmation != Some(action) {
        app.jobs.awaiting_confirmation = Some(action);
        let key = app.keymap.label(action);
        let text = format!(
            "a job has been running for more than 5 s: {key} again ends it, <back> keeps what is finished"
        );
        app.say(Severity::Warning, text);
        return false;
    }
    app.jobs.awaiting_confirmation = None;
    true
}

/// Submits a study in place of the older one of its slot.
fn begin(app: &mut App, scene: &Arc<Scene>, request: StudyRequest, budget: Option<Duration>) {
    app.jobs.take_slot(app.tab, &request);
    let running = task(app, app.tab, scene, request, budget);
    app.request(Effect::After(LONG, Message::LongJob(running.id)));
    app.jobs.studies.push(running);
}

/// Submits a task.
fn task(
    app: &mut App,
    tab: Tab,
    scene: &Arc<Scene>,
    request: StudyRequest,
    budget: Option<Duration>,
) -> Running {
    app.jobs.last_id += 1;
    let (id, scene) = (app.jobs.last_id, Arc::clone(scene));
    // A run cannot be parallelised.
    let is_single = matches!(request, StudyRequest::Run(_)) || budget.is_some();
    let threads = if is_single { 1 } else { cores() };
    let page = Page(tab.index());
    let task =
        Task { id, page, threads, budget, scene: Arc::clone(&scene), request: request.clone() };
    app.request(Effect::Submit(task));
    let (is_look, is_ended) = (budget.is_some(), false);
    Running {
        id,
        tab,
        is_look,
        is_ended,
        scene,
        request,
        points: None,
        elapsed: None,
        reached: None,
    }
}

/// Updates the state of a study from a report; returns the study.
fn study_report(app: &mut App, at: usize, body: &ReportBody) -> Running {
    if let ReportBody::Failed(text) = body {
        app.refuse(text);
    }
    if body.is_last() {
        return app.jobs.studies.remove(at);
    }
    let running = &mut app.jobs.studies[at];
    if let ReportBody::Progress { progress: JobProgress::Points(done, total), elapsed } = *body {
        (running.points, running.elapsed) = (Some((done, total)), Some(elapsed));
    }
    running.clone()
}

/// Handles the end of the quiet time after an edit.
pub(crate) fn run_due(app: &mut App, serial: u64) {
    let Some(job) = app.jobs.current.as_ref().filter(|_| serial == app.jobs.serial) else {
        return;
    };
    app.jobs.overdue = true;
    if job.scene != app.scene {
        submit(app);
    }
}

/// Handles the report of a task; ignores replaced tasks. Returns the study whose page handles the report.
pub(crate) fn report(app: &mut App, report: TaskReport) -> Option<(Running, ReportBody)> {
    if report.body.is_last() && app.jobs.is_long(report.id) {
        app.jobs.long.retain(|id| *id != report.id);
        // A question whether to end this job is answered.
        if app.jobs.awaiting_confirmation.take().is_some() {
            app.notice = None;
        }
    }
    let TaskReport { id, body } = report;
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
            // The first report indicates that the run takes a while.
            let begins = t_s == 0.0;
            if let Some(job) = &mut app.jobs.current {
                job.reached = (!begins).then_some((t_s, elapsed));
            }
            if begins {
                app.request(Effect::After(LONG, Message::LongJob(id)));
            }
            return;
        }
        ReportBody::Part(Answer { report: StudyResult::Run(run), .. }) => {
            app.shown = Some(DisplayedRun { run, elapsed: None });
            return;
        }
        ReportBody::Progress { .. } | ReportBody::Part(_) => return,
        ReportBody::Failed(text) => {
            app.jobs.failure = Some(text.clone());
            app.refuse(text);
            // Remove the result of another scene, because the current scene has none.
            app.shown.take_if(|shown| shown.run.scene != app.scene);
        }
        ReportBody::Ended(Some(Answer { report: StudyResult::Run(run), elapsed, .. })) => {
            let took = Some(elapsed).filter(|_| run.end != EndReason::Cancelled);
            if took.is_none() {
                app.report_progress(CANCELLED);
            }
            show(app, &run, took);
        }
        ReportBody::Ended(_) => app.report_progress("cancelled: <run> runs again"),
    }
    let finished = app.jobs.current.take();
    app.jobs.overdue = false;
    if finished.is_some_and(|job| job.scene != app.scene) {
        run_now(app);
    }
}

fn show(app: &mut App, run: &Arc<Run>, elapsed: Option<Duration>) {
    let before = app.shown.replace(DisplayedRun { run: Arc::clone(run), elapsed });
    let known = before.as_ref().map_or(&[][..], |shown| &shown.run.warnings);
    let is_known =
        |it: &&RunWarning| known.iter().any(|old| discriminant(old) == discriminant(*it));
    // The status row shows new warnings briefly; the Log tab has the full sentences. Warnings about the motion after the run are always in
    // the row.
    let is_later = |it: &&RunWarning| matches!(it, RunWarning::InterfaceRebound { .. });
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
        ReportBody::Ended(Some(Answer { report: StudyResult::Run(run), .. })) => {
            // Discard a cancelled run, which would be taken for the result and not recomputed.
            pin.run = Some(run).filter(|run| run.end != EndReason::Cancelled);
        }
        ReportBody::Failed(text) => {
            let text = format!("pinned run {}: {text}", pin.letter);
            app.refuse(text);
        }
        ReportBody::Progress { .. } | ReportBody::Part(_) | ReportBody::Ended(_) => {}
    }
}
