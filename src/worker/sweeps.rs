//! The thread for sweeps on the screen: the newest one wins, coarse pictures come first, and what is finished is kept.
//!
//! Every sweep submitted gets exactly one last report. A panic is contained. Time is measured here.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::job::contained;
use super::quiet::Quiet;
use crate::study::sweep::Plan;
use crate::study::sweep::crew::Crew;
use crate::study::sweep::grid::{self, Grid};

/// A sweep that ends before this shows nothing on the way: no picture is drawn twice for it.
const QUIET: Duration = Duration::from_millis(25);
/// Least time between two pictures of passes, and between two words of progress.
const BETWEEN_PASSES: Duration = Duration::from_millis(120);
const BETWEEN_WORDS: Duration = Duration::from_millis(500);

/// A sweep to make.
#[derive(Clone, Debug)]
pub struct SweepJob {
    /// Counts up; reports carry it.
    pub id: u64,
    /// What is swept.
    pub plan: Arc<Plan>,
    /// On how many threads.
    pub threads: usize,
}

/// What the thread says of a sweep.
#[derive(Clone, Debug)]
pub struct SweepReport {
    /// The sweep.
    pub id: u64,
    /// What about it.
    pub body: SweepBody,
}

/// What a report of a sweep says.
#[derive(Clone, Debug)]
pub enum SweepBody {
    /// A picture of what there is: a pass is finished.
    Part {
        /// The grid so far.
        grid: Arc<Grid>,
        /// Time gone.
        elapsed: Duration,
    },
    /// It goes on.
    Progress {
        /// Points done.
        done: usize,
        /// Points in all.
        total: usize,
        /// Time gone.
        elapsed: Duration,
    },
    /// It is done, or was stopped and this is what it had.
    Ended {
        /// The grid.
        grid: Arc<Grid>,
        /// Time taken.
        took: Duration,
    },
    /// It could not be made; the text is for the message row.
    Failed(String),
}

/// A sweep with its flag to stop it.
type Asked = (SweepJob, Arc<AtomicBool>);

/// The thread's owner. The thread ends when this is dropped.
pub struct Sweeps {
    ask: Sender<Asked>,
    newest: Mutex<Option<Arc<AtomicBool>>>,
}

impl Sweeps {
    /// Start the thread; `sink` is given every report.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn(
        quiet: &Quiet,
        sink: impl Fn(SweepReport) + Send + 'static,
    ) -> std::io::Result<Self> {
        let (ask, asked) = mpsc::channel();
        let quiet = quiet.clone();
        let thread = thread::Builder::new().name("sweeps".to_owned());
        thread.spawn(move || serve(&asked, &quiet, &sink))?;
        Ok(Self { ask, newest: Mutex::default() })
    }

    /// Make a sweep; the one before it is stopped.
    pub fn submit(&self, job: SweepJob) {
        let stop = Arc::new(AtomicBool::new(false));
        self.replace(Some(Arc::clone(&stop)));
        if self.ask.send((job, stop)).is_err() {
            log::error!("the thread for sweeps has ended");
        }
    }

    /// Stop the sweep.
    pub fn cancel(&self) {
        self.replace(None);
    }

    fn replace(&self, stop: Option<Arc<AtomicBool>>) {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(before) = std::mem::replace(&mut *newest, stop) {
            before.store(true, Ordering::Relaxed);
        }
    }
}

impl Drop for Sweeps {
    fn drop(&mut self) {
        self.cancel();
    }
}

fn serve(asked: &Receiver<Asked>, quiet: &Quiet, sink: &impl Fn(SweepReport)) {
    while let Ok((job, stop)) = asked.recv() {
        let tell = |body| sink(SweepReport { id: job.id, body });
        tell(quiet.together(&stop, || make(&job, &stop, &tell)));
    }
}

