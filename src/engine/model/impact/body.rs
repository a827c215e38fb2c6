//! The present state of projectile and plate: state and mode, the equations that hold, and what follows from both.

use crate::model::contact_models::Hole;
use crate::model::event_function::EventId;
use crate::model::impact::problem::Problem;
use crate::model::mechanism::{Elastic, PowerLaw, sign};
use crate::model::motion::{ElasticForce, Motion, State};
use crate::model::run::Mode;

mod active_events;
mod energy;
mod missed_event;
mod omission;
mod outcome;
mod rebound;

pub(super) use active_events::Noted;
pub(super) use energy::NO_ENERGY;
pub(super) use outcome::MaximumDisplacement;

/// Local tolerance per global tolerance: a run has some tens of steps, whose errors may grow a little.
const LOCAL_TOLERANCE: f64 = 1e-4;
/// Part of the impact velocity, per tolerance, below which the plate's own is lost among the errors of Taylor steps: their local
/// tolerance of the scale that matters to the depth.
const UNRESOLVED_SPEED: f64 = 1e-7;

/// Part of the displacements seen by which rounding puts a plate beyond an event at most.
const PROJECTED: f64 = 1e-9;

/// The law of a spring or a damper close to the zero of its argument, displacement or velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NearZero {
    /// The side of zero on which the argument is, or to which it is going: 1 or -1.
    pub(super) side: f64,
    /// The law is singular there, and omitted.
    pub(super) omitted: bool,
    /// How far from zero it is restored, fixed when it is omitted, m or m/s.
    pub(super) clear: f64,
}

impl NearZero {
    fn on_side_of(z: f64) -> Self {
        Self { side: if z < 0.0 { -1.0 } else { 1.0 }, omitted: false, clear: 0.0 }
    }

    /// Restores the law on the side of its argument.
    pub(super) fn restore(&mut self, z: f64) {
        (self.side, self.omitted) = (side(z, self.side), false);
    }

    /// Takes the side of an argument that is resolved, and restores the law once the argument is clear of zero.
    fn leave(&mut self, z: f64, resolved: f64) {
        let is_clear = self.omitted && z.abs() > self.clear;
        if z.abs() > resolved || is_clear {
            self.side = sign(z);
        }
        self.omitted &= !is_clear;
    }
}

/// Projectile and plate.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "facts that hold or do not, each by itself")]
pub(super) struct Body<'a> {
    pub(super) problem: &'a Problem,
    pub(super) tolerance: f64,
    pub(super) state: State,
    pub(super) mode: Mode,
    /// Greatest travel so far: the bottom of the hole, m.
    pub(super) deepest_m: f64,
    pub(super) rests_on_stop: bool,
    /// The rigid stop has released the plate at this moment: no rounding of the forces brings it back.
    pub(super) released: bool,
    /// The mechanism cannot move the plate noticeably: it stays where it is.
    pub(super) fixed: bool,
    /// The plate, on which only its mechanism acts, has come to rest.
    pub(super) at_rest: bool,
    pub(super) stop_touches: bool,
    /// The spring near x = 0, and the damper near w = 0.
    pub(super) x_zero: NearZero,
    pub(super) w_zero: NearZero,
    /// Rounding of the displacement by the last step, m.
    pub(super) compensation_m: f64,
    /// The stretch of the spring's curve in which the plate is; without meaning for a power law.
    pub(super) region: usize,
    /// Greatest |x| and |w| so far, m and m/s.
    pub(super) plate_scale_m: f64,
    pub(super) speed_scale_m_s: f64,
    /// Times the interface has yielded since the hole last became noticeably deeper.
    pub(super) yields_since_deeper: usize,
    /// Depth of the hole when it last did, as travel, m.
    counted_depth_m: f64,
}

