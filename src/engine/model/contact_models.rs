//! Contact models of thesis section 8.2 and Table 8.1, for the same integration loop.
//!
//! A model defines the contact force; `impact` has the modes and events. A result that a model does not define is absent: no depth without
//! an interface, no peak force for an instantaneous collision. The listing of Appendix A has its own time stepping: see `appendix`.

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::scene::{ContactModel, Scene};
use crate::model::units::{engineering, shortest, significant};

mod half_sine;
mod law;
mod lumped;

pub(super) use law::ContactLaw;

impl ContactModel {
    /// Contact models in the order of Table 8.1.
    pub const IN_TABLE_8_1: [Self; 5] =
        [Self::Hydrodynamic, Self::Lumped, Self::HalfSine, Self::InitialVelocity, Self::Appendix];

    /// Returns the model's strength according to Table 8.1, and its limitation.
    pub fn about(self) -> &'static str {
        match self {
            Self::Hydrodynamic => "simple; models the contact force as a modified fluid drag",
            Self::HalfSine => "simple; the duration has to be chosen; cannot perforate",
            Self::InitialVelocity => "simple; the impact takes no time; cannot perforate",
            Self::Lumped => "simple; needs parameters that no source gives; cannot perforate",
            Self::Appendix => "the method of chapter 9; not in Table 8.1",
        }
    }

    /// Describes the model's parameters in a scene; empty if it has none.
    pub fn parameters(self, scene: &Scene) -> String {
        let (contact, step_s) = (&scene.contact, scene.contact.appendix.step_s);
        match self {
            Self::Hydrodynamic | Self::InitialVelocity => String::new(),
            Self::HalfSine => {
                let duration = engineering(duration_s(scene), "s", 4);
                format!("t_d = {duration}{}", auto(contact.duration_s))
            }
            Self::Lumped => {
                let (load_n_m, unload_n_m) = stiffnesses_n_m(scene);
                format!(
                    "k_load = {}{}, k_unload = {} k_load{}, b_2 = {} N s/m",
                    engineering(load_n_m, "N/m", 4),
                    auto(contact.load_stiffness_n_m),
                    significant(unload_n_m / load_n_m, 4),
                    auto(contact.unload_stiffness_n_m),
                    shortest(contact.damping_n_s_m)
                )
            }
            Self::Appendix => format!("dt = {}", engineering(step_s, "s", 4)),
        }
    }
}

/// Returns a note if a parameter is not given.
fn auto(given: Option<f64>) -> &'static str {
    if given.is_none() { " (auto)" } else { "" }
}

/// Default ratio of unloading to loading stiffness: a hundredth of the dent and a tenth of the velocity are recovered.
const UNLOAD_PER_LOAD: f64 = 100.0;

/// Returns the duration of the half-sine history, s; by default that of the hydrodynamic contact on a rigid mount.
fn duration_s(scene: &Scene) -> f64 {
    scene.contact.duration_s.unwrap_or_else(|| hydrodynamic_on_rigid_mount(scene).0)
}

/// Returns loading and unloading stiffness of the lumped interface, N/m. The default loading stiffness gives the travel of the hydrodynamic
/// contact on a rigid mount.
fn stiffnesses_n_m(scene: &Scene) -> (f64, f64) {
    let load_n_m = scene.contact.load_stiffness_n_m.unwrap_or_else(|| {
        let speed_per_s = scene.projectile.velocity_m_s / hydrodynamic_on_rigid_mount(scene).1;
        scene.projectile.mass_kg * speed_per_s * speed_per_s
    });
    (load_n_m, scene.contact.unload_stiffness_n_m.unwrap_or(UNLOAD_PER_LOAD * load_n_m))
}

/// Returns duration, s, and travel, m, of the hydrodynamic contact on a rigid mount, up to the exit for a perforation.
fn hydrodynamic_on_rigid_mount(scene: &Scene) -> (f64, f64) {
    let geometry = Geometry::from_scene(scene);
    let passage = Passage::rigid(scene, &geometry);
    let arrest_m = passage.arrest_m();
    let end_s = passage.time_s(arrest_m);
    let at_speed_s = geometry.exit_m / scene.projectile.velocity_m_s;
    (if end_s.is_finite() { end_s } else { at_speed_s }, arrest_m.unwrap_or(geometry.exit_m))
}

#[cfg(test)]
mod tests;
