//! Rules between the values of a scene, and requirements of studies.

use super::Variable;
use super::error::VariableError;
use super::names::find;
use super::table::VARIABLES;
use crate::model::contact_models::stiffnesses_n_m;
use crate::model::plug::{Metal, Plug};
use crate::model::run::plate_name;
use crate::model::scene::{
    Closure, Combination, Contact, ContactModel, Layer, Mechanism, OwnMass, Scene, Stack, Target,
    resists,
};
use crate::model::stack;
use crate::model::units::{shortest, significant};

/// Rejects values of the variables with these keys that make no sense together.
fn require(
    holds: bool,
    keys: &[&'static str],
    otherwise: impl FnOnce() -> String,
) -> Result<(), VariableError> {
    if holds { Ok(()) } else { Err(VariableError::together(keys, otherwise())) }
}

/// A variable of a scene as errors state it: `x_stop (mechanism.stop.position_m) = -1 m`.
fn stated(scene: &Scene, key: &str) -> String {
    let text = |it: &Variable| format!("{} ({key}) = {} {}", it.symbol, it.show(scene), it.unit());
    find(key).map_or_else(|error| error.to_string(), |it| text(it).trim_end().to_owned())
}

/// Checks all values and the rules between values, in the order of the table.
pub fn validate(scene: &Scene) -> Result<(), VariableError> {
    for variable in VARIABLES.iter() {
        variable.check(variable.value(scene))?;
    }
    check_together(scene)
}

/// Checks all rules between values, in the order in which they are reported.
fn check_together(scene: &Scene) -> Result<(), VariableError> {
    let Scene { projectile, plate, mechanism, contact, .. } = scene;
    // `-d` would be -0 without cocking.
    let start = 0.0 - plate.cocking_m;
    let position = mechanism.stop.position_m.unwrap_or(start);
    require(position >= start, &["mechanism.stop.position_m"], || {
        format!(
            "{} lies behind the plate's start at -d = {start} m: it must be {start} m or more; move the stop or reduce d",
            stated(scene, "mechanism.stop.position_m"),
            start = shortest(start)
        )
    })?;
    require(scene.closing_velocity_m_s() > 0.0, &["plate.velocity_m_s"], || {
        format!(
            "{} takes the plate away before the projectile reaches it: it must be below v_i / cos(theta) = {} m/s; reduce w_0 or raise v_i",
            stated(scene, "plate.velocity_m_s"),
            significant(projectile.velocity_m_s / scene.cos_obliquity(), 6)
        )
    })?;
    check_closure(scene)?;
    check_lumped(scene)?;
    if scene.is_sprung() {
        mechanism.spring.law().check()?;
        require(
            contact.model != ContactModel::Appendix || mechanism.is_plain(),
            &["contact.model", "mechanism.spring.kind"],
            || {
                format!(
                    "{} needs a power law, and {} is not one: set model = hydrodynamic, or spring = power-law, combine = alone, own_mass = ignored",
                    stated(scene, "contact.model"),
                    described(scene)
                )
            },
        )?;
    }
    check_stack(scene)
}

/// Checks that the lumped interface gives back no more than it took, whether its stiffnesses are given or derived from the scene.
fn check_lumped(scene: &Scene) -> Result<(), VariableError> {
    let Contact { model, load_stiffness_n_m, unload_stiffness_n_m, .. } = scene.contact;
    // A derived unloading stiffness is a multiple of the other.
    if model != ContactModel::Lumped || unload_stiffness_n_m.is_none() {
        return Ok(());
    }
    let (load, unload) = stiffnesses_n_m(scene);
    let derived = if load_stiffness_n_m.is_some() { "" } else { "auto = " };
    require(unload >= load, &["contact.unload_stiffness_n_m"], || {
        format!(
            "{} is below k_load = {derived}{load} N/m: the interface would give back more than it took; it must be {load} N/m or more, or \
             `auto`",
            stated(scene, "contact.unload_stiffness_n_m"),
            load = shortest(load)
        )
    })
}

/// Checks the closure. Each closure accounts for the bulge either by dishing or in the strength, never both; cavity expansion needs an
/// elastic body.
fn check_closure(scene: &Scene) -> Result<(), VariableError> {
    let Target { closure, dishing, yield_pa, modulus_pa, .. } = scene.target_in_effect();
    let is_cavity = closure == Closure::Cavity;
    require(!(is_cavity && dishing), &["target.closure", "target.dishing"], || {
        format!(
            "{} with dishing (target.dishing) = on corrects twice, for the bulge and for the material that holds it back: set dishing = off, \
             or closure = double-yield",
            stated(scene, "target.closure")
        )
    })?;
    let is_stiff = |least_pa: f64, what: &str| {
        require(modulus_pa > least_pa, &["target.modulus_pa", "target.yield_pa"], || {
            format!(
                "{} is not greater than {what} = {} Pa: cavity expansion needs an elastic body; for steel E is about 2e11 Pa, for aluminium \
                 7e10 Pa",
                stated(scene, "target.modulus_pa"),
                significant(least_pa, 6)
            )
        })
    };
    let shears = scene.projectile.nose.shears() && resists(scene);
    if closure == Closure::Cylindrical || shears && closure != Closure::Given {
        is_stiff(3f64.sqrt() * yield_pa, "3^(1/2) Y (target.yield_pa)")?;
    } else if is_cavity {
        is_stiff(yield_pa, "Y (target.yield_pa)")?;
    }
    if shears { check_plug(scene) } else { Ok(()) }
}

/// Checks that a nose that shears out a plug has the strength of the metal, a plug law, and a plate heavier than the plug.
fn check_plug(scene: &Scene) -> Result<(), VariableError> {
    let nose = || stated(scene, "projectile.nose");
    require(scene.closure() != Closure::Given, &["projectile.nose", "target.closure"], || {
        format!(
            "{} with {}: the plug law needs Y and E; set closure = cylindrical with Y, UTS and E, choose a material, or set nose = \
             hemispherical",
            nose(),
            stated(scene, "target.closure")
        )
    })?;
    require(
        scene.contact.model != ContactModel::Appendix,
        &["projectile.nose", "contact.model"],
        || {
            format!(
                "{} with {}: the listing has a hemisphere only; set model = hydrodynamic, or nose = hemispherical",
                nose(),
                stated(scene, "contact.model")
            )
        },
    )?;
    require(
        Metal::of_density(scene.target.density_kg_m3).is_some(),
        &["projectile.nose", "target.density_kg_m3"],
        || {
            let (low, high) = Metal::STEEL_KG_M3;
            format!(
                "{} on a plate of {}: there is no plug law for this metal, only for light alloys below {} and steels of {} to {} kg/m3; set \
                 nose = hemispherical for hole growth alone",
                nose(),
                stated(scene, "target.density_kg_m3"),
                shortest(Metal::LIGHT_BELOW_KG_M3),
                shortest(low),
                shortest(high)
            )
        },
    )?;
    let plug_kg = Plug::from_scene(scene).map_or(0.0, |plug| plug.mass_kg);
    let plate_kg = scene.plate_mass_kg();
    require(
        !scene.is_sprung() || plate_kg > plug_kg,
        &["projectile.nose", "plate.mass_ratio"],
        || {
            format!(
                "plate mass m_2 = {} g is not greater than the {} g of the plug that {} shears out: the whole plate is the plug; raise gamma \
                 (plate.mass_ratio), m_2 or face, or set mount = rigid",
                significant(1e3 * plate_kg, 4),
                significant(1e3 * plug_kg, 4),
                nose()
            )
        },
    )
}

/// Describes the mechanism in a few words, for error messages.
fn described(scene: &Scene) -> String {
    let Mechanism { spring, combination, .. } = &scene.mechanism;
    let own = if spring.own_mass == OwnMass::Counted { " with its own mass" } else { "" };
    match combination {
        Combination::Alone => stated(scene, "mechanism.spring.kind") + own,
        Combination::Parallel => format!("{} in parallel with a second spring", spring.kind.word()),
    }
}

/// Checks that a stack has a base plate, a whole number of elements that each make sense, and a contact model with a residual velocity.
fn check_stack(scene: &Scene) -> Result<(), VariableError> {
    let Stack { elements, layers, base_thickness_m, .. } = &scene.stack;
    let model = scene.contact.model;
    require(elements.fract() == 0.0, &["stack.elements"], || {
        format!(
            "{} is not whole: there are 1 to 50 of them; round it",
            stated(scene, "stack.elements")
        )
    })?;
    if base_thickness_m.is_none() {
        return require(
            *elements <= 1.0 && layers.is_empty(),
            &["stack.elements", "stack.base_thickness_m"],
            || {
                format!(
                    "elements (stack.elements, stack.layer) = {} without h_base (stack.base_thickness_m): a stack must end in a \
                 base plate; write its thickness, for example stack.base_thickness_m = 0.01, or omit the stack",
                    shortest(elements + layers.len() as f64)
                )
            },
        );
    }
    require(
        model == ContactModel::Hydrodynamic,
        &["contact.model", "stack.base_thickness_m"],
        || {
            format!(
                "{} gives no residual velocity, which a stack (stack.base_thickness_m) needs: set model = hydrodynamic, or h_base = none",
                stated(scene, "contact.model")
            )
        },
    )?;
    for (number, Layer { target, plate, mechanism }) in (1..).zip(layers) {
        let mut own = Scene { stack: Stack::default(), ..scene.clone() };
        (own.target, own.plate, own.mechanism) = (*target, *plate, mechanism.clone());
        require(plate.velocity_m_s == 0.0, &["plate.velocity_m_s"], || {
            format!(
                "stack.layer {number}: {}: only the plate that is struck first can have a velocity; set it to 0",
                stated(&own, "plate.velocity_m_s")
            )
        })?;
        validate(&own).map_err(|source| element(format!("stack.layer {number}"), source))?;
    }
    if !scene.projectile.nose.shears() {
        return Ok(());
    }
    // Plates behind a plug are also struck by the plug.
    let plates = stack::plates(scene);
    let count = plates.len() - 1;
    for (number, plate) in plates.iter().enumerate().skip(1) {
        validate(plate).map_err(|source| element(plate_name(number, count), source))?;
    }
    Ok(())
}

fn element(place: String, source: VariableError) -> VariableError {
    VariableError::Element { place, source: Box::new(source) }
}

/// Rejects contact models other than the hydrodynamic one.
pub fn require_hydrodynamic(scene: &Scene) -> Result<(), VariableError> {
    let is_hydrodynamic = scene.contact.model == ContactModel::Hydrodynamic;
    require(is_hydrodynamic, &["contact.model"], || {
        format!(
            "{} is not for this study, which compares methods for the hydrodynamic law: set model = hydrodynamic",
            stated(scene, "contact.model")
        )
    })
}

/// Rejects mechanisms other than the thesis's, whose variables are the axes of the stability map.
pub fn require_plain(scene: &Scene) -> Result<(), VariableError> {
    require(!scene.is_sprung() || scene.mechanism.is_plain(), &["mechanism.spring.kind"], || {
        format!(
            "{} is not for the stability map, which varies k, n or b of the thesis's spring k |x|^n and damper: set spring = \
             power-law, combine = alone, own_mass = ignored, N_spring = 1",
            described(scene)
        )
    })
}

/// Rejects a stack, for studies of a single plate.
pub fn require_single(scene: &Scene) -> Result<(), VariableError> {
    require(scene.stack.base_thickness_m.is_none(), &["stack.base_thickness_m"], || {
        format!(
            "{} makes the scene a stack, and this study looks at one plate: set h_base = none, elements = 1",
            stated(scene, "stack.base_thickness_m")
        )
    })
}
