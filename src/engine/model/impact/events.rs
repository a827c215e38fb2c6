//! Events of a mode and their event functions: positive while the mode lasts, zero at the event.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::{Contact, Event, HybridMode, PlateConstraint};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::state::State;
use crate::numerics::larger;

/// Returns the events that can end a mode.
pub(super) fn possible_events(
    setup: &ImpactParameters,
    mode: &HybridMode,
) -> impl Iterator<Item = Event> {
    let (below, above) = mode.spring.ends(mode.stretch);
    let is_free = mode.hold == PlateConstraint::Free;
    let of_plate = [
        (mode.hold == PlateConstraint::OnStop, Event::StopRelease),
        (mode.hold == PlateConstraint::Spring, Event::Yields),
        (is_free, Event::SpeedZero),
        (is_free && above.is_finite(), Event::KnotAhead),
        (is_free && below.is_finite(), Event::KnotBehind),
        (is_free && !mode.is_pressed && setup.has_stop(), Event::StopReached),
        // Only a plate that moves backwards can be faster than the stop.
        (is_free && mode.is_pressed && mode.w_side < 0.0, Event::StopSlack),
    ];
    let of_plate = of_plate.into_iter().filter(|(has, _)| *has).map(|(_, event)| event);
    of_contact(setup, mode).iter().copied().chain(of_plate)
}

/// Returns the events of the contact.
fn of_contact(setup: &ImpactParameters, mode: &HybridMode) -> &'static [Event] {
    let is_free = mode.hold == PlateConstraint::Free;
    match (setup.law, mode.contact) {
        (_, Contact::Perforated) | (ContactLaw::AtOnce, _) => &[],
        (_, Contact::Fused) if setup.interface.is_plastic && is_free => {
            &[Event::PushLimit, Event::PullLimit]
        }
        (_, Contact::Fused) => &[],
        (ContactLaw::Flow, Contact::Penetrating) => &[Event::PieceEnd, Event::SlipZero],
        (ContactLaw::Flow, Contact::Closing) => &[Event::PieceEnd, Event::SlipZero, Event::Bottom],
        (ContactLaw::Flow, Contact::Withdrawing) => &[Event::PieceStart, Event::SlipZero],
        // For a fixed plate the relative velocity is zero only at the end of the history, where it has a double zero.
        (ContactLaw::History(_), _) if is_free => &[Event::HistoryEnd, Event::SlipZero],
        (ContactLaw::History(_), _) => &[Event::HistoryEnd],
        (_, Contact::FreeFlight) => &[Event::Recontact],
        (ContactLaw::Lumped(_), Contact::Penetrating) => &[Event::SlipZero],
        (ContactLaw::Lumped(_), _) => &[Event::ContactLost, Event::Bottom],
    }
}

/// Returns the event function of an event.
pub(super) fn event_function(equations: &Equations<'_>, event: Event, state: &State) -> f64 {
    let Equations { setup, mode } = equations;
    match event {
        Event::PieceEnd => mode.piece.to_m - state.q_m,
        Event::PieceStart => state.q_m - mode.piece.from_m,
        Event::Bottom => mode.deepest_m - state.q_m,
        Event::SlipZero if mode.contact == Contact::Withdrawing => -state.u_m_s,
        Event::SlipZero => state.u_m_s,
        Event::Recontact => recontact(setup, mode, state),
        Event::ContactLost => equations.contact_n(state),
        Event::HistoryEnd => setup.law.lasts_s() - state.t_s,
        Event::PushLimit => equations.limit_loads_n(state).0 - equations.interface_force_n(state),
        // Without a grip, the rounding of a spring that goes slack does not pull the projectile out.
        Event::PullLimit => {
            let rounding_n = equations.mechanism_rounding_n(state.x_m, state.w_m_s);
            equations.limit_loads_n(state).1 + equations.interface_force_n(state) + rounding_n
        }
        // A plate that creeps to a knot at its rest position does not cross it again and again by rounding.
        Event::KnotAhead => equations.knots_m().1 - state.x_m + equations.unresolved_m(),
        Event::KnotBehind => state.x_m - equations.knots_m().0 + equations.unresolved_m(),
        Event::SpeedZero => mode.w_side * state.w_m_s + equations.unresolved_m_s(),
        // An elastic stop follows a plate that moves backwards.
        Event::StopReached if mode.w_side < 0.0 && setup.stop.stiffness_n_m > 0.0 => {
            -equations.stop_n(state.x_m, state.w_m_s)
        }
        Event::StopReached => -equations.beyond_stop_m(state.x_m),
        Event::StopSlack => equations.stop_n(state.x_m, state.w_m_s),
        Event::StopRelease => equations.push_on_stop_n(state),
        // The loop checks this event between steps.
        Event::SpringHolds => 1.0,
        Event::Yields => equations.lock_margin_n(state),
    }
}