fn make(job: &SweepJob, stop: &AtomicBool, tell: &impl Fn(SweepBody)) -> SweepBody {
    if let Err(error) = grid::fits(&job.plan) {
        return SweepBody::Failed(error.to_string());
    }
    let Some(grid) = Grid::new(Arc::clone(&job.plan)) else {
        return SweepBody::Failed("a picture has one axis or two: take fewer axes".to_owned());
    };
    let start = Instant::now();
    let (mut pictured, mut told) = (None, start);
    let mut watch = |grid: &Grid, finished: bool| {
        let now = Instant::now();
        let elapsed = now.duration_since(start);
        let due = pictured.is_none_or(|at| now.duration_since(at) >= BETWEEN_PASSES);
        if finished && due && elapsed >= QUIET && !grid.is_complete() {
            pictured = Some(now);
            told = now;
            tell(SweepBody::Part { grid: Arc::new(grid.clone()), elapsed });
        } else if now.duration_since(told) >= BETWEEN_WORDS {
            told = now;
            let (done, total) = grid.progress();
            tell(SweepBody::Progress { done, total, elapsed });
        }
        if stop.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let crew = Crew { threads: job.threads, ..Crew::of_machine() };
    let (ended, took) = contained(|| Ok(Arc::new(grid.fill(crew, stop, &mut watch))));
    match ended {
        Ok(grid) => SweepBody::Ended { grid, took },
        Err(text) => SweepBody::Failed(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::scene::Scene;
    use crate::study::sweep::{Axis, Design, Spacing, USUAL_OUTPUTS};

    const PATIENCE: Duration = Duration::from_secs(60);

    fn job(id: u64, count: u64, plastic: bool) -> SweepJob {
        let mut scene = Scene::default();
        if plastic {
            scene.interface.law = crate::model::scene::InterfaceLaw::Plastic;
        }
        let axis = |name, from, to| Axis::new(name, (from, to), count, Spacing::Linear).unwrap();
        let axes = vec![axis("gamma", 0.8, 7.0), axis("k", 0.0, 7.5e6)];
        let plan = Plan::new(&scene, axes, Design::Factorial, &USUAL_OUTPUTS).unwrap();
        SweepJob { id, plan: Arc::new(plan), threads: 2 }
    }

    fn start() -> (Sweeps, Receiver<SweepReport>) {
        let (send, reports) = mpsc::channel();
        let sweeps = Sweeps::spawn(&Quiet::default(), move |report| {
            // The test may be over.
            let _ = send.send(report);
        })
        .unwrap();
        (sweeps, reports)
    }

    #[test]
    fn the_newest_sweep_wins_and_each_ends_once() {
        let (sweeps, reports) = start();
        sweeps.submit(job(1, 300, true));
        sweeps.submit(job(2, 5, false));
        let mut ended = Vec::new();
        while ended.len() < 2 {
            let report = reports.recv_timeout(PATIENCE).expect("a report in time");
            if let SweepBody::Ended { grid, .. } = report.body {
                ended.push((report.id, grid.is_complete()));
            }
        }
        assert_eq!(ended, [(1, false), (2, true)]);
    }

    #[test]
    fn a_long_sweep_shows_a_coarse_picture_and_keeps_it_when_stopped() {
        let (sweeps, reports) = start();
        sweeps.submit(job(7, 400, true));
        let done = loop {
            let report = reports.recv_timeout(PATIENCE).expect("a report in time");
            if let SweepBody::Part { grid, .. } = report.body {
                break grid.progress().0;
            }
        };
        assert!(done >= 25 * 25, "the coarsest pass at least: {done}");
        sweeps.cancel();
        let kept = loop {
            let report = reports.recv_timeout(PATIENCE).expect("a report in time");
            if let SweepBody::Ended { grid, .. } = report.body {
                break grid;
            }
        };
        assert!(!kept.is_complete() && kept.progress().0 >= done);
    }

    #[test]
    fn more_points_than_a_screen_needs_are_refused_in_words() {
        let (sweeps, reports) = start();
        sweeps.submit(job(1, 2000, false));
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        assert!(matches!(report.body, SweepBody::Failed(text) if text.contains("cmra sweep")));
    }
}
