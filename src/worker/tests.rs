//! Tests of the worker. Its clock moves with each look at it, so that no test depends on the speed of the machine.

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use super::clock::{Clock, Clocks};
use super::reporter::Reporter;
use super::runs::run;
use super::studies::{
    ChartKind, Claims, LimitSearch, PictureSweep, SearchRequest, StiffScenes, StudyRequest,
    StudyResult,
};
use super::{JobProgress, Page, ReportBody, SceneRun, Slot, Task, TaskReport, Worker};
use cmra_engine::model::run::{EndReason, Run};
use cmra_engine::model::scene::{InterfaceLaw, Scene};
use cmra_engine::model::simulate::{self, RunSnapshot};
use cmra_studies::study::context::{Answer, Context, Progress, Reach};
use cmra_studies::study::monte_carlo;
use cmra_studies::study::search::seek;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::sweep::{Axis, DEFAULT_OUTPUTS, Plan, Spacing};
use cmra_studies::study::thesis::{Row, claims};

/// A test that waits so long hangs.
const HANG: Duration = Duration::from_secs(120);

/// Advance of the clock with each reading.
const TICK: Duration = Duration::from_millis(5);

/// Steps of the endless run that is to be cancelled.
static STEPS: AtomicUsize = AtomicUsize::new(0);

/// Does a task as its title says: a run goes on until it is cancelled, or panics; a study counts its points.
fn make(task: &Task, reporter: &Reporter<'_>) -> Result<StudyResult, Box<dyn Error>> {
    match (&task.request, task.scene.title.is_empty()) {
        (StudyRequest::Run(_), true) | (StudyRequest::Picture(_), _) => {
            task.request.make(&task.scene, reporter)
        }
        (StudyRequest::Run(slot), false) => slow_run(slot.0, &task.scene, reporter),
        (_, _) => Ok(count_points(task.scene.title == "endless", reporter).into()),
    }
}

/// Runs the real simulation of the scene, then pretends to need steps until cancelled when the title says so.
fn slow_run(
    slot: Slot,
    scene: &Arc<Scene>,
    reporter: &Reporter<'_>,
) -> Result<StudyResult, Box<dyn Error>> {
    run(slot, reporter, |settings, took_s, observer| {
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let mut run = simulate::simulate(scene, settings, go_on).map_err(|it| it.to_string())?;
        assert!(scene.title != "panics", "deliberate");
        let mut t_s = 0.0;
        if scene.title.starts_with("endless") {
            while observer(&RunSnapshot { t_s, so_far: &|| None }).is_continue() {
                t_s += 1e-9;
                if scene.title.ends_with("counted") {
                    STEPS.fetch_add(1, Ordering::SeqCst);
                }
            }
            run.end = EndReason::Cancelled;
        }
        run.cost.took_s = Some(took_s());
        Ok(run)
    })
}

/// Shows its points as it counts them, and goes on until it is cancelled where it is endless.
fn count_points(endless: bool, reporter: &Reporter<'_>) -> Vec<Row> {
    let watch = &mut reporter.watch(|done: &usize| rows(*done));
    let context = &mut Context::new(reporter.threads.clone(), watch);
    let mut done = 0;
    while context.show(&done) && (endless || done < 3) {
        context.expect(1);
        done += 1;
        context.count(1);
    }
    rows(done)
}

/// So many rows.
fn rows(count: usize) -> Vec<Row> {
    let (computed, as_printed) = <(String, String)>::default();
    let row = Row { claim: claims().next().expect("one"), computed, as_printed, holds: true };
    vec![row; count]
}

fn run_of(id: u64, slot: Slot, scene: Scene) -> Task {
    let (page, request) = (Page::default(), SceneRun(slot).into());
    Task { id, page, threads: 1, budget: None, scene: Arc::new(scene), request }
}

fn job(id: u64, slot: Slot, title: &str) -> Task {
    run_of(id, slot, Scene { title: title.to_owned(), ..Scene::default() })
}

