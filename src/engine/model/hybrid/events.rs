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
            Hold::Law => {
                events.add(&[Event::Yields]);
                return events;
            }
            Hold::Free => events.add(&[Event::SpeedZero]),
        }
        let (below, above) = mode.spring.ends(mode.stretch);
        if above.is_finite() {
            events.add(&[Event::KnotAhead]);
        }
        if below.is_finite() {
            events.add(&[Event::KnotBehind]);
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
        Event::PushLimit => limits_n(setup, mode, state.q_m).0 - equations.carried_n(state),
        Event::PullLimit => limits_n(setup, mode, state.q_m).1 + equations.carried_n(state),
        Event::KnotAhead => equations.knots_m().1 - state.x_m,
        Event::KnotBehind => state.x_m - equations.knots_m().0,
        Event::SpeedZero => mode.w_side * state.w_m_s + equations.unresolved_m_s(),
        Event::StopReached => -equations.beyond_stop_m(state.x_m),
        Event::StopSlack => equations.stop_n(state.x_m, state.w_m_s),
        Event::StopCleared => equations.beyond_stop_m(state.x_m),
        Event::StopPressed => -equations.stop_n(state.x_m, state.w_m_s),
        Event::StopRelease => equations.push_on_stop_n(state),
        Event::Yields => {
            equations.holding_n() - equations.contact_n(state.q_m, state.u_m_s) * setup.cos
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::hybrid::modes::first;
    use crate::model::variables::scene_with;

    /// Scene, contact and touch, and the events that can end them.
    #[rustfmt::skip]
    const MODES: [(&str, Contact, Touch, &[Event]); 8] = [
        ("k=1e5", Contact::Deepening, Touch::Away, &[Event::PieceEnd, Event::SlipZero, Event::SpeedZero]),
        ("k=1e5 n=2", Contact::Closing, Touch::Away, &[Event::PieceEnd, Event::SlipZero, Event::Bottom, Event::SpeedZero, Event::KnotBehind]),
        ("k=1e5 n=3", Contact::PullingOut, Touch::Away, &[Event::PieceStart, Event::SlipZero, Event::SpeedZero]),
        ("k=1e5", Contact::Apart, Touch::Away, &[Event::Recontact, Event::SpeedZero]),
        ("k=1e5", Contact::Joined, Touch::Away, &[Event::SpeedZero]),
        ("k=1e5 interface=plastic", Contact::Joined, Touch::Away, &[Event::PushLimit, Event::PullLimit, Event::SpeedZero]),
        ("k=1e5 x_stop=1mm stop_kind=elastic", Contact::Gone, Touch::Pressed, &[Event::SpeedZero, Event::StopSlack]),
        ("k=1e5 x_stop=1mm stop_kind=elastic", Contact::Gone, Touch::Slack, &[Event::SpeedZero, Event::StopCleared, Event::StopPressed]),
    ];

    #[test]
    fn a_mode_has_the_events_that_can_end_it() {
        for (pairs, contact, touch, expected) in MODES {
            let setup = Setup::of(&scene_with(pairs));
            let mode = Mode { contact, touch, ..first(&setup).0 };
            assert_eq!(Events::of(&setup, &mode).list(), expected, "{pairs} {contact:?}");
        }
        let setup = Setup::of(&scene_with("mount=rigid"));
        let mode = first(&setup).0;
        assert_eq!(Events::of(&setup, &mode).list(), [Event::PieceEnd, Event::SlipZero]);
    }

    /// Scene, contact and event, and states (q, u, x, w) before and beyond it.
    type Case = (&'static str, Contact, Event, [f64; 4], [f64; 4]);

    #[rustfmt::skip]
    const GAPS: [Case; 9] = [
        ("k=1e5", Contact::Deepening, Event::PieceEnd, [1e-3, 9.0, 0.0, 1.0], [2e-2, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Deepening, Event::SlipZero, [1e-3, 9.0, 0.0, 1.0], [1e-3, -9.0, 0.0, 1.0]),
        ("k=1e5", Contact::PullingOut, Event::SlipZero, [1e-3, -9.0, 0.0, 1.0], [1e-3, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Closing, Event::Bottom, [4e-3, 9.0, 0.0, 1.0], [6e-3, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Apart, Event::Recontact, [-1e-3, 9.0, 0.0, 1.0], [1e-3, 9.0, 0.0, 1.0]),
        ("k=1e7 interface=plastic", Contact::Joined, Event::PushLimit, [5e-3, 0.0, 1e-3, 1.0], [5e-3, 0.0, 5e-3, 1.0]),
        ("k=1e7 interface=plastic", Contact::Joined, Event::PullLimit, [5e-3, 0.0, -1e-4, 1.0], [5e-3, 0.0, -1e-3, 1.0]),
        ("k=1e5", Contact::Deepening, Event::SpeedZero, [5e-3, 9.0, 0.0, 1.0], [5e-3, 9.0, 0.0, -1.0]),
        ("k=1e5 x_stop=1mm", Contact::Deepening, Event::StopReached, [5e-3, 9.0, 0.0, 1.0], [5e-3, 9.0, 2e-3, 1.0]),
    ];

    #[test]
    fn a_gap_is_above_zero_before_its_event_and_below_beyond_it() {
        for (pairs, contact, event, before, beyond) in GAPS {
            let setup = Setup::of(&scene_with(pairs));
            let mode = Mode { contact, deepest_m: 5e-3, ..first(&setup).0 };
            let at = |[q_m, u_m_s, x_m, w_m_s]: [f64; 4]| {
                let state = State { t_s: 0.0, q_m, u_m_s, x_m, w_m_s };
                gap(&Equations { setup: &setup, mode: &mode }, event, &state)
            };
            assert!(at(before) > 0.0 && at(beyond) < 0.0, "{pairs} {contact:?} {event:?}");
        }
    }
}
