//! Tables of the events that are watched and missed in each mode, of projections onto them, of energy bounds and outcomes.

use super::{Body, MaximumDisplacement, Noted};
use crate::model::event_function::EventId;
use crate::model::impact::problem::Problem;
use crate::model::impact::simulation::Simulation;
use crate::model::run::{Mode, Outcome};

/// `m_p`, kg, and the impact velocity, m/s, of the default scene; gamma = 1.
const MASS_KG: f64 = 0.0295;
const VELOCITY_M_S: f64 = 100.0;

fn body(problem: &Problem, mode: Mode, state: [f64; 4]) -> Body<'_> {
    Simulation::at(problem, mode, state).body
}

#[test]
fn each_mode_watches_its_own_events() {
    use EventId as E;
    let slip = [3e-3, 10.0, 1e-3, 20.0];
    #[rustfmt::skip]
    let cases: [(&str, Mode, &[E]); 13] = [
        ("k=1e5", Mode::Penetrating, &[E::PieceEnd, E::SlipZero, E::PlateSpeedZero]),
        ("k=1e5 n=2", Mode::Penetrating, &[E::PieceEnd, E::SlipZero, E::PlateZero, E::PlateSpeedZero]),
        ("k=1e5", Mode::Closing, &[E::PieceEnd, E::SlipZero, E::HoleBottom, E::PlateSpeedZero]),
        ("k=1e5", Mode::Withdrawing, &[E::PieceStart, E::SlipZero, E::PlateSpeedZero]),
        ("k=1e5", Mode::FreeFlight, &[E::Recontact, E::PlateSpeedZero]),
        ("k=1e5", Mode::Perforated, &[E::PlateSpeedZero]),
        ("k=1e5 x_stop=0.01", Mode::Perforated, &[E::PlateSpeedZero, E::StopReached]),
        ("k=1e5", Mode::Fused, &[E::PushLimit, E::PullLimit, E::PlateSpeedZero]),
        ("k=1e5 model=half-sine", Mode::Penetrating, &[E::HistoryEnd, E::SlipZero, E::PlateSpeedZero]),
        ("k=1e5 model=half-sine", Mode::Fused, &[E::PlateSpeedZero]),
        ("k=1e5 model=lumped", Mode::Penetrating, &[E::SlipZero, E::PlateSpeedZero]),
        ("k=1e5 model=lumped", Mode::Closing, &[E::ContactLost, E::HoleBottom, E::PlateSpeedZero]),
        ("k=1e5 model=lumped", Mode::FreeFlight, &[E::Recontact, E::PlateSpeedZero]),
    ];
    for (pairs, mode, expected) in cases {
        let problem = Problem::with(pairs);
        let events = body(&problem, mode, slip).active_events(false, Noted::default());
        let found: Vec<E> = events.iter().map(|(event, _)| *event).collect();
        assert_eq!(found, expected, "{pairs} {mode:?}");
    }
    let problem = Problem::with("k=1e5");
    let noted = Noted { push: true, pull: true };
    let events = body(&problem, Mode::Fused, slip).active_events(false, noted);
    assert_eq!(events.iter().count(), 1);
}

#[test]
fn an_event_behind_the_state_is_found_once_it_is_behind() {
    use EventId as E;
    for (pairs, mode, state, expected) in [
        ("k=1e5", Mode::Penetrating, [3e-3, -1e-9, 0.0, 1.0], Some(E::SlipZero)),
        ("k=1e5", Mode::Penetrating, [3e-3, 1e-9, 0.0, 1.0], None),
        ("k=1e5 h=0.001", Mode::Penetrating, [1.0, 5.0, 0.0, 1.0], Some(E::PieceEnd)),
        ("k=1e5", Mode::Closing, [5e-3, 1.0, 0.0, 1.0], Some(E::HoleBottom)),
        ("k=1e5", Mode::Withdrawing, [0.0, -1.0, 0.0, 1.0], Some(E::PieceStart)),
        ("k=1e5", Mode::FreeFlight, [1e-9, 1.0, 0.0, 1.0], Some(E::Recontact)),
        ("k=1e5", Mode::FreeFlight, [1e-9, -1.0, 0.0, 1.0], None),
        ("k=1e5 x_stop=0.001", Mode::Perforated, [0.0, 0.0, 1e-3, 1.0], Some(E::StopReached)),
        ("k=1e5 x_stop=0.001", Mode::Perforated, [0.0, 0.0, 1e-3, -1.0], None),
        ("k=1e5 model=lumped", Mode::Withdrawing, [1e-3, -1.0, 0.0, 0.0], Some(E::ContactLost)),
        ("k=1e5 model=lumped", Mode::Closing, [5e-3, 1.0, 0.0, 0.0], Some(E::HoleBottom)),
    ] {
        let problem = Problem::with(pairs);
        let found = body(&problem, mode, state).missed_event();
        assert_eq!(found, expected, "{pairs} {mode:?} {state:?}");
    }
}

