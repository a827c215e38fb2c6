//! Contact models of thesis section 8.2 and Table 8.1, for the same integration loop.
//!
//! A model defines the contact force; `impact` has the modes and events. A result that a model does not define is absent: no depth without
//! an interface, no peak force for an instantaneous collision. The listing of Appendix A has its own time stepping: see `appendix`.

use crate::model::contact_models::half_sine::duration_s;
use crate::model::scene::{ContactModel, Scene};
use crate::model::units::{engineering, shortest, significant};

mod half_sine;
mod law;
mod lumped;

pub(super) use law::ContactLaw;
pub(super) use lumped::stiffnesses_n_m;

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

#[cfg(test)]
mod tests;
