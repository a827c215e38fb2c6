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
        self.kept.truncate(KEPT);
    }
}
