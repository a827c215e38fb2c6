//! The events that may end a stretch of smooth motion, by mode.

use super::{Body, NearZero};
use crate::model::event_function::{ActiveEvents, EventFunction, EventId};
use crate::model::run::Mode;

/// Which excesses of the fused interface are noted already, and need not be found again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(in crate::model::impact) struct Noted {
    pub(in crate::model::impact) push: bool,
    pub(in crate::model::impact) pull: bool,
}

impl Body<'_> {
    pub(in crate::model::impact) fn active_events(
        &self,
        stiff: bool,
        noted: Noted,
    ) -> ActiveEvents {
        let mut events = self.contact_events();
        if self.mode == Mode::Fused && !self.is_still() {
            self.add_interface_events(&mut events, noted);
        }
        if !self.problem.rigid && !self.fixed {
            self.add_plate_events(&mut events, stiff);
        }
        events
    }

    /// The events that may end a contact without joining the bodies.
    pub(super) fn contact_events(&self) -> ActiveEvents {
        let mut events = ActiveEvents::none();
        if self.mode != Mode::Fused {
            self.problem.contact.add_events(self.mode, &self.hole(), &mut events);
        }
        events
    }

    fn add_interface_events(&self, events: &mut ActiveEvents, noted: Noted) {
        let (push, pull) = self.interface_limits_n();
        let fraction = self.problem.interface_fraction;
        for (event, offset, mechanism, noted) in [
            (EventId::PushLimit, push, -fraction, noted.push),
            (EventId::PullLimit, pull, fraction, noted.pull),
        ] {
            if self.problem.plastic || (self.interface_n() > 0.0 && !noted) {
                events.add(event, EventFunction { offset, mechanism, ..EventFunction::default() });
            }
        }
    }

    fn add_plate_events(&self, events: &mut ActiveEvents, stiff: bool) {
        let mechanism = &self.problem.mechanism;
        if self.rests_on_stop {
            let offset = -mechanism.spring.force(self.state.plate_m);
            let form =
                EventFunction { offset, contact: self.problem.cos, ..EventFunction::default() };
            events.add(EventId::StopRelease, form);
            return;
        }
        if mechanism.spring.curve().is_some() {
            self.add_knots_events(events);
        } else if !stiff || self.x_zero.omitted {
            self.add_zero_of_x_events(events);
        }
        // A plate that follows the slow manifold of its spring from rest is of either sign until its velocity matters.
        if !(stiff && self.plate_is_unresolved()) {
            self.add_zero_of_w_events(events, mechanism.damper.is_singular() && !stiff);
        }
        let at = mechanism.stop_at_m;
        if self.stop_touches {
            events.add(EventId::StopCleared, self.stop_force(1.0));
        } else if at.is_finite() {
            events.add(EventId::StopReached, EventFunction::plate(at, -1.0));
            if self.is_beyond_stop() {
                events.add(EventId::StopPressed, self.stop_force(-1.0));
            }
        }
    }

    /// The force of an elastic stop while it touches, or, times -1, the force missing until it pushes again, N.
    pub(in crate::model::impact) fn stop_force(&self, sign: f64) -> EventFunction {
        let mechanism = &self.problem.mechanism;
        let stop = mechanism.elastic_stop().unwrap_or_default();
        EventFunction {
            offset: -sign * stop.stiffness_n_m * mechanism.stop_at_m,
            plate: sign * stop.stiffness_n_m,
            plate_speed: sign * stop.damping_n_s_m,
            ..EventFunction::default()
        }
    }

    fn add_knots_events(&self, events: &mut ActiveEvents) {
        let (behind, ahead) = self.spring_ends();
        if ahead.is_finite() {
            events.add(EventId::KnotAhead, EventFunction::plate(ahead, -1.0));
        }
        if behind.is_finite() {
            events.add(EventId::KnotBehind, EventFunction::plate(-behind, 1.0));
        }
    }

    fn add_zero_of_x_events(&self, events: &mut ActiveEvents) {
        let singular = self.problem.mechanism.spring.is_singular();
        if self.x_zero.omitted || !self.spring().is_smooth_at_zero() {
            let near = if singular { self.near_zero_m() } else { 0.0 };
            let ids = [EventId::PlateZero, EventId::PlateClear];
            add_zero_events(events, self.x_zero, near, ids, EventFunction::plate);
        }
    }

    fn add_zero_of_w_events(&self, events: &mut ActiveEvents, singular: bool) {
        let near = if singular { self.near_zero_m_s() } else { 0.0 };
        let ids = [EventId::PlateSpeedZero, EventId::PlateSpeedClear];
        add_zero_events(events, self.w_zero, near, ids, EventFunction::plate_speed);
    }
}

/// Watches for an argument that comes as near to the zero of its law as that, or, where the law is omitted, is clear of it.
fn add_zero_events(
    events: &mut ActiveEvents,
    zero: NearZero,
    near: f64,
    [comes_near, is_clear]: [EventId; 2],
    form: fn(f64, f64) -> EventFunction,
) {
    if zero.omitted {
        for side in [1.0, -1.0] {
            events.add(is_clear, form(zero.clear, -side));
        }
    } else {
        events.add(comes_near, form(-near, zero.side));
    }
}
