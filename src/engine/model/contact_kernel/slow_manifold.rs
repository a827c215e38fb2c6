//! A contact whose plate follows the slow manifold of its spring, pass by pass: after a pass it takes another about the new balance, or
//! has settled and takes a step, or fails and tries a shorter one; and where even that fails it hands over to plain steps.

use std::ops::ControlFlow;

use crate::model::contact_kernel::Contact;
use crate::model::contact_kernel::expansion::{Area, Series, trusted};
use crate::model::contact_kernel::integration::{
    InitialPhase, IntegrationState, STEPS_MAX, Sides, StepEnd, plate_scale_m,
};
use crate::model::contact_kernel::slow_manifold_series::{
    About, Balance, Guess, Lag, SpringManifold, tolerance_factor,
};
use crate::numerics::larger;

/// Maximum number of passes.
const PASSES_MAX: usize = 8;
/// Part of the tolerance by which the last two passes may differ.
const PASS_TOLERANCE: f64 = 0.3;
/// What a pass must at least gain, after the first few.
const PASS_GAIN: f64 = 0.5;
const FIRST_PASSES: usize = 3;
/// Part of a step below which a plate that has left the manifold is not tried again.
const RETRY_STEP_MIN: f64 = 0.1;

/// A contact on the slow manifold.
#[derive(Clone, Copy, Debug)]
pub(super) struct ManifoldRun {
    manifold: SpringManifold,
    tolerance: f64,
    progress: IntegrationState,
    /// From where another method goes on: a step earlier than where this one was seen to fail.
    before: IntegrationState,
    /// The area law of the piece that the last step ended with.
    joint: Option<Area>,
    /// How far steps are trusted after failures.
    reach_factor: f64,
    terms: usize,
}

/// An expansion about the present state.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    area: Area,
    /// Made with the area law of the piece before, to see whether the next one sets the plate oscillating.
    by_piece_before: bool,
    passes: usize,
    balance: Balance,
    /// How far that is from the one before, relative.
    moved: f64,
    /// By how much the pass before changed the plate's displacement, relative.
    change: f64,
}

/// The next attempt, or what follows the manifold.
type Continued = ControlFlow<InitialPhase, Attempt>;

#[derive(Clone, Copy, PartialEq, Eq)]
enum PassResult {
    Again,
    Settled,
    Failed,
}

impl ManifoldRun {
    pub(super) fn from(
        manifold: SpringManifold,
        start: IntegrationState,
        tolerance: f64,
        terms: usize,
    ) -> Self {
        Self {
            manifold,
            tolerance,
            progress: start,
            before: start,
            joint: None,
            reach_factor: 1.0,
            terms,
        }
    }

    fn step(&mut self, contact: &Contact) -> Continued {
        if self.progress.steps >= STEPS_MAX {
            return ControlFlow::Break(self.left(contact));
        }
        let Some(area) = contact.area_law(self.progress.piece) else {
            return ControlFlow::Break(self.left(contact));
        };
        self.progress.steps += 1;
        self.attempt(contact, area, false)
    }

    fn attempt(&mut self, contact: &Contact, area: Area, by_piece_before: bool) -> Continued {
        let IntegrationState { state, .. } = self.progress;
        let guess = Guess { balance: self.manifold.at(state[2]), lag_n: 0.0, speed_m_s: state[3] };
        let found = self.manifold.balance(&contact.constants, state, area, &guess);
        let Some(balance) = found else { return self.failed(contact, by_piece_before) };
        let (moved, change) = ((balance.plate_m - state[2]).abs() / balance.plate_m, f64::INFINITY);
        let attempt = Attempt { area, by_piece_before, passes: 0, balance, moved, change };
        ControlFlow::Continue(attempt)
    }

    /// The next attempt after a failure.
    fn failed(&mut self, contact: &Contact, by_piece_before: bool) -> Continued {
        if let (Some(area), false) = (self.joint, by_piece_before) {
            return self.attempt(contact, area, true);
        }
        if self.progress.piece != self.before.piece || self.reach_factor < RETRY_STEP_MIN {
            return ControlFlow::Break(self.handed(contact, self.before));
        }
        // The step there may have been too long, and so may be those to come.
        self.reach_factor *= 0.5;
        self.progress = IntegrationState { steps: self.progress.steps, ..self.before };
        self.step(contact)
    }

