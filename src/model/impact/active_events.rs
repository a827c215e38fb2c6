//! Which guards are watched in which mode.

use crate::model::event_function::{ActiveEvents, EventFunction, EventId};
use crate::model::impact::track::Track;
use crate::model::mechanism::{PowerKind, PowerLaw, sign};
use crate::model::run::Mode;
use crate::numerics::{larger, smaller};

/// Half-width of the neighbourhood of zero in which a singular power law is left out, relative to the greatest value seen.
/// A spring gives on one side of it what it takes on the other; a damper does not, and a plate may creep near zero.
const CLEAR_OF_SPRING: f64 = 1e-6;
const CLEAR_OF_DAMPER: f64 = 1e-9;
/// Tolerance from which down the spring's neighbourhood shrinks.
const CLEAR_AT: f64 = 1e-9;
/// Part of the plate's energy, or of the other forces, that a law may have where it is left out.
const PASSING: f64 = 1e-3;
/// The least distance, relative to the tip's radius and the impact velocity: where nothing drives the plate yet, there is no
/// other measure.
const LEAST: f64 = 1e-13;
/// The least half-width relative to the greatest displacement seen: less than that drowns in rounding.
const FINEST: f64 = 1e-12;
/// Time unit of the first expansion without the law, in times it takes to leave the neighbourhood.
const UNIT_PER_CROSSING: f64 = 4.0;
/// Part of the other forces on the plate below which one is lost in their rounding.
const DROWNED: f64 = 8.0 * f64::EPSILON;
/// The neighbourhood takes at least this part of the time reached to cross: the clock has no finer ticks.
const CLOCK: f64 = 1e-13;

