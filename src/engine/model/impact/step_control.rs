//! How the steps go: their size and method, and how much work is left.

use std::cell::Cell;

use crate::model::impact::body::Body;
use crate::model::mechanism::sign;
use crate::model::run::{EndReason, Mode};
use crate::numerics::smaller;

/// Work after which a run ends early, in Taylor expansions: about a second. An event counts as one, too.
const WORK_MAX: usize = 400_000;

/// Turns and events (five hundred oscillations) and steps after which a run that was given no horizon ends while still moving. A
/// plate on an undamped spring oscillates for ever. The first contact, which always ends, has only the limit of work.
const TURNS_MAX: usize = 1_000;
const UNDECIDED_STEPS: usize = 15_000;
/// Time unit of the first expansion without the law, in times it takes to leave the neighbourhood.
const UNIT_PER_CROSSING: f64 = 4.0;

#[derive(Clone, Debug, Default)]
pub(super) struct StepControl {
    pub(super) unit_s: f64,
    /// The implicit method has this stretch.
    pub(super) stiff: bool,
    /// Steps since the mode changed or the force on the plate changed its sign.
    pub(super) stretch_steps: usize,
    /// Taylor steps in a row in which the plate crept against its damper.
    pub(super) stiffness_signs: usize,
    /// Times the force on the plate changed its sign: twice an oscillation.
    pub(super) turns: usize,
    /// The sign of the force on the plate at the last step.
    pub(super) pushed: f64,
    pub(super) steps: usize,
    pub(super) stiff_steps: usize,
    pub(super) rejected: usize,
    pub(super) evaluations: usize,
    /// Work done, in Taylor expansions.
    pub(super) work: Cell<usize>,
    /// Events that changed what the bodies do.
    pub(super) event_count: usize,
    /// Where a crossing step through the zero of the spring, and of the damper, was refused last on the approach, m and m/s.
    pub(super) crossing_refused: [f64; 2],
    /// Where the last crossing step out of each zero ended, m and m/s; 0 once the direction has changed.
    pub(super) crossed_to: [f64; 2],
    /// What crossing steps that the depth depends on may be off by, relative.
    pub(super) crossing_error: f64,
    /// The second computation, which the first is compared with.
    pub(super) is_second: bool,
}

impl StepControl {
    pub(super) fn new(unit_s: f64) -> Self {
        Self { unit_s, crossing_refused: [f64::INFINITY; 2], ..Self::default() }
    }

    /// Count how often the force on the plate changes its sign, by its acceleration at every step.
    pub(super) fn count_turns(&mut self, acceleration: f64) {
        let pushed = sign(acceleration);
        if pushed * self.pushed < 0.0 {
            self.turns += 1;
            // An oscillation takes many steps without being stiff.
            self.stretch_steps = 0;
        }
        self.pushed = if pushed == 0.0 { self.pushed } else { pushed };
    }

    /// Leaving a neighbourhood, or coming back to a stop, is an event that a step many times as long would not notice.
    pub(super) fn shorten_unit(&mut self, crossing_s: f64) {
        if crossing_s > 0.0 {
            self.unit_s = smaller(self.unit_s, UNIT_PER_CROSSING * crossing_s);
        }
    }

    /// Why the run ends before anything is decided, if it has done all it may. The work is counted, never timed: the same scene
    /// ends at the same step on every machine.
    pub(super) fn budget_used_up(&self, body: &Body<'_>, is_first: bool) -> Option<EndReason> {
        let in_first_contact = is_first && body.mode == Mode::Penetrating;
        let oscillation_factor = body.problem.oscillation_factor;
        let oscillates = !body.problem.horizon_is_given
            && self.turns + self.event_count > TURNS_MAX * oscillation_factor;
        let is_undecided = !in_first_contact && self.steps > UNDECIDED_STEPS * oscillation_factor;
        let is_worked_off = self.work.get() > WORK_MAX;
        if oscillates && (is_undecided || is_worked_off) {
            Some(EndReason::Oscillates)
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
    use super::*;
    use crate::model::impact::problem::Problem;

    #[test]
    fn work_is_counted_until_the_budget_is_used_up() {
        let problem = Problem::with("");
        let (body, control) = (Body::new(&problem, 1e-9), StepControl::new(1e-6));
        control.worked(WORK_MAX);
        assert_eq!(control.budget_used_up(&body, true), None);
        control.worked(1);
        assert_eq!(control.budget_used_up(&body, true), Some(EndReason::StepBudget));
    }
}