impl<'a> Body<'a> {
    /// At the moment of first contact.
    pub(super) fn new(problem: &'a Problem, tolerance: f64) -> Self {
        let state = State {
            t_s: 0.0,
            travel_m: 0.0,
            slip_m_s: problem.velocity_m_s,
            plate_m: problem.start_m,
            plate_m_s: 0.0,
        };
        let (spring, x) = (&problem.mechanism.spring, problem.start_m);
        let pull = -spring.force(x);
        let mut body = Self {
            problem,
            state,
            tolerance,
            deepest_m: 0.0,
            mode: Mode::Penetrating,
            rests_on_stop: problem.mechanism.rigid_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m
                && pull >= 0.0,
            released: false,
            fixed: false,
            at_rest: false,
            stop_touches: problem.mechanism.elastic_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m,
            x_zero: NearZero::on_side_of(problem.start_m),
            w_zero: NearZero::on_side_of(pull),
            compensation_m: 0.0,
            region: spring.curve().map_or(0, |curve| curve.region(x)),
            plate_scale_m: problem.start_m.abs(),
            speed_scale_m_s: 0.0,
            yields_since_deeper: 0,
            counted_depth_m: 0.0,
        };
        if let Some(curve) = spring.curve()
            && !problem.rigid
        {
            let way = body.way();
            body.w_zero = NearZero::on_side_of(way);
            if way < 0.0 {
                // The stretch into which the plate starts to move.
                body.region = curve.region_below(x);
            }
        }
        body
    }

    /// Whether the plate cannot move: rigid, at rest on its stop, or fixed by its mechanism.
    pub(super) fn is_still(&self) -> bool {
        self.problem.rigid || self.rests_on_stop || self.fixed || self.at_rest
    }

    /// Whether projectile and plate slide against each other.
    pub(super) fn is_sliding(&self) -> bool {
        matches!(self.mode, Mode::Penetrating | Mode::Closing | Mode::Withdrawing)
    }

