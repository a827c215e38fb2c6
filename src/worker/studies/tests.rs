//! Studies replace, stop and pass each other as they should.

use std::sync::atomic::AtomicUsize;

use super::*;

const PATIENCE: Duration = Duration::from_secs(60);

fn study(id: u64) -> Study {
    Study { id, scene: Arc::default(), kind: StudyKind::Accuracy(Effort::QUICK), threads: 2 }
}

/// The studies' threads, and what they report.
fn spawned() -> (Studies, Receiver<StudyReport>) {
    let (send, reports) = mpsc::channel();
    let studies = Studies::spawn(&Quiet::default(), move |report| {
        // The test may be over.
        let _ = send.send(report);
    });
    (studies.unwrap(), reports)
}

#[test]
fn a_newer_study_stops_the_older_and_each_ends_once() {
    let (studies, reports) = spawned();
    studies.submit(study(1));
    studies.submit(study(2));
    let mut ended = Vec::new();
    while ended.len() < 2 {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        if let StudyBody::Ended(Finding::Accuracy(found)) = report.body {
            ended.push((report.id, found.is_complete));
        }
    }
    assert_eq!(ended[1], (2, true));
    assert_eq!(ended[0].0, 1);
}

#[test]
fn a_cancelled_study_keeps_what_it_has() {
    let (studies, reports) = spawned();
    let full = StudyKind::Accuracy(Effort::FULL);
    studies.submit(Study { kind: full, ..study(7) });
    studies.cancel(7);
    let found = loop {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        if let StudyBody::Ended(Finding::Accuracy(found)) = report.body {
            break found;
        }
    };
    assert!(!found.is_complete);
}

#[test]
fn a_battery_on_two_threads_has_every_scene_once_in_its_order() {
    let go_on = &mut |_: usize, _: usize, _: &dyn Fn() -> Finding| ControlFlow::Continue(());
    // The other methods are left out: their time is past.
    let found =
        battery(2, (&|| 2.0 * battery::OTHERS_UNTIL_S, &AtomicBool::new(false)), go_on).unwrap();
    let Finding::Battery(rows, true) = found else { panic!("not the whole battery") };
    let names: Vec<&str> = rows.iter().map(|row| row.case.name).collect();
    let cases: Vec<&str> = stability::battery(false).iter().map(|case| case.name).collect();
    assert_eq!(names, cases);
}

#[test]
fn a_stopped_battery_keeps_what_it_has() {
    let mut asked = 0;
    let stop = &mut |_: usize, _: usize, _: &dyn Fn() -> Finding| {
        asked += 1;
        if asked > 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let found =
        battery(2, (&|| 2.0 * battery::OTHERS_UNTIL_S, &AtomicBool::new(false)), stop).unwrap();
    let Finding::Battery(rows, false) = found else { panic!("the whole battery") };
    assert!(rows.len() >= 3 && rows.len() < stability::battery(false).len());
}

/// Not only between two scenes: one may take seconds.
#[test]
fn a_battery_is_stopped_within_a_scene() {
    let mut cases = stability::battery(false).into_iter();
    let case = cases.find(|case| case.name == "plastic, n 0.22, g 0").unwrap();
    let asked = AtomicUsize::new(0);
    // The clock of a scene asks before every step; it has millions.
    let stopped = || asked.fetch_add(1, Ordering::Relaxed) > 1000;
    let clock = stability::Clock { now_s: &|| 0.0, until_s: -1.0, stopped: &stopped };
    assert!(stability::examine(case, clock).unwrap().is_none());
    assert!(asked.into_inner() < 2000);
}

/// Not only between two claims: the longest take most of a second.
#[test]
fn the_claims_are_stopped_within_a_claim() {
    let stop = Arc::new(AtomicBool::new(false));
    let mut asked = 0;
    // Several are checked side by side: those that run when it is stopped are left out, and none is begun after them.
    let tell = &mut |_: usize, _: usize, _: &dyn Fn() -> Finding| {
        asked += 1;
        stop.store(asked > 3, Ordering::Relaxed);
        ControlFlow::Continue(())
    };
    let Finding::Thesis(rows, false) = claims(tell, &stop) else { panic!("all the claims") };
    let all = thesis::claims().len();
    assert!(rows.len() < all / 2, "{} of {all}", rows.len());
}

#[test]
fn an_impossible_scene_is_refused_in_words() {
    let (studies, reports) = spawned();
    let mut scene = Scene::default();
    scene.projectile.mass_kg = -1.0;
    studies.submit(Study { scene: Arc::new(scene), ..study(1) });
    let report = reports.recv_timeout(PATIENCE).expect("a report in time");
    assert!(matches!(report.body, StudyBody::Failed(text) if text.contains("m_p")));
}

#[test]
fn a_limit_is_found_and_a_stopped_one_says_so() {
    let (studies, reports) = spawned();
    let kind =
        StudyKind::Limit(limit::Effort { criterion: limit::Criterion::Passage, scattering: None });
    let found = || loop {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        if let StudyBody::Ended(Finding::Limit(Some(found))) = report.body {
            break found;
        }
    };
    // A rigid mount has its limit in closed form (model page, section 2).
    let mut scene = Scene::default();
    scene.plate.mount = crate::model::scene::Mount::Rigid;
    studies.submit(Study { scene: Arc::new(scene), kind, ..study(1) });
    let limit_m_s = found().limit.velocity_m_s().expect("a limit");
    assert!((limit_m_s - 232.295_378).abs() < 5e-7, "{limit_m_s}");
    let scattering = limit::scatter::Scattering {
        deviation: 0.02,
        samples: 1_000_000,
        seed: 1,
        model: limit::scatter::ModelError::default(),
    };
    let kind = StudyKind::Limit(limit::Effort {
        criterion: limit::Criterion::Passage,
        scattering: Some(scattering),
    });
    studies.submit(Study { kind, ..study(2) });
    studies.cancel(2);
    assert!(!found().is_complete);
}

#[test]
fn studies_of_different_kinds_do_not_stop_each_other() {
    let (studies, reports) = spawned();
    studies.submit(study(1));
    let kind = StudyKind::Map(map::Method::Rk4, map::Axis::K);
    studies.submit(Study { kind, ..study(2) });
    let (mut measured, mut mapped) = (None, None);
    while measured.is_none() || mapped.is_none() {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        match report.body {
            StudyBody::Ended(Finding::Accuracy(found)) => measured = Some(found.is_complete),
            StudyBody::Ended(Finding::Map(map)) => {
                mapped = Some((map.values.len(), map.dt_s.len()));
            }
            StudyBody::Ended(_) | StudyBody::Part { .. } => {}
            StudyBody::Failed(text) => panic!("{text}"),
        }
    }
    assert_eq!((measured, mapped), (Some(true), Some(map::CELLS)));
}

/// The battery goes on while a limit is found.
#[test]
fn who_asks_for_a_limit_does_not_wait_for_the_battery() {
    let (studies, reports) = spawned();
    studies.submit(Study { kind: StudyKind::Battery, ..study(1) });
    let kind =
        StudyKind::Limit(limit::Effort { criterion: limit::Criterion::Passage, scattering: None });
    studies.submit(Study { kind, ..study(2) });
    let first = loop {
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        if let StudyBody::Ended(_) = report.body {
            break report.id;
        }
    };
    assert_eq!(first, 2);
    studies.cancel(1);
}