/// The run a report ends with, and the time it took.
fn ended(body: ReportBody) -> (Arc<Run>, Duration) {
    match body {
        ReportBody::Ended(Some(Answer { report: StudyResult::Run(run), elapsed, .. })) => {
            (run, elapsed)
        }
        other => panic!("not a run: {other:?}"),
    }
}

/// Clocks that move with each look at them: that of elapsed time by `wall`, those of processor time by [`TICK`].
fn clocks(wall: Duration) -> Clocks {
    let moving = |by: Duration| -> Clock {
        let looks = AtomicU64::new(0);
        Arc::new(move || by * u32::try_from(looks.fetch_add(1, Ordering::Relaxed)).expect("few"))
    };
    Clocks { wall: moving(wall), thread: moving(TICK), process: moving(TICK) }
}

fn start() -> (Worker, Receiver<TaskReport>) {
    let (send, receive) = mpsc::channel();
    let sink = move |report| drop(send.send(report));
    (Worker::with(clocks(TICK), make, sink), receive)
}

fn next(reports: &Receiver<TaskReport>) -> TaskReport {
    reports.recv_timeout(HANG).expect("a report in time")
}

/// The next report that ends a job.
fn next_last(reports: &Receiver<TaskReport>) -> TaskReport {
    loop {
        let report = next(reports);
        if report.body.is_last() {
            return report;
        }
    }
}

