//! Measurements of run time have the machine to themselves: other studies and sweeps wait for the end of the point that is being
//! measured, and the next point waits for them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How often one that waits looks whether it is still wanted.
const LOOK: Duration = Duration::from_millis(10);

/// Who is at work: a measurement alone, or others together.
#[derive(Debug, Default)]
pub struct Quiet {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    measuring: bool,
    others: usize,
    waiting: usize,
}

impl Quiet {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until the state is as wanted; a stop ends the waiting. Whether it is.
    fn wait<'a>(
        &'a self,
        mut state: MutexGuard<'a, State>,
        stop: &AtomicBool,
        wanted: impl Fn(&State) -> bool,
    ) -> (MutexGuard<'a, State>, bool) {
        while !wanted(&state) {
            if stop.load(Ordering::Relaxed) {
                return (state, false);
            }
            let waited = self.changed.wait_timeout(state, LOOK);
            state = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        (state, true)
    }

    /// Do some work while nothing is measured; a stop ends the waiting, and the work sees it at once.
    pub(super) fn together<T>(&self, stop: &AtomicBool, work: impl FnOnce() -> T) -> T {
        let mut state = self.lock();
        state.waiting += 1;
        let (mut state, entered) = self.wait(state, stop, |state| !state.measuring);
        state.waiting -= 1;
        state.others += usize::from(entered);
        drop(state);
        let done = work();
        if entered {
            self.lock().others -= 1;
            self.changed.notify_all();
        }
        done
    }

    /// Measure while nothing else is at work; a stop ends the waiting.
    pub(super) fn alone<T>(&self, stop: &AtomicBool, work: impl FnOnce() -> T) -> T {
        self.begin(stop);
        let done = work();
        self.end();
        done
    }

    /// Begin to measure, once nothing else is at work or waits for its turn; a stop ends the waiting.
    pub(super) fn begin(&self, stop: &AtomicBool) {
        let free = |state: &State| state.others == 0 && state.waiting == 0;
        let (mut state, entered) = self.wait(self.lock(), stop, free);
        state.measuring = entered;
    }

    /// A point is measured: a waiting task has a turn.
    pub(super) fn end(&self) {
        self.lock().measuring = false;
        self.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;

    /// While a point is measured nothing else runs; between two points it does.
    #[test]
    fn nothing_runs_beside_a_measurement() {
        let (quiet, go_on) = (Quiet::default(), AtomicBool::new(false));
        let ran = AtomicBool::new(false);
        quiet.begin(&go_on);
        thread::scope(|scope| {
            scope.spawn(|| quiet.together(&go_on, || ran.store(true, Ordering::Relaxed)));
            while quiet.lock().waiting == 0 {
                thread::yield_now();
            }
            assert!(!ran.load(Ordering::Relaxed));
            quiet.end();
            // The next point waits for the work that waited.
            quiet.begin(&go_on);
            assert!(ran.load(Ordering::Relaxed));
            quiet.end();
        });
    }

    #[test]
    fn a_stop_ends_the_waiting() {
        let (quiet, stop) = (Quiet::default(), AtomicBool::new(true));
        quiet.begin(&AtomicBool::new(false));
        assert_eq!(quiet.together(&stop, || 7), 7);
    }
}
