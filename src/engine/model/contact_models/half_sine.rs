//! Linearised force history of Abatan and Hu, thesis equations 8.5 to 8.9: `F = m_p v pi/(2 t_d) sin(pi t/t_d)`.
//!
//! The history is prescribed. Its impulse is the momentum of the projectile: on a fixed plate it just stops the shot. Here it acts on both
//! bodies for the whole duration `t_d`, regardless of the motion of the plate; then a perfectly inelastic impact joins them. The
//! initial-velocity model is the limit `t_d` -> 0. The depth is the maximum relative travel: at the first zero of the relative velocity,
//! or at a later one if the spring returns the plate.

use std::f64::consts::PI;

use crate::model::closed_form::hydrodynamic_on_rigid_mount;
use crate::model::scene::Scene;

/// Returns the duration of the half-sine history, s; by default that of the hydrodynamic contact on a rigid mount.
pub(super) fn duration_s(scene: &Scene) -> f64 {
    scene.contact.duration_s.unwrap_or_else(|| hydrodynamic_on_rigid_mount(scene).0)
}

/// Prescribed force history, a function of time only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) struct History {
    pub(in crate::model) duration_s: f64,
    amplitude_n: f64,
    /// Travel on a rigid mount, m.
    pub(super) travel_m: f64,
}

impl History {
    pub(super) fn from_scene(scene: &Scene) -> Self {
        let (mass_kg, velocity_m_s) = (scene.projectile.mass_kg, scene.projectile.velocity_m_s);
        let duration_s = duration_s(scene);
        Self {
            duration_s,
            amplitude_n: 0.5 * PI * mass_kg * velocity_m_s / duration_s,
            travel_m: 0.5 * velocity_m_s * duration_s,
        }
    }

    pub(in crate::model) fn force_n(&self, t_s: f64) -> f64 {
        self.amplitude_n * (PI * t_s / self.duration_s).sin()
    }
}
