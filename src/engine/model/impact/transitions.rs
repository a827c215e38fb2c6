//! Transitions at events: pure functions of mode, event and state.
//!
//! The interface follows one rule. u > 0 at the bottom of the hole: the hole deepens. u > 0 above it: the gap closes against friction g A
//! S. u < 0: the projectile is pulled out against g A S. u = 0: the bodies stick while the interface force stays within its limit loads. A
//! fused interface never parts.

use std::array;

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::{Contact, Event, HybridMode, PlateConstraint};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::resolution::ROUNDING;
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;
use crate::model::power_law::sign;
use crate::numerics::{larger, smaller};

/// Returns mode and state at first contact.
pub(super) fn first(setup: &ImpactParameters) -> (HybridMode, State) {
    let mut mode = HybridMode {
        contact: Contact::Penetrating,
        hold: if setup.is_rigid_mount { PlateConstraint::Mount } else { PlateConstraint::Free },
        held_m: setup.held_m(),
        is_pressed: false,
        piece: setup.geometry.piece(0.0),
        deepest_m: 0.0,
        stuck_m3: None,
        origin_m: 0.0,
        spring: setup.spring.clone(),
        elastic: setup.with_stop(&setup.spring),
        stretch: setup.spring.stretch(setup.start.x_m),
        crushed_m: 0.0,
        crushed_j: 0.0,
        least: [1e-9 * setup.reference.length_m, 1e-6 * setup.reference.velocity_m_s],
        w_side: if setup.start.w_m_s < 0.0 { -1.0 } else { 1.0 },
    };
    let mut state = State {
        u_m_s: setup.start.closing_m_s * setup.kept,
        x_m: setup.start.x_m,
        w_m_s: setup.start.w_m_s,
        ..State::default()
    };
    if let Some(held_m) = (Equations { setup, mode: &mode }).initial_lock_displacement_m() {
        (mode.hold, mode.held_m, mode.w_side) = (PlateConstraint::Spring, held_m, 1.0);
        hold_plate(setup, &mut state);
    }
    if setup.law == ContactLaw::AtOnce {
        merge_bodies(setup, &mut mode, &mut state);
        setup.update_weight(&mut mode, Contact::Penetrating);
    }
    if state.w_m_s != 0.0 {
        update_direction(setup, &mut mode, &state);
    }
    // A moving plate hits its stop in the loop, which records the work.
    if setup.starts_on_stop() && state.w_m_s == 0.0 {
        reach_stop(setup, &mut mode, &mut state);
        mode.w_side = 1.0;
    }
    (mode, state)
}

/// Stops the plate; the projectile keeps its velocity.
fn hold_plate(setup: &ImpactParameters, state: &mut State) {
    state.u_m_s += setup.cos * state.w_m_s;
    state.w_m_s = 0.0;
}

/// Returns the mode after an event; sets the state exactly to the event, and applies its jump.
pub(super) fn after(
    setup: &ImpactParameters,
    mode: &HybridMode,
    event: Event,
    state: &mut State,
) -> HybridMode {
    let mut next = mode.clone();
    match event {
        Event::KnotAhead => {
            state.x_m = Equations { setup, mode }.knots_m().1;
            next.stretch += 1;
        }
        Event::KnotBehind => {
            state.x_m = Equations { setup, mode }.knots_m().0;
            next.stretch -= 1;
        }
        Event::SpeedZero => {
            state.w_m_s = 0.0;
            next.w_side = -mode.w_side;
        }
        Event::StopReached => reach_stop(setup, &mut next, state),
        Event::StopSlack => next.is_pressed = false,
        Event::StopRelease => {
            state.x_m = setup.stop.position_m - mode.origin_m;
            release(setup, &mut next, state);
        }
        Event::SpringHolds => {
            (next.hold, next.held_m) =
                (PlateConstraint::Spring, setup.relock_displacement_m(state.q_m));
            hold_plate(setup, state);
        }
        Event::Yields => {
            next.hold = PlateConstraint::Free;
            (state.x_m, state.w_m_s) = (Equations { setup, mode }).quasi_static_state(state);
            state.u_m_s -= setup.cos * state.w_m_s;
            next.w_side = sign(state.w_m_s);
        }
        _ => at_contact(setup, mode, event, (&mut next, state)),
    }
    let setup = if event == Event::PieceEnd { setup.at(state.q_m) } else { setup };
    if next.hold == PlateConstraint::OnStop
        && (Equations { setup, mode: &next }).push_on_stop_n(state) < 0.0
    {
        release(setup, &mut next, state);
    }
    unload(setup, &mut next, state);
    setup.update_weight(&mut next, mode.contact);
    if next.contact != mode.contact {
        if next.contact == Contact::Fused {
            // However short the swing is, its forces count.
            let swing = (Equations { setup, mode: &next }).swing(state);
            next.least = array::from_fn(|i| {
                if swing[i] > 0.0 { smaller(swing[i], mode.least[i]) } else { mode.least[i] }
            });
        }
        next.stuck_m3 = None;
        let is_stuck = setup.interface.is_plastic && next.contact == Contact::Fused;
        next.stuck_m3 = is_stuck.then(|| (Equations { setup, mode: &next }).stuck_m3(state));
    }
    next
}

