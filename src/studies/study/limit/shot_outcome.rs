//! Whether a shot goes through, and where that changes: the same rule for velocities and for thicknesses.

use std::sync::Arc;

use crate::study::first_contact::is_perforated;
use cmra_engine::model::contact_kernel::ContactEnd;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::{Criterion, Scene};
use cmra_engine::model::simulate::{Observer, Settings, simulate};
use cmra_engine::numerics::smaller;

/// Relative width up to which undecided shots are one limit for any purpose.
const ONE_POINT: f64 = 1e-6;
/// Undecided shots, each followed as far as a run goes, that are spent on the edge of what no run decides.
const UNDECIDED_MAX: usize = 8;

/// Whether a shot goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum ShotOutcome {
    Perforated,
    Stopped,
    /// Undecided at the end of the run.
    Undecided,
}

impl ShotOutcome {
    /// Returns the outcome of a shot that the first contact decides.
    pub(in crate::study) fn of_contact(scene: &Scene, end: &ContactEnd) -> Self {
        if is_perforated(scene, end) { Self::Perforated } else { Self::Stopped }
    }

    /// A shot that has no energy left to go through is stopped, whether it is arrested or may still leave the way it came.
    pub(in crate::study) fn from_run(run: &Run) -> Self {
        match run.shot_outcome() {
            // The limit of the law is that of the law, also where it is low.
            Outcome::Perforated | Outcome::Unmeasured => Self::Perforated,
            Outcome::Arrested | Outcome::Separated => Self::Stopped,
            Outcome::Moving => {
                let behind = run.stack.as_ref().and_then(|stack| stack.behind.last());
                let plate = behind.map_or(run, |last| last);
                let most_m = plate.final_penetration_m.or(plate.penetration_at_most_m);
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

/// A shot and its verdict by bare runs of these settings; one that its horizon leaves undecided is followed beyond it. `None` for a scene
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

/// A value and its verdict.
pub(in crate::study) type BracketEnd = (f64, ShotOutcome);

/// Where shots cease to perforate on the way from a value at which they do to one at which they do not, to a relative width: the
/// last value that perforates, and the next with its verdict. `None` when stopped.
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

    /// From 2 (perforated) to 1 (stopped), with undecided shots in between.
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
