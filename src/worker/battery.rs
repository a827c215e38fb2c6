//! The battery of stiff and extreme scenes on several threads, row by row. Time is measured here, not in the study.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use crate::model::variables::VariableError;
use crate::study::stability::cases::Case;
use crate::study::stability::{self, Clock, Row};

/// Other methods than `auto` are left out after so many seconds.
pub(super) const OTHERS_UNTIL_S: f64 = 30.0;

/// Given the cases done and to do and the rows there are; `Break` stops.
pub type Tell<'a> = &'a mut dyn FnMut(usize, usize, &dyn Fn() -> Vec<Row>) -> ControlFlow<()>;

/// What all threads have in common.
struct Battery<'a> {
    cases: Vec<&'static Case>,
    clock: Clock<'a>,
    next: AtomicUsize,
    rows: Mutex<BTreeMap<usize, Row>>,
    failed: Mutex<Option<VariableError>>,
}

impl Battery<'_> {
    /// The next scene that nobody has; false when there is none, or when stopped.
    fn examine_next(&self) -> bool {
        let index = self.next.fetch_add(1, Ordering::Relaxed);
        let Some(case) = self.cases.get(index) else { return false };
        match stability::examine(case, self.clock) {
            Ok(Some(row)) => {
                self.rows.lock().unwrap_or_else(PoisonError::into_inner).insert(index, row);
                true
            }
            Ok(None) => false,
            Err(error) => {
                let mut failed = self.failed.lock().unwrap_or_else(PoisonError::into_inner);
                *failed = Some(error);
                false
            }
        }
    }

    /// The rows there are, in the battery's order.
    fn rows(&self) -> Vec<Row> {
        let rows = self.rows.lock().unwrap_or_else(PoisonError::into_inner);
        rows.values().cloned().collect()
    }
}

/// Run these cases on so many threads, this one among them: it alone tells how far they are, and stops them all. Gives the rows in
/// the order of the cases, and fewer than those when it was stopped.
///
/// # Errors
/// A [`VariableError`] when a case is no scene, which a test rules out.
pub fn run(
    cases: Vec<&'static Case>,
    threads: usize,
    (now_s, asked_to_stop): (&(dyn Fn() -> f64 + Sync), &AtomicBool),
    tell: Tell<'_>,
) -> Result<Vec<Row>, VariableError> {
    let stop = AtomicBool::new(false);
    let stopped = || stop.load(Ordering::Relaxed) || asked_to_stop.load(Ordering::Relaxed);
    let total = cases.len();
    let battery = Battery {
        cases,
        clock: Clock { now_s, until_s: OTHERS_UNTIL_S, stopped: &stopped },
        next: AtomicUsize::new(0),
        rows: Mutex::default(),
        failed: Mutex::default(),
    };
    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(|| while !stopped() && battery.examine_next() {});
        }
        loop {
            let done = battery.next.load(Ordering::Relaxed).min(total);
            if tell(done, total, &|| battery.rows()).is_break() || !battery.examine_next() {
                break;
            }
        }
        // Without more scenes the others end by themselves.
        if battery.next.load(Ordering::Relaxed) < total {
            stop.store(true, Ordering::Relaxed);
        }
    });
    let failed = battery.failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    let rows = battery.rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    failed.map_or_else(|| Ok(rows.into_values().collect()), Err)
}