/// Applies an event of the contact.
fn at_contact(
    setup: &ImpactParameters,
    mode: &HybridMode,
    event: Event,
    (next, state): (&mut HybridMode, &mut State),
) {
    let before = Equations { setup, mode };
    match event {
        Event::PieceEnd => {
            state.q_m = mode.piece.to_m;
            let after = setup.at(state.q_m);
            next.piece = after.geometry.piece(state.q_m);
            if after.shears() && !setup.shears() {
                state.u_m_s *= after.kept;
            } else if state.q_m >= setup.geometry.exit_m {
                next.deepest_m = larger(mode.deepest_m, state.q_m);
                next.contact = Contact::Perforated;
            }
        }
        Event::PieceStart => {
            state.q_m = larger(mode.piece.from_m, 0.0);
            start_withdrawal(setup, next, state);
        }
        Event::Bottom => {
            state.q_m = mode.deepest_m;
            start_loading(setup, next, state);
        }
        Event::Recontact => {
            // In the other direction the damper ends its push on the spring.
            if state.u_m_s > 0.0 {
                state.q_m = setup.law.slack_m(mode.deepest_m);
            }
            start_loading(setup, next, state);
        }
        Event::ContactLost => next.contact = Contact::FreeFlight,
        Event::SlipZero if mode.contact == Contact::Penetrating && !before.can_arrest(state) => {
            // The error of the velocity has reached it; the computations of an estimate go on with velocities of their own.
            state.u_m_s = setup.threshold_factor() * before.unresolved_m_s();
        }
        Event::SlipZero | Event::HistoryEnd => {
            if mode.hold == PlateConstraint::Spring {
                next.hold = PlateConstraint::Free;
                (state.x_m, state.w_m_s) = (Equations { setup, mode }).quasi_static_state(state);
            }
            if mode.contact == Contact::Penetrating {
                next.deepest_m = larger(mode.deepest_m, state.q_m);
            }
            if event == Event::HistoryEnd {
                merge_bodies(setup, next, state);
            } else {
                state.u_m_s = 0.0;
                stick_or_slip(setup, next, state);
            }
        }
        Event::PushLimit => start_loading(setup, next, state),
        Event::PullLimit => start_withdrawal(setup, next, state),
        _ => {}
    }
}

/// Starts the unloading branch of an absorber at the present displacement; the energy of crushing is dissipated.
fn unload(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    let x_m = mode.origin_m + state.x_m;
    if state.w_m_s > 0.0 {
        return;
    }
    let Some((spring, crushed_m)) = setup.crushed_at(x_m, mode.crushed_m) else { return };
    mode.crushed_j += mode.spring.energy(x_m) - spring.energy(x_m);
    mode.crushed_m = crushed_m;
    mode.stretch = spring.stretch(x_m.next_down());
    mode.elastic = setup.elastic(&spring, mode.contact);
    mode.spring = spring;
}

