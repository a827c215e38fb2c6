//! Whether a shot goes through, and the edges of what no run decides: the same rule for velocities and for thicknesses.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::model::scene::{Criterion, Scene};
use crate::model::simulate::{Settings, follow, simulate};
use crate::model::units::fixed_significant;
use crate::numerics::smaller;

/// Relative width up to which undecided shots are one limit for any purpose, and that to which their edges are closed in.
pub(in crate::study) const ONE_POINT: f64 = 1e-6;
const WIDTH: f64 = 1e-10;
/// Undecided shots, each followed for long, that are spent on each edge: of one point, and of anything wider.
const UNDECIDED_MAX: usize = 8;
const UNDECIDED_WIDE: usize = 3;

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

/// A value at which no run is decided, between two with known verdicts.
pub(in crate::study) struct Gap {
    /// The side from which an answer is looked for.
    pub(in crate::study) from: (f64, ShotOutcome),
    pub(in crate::study) undecided: f64,
    /// The other side; `None`: nothing is known there.
    pub(in crate::study) to: (Option<f64>, ShotOutcome),
    /// Relative width up to which it is one point.
    pub(in crate::study) width: f64,
}

/// How the verdict changes beside a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) enum Change {
    /// At one point, between shots on either side of it.
    At {
        from: f64,
        to: f64,
        /// Whether undecided shots lie on the near side, beyond shots decided like those at the start.
        is_past_gap: bool,
    },
    /// Somewhere between the edges of the gap; nothing may be known on the other side.
    Between { from: f64, to: Option<f64> },
}

/// Significant digits with which two ends differ when written, six at least.
pub(in crate::study) fn digits_apart(low: f64, high: f64) -> usize {
    let differs =
        |digits: &usize| fixed_significant(low, *digits) != fixed_significant(high, *digits);
    (6..=15).find(differs).unwrap_or(15)
}

impl Gap {
    /// From either side as close to the undecided value as shots are decided: the verdict may change before anything is undecided,
    /// or only past all that is. `None` when stopped.
    pub(in crate::study) fn change(
        &self,
        mut look: impl FnMut(f64) -> Option<ShotOutcome>,
    ) -> Option<Change> {
        let mut undecided_max = UNDECIDED_MAX;
        for (known, verdict) in [(Some(self.from.0), self.from.1), self.to] {
            let side = |known: f64| self.width * (known - self.undecided).signum();
            let near = known.map(|known| self.undecided * (1.0 + side(known)));
            // Decided this near on both sides it may be one point, which takes more shots to close in.
            if near.map_or(Some(ShotOutcome::Undecided), &mut look)? != verdict {
                undecided_max = UNDECIDED_WIDE;
                break;
            }
        }
        let mut edge = |(mut known, verdict): (f64, ShotOutcome)| {
            let (mut beyond, mut undecided) = ((self.undecided, ShotOutcome::Undecided), 0);
            while (beyond.0 - known).abs() > WIDTH * smaller(known, beyond.0)
                && undecided < undecided_max
            {
                let middle = 0.5 * (known + beyond.0);
                let found = look(middle)?;
                undecided += usize::from(found == ShotOutcome::Undecided);
                if found == verdict { known = middle } else { beyond = (middle, found) }
            }
            Some((known, beyond))
        };
        let (from, beyond) = edge(self.from)?;
        let (to, verdict) = self.to;
        if beyond.1 == verdict {
            return Some(Change::At { from, to: beyond.0, is_past_gap: false });
        }
        let Some(to) = to else { return Some(Change::Between { from, to }) };
        let (to, beyond) = edge((to, verdict))?;
        Some(if beyond.1 == self.from.1 {
            Change::At { from: beyond.0, to, is_past_gap: true }
        } else if (to - from).abs() <= self.width * smaller(from, to) {
            Change::At { from, to, is_past_gap: false }
        } else {
            Change::Between { from, to: Some(to) }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ShotOutcome::{Perforated, Stopped, Undecided};

    /// The edges between 1 (stopped) and 2 (perforated) of shots that are undecided at 1.5, and how many were undecided.
    fn change(verdict: impl Fn(f64) -> ShotOutcome) -> (Change, usize) {
        let (from, to) = ((1.0, Stopped), (Some(2.0), Perforated));
        let mut undecided = 0;
        let look = |value: f64| {
            undecided += usize::from(verdict(value) == Undecided);
            Some(verdict(value))
        };
        let found = Gap { from, undecided: 1.5, to, width: ONE_POINT }.change(look);
        (found.unwrap(), undecided)
    }

    fn outside(low: f64, high: f64) -> impl Fn(f64) -> ShotOutcome {
        move |value| match value {
            _ if value < low => Stopped,
            _ if value > high => Perforated,
            _ => Undecided,
        }
    }

    #[test]
    fn one_point_is_closed_in_and_a_wide_gap_takes_few_shots() {
        let (found, _) = change(outside(1.5 - 1e-8, 1.5 + 1e-8));
        let Change::At { from, to, is_past_gap: false } = found else { panic!("{found:?}") };
        assert!(from < 1.5 && to > 1.5 && to - from < 1.5 * ONE_POINT, "{from} {to}");
        let (found, undecided) = change(outside(1.4, 1.6));
        let Change::Between { from, to: Some(to) } = found else { panic!("{found:?}") };
        assert!(from < 1.4 && to > 1.6 && from > 1.3 && to < 1.7, "{from} {to}");
        assert!(undecided <= 7, "{undecided}");
    }

    #[test]
    fn a_gap_beyond_the_change_of_the_verdict_does_not_count() {
        let pocket = |value: f64| match value {
            _ if value < 1.2 => Stopped,
            _ if (1.4..1.6).contains(&value) => Undecided,
            _ => Perforated,
        };
        let (found, _) = change(pocket);
        let Change::At { from, to, is_past_gap: false } = found else { panic!("{found:?}") };
        assert!(from < 1.2 && to >= 1.2 && to - from < 1e-9, "{from} {to}");
    }

    /// Shots are stopped again above undecided ones: the least that perforates is known.
    #[test]
    fn a_change_past_the_undecided_shots_is_found() {
        let island = |value: f64| match value {
            _ if (1.4..1.6).contains(&value) => Undecided,
            _ if value < 1.65 => Stopped,
            _ => Perforated,
        };
        let (found, undecided) = change(island);
        let Change::At { from, to, is_past_gap: true } = found else { panic!("{found:?}") };
        assert!(from < 1.65 && to >= 1.65 && to - from < 1e-9 && undecided <= 7, "{from} {to}");
    }

    #[test]
    fn two_ends_are_written_with_digits_that_differ() {
        assert_eq!([digits_apart(105.4, 111.6), digits_apart(10.339_119_6, 10.339_119_7)], [6, 9]);
    }
}
