//! A window into a run that goes on: its own rows so far, for whoever watches. Nobody who does not ask pays for it.

use std::cell::{Cell, RefCell};

use crate::model::run::Run;

/// Asked for by the observer, filled by the run at its next step.
#[derive(Debug, Default)]
pub struct Window {
    wanted: Cell<bool>,
    run: RefCell<Option<Run>>,
}

impl Window {
    /// Ask for the run so far.
    pub fn ask(&self) {
        self.wanted.set(true);
    }

    /// What was put in since it was asked for: the run as if it had been cancelled there, or whole but for its error estimate.
    pub fn take(&self) -> Option<Run> {
        self.run.take()
    }

    /// Put in the run so far, if somebody has asked.
    pub(super) fn show(&self, so_far: impl FnOnce() -> Run) {
        if self.wanted.replace(false) {
            self.run.replace(Some(so_far()));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;
    use crate::model::impact::{Settings, simulate_openly};
    use crate::model::run::{EndReason, Sample, Warning};
    use crate::model::scene::Scene;

    /// Looks after so many steps of a run that swings on, and the run itself, ended after so many.
    fn looks(after: &[usize], end: usize) -> (Vec<Run>, Run) {
        let mut scene = Scene::default();
        scene.mechanism.spring.exponent = 0.3;
        scene.run.horizon_s = Some(1e3);
        let window = Window::default();
        let (mut steps, mut parts) = (0, Vec::new());
        let mut observer = |_: f64| {
            steps += 1;
            parts.extend(window.take());
            if after.contains(&steps) {
                window.ask();
            }
            if steps > end { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let settings = Settings { series: true, estimate: false };
        let whole = simulate_openly(&Arc::new(scene), &settings, &mut observer, &window).unwrap();
        (parts, whole)
    }

    fn is_in_order(rows: &[Sample]) -> bool {
        rows.windows(2).all(|pair| pair[0].t_s <= pair[1].t_s && pair[0] != pair[1])
    }

    /// Not thinned yet, a run has every row of a look at it.
    #[test]
    fn every_row_of_a_look_is_one_of_the_runs_own_in_their_order() {
        let (parts, whole) = looks(&[500, 2_000, 5_000], 6_000);
        assert!(parts.len() == 3 && whole.end == EndReason::Cancelled);
        assert!(is_in_order(&whole.series));
        for part in parts {
            assert!(part.series.len() > 3_000 && is_in_order(&part.series));
            let mut own = whole.series.iter();
            for row in &part.series {
                assert!(own.any(|one| one == row), "{row:?}");
            }
        }
    }

    /// What a run thins later, an earlier look may still have: the rows of both begin alike and stay in order.
    #[test]
    fn a_look_at_a_run_that_is_thinned_later_begins_with_its_rows() {
        let (parts, whole) = looks(&[20_000], 110_000);
        let is_thinned = |warning: &Warning| matches!(warning, Warning::SeriesThinned { .. });
        assert!(whole.warnings.iter().any(is_thinned));
        assert!(is_in_order(&whole.series) && is_in_order(&parts[0].series));
        assert_eq!(parts[0].series[..4_000], whole.series[..4_000]);
    }
}