/// Wait until the running job says that it has begun.
fn await_started(reports: &Receiver<TaskReport>, id: u64) {
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
fn the_newest_job_of_a_slot_wins_and_each_ends_once() {
    let (worker, reports) = start();
    for (slot, id) in [(Slot::Current, 1), (Slot::Pin('A'), 3)] {
        worker.submit(job(id, slot, "endless"));
        await_started(&reports, id);
        worker.submit(job(id + 1, slot, "newer"));
        let end = || {
            let report = next_last(&reports);
            (report.id, ended(report.body).0.end != EndReason::Cancelled)
        };
        let mut ends = [end(), end()];
        ends.sort_unstable();
        assert_eq!(ends, [(id, false), (id + 1, true)]);
    }
}

#[test]
fn a_job_of_another_slot_does_not_cancel() {
    let (worker, reports) = start();
    worker.submit(job(1, Slot::Pin('A'), "endless"));
    await_started(&reports, 1);
    worker.submit(job(2, Slot::Pin('B'), "short"));
    assert_eq!(next_last(&reports).id, 2);
    // Still alive long enough to make progress.
    let report = loop {
        let report = next(&reports);
        if report.id == 1 {
            break report;
        }
    };
    assert!(
        matches!(report.body, ReportBody::Progress { progress: JobProgress::Time(t_s), .. } if t_s > 0.0),
        "{report:?}"
    );
    worker.cancel(1);
    assert_eq!(next_last(&reports).id, 1);
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
        if let ReportBody::Part(Answer { report: StudyResult::Run(run), .. }) = report.body {
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

fn study(id: u64, request: impl Into<StudyRequest>, endless: bool) -> Task {
    let title = if endless { "endless" } else { "short" }.to_owned();
    let scene = Arc::new(Scene { title, ..Scene::default() });
    Task { id, page: Page(3), threads: 2, budget: None, scene, request: request.into() }
}

/// The number of rows in a report, if any.
fn count(body: &ReportBody) -> Option<usize> {
    Some(body.found::<Vec<Row>>()?.report.len())
}

#[test]
fn the_newest_study_of_a_page_wins_and_each_ends_once() {
    let (worker, reports) = start();
    worker.submit(study(1, Claims, true));
    while count(&next(&reports).body).is_none() {}
    worker.submit(study(2, Claims, false));
    let end = || {
        let report = next_last(&reports);
        (report.id, count(&report.body).is_some(), count(&report.body) == Some(3))
    };
    let mut ends = [end(), end()];
    ends.sort_unstable();
    assert_eq!((ends[0].0, ends[0].1), (1, true));
    assert_eq!(ends[1], (2, true, true));
}

/// No study waits for another one, of another type, another page, or another search.
#[test]
fn studies_of_other_slots_run_at_once() {
    let (worker, reports) = start();
    let seek = SearchRequest::Seek(seek::Request {
        over: Axis::new("d", (0.0, 0.5), 9, Spacing::Linear).unwrap(),
        goal: "percent_of_baseline=60".parse().unwrap(),
    });
    let scatter = SearchRequest::MonteCarlo(monte_carlo::Request::default());
    worker.submit(study(1, Claims, true));
    worker.submit(study(2, scatter.clone(), true));
    worker.submit(Task { page: Page(9), ..study(3, scatter, false) });
    worker.submit(study(4, StiffScenes, false));
    worker.submit(study(5, seek, false));
    worker.submit(study(6, LimitSearch, false));
    let mut ends: Vec<u64> = (0..4).map(|_| next_last(&reports).id).collect();
    ends.sort_unstable();
    assert_eq!(ends, [3, 4, 5, 6]);
    worker.cancel(1);
    worker.cancel(2);
    let mut ends = [next_last(&reports).id, next_last(&reports).id];
    ends.sort_unstable();
    assert_eq!(ends, [1, 2]);
}

/// On a busy machine a study waits for minutes between two looks at the clocks, and may use its processor time all the same.
#[test]
fn the_time_limit_is_one_of_processor_time() {
    let (send, receive) = mpsc::channel();
    let sink = move |report| drop(send.send(report));
    let worker = Worker::with(clocks(Duration::from_secs(600)), make, sink);
    let budget = Some(Duration::from_millis(50));
    worker.submit(Task { budget, ..study(1, Claims, true) });
    let answer = next_last(&receive).body.found::<Vec<Row>>().expect("a part");
    let Reach::Partial(Progress { done, .. }) = answer.reach else { panic!("{answer:?}") };
    assert_eq!(done, 9, "the tenth look finds 50 ms");
}

/// The clock moves by 5 ms with each look at it: a budget of 50 ms ends an endless study by itself.
#[test]
fn work_with_little_time_ends_by_itself_and_says_how_far_it_came() {
    let (worker, reports) = start();
    let budget = Some(Duration::from_millis(50));
    worker.submit(Task { budget, ..study(1, Claims, true) });
    let answer = next_last(&reports).body.found::<Vec<Row>>().expect("a part");
    let Reach::Partial(Progress { done, .. }) = answer.reach else { panic!("{answer:?}") };
    assert!(done > 0 && done == answer.report.len(), "{done}");
    // Enough time: the whole.
    let budget = Some(HANG);
    worker.submit(Task { budget, ..study(2, Claims, false) });
    assert!(next_last(&reports).body.found::<Vec<Row>>().expect("all").reach.is_complete());
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
    let plan = Arc::new(Plan::new(&scene, axes, &DEFAULT_OUTPUTS).unwrap());
    let (worker, reports) = start();
    worker.submit(study(1, PictureSweep { picture: ChartKind::Surface, plan }, false));
    let part = loop {
        if let Some(part) = next(&reports).body.found::<Grid>() {
            break part.report;
        }
    };
    let done = part.progress().0;
    assert!(done >= 25 * 25, "the coarsest pass at least: {done}");
    worker.cancel(1);
    let kept = next_last(&reports).body.found::<Grid>().expect("a grid");
    assert!(!kept.reach.is_complete() && !kept.report.is_complete());
    assert!(kept.report.progress().0 >= done);
}

#[test]
fn an_invalid_scene_is_refused_with_the_reason() {
    let (worker, receive) = start();
    let mut wrong = Scene::default();
    wrong.projectile.mass_kg = -1.0;
    let refused = cmra_engine::model::variables::validate(&wrong);
    let expected = refused.expect_err("a negative mass is refused").to_string();
    worker.submit(run_of(1, Slot::Current, wrong));
    let report = next(&receive);
    assert!(matches!(&report.body, ReportBody::Failed(text) if *text == expected), "{report:?}");
}