#[test]
fn a_projection_puts_one_component_exactly_on_its_event() {
    use EventId as E;
    let near = [4.9e-3, 1e-12, 1e-3 + 1e-15, 1e-12];
    let problem = Problem::with("k=1e5 n=2 x_stop=0.001");
    for (event, expected) in [
        (E::SlipZero, [near[0], 0.0, near[2], near[3]]),
        (E::HoleBottom, [5e-3, near[1], near[2], near[3]]),
        (E::Recontact, [0.0, near[1], near[2], near[3]]),
        (E::PlateZero, [near[0], near[1], 0.0, near[3]]),
        (E::PlateSpeedZero, [near[0], near[1], near[2], 0.0]),
        (E::StopReached, [near[0], near[1], 1e-3, near[3]]),
        (E::PushLimit, near),
    ] {
        let mut body = body(&problem, Mode::Closing, near);
        let before = body.state;
        body.project_onto_event(event, &before);
        let state = body.state;
        let found = [state.travel_m, state.slip_m_s, state.plate_m, state.plate_m_s];
        assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{event:?}");
    }
}

#[test]
fn valid_the_remaining_energy_bounds_displacement_and_load() {
    // A linear spring: x = sqrt(2 E/k), and the interface carries half of its force where both bodies weigh the same.
    let energy_j = 0.2;
    let exact = (2.0 * energy_j / 1e5f64).sqrt();
    let own = Problem::with("k=1e5");
    let fused = body(&own, Mode::Fused, [5e-3, 0.0, 1e-4, 1.0]);
    assert!((fused.reach_with(energy_j) / exact - 1.0).abs() < 1e-14);
    assert!((fused.push_at(energy_j) / (0.5 * 1e5 * exact) - 1.0).abs() < 1e-14);
    assert!((fused.energy_j() / (MASS_KG + 0.5e5 * 1e-8) - 1.0).abs() < 1e-14);
    // An elastic stop of the same stiffness at 1 mm: k x²/2 + k (x - a)²/2 = E.
    let stopped = Problem::with("k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e5 b_stop=0");
    let reach = body(&stopped, Mode::Fused, [5e-3, 0.0, 1e-4, 1.0]).reach_with(energy_j);
    let exact = 0.5 * (1e-3 + (4.0 * energy_j / 1e5 - 1e-6f64).sqrt());
    assert!((reach / exact - 1.0).abs() < 1e-12, "{reach} {exact}");
}

#[test]
fn an_outcome_is_decided_as_soon_as_nothing_can_change_it() {
    use Outcome as O;
    for (pairs, mode, state, expected) in [
        ("k=1e5", Mode::Penetrating, [3e-3, 50.0, 0.0, 10.0], O::Moving),
        ("k=1e5", Mode::Perforated, [0.1, 50.0, 0.0, 10.0], O::Perforated),
        ("k=1e5", Mode::Fused, [5e-3, 0.0, 0.0, 50.0], O::Arrested),
        // Plastic: the interface carries A S = 17 kN, half of the spring's force; 50 m/s on 59 g press it with 38 kN.
        ("k=1e7 interface=plastic", Mode::Fused, [5e-3, 0.0, 0.0, 50.0], O::Moving),
        ("k=1e3 interface=plastic", Mode::Fused, [5e-3, 0.0, 0.0, 1.0], O::Arrested),
        // It flies away faster than the plate can ever go, or slower.
        ("k=1e5", Mode::FreeFlight, [-1e-3, -60.0, 0.0, 20.0], O::Separated),
        ("k=1e5", Mode::FreeFlight, [-1e-3, -30.0, 0.0, 20.0], O::Moving),
        ("k=0", Mode::FreeFlight, [-1e-3, -30.0, 0.0, 40.0], O::Separated),
        ("k=1e5", Mode::FreeFlight, [-1e-3, 30.0, 0.0, -20.0], O::Moving),
        // Everything at rest in a contact that only pushes.
        ("k=1e5 model=lumped", Mode::Closing, [4.95e-3, 0.0, 0.0, 0.0], O::Arrested),
    ] {
        let problem = Problem::with(pairs);
        assert_eq!(body(&problem, mode, state).outcome(), expected, "{pairs} {mode:?} {state:?}");
    }
}

#[test]
fn valid_the_greatest_displacement_of_a_joined_plate_is_a_closed_form() {
    use MaximumDisplacement as M;
    let w = 0.5 * VELOCITY_M_S;
    for (pairs, expected) in [
        ("k=1e5", Some(w * (2.0 * MASS_KG / 1e5f64).sqrt())),
        // The damper alone: M w/b.
        ("k=0 b=100", Some(2.0 * MASS_KG * w / 100.0)),
        ("k=0", None),
    ] {
        let problem = Problem::with(pairs);
        let found = body(&problem, Mode::Fused, [5e-3, 0.0, 0.0, w]).maximum_displacement(0.0);
        match expected {
            Some(exact) => {
                let M::Known(x) = found else { panic!("{pairs}: {found:?}") };
                assert!((x / exact - 1.0).abs() < 1e-14, "{pairs}: {x}");
            }
            None => assert_eq!(found, M::Unbounded),
        }
    }
}