/// Perfectly inelastic impact: both bodies get the common velocity, with conserved momentum.
fn merge_bodies(setup: &ImpactParameters, mode: &mut HybridMode, state: &mut State) {
    let v = setup.projectile_m_s(state);
    let momentum = setup.mass.projectile_kg * v * setup.cos + setup.mass.plate_kg * state.w_m_s;
    state.u_m_s = 0.0;
    if mode.hold == PlateConstraint::Free {
        state.w_m_s = momentum / setup.mass.joined_kg;
    }
    if state.w_m_s != 0.0 {
        mode.w_side = sign(state.w_m_s);
    }
    mode.contact = Contact::Fused;
}

/// Sets the contact of a nose that moves into the plate. A lumped interface is on its loading branch at its maximum travel; a prescribed
/// force history does not depend on the depth.
fn start_loading(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    let at_bottom = state.q_m >= mode.deepest_m;
    mode.contact = match setup.law {
        ContactLaw::Lumped(_) if !at_bottom => Contact::Withdrawing,
        ContactLaw::Flow if !at_bottom => Contact::Closing,
        _ => Contact::Penetrating,
    };
    mode.piece = setup.geometry.piece(state.q_m);
}

/// Sets the contact of a nose that moves out of the plate, or is out.
fn start_withdrawal(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    mode.contact = if state.q_m > 0.0 { Contact::Withdrawing } else { Contact::FreeFlight };
    mode.piece = setup.geometry.piece(state.q_m.next_down());
}

/// Decides between stick and slip at zero relative velocity: the bodies stick unless the interface force exceeds a limit load.
fn stick_or_slip(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    mode.contact = match (setup.law, mode.contact) {
        (ContactLaw::History(_), Contact::Withdrawing) => Contact::Penetrating,
        (ContactLaw::History(_) | ContactLaw::Lumped(_), Contact::Penetrating) => {
            Contact::Withdrawing
        }
        _ => Contact::Fused,
    };
    if mode.contact != Contact::Fused || !setup.interface.is_plastic {
        return;
    }
    let equations = Equations { setup, mode };
    let (carried_n, (push_n, pull_n)) =
        (equations.interface_force_n(state), equations.limit_loads_n(state));
    if carried_n > push_n {
        start_loading(setup, mode, state);
    } else if carried_n < -pull_n {
        start_withdrawal(setup, mode, state);
    }
}

/// Applies the contact of the plate with its rigid or elastic stop.
fn reach_stop(setup: &ImpactParameters, mode: &mut HybridMode, state: &mut State) {
    // A plate that moves towards the stop is at the stop; otherwise the stop reaches the plate.
    let is_beyond = setup.stop.restitution.is_none() && state.w_m_s <= 0.0;
    let beyond_m = Equations { setup, mode }.beyond_stop_m(state.x_m);
    (mode.origin_m, state.x_m) = (setup.stop.position_m, if is_beyond { beyond_m } else { 0.0 });
    let Some(restitution) = setup.stop.restitution else {
        mode.is_pressed = true;
        // The damper of the stop has a force at once.
        if mode.contact == Contact::Fused {
            stick_or_slip(setup, mode, state);
        }
        return;
    };
    let joined = mode.contact == Contact::Fused;
    let before = state.w_m_s;
    mode.w_side = -1.0;
    let blow_j = 0.5 * setup.mass.joined_kg * before * before;
    let hole_j = setup.geometry.area_m2(mode.deepest_m) * setup.strength_pa * mode.deepest_m;
    let is_soft = joined
        && setup.interface.is_plastic
        && blow_j < ROUNDING * hole_j
        && Rule::SoftBlow.applies();
    state.w_m_s = if is_soft { 0.0 } else { rebound(setup, mode, restitution, state) };
    if !(joined && (is_soft || !setup.interface.is_plastic)) {
        state.u_m_s += (before - state.w_m_s) * setup.cos;
        if state.u_m_s > 0.0 && matches!(mode.contact, Contact::Fused | Contact::Withdrawing) {
            start_loading(setup, mode, state);
        }
    }
    if state.w_m_s == 0.0 {
        mode.hold = PlateConstraint::OnStop;
    }
}

