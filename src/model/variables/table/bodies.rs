//! Projectile, target and plate.

use super::{TABLE_9_1, TABLE_9_2};
use crate::model::scene::{Closure, Mount, Nose, PlateSize};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, is_oblique, is_sprung, uses_target};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Variable, springs};

/// The input that defines the plate's size instead of gamma.
macro_rules! size {
    ($quantity:ident, $key:ident, $size:ident) => {
        variable!(
            plate.$key,
            Kind::Number(Number {
                absent: Some("none"),
                get: |scene| match scene.plate.size {
                    PlateSize::$size(value) => Some(value),
                    _ => None,
                },
                set: |scene, value| match (value, scene.plate.size) {
                    (Some(value), _) => scene.resize(PlateSize::$size(value)),
                    (None, PlateSize::$size(_)) => scene.resize(PlateSize::Ratio),
                    (None, _) => {}
                },
                ..Number::of(Quantity::$quantity, Allowed::Positive)
            })
        )
        .visible_when(Visible {
            listed: |scene| matches!(scene.plate.size, PlateSize::$size(_)),
            used: is_sprung,
        })
        .from("none: gamma gives the mass")
    };
}

pub(super) const ROWS: &[Variable] = &[
    sizing!(Mass, projectile.mass_kg)
        .named("m_p", "projectile mass")
        .means("projectile mass")
        .from(TABLE_9_1),
    number!(Length, Allowed::Positive, projectile.tip_radius_m)
        .named("R", "tip radius")
        .means("radius of the hemispherical tip and of the body behind it")
        .from(TABLE_9_1),
    number!(Velocity, Allowed::Positive, projectile.velocity_m_s)
        .named("v_i", "impact velocity")
        .also(&["vi"])
        .means("impact velocity")
        .from(TABLE_9_1),
    number!(Angle, Allowed::Below(0.0, 90.0), projectile.obliquity_deg)
        .named("theta", "obliquity")
        .means("obliquity, between the projectile's axis and the plate's normal")
        .from("thesis Appendix A.1; 0 throughout chapter 9"),
    number!(Density, Allowed::Positive, projectile.density_kg_m3)
        .named("rho_p", "density")
        .when(is_oblique)
        .means("projectile density, used for the ricochet warning only")
        .from("assumption: steel"),
    number!(Pressure, Allowed::Positive, projectile.strength_pa)
        .named("Y_p", "yield strength")
        .when(is_oblique)
        .means("projectile strength, used for the ricochet warning only")
        .from("assumption: 1 GPa"),
    choice!(Nose, projectile.nose)
    .named("nose", "nose shape")
    .listed_when(|scene| scene.projectile.nose != Nose::Hemispherical)
    .means("shape of the nose; the law is for a hemisphere, other shapes cause a warning")
    .from("assumption of the model"),
    sizing!(Length, target.thickness_m)
        .named("h", "plate thickness")
        .used_when(uses_target)
        .means("plate thickness")
        .from(TABLE_9_1),
    sizing!(Density, target.density_kg_m3)
        .named("rho", "plate density")
        .used_when(uses_target)
        .means("plate density")
        .from("thesis Table 9.1 (the Appendix has 2780)"),
    number!(Pressure, Allowed::NonNegative, target.flow_strength_pa)
        .named("S_y", "flow strength")
        .also(&["Sy"])
        .used_when(|scene| uses_target(scene) && scene.target.closure == Closure::Given)
        .means("dynamic flow strength of the plate")
        .from("thesis Table 9.1 prints 1.52e7, a misprint: the Appendix has 2 x 75.8e6"),
    choice!(Closure, target.closure)
    .named("closure", "source of S_y")
    .used_when(uses_target)
    .means("where S_y comes from: given, 2 Y (with dishing), or cavity expansion (without dishing)")
    .from("given: Table 9.1; double-yield: thesis 8.3.1; cavity: 2/3 Y (1 + ln(2 E/3 Y))"),
    number!(Pressure, Allowed::Positive, target.yield_pa)
        .named("Y", "yield strength")
        .visible_when(Visible {
            listed: |scene| scene.target.closure != Closure::Given,
            used: uses_target,
        })
        .means("static yield strength, for a closure")
        .from("thesis Appendix A.1: 75.8 MPa"),
    number!(Pressure, Allowed::Positive, target.modulus_pa)
        .named("E", "elastic modulus")
        .visible_when(Visible {
            listed: |scene| scene.target.closure == Closure::Cavity,
            used: uses_target,
        })
        .means("modulus of elasticity, for the closure by cavity expansion")
        .from("aluminium 2024; the thesis needs none"),
    number!(Number, Allowed::NonNegative, target.drag_coefficient)
        .named("C_d", "drag coefficient")
        .also(&["Cd"])
        .used_when(uses_target)
        .means("drag coefficient: the inertial part of the contact force is C_d rho u^2 / 2")
        .from(TABLE_9_1),
    variable!(
        target.dishing,
        Kind::Switch {
            get: |scene| scene.target.dishing,
            set: |scene, on| scene.target.dishing = on,
        }
    )
    .named("dishing", "dishing")
    .used_when(uses_target)
    .means("the plate's local bulge takes up about one projectile diameter of travel")
    .from("thesis section 8.3.1 and Appendix A.2"),
    choice!(Mount, plate.mount)
        .named("mount", "mount")
        .means("sprung: carried by spring and damper; rigid: it cannot move")
        .from("thesis section 9.3 (rigid: the baseline)"),
    variable!(
        plate.mass_ratio,
        Kind::Number(Number {
            get: |scene| Some(scene.plate.mass_ratio),
            set: |scene, value| {
                scene.plate.size = PlateSize::Ratio;
                scene.plate.mass_ratio = value.unwrap_or_default();
            },
            ..Number::of(Quantity::Number, Allowed::Positive)
        })
    )
    .searched(Some((0.8, 7.0)))
    .named("gamma", "mass ratio")
    .used_when(is_sprung)
    .means("mass ratio, plate mass over projectile mass")
    .from(TABLE_9_2),
    size!(Mass, mass_kg, Mass)
        .named("m_2", "plate mass")
        .also(&["m2"])
        .means("plate mass; gamma = m_2/m_p follows from it"),
    size!(Length, face_m, Face)
        .named("face", "plate side")
        .means("side of the plate's square face; gamma = rho h face^2/m_p follows from it"),
    number!(Length, Allowed::NonNegative, plate.cocking_m)
        .named("d", "cocking distance")
        .searched(Some((0.0, 0.5)))
        .used_when(|scene| is_sprung(scene) && springs::acts(&scene.mechanism))
        .means("cocking distance: the plate starts at x = -d, at rest")
        .from(TABLE_9_2),
];