/// Returns the event function of renewed contact: the distance to contact. In the dent of a lumped interface it is the force of the damper,
/// which separates projectile and spring.
fn recontact(setup: &ImpactParameters, mode: &HybridMode, state: &State) -> f64 {
    let missing_m = setup.law.slack_m(mode.deepest_m) - state.q_m;
    let ContactLaw::Lumped(lumped) = setup.law else { return missing_m };
    let push_n = lumped.force_n(false, mode.deepest_m, (state.q_m, state.u_m_s));
    larger(missing_m, -push_n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::transitions::first;
    use crate::model::variables::scene_with;

    /// Scene, contact, whether the elastic stop is pressed, and the events that can end them.
    #[rustfmt::skip]
    const MODES: [(&str, Contact, bool, &[Event]); 15] = [
        ("k=1e5", Contact::Penetrating, false, &[Event::PieceEnd, Event::SlipZero, Event::SpeedZero]),
        ("k=1e5 n=2", Contact::Closing, false, &[Event::PieceEnd, Event::SlipZero, Event::Bottom, Event::SpeedZero, Event::KnotBehind]),
        ("k=1e5 n=3", Contact::Withdrawing, false, &[Event::PieceStart, Event::SlipZero, Event::SpeedZero]),
        ("k=1e5", Contact::FreeFlight, false, &[Event::Recontact, Event::SpeedZero]),
        ("k=1e5", Contact::Fused, false, &[Event::SpeedZero]),
        ("k=1e5 interface=plastic", Contact::Fused, false, &[Event::PushLimit, Event::PullLimit, Event::SpeedZero]),
        ("k=1e5 x_stop=1mm stop_kind=elastic", Contact::Perforated, true, &[Event::SpeedZero, Event::StopSlack]),
        ("k=1e5 x_stop=1mm stop_kind=elastic", Contact::Perforated, false, &[Event::SpeedZero, Event::StopReached]),
        ("spring=bistable d=1mm", Contact::Perforated, false, &[Event::SpeedZero, Event::KnotAhead]),
        ("spring=bistable", Contact::Perforated, false, &[Event::SpeedZero, Event::KnotAhead, Event::KnotBehind]),
        ("spring=table", Contact::Perforated, false, &[Event::SpeedZero]),
        ("model=half-sine", Contact::Penetrating, false, &[Event::HistoryEnd, Event::SlipZero, Event::SpeedZero]),
        ("model=lumped", Contact::Penetrating, false, &[Event::SlipZero, Event::SpeedZero]),
        ("model=lumped", Contact::Withdrawing, false, &[Event::ContactLost, Event::Bottom, Event::SpeedZero]),
        ("model=lumped", Contact::FreeFlight, false, &[Event::Recontact, Event::SpeedZero]),
    ];

    #[test]
    fn a_mode_has_the_events_that_can_end_it() {
        for (pairs, contact, is_pressed, expected) in MODES {
            let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
            let w_side = if is_pressed { -1.0 } else { 1.0 };
            let mode = HybridMode { contact, is_pressed, w_side, ..first(&setup).0 };
            assert_eq!(
                possible_events(&setup, &mode).collect::<Vec<_>>(),
                expected,
                "{pairs} {contact:?}"
            );
        }
        let setup = ImpactParameters::from_scene(&scene_with("mount=rigid"), 1e-12);
        let mode = first(&setup).0;
        assert!(possible_events(&setup, &mode).eq([Event::PieceEnd, Event::SlipZero]));
        // Where the plate cannot move the slip is zero at the end of the history alone.
        let setup = ImpactParameters::from_scene(&scene_with("mount=rigid model=half-sine"), 1e-12);
        assert!(possible_events(&setup, &first(&setup).0).eq([Event::HistoryEnd]));
    }

    /// Scene, contact and event, and states (q, u, x, w) before and beyond it.
    type Case = (&'static str, Contact, Event, [f64; 4], [f64; 4]);

    #[rustfmt::skip]
    const GAPS: [Case; 15] = [
        ("k=1e5", Contact::Penetrating, Event::PieceEnd, [1e-3, 9.0, 0.0, 1.0], [2e-2, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Penetrating, Event::SlipZero, [1e-3, 9.0, 0.0, 1.0], [1e-3, -9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Withdrawing, Event::SlipZero, [1e-3, -9.0, 0.0, 1.0], [1e-3, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::Closing, Event::Bottom, [4e-3, 9.0, 0.0, 1.0], [6e-3, 9.0, 0.0, 1.0]),
        ("k=1e5", Contact::FreeFlight, Event::Recontact, [-1e-3, 9.0, 0.0, 1.0], [1e-3, 9.0, 0.0, 1.0]),
        ("k=1e7 interface=plastic", Contact::Fused, Event::PushLimit, [5e-3, 0.0, 1e-3, 1.0], [5e-3, 0.0, 5e-3, 1.0]),
        ("k=1e7 interface=plastic", Contact::Fused, Event::PullLimit, [5e-3, 0.0, -1e-4, 1.0], [5e-3, 0.0, -1e-3, 1.0]),
        ("k=1e5", Contact::Penetrating, Event::SpeedZero, [5e-3, 9.0, 0.0, 1.0], [5e-3, 9.0, 0.0, -1.0]),
        ("k=1e5 x_stop=1mm", Contact::Penetrating, Event::StopReached, [5e-3, 9.0, 0.0, 1.0], [5e-3, 9.0, 2e-3, 1.0]),
        // An elastic stop follows within a millisecond.
        ("k=1e5 x_stop=1mm stop_kind=elastic k_stop=1e6 b_stop=1e3", Contact::Penetrating, Event::StopReached, [5e-3, 9.0, 2e-3, -2.0], [5e-3, 9.0, 2e-3, -0.5]),
        ("spring=constant x_c=1mm", Contact::Perforated, Event::KnotAhead, [5e-3, 9.0, 9e-4, 1.0], [5e-3, 9.0, 1.1e-3, 1.0]),
        ("spring=constant x_c=1mm", Contact::Perforated, Event::KnotBehind, [5e-3, 9.0, -9e-4, -1.0], [5e-3, 9.0, -1.1e-3, -1.0]),
        // A hundredth of 5 mm springs back; a damper holds the interface off its spring, and lets go of it.
        ("model=lumped", Contact::Withdrawing, Event::ContactLost, [4.96e-3, -9.0, 0.0, 1.0], [4.94e-3, -9.0, 0.0, 1.0]),
        ("model=lumped", Contact::FreeFlight, Event::Recontact, [4.94e-3, 9.0, 0.0, 1.0], [4.96e-3, 9.0, 0.0, 1.0]),
        ("model=lumped k_load=1e6 b_2=1e3", Contact::FreeFlight, Event::Recontact, [4.96e-3, -9.0, 0.0, 1.0], [4.96e-3, -0.9, 0.0, 1.0]),
    ];

    #[test]
    fn a_gap_is_above_zero_before_its_event_and_below_beyond_it() {
        for (pairs, contact, event, before, beyond) in GAPS {
            let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
            let w_side = before[3].signum();
            let mode = HybridMode { contact, deepest_m: 5e-3, w_side, ..first(&setup).0 };
            let at = |[q_m, u_m_s, x_m, w_m_s]: [f64; 4]| {
                let state = State { t_s: 0.0, q_m, u_m_s, x_m, w_m_s };
                event_function(&Equations { setup: &setup, mode: &mode }, event, &state)
            };
            assert!(at(before) > 0.0 && at(beyond) < 0.0, "{pairs} {contact:?} {event:?}");
        }
    }
}
