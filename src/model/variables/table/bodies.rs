//! What strikes, and what is struck.

use super::{TABLE_9_1, TABLE_9_2};
use crate::model::scene::{Closure, Mount, Nose, PlateSize};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, is_oblique, is_sprung, uses_target};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Step, Variable, springs};

/// Projectile, target and plate.
pub(super) const ROWS: &[Variable] = &[
    Variable {
        key: "projectile.mass_kg",
        symbol: "m_p",
        label: "projectile mass",
        aliases: &[],
        visible: Visible::ALWAYS,
        group: Group::Projectile,
        meaning: "projectile mass",
        source: TABLE_9_1,
        kind: sizing!(Mass, projectile.mass_kg),
    },
    Variable {
        key: "projectile.tip_radius_m",
        symbol: "R",
        label: "tip radius",
        aliases: &[],
        visible: Visible::ALWAYS,
        group: Group::Projectile,
        meaning: "radius of the hemispherical tip and of the body behind it",
        source: TABLE_9_1,
        kind: number!(Length, Allowed::Positive, None, Linear, projectile.tip_radius_m),
    },
    Variable {
        key: "projectile.velocity_m_s",
        symbol: "v_i",
        label: "impact velocity",
        aliases: &["vi"],
        visible: Visible::ALWAYS,
        group: Group::Projectile,
        meaning: "impact velocity",
        source: TABLE_9_1,
        kind: number!(Velocity, Allowed::Positive, None, Linear, projectile.velocity_m_s),
    },
    Variable {
        key: "projectile.obliquity_deg",
        symbol: "theta",
        label: "obliquity",
        aliases: &[],
        visible: Visible::ALWAYS,
        group: Group::Projectile,
        meaning: "obliquity, between the projectile's axis and the plate's normal",
        source: "thesis Appendix A.1; 0 throughout chapter 9",
        kind: number!(Angle, Allowed::Below(0.0, 90.0), None, Linear, projectile.obliquity_deg),
    },
    Variable {
        key: "projectile.density_kg_m3",
        symbol: "rho_p",
        label: "density",
        aliases: &[],
        visible: Visible::when(is_oblique),
        group: Group::Projectile,
        meaning: "projectile density, for the warning of ricochet alone",
        source: "assumption: steel",
        kind: number!(Density, Allowed::Positive, None, Linear, projectile.density_kg_m3),
    },
    Variable {
        key: "projectile.strength_pa",
        symbol: "Y_p",
        label: "yield strength",
        aliases: &[],
        visible: Visible::when(is_oblique),
        group: Group::Projectile,
        meaning: "projectile strength, for the warning of ricochet alone",
        source: "assumption: 1 GPa",
        kind: number!(Pressure, Allowed::Positive, None, Linear, projectile.strength_pa),
    },
    Variable {
        key: "projectile.nose",
        symbol: "nose",
        label: "nose shape",
        aliases: &[],
        visible: Visible::listed_when(|scene| scene.projectile.nose != Nose::Hemispherical),
        group: Group::Projectile,
        meaning: "shape of the nose; the law is for a hemisphere, the others only earn a warning",
        source: "assumption of the model",
        kind: Kind::Choice(Choice {
            words: &["hemispherical", "pointed", "blunt"],
            get: |scene| scene.projectile.nose as usize,
            set: |scene, index| {
                scene.projectile.nose =
                    [Nose::Hemispherical, Nose::Pointed, Nose::Blunt][index.min(2)];
            },
        }),
    },
    Variable {
        key: "target.thickness_m",
        symbol: "h",
        label: "plate thickness",
        aliases: &[],
        visible: Visible::used_when(uses_target),
        group: Group::Target,
        meaning: "plate thickness",
        source: TABLE_9_1,
        kind: sizing!(Length, target.thickness_m),
    },
    Variable {
        key: "target.density_kg_m3",
        symbol: "rho",
        label: "plate density",
        aliases: &[],
        visible: Visible::used_when(uses_target),
        group: Group::Target,
        meaning: "plate density",
        source: "thesis Table 9.1 (the Appendix has 2780)",
        kind: sizing!(Density, target.density_kg_m3),
    },
    Variable {
        key: "target.flow_strength_pa",
        symbol: "S_y",
        label: "flow strength",
        aliases: &["Sy"],
        visible: Visible::used_when(|scene| {
            uses_target(scene) && scene.target.closure == Closure::Given
        }),
        group: Group::Target,
        meaning: "dynamic flow strength of the plate",
        source: "thesis Table 9.1 prints 1.52e7, a misprint: the Appendix has 2 x 75.8e6",
        kind: number!(Pressure, Allowed::NonNegative, None, Linear, target.flow_strength_pa),
    },
    Variable {
        key: "target.closure",
        symbol: "closure",
        label: "source of S_y",
        aliases: &[],
        visible: Visible::used_when(uses_target),
        group: Group::Target,
        meaning: "where S_y comes from: given, 2 Y (with dishing), or cavity expansion (without dishing)",
        source: "given: Table 9.1; double-yield: thesis 8.3.1; cavity: 2/3 Y (1 + ln(2 E/3 Y))",
        kind: Kind::Choice(Choice {
            words: &["given", "double-yield", "cavity"],
            get: |scene| match scene.target.closure {
                Closure::Given => 0,
                Closure::DoubleYield => 1,
                Closure::Cavity => 2,
            },
            set: |scene, index| {
                scene.target.closure =
                    [Closure::Given, Closure::DoubleYield, Closure::Cavity][index.min(2)];
            },
        }),
    },
    Variable {
        key: "target.yield_pa",
        symbol: "Y",
        label: "yield strength",
        aliases: &[],
        visible: Visible {
            listed: |scene| scene.target.closure != Closure::Given,
            used: uses_target,
        },
        group: Group::Target,
        meaning: "static yield strength, for a closure",
        source: "thesis Appendix A.1: 75.8 MPa",
        kind: number!(Pressure, Allowed::Positive, None, Linear, target.yield_pa),
    },
    Variable {
        key: "target.modulus_pa",
        symbol: "E",
        label: "elastic modulus",
        aliases: &[],
        visible: Visible {
            listed: |scene| scene.target.closure == Closure::Cavity,
            used: uses_target,
        },
        group: Group::Target,
        meaning: "modulus of elasticity, for the closure by cavity expansion",
        source: "aluminium 2024; the thesis needs none",
        kind: number!(Pressure, Allowed::Positive, None, Linear, target.modulus_pa),
    },
    Variable {
        key: "target.drag_coefficient",
        symbol: "C_d",
        label: "drag coefficient",
        aliases: &["Cd"],
        visible: Visible::used_when(uses_target),
        group: Group::Target,
        meaning: "drag coefficient: the inertial part of the contact force is C_d rho u^2 / 2",
        source: TABLE_9_1,
        kind: number!(Number, Allowed::NonNegative, None, Linear, target.drag_coefficient),
    },
    Variable {
        key: "target.dishing",
        symbol: "dishing",
        label: "dishing",
        aliases: &[],
        visible: Visible::used_when(uses_target),
        group: Group::Target,
        meaning: "the plate's local bulge takes up about one projectile diameter of travel",
        source: "thesis section 8.3.1 and Appendix A.2",
        kind: Kind::Switch {
            get: |scene| scene.target.dishing,
            set: |scene, on| scene.target.dishing = on,
        },
    },
    Variable {
        key: "plate.mount",
        symbol: "mount",
        label: "mount",
        aliases: &[],
        visible: Visible::ALWAYS,
        group: Group::Plate,
        meaning: "sprung: carried by spring and damper; rigid: it cannot move",
        source: "thesis section 9.3 (rigid: the baseline)",
        kind: Kind::Choice(Choice {
            words: &["sprung", "rigid"],
            get: |scene| usize::from(scene.plate.mount == Mount::Rigid),
            set: |scene, index| {
                scene.plate.mount = if index == 0 { Mount::Sprung } else { Mount::Rigid };
            },
        }),
    },
    Variable {
        key: "plate.mass_ratio",
        symbol: "gamma",
        label: "mass ratio",
        aliases: &[],
        visible: Visible::used_when(is_sprung),
        group: Group::Plate,
        meaning: "mass ratio, plate mass over projectile mass",
        source: TABLE_9_2,
        kind: Kind::Number(Number {
            quantity: Quantity::Number,
            allowed: Allowed::Positive,
            thesis_range: Some((0.8, 7.0)),
            step: Step::Linear,
            absent: None,
            get: |scene| Some(scene.plate.mass_ratio),
            set: |scene, value| {
                scene.plate.size = PlateSize::Ratio;
                scene.plate.mass_ratio = value.unwrap_or_default();
            },
        }),
    },
    Variable {
        key: "plate.mass_kg",
        symbol: "m_2",
        label: "plate mass",
        aliases: &["m2"],
        visible: Visible {
            listed: |scene| matches!(scene.plate.size, PlateSize::Mass(_)),
            used: is_sprung,
        },
        group: Group::Plate,
        meaning: "plate mass; gamma = m_2/m_p follows from it",
        source: "none: gamma gives the mass",
        kind: Kind::Number(Number {
            quantity: Quantity::Mass,
            allowed: Allowed::Positive,
            thesis_range: None,
            step: Step::Linear,
            absent: Some("none"),
            get: |scene| match scene.plate.size {
                PlateSize::Mass(kg) => Some(kg),
                PlateSize::Ratio | PlateSize::Face(_) => None,
            },
            set: |scene, value| match (value, scene.plate.size) {
                (Some(kg), _) => scene.resize(PlateSize::Mass(kg)),
                (None, PlateSize::Mass(_)) => scene.resize(PlateSize::Ratio),
                (None, PlateSize::Ratio | PlateSize::Face(_)) => {}
            },
        }),
    },
    Variable {
        key: "plate.face_m",
        symbol: "face",
        label: "plate side",
        aliases: &[],
        visible: Visible {
            listed: |scene| matches!(scene.plate.size, PlateSize::Face(_)),
            used: is_sprung,
        },
        group: Group::Plate,
        meaning: "side of the plate's square face; gamma = rho h face^2/m_p follows from it",
        source: "none: gamma gives the mass",
        kind: Kind::Number(Number {
            quantity: Quantity::Length,
            allowed: Allowed::Positive,
            thesis_range: None,
            step: Step::Linear,
            absent: Some("none"),
            get: |scene| match scene.plate.size {
                PlateSize::Face(side_m) => Some(side_m),
                PlateSize::Ratio | PlateSize::Mass(_) => None,
            },
            set: |scene, value| match (value, scene.plate.size) {
                (Some(side_m), _) => scene.resize(PlateSize::Face(side_m)),
                (None, PlateSize::Face(_)) => scene.resize(PlateSize::Ratio),
                (None, PlateSize::Ratio | PlateSize::Mass(_)) => {}
            },
        }),
    },
    Variable {
        key: "plate.cocking_m",
        symbol: "d",
        label: "cocking distance",
        aliases: &[],
        visible: Visible::used_when(|scene| is_sprung(scene) && springs::acts(&scene.mechanism)),
        group: Group::Plate,
        meaning: "cocking distance: the plate starts at x = -d, at rest",
        source: TABLE_9_2,
        kind: number!(Length, Allowed::NonNegative, Some((0.0, 0.5)), Linear, plate.cocking_m),
    },
];
