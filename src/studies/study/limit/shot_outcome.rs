//! Outcome of a shot with respect to perforation, and bisection on it: the same rule for velocities and for thicknesses.

use std::sync::Arc;

use crate::study::first_contact::is_perforated;
use cmra_engine::model::contact_kernel::ContactEnd;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::{Criterion, Scene};
use cmra_engine::model::simulate::{Observer, Settings, simulate};
use cmra_engine::numerics::smaller;

/// Relative width below which a range of undecided shots is treated as one point.
const ONE_POINT: f64 = 1e-6;
/// Maximum number of undecided shots, each followed to the end of its budget, in the search for the boundary of an undecided range.
const UNDECIDED_MAX: usize = 8;

/// Outcome of a shot with respect to perforation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum ShotOutcome {
    Perforated,
    Stopped,
    /// Undecided at the end of the run.
    Undecided,
}

impl ShotOutcome {
    /// Returns the outcome of a shot that is decided at the first contact.
    pub(in crate::study) fn of_contact(scene: &Scene, end: &ContactEnd) -> Self {
        if is_perforated(scene, end) { Self::Perforated } else { Self::Stopped }
    }

    /// Returns the outcome of a run. A shot without enough energy to perforate is stopped, whether it is arrested or may still rebound.
    pub(in crate::study) fn from_run(run: &Run) -> Self {
        match run.shot_outcome() {
            // An unmeasured perforation counts as a perforation: the limit is that of the law.
            Outcome::Perforated | Outcome::Unmeasured => Self::Perforated,
            Outcome::Arrested | Outcome::Separated => Self::Stopped,
            Outcome::Moving => {
                let behind = run.stack.as_ref().and_then(|stack| stack.behind.last());
                let plate = behind.map_or(run, |last| last);
                let most_m = plate.penetration.final_m.or(plate.penetration.at_most_m);
                let through_m = match run.scene.target.criterion {
                    Criterion::Passage => f64::INFINITY,
                    Criterion::Protrusion => plate.scene.effective_thickness_m(),
                };
                let is_held = most_m.is_some_and(|depth| depth <= through_m);
                if is_held { Self::Stopped } else { Self::Undecided }
            }
        }
    }
}

/// Runs a shot without a series and decides its outcome. A shot that is undecided at the horizon is followed beyond it. `None` for a scene
/// that makes no physical sense.
pub(in crate::study) fn decide(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Option<(Run, ShotOutcome)> {
    let mut run = simulate(scene, settings, observer).ok()?;
    if scene.run.horizon_s.is_some() && ShotOutcome::from_run(&run) == ShotOutcome::Undecided {
        let mut own = Scene::clone(scene);
        own.run.horizon_s = None;
        run = simulate(&Arc::new(own), settings, observer).ok()?;
    }
    let verdict = ShotOutcome::from_run(&run);
    Some((run, verdict))
}

/// End of a bracket: a value and its outcome.
pub(in crate::study) type BracketEnd = (f64, ShotOutcome);

/// Bisects, to a relative width, between a value that perforates and one that does not. Returns the last value that perforates, and the
/// next value with its outcome; `None` if cancelled.
pub(in crate::study) fn edge(
    mut perforated: f64,
    mut beyond: BracketEnd,
    width: f64,
    look: &mut dyn FnMut(f64) -> Option<ShotOutcome>,
) -> Option<(f64, BracketEnd)> {
    let mut undecided = 0;
    let apart = |a: f64, b: f64| (a - b).abs() / smaller(a, b);
    while apart(perforated, beyond.0) > width && undecided < UNDECIDED_MAX {
        let middle = 0.5 * (perforated + beyond.0);
        match look(middle)? {
            ShotOutcome::Perforated => perforated = middle,
            ShotOutcome::Undecided if apart(perforated, beyond.0) > ONE_POINT => {
                undecided += 1;
                beyond = (middle, ShotOutcome::Undecided);
            }
            ShotOutcome::Stopped | ShotOutcome::Undecided => {
                beyond = (middle, ShotOutcome::Stopped);
            }
        }
    }
    Some((perforated, beyond))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ShotOutcome::{Perforated, Stopped, Undecided};

    /// Boundary search from 2 (perforated) to 1 (stopped), with undecided shots in between.
    fn found(low: f64, high: f64) -> (f64, BracketEnd) {
        let look = &mut |value: f64| {
            Some(match value {
                _ if value < low => Stopped,
                _ if value > high => Perforated,
                _ => Undecided,
            })
        };
        edge(2.0, (1.0, Stopped), 1e-10, look).unwrap()
    }

    #[test]
    fn undecided_shots_at_one_point_are_a_change_and_those_of_a_wide_gap_are_none() {
        let (high, (low, verdict)) = found(1.3 - 1e-8, 1.3 + 1e-8);
        assert_eq!(verdict, Stopped);
        assert!(high > 1.3 && (high - low).abs() < 1e-6, "{low} {high}");
        let (high, (low, verdict)) = found(1.4, 1.6);
        assert_eq!(verdict, Undecided);
        assert!((1.6..1.7).contains(&high) && (1.4..=1.6).contains(&low), "{low} {high}");
    }
}
