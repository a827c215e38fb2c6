//! The threads for studies: work of seconds that must not hold up the run of an edited scene.
//!
//! On each thread one study at a time, in the order asked for; a newer one of the same kind replaces an older one. Parts are
//! shown as they grow, at most twice a second. A panic is contained. Every study submitted gets exactly one last report.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::job::contained;
use super::quiet::Quiet;
use super::searches::{self, Answer, Request};
use super::{battery, clock};
use crate::model::scene::Scene;
use crate::study::accuracy::{self, Effort};
use crate::study::limit;
use crate::study::stability::map::{self, Map};
use crate::study::stability::{self, Row};
use crate::study::thesis;

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
    /// On how many threads, where it has several.
    pub threads: usize,
}

/// What a study is of.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyKind {
    /// Error against run time of every method.
    Accuracy(Effort),
    /// Where a fixed-step method is stable.
    Map(map::Method, map::Axis),
    /// The battery of stiff and extreme scenes; the study's own scene plays no part.
    Battery,
    /// Every claim of the thesis; the study's own scene plays no part.
    Thesis,
    /// The ballistic limit.
    Limit(limit::Effort),
    /// A search for designs.
    Search(Arc<Request>),
}

impl StudyKind {
    const COUNT: usize = 7;

    /// Studies of one place replace each other.
    fn place(&self) -> usize {
        match self {
            Self::Accuracy(_) => 0,
            Self::Map(..) => 1,
            Self::Battery => 2,
            Self::Thesis => 3,
            Self::Limit(_) => 4,
            Self::Search(request) if **request == Request::Compare => 6,
            Self::Search(_) => 5,
        }
    }

