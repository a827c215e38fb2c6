//! Weight of the projectile: it acts along the plate's normal as long as the bodies touch.
//!
//! The plate's own weight is in equilibrium with the spring at x = 0. With the weight's part P along the projectile's axis
//! `m_p v' = P - F`; joined bodies have `M w' = P cos - G`, M their mass along the normal, so that the interface carries
//! `m_p cos G/M + P m_2/M`. A projectile that has left the plate flies on without weight: a second fall is not in the model.

use crate::model::impact::equations::{Equations, ImpactParameters, State};
use crate::model::impact::modes::{Contact, HybridMode};
use crate::model::mechanism::Spring;
use crate::numerics::larger;

impl ImpactParameters {
    /// Energy of joined bodies in spring, elastic stop and weight, or without the weight of bodies that are not joined.
    pub(super) fn elastic(&self, spring: &Spring, contact: Contact) -> Spring {
        let elastic = self.with_stop(spring);
        let is_heavy = self.weight_n > 0.0 && contact == Contact::Fused;
        if !is_heavy {
            return elastic;
        }
        elastic.beside_force(-self.weight_n * self.cos, self.rigid_stop_m())
    }

    /// Updates the energy law of a mode whose contact was another.
    pub(super) fn update_weight(&self, mode: &mut HybridMode, before: Contact) {
        let changes = (mode.contact == Contact::Fused) != (before == Contact::Fused);
        if changes && self.weight_n > 0.0 {
            mode.elastic = self.elastic(&mode.spring, mode.contact);
        }
    }
}

impl Equations<'_> {
    /// Weight along the projectile's axis, N; none once the bodies have parted.
    pub(super) fn weight_n(&self) -> f64 {
        let is_gone = matches!(self.mode.contact, Contact::FreeFlight | Contact::Perforated);
        if is_gone { 0.0 } else { self.setup.weight_n }
    }

    /// Weight that drives joined bodies along the plate's normal, N.
    pub(super) fn joined_weight_n(&self) -> f64 {
        if self.mode.contact == Contact::Fused { self.setup.weight_n * self.setup.cos } else { 0.0 }
    }

    /// Part of the weight that the joined interface carries besides its part of the mechanism's force, N.
    pub(super) fn carried_weight_n(&self) -> f64 {
        let setup = self.setup;
        if self.mode.contact == Contact::Fused {
            setup.weight_n * (setup.plate_kg / setup.joined_kg)
        } else {
            0.0
        }
    }

    /// The force that the joined interface carries, positive where it is pushed, N.
    pub(super) fn interface_force_n(&self, state: &State) -> f64 {
        if self.plate_rests() || self.creeps(state) {
            return self.weight_n();
        }
        self.setup.interface_fraction() * self.mechanism_n(state.x_m, state.w_m_s)
            + self.carried_weight_n()
    }

    /// Work of the weight on a step, J.
    pub(super) fn weight_work_j(&self, from: &State, to: &State) -> f64 {
        self.weight_n() * (to.q_m - from.q_m + self.setup.cos * (to.x_m - from.x_m))
    }

    /// Accelerations of slip and plate with those that the weight adds.
    #[inline]
    pub(super) fn with_weight(&self, (slip, plate): (f64, f64)) -> (f64, f64) {
        let setup = self.setup;
        match self.mode.contact {
            _ if setup.weight_n == 0.0 => (slip, plate),
            Contact::Fused if self.plate_rests() => (slip, plate),
            Contact::Fused => (slip, plate + self.joined_weight_n() / setup.joined_kg),
            _ => (slip + self.weight_n() / setup.projectile_kg, plate),
        }
    }

    /// Greatest push and pull on the joined interface with the weight, from those of the forces that drive joined bodies, N.
    pub(super) fn loads_with_weight_n(&self, [push_n, pull_n]: [f64; 2]) -> [f64; 2] {
        let is_joined = self.mode.contact == Contact::Fused;
        let weight_n = if is_joined { self.setup.weight_n } else { 0.0 };
        [push_n + weight_n, larger(pull_n - weight_n, 0.0)]
    }

    /// Greatest forces of the mechanism forwards and backwards with these loads of the joined interface, N.
    pub(super) fn mechanism_bounds_n(&self, [push_n, pull_n]: [f64; 2]) -> [f64; 2] {
        let carried_n = self.carried_weight_n();
        [push_n - carried_n, pull_n + carried_n]
            .map(|load_n| load_n / self.setup.interface_fraction())
    }
}
