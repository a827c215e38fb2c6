//! The run itself: stretches of smooth motion between located events.
//!
//! A [`Simulation`] owns the state and knows in which mode the bodies are. Each stretch is advanced by Taylor steps (`taylor.rs`)
//! or, where those become too many, by the implicit method (`stiff.rs`); when an event function (`active_events.rs`) changes its
//! sign, the state is put exactly on the event and `events.rs` decides what follows. Events that rounding has put behind the
//! state are found by `missed_event.rs`.

use std::ops::ControlFlow;

use crate::model::event_function::{ActiveEvents, EventId};
use crate::model::impact::body::{Body, Noted};
use crate::model::impact::problem::Problem;
use crate::model::impact::record::{Record, Setting};
use crate::model::impact::report;
use crate::model::impact::step_control::StepControl;
use crate::model::impact::termination::Termination;
use crate::model::mechanism::sign;
use crate::model::motion::{Motion, State};
use crate::model::run::Observer;
use crate::model::run::{EndReason, Mode};
use crate::numerics::larger;

/// Taylor steps after which a stretch is handed to the implicit method.
const TAYLOR_STEPS_PER_STRETCH: usize = 20_000;
/// A passage through zero within this many ulps of the time takes no time.
const PASSED_TICKS: f64 = 16.0;

/// Part of the spring's force up to which its damper, times its exponent, lets a plate that came through zero oscillate: Taylor
/// steps then follow the oscillations, with fewer steps than the implicit method.
const OSCILLATES_BELOW: f64 = 3.0;

/// A run in progress.
#[derive(Clone)]
pub(super) struct Simulation<'a> {
    pub(super) body: Body<'a>,
    pub(super) control: StepControl,
    pub(super) record: Record<'a>,
    pub(super) termination: Termination,
}

impl<'a> Simulation<'a> {
    /// A run at the moment of first contact.
    pub(super) fn new(problem: &'a Problem, tolerance: f64, keep_series: bool) -> Self {
        Self {
            body: Body::new(problem, tolerance),
            control: StepControl::new(
                0.1 * (problem.geometry.nose.radius_m / problem.velocity_m_s),
            ),
            record: Record {
                keep_series,
                max_displacement_m: problem.start_m,
                min_displacement_m: problem.start_m,
                ..Record::default()
            },
            termination: Termination::default(),
        }
    }

    pub(super) fn run<const N: usize>(&mut self, observer: Observer<'_>) -> EndReason {
        loop {
            if let Some(reason) = self.finished() {
                return reason;
            }
            if observer(self.body.state.t_s).is_break() {
                return EndReason::Cancelled;
            }
            if let Some(window) = self.record.window {
                window
                    .show(|| report::gather(self.body.problem, self.clone(), EndReason::Cancelled));
            }
            if let Some(reason) =
                self.control.budget_used_up(&self.body, self.record.first_arrest.is_none())
            {
                return self.end_early(reason);
            }
            if let Some(event) = self.body.missed_event() {
                self.body.project_within_rounding(event);
                self.apply_transition(event);
                continue;
            }
            self.body.restore_omitted();
            self.come_to_rest();
            self.unload_absorbers();
            if self.cross_singularity() {
                continue;
            }
            self.keep_off_singularities();
            self.pass_zero_under_implicit_steps();
            if self.control.stretch_steps > TAYLOR_STEPS_PER_STRETCH {
                self.control.stiff = true;
            }
            let advanced =
                if self.control.stiff { self.stiff_step() } else { self.taylor_step::<N>() };
            match advanced {
                ControlFlow::Break(reason) => return self.end_early(reason),
                ControlFlow::Continue(detected) => self.apply_detected(detected),
            }
        }
    }

    pub(super) fn active_events(&self) -> ActiveEvents {
        let Record { push_exceeded_s, pull_exceeded_s, .. } = &self.record;
        let noted = Noted { push: push_exceeded_s.is_some(), pull: pull_exceeded_s.is_some() };
        self.body.active_events(self.control.stiff, noted)
    }

    /// The transition after the event that ended a step, if one did.
    pub(super) fn apply_detected(&mut self, detected: Option<EventId>) {
        if let Some(event) = detected {
            self.apply_transition(event);
        }
    }

    /// The transition after an event, and the method that continues.
    pub(super) fn apply_transition(&mut self, event: EventId) {
        self.control.event_count += usize::from(event.changes_course());
        self.control.worked(1);
        let before = self.body.mode;
        self.handle(event);
        if self.body.mode != before {
            self.control.stiff = false;
            self.body.at_rest = false;
            self.control.stretch_steps = 0;
        }
    }

