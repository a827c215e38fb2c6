//! Which events a mode has, and the gap of each: above zero while the mode lasts, falling through zero where the event happens.

use crate::model::hybrid::equations::{Equations, Setup, State};
use crate::model::hybrid::modes::{Contact, Event, Hold, Mode, Touch, limits_n};
use crate::model::scene::StopKind;
use crate::numerics::locate::GAPS_MAX;

/// The events of a mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Events {
    list: [Event; GAPS_MAX],
    count: usize,
}

impl Events {
    /// Those that can end this mode.
    pub(super) fn of(setup: &Setup, mode: &Mode) -> Self {
        let mut events = Self { list: [Event::SpeedZero; GAPS_MAX], count: 0 };
        match mode.contact {
            Contact::Deepening => events.add(&[Event::PieceEnd, Event::SlipZero]),
            Contact::Closing => {
                events.add(&[Event::PieceEnd, Event::SlipZero, Event::Bottom]);
            }
            Contact::PullingOut => events.add(&[Event::PieceStart, Event::SlipZero]),
            Contact::Apart => events.add(&[Event::Recontact]),
            Contact::Joined if setup.plastic && mode.hold == Hold::Free => {
                events.add(&[Event::PushLimit, Event::PullLimit]);
            }
            Contact::Joined | Contact::Gone => {}
        }
        match mode.hold {
            Hold::Mount => return events,
            Hold::OnStop => {
                events.add(&[Event::StopRelease]);
                return events;
            }
            Hold::Spring => {
                events.add(&[Event::Yields]);
                return events;
            }
            Hold::Free => events.add(&[Event::SpeedZero]),
        }
        if !setup.spring.is_smooth_at_zero() {
            events.add(&[Event::PlaceZero]);
        }
        match (setup.stop.map(|stop| stop.kind), mode.touch) {
            (Some(_), Touch::Away) => events.add(&[Event::StopReached]),
            (Some(StopKind::Elastic), Touch::Pressed) => events.add(&[Event::StopSlack]),
            (Some(StopKind::Elastic), Touch::Slack) => {
                events.add(&[Event::StopCleared, Event::StopPressed]);
            }
            _ => {}
        }
        events
    }

    fn add(&mut self, more: &[Event]) {
        for event in more {
            self.list[self.count] = *event;
            self.count += 1;
        }
    }

    /// The events in order.
    pub(super) fn list(&self) -> &[Event] {
        &self.list[..self.count]
    }
}

/// The gap of an event.
pub(super) fn gap(equations: &Equations<'_>, event: Event, state: &State) -> f64 {
    let Equations { setup, mode } = equations;
    match event {
        Event::PieceEnd => mode.piece.to_m - state.q_m,
        Event::PieceStart => state.q_m - mode.piece.from_m,
        Event::Bottom => mode.deepest_m - state.q_m,
        Event::SlipZero if mode.contact == Contact::PullingOut => -state.u_m_s,
        Event::SlipZero => state.u_m_s,
        Event::Recontact => -state.q_m,
        Event::PushLimit => {
            limits_n(setup, mode, state.q_m).0 - equations.carried_n(state)
        }
        Event::PullLimit => {
            limits_n(setup, mode, state.q_m).1 + equations.carried_n(state)
        }
        Event::PlaceZero => mode.x_side * equations.displacement_m(state.x_m),
        Event::SpeedZero => mode.w_side * state.w_m_s + equations.unresolved_m_s(),
        Event::StopReached => -equations.beyond_stop_m(state.x_m),
        Event::StopSlack => equations.stop_n(state.x_m, state.w_m_s),
        Event::StopCleared => equations.beyond_stop_m(state.x_m),
        Event::StopPressed => -equations.stop_n(state.x_m, state.w_m_s),
        Event::StopRelease => equations.push_on_stop_n(state),
        Event::Yields => equations.holding_n() - equations.contact_n(state.q_m, state.u_m_s) * setup.cos,
    }
}
