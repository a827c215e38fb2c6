//! The comparison in closed form: a free plate without dishing on a soft spring; see the module's head for the derivation.

use serde::Serialize;

use crate::model::mechanism::Mechanism;
use crate::model::scene::{ContactModel, Mount, PlateSize, Scene};
use crate::study::compare::Hardware;
use crate::study::compare::hardware::is_own;

/// The closed-form result of a design.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClosedForm {
    /// Mass efficiency at the design velocity.
    pub mass_efficiency: f64,
    /// The energy per mass above which the mechanism pays, J/kg.
    pub needed_j_per_kg: f64,
    /// The velocity below which it pays with the given energy per mass, m/s.
    pub pays_below_m_s: f64,
}

impl ClosedForm {
    /// For a mass ratio, an impact velocity, m/s, and an energy per mass, J/kg.
    pub fn new(mass_ratio: f64, velocity_m_s: f64, energy_j_per_kg: f64) -> Self {
        let (gamma, e) = (mass_ratio, energy_j_per_kg);
        let needed = velocity_m_s * velocity_m_s / (2.0 * (1.0 + gamma));
        Self {
            mass_efficiency: (1.0 + 1.0 / gamma) / (1.0 + needed / (gamma * e)),
            needed_j_per_kg: needed,
            pays_below_m_s: (2.0 * (1.0 + gamma) * e).sqrt(),
        }
    }

    /// For a scene whose spring alone takes up energy; `None` for a rigid mount, a stack, an oblique shot, another contact model, a
    /// cocked plate, a stop, a damper, a spring whose mass is given or its own, and a plate whose mass ratio follows from its face.
    pub fn of(scene: &Scene, hardware: &Hardware) -> Option<Self> {
        let fits = scene.plate.mount == Mount::Sprung
            && !scene.is_stack()
            && scene.projectile.obliquity_deg == 0.0
            && scene.contact.model == ContactModel::Hydrodynamic
            && scene.plate.cocking_m == 0.0
            && !matches!(scene.plate.size, PlateSize::Face(_))
            && scene.mechanism.stop.position_m.is_none()
            && scene.mechanism.damper.coefficient == 0.0
            && !Mechanism::of(scene).spring.is_absent()
            && hardware.spring_kg.is_none()
            && !is_own(scene);
        let (gamma, velocity_m_s) = (scene.plate.mass_ratio, scene.projectile.velocity_m_s);
        let energy_j_kg = scene.mechanism.specific_energy_j_kg().filter(|_| fits)?;
        Some(Self::new(gamma, velocity_m_s, energy_j_kg))
    }
}