    /// What a pass means that gave these plate velocities, the one it was made with first; finds the next balance.
    fn assess(
        &self,
        contact: &Contact,
        attempt: &mut Attempt,
        [old_m_s, new_m_s]: [f64; 2],
        lag_n: f64,
    ) -> PassResult {
        let IntegrationState { state, clock, .. } = self.progress;
        let tolerance = self.tolerance * tolerance_factor(state[2], self.manifold.reach_m);
        let x = attempt.balance.plate_m;
        let change = larger(attempt.moved, (old_m_s - new_m_s).abs() * clock.rates()[0] / x);
        // The first has no inertia yet, and agrees with a step before that had none.
        if attempt.passes > 0 && change <= PASS_TOLERANCE * tolerance {
            let keeps = self.manifold.keeps_to(attempt.balance, new_m_s, state, tolerance);
            return if keeps { PassResult::Settled } else { PassResult::Failed };
        }
        if attempt.passes >= FIRST_PASSES && change > PASS_GAIN * attempt.change {
            return PassResult::Failed;
        }
        let guess = Guess { balance: attempt.balance, lag_n, speed_m_s: new_m_s };
        let next = self.manifold.balance(&contact.constants, state, attempt.area, &guess);
        let Some(balance) = next.filter(|_| attempt.passes + 1 < PASSES_MAX) else {
            return PassResult::Failed;
        };
        let moved = (balance.plate_m - x).abs() / balance.plate_m;
        let passes = attempt.passes + 1;
        *attempt = Attempt { passes, balance, moved, change, ..*attempt };
        PassResult::Again
    }

    /// The passes of an attempt, the first without inertia and with the plate's velocity as it is, and the step if it settles.
    fn settle<const N: usize>(&mut self, contact: &Contact, mut attempt: Attempt) -> Continued {
        let (manifold, constants) = (self.manifold, &contact.constants);
        let IntegrationState { state, clock, .. } = self.progress;
        let unit_s = clock.rates()[0];
        let mut lag = Lag { force: [0.0; N], speed: [0.0; N] };
        lag.speed[0] = state[3];
        loop {
            let Balance { plate_m, force_n } = attempt.balance;
            let about = About { plate_m, held_n: force_n, lag: &lag };
            let mut series = manifold.pass::<N>(constants, state, unit_s, attempt.area, &about);
            let next = manifold.lag(&series, unit_s);
            let speeds = [lag.speed[0], next.speed[0]];
            match self.assess(contact, &mut attempt, speeds, next.force[0]) {
                PassResult::Again => lag = next,
                PassResult::Failed => return self.failed(contact, attempt.by_piece_before),
                PassResult::Settled => {
                    // With another speed another slip: the projectile's own velocity is what the force left of it.
                    for j in 0..N {
                        series.slip[j] += constants.cos * (lag.speed[j] - next.speed[j]);
                    }
                    series.speed = next.speed;
                    let scale_m = plate_scale_m(plate_m, Some(manifold.reach_m));
                    let trusted =
                        trusted::<N>(constants.last_terms(&series, scale_m), self.tolerance);
                    let end_of_step = StepEnd::of(&series, self.reach_factor * trusted);
                    return self.take(contact, &attempt, &end_of_step, &series);
                }
            }
        }
    }

    /// Take the step that an attempt has settled on.
    fn take<const N: usize>(
        &mut self,
        contact: &Contact,
        attempt: &Attempt,
        end_of_step: &StepEnd,
        series: &Series<N>,
    ) -> Continued {
        if attempt.by_piece_before {
            // Fine up to the joint; on the next piece the plate oscillates.
            return ControlFlow::Break(self.handed(contact, self.progress));
        }
        self.joint = None;
        let here = self.progress;
        let sides = Sides { spring: false, damper: true };
        if let ControlFlow::Break(end) =
            contact.advance(&mut self.progress, sides, end_of_step, series)
        {
            return ControlFlow::Break(end.map_or_else(|| self.left(contact), InitialPhase::Ended));
        }
        if self.progress.t_s > here.t_s {
            self.before = here;
        }
        if self.progress.piece > here.piece {
            self.joint = Some(attempt.area);
        }
        self.step(contact)
    }

    /// Plain steps go on from where the manifold was followed to.
    fn handed(&self, contact: &Contact, progress: IntegrationState) -> InitialPhase {
        if progress.steps == 0 {
            return self.left(contact);
        }
        InitialPhase::Steps(self.manifold.plan(progress, self.tolerance, self.terms))
    }

    /// The contact starts anew, without the manifold.
    fn left(&self, contact: &Contact) -> InitialPhase {
        contact.start(self.tolerance, self.terms)
    }
}

impl Contact {
    /// The continuation of a run along the manifold.
    pub(super) fn end_of_manifold(&self, run: &ManifoldRun) -> InitialPhase {
        by_terms!(run.terms, N => self.follow::<N>(run))
    }

    fn follow<const N: usize>(&self, run: &ManifoldRun) -> InitialPhase {
        let mut run = *run;
        let mut next = run.step(self);
        loop {
            match next {
                ControlFlow::Continue(attempt) => next = run.settle::<N>(self, attempt),
                ControlFlow::Break(phase) => return phase,
            }
        }
    }
}
