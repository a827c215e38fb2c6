//! The studies on the threads of the worker: what they refuse, and what they keep.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use super::{Asked, Finding, Found, Picture, PictureSweep};
use crate::model::scene::{InterfaceLaw, Scene};
use crate::study::sweep::grid::Grid;
use crate::study::sweep::{Axis, Plan, Spacing, USUAL_OUTPUTS};
use crate::worker::{Report, ReportBody, Task, Worker};

/// A test that waits so long hangs.
const HANG: Duration = Duration::from_secs(120);

/// The threads with one study, and what they report. A second passes with each look at their clock, so that progress comes however
/// fast the machine is; a report that is read holds the study up until the next one is wanted.
fn begun(scene: Scene, study: impl Into<Asked>) -> (Worker, Receiver<Report>) {
    let (send, reports) = mpsc::sync_channel(0);
    let looks = AtomicU32::new(0);
    let clock = move || Duration::from_secs(1) * looks.fetch_add(1, Ordering::Relaxed);
    let worker = Worker::with_clock(Arc::new(clock), move |report| {
        // The test may be over.
        let _ = send.send(report);
    });
    let worker = worker.unwrap();
    worker.submit(Task { id: 1, threads: 2, scene: Arc::new(scene), asked: study.into() });
    (worker, reports)
}

fn next(reports: &Receiver<Report>) -> ReportBody {
    reports.recv_timeout(HANG).expect("a report in time").body
}

/// The result, or why there is none.
fn last(reports: &Receiver<Report>) -> Result<Found, String> {
    loop {
        match next(reports) {
            ReportBody::Ended { found, .. } => return Ok(found.expect("a result")),
            ReportBody::Failed(text) => return Err(text),
            ReportBody::Progress { .. } | ReportBody::Part(_) => {}
        }
    }
}

/// A sweep of a given number of points along two axes; with a plastic interface each takes longer.
fn sweep(count: u64) -> PictureSweep {
    let mut scene = Scene::default();
    scene.interface.law = InterfaceLaw::Plastic;
    let axis = |name, from, to| Axis::new(name, (from, to), count, Spacing::Linear).unwrap();
    let axes = vec![axis("gamma", 0.8, 7.0), axis("k", 0.0, 7.5e6)];
    let plan = Plan::new(&scene, axes, &USUAL_OUTPUTS).unwrap();
    PictureSweep { picture: Picture::Surface, plan: Arc::new(plan) }
}

#[test]
fn a_long_sweep_shows_a_coarse_picture_and_keeps_it_when_cancelled() {
    let (worker, reports) = begun(Scene::default(), sweep(400));
    let part = loop {
        if let ReportBody::Part(part) = next(&reports) {
            break part;
        }
    };
    let done = Grid::of(&part).expect("a grid").progress().0;
    assert!(done >= 25 * 25, "the coarsest pass at least: {done}");
    worker.cancel(1);
    let last = last(&reports).unwrap();
    let kept = Grid::of(&last).expect("a grid");
    assert!(!kept.is_complete() && kept.progress().0 >= done);
}
