//! The context of every study: progress, cancellation and the number of threads.

use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::study::parallel;
pub use crate::study::parallel::{Clock, SharedCores, Threads, Work, WorkClock};
use cmra_engine::model::simulate::RunSnapshot;

/// Steps of a run after which a study looks again whether to stop: a run may have millions of steps.
const STEPS_PER_POLL: u64 = 64;

/// How far a study is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// Pieces of work done: runs, shots, points, cases.
    pub done: usize,
    /// About how many there are.
    pub total: usize,
}

/// Extent of a study: all of it, or the part done before it was stopped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reach {
    #[default]
    /// The study ran to its end.
    Complete,
    /// The study was stopped with this progress.
    Partial(Progress),
}

impl Reach {
    /// Reach of a study with this progress, stopped or not.
    pub fn new(is_stopped: bool, progress: Progress) -> Self {
        if is_stopped { Self::Partial(progress) } else { Self::Complete }
    }

    /// Returns `true` if the study ran to its end.
    pub fn is_complete(self) -> bool {
        self == Self::Complete
    }

    /// `30 of 49 rows`: how far an incomplete study came; `None` for a complete one, and before the total is known.
    pub fn counted(self, items: &str) -> Option<String> {
        let Self::Partial(Progress { done, total }) = self else { return None };
        let items = if items.is_empty() { String::new() } else { format!(" {items}") };
        (total > 0).then(|| format!("{} of {total}{items}", done.min(total)))
    }
}

/// Result of a study as its runner hands it over: the study itself does not record how far it came.
#[derive(Clone, Debug)]
pub struct Answer<T> {
    /// Report of the study.
    pub report: T,
    /// Extent of the report.
    pub reach: Reach,
    /// Wall-clock time of the computation.
    pub elapsed: Duration,
}

impl<T> Answer<T> {
    /// Converts the report and keeps reach and elapsed time.
    pub fn map<U>(self, make: impl FnOnce(T) -> U) -> Answer<U> {
        Answer { report: make(self.report), reach: self.reach, elapsed: self.elapsed }
    }
}

/// Receives the progress of a study, and the result so far where the study has parts to show. `Break` stops the study, which
/// keeps what it has.
pub type ProgressCallback<'w, P> = &'w mut dyn FnMut(Progress, Option<&P>) -> ControlFlow<()>;

/// The flag that stops a study, as its workers see it: they hand in what they have done.
#[derive(Clone, Debug, Default)]
pub struct CancelFlag(Arc<AtomicBool>);

impl From<Arc<AtomicBool>> for CancelFlag {
    fn from(flag: Arc<AtomicBool>) -> Self {
        Self(flag)
    }
}

impl CancelFlag {
    /// Whether it is set.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// `Break` where it is set.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.is_set() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Sets or clears it.
    pub fn store(&self, is_set: bool) {
        self.0.store(is_set, Ordering::Relaxed);
    }
}

/// The context of a study whose parts are `P`.
pub struct Context<'w, P: ?Sized = ()> {
    watch: ProgressCallback<'w, P>,
    threads: Threads,
    progress: Progress,
    stop: CancelFlag,
}

impl<'w, P: ?Sized> Context<'w, P> {
    /// A context on a given number of threads.
    pub fn new(threads: impl Into<Threads>, watch: ProgressCallback<'w, P>) -> Self {
        Self {
            watch,
            threads: threads.into(),
            progress: Progress::default(),
            stop: CancelFlag::default(),
        }
    }