impl Track<'_> {
    /// Everything that may end the present stretch.
    pub(super) fn active_events(&self) -> ActiveEvents {
        let mut guards = ActiveEvents::none();
        if self.mode != Mode::Fused {
            self.problem.contact.watch(self.mode, &self.hole(), &mut guards);
        } else if !self.is_still() {
            self.watch_interface(&mut guards);
        }
        if !self.problem.rigid && !self.immobile {
            self.watch_plate(&mut guards);
        }
        guards
    }

    fn watch_interface(&self, guards: &mut ActiveEvents) {
        let (strength, share) = (self.interface_n(), self.problem.share);
        let pull = self.problem.grip * strength;
        let at_bottom = self.state.travel_m >= self.deepest_m;
        let push = if at_bottom { strength } else { pull };
        let record = &self.record;
        if self.problem.plastic || (strength > 0.0 && record.push_exceeded_s.is_none()) {
            let form =
                EventFunction { offset: push, mechanism: -share, ..EventFunction::default() };
            guards.watch(EventId::PushLimit, form);
        }
        if self.problem.plastic || (strength > 0.0 && record.pull_exceeded_s.is_none()) {
            let form = EventFunction { offset: pull, mechanism: share, ..EventFunction::default() };
            guards.watch(EventId::PullLimit, form);
        }
    }

    fn watch_plate(&self, guards: &mut ActiveEvents) {
        let mechanism = &self.problem.mechanism;
        if self.held {
            let offset = -mechanism.spring.force(self.state.plate_m);
            let form =
                EventFunction { offset, contact: self.problem.cos, ..EventFunction::default() };
            guards.watch(EventId::StopRelease, form);
            return;
        }
        let singular = |law: PowerLaw| law.kind() == PowerKind::General && !self.stiff;
        if mechanism.spring.curve().is_some() {
            self.watch_knots(guards);
        } else {
            self.watch_zero_of_x(guards, mechanism.spring.is_singular() && !self.stiff);
        }
        // A plate that rides on its spring from rest is of either sign until its velocity matters.
        if !(self.stiff && self.is_unfelt()) {
            self.watch_zero_of_w(guards, singular(mechanism.damper));
        }
        let at = mechanism.stop_at_m;
        if self.stop_touches {
            guards.watch(EventId::StopCleared, self.stop_force(1.0));
        } else if at.is_finite() {
            guards.watch(
                EventId::StopReached,
                EventFunction { offset: at, plate: -1.0, ..EventFunction::default() },
            );
            if self.is_beyond_stop() {
                guards.watch(EventId::StopPressed, self.stop_force(-1.0));
            }
        }
    }

    /// What an elastic stop pushes back with while it touches (or, times -1, what it lacks to push again), N, and what nothing feels
    /// besides.
    pub(super) fn stop_force(&self, sign: f64) -> EventFunction {
        let mechanism = &self.problem.mechanism;
        let stop = mechanism.elastic_stop().unwrap_or_default();
        EventFunction {
            offset: self.unfelt_n() - sign * stop.stiffness_n_m * mechanism.stop_at_m,
            plate: sign * stop.stiffness_n_m,
            plate_speed: sign * stop.damping_n_s_m,
            ..EventFunction::default()
        }
    }

    /// A force on the plate that drowns in the rounding of the others, N: a stop beside a plate that rides on a spring infinitely
    /// steep at zero would let go and press again at every step.
    fn unfelt_n(&self) -> f64 {
        let (motion, state) = (self.motion(), &self.state);
        let contact_n = motion.coupling * motion.contact_force(state);
        let spring_n = motion.spring.force(state.plate_m);
        let damper_n = motion.damper.force(state.plate_m_s);
        DROWNED * (contact_n.abs() + spring_n.abs() + damper_n.abs())
    }

    /// The ends of the stretch of the spring's law.
    fn watch_knots(&self, guards: &mut ActiveEvents) {
        let (behind, ahead) = self.spring_ends();
        if ahead.is_finite() {
            let form = EventFunction { offset: ahead, plate: -1.0, ..EventFunction::default() };
            guards.watch(EventId::KnotAhead, form);
        }
        if behind.is_finite() {
            let form = EventFunction { offset: -behind, plate: 1.0, ..EventFunction::default() };
            guards.watch(EventId::KnotBehind, form);
        }
    }

    fn watch_zero_of_x(&self, guards: &mut ActiveEvents, singular: bool) {
        let near = if self.spring_omitted { self.clear_m } else { self.near_zero_m() };
        if self.spring_omitted {
            for side in [1.0, -1.0] {
                let form = EventFunction { offset: near, plate: -side, ..EventFunction::default() };
                guards.watch(EventId::PlateClear, form);
            }
        } else if !self.spring().is_smooth_at_zero() && !self.stiff {
            let offset = if singular { -near } else { 0.0 };
            guards.watch(
                EventId::PlateZero,
                EventFunction { offset, plate: self.side_x, ..EventFunction::default() },
            );
        }
    }

    fn watch_zero_of_w(&self, guards: &mut ActiveEvents, singular: bool) {
        let near = if self.damper_omitted { self.clear_m_s } else { self.near_zero_m_s() };
        if self.damper_omitted {
            for side in [1.0, -1.0] {
                let form =
                    EventFunction { offset: near, plate_speed: -side, ..EventFunction::default() };
                guards.watch(EventId::PlateSpeedClear, form);
            }
            return;
        }
        let offset = if singular { -near } else { 0.0 };
        let form = EventFunction { offset, plate_speed: self.side_w, ..EventFunction::default() };
        guards.watch(EventId::PlateSpeedZero, form);
    }

    /// Leave the singular spring out until the plate is clear of zero. The distance is fixed now: one that shrank on the way
    /// would never be reached.
    pub(super) fn omit_spring(&mut self) {
        let least = LEAST * self.problem.geometry.nose.radius_m;
        let (x, w) = (self.state.plate_m, self.state.plate_m_s);
        self.clear_m = if x * w < 0.0 {
            // As far on the other side as on this one: then what the spring takes it also gives.
            larger(x.abs(), FINEST * self.plate_scale_m)
        } else if x == 0.0 && w != 0.0 {
            // From zero itself there is no other side: as close as the clock sees.
            larger(CLOCK * self.state.t_s * w.abs(), FINEST * self.plate_scale_m)
        } else {
            larger(larger(self.near_zero_m(), 2.0 * x.abs()), least)
        };
        self.spring_omitted = true;
        self.shorten_unit(self.clear_m / w.abs());
    }

    /// The same for the singular damper.
    pub(super) fn omit_damper(&mut self) {
        let least = LEAST * self.problem.velocity_m_s;
        let near = larger(self.near_zero_m_s(), 2.0 * self.state.plate_m_s.abs());
        self.clear_m_s = larger(near, least);
        self.damper_omitted = true;
        let (_, rate) = self.motion().accelerations(&self.state);
        self.shorten_unit(self.clear_m_s / rate.abs());
    }

    /// Leaving a neighbourhood, or coming back to a stop, is an event that a step many times as long would not notice.
    pub(super) fn shorten_unit(&mut self, crossing_s: f64) {
        if crossing_s > 0.0 {
            self.unit_s = smaller(self.unit_s, UNIT_PER_CROSSING * crossing_s);
        }
    }

    /// A law that was left out comes back as soon as its argument has left the neighbourhood of zero. A plate that only touched
    /// zero is on the side on which it is, so that its next passage is not taken for a return.
    pub(super) fn compensate_displacement(&mut self) {
        let (x, w) = (self.state.plate_m, self.state.plate_m_s);
        if x.abs() > FINEST * self.plate_scale_m {
            self.side_x = sign(x);
        }
        if w.abs() > FINEST * self.speed_scale_m_s {
            self.side_w = sign(w);
        }
        if self.spring_omitted && x.abs() > self.clear_m {
            self.spring_omitted = false;
            self.side_x = sign(x);
        }
        if self.damper_omitted && w.abs() > self.clear_m_s {
            self.damper_omitted = false;
            self.side_w = sign(w);
        }
    }

    /// How close to zero displacement the singular spring is left out: so close that it holds little of the plate's energy.
    pub(super) fn near_zero_m(&self) -> f64 {
        let (spring, w) = (self.spring(), self.state.plate_m_s);
        let energy = 0.5 * self.problem.plate_kg * w * w;
        // Tighter computations come closer, so that two of them do not share what is left out.
        let closer = smaller((self.tolerance / CLEAR_AT).sqrt(), 1.0);
        let clear_m = CLEAR_OF_SPRING * closer * self.plate_scale_m;
        let passing = smaller(clear_m, spring.at_integral(PASSING * energy));
        larger(passing, CLOCK * self.state.t_s * w.abs())
    }

    /// How close to zero velocity the singular damper is left out: so close that other forces turn the plate round.
    fn near_zero_m_s(&self) -> f64 {
        let damper = self.problem.mechanism.damper;
        let motion = self.motion();
        let (_, rate) = motion.accelerations(&self.state);
        let damping = motion.damper.force(self.state.plate_m_s) * motion.plate_mobility;
        let others = (rate + damping).abs();
        let turning = damper.at_force(PASSING * others * self.problem.plate_kg);
        larger(
            smaller(CLEAR_OF_DAMPER * self.speed_scale_m_s, turning),
            CLOCK * self.state.t_s * others,
        )
    }
}
