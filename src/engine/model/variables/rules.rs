//! Rules between the values of a scene, and which studies it serves.

use super::VariableError;
use crate::model::scene::{
    self, Closure, Combination, ContactModel, Layer, OwnMass, Scene, Stack, Target,
};
use crate::model::units::{shortest, significant};

/// A refusal of values that make no sense together.
fn refuse(text: String) -> Result<(), VariableError> {
    Err(VariableError(text))
}

/// All rules between values, in the order in which they are reported.
pub(super) fn check(scene: &Scene) -> Result<(), VariableError> {
    check_stop(scene)?;
    check_closing(scene)?;
    check_closure(scene)?;
    check_interface_spring(scene)?;
    check_springs(scene)?;
    check_stack(scene)
}

/// The plate starts in front of its stop.
fn check_stop(scene: &Scene) -> Result<(), VariableError> {
    // Not `-d`, which is written as -0 where nothing is cocked.
    let start = 0.0 - scene.plate.cocking_m;
    if let Some(position) = scene.mechanism.stop.position_m
        && position < start
    {
        let (position, start) = (shortest(position), shortest(start));
        return refuse(format!(
            "x_stop (mechanism.stop.position_m) = {position} m lies behind the plate's start at -d = {start} m: it must be \
             {start} m or more; move the stop or reduce d"
        ));
    }
    Ok(())
}

/// The projectile reaches the plate.
fn check_closing(scene: &Scene) -> Result<(), VariableError> {
    if scene.closing_velocity_m_s() > 0.0 {
        return Ok(());
    }
    let most_m_s = scene.projectile.velocity_m_s / scene.cos_obliquity();
    refuse(format!(
        "w_0 (plate.velocity_m_s) = {} m/s takes the plate away before the projectile reaches it: it must be below \
         v_i / cos(theta) = {} m/s; reduce w_0 or raise v_i",
        shortest(scene.plate.velocity_m_s),
        significant(most_m_s, 6)
    ))
}

/// The two closures for the flow strength each contain the bulge in their own way: never both.
fn check_closure(scene: &Scene) -> Result<(), VariableError> {
    let (closure, Target { yield_pa, modulus_pa, .. }) = (scene.closure(), scene.target);
    if closure == Closure::Cavity && scene.dishing() {
        return refuse(
            "closure (target.closure) = cavity with dishing (target.dishing) = on corrects twice, for the bulge and for the \
             material that holds it back: set dishing = off, or closure = double-yield"
                .to_owned(),
        );
    }
    if closure == Closure::Cavity && modulus_pa <= yield_pa {
        return refuse(format!(
            "E (target.modulus_pa) = {} Pa is not greater than Y (target.yield_pa) = {} Pa: cavity expansion needs an elastic \
             body; for steel E is about 2e11 Pa, for aluminium 7e10 Pa",
            shortest(modulus_pa),
            shortest(yield_pa)
        ));
    }
    Ok(())
}

/// The interface cannot give back more than it took.
fn check_interface_spring(scene: &Scene) -> Result<(), VariableError> {
    let contact = &scene.contact;
    if let (Some(load), Some(unload)) = (contact.load_stiffness_n_m, contact.unload_stiffness_n_m)
        && contact.model == ContactModel::Lumped
        && unload < load
    {
        let (load, unload) = (shortest(load), shortest(unload));
        return refuse(format!(
            "k_unload (contact.unload_stiffness_n_m) = {unload} N/m is below k_load = {load} N/m: the interface would give back \
             more than it took; it must be {load} N/m or more, or `auto`"
        ));
    }
    Ok(())
}

/// The rules between the values of the springs, and between them and the contact model.
fn check_springs(scene: &Scene) -> Result<(), VariableError> {
    if scene.is_rigid() {
        return Ok(());
    }
    let mechanism = &scene.mechanism;
    mechanism.spring.law().check("mechanism.spring")?;
    if scene.contact.model != ContactModel::Appendix || mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "model (contact.model) = appendix needs a power law, and {} is not one: set model = hydrodynamic, or spring = power-law, \
         combine = alone, own_mass = ignored",
        described(mechanism)
    ))
}

/// The mechanism in a few words, for refusals.
fn described(mechanism: &scene::Mechanism) -> String {
    let kind = mechanism.spring.kind.word();
    let own = if mechanism.spring.own_mass == OwnMass::Counted { " with its own mass" } else { "" };
    match mechanism.combination {
        Combination::Alone => format!("spring (mechanism.spring.kind) = {kind}{own}"),
        Combination::Parallel => format!("{kind} in parallel with a second spring"),
    }
}

/// A stack has a base at the end, a whole number of elements, each of which makes sense by itself, and a model that knows what is
/// left of a shot.
fn check_stack(scene: &Scene) -> Result<(), VariableError> {
    let stack = &scene.stack;
    if stack.elements.fract() != 0.0 {
        return refuse(format!(
            "elements (stack.elements) = {} is not whole: there are 1 to 50 of them; round it",
            shortest(stack.elements)
        ));
    }
    if stack.base_thickness_m.is_none() {
        if stack.elements > 1.0 || !stack.layers.is_empty() {
            return refuse(format!(
                "elements (stack.elements, stack.layer) = {} without h_base (stack.base_thickness_m): a stack must end in a \
                 base plate; write its thickness, for example stack.base_thickness_m = 0.01, or omit the stack",
                shortest(stack.elements + stack.layers.len() as f64)
            ));
        }
        return Ok(());
    }
    if scene.contact.model != ContactModel::Hydrodynamic {
        return refuse(format!(
            "model (contact.model) = {} gives no residual velocity, which a stack (stack.base_thickness_m) needs: set \
             model = hydrodynamic, or h_base = none",
            scene.contact.model.word()
        ));
    }
    for (index, Layer { target, plate, mechanism }) in stack.layers.iter().enumerate() {
        let mut own = Scene { stack: Stack::default(), ..scene.clone() };
        (own.target, own.plate, own.mechanism) = (*target, *plate, mechanism.clone());
        if plate.velocity_m_s != 0.0 {
            return refuse(format!(
                "stack.layer {}: w_0 (plate.velocity_m_s) = {} m/s: only the plate that is struck first can have a velocity; set it to 0",
                index + 1,
                shortest(plate.velocity_m_s)
            ));
        }
        super::validate(&own)
            .map_err(|error| VariableError(format!("stack.layer {}: {error}", index + 1)))?;
    }
    Ok(())
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
    refuse(format!(
        "model (contact.model) = {} is not for this study, which compares methods for the hydrodynamic law: set model = \
         hydrodynamic",
        model.word()
    ))
}

/// For the stability map, whose axes are the thesis's own mechanism's.
///
/// # Errors
/// [`VariableError`] when the scene has another one.
pub fn require_plain(scene: &Scene) -> Result<(), VariableError> {
    if scene.is_rigid() || scene.mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "{} is not for the stability map, which varies k, n or b of the thesis's spring k |x|^n and damper: set spring = \
         power-law, combine = alone, own_mass = ignored, N_spring = 1",
        described(&scene.mechanism)
    ))
}

/// For studies that look at one plate.
///
/// # Errors
/// [`VariableError`] when the scene is a stack.
pub fn require_single(scene: &Scene) -> Result<(), VariableError> {
    let Some(base) = scene.stack.base_thickness_m else { return Ok(()) };
    refuse(format!(
        "h_base (stack.base_thickness_m) = {} m makes the scene a stack, and this study looks at one plate: set h_base = none, \
         elements = 1",
        shortest(base)
    ))
}
