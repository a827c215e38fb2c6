//! Tests of the worker. Its clock moves with each look at it, so that no test depends on the speed of the machine.

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use super::runs::run;
use super::studies::{Asked, Claims, Found, LimitSearch, Picture, PictureSweep, StiffScenes};
use super::study::{Reporter, RowsSoFar};
use super::{JobProgress, Report, ReportBody, SceneRun, Slot, Task, Worker};
use crate::model::run::{EndReason, Run};
use crate::model::scene::{InterfaceLaw, Scene};
use crate::model::simulate::{self, Look};
use crate::study::context::Context;
use crate::study::sweep::grid::Grid;
use crate::study::sweep::{Axis, Plan, Spacing, USUAL_OUTPUTS};
use crate::study::thesis::{Row, claims};

/// A test that waits so long hangs.
const HANG: Duration = Duration::from_secs(120);

/// What the clock moves on with each look.
const TICK: Duration = Duration::from_millis(5);

/// Steps of the endless run that is to be cancelled.
static STEPS: AtomicUsize = AtomicUsize::new(0);

/// Does a task as its title says: a run goes on until it is cancelled, or panics; a study counts its points.
fn make(task: &Task, reporter: &Reporter<'_>) -> Result<Found, Box<dyn Error>> {
    match (&task.asked, task.scene.title.is_empty()) {
        (Asked::Run(_), true) | (Asked::Picture(_), _) => task.asked.make(&task.scene, reporter),
        (Asked::Run(slot), false) => slow_run(slot.0, &task.scene, reporter),
        (_, _) => Ok(count_points(task.scene.title == "endless", reporter).into()),
    }
}

/// Runs the real simulation of the scene, then pretends to need steps until cancelled when the title says so.
fn slow_run(
    slot: Slot,
    scene: &Arc<Scene>,
    reporter: &Reporter<'_>,
) -> Result<Found, Box<dyn Error>> {
    run(slot, scene, reporter, |settings, observer| {
        let go_on = &mut |_: &Look<'_>| ControlFlow::Continue(());
        let mut run = simulate::simulate(scene, settings, go_on).map_err(|it| it.to_string())?;
        assert!(scene.title != "panics", "deliberate");
        let mut t_s = 0.0;
        if scene.title.starts_with("endless") {
            while observer(&Look { t_s, so_far: &|| None }).is_continue() {
                t_s += 1e-9;
                if scene.title.ends_with("counted") {
                    STEPS.fetch_add(1, Ordering::SeqCst);
                }
            }
            run.end = EndReason::Cancelled;
        }
        Ok(run)
    })
}

/// Shows its points as it counts them, and goes on until it is cancelled where it is endless.
fn count_points(endless: bool, reporter: &Reporter<'_>) -> RowsSoFar<Row> {
    let watch = &mut reporter.watch(|done: &usize| rows(*done));
    let context = &mut Context::new(reporter.threads, watch);
    let mut done = 0;
    while context.show(&done) && (endless || done < 3) {
        done += 1;
        context.count(1);
    }
    rows(done)
}

/// So many rows.
fn rows(count: usize) -> RowsSoFar<Row> {
    let (computed, as_printed) = <(String, String)>::default();
    let row = Row { claim: claims().next().expect("one"), computed, as_printed, holds: true };
    RowsSoFar { rows: vec![row; count], is_complete: false }
}

fn run_of(id: u64, slot: Slot, scene: Scene) -> Task {
    Task { id, threads: 1, scene: Arc::new(scene), asked: SceneRun(slot).into() }
}

fn job(id: u64, slot: Slot, title: &str) -> Task {
    run_of(id, slot, Scene { title: title.to_owned(), ..Scene::default() })
}

/// The run a report ends with, and the time it took.
fn ended(body: ReportBody) -> (Arc<Run>, Duration) {
    match body {
        ReportBody::Ended { found: Some(Found::Run(run)), took } => (run, took),
        other => panic!("not a run: {other:?}"),
    }
}

fn start() -> (Worker, Receiver<Report>) {
    let (send, receive) = mpsc::channel();
    let sink = move |report| drop(send.send(report));
    let looks = AtomicU64::new(0);
    let clock = move || TICK * u32::try_from(looks.fetch_add(1, Ordering::Relaxed)).expect("few");
    (Worker::with(Arc::new(clock), make, sink).expect("a thread"), receive)
}

fn next(reports: &Receiver<Report>) -> Report {
    reports.recv_timeout(HANG).expect("a report in time")
}

