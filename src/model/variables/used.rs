//! Which variables have any effect on a scene, and which of them a list shows at all; and the rule between the two
//! stiffnesses of the lumped interface.

use super::{Kind, Variable, VariableError, springs};
use crate::model::design::Rod;
use crate::model::scene::{
    Closure, ContactModel, InterfaceLaw, Mount, Nose, PlateSize, Scene, StopKind, Target,
};
use crate::model::units;

/// Whether a variable has any effect on this scene; rows without effect are dimmed in the editor.
pub fn is_used(variable: &Variable, scene: &Scene) -> bool {
    let sprung = scene.plate.mount == Mount::Sprung;
    let mechanism = &scene.mechanism;
    let model = scene.contact.model;
    let stop = sprung && mechanism.stop.position_m.is_some() && model != ContactModel::Appendix;
    match variable.key {
        "mechanism.damper.exponent" => sprung && mechanism.damper.coefficient > 0.0,
        "plate.cocking_m" => sprung && springs::acts(mechanism),
        key if springs::is_row(key) => sprung && springs::is_used(key, scene),
        "interface.law" => model == ContactModel::Hydrodynamic,
        "interface.grip" => {
            model == ContactModel::Hydrodynamic && scene.interface.law == InterfaceLaw::Plastic
        }
        "mechanism.stop.position_m" => sprung && model != ContactModel::Appendix,
        "mechanism.stop.kind" => stop,
        "mechanism.stop.restitution" => stop && mechanism.stop.kind == StopKind::Rigid,
        "mechanism.stop.stiffness_n_m" | "mechanism.stop.damping_n_s_m" => {
            stop && mechanism.stop.kind == StopKind::Elastic
        }
        "projectile.density_kg_m3" | "projectile.strength_pa" => is_oblique(scene),
        "target.flow_strength_pa" => uses_target(scene) && scene.target.closure == Closure::Given,
        key if key.starts_with("target.") => uses_target(scene),
        key if key.starts_with("contact.") => model_has(model, key),
        key => {
            let sizes = ["plate.mass_ratio", "plate.mass_kg", "plate.face_m"].contains(&key);
            sprung || !(key.starts_with("mechanism.") || sizes)
        }
    }
}

impl Variable {
    /// The words of a choice, in order; none for a number or a switch.
    pub fn words(&self) -> &'static [&'static str] {
        match &self.kind {
            Kind::Choice(choice) => choice.words,
            Kind::Number(_) | Kind::Switch { .. } => &[],
        }
    }
}

/// Whether the workbench's lists offer the variable: what is listed, less the values of a stop that is not there or of
/// its other kind. Files keep those, for the stop may come back.
pub fn is_offered(variable: &Variable, scene: &Scene) -> bool {
    let of_stop =
        variable.key.starts_with("mechanism.stop.") && variable.key != "mechanism.stop.position_m";
    is_listed(variable, scene) && (!of_stop || is_used(variable, scene))
}

/// Whether a list shows the variable at all: what belongs to another interaction model is not even dimmed.
pub fn is_listed(variable: &Variable, scene: &Scene) -> bool {
    match variable.key {
        "projectile.density_kg_m3" | "projectile.strength_pa" => is_oblique(scene),
        "projectile.nose" => scene.projectile.nose != Nose::Hemispherical,
        "plate.mass_kg" => matches!(scene.plate.size, PlateSize::Mass(_)),
        "plate.face_m" => matches!(scene.plate.size, PlateSize::Face(_)),
        "target.yield_pa" => scene.target.closure != Closure::Given,
        "target.modulus_pa" => scene.target.closure == Closure::Cavity,
        "mechanism.energy_j_kg" => scene.mechanism.energy_j_kg.is_some(),
        "stack.base_thickness_m" => true,
        key if key.starts_with("stack.") => {
            scene.stack.base_thickness_m.is_some() || scene.stack.elements > 1.0
        }
        key if springs::is_row(key) => springs::is_listed(key, scene),
        key => !key.starts_with("contact.") || model_has(scene.contact.model, key),
    }
}

fn is_oblique(scene: &Scene) -> bool {
    scene.projectile.obliquity_deg > 0.0
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
        return Err(VariableError::Together(
            "closure (target.closure) = cavity with dishing (target.dishing) = on corrects twice, for the bulge and for the \
             material that holds it back: set dishing = off, or closure = double-yield"
                .to_owned(),
        ));
    }
    if closure == Closure::Cavity && modulus_pa <= yield_pa {
        return Err(VariableError::Together(format!(
            "E (target.modulus_pa) = {} Pa is not greater than Y (target.yield_pa) = {} Pa: cavity expansion needs an elastic \
             body; for steel E is about 2e11 Pa, for aluminium 7e10 Pa",
            units::shortest(modulus_pa),
            units::shortest(yield_pa)
        )));
    }
    Ok(())
}

/// Whether a key below `contact.` belongs to this model.
fn model_has(model: ContactModel, key: &str) -> bool {
    match key {
        "contact.model" => true,
        "contact.duration_s" => model == ContactModel::HalfSine,
        key if key.starts_with("contact.appendix.") => model == ContactModel::Appendix,
        _ => model == ContactModel::Lumped,
    }
}

/// Whether the plate's material matters: to the other models only where it fills in what was left open.
fn uses_target(scene: &Scene) -> bool {
    match scene.contact.model {
        ContactModel::Hydrodynamic | ContactModel::Appendix => true,
        ContactModel::HalfSine => scene.contact.duration_s.is_none(),
        ContactModel::Lumped => scene.contact.load_stiffness_n_m.is_none(),
        ContactModel::InitialVelocity => false,
    }
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
    Err(VariableError::Together(format!(
        "k_unload (contact.unload_stiffness_n_m) = {unload} N/m is below k_load = {load} N/m: the interface would give back \
         more than it took; it must be {load} N/m or more, or `auto`"
    )))
}

/// For what only makes sense of the hydrodynamic law.
///
/// # Errors
/// [`VariableError::Together`] when the scene asks for another model.
pub fn require_hydrodynamic(scene: &Scene) -> Result<(), VariableError> {
    let model = scene.contact.model;
    if model == ContactModel::Hydrodynamic {
        return Ok(());
    }
    Err(VariableError::Together(format!(
        "model (contact.model) = {} is not for this study, which compares methods for the hydrodynamic law: set model = \
         hydrodynamic",
        model.word()
    )))
}