    /// The thread it is made on: half a minute of measurements or of stiff scenes must not keep waiting who asks for a limit.
    fn lane(&self) -> usize {
        match self {
            Self::Accuracy(_) | Self::Battery | Self::Thesis => 0,
            Self::Map(..) | Self::Limit(_) | Self::Search(_) => 1,
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
    /// Rows of the reproduction report, and whether these are all.
    Thesis(Arc<Vec<thesis::Row>>, bool),
    /// The ballistic limit; `None` while it is looked for.
    Limit(Option<Arc<limit::Report>>),
    /// What a search has; `None` while there is nothing to show.
    Search(Option<Answer>),
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

/// The newest study of its kind: its number and its flag to stop it.
type Newest = (u64, Arc<AtomicBool>);

/// The threads' owner. They end when this is dropped.
pub struct Studies {
    /// By lane.
    ask: [Sender<Asked>; 2],
    newest: Mutex<[Option<Newest>; StudyKind::COUNT]>,
}

impl Studies {
    /// Start the threads; `sink` is given every report.
    ///
    /// # Errors
    /// When the system has no thread to give.
    pub fn spawn(
        quiet: &Quiet,
        sink: impl Fn(StudyReport) + Clone + Send + 'static,
    ) -> std::io::Result<Self> {
        let start = |name: &str| {
            let (ask, asked) = mpsc::channel();
            let (sink, quiet) = (sink.clone(), quiet.clone());
            let thread = thread::Builder::new().name(name.to_owned());
            thread.spawn(move || serve(&asked, &quiet, &sink)).map(|_| ask)
        };
        Ok(Self { ask: [start("studies")?, start("searches")?], newest: Mutex::default() })
    }

    /// Make a study; the one of its kind before it is stopped.
    pub fn submit(&self, study: Study) {
        let stop = Arc::new(AtomicBool::new(false));
        let before = self.replace(study.kind.place(), Some((study.id, Arc::clone(&stop))));
        if let Some((_, before)) = before {
            before.store(true, Ordering::Relaxed);
        }
        if self.ask[study.kind.lane()].send((study, stop)).is_err() {
            log::error!("the thread for studies has ended");
        }
    }

    /// Stop the study of this number; others go on.
    pub fn cancel(&self, id: u64) {
        let newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        for (_, stop) in newest.iter().flatten().filter(|(one, _)| *one == id) {
            stop.store(true, Ordering::Relaxed);
        }
    }

    fn replace(&self, place: usize, stop: Option<Newest>) -> Option<Newest> {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut newest[place], stop)
    }
}

impl Drop for Studies {
    fn drop(&mut self) {
        let newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        for (_, stop) in newest.iter().flatten() {
            stop.store(true, Ordering::Relaxed);
        }
    }
}

fn serve(asked: &Receiver<Asked>, quiet: &Quiet, sink: &impl Fn(StudyReport)) {
    while let Ok((study, stop)) = asked.recv() {
        let body = if matches!(study.kind, StudyKind::Accuracy(_)) {
            quiet.begin(&stop);
            let body = make(&study, &stop, quiet, sink);
            quiet.end();
            body
        } else {
            quiet.together(&stop, || make(&study, &stop, quiet, sink))
        };
        sink(StudyReport { id: study.id, body });
    }
}

fn make(
    study: &Study,
    stop: &Arc<AtomicBool>,
    quiet: &Quiet,
    sink: &impl Fn(StudyReport),
) -> StudyBody {
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
    let work = || match &study.kind {
        StudyKind::Accuracy(effort) => {
            let watch = &mut |report: &accuracy::Report, done, total| {
                // Between two points others have their turn.
                quiet.end();
                quiet.begin(stop);
                tell(done, total, &|| Finding::Accuracy(Arc::new(report.clone())))
            };
            accuracy::compare_openly(&study.scene, *effort, &mut clock::processor_s, watch)
                .map(|report| Finding::Accuracy(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        StudyKind::Map(method, axis) => {
            map::accepts(&study.scene).map_err(|error| error.to_string())?;
            let watch: map::Watch<'_> =
                &mut |done, total, map| tell(done, total, &|| Finding::Map(Arc::new(map.clone())));
            let map = map::map(&study.scene, (*method, *axis), map::CELLS, watch);
            Ok(Finding::Map(Arc::new(map)))
        }
        StudyKind::Battery => battery(study.threads.min(2), (&now_s, stop), &mut tell),
        StudyKind::Thesis => Ok(claims(&mut tell, stop)),
        StudyKind::Limit(effort) => ballistic(study, *effort, &mut tell),
        StudyKind::Search(request) => search(study, request, &mut tell),
    };
    match contained(work).0 {
        Ok(found) => StudyBody::Ended(found),
        Err(text) => StudyBody::Failed(text),
    }
}

/// Given the cases done and to do and what there is so far; `Break` stops.
type Tell<'a> = &'a mut dyn FnMut(usize, usize, &dyn Fn() -> Finding) -> ControlFlow<()>;

/// The battery on so many threads, this one among them.
fn battery(
    threads: usize,
    (now_s, asked_to_stop): (&(dyn Fn() -> f64 + Sync), &AtomicBool),
    tell: Tell<'_>,
) -> Result<Finding, String> {
    let told = &mut |done: usize, total: usize, rows: &dyn Fn() -> Vec<Row>| {
        tell(done, total, &|| Finding::Battery(Arc::new(rows()), false))
    };
    let cases = stability::battery(false);
    let total = cases.len();
    let rows = battery::run(cases, threads, (now_s, asked_to_stop), told);
    let rows = rows.map_err(|error| error.to_string())?;
    let all = rows.len() == total;
    Ok(Finding::Battery(Arc::new(rows), all))
}

/// The claims, one after the other; what there is when it is stopped is kept.
fn claims(tell: Tell<'_>, stop: &Arc<AtomicBool>) -> Finding {
    let watch = &mut |rows: &[thesis::Row], total| {
        tell(rows.len(), total, &|| Finding::Thesis(Arc::new(rows.to_vec()), false))
    };
    let rows = thesis::reproduce(watch, stop);
    let all = rows.len() == thesis::claims().len();
    Finding::Thesis(Arc::new(rows), all)
}

/// The ballistic limit; what there is when it is stopped is kept.
fn ballistic(study: &Study, effort: limit::Effort, tell: Tell<'_>) -> Result<Finding, String> {
    let watch = &mut |done, total| tell(done, total, &|| Finding::Limit(None));
    limit::find(&study.scene, effort, watch)
        .map(|report| Finding::Limit(Some(Arc::new(report))))
        .map_err(|error| error.to_string())
}

/// A search; what there is when it is stopped is kept.
fn search(study: &Study, request: &Request, tell: Tell<'_>) -> Result<Finding, String> {
    let tell: searches::Tell<'_> =
        &mut |done, total, part| tell(done, total, &|| Finding::Search(part()));
    searches::make(study, request, tell).map(|answer| Finding::Search(Some(answer)))
}

#[cfg(test)]
mod tests;
