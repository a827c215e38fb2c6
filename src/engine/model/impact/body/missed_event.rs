//! Events that are there already, without an event function that falls: put behind the state by rounding, or on the very place
//! where another one has put it.

use super::Body;
use crate::model::event_function::{EventId, Forces};
use crate::model::mechanism::stop::HEIGHT_ROUNDING;
use crate::model::mechanism::{PowerLaw, sign};
use crate::model::motion::{Motion, State};
use crate::model::run::Mode;

/// Part of a displacement by which rounding puts a zero of a spring's force elsewhere, and of a curve's size that is just beyond
/// it.
const ROUNDING: f64 = 1e-12;
const NEARBY: f64 = 1e-9;
/// Part of the tip's radius that a plate at rest on a knot is displaced by when its way is decided, and how many terms of its path
/// say so: the contact's force may begin with the second derivative.
const RESOLVED: f64 = 1e-13;
const RATES: usize = 8;

impl Body<'_> {
    /// An event that rounding has put behind the state already, when another one fell on nearly the same moment.
    pub(in crate::model::impact) fn missed_event(&self) -> Option<EventId> {
        let State { plate_m: x, plate_m_s: w, .. } = self.state;
        let problem = self.problem;
        let rigid_stop = problem.mechanism.rigid_stop().is_some() && !self.is_still();
        // So close that neither the time nor the displacement resolves the distance.
        let presses = || {
            w == 0.0 && !self.released && self.motion().accelerations(&self.state).plate_m_s2 > 0.0
        };
        if rigid_stop && x >= problem.mechanism.stop_at_m && (w > 0.0 || presses()) {
            return Some(EventId::StopReached);
        }
        if self.is_beyond_stop() && self.stop_presses() {
            return Some(EventId::StopPressed);
        }
        if let Some(event) = self.missed_event_in_place() {
            return Some(event);
        }
        let (behind, ahead) = self.spring_ends();
        if !self.is_still() && (x > ahead || (x >= ahead && self.way() > 0.0)) {
            return Some(EventId::KnotAhead);
        }
        if !self.is_still() && (x < behind || (x <= behind && self.way() < 0.0)) {
            return Some(EventId::KnotBehind);
        }
        self.missed_contact_event()
    }

    /// The way the plate goes from here, 1 or -1; 0 where nothing moves it. From rest it is that of the term of its path that reaches
    /// a displacement of the order of rounding first: a force that is only rounding does not decide it.
    pub(super) fn way(&self) -> f64 {
        if self.state.plate_m_s != 0.0 {
            return sign(self.state.plate_m_s);
        }
        // A damper, which may be singular here, turns no plate round.
        let motion = Motion { damper: PowerLaw::NONE, ..self.motion() };
        let radius_m = self.problem.geometry.nose.radius_m;
        let unit_s = radius_m / self.problem.velocity_m_s;
        let path: [f64; RATES] = motion.expand(&self.state, unit_s).plate;
        // One over the time at which the term alone has displaced the plate that far.
        let haste =
            |order: usize| (path[order].abs() / (RESOLVED * radius_m)).powf(1.0 / order as f64);
        let first = (2..RATES).max_by(|a, b| haste(*a).total_cmp(&haste(*b)));
        first.map_or(0.0, |order| sign(path[order]))
    }

    /// An event of the contact that the state has passed: a slip of the wrong sign, or a place, force or time beyond that of its
    /// event that goes on.
    pub(in crate::model::impact) fn missed_contact_event(&self) -> Option<EventId> {
        let events = self.contact_events();
        let missed = events.iter().find(|(event, form)| {
            let value = form.value(&self.state, Forces::default());
            let is_slip = matches!(event, EventId::SlipZero);
            let goes_on = || form.rate(&self.motion(), &self.state) < 0.0;
            if is_slip { value < 0.0 } else { value <= 0.0 && goes_on() }
        });
        missed.map(|(event, _)| *event)
    }

    /// Whether the plate is where an elastic stop that has let go of it would press it again.
    pub(in crate::model::impact) fn is_beyond_stop(&self) -> bool {
        let mechanism = &self.problem.mechanism;
        let lets_go = mechanism.elastic_stop().is_some() && !self.stop_touches;
        lets_go && !self.is_still() && self.state.plate_m > mechanism.stop_at_m
    }

    /// Whether an elastic stop would push by more than rounding, if it touched.
    fn stop_presses(&self) -> bool {
        let form = self.stop_force(-1.0);
        let motion = self.motion();
        form.at(&motion, &self.state) < -form.rounding(&motion, &self.state)
    }

    /// An event at the very place on which another one has put the plate: its event function is zero there and falls no more.
    fn missed_event_in_place(&self) -> Option<EventId> {
        let State { plate_m: x, plate_m_s: w, .. } = self.state;
        if self.is_still() {
            return None;
        }
        let mechanism = &self.problem.mechanism;
        if self.stop_touches && self.stop_lets_go() {
            return Some(EventId::StopCleared);
        }
        let untouched = mechanism.elastic_stop().is_some() && !self.stop_touches;
        let reaches = x >= mechanism.stop_at_m && (w > 0.0 || self.turns_within_resolution());
        if untouched && reaches && !self.stop_lets_go() {
            return Some(EventId::StopReached);
        }
        // Without any strength the interface yields where the spring's force changes its sign.
        let carries = self.mode == Mode::Fused && self.problem.plastic;
        let ahead = if carries { self.spring_turns(w) } else { 0.0 };
        let (push, pull) = if ahead == 0.0 { (0.0, 0.0) } else { self.interface_limits_n() };
        if ahead < 0.0 && pull == 0.0 {
            Some(EventId::PullLimit)
        } else {
            (ahead > 0.0 && push == 0.0).then_some(EventId::PushLimit)
        }
    }

    /// The sign that the spring's force is about to have where nothing acts on the plate now; zero elsewhere.
    fn spring_turns(&self, w: f64) -> f64 {
        let spring = &self.problem.mechanism.spring;
        let (x, (behind, ahead)) = (self.state.plate_m, self.spring_ends());
        let at_zero = x == 0.0 && !spring.is_absent();
        let at_knot = [behind, ahead].map(f64::to_bits).contains(&x.to_bits());
        // A zero between two stretches of a curve is one up to rounding.
        let rounding = if at_knot { (ROUNDING * x * spring.tangent(x)).abs() } else { 0.0 };
        if !(at_zero || at_knot) || self.motion().mechanism_force(&self.state).abs() > rounding {
            return 0.0;
        }
        spring.curve().map_or_else(
            || sign(w),
            |curve| sign(curve.force(x + sign(w) * NEARBY * curve.scale_m())),
        )
    }

    /// Whether a plate on its stop that goes back is turned round so soon that its displacement does not resolve it.
    fn turns_within_resolution(&self) -> bool {
        let rate = self.motion().accelerations(&self.state).plate_m_s2;
        let State { plate_m: x, plate_m_s: w, .. } = self.state;
        let (on_stop, rounding_m) =
            (self.problem.mechanism.stop_at_m, HEIGHT_ROUNDING * self.stop_scale_m());
        x - on_stop <= rounding_m && w <= 0.0 && rate > 0.0 && 0.5 * w * w <= rounding_m * rate
    }

    /// Whether an elastic stop's force is zero and about to pull.
    fn stop_lets_go(&self) -> bool {
        let (form, motion) = (self.stop_force(1.0), self.motion());
        form.at(&motion, &self.state) <= 0.0 && form.rate(&motion, &self.state) < 0.0
    }
}
