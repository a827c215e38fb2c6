//! Transitions after events: the interface law and the stop.
//!
//! One rule serves every mode. u > 0 at the bottom of the hole: the hole deepens. u > 0 above it:
//! the gap closes against friction g A S. u < 0: the projectile is pulled out against g A S. u = 0: together, as long as
//! the force the interface must carry stays within its limits.

use crate::model::event_function::EventId;
use crate::model::impact::body::{Body, side};
use crate::model::impact::simulation::Simulation;
use crate::model::mechanism::stop::{Hit, SLOW};
use crate::model::run::{Arrest, Departure, EventKind, Mode};

/// Hits of the stop slower than this part of the impact velocity are not events of the run.
const NOTED_HIT: f64 = 1e-9;

/// First step of the implicit method, relative to the time reached, where the plate is too slow for Taylor steps.
const UNRESOLVED_STEP: f64 = 1e-3;

impl Simulation<'_> {
    fn note(&mut self, kind: EventKind) {
        self.record.event(self.body.state.t_s, kind);
    }

    pub(super) fn handle(&mut self, event: EventId) {
        match event {
            EventId::PieceEnd => self.piece_end(),
            EventId::PieceStart => self.piece_start(),
            EventId::HoleBottom => self.deepen(),
            EventId::SlipZero => self.common_velocity(),
            EventId::Recontact | EventId::ContactAgain => {
                self.note(EventKind::Recontact);
                self.body.mode =
                    if self.body.deepest_m > 0.0 { Mode::Closing } else { Mode::Penetrating };
            }
            EventId::ContactLost => self.separate(),
            EventId::DentLeft => {}
            EventId::HistoryEnd => self.join(),
            EventId::PlateZero => self.plate_zero(),
            EventId::KnotAhead => self.body.region += 1,
            EventId::KnotBehind => self.body.region -= 1,
            EventId::PlateSpeedZero => self.plate_speed_zero(),
            EventId::PlateClear => self.body.x_zero.restore(self.body.state.plate_m),
            EventId::PlateSpeedClear => self.body.w_zero.restore(self.body.state.plate_m_s),
            EventId::StopReached => self.hit_stop(),
            EventId::StopCleared => self.body.stop_touches = false,
            // Behind its place there is nothing to press on.
            EventId::StopPressed => {
                self.body.stop_touches =
                    self.body.state.plate_m > self.body.problem.mechanism.stop_at_m;
            }
            EventId::StopRelease => self.release(),
            EventId::PushLimit | EventId::PullLimit => self.pass_limit(event),
        }
        if self.body.rests_on_stop && self.body.net_push_on_stop() < 0.0 {
            self.release();
        }
    }

    fn piece_end(&mut self) {
        let geometry = &self.body.problem.geometry;
        let q = self.body.state.travel_m;
        if q >= geometry.exit_m {
            self.record.exit = Some(self.departure());
            self.note(EventKind::Perforation);
            self.body.mode = Mode::Perforated;
        } else if self.body.mode == Mode::Penetrating {
            let depth = geometry.depth_m(q);
            let close = |other: f64| (depth - other).abs() < 1e-9 * depth;
            if close(geometry.thickness_m) {
                self.note(EventKind::RearFace);
            } else if depth > 0.99 * geometry.nose.full_from_m()
                && depth < 1.01 * geometry.nose.full_from_m()
            {
                self.note(EventKind::NoseBuried);
            }
        }
    }

    fn piece_start(&mut self) {
        if self.body.state.travel_m <= 0.0 {
            self.body.state.travel_m = 0.0;
            self.separate();
        }
    }

    fn separate(&mut self) {
        self.body.mode = Mode::FreeFlight;
        self.record.separation = Some(self.departure());
        self.note(EventKind::Separation);
    }

    fn departure(&self) -> Departure {
        let Body { state, problem, .. } = &self.body;
        Departure { t_s: state.t_s, velocity_m_s: state.projectile_m_s(problem.cos) }
    }

    /// Makes the bodies one, with the momentum they have. The energy that this takes is the contact's.
    fn join(&mut self) {
        let problem = self.body.problem;
        let (v, w) = (self.body.state.projectile_m_s(problem.cos), self.body.state.plate_m_s);
        let energy_j = 0.5 * (problem.projectile_kg * v * v + problem.plate_kg * w * w);
        let momentum = problem.projectile_kg * v * problem.cos + problem.plate_kg * w;
        let joined = if self.body.is_still() { 0.0 } else { momentum / problem.joined_kg };
        (self.body.state.slip_m_s, self.body.state.plate_m_s) = (0.0, joined);
        self.record.work.penetration_j += energy_j - 0.5 * problem.joined_kg * joined * joined;
        self.note_arrest();
        self.body.mode = Mode::Fused;
        self.point();
    }

    fn common_velocity(&mut self) {
        if self.body.mode == Mode::Withdrawing && !self.body.problem.flows() {
            self.body.mode = self.body.problem.contact.turned_forward();
            return;
        }
        self.note_arrest();
        self.settle();
    }

    /// Notes common velocity; the collision that takes no time has no depth then.
    fn note_arrest(&mut self) {
        let first = self.record.first_arrest.is_none();
        if first && self.body.problem.contact.hole_m(self.body.deepest_m).is_some() {
            self.record.first_arrest = Some(Arrest {
                t_s: self.body.state.t_s,
                penetration_m: self.body.problem.geometry.depth_m(self.body.state.travel_m),
                plate_displacement_m: self.body.state.plate_m,
                plate_velocity_m_s: self.body.state.plate_m_s,
            });
        }
        self.note(if first { EventKind::FirstArrest } else { EventKind::Arrest });
    }

    /// Common velocity: together, or on to what the contact model says.
    fn settle(&mut self) {
        self.body.state.slip_m_s = 0.0;
        if self.body.mode != Mode::Fused {
            self.body.mode = self.body.problem.contact.at_common_velocity();
        }
        if self.body.mode == Mode::Fused
            && !self.yields_at_once()
            && self.body.problem.plastic
            && !self.body.is_still()
        {
            self.body.count_yields();
            self.yield_to_the_end();
        }
    }

    /// Whether the interface of the joined body yields at once, which it then does.
    fn yields_at_once(&mut self) -> bool {
        let motion = self.body.motion();
        let carried = if self.body.is_still() {
            0.0
        } else {
            self.body.problem.interface_fraction * motion.mechanism_force(&self.body.state)
        };
        let (push, pull) = self.body.interface_limits_n();
        let limit = if carried > push {
            Some(EventId::PushLimit)
        } else {
            (carried < -pull).then_some(EventId::PullLimit)
        };
        // A fused interface without strength has no limits to pass.
        if let Some(limit) = limit.filter(|_| self.body.problem.plastic || push != 0.0) {
            self.pass_limit(limit);
        }
        self.body.mode != Mode::Fused
    }

    /// A plastic interface yields at its limit; for a fused one the first time is noted.
    fn pass_limit(&mut self, limit: EventId) {
        let is_push = limit == EventId::PushLimit;
        match (self.body.problem.plastic, is_push) {
            (true, true) => self.resume(),
            (true, false) => {
                self.body.mode = Mode::Withdrawing;
                self.note(EventKind::PullOut);
            }
            (false, _) => {
                let record = &mut self.record;
                let first_s =
                    if is_push { &mut record.push_exceeded_s } else { &mut record.pull_exceeded_s };
                if first_s.is_none() {
                    *first_s = Some(self.body.state.t_s);
                    self.note(EventKind::InterfaceExceeded);
                }
            }
        }
    }

    /// The interface yields forwards.
    fn resume(&mut self) {
        if self.body.state.travel_m >= self.body.deepest_m {
            self.deepen();
        } else {
            self.body.mode = Mode::Closing;
        }
    }

    /// The bottom of the hole is reached with speed to spare.
    fn deepen(&mut self) {
        self.body.mode = Mode::Penetrating;
        self.record.resumed_s.get_or_insert(self.body.state.t_s);
        self.note(EventKind::Resumption);
    }

    fn plate_zero(&mut self) {
        if self.body.spring_is_whole() {
            self.body.x_zero.side = -self.body.x_zero.side;
        } else if self.body.plate_is_unresolved() {
            // Below what Taylor steps resolve: the implicit method follows the spring's force instead.
            self.control.stiff = true;
            self.control.unit_s = UNRESOLVED_STEP * self.body.state.t_s;
        } else {
            self.control.shorten_unit(self.body.omit_spring());
        }
    }

    fn plate_speed_zero(&mut self) {
        if self.body.problem.mechanism.damper.is_singular() && !self.control.stiff {
            self.note_greatest_displacement();
            self.control.shorten_unit(self.body.omit_damper());
        } else {
            self.turned_round();
        }
    }

    pub(super) fn turned_round(&mut self) {
        self.note_greatest_displacement();
        self.body.w_zero.side = -self.body.w_zero.side;
    }

    fn note_greatest_displacement(&mut self) {
        if self.body.w_zero.side > 0.0 && self.body.state.plate_m >= self.record.max_displacement_m
        {
            self.note(EventKind::GreatestDisplacement);
        }
    }

    fn hit_stop(&mut self) {
        self.record.reach(&self.body.state);
        let Some(stop) = self.body.problem.mechanism.rigid_stop() else {
            self.note(EventKind::StopHit);
            self.body.stop_touches = true;
            // Its damper pushes at once: no event function falls where the force jumps.
            if self.body.mode == Mode::Fused {
                self.yields_at_once();
            }
            return;
        };
        let joined = self.body.mode == Mode::Fused && !self.body.problem.plastic;
        let mass = if joined { self.body.problem.joined_kg } else { self.body.problem.plate_kg };
        let before = self.body.state.plate_m_s;
        let rate = self.body.motion().accelerations(&self.body.state).plate_m_s2;
        let after = stop.rebound(&Hit {
            velocity: before,
            acceleration: rate,
            slow: SLOW
                * self.body.tolerance
                * (self.body.problem.velocity_m_s + self.body.speed_scale_m_s),
            length_scale: self.body.stop_scale_m(),
        });
        if before > NOTED_HIT * self.body.problem.velocity_m_s {
            self.note(EventKind::StopHit);
        }
        self.record.work.stop_j += 0.5 * mass * (before - after) * (before + after);
        self.body.state.plate_m_s = after;
        self.body.w_zero.side = -1.0;
        if !joined {
            self.body.state.slip_m_s += (before - after) * self.body.problem.cos;
            self.slip_has_jumped();
        }
        if after < 0.0 {
            self.control.shorten_unit(after.abs() / rate.abs());
        }
        if after == 0.0 {
            self.body.rests_on_stop = true;
            if self.body.mode == Mode::Fused {
                self.settle();
            }
            if self.body.net_push_on_stop() >= 0.0 {
                self.note(EventKind::StopHold);
            }
        }
    }

    /// The stop has changed the plate's velocity, not the projectile's.
    fn slip_has_jumped(&mut self) {
        match self.body.mode {
            Mode::Fused if self.body.state.slip_m_s > 0.0 => self.resume(),
            Mode::Withdrawing if self.body.state.slip_m_s > 0.0 => {
                self.body.mode = self.body.problem.contact.turned_forward();
            }
            Mode::Withdrawing if self.body.state.slip_m_s == 0.0 => self.settle(),
            _ => {}
        }
    }

    /// The net push on a plate at rest on its rigid stop has become negative: it is free until it comes back with speed.
    fn release(&mut self) {
        (self.body.rests_on_stop, self.body.released) = (false, true);
        self.body.w_zero.side = -1.0;
        self.body.x_zero.side = side(self.body.state.plate_m, -1.0);
        self.note(EventKind::StopRelease);
        if self.body.mode == Mode::Fused {
            self.settle();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::problem::Problem;
    use crate::model::motion::State;

    /// The view of a run after an event.
    fn look<T>(
        pairs: &str,
        mode: Mode,
        event: EventId,
        state: [f64; 4],
        look: impl Fn(&Simulation<'_>) -> T,
    ) -> T {
        let problem = Problem::with(pairs);
        let mut simulation = Simulation::at(&problem, mode, state);
        simulation.apply_transition(event);
        look(&simulation)
    }

    fn noted(simulation: &Simulation<'_>) -> Vec<EventKind> {
        simulation.record.events.iter().map(|event| event.kind).collect()
    }

    /// Mode, slip and plate velocity after an event, and what is noted of it.
    fn after(
        pairs: &str,
        mode: Mode,
        event: EventId,
        state: [f64; 4],
    ) -> (Mode, f64, f64, Vec<EventKind>) {
        look(pairs, mode, event, state, |simulation| {
            let State { slip_m_s, plate_m_s, .. } = simulation.body.state;
            (simulation.body.mode, slip_m_s, plate_m_s, noted(simulation))
        })
    }

    type Transition = (&'static str, Mode, EventId, [f64; 4], Mode, EventKind);

    const PLASTIC: &str = "k=1e7 interface=plastic";

    /// Scene, mode, event and state (q, u, x, w), and the mode and the note after it.
    #[rustfmt::skip]
    const TRANSITIONS: [Transition; 13] = [
        ("k=1e5", Mode::Penetrating, EventId::SlipZero, [5e-3, 0.0, 0.0, 20.0], Mode::Fused, EventKind::FirstArrest),
        ("k=1e5", Mode::Closing, EventId::HoleBottom, [5e-3, 9.0, 0.0, 1.0], Mode::Penetrating, EventKind::Resumption),
        ("k=1e5", Mode::Withdrawing, EventId::PieceStart, [0.0, -9.0, 0.0, 1.0], Mode::FreeFlight, EventKind::Separation),
        ("k=1e5", Mode::FreeFlight, EventId::Recontact, [0.0, 9.0, 0.0, 1.0], Mode::Closing, EventKind::Recontact),
        ("k=1e5", Mode::Penetrating, EventId::PieceEnd, [0.1, 9.0, 0.0, 1.0], Mode::Perforated, EventKind::Perforation),
        (PLASTIC, Mode::Fused, EventId::PushLimit, [5e-3, 0.0, 5e-3, 1.0], Mode::Penetrating, EventKind::Resumption),
        (PLASTIC, Mode::Fused, EventId::PullLimit, [5e-3, 0.0, -5e-3, 1.0], Mode::Withdrawing, EventKind::PullOut),
        ("k=1e7", Mode::Fused, EventId::PushLimit, [5e-3, 0.0, 5e-3, 1.0], Mode::Fused, EventKind::InterfaceExceeded),
        ("model=half-sine", Mode::Penetrating, EventId::SlipZero, [5e-3, 0.0, 0.0, 9.0], Mode::Withdrawing, EventKind::FirstArrest),
        ("model=half-sine", Mode::Withdrawing, EventId::HistoryEnd, [5e-3, -9.0, 0.0, 9.0], Mode::Fused, EventKind::FirstArrest),
        ("model=lumped", Mode::Penetrating, EventId::SlipZero, [5e-3, 0.0, 0.0, 9.0], Mode::Withdrawing, EventKind::FirstArrest),
        ("model=lumped", Mode::Withdrawing, EventId::ContactLost, [4e-3, -9.0, 0.0, 9.0], Mode::FreeFlight, EventKind::Separation),
        ("model=lumped", Mode::FreeFlight, EventId::ContactAgain, [4e-3, 9.0, 0.0, 9.0], Mode::Closing, EventKind::Recontact),
    ];

    #[test]
    fn each_event_leads_to_its_mode_and_is_noted() {
        for (pairs, mode, event, state, expected, noted) in TRANSITIONS {
            let found = after(pairs, mode, event, state);
            assert_eq!((found.0, found.3), (expected, vec![noted]), "{pairs} {mode:?} {event:?}");
        }
    }

    type Change = (&'static str, EventId, [f64; 4], fn(&Body<'_>) -> bool, &'static [EventKind]);

    /// Scene, event and state (q, u, x, w) of joined bodies whose plate starts forward from 0, what holds afterwards, and the
    /// notes.
    #[rustfmt::skip]
    const CHANGES: [Change; 12] = [
        ("k=1e5 n=2", EventId::PlateZero, [5e-3, 0.0, 0.0, -3.0], |body| body.x_zero.side < 0.0, &[]),
        ("k=1e5 n=0.5", EventId::PlateZero, [5e-3, 0.0, 1e-9, -3.0], |body| body.x_zero.omitted, &[]),
        ("k=1e5 n=0.5", EventId::PlateClear, [5e-3, 0.0, -1e-6, -3.0], |body| !body.x_zero.omitted && body.x_zero.side < 0.0, &[]),
        ("k=1e5", EventId::PlateSpeedZero, [5e-3, 0.0, 1e-3, 0.0], |body| body.w_zero.side < 0.0, &[EventKind::GreatestDisplacement]),
        ("k=1e5 b=9 m=0.5", EventId::PlateSpeedZero, [5e-3, 0.0, 1e-3, 1e-9], |body| body.w_zero.omitted, &[EventKind::GreatestDisplacement]),
        ("k=1e5 b=9 m=0.5", EventId::PlateSpeedClear, [5e-3, 0.0, 1e-3, -1e-3], |body| !body.w_zero.omitted && body.w_zero.side < 0.0, &[]),
        ("spring=bistable", EventId::KnotAhead, [5e-3, 0.0, 1e-3, 1.0], |body| body.region == Body::new(body.problem, 1e-9).region + 1, &[]),
        ("spring=bistable", EventId::KnotBehind, [5e-3, 0.0, 1e-3, -1.0], |body| body.region + 1 == Body::new(body.problem, 1e-9).region, &[]),
        (ELASTIC_STOP, EventId::StopReached, [5e-3, 0.0, 1e-3, 2.0], |body| body.stop_touches && !body.rests_on_stop, &[EventKind::StopHit]),
        (ELASTIC_STOP, EventId::StopCleared, [5e-3, 0.0, 1e-3, -2.0], |body| !body.stop_touches, &[]),
        (ELASTIC_STOP, EventId::StopPressed, [5e-3, 0.0, 2e-3, -2.0], |body| body.stop_touches, &[]),
        ("k=1e5 x_stop=0.001 e=0", EventId::StopRelease, [5e-3, 0.0, 1e-3, 0.0], |body| body.released && !body.rests_on_stop, &[EventKind::StopRelease]),
    ];

    const ELASTIC_STOP: &str = "k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e6 b_stop=0";

    #[test]
    fn an_event_of_the_plate_changes_its_law_or_its_side_and_leaves_the_mode() {
        for (pairs, event, state, holds, notes) in CHANGES {
            look(pairs, Mode::Fused, event, state, |simulation| {
                assert!(holds(&simulation.body), "{pairs} {event:?}");
                assert_eq!(simulation.body.mode, Mode::Fused, "{pairs} {event:?}");
                assert_eq!(noted(simulation), notes, "{pairs} {event:?}");
            });
        }
    }

    /// The ends of pieces that are not exits: the nose is in, then its front is at the rear face; a dent that is left changes
    /// nothing.
    #[test]
    fn an_end_of_a_piece_is_noted_by_its_place() {
        let radius_m = 0.00635;
        #[rustfmt::skip]
        let cases: [(&str, Mode, EventId, f64, &[EventKind]); 4] = [
            ("k=1e5 dishing=off", Mode::Penetrating, EventId::PieceEnd, radius_m, &[EventKind::NoseBuried]),
            ("k=1e5 dishing=off", Mode::Penetrating, EventId::PieceEnd, 0.0254, &[EventKind::RearFace]),
            ("k=1e5 dishing=off", Mode::Closing, EventId::PieceEnd, radius_m, &[]),
            ("k=1e5 model=lumped", Mode::FreeFlight, EventId::DentLeft, 4e-3, &[]),
        ];
        for (pairs, mode, event, travel_m, notes) in cases {
            let state = [travel_m, 9.0, 0.0, 1.0];
            let found = after(pairs, mode, event, state);
            assert_eq!((found.0, &*found.3), (mode, notes), "{pairs} {event:?} {travel_m}");
        }
    }

    /// What the spring requires of the interface decides: half of 50 kN against a strength of 15 kN and a grip of 1.5 kN.
    #[test]
    fn a_plastic_interface_yields_at_once_where_the_spring_asks_too_much() {
        for (x, expected) in
            [(5e-3, Mode::Penetrating), (-5e-3, Mode::Withdrawing), (1e-4, Mode::Fused)]
        {
            let state = [5e-3, 0.0, x, 1.0];
            let found =
                after("k=1e7 interface=plastic", Mode::Penetrating, EventId::SlipZero, state);
            assert_eq!(found.0, expected, "{x}");
        }
    }

    #[test]
    fn valid_a_rigid_stop_reverses_the_plate_and_a_collision_conserves_momentum() {
        let hit =
            |pairs: &str, mode| after(pairs, mode, EventId::StopReached, [4e-3, 7.0, 1e-3, 2.0]);
        // Alone the plate comes back with e = 0.5, and the projectile keeps its own velocity.
        let (_, slip, plate, _) = hit("k=1e5 x_stop=0.001 e=0.5", Mode::Penetrating);
        assert!((plate + 1.0).abs() < 1e-15 && (slip - 10.0).abs() < 1e-14, "{plate} {slip}");
        let (_, _, plate, noted) = hit("k=1e5 x_stop=0.001 e=0", Mode::Perforated);
        assert_eq!(plate.to_bits(), 0.0f64.to_bits());
        assert_eq!(noted, [EventKind::StopHit, EventKind::StopRelease]);
        // 1/2 of 100 m/s, for bodies of the same mass.
        let start = [0.0, 100.0, 0.0, 0.0];
        let (mode, slip, plate, _) =
            after("model=initial-velocity", Mode::Penetrating, EventId::HistoryEnd, start);
        assert_eq!((mode, slip.to_bits()), (Mode::Fused, 0));
        assert!((plate - 50.0).abs() < 1e-13);
    }
}
