//! The linearised force history of Abatan and Hu, thesis equations 8.5 to 8.9: `F = m_p v pi/(2 t_d) sin(pi t/t_d)`.
//!
//! The history is prescribed: it is that of a fixed plate, on which it just stops the projectile, and its impulse is the
//! projectile's whole momentum. Here it acts on both bodies for all of `t_d`, whatever the plate does meanwhile; then they
//! are one, with the momentum they have. So the initial-velocity model is its limit for `t_d` to 0. Depth is the greatest
//! relative travel that follows: at the first common velocity, or at a later one where a spring throws the plate back.

use std::f64::consts::PI;

use super::duration_s;
use crate::model::scene::Scene;

/// A prescribed force history, a function of time alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) struct History {
    pub(in crate::model) duration_s: f64,
    amplitude_n: f64,
    /// How far the projectile comes on a rigid mount, m.
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