/// Returns the velocity after an impact on a rigid stop. Bounces of a plate that is pressed on it are parabolas, shorter by the coefficient
/// of restitution each time; zero if all further bounces are negligible.
fn rebound(setup: &ImpactParameters, mode: &HybridMode, restitution: f64, state: &State) -> f64 {
    let speed = restitution * state.w_m_s;
    let left = State { w_m_s: 0.0, ..*state };
    let pressed = Equations { setup, mode }.accelerations(&left).1;
    let way_m = 2.0 * speed * speed / (pressed * (1.0 - restitution));
    let is_over = pressed > 0.0 && way_m < setup.held_m() && Rule::BouncesToRest.applies();
    if is_over { 0.0 } else { -speed }
}

/// Releases the plate from a rigid stop.
fn release(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    mode.hold = PlateConstraint::Free;
    mode.w_side = -1.0;
    mode.stretch = mode.spring.stretch((mode.origin_m + state.x_m).next_down());
    if mode.contact == Contact::Fused {
        stick_or_slip(setup, mode, state);
    }
}

/// Updates the direction of a plate at rest, and the piece of the spring's law at a knot.
pub(super) fn update_direction(setup: &ImpactParameters, mode: &mut HybridMode, state: &State) {
    if mode.hold != PlateConstraint::Free {
        return;
    }
    let equations = Equations { setup, mode };
    let (behind, ahead) = equations.knots_m();
    let is_at_rest = state.w_m_s == 0.0;
    let direction =
        if is_at_rest { sign(equations.accelerations(state).1) } else { sign(state.w_m_s) };
    if is_at_rest && direction != 0.0 {
        mode.w_side = direction;
    }
    // There is no piece beyond an infinite end, even if the displacement overflows.
    if direction > 0.0 && state.x_m >= ahead && ahead.is_finite() {
        mode.stretch += 1;
    } else if direction < 0.0 && state.x_m <= behind && behind.is_finite() {
        mode.stretch -= 1;
    }
}

