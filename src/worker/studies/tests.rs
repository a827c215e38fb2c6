//! Studies replace, stop and pass each other as they should.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use super::*;
use crate::worker::{Report, Task, Work, Worker};

const PATIENCE: Duration = Duration::from_secs(60);
/// A time at which the battery leaves the other methods out.
const LATE_S: f64 = 60.0;

fn study(id: u64, kind: StudyKind) -> Task {
    Task { id, threads: 2, work: Work::Study(Arc::default(), kind) }
}

/// The threads, and what they report.
fn spawned() -> (Worker, Receiver<Report>) {
    let (send, reports) = mpsc::channel();
    let worker = Worker::spawn(move |report| {
        // The test may be over.
        let _ = send.send(report);
    });
    (worker.unwrap(), reports)
}

/// The next report that ends a study, and what it found.
fn ended(reports: &Receiver<Report>) -> (u64, Option<Finding>) {
    loop {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        match report.body {
            ReportBody::Ended { found, .. } => return (report.id, found),
            ReportBody::Failed(text) => panic!("{text}"),
            ReportBody::Progress { .. } | ReportBody::Part(_) => {}
        }
    }
}

/// A reporter that nobody listens to, and that is cancelled once it was asked so often.
fn with_reporter<T>(asked_most: usize, work: impl FnOnce(&Reporter<'_>) -> T) -> T {
    let (asked, cancel) = (AtomicUsize::new(0), Arc::new(AtomicBool::new(false)));
    let send = |_| {
        if asked.fetch_add(1, Ordering::Relaxed) >= asked_most {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    work(&Reporter::eager(&send, &cancel))
}

#[test]
fn a_newer_study_stops_the_older_and_each_ends_once() {
    let (worker, reports) = spawned();
    worker.submit(study(1, StudyKind::Accuracy(Effort::QUICK)));
    worker.submit(study(2, StudyKind::Accuracy(Effort::QUICK)));
    let first = ended(&reports).0;
    let (second, found) = ended(&reports);
    assert_eq!((first, second), (1, 2));
    assert!(matches!(found, Some(Finding::Accuracy(report)) if report.is_complete));
}

#[test]
fn a_cancelled_study_keeps_what_it_has() {
    let (worker, reports) = spawned();
    worker.submit(study(7, StudyKind::Accuracy(Effort::FULL)));
    while !matches!(
        reports.recv_timeout(PATIENCE).expect("a report in time").body,
        ReportBody::Progress { .. }
    ) {}
    worker.cancel(7);
    let (_, found) = ended(&reports);
    assert!(matches!(found, Some(Finding::Accuracy(report)) if !report.is_complete));
}

#[test]
fn a_battery_on_two_threads_has_every_scene_once_in_its_order() {
    // The other methods are left out: their time is past.
    let cases = stability::battery(true);
    let found = with_reporter(usize::MAX, |reporter| battery(&cases, 2, &|| LATE_S, reporter));
    let Ok(Finding::Battery(rows, true)) = found else { panic!("not the whole battery") };
    let names: Vec<&str> = rows.iter().map(|row| row.case.name).collect();
    assert_eq!(names, cases.iter().map(|case| case.name).collect::<Vec<_>>());
}

#[test]
fn a_stopped_battery_keeps_what_it_has() {
    let cases = stability::battery(false);
    let found = with_reporter(6, |reporter| battery(&cases, 2, &|| LATE_S, reporter));
    let Ok(Finding::Battery(rows, false)) = found else { panic!("the whole battery") };
    assert!(rows.len() < cases.len());
}

/// Not only between two scenes: one may take seconds.
#[test]
fn a_battery_is_stopped_within_a_scene() {
    let mut cases = stability::battery(false).into_iter();
    let case = cases.find(|case| case.name == "plastic, n 0.22, g 0").unwrap();
    // It has millions of steps, and is stopped while it runs.
    let mut asked = 0;
    let watch = &mut |_: Progress, _: Option<&[Row]>| {
        asked += 1;
        if asked > 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let context = &mut Context::new(1, watch);
    let rows = stability::run(&[case], &|| LATE_S, context).unwrap();
    assert!(rows.is_empty() && context.is_stopped());
}

/// Not only between two claims: the longest take most of a second.
#[test]
fn the_claims_are_stopped_within_a_claim() {
    // Several are checked side by side: those that run when it is stopped are left out, and none is begun after them.
    let Finding::Thesis(rows, false) = with_reporter(6, |it| claims(2, it)) else {
        panic!("all the claims")
    };
    let all = thesis::claims().len();
    assert!(rows.len() < all / 2, "{} of {all}", rows.len());
}

#[test]
fn an_impossible_scene_is_refused_in_words() {
    let (worker, reports) = spawned();
    let mut scene = Scene::default();
    scene.projectile.mass_kg = -1.0;
    let work = Work::Study(Arc::new(scene), StudyKind::Accuracy(Effort::QUICK));
    worker.submit(Task { id: 1, threads: 1, work });
    let report = reports.recv_timeout(PATIENCE).expect("a report in time");
    assert!(matches!(report.body, ReportBody::Failed(text) if text.contains("m_p")));
}

#[test]
fn a_limit_is_found_and_a_stopped_one_says_so() {
    let (worker, reports) = spawned();
    let passage = |sampling| {
        let criterion = limit::Criterion::Passage;
        StudyKind::Limit(limit::Effort { criterion, sampling })
    };
    let found = || match ended(&reports).1 {
        Some(Finding::Limit(found)) => found,
        other => panic!("no limit: {other:?}"),
    };
    // A rigid mount has its limit in closed form (model page, section 2).
    let mut scene = Scene::default();
    scene.plate.mount = crate::model::scene::Mount::Rigid;
    let work = Work::Study(Arc::new(scene), passage(None));
    worker.submit(Task { id: 1, threads: 1, work });
    let limit_m_s = found().limit.velocity_m_s().expect("a limit");
    assert!((limit_m_s - 232.295_378).abs() < 5e-7, "{limit_m_s}");
    let sampling = limit::monte_carlo::Sampling {
        deviation: 0.02,
        samples: 1_000_000,
        seed: 1,
        model: limit::monte_carlo::ModelError::default(),
    };
    worker.submit(study(2, passage(Some(sampling))));
    while !matches!(
        reports.recv_timeout(PATIENCE).expect("a report in time").body,
        ReportBody::Progress { .. }
    ) {}
    worker.cancel(2);
    assert!(!found().is_complete);
}

#[test]
fn studies_of_different_kinds_do_not_stop_each_other() {
    let (worker, reports) = spawned();
    worker.submit(study(1, StudyKind::Accuracy(Effort::QUICK)));
    worker.submit(study(2, StudyKind::Map(map::Method::Rk4, map::Axis::K)));
    for _ in 0..2 {
        match ended(&reports).1 {
            Some(Finding::Accuracy(report)) => assert!(report.is_complete),
            Some(Finding::Map(map)) => assert!(map.is_complete()),
            other => panic!("{other:?}"),
        }
    }
}

/// The battery goes on while a limit is found.
#[test]
fn a_limit_does_not_wait_for_the_battery() {
    let (worker, reports) = spawned();
    worker.submit(study(1, StudyKind::Battery));
    let criterion = limit::Criterion::Passage;
    let kind = StudyKind::Limit(limit::Effort { criterion, sampling: None });
    worker.submit(study(2, kind));
    assert_eq!(ended(&reports).0, 2);
    worker.cancel(1);
}
