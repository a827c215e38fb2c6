//! The last digits of a single best design: COBYLA from where the genetic search has ended. Only what it visits, keeps every
//! constraint and is better counts.

use std::cell::RefCell;

use cobyla::{RhoBeg, StopTols, minimize};

use crate::study::search::nsga::{Individual, Judged};

/// First step and last, in shares of the bounds.
const FIRST: f64 = 0.02;
const LAST: f64 = 1e-10;
/// Constraints are aimed at from within by this much, relative to their bounds: COBYLA ends on them, on either side.
const INSIDE: f64 = 1e-9;
/// Stands for an objective that does not exist, times the best known or 1.
const NONE: f64 = 1e3;

#[derive(Clone, Debug)]
pub(super) struct Trial<T> {
    pub(super) judged: Judged,
    pub(super) found: T,
    /// How far each constraint is from its bound; negative where it is broken.
    pub(super) margins: Vec<f64>,
}

/// A point as good or better, for a given number of constraints and with a given number of evaluations at most; `attempt` gives `None` once it is stopped.
pub(super) fn polish<T: Clone>(
    start: Individual<T>,
    constraints: usize,
    evaluations: usize,
    attempt: &mut dyn FnMut(&[f64]) -> Option<Trial<T>>,
) -> Individual<T> {
    let shares = start.shares.clone();
    let worst = NONE * (1.0 + start.judged.objectives[0].abs());
    let best = RefCell::new(start);
    let last: RefCell<Option<(Vec<f64>, Trial<T>)>> = RefCell::new(None);
    let attempt = RefCell::new(attempt);
    // Objective and constraints are requested one after the other: a point is run once for all of them.
    let look = |x: &[f64]| -> Option<Trial<T>> {
        let x: Vec<f64> = x.iter().map(|share| share.clamp(0.0, 1.0)).collect();
        if let Some((known, trial)) = last.borrow().as_ref()
            && *known == x
        {
            return Some(trial.clone());
        }
        let trial = (attempt.borrow_mut())(&x)?;
        if trial.judged.dominates(&best.borrow().judged) {
            let Trial { judged, found, .. } = trial.clone();
            *best.borrow_mut() = Individual { shares: x.clone(), judged, found };
        }
        *last.borrow_mut() = Some((x, trial.clone()));
        Some(trial)
    };
    let objective = |x: &[f64], (): &mut ()| {
        let value = look(x).map(|trial| trial.judged.objectives[0]);
        value.filter(|value| value.is_finite()).unwrap_or(worst)
    };
    let margin = |at: usize| {
        let look = &look;
        move |x: &[f64], (): &mut ()| {
            look(x).and_then(|trial| Some(trial.margins.get(at)? - INSIDE)).unwrap_or(-1.0)
        }
    };
    let margins: Vec<_> = (0..constraints).map(margin).collect();
    let bounds = vec![(0.0, 1.0); shares.len()];
    let tolerances = StopTols { xtol_abs: vec![LAST; shares.len()], ..StopTols::default() };
    // How it ended does not matter: the best of what it visited is kept.
    let _ = minimize(
        objective,
        &shares,
        &bounds,
        &margins,
        (),
        evaluations,
        RhoBeg::All(FIRST),
        Some(tolerances),
    );
    best.into_inner()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Problem g06 of the constrained test suite: optimum -6961.81388 at (14.095, 0.84296), between two circles.
    #[test]
    fn valid_optimum_of_g06() {
        let mut attempt = |shares: &[f64]| {
            let (x, y) = (13.0 + 87.0 * shares[0], 100.0 * shares[1]);
            let margins = vec![
                (x - 5.0).powi(2) + (y - 5.0).powi(2) - 100.0,
                82.81 - (x - 6.0).powi(2) - (y - 5.0).powi(2),
            ];
            let violation =
                margins.iter().map(|margin| if *margin < 0.0 { -margin } else { 0.0 }).sum();
            let objectives = vec![(x - 10.0).powi(3) + (y - 20.0).powi(3)];
            Some(Trial { judged: Judged { objectives, violation }, found: (), margins })
        };
        let shares = vec![(14.5 - 13.0) / 87.0, 0.018];
        let judged = attempt(&shares).unwrap().judged;
        assert!(judged.is_feasible());
        let found = polish(Individual { shares, judged, found: () }, 2, 600, &mut attempt);
        let value = found.judged.objectives[0];
        assert!(found.judged.is_feasible() && (value + 6_961.813_88).abs() < 0.01, "{value}");
        assert!((13.0 + 87.0 * found.shares[0] - 14.095).abs() < 1e-4);
    }

    #[test]
    fn a_worse_or_stopped_candidate_changes_nothing() {
        let judged = Judged { objectives: vec![1.0], violation: 0.0 };
        let start = Individual { shares: vec![0.3], judged: judged.clone(), found: () };
        assert_eq!(polish(start.clone(), 0, 100, &mut |_| None), start);
        let mut flat =
            |_: &[f64]| Some(Trial { judged: judged.clone(), found: (), margins: Vec::new() });
        assert_eq!(polish(start.clone(), 0, 100, &mut flat), start);
    }
}
