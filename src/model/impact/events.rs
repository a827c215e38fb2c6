//! What follows an event: the interface law and the stop.
//!
//! One rule serves every mode (model page, section 3). u > 0 at the bottom of the hole: the hole deepens. u > 0 above it:
//! the gap closes against friction g A S. u < 0: the projectile is pulled out against g A S. u = 0: together, as long as
//! the force the interface must carry stays within its limits.

use crate::model::event_function::EventId;
use crate::model::impact::track::{Track, side};
use crate::model::mechanism::sign;
use crate::model::mechanism::stop::{Hit, SLOW};
use crate::model::motion::State;
use crate::model::run::{Arrest, EventKind, Mode};

/// Part of the impact velocity, per tolerance, below which the plate's own is lost among the errors of Taylor steps (their local
/// tolerance of the scale that matters to the depth), and the first step of the implicit method then, relative to the time.
const UNFELT: f64 = 1e-7;
const UNFELT_STEP: f64 = 1e-3;

impl Track<'_> {
    /// Put the state exactly on the event that ended the step.
    pub(super) fn project_onto_event(&mut self, event: EventId, before: &State) {
        let geometry = &self.problem.geometry;
        match event {
            // Past the exit there is no end to come to.
            EventId::PieceEnd => {
                let end = geometry.piece(before.travel_m).to_m;
                self.state.travel_m = if end.is_finite() { end } else { before.travel_m };
            }
            EventId::PieceStart => {
                let behind = geometry.pieces().iter().rev();
                let piece = behind.into_iter().find(|piece| piece.from_m < before.travel_m);
                self.state.travel_m = piece.map_or(0.0, |piece| piece.from_m);
            }
            EventId::HoleBottom => self.state.travel_m = self.deepest_m,
            EventId::SlipZero | EventId::SlipHeld => self.state.slip_m_s = 0.0,
            EventId::Recontact | EventId::DentLeft => {
                self.state.travel_m = self.problem.contact.slack_m(self.deepest_m);
            }
            EventId::PlateZero if self.spring_is_whole() => self.state.plate_m = 0.0,
            EventId::KnotAhead => self.state.plate_m = self.spring_ends().1,
            EventId::KnotBehind => self.state.plate_m = self.spring_ends().0,
            EventId::PlateSpeedZero if !self.damper_is_singular() => self.state.plate_m_s = 0.0,
            EventId::StopReached => self.state.plate_m = self.problem.mechanism.stop_at_m,
            EventId::ContactLost
            | EventId::ContactAgain
            | EventId::HistoryEnd
            | EventId::PlateZero
            | EventId::PlateSpeedZero
            | EventId::PlateClear
            | EventId::PlateSpeedClear
            | EventId::StopCleared
            | EventId::StopPressed
            | EventId::StopRelease
            | EventId::PushLimit
            | EventId::PullLimit => {}
        }
    }

    /// Whether the spring is a whole power, which changes its form exactly at zero.
    fn spring_is_whole(&self) -> bool {
        self.problem.mechanism.spring.power().is_some_and(|law| law.exponent.fract() == 0.0)
    }

    fn damper_is_singular(&self) -> bool {
        use crate::model::mechanism::PowerKind;
        self.problem.mechanism.damper.kind() == PowerKind::General
    }

    /// Decide what follows an event.
    pub(super) fn handle(&mut self, event: EventId) {
        match event {
            EventId::PieceEnd => self.piece_end(),
            EventId::PieceStart => self.piece_start(),
            EventId::HoleBottom => self.deepen(),
            EventId::SlipZero => self.common_velocity(),
            EventId::SlipHeld => {
                self.record.event(self.state.t_s, EventKind::Arrest);
                self.mode = Mode::Fused;
            }
            EventId::Recontact | EventId::ContactAgain => {
                self.record.event(self.state.t_s, EventKind::Recontact);
                self.mode = if self.deepest_m > 0.0 { Mode::Closing } else { Mode::Penetrating };
            }
            EventId::ContactLost => self.separate(),
            EventId::DentLeft => {}
            EventId::HistoryEnd => self.join(),
            EventId::PlateZero => self.plate_zero(),
            EventId::KnotAhead => self.region += 1,
            EventId::KnotBehind => self.region -= 1,
            EventId::PlateSpeedZero => self.plate_speed_zero(),
            EventId::PlateClear => {
                self.spring_omitted = false;
                self.side_x = side(self.state.plate_m, self.side_x);
            }
            EventId::PlateSpeedClear => {
                self.damper_omitted = false;
                self.side_w = side(self.state.plate_m_s, self.side_w);
            }
            EventId::StopReached => self.hit_stop(),
            EventId::StopCleared => self.stop_touches = false,
            // Behind its place there is nothing to press on.
            EventId::StopPressed => {
                self.stop_touches = self.state.plate_m > self.problem.mechanism.stop_at_m;
            }
            EventId::StopRelease => self.release(),
            EventId::PushLimit => self.push_limit(),
            EventId::PullLimit => self.pull_limit(),
        }
        if self.held && self.net_push_on_stop() < 0.0 {
            self.release();
        }
    }

    fn piece_end(&mut self) {
        let geometry = &self.problem.geometry;
        let q = self.state.travel_m;
        if q >= geometry.exit_m {
            let velocity = self.state.slip_m_s + self.state.plate_m_s * self.problem.cos;
            self.record.exit = Some((self.state.t_s, velocity));
            self.record.event(self.state.t_s, EventKind::Perforation);
            self.mode = Mode::Perforated;
        } else if self.mode == Mode::Penetrating {
            let depth = geometry.depth_m(q);
            let close = |other: f64| (depth - other).abs() < 1e-9 * depth;
            if close(geometry.thickness_m) {
                self.record.event(self.state.t_s, EventKind::RearFace);
            } else if depth > 0.99 * geometry.nose.full_from_m()
                && depth < 1.01 * geometry.nose.full_from_m()
            {
                self.record.event(self.state.t_s, EventKind::NoseBuried);
            }
        }
    }

    fn piece_start(&mut self) {
        if self.state.travel_m <= 0.0 {
            self.state.travel_m = 0.0;
            self.separate();
        }
    }

    fn separate(&mut self) {
        self.mode = Mode::FreeFlight;
        let velocity = self.state.slip_m_s + self.state.plate_m_s * self.problem.cos;
        self.record.separation = Some((self.state.t_s, velocity));
        self.record.event(self.state.t_s, EventKind::Separation);
    }

    /// Makes the bodies one, with the momentum they have. The energy that this takes is the contact's.
    fn join(&mut self) {
        let problem = self.problem;
        let State { slip_m_s: u, plate_m_s: w, .. } = self.state;
        let v = u + w * problem.cos;
        let energy_j = 0.5 * (problem.projectile_kg * v * v + problem.plate_kg * w * w);
        let momentum = problem.projectile_kg * v * problem.cos + problem.plate_kg * w;
        let joined = if self.is_still() { 0.0 } else { momentum / problem.joined_kg };
        (self.state.slip_m_s, self.state.plate_m_s) = (0.0, joined);
        self.record.work.penetration_j += energy_j - 0.5 * problem.joined_kg * joined * joined;
        self.note_arrest();
        self.mode = Mode::Fused;
        self.point();
    }

    fn common_velocity(&mut self) {
        if self.mode == Mode::Withdrawing && !self.problem.flows() {
            self.mode = self.problem.contact.turned_forward();
            return;
        }
        self.note_arrest();
        self.settle();
    }

    /// Notes common velocity; the collision that takes no time has no depth then.
    fn note_arrest(&mut self) {
        let first = self.record.first_arrest.is_none();
        if first && self.problem.contact.hole_m(self.deepest_m).is_some() {
            self.record.first_arrest = Some(Arrest {
                t_s: self.state.t_s,
                penetration_m: self.problem.geometry.depth_m(self.state.travel_m),
                plate_displacement_m: self.state.plate_m,
                plate_velocity_m_s: self.state.plate_m_s,
            });
        }
        self.record
            .event(self.state.t_s, if first { EventKind::FirstArrest } else { EventKind::Arrest });
    }

    /// Common velocity: together, or on to what the contact model says.
    fn settle(&mut self) {
        self.state.slip_m_s = 0.0;
        if self.mode != Mode::Fused {
            self.mode = self.problem.contact.at_common_velocity();
        }
        if self.mode == Mode::Fused && !self.gives_way() && self.problem.plastic && !self.is_still()
        {
            self.count_slips();
            self.take_last_slips();
        }
    }

    /// Whether the interface of the joined body gives way at once, which it then does.
    fn gives_way(&mut self) -> bool {
        let motion = self.motion();
        let carried = if self.is_still() {
            0.0
        } else {
            self.problem.share * motion.mechanism_force(&self.state)
        };
        let (push, pull) = self.interface_limits_n();
        if self.problem.plastic && carried > push {
            self.resume();
        } else if self.problem.plastic && carried < -pull {
            self.pull_out();
        } else {
            self.note_excess(carried, push, pull);
        }
        self.mode != Mode::Fused
    }

    /// Count how often the interface gave way without a noticeably deeper hole.
    fn count_slips(&mut self) {
        let noticeable = self.problem.scene.run.tolerance * self.deepest_m;
        if self.deepest_m > self.noticed_m + noticeable {
            self.noticed_m = self.deepest_m;
            self.slips_since_deeper = 0;
        } else {
            self.slips_since_deeper += 1;
        }
    }

    /// What the interface can push and pull at the present travel, N.
    pub(super) fn interface_limits_n(&self) -> (f64, f64) {
        let strength = self.interface_n();
        let pull = self.problem.grip * strength;
        let at_bottom = self.state.travel_m >= self.deepest_m;
        (if at_bottom { strength } else { pull }, pull)
    }

    /// Fused law: note when the limits are passed already on arrival.
    fn note_excess(&mut self, carried_n: f64, push_n: f64, pull_n: f64) {
        if self.problem.plastic || push_n == 0.0 {
            return;
        }
        if carried_n > push_n {
            self.note_push();
        }
        if carried_n < -pull_n {
            self.note_pull();
        }
    }

    fn note_push(&mut self) {
        if self.record.push_exceeded_s.is_none() {
            self.record.push_exceeded_s = Some(self.state.t_s);
            self.record.event(self.state.t_s, EventKind::InterfaceExceeded);
        }
    }

    fn note_pull(&mut self) {
        if self.record.pull_exceeded_s.is_none() {
            self.record.pull_exceeded_s = Some(self.state.t_s);
            self.record.event(self.state.t_s, EventKind::InterfaceExceeded);
        }
    }

    fn push_limit(&mut self) {
        if self.problem.plastic { self.resume() } else { self.note_push() }
    }

    fn pull_limit(&mut self) {
        if self.problem.plastic { self.pull_out() } else { self.note_pull() }
    }

    /// The interface gives way forwards.
    fn resume(&mut self) {
        if self.state.travel_m >= self.deepest_m {
            self.deepen();
        } else {
            self.mode = Mode::Closing;
        }
    }

    /// The bottom of the hole is reached with speed to spare.
    fn deepen(&mut self) {
        self.mode = Mode::Penetrating;
        self.record.resumed_s.get_or_insert(self.state.t_s);
        self.record.event(self.state.t_s, EventKind::Resumption);
    }

    fn pull_out(&mut self) {
        self.mode = Mode::Withdrawing;
        self.record.event(self.state.t_s, EventKind::PullOut);
    }

    /// Whether the plate moves so slowly during the contact that nothing else feels it.
    pub(super) fn is_unfelt(&self) -> bool {
        self.is_sliding()
            && self.state.plate_m_s.abs() <= UNFELT * self.tolerance * self.problem.velocity_m_s
    }

    fn plate_zero(&mut self) {
        if self.spring_is_whole() {
            self.side_x = -self.side_x;
        } else if self.is_unfelt() {
            // Below what Taylor steps resolve: the implicit method follows the spring's force instead.
            (self.stiff, self.creeps) = (true, true);
            self.unit_s = UNFELT_STEP * self.state.t_s;
        } else {
            self.omit_spring();
        }
    }

    fn plate_speed_zero(&mut self) {
        if self.damper_is_singular() && !self.stiff {
            self.note_greatest_displacement();
            self.omit_damper();
        } else {
            self.turned_round();
        }
    }

    /// The plate's velocity has changed its sign.
    pub(super) fn turned_round(&mut self) {
        self.note_greatest_displacement();
        self.side_w = -self.side_w;
    }

    fn note_greatest_displacement(&mut self) {
        if self.side_w > 0.0 && self.state.plate_m >= self.record.farthest_m {
            self.record.event(self.state.t_s, EventKind::GreatestDisplacement);
        }
    }

    /// The displacements at the stop that matter, m.
    pub(super) fn stop_scale_m(&self) -> f64 {
        self.problem.mechanism.stop_at_m.abs() + self.plate_scale_m
    }

    /// The plate meets its stop.
    fn hit_stop(&mut self) {
        self.record.reach(&self.state);
        let Some(stop) = self.problem.mechanism.rigid_stop() else {
            self.record.event(self.state.t_s, EventKind::StopHit);
            self.stop_touches = true;
            // Its damper pushes at once: no guard falls where the force jumps.
            if self.mode == Mode::Fused {
                self.gives_way();
            }
            return;
        };
        let joined = self.mode == Mode::Fused && !self.problem.plastic;
        let mass = if joined { self.problem.joined_kg } else { self.problem.plate_kg };
        let before = self.state.plate_m_s;
        let (_, rate) = self.motion().accelerations(&self.state);
        let after = stop.rebound(&Hit {
            velocity: before,
            acceleration: rate,
            velocity_scale: self.problem.velocity_m_s + self.speed_scale_m_s,
            length_scale: self.stop_scale_m(),
        });
        if before > SLOW * self.problem.velocity_m_s {
            self.record.event(self.state.t_s, EventKind::StopHit);
        }
        self.record.work.stop_j += 0.5 * mass * (before - after) * (before + after);
        self.state.plate_m_s = after;
        self.side_w = -1.0;
        if !joined {
            self.state.slip_m_s += (before - after) * self.problem.cos;
            self.slip_has_jumped();
        }
        if after < 0.0 {
            self.shorten_unit(after.abs() / rate.abs());
        }
        if after == 0.0 {
            self.held = true;
            if self.mode == Mode::Fused {
                self.settle();
            }
            if self.net_push_on_stop() >= 0.0 {
                self.record.event(self.state.t_s, EventKind::StopHold);
            }
        }
    }

    /// The stop has changed the plate's velocity, not the projectile's.
    fn slip_has_jumped(&mut self) {
        match self.mode {
            Mode::Fused if self.state.slip_m_s > 0.0 => self.resume(),
            Mode::Withdrawing if self.state.slip_m_s > 0.0 => {
                self.mode = self.problem.contact.turned_forward();
            }
            Mode::Withdrawing if self.state.slip_m_s == 0.0 => self.settle(),
            Mode::Fused
            | Mode::Withdrawing
            | Mode::Penetrating
            | Mode::Closing
            | Mode::FreeFlight
            | Mode::Perforated => {}
        }
    }

    /// What presses a plate at rest on its stop, N.
    pub(super) fn net_push_on_stop(&self) -> f64 {
        let motion = self.motion();
        let contact = motion.contact_force(&self.state) * self.problem.cos;
        contact - self.problem.mechanism.spring.force(self.state.plate_m)
    }

    /// The net push on a plate held by its rigid stop has become negative: it is free until it comes back with speed.
    fn release(&mut self) {
        (self.held, self.released) = (false, true);
        self.side_w = -1.0;
        self.side_x = side(self.state.plate_m, -1.0);
        self.record.event(self.state.t_s, EventKind::StopRelease);
        if self.mode == Mode::Fused {
            self.settle();
        }
    }

    /// Whether nothing will ever move again: joined, at rest, and no force.
    pub(super) fn is_at_rest(&self) -> bool {
        self.mode == Mode::Fused
            && (self.is_still()
                || (self.state.plate_m_s == 0.0
                    && sign(self.motion().mechanism_force(&self.state)) == 0.0))
    }
}
