//! The thread for studies: work of seconds that must not hold up the run of an edited scene.
//!
//! One study at a time, in the order asked for; a newer one of the same kind replaces an older one. Parts are shown as they grow, at most twice a second. A panic is contained.
//! Every study submitted gets exactly one last report.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::job::contained;
use crate::model::scene::Scene;
use crate::study::accuracy::{self, Effort};
use crate::study::stability::map::{self, Map};
use crate::study::stability::{self, Row};

/// The battery leaves other methods than `auto` out after so many seconds.
const OTHERS_UNTIL_S: f64 = 30.0;
/// Rows and columns of a map.
const MAP_CELLS: (usize, usize) = (19, 61);

/// Least time between two parts.
const BETWEEN_PARTS: Duration = Duration::from_millis(500);

/// A study to make.
#[derive(Clone, Debug)]
pub struct Study {
    /// Counts up; reports carry it.
    pub id: u64,
    /// Of which scene.
    pub scene: Arc<Scene>,
    /// What is compared.
    pub kind: StudyKind,
}

/// What a study is of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StudyKind {
    /// Error against run time of every method.
    Accuracy(Effort),
    /// Where a fixed-step method is stable.
    Map(map::Method, map::Axis),
    /// The battery of stiff and extreme scenes; the study's own scene plays no part.
    Battery,
}

impl StudyKind {
    const COUNT: usize = 3;

    /// Studies of one place replace each other.
    fn place(self) -> usize {
        match self {
            Self::Accuracy(_) => 0,
            Self::Map(..) => 1,
            Self::Battery => 2,
        }
    }
}

/// What a study found.
#[derive(Clone, Debug)]
pub enum Finding {
    /// Error against run time.
    Accuracy(Arc<accuracy::Report>),
    /// A map.
    Map(Arc<Map>),
    /// Rows of the battery, and whether these are all.
    Battery(Arc<Vec<Row>>, bool),
}

/// What the thread says of a study.
#[derive(Clone, Debug)]
pub struct StudyReport {
    /// The study.
    pub id: u64,
    /// What about it.
    pub body: StudyBody,
}

/// What a report of a study says.
#[derive(Clone, Debug)]
pub enum StudyBody {
    /// It goes on: steps done and in all, and what there is so far.
    Part {
        /// Points done.
        done: usize,
        /// Points in all.
        total: usize,
        /// What there is so far.
        part: Finding,
    },
    /// It is done, or was stopped and this is what it had.
    Ended(Finding),
    /// It could not be made; the text is for the message row.
    Failed(String),
}

/// A study with its flag to stop it.
type Asked = (Study, Arc<AtomicBool>);

/// The thread's owner. The thread ends when this is dropped.
pub struct Studies {
    ask: Sender<Asked>,
    newest: Mutex<[Option<Arc<AtomicBool>>; StudyKind::COUNT]>,
}

impl Studies {
    /// Start the thread; `sink` is given every report.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn(sink: impl Fn(StudyReport) + Send + 'static) -> std::io::Result<Self> {
        let (ask, asked) = mpsc::channel();
        thread::Builder::new().name("studies".to_owned()).spawn(move || serve(&asked, &sink))?;
        Ok(Self { ask, newest: Mutex::default() })
    }

    /// Make a study; the one of its kind before it is stopped.
    pub fn submit(&self, study: Study) {
        let stop = Arc::new(AtomicBool::new(false));
        let before = self.replace(study.kind.place(), Some(Arc::clone(&stop)));
        if let Some(before) = before {
            before.store(true, Ordering::Relaxed);
        }
        if self.ask.send((study, stop)).is_err() {
            log::error!("the thread for studies has ended");
        }
    }

    /// Stop all studies.
    pub fn cancel(&self) {
        for place in 0..StudyKind::COUNT {
            if let Some(stop) = self.replace(place, None) {
                stop.store(true, Ordering::Relaxed);
            }
        }
    }

    fn replace(&self, place: usize, stop: Option<Arc<AtomicBool>>) -> Option<Arc<AtomicBool>> {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut newest[place], stop)
    }
}

impl Drop for Studies {
    fn drop(&mut self) {
        self.cancel();
    }
}

fn serve(asked: &Receiver<Asked>, sink: &impl Fn(StudyReport)) {
    while let Ok((study, stop)) = asked.recv() {
        let body = make(&study, &stop, sink);
        sink(StudyReport { id: study.id, body });
    }
}

