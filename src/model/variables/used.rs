//! Rules between the values of a contact model, and which studies it serves.

use super::{Kind, Variable, VariableError};
use crate::model::design::Rod;
use crate::model::scene::{Closure, ContactModel, Scene, Target};
use crate::model::units;

impl Variable {
    /// The words of a choice, in order; none for a number or a switch.
    pub fn words(&self) -> &'static [&'static str] {
        match &self.kind {
            Kind::Choice(choice) => choice.words,
            Kind::Number(_) | Kind::Switch { .. } => &[],
        }
    }
}

/// Tate's critical obliquity of a scene's shot, taken as a rod of its mass and radius, degrees.
pub fn critical_obliquity_deg(scene: &Scene) -> f64 {
    let shot = &scene.projectile;
    let section = std::f64::consts::PI * shot.tip_radius_m * shot.tip_radius_m;
    let rod = Rod {
        density_kg_m3: shot.density_kg_m3,
        strength_pa: shot.strength_pa,
        velocity_m_s: shot.velocity_m_s,
        length_m: shot.mass_kg / (shot.density_kg_m3 * section),
        diameter_m: 2.0 * shot.tip_radius_m,
    };
    rod.critical_obliquity_deg(scene.target.density_kg_m3)
}

/// The two closures for the flow strength each contain the bulge in their own way: never both.
pub(super) fn check_closure(scene: &Scene) -> Result<(), VariableError> {
    let Target { closure, dishing, yield_pa, modulus_pa, .. } = scene.target;
    if closure == Closure::Cavity && dishing {
        return Err(VariableError(
            "closure (target.closure) = cavity with dishing (target.dishing) = on corrects twice, for the bulge and for the \
             material that holds it back: set dishing = off, or closure = double-yield"
                .to_owned(),
        ));
    }
    if closure == Closure::Cavity && modulus_pa <= yield_pa {
        return Err(VariableError(format!(
            "E (target.modulus_pa) = {} Pa is not greater than Y (target.yield_pa) = {} Pa: cavity expansion needs an elastic \
             body; for steel E is about 2e11 Pa, for aluminium 7e10 Pa",
            units::shortest(modulus_pa),
            units::shortest(yield_pa)
        )));
    }
    Ok(())
}

/// The interface cannot give back more than it took.
pub(super) fn check_interface_spring(scene: &Scene) -> Result<(), VariableError> {
    let contact = &scene.contact;
    let (Some(load), Some(unload)) = (contact.load_stiffness_n_m, contact.unload_stiffness_n_m)
    else {
        return Ok(());
    };
    if contact.model != ContactModel::Lumped || unload >= load {
        return Ok(());
    }
    let (load, unload) = (units::shortest(load), units::shortest(unload));
    Err(VariableError(format!(
        "k_unload (contact.unload_stiffness_n_m) = {unload} N/m is below k_load = {load} N/m: the interface would give back \
         more than it took; it must be {load} N/m or more, or `auto`"
    )))
}

/// For what only makes sense of the hydrodynamic law.
///
/// # Errors
/// [`VariableError`] when the scene requests another model.
pub fn require_hydrodynamic(scene: &Scene) -> Result<(), VariableError> {
    let model = scene.contact.model;
    if model == ContactModel::Hydrodynamic {
        return Ok(());
    }
    Err(VariableError(format!(
        "model (contact.model) = {} is not for this study, which compares methods for the hydrodynamic law: set model = \
         hydrodynamic",
        model.word()
    )))
}