/// The next report that ends a job.
fn next_last(reports: &Receiver<Report>) -> Report {
    loop {
        let report = next(reports);
        if report.body.is_last() {
            return report;
        }
    }
}

/// Wait until the running job says that it has begun.
fn await_started(reports: &Receiver<Report>, id: u64) {
    let report = next(reports);
    assert_eq!(report.id, id);
    let begun = JobProgress::Time(0.0);
    assert!(
        matches!(report.body, ReportBody::Progress { progress, .. } if progress == begun),
        "{report:?}"
    );
}

#[test]
fn a_running_job_is_cancelled_at_its_next_step_and_keeps_its_part() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Current, "endless, counted"));
    await_started(&reports, 1);
    worker.cancel(1);
    let steps = STEPS.load(Ordering::SeqCst);
    let report = next_last(&reports);
    assert_eq!(report.id, 1);
    assert_eq!(ended(report.body).0.end, EndReason::Cancelled);
    assert!(STEPS.load(Ordering::SeqCst) <= steps + 1);
}

#[test]
fn the_newest_job_of_a_slot_wins_over_running_and_waiting_ones() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Current, "endless"));
    await_started(&reports, 1);
    worker.submit(job(2, Slot::Pin('A'), "pin"));
    worker.submit(job(3, Slot::Pin('A'), "newer pin"));
    let replaced = next_last(&reports);
    assert_eq!(replaced.id, 2);
    assert!(matches!(replaced.body, ReportBody::Ended { found: None, .. }));
    worker.submit(job(4, Slot::Current, "newer"));
    let ends: Vec<_> = (0..3)
        .map(|_| {
            let report = next_last(&reports);
            (report.id, ended(report.body).0.end != EndReason::Cancelled)
        })
        .collect();
    // The screen's scene goes before the pinned one.
    assert_eq!(ends, [(1, false), (4, true), (3, true)]);
}

#[test]
fn a_job_of_another_slot_does_not_cancel() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Pin('A'), "endless"));
    await_started(&reports, 1);
    worker.submit(job(2, Slot::Pin('B'), "short"));
    // Still alive long enough to make progress.
    let report = next(&reports);
    assert_eq!(report.id, 1);
    assert!(
        matches!(report.body, ReportBody::Progress { progress: JobProgress::Time(t_s), .. } if t_s > 0.0),
        "{report:?}"
    );
    worker.cancel(1);
    worker.cancel(2);
    let mut ended = [next_last(&reports).id, next_last(&reports).id];
    ended.sort_unstable();
    assert_eq!(ended, [1, 2]);
}

#[test]
fn progress_comes_at_most_twice_a_second() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Current, "endless"));
    await_started(&reports, 1);
    let progress = || loop {
        if let ReportBody::Progress { elapsed, .. } = next(&reports).body {
            break elapsed;
        }
    };
    let (first, second) = (progress(), progress());
    assert!(second >= first + Duration::from_millis(500), "{first:?}, {second:?}");
    worker.cancel(1);
    next_last(&reports);
}

/// A scene whose run does not end by itself: the plate oscillates for thirty years.
fn swinging(id: u64, slot: Slot) -> Task {
    let mut scene = Scene::default();
    scene.mechanism.spring.exponent = 0.3;
    scene.run.horizon_s = Some(1e9);
    run_of(id, slot, scene)
}

#[test]
fn a_slow_run_of_the_screen_shows_its_own_rows_so_far_and_one_of_a_pin_does_not() {
    let (worker, reports) = start();
    worker.submit(swinging(1, Slot::Current));
    let part = || loop {
        let report = next(&reports);
        assert_eq!(report.id, 1);
        if let ReportBody::Part(Found::Run(run)) = report.body {
            break run;
        }
    };
    let (first, second) = (part(), part());
    worker.cancel(1);
    let (whole, _) = ended(next_last(&reports).body);
    assert_eq!(whole.end, EndReason::Cancelled);
    // Each is the run as it was then, not another computation of it.
    assert_eq!(first.end, EndReason::Cancelled);
    assert!(Arc::ptr_eq(&first.scene, &whole.scene));
    assert!(first.first_arrest.is_some() && first.first_arrest == whole.first_arrest);
    for part in [&first, &second] {
        let rows = part.series.len();
        assert!(rows > 100 && part.series[..] == whole.series[..rows], "{rows} rows");
        assert!(part.series.windows(2).all(|pair| pair[0].t_s <= pair[1].t_s));
    }
    let reached = |run: &Run| run.series.last().map(|row| row.t_s);
    assert!(reached(&first) < reached(&second));
    worker.submit(swinging(2, Slot::Pin('A')));
    // Progress comes after half a second, a curve would have come before.
    loop {
        match next(&reports).body {
            ReportBody::Progress { progress: JobProgress::Time(t_s), .. } if t_s > 0.0 => break,
            body => assert!(matches!(body, ReportBody::Progress { .. }), "{body:?}"),
        }
    }
    worker.cancel(2);
    assert_eq!(ended(next_last(&reports).body).0.end, EndReason::Cancelled);
}

