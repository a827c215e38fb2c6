//! The thread for studies: work of seconds that must not hold up the run of an edited scene.
//!
//! One study at a time; a newer one replaces it. Parts are shown as they grow, at most twice a second. A panic is contained.
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
        part: Arc<accuracy::Report>,
    },
    /// It is done, or was stopped and this is what it had.
    Ended(Arc<accuracy::Report>),
    /// It could not be made; the text is for the message row.
    Failed(String),
}

/// A study with its flag to stop it.
type Asked = (Study, Arc<AtomicBool>);

/// The thread's owner. The thread ends when this is dropped.
pub struct Studies {
    ask: Sender<Asked>,
    newest: Mutex<Option<Arc<AtomicBool>>>,
}

impl Studies {
    /// Start the thread; `sink` is given every report.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn(sink: impl Fn(StudyReport) + Send + 'static) -> std::io::Result<Self> {
        let (ask, asked) = mpsc::channel();
        thread::Builder::new().name("studies".to_owned()).spawn(move || serve(&asked, &sink))?;
        Ok(Self { ask, newest: Mutex::new(None) })
    }

    /// Make a study; the one before it is stopped.
    pub fn submit(&self, study: Study) {
        let stop = Arc::new(AtomicBool::new(false));
        let before = self.replace(Some(Arc::clone(&stop)));
        if let Some(before) = before {
            before.store(true, Ordering::Relaxed);
        }
        if self.ask.send((study, stop)).is_err() {
            log::error!("the thread for studies has ended");
        }
    }

    /// Stop the study that is being made.
    pub fn cancel(&self) {
        if let Some(stop) = self.replace(None) {
            stop.store(true, Ordering::Relaxed);
        }
    }

    fn replace(&self, stop: Option<Arc<AtomicBool>>) -> Option<Arc<AtomicBool>> {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut *newest, stop)
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
    let StudyKind::Accuracy(effort) = study.kind;
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64();
    let mut told = start;
    let mut watch = |report: &accuracy::Report, done: usize, total: usize| {
        if stop.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        let now = Instant::now();
        if now.duration_since(told) >= BETWEEN_PARTS {
            told = now;
            let part = Arc::new(report.clone());
            sink(StudyReport { id: study.id, body: StudyBody::Part { done, total, part } });
        }
        ControlFlow::Continue(())
    };
    let compared = || {
        accuracy::compare_openly(&study.scene, effort, &mut clock, &mut watch)
            .map_err(|error| error.to_string())
    };
    match contained(compared).0 {
        Ok(report) => StudyBody::Ended(Arc::new(report)),
        Err(text) => StudyBody::Failed(text),
    }
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
            if let StudyBody::Ended(found) = report.body {
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
            if let StudyBody::Ended(found) = report.body {
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
}