    /// A run whose outcome is known is complete even when its tail is cut short, unless it was to go as far as a horizon.
    fn end_early(&self, reason: EndReason) -> EndReason {
        let is_complete = self.termination.decided.is_some() && !self.body.problem.horizon_is_given;
        if is_complete { EndReason::Decided } else { reason }
    }

    /// A singular law exactly at its zero cannot be expanded: leave it out until it has left zero.
    fn keep_off_singularities(&mut self) {
        if self.body.is_still() || self.control.stiff {
            return;
        }
        let mechanism = &self.body.problem.mechanism;
        if mechanism.spring.is_singular() && self.body.state.plate_m == 0.0 {
            self.control.shorten_unit(self.body.omit_spring());
        }
        if mechanism.damper.is_singular() && self.body.state.plate_m_s == 0.0 {
            self.control.shorten_unit(self.body.omit_damper());
        }
    }

    /// The implicit method follows a spring that is infinitely steep at zero, but cannot follow a plate that comes
    /// through zero with speed to spare: its unknown, the spring's force, changes sign there at once.
    fn pass_zero_under_implicit_steps(&mut self) {
        let (x, w) = (self.body.state.plate_m, self.body.state.plate_m_s);
        if !(self.control.stiff && self.body.spring().is_steep_at_zero())
            || self.body.is_still()
            || self.body.x_zero.omitted
        {
            return;
        }
        let (spring, damper) = (self.body.spring(), self.body.problem.mechanism.damper);
        // The velocity of a plate that only follows the contact's force may be what a step has left of it.
        let unresolved = self.body.plate_is_unresolved();
        let on_manifold =
            unresolved && 0.5 * self.body.problem.plate_kg * w * w < spring.integral(x);
        if x * w < 0.0 && x.abs() <= self.body.near_zero_m() && !on_manifold {
            if !unresolved
                && damper.exponent * damper.force(w).abs()
                    <= OSCILLATES_BELOW * spring.force(x).abs()
            {
                self.control.stiff = false;
                self.control.stretch_steps = 0;
                self.body.x_zero.side = sign(x);
                self.body.w_zero.side = sign(w);
            }
            if x.abs() <= PASSED_TICKS * f64::EPSILON * self.body.state.t_s * w.abs() {
                // The time does not resolve it.
                self.body.state.plate_m = -x;
                self.body.x_zero.side = sign(-x);
                return;
            }
            // As far on the other side as on this one: what the spring takes it also gives.
            self.body.x_zero.clear = x.abs();
            self.body.x_zero.omitted = true;
            self.control.shorten_unit(self.body.x_zero.clear / w.abs());
        }
    }

    pub(super) fn point(&mut self) {
        let motion = self.body.motion();
        self.record.point(&Setting { body: &self.body, motion: &motion }, &self.body.state, true);
    }

    /// Records the state at the end of a step, put exactly on the event that ended it.
    pub(super) fn arrive(&mut self, state: State, motion: &Motion<'_>, detected: Option<EventId>) {
        self.reach(state, detected);
        self.record.point(&Setting { body: &self.body, motion }, &self.body.state, true);
    }

    /// Takes a state, put exactly on the event that led to it.
    pub(super) fn reach(&mut self, state: State, detected: Option<EventId>) {
        let before = self.body.state;
        self.body.state = state;
        self.body.compensation_m = 0.0;
        self.body.released = false;
        if let Some(event) = detected {
            self.body.project_onto_event(event, &before);
        }
        if self.body.mode == Mode::Penetrating {
            self.body.deepest_m = larger(self.body.state.travel_m, self.body.deepest_m);
        }
        let (x, w) = (self.body.state.plate_m.abs(), self.body.state.plate_m_s.abs());
        self.body.plate_scale_m = larger(x, self.body.plate_scale_m);
        self.body.speed_scale_m_s = larger(w, self.body.speed_scale_m_s);
        self.record.reach(&self.body.state);
    }
}

#[cfg(test)]
impl<'a> Simulation<'a> {
    /// A run at 0.1 ms in a hole 5 mm of travel deep.
    pub(super) fn at(problem: &'a Problem, mode: Mode, [q, u, x, w]: [f64; 4]) -> Self {
        let mut simulation = Self::new(problem, 1e-9, false);
        (simulation.body.mode, simulation.body.deepest_m) = (mode, 5e-3);
        simulation.body.state =
            State { t_s: 1e-4, travel_m: q, slip_m_s: u, plate_m: x, plate_m_s: w };
        simulation.body.speed_scale_m_s = w.abs();
        simulation
    }
}

pub(super) fn is_finite(state: &State) -> bool {
    let State { travel_m, slip_m_s, plate_m, plate_m_s, .. } = state;
    [travel_m, slip_m_s, plate_m, plate_m_s].into_iter().all(|value| value.is_finite())
}