    /// Whether the study was stopped.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_set()
    }

    /// The flag that is set then.
    pub fn stop(&self) -> CancelFlag {
        self.stop.clone()
    }

    /// Announces a number of further pieces of work.
    pub fn expect(&mut self, more: usize) {
        self.progress.total = self.progress.total.max(self.progress.done + more);
    }

    /// Counts finished pieces of work.
    pub fn count(&mut self, done: usize) {
        self.progress.done += done;
    }

    /// Whether to go on: once stopped, always stopped.
    pub fn should_continue(&mut self) -> bool {
        self.look(None)
    }

    /// Reports progress with the partial result; returns `false` once cancelled.
    pub fn show(&mut self, part: &P) -> bool {
        self.look(Some(part))
    }

    fn look(&mut self, part: Option<&P>) -> bool {
        if !self.is_stopped() {
            let Progress { done, total } = self.progress;
            let shown = Progress { done: done.min(total), total };
            self.stop.store((self.watch)(shown, part).is_break());
        }
        !self.is_stopped()
    }

    /// Returns [`Context::should_continue`] as a control flow.
    pub fn flow(&mut self) -> ControlFlow<()> {
        self.should_continue();
        self.stop.flow()
    }

    /// Observes a run: stops it when the study is stopped.
    pub fn observer(&mut self) -> impl FnMut(&RunSnapshot<'_>) -> ControlFlow<()> {
        let mut steps = 0_u64;
        move |_| {
            steps += 1;
            if steps.is_multiple_of(STEPS_PER_POLL) {
                self.flow()
            } else {
                ControlFlow::Continue(())
            }
        }
    }

    /// Work on all threads. `take` is given each result in order, and says whether to go on.
    pub fn each<T: Send, W: FnMut(Range<u64>) -> T>(
        &mut self,
        work: Work,
        worker: impl Fn() -> W + Sync,
        mut take: impl FnMut(&mut Self, Range<u64>, T) -> bool,
    ) {
        let threads = self.threads.clone();
        let _ = parallel::map(&threads, work, worker, |news| {
            let goes_on = match news {
                Some((piece, result)) => take(self, piece, result),
                None => self.should_continue(),
            };
            self.stop.store(!goes_on);
            self.stop.flow()
        });
    }

    /// Works on these items on all threads, several at once; a stopped worker returns fewer results. `take` is given each part of the items
    /// in order with its results, and says whether to go on.
    pub fn each_of<I: Sync, T: Send, W: FnMut(&[I]) -> Vec<T>>(
        &mut self,
        (items, at_once): (&[I], u64),
        worker: impl Fn() -> W + Sync,
        mut take: impl FnMut(&mut Self, &[I], Vec<T>) -> bool,
    ) {
        let part = |piece: &Range<u64>| {
            let at = |end: u64| usize::try_from(end).unwrap_or(items.len());
            &items[at(piece.start)..at(piece.end)]
        };
        let pieces = || {
            let mut worker = worker();
            move |piece: Range<u64>| worker(part(&piece))
        };
        let work = Work { count: items.len() as u64, at_once };
        self.each(work, pieces, |context, piece, found| {
            let is_whole = found.len() == part(&piece).len();
            context.count(found.len());
            take(context, part(&piece), found) && is_whole
        });
    }

    /// The results of work, of which workers give several at once; fewer than all when stopped, and then a worker gives fewer, too.
    /// `show` is given all there are so far, and says whether to go on.
    pub fn map<T: Send, W: FnMut(Range<u64>) -> Vec<T>>(
        &mut self,
        work: Work,
        worker: impl Fn() -> W + Sync,
        mut show: impl FnMut(&mut Self, &[T]) -> bool,
    ) -> Vec<T> {
        let mut all = Vec::new();
        self.each(work, worker, |context, piece, found| {
            let is_whole = found.len() as u64 == piece.end - piece.start;
            context.count(found.len());
            all.extend(found);
            show(context, &all) && is_whole
        });
        all
    }

    /// The result of `make` for each of these items, one at a time; as [`Self::map`] otherwise. A `make` that is stopped gives `None`.
    pub fn map_items<I: Sync, T: Send>(
        &mut self,
        items: &[I],
        make: impl Fn(&I) -> Option<T> + Sync,
        show: impl FnMut(&mut Self, &[T]) -> bool,
    ) -> Vec<T> {
        let work = Work { count: items.len() as u64, at_once: 1 };
        let one = |piece: Range<u64>| {
            let at = usize::try_from(piece.start).ok();
            at.and_then(|at| make(items.get(at)?)).into_iter().collect()
        };
        self.map(work, || &one, show)
    }

    /// Work whose own pieces do not count, since it is one piece of this study.
    pub fn uncounted<T>(&mut self, work: impl FnOnce(&mut Context<'_>) -> T) -> T {
        let threads = self.threads.clone();
        work(&mut Context::new(threads, &mut |_, _| self.flow()))
    }
}

/// A watch that lets a study run to its end.
pub fn never_cancel<P: ?Sized>(_: Progress, _: Option<&P>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A watch that stops a study when more than this many pieces of work are done.
#[cfg(test)]
pub fn until<P: ?Sized>(most: usize) -> impl FnMut(Progress, Option<&P>) -> ControlFlow<()> {
    move |progress, _| {
        if progress.done > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stopped_study_stays_stopped_and_nested_work_stops_with_it() {
        let mut seen = Vec::new();
        let mut watch = |progress: Progress, part: Option<&str>| {
            seen.push((progress.done, progress.total, part.map(str::to_owned)));
            if progress.done >= 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let mut context: Context<'_, str> = Context::new(2, &mut watch);
        context.expect(2);
        context.count(1);
        assert!(context.should_continue() && context.show("part"));
        // More than was expected is shown as all of it.
        context.expect(4);
        let ask = |inner: &mut Context<'_>| {
            inner.count(7);
            inner.threads.count() == 2 && inner.should_continue()
        };
        assert!(context.uncounted(ask));
        context.count(2);
        assert!(!context.should_continue() && !context.should_continue() && context.is_stopped());
        assert!(!context.uncounted(ask));
        let mut observe = context.observer();
        let look = RunSnapshot { t_s: 0.0, so_far: &|| None };
        assert_eq!((0..64).filter(|_| observe(&look).is_break()).count(), 1);
        drop(observe);
        let part = Some("part".to_owned());
        assert_eq!(seen, [(1, 2, None), (1, 2, part), (1, 5, None), (3, 5, None)]);
    }
}