fn make(study: &Study, stop: &AtomicBool, sink: &impl Fn(StudyReport)) -> StudyBody {
    let start = Instant::now();
    let mut told = start;
    let mut tell = |done: usize, total: usize, part: &dyn Fn() -> Finding| {
        if stop.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        let now = Instant::now();
        if now.duration_since(told) >= BETWEEN_PARTS {
            told = now;
            let body = StudyBody::Part { done, total, part: part() };
            sink(StudyReport { id: study.id, body });
        }
        ControlFlow::Continue(())
    };
    let now_s = || start.elapsed().as_secs_f64();
    let work = || match study.kind {
        StudyKind::Accuracy(effort) => {
            let watch = &mut |report: &accuracy::Report, done, total| {
                tell(done, total, &|| Finding::Accuracy(Arc::new(report.clone())))
            };
            accuracy::compare_openly(&study.scene, effort, &mut { now_s }, watch)
                .map(|report| Finding::Accuracy(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        StudyKind::Map(method, axis) => {
            crate::model::variables::validate(&study.scene).map_err(|error| error.to_string())?;
            Ok(Finding::Map(Arc::new(map::map(&study.scene, method, axis, MAP_CELLS))))
        }
        StudyKind::Battery => battery(&now_s, &mut tell),
    };
    match contained(work).0 {
        Ok(found) => StudyBody::Ended(found),
        Err(text) => StudyBody::Failed(text),
    }
}

/// Given the cases done and to do and what there is so far; `Break` stops.
type Tell<'a> = &'a mut dyn FnMut(usize, usize, &dyn Fn() -> Finding) -> ControlFlow<()>;

fn battery(now_s: &(dyn Fn() -> f64 + Sync), tell: Tell<'_>) -> Result<Finding, String> {
    let cases = stability::battery(false);
    let clock = stability::Clock { now_s, until_s: OTHERS_UNTIL_S };
    let mut rows = Vec::new();
    for case in &cases {
        let part = || Finding::Battery(Arc::new(rows.clone()), false);
        if tell(rows.len(), cases.len(), &part).is_break() {
            break;
        }
        rows.push(stability::examine(case, clock).map_err(|error| error.to_string())?);
    }
    let all = rows.len() == cases.len();
    Ok(Finding::Battery(Arc::new(rows), all))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATIENCE: Duration = Duration::from_secs(60);

    fn study(id: u64) -> Study {
        Study { id, scene: Arc::default(), kind: StudyKind::Accuracy(Effort::QUICK) }
    }

    #[test]
    fn a_newer_study_stops_the_older_and_each_ends_once() {
        let (send, reports) = mpsc::channel();
        let studies = Studies::spawn(move |report| {
            // The test may be over.
            let _ = send.send(report);
        })
        .unwrap();
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
        let (send, reports) = mpsc::channel();
        let studies = Studies::spawn(move |report| {
            // The test may be over.
            let _ = send.send(report);
        })
        .unwrap();
        let full = StudyKind::Accuracy(Effort::FULL);
        studies.submit(Study { kind: full, ..study(7) });
        studies.cancel();
        let found = loop {
            let report = reports.recv_timeout(PATIENCE).expect("a report in time");
            if let StudyBody::Ended(Finding::Accuracy(found)) = report.body {
                break found;
            }
        };
        assert!(!found.is_complete);
    }

    #[test]
    fn an_impossible_scene_is_refused_in_words() {
        let (send, reports) = mpsc::channel();
        let studies = Studies::spawn(move |report| {
            // The test may be over.
            let _ = send.send(report);
        })
        .unwrap();
        let mut scene = Scene::default();
        scene.projectile.mass_kg = -1.0;
        studies.submit(Study { scene: Arc::new(scene), ..study(1) });
        let report = reports.recv_timeout(PATIENCE).expect("a report in time");
        assert!(matches!(report.body, StudyBody::Failed(text) if text.contains("m_p")));
    }
    #[test]
    fn studies_of_different_kinds_do_not_stop_each_other() {
        let (send, reports) = mpsc::channel();
        let studies = Studies::spawn(move |report| {
            // The test may be over.
            let _ = send.send(report);
        })
        .unwrap();
        studies.submit(study(1));
        let kind = StudyKind::Map(map::Method::Rk4, map::Axis::K);
        studies.submit(Study { kind, ..study(2) });
        let mut complete = false;
        loop {
            let report = reports.recv_timeout(PATIENCE).expect("a report in time");
            match report.body {
                StudyBody::Ended(Finding::Accuracy(found)) => complete = found.is_complete,
                StudyBody::Ended(Finding::Map(map)) => {
                    assert_eq!((map.values.len(), map.dt_s.len()), MAP_CELLS);
                    break;
                }
                StudyBody::Ended(_) | StudyBody::Part { .. } => {}
                StudyBody::Failed(text) => panic!("{text}"),
            }
        }
        assert!(complete);
    }
}
