//! How much work a run may do before it ends early.

use crate::model::impact::track::Track;
use crate::model::run::{EndReason, Mode};

/// Work after which a run ends early, in Taylor expansions: about a second.
const WORK_MAX: usize = 400_000;
/// Events after which a run ends early.
const EVENTS_MAX: usize = 400_000;

/// Turns and events (five hundred oscillations) and steps after which a run that was given no horizon ends while still moving. A
/// plate on an undamped spring oscillates for ever. The first contact, which always ends, has only the limit of work.
const TURNS_MAX: usize = 1_000;
const UNDECIDED_STEPS: usize = 15_000;

impl Track<'_> {
    /// Why the run ends before anything is decided, if it has done all it may. The work is counted, never timed: the same scene
    /// ends at the same step on every machine.
    pub(super) fn budget_used_up(&self) -> Option<EndReason> {
        let in_first_contact = self.mode == Mode::Penetrating && self.record.first_arrest.is_none();
        let patience = self.problem.patience;
        let oscillates = !self.problem.horizon_is_asked
            && !in_first_contact
            && self.turns + self.event_count > TURNS_MAX * patience;
        let is_worked_off = self.work.get() > WORK_MAX;
        if oscillates && (self.steps > UNDECIDED_STEPS * patience || is_worked_off) {
            Some(EndReason::Swings)
        } else if self.event_count > EVENTS_MAX {
            Some(EndReason::EventBudget)
        } else {
            is_worked_off.then_some(EndReason::StepBudget)
        }
    }

    /// Count work done, in Taylor expansions.
    pub(super) fn worked(&self, expansions: usize) {
        self.work.set(self.work.get() + expansions);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::model::impact::problem::Problem;
    use crate::model::scene::Scene;

    #[test]
    fn work_is_counted_until_the_budget_is_used_up() {
        let problem = Problem::of(&Arc::new(Scene::default()));
        let track = Track::new(&problem, 1e-9, false);
        track.worked(WORK_MAX);
        assert_eq!(track.budget_used_up(), None);
        track.worked(1);
        assert_eq!(track.budget_used_up(), Some(EndReason::StepBudget));
    }
}
