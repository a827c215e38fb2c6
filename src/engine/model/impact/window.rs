//! A window into a run that goes on: its own rows so far, for an observer. It costs nothing unless a look is requested.

use std::cell::{Cell, RefCell};

use crate::model::run::{Run, Sample};

/// Asked for by the observer, filled by the run at its next step.
#[derive(Debug, Default)]
pub struct Window {
    wanted: Cell<bool>,
    run: RefCell<Option<Run>>,
    even: RefCell<Option<Even>>,
}

/// Rows at equal time steps.
#[derive(Debug)]
struct Even {
    dt_s: f64,
    rows: Vec<Sample>,
    rows_max: usize,
}

impl Window {
    /// Ask for the run so far.
    pub fn ask(&self) {
        self.wanted.set(true);
    }

    /// What was put in since it was requested: the run as if it had been cancelled there, or whole but for its error estimate.
    pub fn take(&self) -> Option<Run> {
        self.run.take()
    }

    /// A window that takes rows at equal time steps, at most this many.
    pub fn with_steps(dt_s: f64, rows_max: usize) -> Self {
        let even = Even { dt_s, rows: Vec::new(), rows_max };
        Self { even: RefCell::new(Some(even)), ..Self::default() }
    }

    /// The rows at equal time steps.
    pub fn rows(&self) -> Vec<Sample> {
        self.even.take().map_or_else(Vec::new, |even| even.rows)
    }

    /// Take the rows that are due up to a moment from a step's dense output.
    pub(in crate::model) fn fill(&self, to_s: f64, sample: impl Fn(f64) -> Sample) {
        if let Some(even) = &mut *self.even.borrow_mut() {
            while even.rows.len() < even.rows_max && even.rows.len() as f64 * even.dt_s <= to_s {
                even.rows.push(sample(even.rows.len() as f64 * even.dt_s));
            }
        }
    }

    /// Put in the run so far, if it was requested.
    pub(in crate::model) fn show(&self, so_far: impl FnOnce() -> Run) {
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
    use crate::model::run::EndReason;
    use crate::model::simulate::{Settings, simulate_openly};
    use crate::model::variables::scene_with;

    /// A run that oscillates on, ended after 6000 steps, has every row of the looks at it.
    #[test]
    fn every_row_of_a_look_is_one_of_the_runs_own_in_their_order() {
        let window = Window::default();
        let (mut steps, mut parts) = (0, Vec::new());
        let mut observer = |_: f64| {
            steps += 1;
            parts.extend(window.take());
            if [500, 2_000, 5_000].contains(&steps) {
                window.ask();
            }
            if steps > 6_000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let scene = Arc::new(scene_with("n=0.3 run.horizon_s=1000"));
        let whole = simulate_openly(&scene, &Settings::SERIES, &mut observer, &window).unwrap();
        assert!(parts.len() == 3 && whole.end == EndReason::Cancelled);
        let is_in_order = |rows: &[Sample]| {
            rows.windows(2).all(|pair| pair[0].t_s <= pair[1].t_s && pair[0] != pair[1])
        };
        assert!(is_in_order(&whole.series));
        for part in parts {
            assert!(part.series.len() > 3_000 && is_in_order(&part.series));
            let mut own = whole.series.iter();
            for row in &part.series {
                assert!(own.any(|one| one == row), "{row:?}");
            }
        }
    }
}
