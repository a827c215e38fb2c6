//! The last few results by scene: running an unchanged scene again, or undoing an edit, is free.
//!
//! The time told with a result is that of the computation that made it. Knows no threads.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Duration;

use crate::model::run::Run;
use crate::model::scene::Scene;

/// Results kept. A result is some 100 kB, most of it its series.
const KEPT: usize = 8;

/// Rows of series that the results kept have together, but for the newest one: a run of millions of steps has hundreds of
/// megabytes of them.
const ROWS_KEPT: usize = 400_000;

/// The last few results, newest first.
#[derive(Default)]
pub struct Cache {
    kept: VecDeque<(Arc<Run>, Duration)>,
}

impl Cache {
    /// The result of this scene and the time it took, s, if it is still kept. It then counts as the newest.
    pub fn find(&mut self, scene: &Scene) -> Option<(Arc<Run>, Duration)> {
        let at = self.kept.iter().position(|(run, _)| *run.scene == *scene)?;
        let found = self.kept.remove(at)?;
        self.kept.push_front(found.clone());
        Some(found)
    }

    /// Keep a complete result; the one unused for longest goes.
    pub fn keep(&mut self, run: Arc<Run>, took: Duration) {
        self.kept.push_front((run, took));
        let mut rows = 0;
        let few = self.kept.iter().take_while(|(run, _)| {
            rows += run.series.len();
            rows <= ROWS_KEPT
        });
        let few = few.count().clamp(1, KEPT);
        self.kept.truncate(few);
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::model::simulate::{Settings, simulate};

    /// A run with so many rows.
    fn run(rows: usize) -> Arc<Run> {
        let settings = Settings { series: true, ..Settings::default() };
        let scene = Arc::new(Scene::default());
        let go_on = &mut |_| ControlFlow::Continue(());
        let mut run = simulate(&scene, &settings, go_on).unwrap();
        let row = run.series[0];
        run.series.resize(rows, row);
        Arc::new(run)
    }

    #[test]
    fn few_results_are_kept_and_of_great_ones_fewer() {
        let mut cache = Cache::default();
        let small = run(1000);
        for _ in 0..20 {
            cache.keep(Arc::clone(&small), Duration::ZERO);
        }
        assert_eq!(Arc::strong_count(&small), 1 + KEPT);
        let great = run(ROWS_KEPT / 2);
        for _ in 0..3 {
            cache.keep(Arc::clone(&great), Duration::ZERO);
        }
        assert_eq!((Arc::strong_count(&great), Arc::strong_count(&small)), (3, 1));
        // The newest one stays, however great.
        let greater = run(2 * ROWS_KEPT);
        cache.keep(Arc::clone(&greater), Duration::ZERO);
        assert_eq!((Arc::strong_count(&greater), Arc::strong_count(&great)), (2, 1));
        assert!(cache.find(&greater.scene).is_some());
    }
}
