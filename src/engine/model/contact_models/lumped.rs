//! Wu's lumped parameters, thesis Figures 8.4 to 8.8: a spring with hysteresis and a damper between projectile and plate.
//!
//! The interface is pressed in along `k_load`, gives back along the steeper `k_unload`, and keeps a dent of
//! `delta_max (1 - k_load/k_unload)`, from which it is pressed again along `k_unload` up to where it was. It only pushes.
//! The dent is the depth; the model has no rear face.

use super::stiffnesses_n_m;
use crate::model::scene::Scene;

/// The interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) struct Lumped {
    load_n_m: f64,
    unload_n_m: f64,
    damping_n_s_m: f64,
    /// Projectile mass, kg.
    mass_kg: f64,
    velocity_m_s: f64,
}

impl Lumped {
    pub(super) fn of(scene: &Scene) -> Self {
        let (load_n_m, unload_n_m) = stiffnesses_n_m(scene);
        Self {
            load_n_m,
            unload_n_m,
            damping_n_s_m: scene.contact.damping_n_s_m,
            mass_kg: scene.projectile.mass_kg,
            velocity_m_s: scene.projectile.velocity_m_s,
        }
    }

    /// The dent that is left by a travel, m.
    pub(super) fn dent_m(&self, deepest_m: f64) -> f64 {
        deepest_m * (1.0 - self.load_n_m / self.unload_n_m)
    }

    /// Stiffness, N/m, and place where it is slack, m, of the way in or of the steeper branch.
    fn branch(&self, goes_in: bool, deepest_m: f64) -> (f64, f64) {
        if goes_in { (self.load_n_m, 0.0) } else { (self.unload_n_m, self.dent_m(deepest_m)) }
    }

    /// The interface force at a travel and a slip on the way in, or on its steeper branch as if it could pull, N.
    pub(in crate::model) fn force_n(
        &self,
        goes_in: bool,
        deepest_m: f64,
        (q_m, u_m_s): (f64, f64),
    ) -> f64 {
        let (stiffness, slack_m) = self.branch(goes_in, deepest_m);
        stiffness * (q_m - slack_m) + self.damping_n_s_m * u_m_s
    }

    /// Returns the derivatives of the force by travel, N/m, and by relative velocity, N s/m.
    pub(in crate::model) fn slopes(&self, goes_in: bool) -> (f64, f64) {
        (self.branch(goes_in, 0.0).0, self.damping_n_s_m)
    }

    /// Returns the recoverable energy of the interface spring at a travel, J.
    pub(in crate::model) fn gives_back_j(&self, goes_in: bool, deepest_m: f64, q_m: f64) -> f64 {
        let force_n = self.force_n(goes_in, deepest_m, (q_m, 0.0));
        0.5 * force_n * force_n / self.unload_n_m
    }

    /// The dent that is left on a rigid mount, m: of m q'' + b q' + k q = 0 from q = 0 at the impact velocity.
    pub(super) fn on_rigid_mount_m(&self) -> f64 {
        let (m, v) = (self.mass_kg, self.velocity_m_s);
        let rate = 0.5 * self.damping_n_s_m / m;
        let square = self.load_n_m / m - rate * rate;
        let root = square.abs().sqrt();
        // The time to the turn: by an angle, or by a hyperbolic one where the damper lets nothing oscillate.
        let to_turn_s = if square > 0.0 {
            root.atan2(rate) / root
        } else if root > 0.0 {
            (root / rate).atanh() / root
        } else {
            1.0 / rate
        };
        self.dent_m(v * (-rate * to_turn_s).exp() / (self.load_n_m / m).sqrt())
    }
}
