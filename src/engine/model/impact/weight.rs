//! Weight of the projectile along the normal of the plate, as long as the bodies are in contact.
//!
//! The weight of the plate is in equilibrium with the spring at x = 0. With the component P of the weight along the axis of the projectile,
//! `m_p v' = P - F`. Fused bodies have `M w' = P cos - G` with their mass M along the normal; the interface carries
//! `m_p cos G/M + P m_2/M`. A projectile that has left the plate has no weight: the model does not include a second fall.

use crate::model::impact::equations::Equations;
use crate::model::impact::modes::{Contact, HybridMode};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::state::State;
use crate::model::mechanism::Spring;
use crate::numerics::larger;

impl ImpactParameters {
    /// Returns the combined law of spring and elastic stop, for fused bodies with the weight.
    pub(super) fn elastic(&self, spring: &Spring, contact: Contact) -> Spring {
        let elastic = self.with_stop(spring);
        let is_heavy = self.weight_n > 0.0 && contact == Contact::Fused;
        if !is_heavy {
            return elastic;
        }
        elastic.beside_force(-self.weight_n * self.cos, self.rigid_stop_m())
    }

    /// Updates the combined law after a change of contact.
    pub(super) fn update_weight(&self, mode: &mut HybridMode, before: Contact) {
        let changes = (mode.contact == Contact::Fused) != (before == Contact::Fused);
        if changes && self.weight_n > 0.0 {
            mode.elastic = self.elastic(&mode.spring, mode.contact);
        }
    }
}

impl Equations<'_> {
    /// Returns the weight along the axis of the projectile, N; 0 after separation.
    pub(super) fn weight_n(&self) -> f64 {
        let is_gone = matches!(self.mode.contact, Contact::FreeFlight | Contact::Perforated);
        if is_gone { 0.0 } else { self.setup.weight_n }
    }

    /// Returns the weight of fused bodies along the normal of the plate, N.
    pub(super) fn joined_weight_n(&self) -> f64 {
        if self.mode.contact == Contact::Fused { self.setup.weight_n * self.setup.cos } else { 0.0 }
    }

    /// Returns the part of the weight that the fused interface carries, N.
    pub(super) fn carried_weight_n(&self) -> f64 {
        let setup = self.setup;
        if self.mode.contact == Contact::Fused {
            setup.weight_n * (setup.mass.plate_kg / setup.mass.joined_kg)
        } else {
            0.0
        }
    }

    /// Returns the force of the fused interface, positive in compression, N.
    pub(super) fn interface_force_n(&self, state: &State) -> f64 {
        if self.plate_rests() {
            return self.weight_n();
        }
        self.setup.interface_fraction() * self.mechanism_n(state.x_m, state.w_m_s)
            + self.carried_weight_n()
    }

    /// Returns the work of the weight on a step, J.
    pub(super) fn weight_work_j(&self, from: &State, to: &State) -> f64 {
        self.weight_n() * (to.q_m - from.q_m + self.setup.cos * (to.x_m - from.x_m))
    }

    /// Adds the weight to the accelerations of relative displacement and plate.
    #[inline]
    pub(super) fn with_weight(&self, (slip, plate): (f64, f64)) -> (f64, f64) {
        let setup = self.setup;
        match self.mode.contact {
            _ if setup.weight_n == 0.0 => (slip, plate),
            Contact::Fused if self.plate_rests() => (slip, plate),
            Contact::Fused => (slip, plate + self.joined_weight_n() / setup.mass.joined_kg),
            _ => (slip + self.weight_n() / setup.mass.projectile_kg, plate),
        }
    }

    /// Adds the weight to the bounds of compression and tension of the fused interface, N.
    pub(super) fn loads_with_weight_n(&self, [push_n, pull_n]: [f64; 2]) -> [f64; 2] {
        let is_joined = self.mode.contact == Contact::Fused;
        let weight_n = if is_joined { self.setup.weight_n } else { 0.0 };
        [push_n + weight_n, larger(pull_n - weight_n, 0.0)]
    }

    /// Returns the forces of the mechanism forwards and backwards at given loads of the fused interface, N.
    pub(super) fn mechanism_bounds_n(&self, [push_n, pull_n]: [f64; 2]) -> [f64; 2] {
        let carried_n = self.carried_weight_n();
        [push_n - carried_n, pull_n + carried_n]
            .map(|load_n| load_n / self.setup.interface_fraction())
    }
}