#[test]
fn a_panic_is_reported_and_the_worker_lives_on() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Current, "panics"));
    let report = next(&reports);
    let ReportBody::Failed(text) = report.body else {
        panic!("not failed: {:?}", report.body);
    };
    assert!(text.starts_with("internal error: deliberate"), "{text}");
    worker.submit(job(2, Slot::Current, "short"));
    ended(next_last(&reports).body);
}

fn study(id: u64, asked: impl Into<Asked>, endless: bool) -> Task {
    let title = if endless { "endless" } else { "short" }.to_owned();
    let scene = Arc::new(Scene { title, ..Scene::default() });
    Task { id, threads: 2, scene, asked: asked.into() }
}

/// The number of rows in a report, if any.
fn count(body: &ReportBody) -> Option<usize> {
    Some(body.found::<RowsSoFar<Row>>()?.rows.len())
}

#[test]
fn the_newest_study_of_a_type_wins_and_each_ends_once() {
    let (worker, reports) = start();
    worker.submit(study(1, Claims, true));
    // Under way, so that it is not dropped unstarted.
    while count(&next(&reports).body).is_none() {}
    worker.submit(study(2, Claims, false));
    let first = next_last(&reports);
    assert!(first.id == 1 && count(&first.body).is_some());
    let second = next_last(&reports);
    assert_eq!((second.id, count(&second.body)), (2, Some(3)));
}

#[test]
fn a_study_of_another_type_waits_in_its_lane_and_passes_in_another() {
    let (worker, reports) = start();
    worker.submit(study(1, Claims, true));
    worker.submit(study(2, StiffScenes, false));
    worker.submit(study(3, LimitSearch, false));
    assert_eq!(next_last(&reports).id, 3);
    worker.cancel(1);
    let ends = [next_last(&reports).id, next_last(&reports).id];
    assert_eq!(ends, [1, 2]);
}

#[test]
fn a_cancelled_study_keeps_its_reported_part() {
    let (worker, reports) = start();
    worker.submit(study(7, Claims, true));
    let mut shown = None;
    while shown.is_none_or(|shown| shown < 2) {
        shown = count(&next(&reports).body).or(shown);
    }
    worker.cancel(7);
    assert!(count(&next_last(&reports).body) >= shown);
}

/// With a plastic interface each of its 160 000 points takes long enough.
#[test]
fn a_long_sweep_shows_a_coarse_picture_and_keeps_it_when_cancelled() {
    let mut scene = Scene::default();
    scene.interface.law = InterfaceLaw::Plastic;
    let axis = |name, from, to| Axis::new(name, (from, to), 400, Spacing::Linear).unwrap();
    let axes = vec![axis("gamma", 0.8, 7.0), axis("k", 0.0, 7.5e6)];
    let plan = Arc::new(Plan::new(&scene, axes, &USUAL_OUTPUTS).unwrap());
    let (worker, reports) = start();
    worker.submit(study(1, PictureSweep { picture: Picture::Surface, plan }, false));
    let part = loop {
        if let Some(part) = next(&reports).body.found::<Grid>() {
            break part;
        }
    };
    let done = part.progress().0;
    assert!(done >= 25 * 25, "the coarsest pass at least: {done}");
    worker.cancel(1);
    let kept = next_last(&reports).body.found::<Grid>().expect("a grid");
    assert!(!kept.is_complete() && kept.progress().0 >= done);
}

#[test]
fn an_invalid_scene_is_refused_with_the_reason() {
    let (worker, receive) = start();
    let mut wrong = Scene::default();
    wrong.projectile.mass_kg = -1.0;
    let refused = crate::model::variables::validate(&wrong);
    let expected = refused.expect_err("a negative mass is refused").to_string();
    worker.submit(run_of(1, Slot::Current, wrong));
    let report = next(&receive);
    assert!(matches!(&report.body, ReportBody::Failed(text) if *text == expected), "{report:?}");
}
