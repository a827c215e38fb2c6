//! The curve so far of a slow run, computed beside it on a thread of its own.
//!
//! A run gives its series when it ends. While it goes on, a rougher and therefore faster computation of the same scene runs
//! ahead of it: it is broken off after a while, what it has is shown, and the next one goes twice as far. Together they cost
//! about as long as the run itself has taken, on another core, and nothing once it has ended.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::{Compute, job};
use crate::model::impact::Settings;
use crate::model::run::{EndReason, Run};
use crate::model::scene::Scene;

/// How long a run goes on before its curve so far is wanted; the first preview takes as long.
pub(super) const SLOW: Duration = Duration::from_millis(200);

/// Least time between two curves.
const BETWEEN: Duration = Duration::from_millis(500);

/// Tolerance of a preview at the least: what an eye can see.
const ROUGH: f64 = 1e-6;

/// Steps between two looks at the clock.
const STEPS_PER_LOOK: u32 = 8;

/// Compute previews until one is whole or `over` is set, and give each away.
pub(super) fn run(
    scene: &Arc<Scene>,
    compute: &Compute,
    over: &AtomicBool,
    mut show: impl FnMut(Arc<Run>),
) {
    let mut rough = (**scene).clone();
    rough.run.tolerance = if rough.run.tolerance > ROUGH { rough.run.tolerance } else { ROUGH };
    let rough = Arc::new(rough);
    let settings = Settings { series: true, estimate: false };
    let mut budget = SLOW;
    let mut shown_at: Option<Instant> = None;
    while !over.load(Ordering::Relaxed) {
        let until = Instant::now() + budget;
        let mut steps = 0_u32;
        let mut observer = |_t_s: f64| {
            steps = steps.wrapping_add(1);
            let is_late = || steps.is_multiple_of(STEPS_PER_LOOK) && Instant::now() >= until;
            if over.load(Ordering::Relaxed) || is_late() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        // A preview that fails says nothing: the run itself will.
        let (Ok(mut found), _) = job::contained(|| compute(&rough, settings, &mut observer)) else {
            return;
        };
        if over.load(Ordering::Relaxed) {
            return;
        }
        let is_whole = found.end != EndReason::Cancelled;
        let is_time = is_whole || shown_at.is_none_or(|at| at.elapsed() >= BETWEEN);
        if is_time {
            found.scene = Arc::clone(scene);
            show(Arc::new(found));
            shown_at = Some(Instant::now());
        }
        if is_whole {
            return;
        }
        budget *= 2;
    }
}