    pub(super) fn motion(&self) -> Motion<'a> {
        let problem = self.problem;
        let mechanism = &problem.mechanism;
        let still = self.is_still();
        let joined = self.mode == Mode::Fused;
        let stop = mechanism.elastic_stop().filter(|_| self.stop_touches);
        let plate_kg = if joined { problem.joined_kg } else { problem.plate_kg };
        Motion {
            contact: problem.contact.force(self.mode, &self.hole()),
            slip_mobility: problem.slip_mobility(!still),
            plate_mobility: if still { 0.0 } else { 1.0 / plate_kg },
            coupling: if joined { 0.0 } else { problem.cos },
            spring: match mechanism.spring.curve() {
                Some(curve) if !still => Elastic::Piece(curve.piece(self.region)),
                _ => Elastic::Power(self.spring().only_if(!(self.x_zero.omitted || still))),
            },
            damper: mechanism.damper.only_if(!(self.w_zero.omitted || still)),
            stop: stop.map_or_else(ElasticForce::default, |stop| ElasticForce {
                stiffness_n_m: stop.stiffness_n_m,
                damping_n_s_m: stop.damping_n_s_m,
                slack_m: mechanism.stop_at_m,
            }),
            side_x: self.x_zero.side,
            side_w: self.w_zero.side,
        }
    }

    pub(super) fn hole(&self) -> Hole<'_> {
        Hole {
            geometry: &self.problem.geometry,
            state: self.state,
            deepest_m: self.deepest_m,
            still: self.is_still(),
        }
    }

    /// The spring as a power law; none where it is a curve.
    pub(super) fn spring(&self) -> PowerLaw {
        self.problem.mechanism.spring.power().unwrap_or(PowerLaw::NONE)
    }

    /// The ends of the present stretch of the spring's curve, m; infinite for a power law.
    pub(super) fn spring_ends(&self) -> (f64, f64) {
        let curve = self.problem.mechanism.spring.curve();
        curve.map_or((f64::NEG_INFINITY, f64::INFINITY), |curve| curve.ends(self.region))
    }

    /// Whether the spring is a whole power, which changes its form exactly at zero.
    pub(super) fn spring_is_whole(&self) -> bool {
        self.problem.mechanism.spring.power().is_some_and(|law| law.exponent.fract() == 0.0)
    }

    /// The compressive strength of the interface at the present travel, N.
    pub(super) fn interface_n(&self) -> f64 {
        self.problem.geometry.area_m2(self.state.travel_m) * self.problem.strength_pa
    }

    /// The compressive and tensile strength of the interface at the present travel, N.
    pub(super) fn interface_limits_n(&self) -> (f64, f64) {
        let strength = self.interface_n();
        let pull = self.problem.grip * strength;
        let at_bottom = self.state.travel_m >= self.deepest_m;
        (if at_bottom { strength } else { pull }, pull)
    }

    /// The force that presses a plate at rest on its stop, N.
    pub(super) fn net_push_on_stop(&self) -> f64 {
        let motion = self.motion();
        let contact = motion.contact_force(&self.state) * self.problem.cos;
        contact - self.problem.mechanism.spring.force(self.state.plate_m)
    }

    /// Whether nothing will ever move again: joined, at rest, and no force.
    pub(super) fn is_at_rest(&self) -> bool {
        self.mode == Mode::Fused
            && (self.is_still()
                || (self.state.plate_m_s == 0.0
                    && sign(self.motion().mechanism_force(&self.state)) == 0.0))
    }

    /// The displacements at the stop that matter, m.
    pub(super) fn stop_scale_m(&self) -> f64 {
        self.problem.mechanism.stop_at_m.abs() + self.plate_scale_m
    }

    /// Whether the plate moves so slowly during the contact that it matters to nothing else.
    pub(super) fn plate_is_unresolved(&self) -> bool {
        self.is_sliding()
            && self.state.plate_m_s.abs()
                <= UNRESOLVED_SPEED * self.tolerance * self.problem.velocity_m_s
    }

    /// Part of the travel, and of the impact velocity, below which the plate's errors do not matter to the depth.
    pub(super) fn resolved_part(&self) -> f64 {
        if self.is_sliding() { 1e-3 } else { 0.0 }
    }

    /// Error that a step may make, relative to the scales.
    pub(super) fn local_tolerance(&self) -> f64 {
        self.tolerance * LOCAL_TOLERANCE
    }

    pub(super) fn project_onto_event(&mut self, event: EventId, before: &State) {
        let geometry = &self.problem.geometry;
        match event {
            // Past the exit there is no end to come to.
            EventId::PieceEnd => {
                let end = geometry.piece(before.travel_m).to_m;
                self.state.travel_m = if end.is_finite() { end } else { before.travel_m };
            }
            EventId::PieceStart => {
                self.state.travel_m =
                    geometry.piece_behind(before.travel_m).map_or(0.0, |piece| piece.from_m);
            }
            EventId::HoleBottom => self.state.travel_m = self.deepest_m,
            EventId::SlipZero => self.state.slip_m_s = 0.0,
            EventId::Recontact | EventId::DentLeft => {
                self.state.travel_m = self.problem.contact.slack_m(self.deepest_m);
            }
            EventId::PlateZero if self.spring_is_whole() => self.state.plate_m = 0.0,
            EventId::KnotAhead => self.state.plate_m = self.spring_ends().1,
            EventId::KnotBehind => self.state.plate_m = self.spring_ends().0,
            EventId::PlateSpeedZero if !self.problem.mechanism.damper.is_singular() => {
                self.state.plate_m_s = 0.0;
            }
            EventId::StopReached => self.state.plate_m = self.problem.mechanism.stop_at_m,
            _ => {}
        }
    }

    /// Puts the state on a missed event, unless that would move the plate by more than rounding.
    pub(super) fn project_within_rounding(&mut self, event: EventId) {
        let before = self.state;
        self.project_onto_event(event, &before);
        if (self.state.plate_m - before.plate_m).abs() > PROJECTED * self.plate_scale_m {
            self.state.plate_m = before.plate_m;
        }
    }

    /// Count how often the interface yielded without a noticeably deeper hole.
    pub(super) fn count_yields(&mut self) {
        let noticeable = self.problem.scene.run.tolerance * self.deepest_m;
        if self.deepest_m > self.counted_depth_m + noticeable {
            self.counted_depth_m = self.deepest_m;
            self.yields_since_deeper = 0;
        } else {
            self.yields_since_deeper += 1;
        }
    }
}

/// The side of zero of a number, or `other` for zero itself.
pub(super) fn side(z: f64, other: f64) -> f64 {
    if z == 0.0 { other } else { sign(z) }
}

#[cfg(test)]
mod tests;