/// Applies the total remaining slip at once: increases the depth and dissipates the energy.
pub(super) fn apply_remaining_slip(
    setup: &ImpactParameters,
    mode: &mut HybridMode,
    state: &mut State,
    travel_m: f64,
) {
    let from_m = state.q_m;
    state.q_m += travel_m;
    let swept_m3 = setup.geometry.swept_m3(state.q_m) - setup.geometry.swept_m3(from_m);
    let left =
        state.w_m_s * state.w_m_s - 2.0 * setup.strength_pa * swept_m3 / setup.mass.joined_kg;
    state.w_m_s = larger(left, 0.0).sqrt().copysign(state.w_m_s);
    (mode.deepest_m, mode.stuck_m3) = (state.q_m, None);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    const PLASTIC: &str = "k=1e7 interface=plastic";

    /// The mode and the state after an event in a hole of 5 mm of travel, from a state (q, u, x, w).
    fn after_event(
        pairs: &str,
        contact: Contact,
        event: Event,
        [q_m, u_m_s, x_m, w_m_s]: [f64; 4],
    ) -> (HybridMode, State) {
        let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
        let (first, state) = first(&setup);
        let mut mode = HybridMode { contact, deepest_m: 5e-3, ..first };
        if contact == Contact::Withdrawing {
            mode.piece = setup.geometry.piece(q_m.next_down());
        }
        let mut state = State { q_m, u_m_s, x_m, w_m_s, ..state };
        (after(&setup, &mode, event, &mut state), state)
    }

    /// Transitions of two bodies of 29.5 g. While they stick, the interface carries half of the spring's 50 kN at 5 mm; the limit loads are
    /// 15 kN and 1.5 kN.
    #[rustfmt::skip]
    const TRANSITIONS: [(&str, Contact, Event, [f64; 4], Contact); 24] = [
        ("k=1e5", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 0.0, 20.0], Contact::Fused),
        ("k=1e7", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 5e-3, 1.0], Contact::Fused),
        (PLASTIC, Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 1e-4, 1.0], Contact::Fused),
        (PLASTIC, Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 5e-3, 1.0], Contact::Penetrating),
        (PLASTIC, Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, -5e-3, 1.0], Contact::Withdrawing),
        (PLASTIC, Contact::Closing, Event::SlipZero, [4e-3, 0.0, 5e-3, 1.0], Contact::Closing),
        (PLASTIC, Contact::Fused, Event::PushLimit, [5e-3, 0.0, 5e-3, 1.0], Contact::Penetrating),
        (PLASTIC, Contact::Fused, Event::PushLimit, [4e-3, 0.0, 5e-3, 1.0], Contact::Closing),
        (PLASTIC, Contact::Fused, Event::PullLimit, [5e-3, 0.0, -5e-3, 1.0], Contact::Withdrawing),
        // Without strength the spring's pull on the plate, away from the projectile, ends the slip; its push does not.
        ("k=1e5 S_y=0", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, -5e-3, 1.0], Contact::Fused),
        ("k=1e5 S_y=0", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 5e-3, 1.0], Contact::Penetrating),
        ("k=0 S_y=0", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 5e-3, 1.0], Contact::Penetrating),
        ("k=1e5", Contact::Closing, Event::Bottom, [5e-3, 9.0, 0.0, 1.0], Contact::Penetrating),
        ("k=1e5", Contact::Withdrawing, Event::PieceStart, [1e-4, -9.0, 0.0, 1.0], Contact::FreeFlight),
        ("k=1e5", Contact::FreeFlight, Event::Recontact, [0.0, 9.0, 0.0, 1.0], Contact::Closing),
        (PLASTIC, Contact::Fused, Event::SpeedZero, [5e-3, 0.0, 1e-4, 1e-17], Contact::Fused),
        ("model=half-sine", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 1e-4, 1.0], Contact::Withdrawing),
        ("model=half-sine", Contact::Withdrawing, Event::SlipZero, [4e-3, 0.0, 1e-4, 1.0], Contact::Penetrating),
        ("model=half-sine", Contact::Withdrawing, Event::HistoryEnd, [4e-3, -9.0, 1e-4, 9.0], Contact::Fused),
        ("model=lumped", Contact::Penetrating, Event::SlipZero, [5e-3, 0.0, 1e-4, 1.0], Contact::Withdrawing),
        ("model=lumped", Contact::Withdrawing, Event::Bottom, [5e-3, 9.0, 1e-4, 1.0], Contact::Penetrating),
        ("model=lumped", Contact::Withdrawing, Event::ContactLost, [5e-3, -9.0, 1e-4, 1.0], Contact::FreeFlight),
        ("model=lumped", Contact::FreeFlight, Event::Recontact, [4.9e-3, 9.0, 1e-4, 1.0], Contact::Withdrawing),
        // Its damper has let go of its spring, which takes over again.
        ("model=lumped b_2=100", Contact::FreeFlight, Event::Recontact, [4.99e-3, -9.0, 1e-4, 1.0], Contact::Withdrawing),
    ];

    #[test]
    fn each_event_leads_to_its_contact() {
        for (pairs, contact, event, state, expected) in TRANSITIONS {
            let (found, _) = after_event(pairs, contact, event, state);
            assert_eq!(found.contact, expected, "{pairs} {contact:?} {event:?} {state:?}");
        }
    }

    /// The drag A c u² leaves a velocity that decays as 1/t and is never zero.
    #[test]
    fn drag_alone_leaves_a_slip() {
        for (pairs, slips) in [("k=1e5", false), ("k=1e5 S_y=0", true)] {
            let state = [5e-3, -1e-25, 5e-3, 1.0];
            let (_, state) = after_event(pairs, Contact::Penetrating, Event::SlipZero, state);
            assert_eq!(state.u_m_s > 0.0, slips, "{pairs}: {state:?}");
        }
    }

    #[test]
    fn the_last_piece_leads_through_the_plate_and_the_others_to_the_next() {
        let (mode, state) =
            after_event("k=1e5", Contact::Penetrating, Event::PieceEnd, [6e-3, 9.0, 0.0, 1.0]);
        assert_eq!(mode.contact, Contact::Penetrating);
        assert_eq!(mode.piece.from_m.to_bits(), state.q_m.to_bits());
        let setup = ImpactParameters::from_scene(&scene_with("k=1e5"), 1e-12);
        let mut last = first(&setup).0;
        last.piece = *setup.geometry.pieces().last().unwrap();
        let mut state = State { u_m_s: 9.0, ..State::default() };
        let gone = after(&setup, &last, Event::PieceEnd, &mut state);
        assert_eq!(gone.contact, Contact::Perforated);
        assert_eq!(state.q_m.to_bits(), setup.geometry.exit_m.to_bits());
    }

    /// Alone the plate comes back with e times its speed, and the projectile keeps its own: the slip grows by what the plate loses.
    #[test]
    fn valid_a_rigid_stop_reverses_the_plate_and_leaves_the_projectile_its_velocity() {
        let hit = |pairs: &str, contact| {
            after_event(pairs, contact, Event::StopReached, [4e-3, 7.0, 1e-3, 2.0])
        };
        let (mode, state) = hit("k=1e5 x_stop=0.001 e=0.5", Contact::Penetrating);
        assert_eq!(
            (mode.hold, mode.w_side.to_bits()),
            (PlateConstraint::Free, (-1.0f64).to_bits())
        );
        assert!((state.w_m_s + 1.0).abs() < 1e-15 && (state.u_m_s - 10.0).abs() < 1e-15);
        assert_eq!((mode.origin_m.to_bits(), state.x_m.to_bits()), (1e-3f64.to_bits(), 0));
        // Without restitution the contact's 15 kN hold it there against the spring's 100 N; gone, nothing does.
        assert_eq!(
            hit("k=1e5 x_stop=0.001 e=0", Contact::Penetrating).0.hold,
            PlateConstraint::OnStop
        );
        assert_eq!(
            hit("k=1e5 x_stop=0.001 e=0", Contact::Perforated).0.hold,
            PlateConstraint::Free
        );
    }

    #[test]
    fn a_joined_body_is_stopped_whole_where_it_is_fused_and_slips_where_it_is_plastic() {
        for (law, contact, slip) in
            [("fused", Contact::Fused, 0.0), ("plastic", Contact::Penetrating, 2.0)]
        {
            let pairs = format!("k=1e5 x_stop=0.001 e=0 interface={law}");
            let state = [5e-3, 0.0, 1e-3, 2.0];
            let (mode, state) = after_event(&pairs, Contact::Fused, Event::StopReached, state);
            assert_eq!(mode.contact, contact, "{law}");
            assert!((state.u_m_s - slip).abs() < 1e-15, "{law}: {state:?}");
        }
    }

    /// Flights of t = 2 w/a, each e times the one before, add up to a way of 2 w² /(a (1 - e)): with the contact's 15 kN on 29.5 g
    /// that of 1 mm/s is 8e-12 m, that of 1 um/s 8e-18 m.
    #[test]
    fn valid_a_plate_that_is_pressed_bounces_until_its_flights_are_too_short() {
        let pairs = "k=1e5 x_stop=0.001 e=0.5";
        for (speed, hold) in [(1e-3, PlateConstraint::Free), (1e-6, PlateConstraint::OnStop)] {
            let state = [5e-3, 0.0, 1e-3, speed];
            let (mode, _) = after_event(pairs, Contact::Penetrating, Event::StopReached, state);
            assert_eq!(mode.hold, hold, "{speed}");
        }
    }

    /// 5 kN crush it from 0.5 mm on: at 3 mm it has taken 13.75 J, of which its elastic rise gives back 1.25 J, and it is slack at
    /// 2.5 mm.
    #[test]
    fn valid_an_absorber_unloads_from_where_the_plate_turns() {
        let pairs = "spring=crush F_crush=5e3 k_crush=1e7 x_crush=0.1";
        let turned =
            |x_m, event| after_event(pairs, Contact::Penetrating, event, [5e-3, 7.0, x_m, 0.0]).0;
        let mode = turned(3e-3, Event::SpeedZero);
        assert!((mode.crushed_j - 12.5).abs() < 1e-12, "{}", mode.crushed_j);
        assert!((mode.spring.energy(3e-3) - 1.25).abs() < 1e-12);
        assert_eq!(mode.spring.ends(mode.stretch), (2.5e-3, 3e-3));
        let elastic = turned(4e-4, Event::SpeedZero);
        assert_eq!((elastic.crushed_m.to_bits(), elastic.crushed_j.to_bits()), (0, 0));
        // So it does from a rigid stop.
        let stopped = format!("{pairs} x_stop=3mm e=0.5");
        let state = [5e-3, 7.0, 3e-3, 2.0];
        let mode = after_event(&stopped, Contact::Penetrating, Event::StopReached, state).0;
        assert!((mode.crushed_j - 12.5).abs() < 1e-12, "{}", mode.crushed_j);
    }

    /// 2.95 kg m/s of both bodies together: at once, and after a history that leaves each the velocity that it has.
    #[test]
    fn valid_bodies_that_become_one_keep_their_momentum() {
        let (mode, state) = first(&ImpactParameters::from_scene(
            &scene_with("gamma=1 model=initial-velocity"),
            1e-12,
        ));
        assert_eq!((mode.contact, state.u_m_s.to_bits()), (Contact::Fused, 0));
        assert!((state.w_m_s - 50.0).abs() < 1e-13);
        let is_rigid_mount = first(&ImpactParameters::from_scene(
            &scene_with("mount=rigid model=initial-velocity"),
            1e-12,
        ))
        .1;
        assert_eq!(is_rigid_mount.w_m_s.to_bits(), 0);
        let state = [4e-3, -90.0, 1e-4, 95.0];
        let pairs = "gamma=1 model=half-sine";
        let (mode, state) = after_event(pairs, Contact::Withdrawing, Event::HistoryEnd, state);
        assert!((state.w_m_s - 50.0).abs() < 1e-13, "{state:?}");
        assert_eq!(mode.w_side.to_bits(), 1f64.to_bits());
    }

    #[test]
    fn an_elastic_stop_presses_lets_go_and_is_left() {
        let pairs = "k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e6 b_stop=1e3";
        let after = |event, x_m, w_m_s| {
            let state = [5e-3, 7.0, x_m, w_m_s];
            let (mode, state) = after_event(pairs, Contact::Penetrating, event, state);
            (mode.is_pressed, mode.origin_m + state.x_m)
        };
        assert_eq!(after(Event::StopReached, 1e-3 + 1e-18, 2.0), (true, 1e-3));
        assert_eq!(after(Event::StopReached, 2e-3, -1.0), (true, 2e-3));
        assert_eq!(after(Event::StopSlack, 2e-3, -1.0), (false, 2e-3));
        assert_eq!(after(Event::StopSlack, 1e-3, -1.0), (false, 1e-3));
    }

    #[test]
    fn sides_follow_the_plate_through_the_zeros_of_its_laws() {
        let pairs = "k=1e5 n=1.5";
        let state = [5e-3, 7.0, 1e-20, -2.0];
        let (mode, state) = after_event(pairs, Contact::Penetrating, Event::KnotBehind, state);
        assert_eq!((mode.stretch, state.x_m.abs().to_bits()), (0, 0));
        let state = [5e-3, 7.0, 1e-3, 1e-20];
        let (mode, state) = after_event(pairs, Contact::Penetrating, Event::SpeedZero, state);
        assert_eq!((mode.w_side.to_bits(), state.w_m_s.to_bits()), ((-1.0f64).to_bits(), 0));
    }

    /// 19 kN against k x^n: a spring of 1 MN/m^0.1 yields by 7e-18 m, one of 100 kN/m by 0.19 m.
    #[test]
    fn a_steep_spring_holds_the_plate_at_first_and_a_soft_one_does_not() {
        let hold =
            |pairs: &str| first(&ImpactParameters::from_scene(&scene_with(pairs), 1e-12)).0.hold;
        assert_eq!(hold("k=1e6 n=0.1"), PlateConstraint::Spring);
        assert_eq!(hold("k=1e6 n=0.2"), PlateConstraint::Spring);
        for pairs in ["k=1e5", "k=1e6 n=0.5", "k=1e6 n=0.1 d=0.001", "b=100 m=0.5", "b=1e4 m=0.2"] {
            assert_eq!(hold(pairs), PlateConstraint::Free, "{pairs}");
        }
        assert_eq!(hold("mount=rigid"), PlateConstraint::Mount);
    }
}
