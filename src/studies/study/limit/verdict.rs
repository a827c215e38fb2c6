//! Whether a shot goes through, and where that changes: the same rule for velocities and for thicknesses.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::model::scene::{Criterion, Scene};
use crate::model::simulate::{Settings, follow, simulate};
use crate::model::units::fixed_significant;
use crate::numerics::smaller;

/// Relative width up to which undecided shots are one limit for any purpose.
const ONE_POINT: f64 = 1e-6;
/// Undecided shots, each followed for long, that are spent on each edge of what no run decides.
const UNDECIDED_MAX: usize = 8;

/// Whether a shot goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum ShotOutcome {
    Perforated,
    Stopped,
    /// Its run ended before that was decided.
    Undecided,
}

impl ShotOutcome {
    /// A shot that has no energy left to go through is stopped, whether it is arrested or may still leave the way it came.
    pub(in crate::study) fn of(run: &Run) -> Self {
        match run.shot_outcome() {
            Outcome::Perforated => Self::Perforated,
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

/// A shot and its verdict; one that is left undecided is followed for longer. `None` for a scene that makes no physical sense.
pub(in crate::study) fn decide(
    scene: &Arc<Scene>,
    observer: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Option<(Run, ShotOutcome)> {
    let mut run = simulate(scene, &Settings::BARE, observer).ok()?;
    if run.stack.is_none() && ShotOutcome::of(&run) == ShotOutcome::Undecided {
        run = follow(scene, observer).ok()?;
    }
    let verdict = ShotOutcome::of(&run);
    Some((run, verdict))
}

/// A value and its verdict.
pub(in crate::study) type Judged = (f64, ShotOutcome);

/// Where a verdict changes between two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) enum Change {
    /// Between these two, which are as near to each other as was requested, or one for any purpose.
    At(f64, f64),
    /// Somewhere between these two: runs between them are not decided.
    Between(f64, f64),
}

/// Where the verdict of `from` changes into that of `to`, as near to `from` as shots are decided, to a relative width; `None` when
/// stopped.
pub(in crate::study) fn change(
    from: Judged,
    to: Judged,
    width: f64,
    look: &mut dyn FnMut(f64) -> Option<ShotOutcome>,
) -> Option<Change> {
    let (near, beyond) = edge(from, to, width, look)?;
    if beyond.1 == to.1 {
        return Some(Change::At(near, beyond.0));
    }
    let (far, before) = edge(to, beyond, width, look)?;
    Some(if before.1 == from.1 {
        Change::At(before.0, far)
    } else if (far - near).abs() <= ONE_POINT * smaller(near, far) {
        Change::At(near, far)
    } else {
        Change::Between(near, far)
    })
}

/// The last value with the verdict of `known` on the way to another one, and the next with another verdict.
fn edge(
    (mut known, verdict): Judged,
    mut beyond: Judged,
    width: f64,
    look: &mut dyn FnMut(f64) -> Option<ShotOutcome>,
) -> Option<(f64, Judged)> {
    let mut undecided = 0;
    while (beyond.0 - known).abs() > width * smaller(known, beyond.0) && undecided < UNDECIDED_MAX {
        let middle = 0.5 * (known + beyond.0);
        let found = look(middle)?;
        undecided += usize::from(found == ShotOutcome::Undecided);
        if found == verdict { known = middle } else { beyond = (middle, found) }
    }
    Some((known, beyond))
}

/// Significant digits with which two ends differ when written, six at least.
pub(in crate::study) fn digits_apart(low: f64, high: f64) -> usize {
    let differs =
        |digits: &usize| fixed_significant(low, *digits) != fixed_significant(high, *digits);
    (6..=15).find(differs).unwrap_or(15)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ShotOutcome::{Perforated, Stopped, Undecided};

    /// From 2 (perforated) to 1 (stopped).
    fn found(verdict: impl Fn(f64) -> ShotOutcome) -> Change {
        change((2.0, Perforated), (1.0, Stopped), 1e-10, &mut |value| Some(verdict(value))).unwrap()
    }

    fn outside(low: f64, high: f64) -> impl Fn(f64) -> ShotOutcome {
        move |value| match value {
            _ if value < low => Stopped,
            _ if value > high => Perforated,
            _ => Undecided,
        }
    }

    #[test]
    fn one_point_is_a_change_and_a_wide_gap_is_none() {
        let Change::At(high, low) = found(outside(1.3 - 1e-8, 1.3 + 1e-8)) else { panic!("a gap") };
        assert!(low < 1.3 && high > 1.3 && high - low < 1e-6, "{low} {high}");
        let Change::Between(high, low) = found(outside(1.4, 1.6)) else { panic!("no gap") };
        assert!((1.3..1.4).contains(&low) && (1.6..1.7).contains(&high), "{low} {high}");
    }

    /// Shots that are not decided below a known change, and above it.
    #[test]
    fn undecided_shots_beside_the_change_leave_it_known() {
        for change in [1.65, 1.2] {
            let pocket = |value: f64| match value {
                _ if (1.4..1.6).contains(&value) => Undecided,
                _ if value < change => Stopped,
                _ => Perforated,
            };
            let Change::At(high, low) = found(pocket) else { panic!("{change}") };
            assert!(low < change && high >= change && high - low < 1e-9, "{low} {high}");
        }
    }

    #[test]
    fn two_ends_are_written_with_digits_that_differ() {
        assert_eq!([digits_apart(105.4, 111.6), digits_apart(10.339_119_6, 10.339_119_7)], [6, 9]);
    }
}
