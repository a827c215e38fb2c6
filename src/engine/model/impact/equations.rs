//! Equations of motion: forces in a mode, accelerations and their derivatives.
//!
//! Travel q and relative velocity u are measured along the projectile's axis, displacement x and velocity w along the plate's normal. With
//! contact force F and the mechanism's force G, `m_p v' = -F` and `m_2 w' = F cos - G`, where u = v - w cos.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::modes::{Contact, HybridMode, PlateConstraint};
use crate::model::impact::parameters::{ImpactParameters, Masses, StopParameters};
use crate::model::impact::resolution::ROUNDING;
use crate::model::impact::state::State;
use crate::numerics::step::{Jacobian, Point};
use crate::numerics::{larger, smaller};

/// Equations of motion in a mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Equations<'a> {
    pub(super) setup: &'a ImpactParameters,
    pub(super) mode: &'a HybridMode,
}

impl Equations<'_> {
    /// Returns the displacement from the zero of the spring, m.
    pub(super) fn displacement_m(&self, x_m: f64) -> f64 {
        self.mode.origin_m + x_m
    }

    /// Returns the displacement as results have it, m: a step that ends at a rigid stop can exceed it by a rounding error.
    pub(super) fn shown_displacement_m(&self, x_m: f64) -> f64 {
        smaller(self.displacement_m(x_m), self.setup.rigid_stop_m())
    }

    /// Returns the ends of the present piece of the spring's law, from the origin of the mode, m.
    pub(super) fn knots_m(&self) -> (f64, f64) {
        let (below, above) = self.mode.spring.ends(self.mode.stretch);
        (below - self.mode.origin_m, above - self.mode.origin_m)
    }

    /// Returns the displacement beyond the stop, m.
    pub(super) fn beyond_stop_m(&self, x_m: f64) -> f64 {
        x_m - (self.setup.stop.position_m - self.mode.origin_m)
    }

    /// Returns strength and drag coefficient of the contact in the present direction.
    fn pressure(&self) -> (f64, f64) {
        let ImpactParameters { strength_pa, drag_kg_m3, interface, .. } = *self.setup;
        match self.mode.contact {
            Contact::Penetrating => (strength_pa, drag_kg_m3),
            Contact::Closing => (interface.grip * strength_pa, 0.0),
            _ => (-interface.grip * strength_pa, 0.0),
        }
    }

    /// Returns the contact force along the axis of the projectile, positive if repulsive, N; 0 for fused bodies.
    #[inline]
    pub(super) fn contact_n(&self, state: &State) -> f64 {
        if !self.is_touching() {
            return 0.0;
        }
        let State { t_s, q_m, u_m_s, .. } = *state;
        match self.setup.law {
            ContactLaw::Flow => {
                let (strength, drag) = self.pressure();
                let area = self.mode.piece.law.area_m2(&self.setup.geometry.nose, q_m);
                area * (strength + drag * u_m_s * u_m_s)
            }
            ContactLaw::History(history) => history.force_n(t_s),
            ContactLaw::Lumped(lumped) => {
                lumped.force_n(self.is_loading(), self.mode.deepest_m, (q_m, u_m_s))
            }
            ContactLaw::AtOnce => 0.0,
        }
    }

    /// Returns `true` if the bodies are in contact and not fused.
    pub(super) fn is_touching(&self) -> bool {
        !matches!(self.mode.contact, Contact::FreeFlight | Contact::Perforated | Contact::Fused)
    }

    /// Returns `true` if the hole gets deeper.
    pub(super) fn is_loading(&self) -> bool {
        self.mode.contact == Contact::Penetrating
    }

    /// Returns `true` if a projectile that penetrates can lose its relative velocity here. Strength takes it, and so does a plate that
    /// accelerates away from the projectile; the drag alone vanishes with the velocity, and takes none of it in finite time.
    pub(super) fn can_arrest(&self, state: &State) -> bool {
        if self.setup.law != ContactLaw::Flow || self.setup.strength_pa > 0.0 {
            return true;
        }
        let at_rest = State { u_m_s: 0.0, ..*state };
        let off_m_s2 = self.setup.cos * self.acceleration_error_m_s2(&at_rest);
        self.accelerations(&at_rest).0 < -off_m_s2
    }

    /// Returns the derivatives of the contact force by travel and relative velocity.
    pub(super) fn contact_slopes(&self, q_m: f64, u_m_s: f64) -> (f64, f64) {
        match self.setup.law {
            ContactLaw::Flow if self.is_touching() => {}
            ContactLaw::Lumped(lumped) if self.is_touching() => {
                return lumped.slopes(self.is_loading());
            }
            _ => return (0.0, 0.0),
        }
        let (strength, drag) = self.pressure();
        let (nose, law) = (&self.setup.geometry.nose, self.mode.piece.law);
        let area = law.area_m2(nose, q_m);
        let slope = law.slope_m(nose, q_m);
        (slope * (strength + drag * u_m_s * u_m_s), 2.0 * area * drag * u_m_s)
    }

    /// Returns the time derivative of the contact force, N/s, except for a prescribed history.
    pub(super) fn contact_rate_n_s(&self, state: &State) -> f64 {
        let (by_travel, by_slip) = self.contact_slopes(state.q_m, state.u_m_s);
        by_travel * state.u_m_s + by_slip * self.accelerations(state).0
    }

    /// Returns the force of spring, damper and elastic stop, positive against forward motion, N.
    pub(super) fn mechanism_n(&self, x_m: f64, w_m_s: f64) -> f64 {
        let mode = self.mode;
        mode.spring.force_in(mode.stretch, self.displacement_m(x_m))
            + self.damper_n(w_m_s)
            + self.pressed_stop_n(x_m, w_m_s)
    }

    /// Returns the force of the elastic stop, N; 0 if it is not in contact.
    pub(super) fn pressed_stop_n(&self, x_m: f64, w_m_s: f64) -> f64 {
        if self.mode.is_pressed { self.stop_n(x_m, w_m_s) } else { 0.0 }
    }

    /// Returns the force of the elastic stop as if it could also pull, N.
    pub(super) fn stop_n(&self, x_m: f64, w_m_s: f64) -> f64 {
        let StopParameters { stiffness_n_m, damping_n_s_m, .. } = self.setup.stop;
        stiffness_n_m * self.beyond_stop_m(x_m) + damping_n_s_m * w_m_s
    }

    /// Returns the derivatives of the mechanism's force by displacement and velocity. An infinite derivative is replaced by that at a
    /// distance of a rounding error.
    pub(super) fn mechanism_slopes(&self, x_m: f64, w_m_s: f64) -> (f64, f64) {
        let StopParameters { stiffness_n_m, damping_n_s_m, .. } = self.setup.stop;
        let (k, b) = if self.mode.is_pressed { (stiffness_n_m, damping_n_s_m) } else { (0.0, 0.0) };
        let (x_m, w_m_s) = (self.displacement_m(x_m), w_m_s);
        let ([_, x_least_m], [_, w_least_m_s]) = self.least_sizes();
        let x_least_m = f64::EPSILON * larger(x_least_m, self.mode.origin_m.abs());
        let x_m = larger(x_m.abs(), x_least_m).copysign(x_m);
        let w_m_s = larger(w_m_s.abs(), f64::EPSILON * w_least_m_s);
        let by_speed = self.damper_slope_n_s_m(w_m_s);
        (self.mode.spring.tangent_in(self.mode.stretch, x_m) + k, by_speed + b)
    }

    /// Returns the force on the mount, N: that of the mechanism without the geared inertia, or for a fixed plate the reaction force.
    pub(super) fn mount_n(&self, state: &State) -> f64 {
        match self.mode.hold {
            PlateConstraint::Mount => 0.0,
            PlateConstraint::OnStop | PlateConstraint::Spring => {
                self.contact_n(state) * self.setup.cos + self.joined_weight_n()
            }
            PlateConstraint::Free => {
                let turning_kg = self.setup.mass.turning_kg;
                let turns = turning_kg > 0.0;
                let turning_n = if turns { turning_kg * self.accelerations(state).1 } else { 0.0 };
                self.mechanism_n(state.x_m, state.w_m_s) + turning_n
            }
        }
    }

    /// Returns the mass that moves with the plate, kg: with the projectile if fused.
    pub(super) fn moving_kg(&self) -> f64 {
        if self.mode.contact == Contact::Fused {
            self.setup.mass.joined_kg
        } else {
            self.setup.mass.plate_kg
        }
    }

    /// Returns `true` if the plate is fixed.
    pub(super) fn plate_rests(&self) -> bool {
        self.mode.hold != PlateConstraint::Free
    }

    /// Returns the accelerations of relative displacement and plate.
    pub(super) fn accelerations(&self, state: &State) -> (f64, f64) {
        let mechanism_n = || self.mechanism_n(state.x_m, state.w_m_s);
        self.with_weight(self.moved_by(self.contact_n(state), mechanism_n))
    }

    /// Returns the accelerations caused by forces of the contact and of the mechanism.
    fn moved_by(&self, contact_n: f64, mechanism_n: impl Fn() -> f64) -> (f64, f64) {
        let ImpactParameters { mass: Masses { projectile_kg, .. }, cos, .. } = *self.setup;
        let plate = if self.plate_rests() {
            0.0
        } else {
            (contact_n * cos - mechanism_n()) / self.moving_kg()
        };
        let slip = match self.mode.contact {
            Contact::Fused => 0.0,
            _ => -contact_n / projectile_kg - plate * cos,
        };
        (slip, plate)
    }

    /// Returns the Jacobian: derivatives of the accelerations by travel and displacement, and by relative velocity and velocity of the
    /// plate.
    #[inline]
    pub(super) fn slopes(&self, state: &State) -> Jacobian<2> {
        let setup = self.setup;
        let contact = self.contact_slopes(state.q_m, state.u_m_s);
        let (mechanism, plate) = if self.plate_rests() {
            ((0.0, 0.0), 0.0)
        } else {
            (self.mechanism_slopes(state.x_m, state.w_m_s), 1.0 / self.moving_kg())
        };
        let slip = 1.0 / setup.mass.projectile_kg + setup.cos * setup.cos * plate;
        let slip_by_plate = if self.mode.contact == Contact::Fused { 0.0 } else { setup.cos };
        let rows = |contact: f64, mechanism: f64| {
            [
                [-contact * slip, mechanism * slip_by_plate * plate],
                [contact * setup.cos * plate, -mechanism * plate],
            ]
        };
        Jacobian { place: rows(contact.0, mechanism.0), speed: rows(contact.1, mechanism.1) }
    }

    /// Returns the rounding errors of the accelerations, which are large if forces cancel.
    pub(super) fn rounding(&self, state: &State) -> (f64, f64) {
        let mechanism_n = || -self.mechanism_rounding_n(state.x_m, state.w_m_s);
        let (slip, plate) = self.moved_by(self.contact_rounding_n(state), mechanism_n);
        (slip.abs(), plate)
    }

    /// Returns the rounding error of the contact force, N.
    fn contact_rounding_n(&self, state: &State) -> f64 {
        match self.setup.law {
            // The spring is compressed by the difference of travel and dent.
            ContactLaw::Lumped(_) if self.is_touching() => {
                let (by_travel, by_slip) = self.contact_slopes(state.q_m, state.u_m_s);
                f64::EPSILON * (by_travel * state.q_m.abs() + by_slip * state.u_m_s.abs())
            }
            _ => ROUNDING * self.contact_n(state).abs(),
        }
    }

    /// Returns the force that presses a resting plate on its stop, N: the mechanism's force at rest plus the contact force.
    pub(super) fn push_on_stop_n(&self, state: &State) -> f64 {
        let spring = self.mode.spring.force(self.displacement_m(state.x_m));
        self.contact_n(state) * self.setup.cos + self.joined_weight_n() - spring
    }

    /// Returns the negligible displacement of the plate, m, as [`unresolved_m_s`](Self::unresolved_m_s).
    pub(super) fn unresolved_m(&self) -> f64 {
        ROUNDING * self.least_sizes().0[1]
    }

    /// Returns the negligible velocity of the plate, m/s: its smallest error at the smallest tolerance.
    pub(super) fn unresolved_m_s(&self) -> f64 {
        ROUNDING * self.least_sizes().1[1]
    }

    /// Returns the smallest error scales: 1e-3 of the reference length and velocity, and those of the plate.
    fn least_sizes(&self) -> Point<2> {
        let (r, v) = (self.setup.reference.length_m, self.setup.reference.velocity_m_s);
        let [x_m, w_m_s] = self.mode.least;
        ([1e-3 * r, x_m], [1e-3 * v, w_m_s])
    }

    /// Returns the error scales at a state.
    pub(super) fn error_scales(&self, state: &State) -> Point<2> {
        let ([q_m, x_m], [u_m_s, w_m_s]) = self.least_sizes();
        let places = [larger(state.q_m.abs(), q_m), larger(state.x_m.abs(), x_m)];
        (places, [larger(state.u_m_s.abs(), u_m_s), larger(state.w_m_s.abs(), w_m_s)])
    }

    /// Returns the rounding error of the mechanism's forces, N: cancelling forces, and a distant origin of the displacement.
    pub(super) fn mechanism_rounding_n(&self, x_m: f64, w_m_s: f64) -> f64 {
        let (mode, at_m) = (self.mode, self.displacement_m(x_m));
        let spring_n = mode.spring.terms_in_n(mode.stretch, at_m);
        let others_n = self.damper_n(w_m_s).abs() + self.pressed_stop_n(x_m, w_m_s).abs();
        let by_place_n = if mode.origin_m == 0.0 {
            0.0
        } else {
            // The stiffness is infinite at a singular zero.
            let slope_n_m = mode.spring.tangent_in(mode.stretch, at_m).abs();
            let most_n = mode.spring.force(mode.origin_m).abs() + spring_n;
            smaller(slope_n_m * mode.origin_m.abs(), most_n)
        };
        ROUNDING * (spring_n + by_place_n + others_n + self.setup.weight_n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::tests::{is_near, look};

    #[test]
    fn valid_slopes_are_differences_of_accelerations() {
        for (pairs, contact, [q, u, x, w]) in [
            ("k=1e6 n=0.5 b=50 m=2 gamma=3", Contact::Penetrating, [4e-3, 80.0, -1e-3, -9.0]),
            ("k=1e5 theta=30deg", Contact::Withdrawing, [8e-3, -80.0, 1e-3, 9.0]),
            ("k=1e5 model=lumped b_2=100", Contact::Withdrawing, [5e-3, -80.0, 1e-3, 9.0]),
            ("k=1e5 b=50 m=1.5 theta=20deg", Contact::Fused, [5e-3, 0.0, 1e-3, 9.0]),
            ("x_stop=1mm stop_kind=elastic b_stop=90", Contact::Perforated, [0.1, 50.0, 2e-3, 9.0]),
            ("mount=rigid", Contact::Penetrating, [4e-3, 80.0, 0.0, 0.0]),
        ] {
            let at = |direction: f64| {
                let state = [
                    q + direction * 1e-7,
                    u + direction * 1e-2,
                    x + direction * 1e-7,
                    w + direction * 1e-2,
                ];
                look(pairs, contact, state, |it, at| (it.accelerations(at), it.slopes(at)))
            };
            let [(ahead, _), (behind, _), (_, slopes)] = [1.0, -1.0, 0.0].map(at);
            for (row, rise) in [ahead.0 - behind.0, ahead.1 - behind.1].into_iter().enumerate() {
                let ([by_q, by_x], [by_u, by_w]) = (slopes.place[row], slopes.speed[row]);
                let expected = 2e-7 * (by_q + by_x) + 2e-2 * (by_u + by_w);
                assert!(is_near(rise, expected, 1e-6), "{pairs} {row}: {rise} {expected}");
            }
        }
    }

    /// In a hole p deep and A = pi p (2 R - p) wide: g A `S_y` above its bottom, as slowly or fast as the projectile slips.
    #[test]
    fn valid_friction_in_the_hole_is_the_grips_part_of_the_strength() {
        let strength_n = std::f64::consts::PI * 2e-3 * (0.0127 - 2e-3) * 1.52e8;
        for (contact, grip) in [(Contact::Closing, 0.1), (Contact::Withdrawing, -0.1)] {
            let state = [3e-3, 80.0, 0.0, 0.0];
            let part = look("k=1e5", contact, state, |it, at| it.contact_n(at) / strength_n);
            assert!(is_near(part, grip, 1e-13), "{contact:?}: {part}");
        }
    }

    /// At 60 degrees 200 N of the spring turn back 59 g and a quarter of the projectile's 29.5 g.
    #[test]
    fn valid_the_joined_interface_carries_what_turns_the_projectile_back() {
        let (pairs, state) = ("gamma=2 k=1e5 theta=60deg", [4e-3, 0.0, 2e-3, 2.0]);
        let part = look(pairs, Contact::Fused, state, |it, at| it.interface_force_n(at) / 200.0);
        assert!(is_near(part, 0.5 * 29.5 / (59.0 + 29.5 / 4.0), 1e-13), "{part}");
    }
}
