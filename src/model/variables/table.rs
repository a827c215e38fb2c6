//! The rows of the table of variables, in the order of the editor.

use super::{Allowed, Choice, Group, Kind, Number, Step, Variable};
use crate::model::scene::{ContactModel, InterfaceLaw, Jumps, Mount, Reading, StopKind};
use crate::model::units::Quantity;

/// A required number at a path of the scene.
macro_rules! number {
    ($quantity:ident, $allowed:expr, $thesis:expr, $step:ident, $($field:ident).+) => {
        Kind::Number(Number {
            quantity: Quantity::$quantity,
            allowed: $allowed,
            thesis_range: $thesis,
            step: Step::$step,
            absent: None,
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value.unwrap_or_default(),
        })
    };
}

/// An optional number at a path of the scene, with the word for its absence.
macro_rules! optional {
    ($quantity:ident, $allowed:expr, $absent:literal, $($field:ident).+) => {
        Kind::Number(Number {
            quantity: Quantity::$quantity,
            allowed: $allowed,
            thesis_range: None,
            step: Step::Linear,
            absent: Some($absent),
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = value,
        })
    };
}

/// A quirk of the listing: printed or mended.
macro_rules! quirk {
    ($field:ident, $symbol:literal, $meaning:literal, $where:literal) => {
        Variable {
            key: concat!("contact.appendix.", stringify!($field)),
            symbol: $symbol,
            aliases: &[],
            group: Group::Interface,
            meaning: $meaning,
            source: concat!("thesis Appendix ", $where),
            kind: Kind::Choice(Choice {
                words: &["printed", "mended"],
                get: |scene| usize::from(scene.contact.appendix.$field == Reading::Mended),
                set: |scene, index| {
                    scene.contact.appendix.$field =
                        if index == 0 { Reading::Printed } else { Reading::Mended };
                },
            }),
        }
    };
}

/// In the order of their words.
const MODELS: [ContactModel; 5] = [
    ContactModel::Hydrodynamic,
    ContactModel::HalfSine,
    ContactModel::InitialVelocity,
    ContactModel::Lumped,
    ContactModel::Appendix,
];

const TABLE_9_1: &str = "thesis Table 9.1";
const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";

/// Every variable there is.
pub static VARIABLES: &[Variable] = &[
    Variable {
        key: "projectile.mass_kg",
        symbol: "m_p",
        aliases: &[],
        group: Group::Projectile,
        meaning: "projectile mass",
        source: TABLE_9_1,
        kind: number!(Mass, Allowed::Positive, None, Linear, projectile.mass_kg),
    },
    Variable {
        key: "projectile.tip_radius_m",
        symbol: "R",
        aliases: &[],
        group: Group::Projectile,
        meaning: "radius of the hemispherical tip and of the body behind it",
        source: TABLE_9_1,
        kind: number!(Length, Allowed::Positive, None, Linear, projectile.tip_radius_m),
    },
    Variable {
        key: "projectile.velocity_m_s",
        symbol: "v_i",
        aliases: &["vi"],
        group: Group::Projectile,
        meaning: "impact velocity",
        source: TABLE_9_1,
        kind: number!(Velocity, Allowed::Positive, None, Linear, projectile.velocity_m_s),
    },
    Variable {
        key: "projectile.obliquity_deg",
        symbol: "theta",
        aliases: &[],
        group: Group::Projectile,
        meaning: "obliquity, between the projectile's axis and the plate's normal",
        source: "thesis Appendix A.1; 0 throughout chapter 9",
        kind: number!(Angle, Allowed::Below(0.0, 90.0), None, Linear, projectile.obliquity_deg),
    },
    Variable {
        key: "projectile.density_kg_m3",
        symbol: "rho_p",
        aliases: &[],
        group: Group::Projectile,
        meaning: "projectile density, for the warning of ricochet alone",
        source: "assumption: steel",
        kind: number!(Density, Allowed::Positive, None, Linear, projectile.density_kg_m3),
    },
    Variable {
        key: "projectile.strength_pa",
        symbol: "Y_p",
        aliases: &[],
        group: Group::Projectile,
        meaning: "projectile strength, for the warning of ricochet alone",
        source: "assumption: 1 GPa",
        kind: number!(Pressure, Allowed::Positive, None, Linear, projectile.strength_pa),
    },
    Variable {
        key: "target.thickness_m",
        symbol: "h",
        aliases: &[],
        group: Group::Target,
        meaning: "plate thickness",
        source: TABLE_9_1,
        kind: number!(Length, Allowed::Positive, None, Linear, target.thickness_m),
    },
    Variable {
        key: "target.density_kg_m3",
        symbol: "rho",
        aliases: &[],
        group: Group::Target,
        meaning: "plate density",
        source: "thesis Table 9.1 (the Appendix has 2780)",
        kind: number!(Density, Allowed::Positive, None, Linear, target.density_kg_m3),
    },
    Variable {
        key: "target.flow_strength_pa",
        symbol: "S_y",
        aliases: &["Sy"],
        group: Group::Target,
        meaning: "dynamic flow strength of the plate",
        source: "thesis Table 9.1 prints 1.52e7, a misprint: the Appendix has 2 x 75.8e6",
        kind: number!(Pressure, Allowed::NonNegative, None, Linear, target.flow_strength_pa),
    },
    Variable {
        key: "target.drag_coefficient",
        symbol: "C_d",
        aliases: &["Cd"],
        group: Group::Target,
        meaning: "drag coefficient: the inertial part of the contact force is C_d rho u^2 / 2",
        source: TABLE_9_1,
        kind: number!(Number, Allowed::NonNegative, None, Linear, target.drag_coefficient),
    },
    Variable {
        key: "target.dishing",
        symbol: "dishing",
        aliases: &[],
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
        aliases: &[],
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
        aliases: &[],
        group: Group::Plate,
        meaning: "mass ratio, plate mass over projectile mass",
        source: TABLE_9_2,
        kind: number!(Number, Allowed::Positive, Some((0.8, 7.0)), Linear, plate.mass_ratio),
    },
    Variable {
        key: "plate.cocking_m",
        symbol: "d",
        aliases: &[],
        group: Group::Plate,
        meaning: "cocking distance: the plate starts at x = -d, at rest",
        source: TABLE_9_2,
        kind: number!(Length, Allowed::NonNegative, Some((0.0, 0.5)), Linear, plate.cocking_m),
    },
    Variable {
        key: "mechanism.damper.coefficient",
        symbol: "b",
        aliases: &[],
        group: Group::Mechanism,
        meaning: "damper coefficient: the damper's force is b |w|^m sgn(w)",
        source: TABLE_9_2,
        kind: number!(
            DamperCoefficient,
            Allowed::NonNegative,
            Some((0.0, 2000.0)),
            Log,
            mechanism.damper.coefficient
        ),
    },
    Variable {
        key: "mechanism.damper.exponent",
        symbol: "m",
        aliases: &[],
        group: Group::Mechanism,
        meaning: "damper exponent",
        source: "thesis section 9.2.2: 1",
        kind: number!(Number, Allowed::Positive, None, Log, mechanism.damper.exponent),
    },
    Variable {
        key: "mechanism.spring.kind",
        symbol: "spring",
        aliases: &[],
        group: Group::Mechanism,
        meaning: "the spring's force law",
        source: "thesis equation 9.3",
        kind: Kind::Choice(Choice {
            words: &["power-law"],
            get: |_scene| 0,
            set: |scene, _index| {
                scene.mechanism.spring.kind = crate::model::scene::SpringKind::PowerLaw;
            },
        }),
    },
    Variable {
        key: "mechanism.spring.coefficient",
        symbol: "k",
        aliases: &[],
        group: Group::Mechanism,
        meaning: "spring coefficient: the spring's force is k |x|^n sgn(x)",
        source: "thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)",
        kind: number!(
            SpringCoefficient,
            Allowed::NonNegative,
            Some((0.0, 7.5e6)),
            Log,
            mechanism.spring.coefficient
        ),
    },
    Variable {
        key: "mechanism.spring.exponent",
        symbol: "n",
        aliases: &[],
        group: Group::Mechanism,
        meaning: "spring exponent",
        source: TABLE_9_2,
        kind: number!(Number, Allowed::Positive, Some((0.1, 3.0)), Log, mechanism.spring.exponent),
    },
    Variable {
        key: "mechanism.stop.position_m",
        symbol: "x_stop",
        aliases: &["stop"],
        group: Group::Stop,
        meaning: "where the plate meets a mechanical stop",
        source: "thesis sections 9.5.1 and 9.6",
        kind: optional!(Length, Allowed::Any, "none", mechanism.stop.position_m),
    },
    Variable {
        key: "mechanism.stop.kind",
        symbol: "stop_kind",
        aliases: &[],
        group: Group::Stop,
        meaning: "rigid: an impact with restitution; elastic: a one-sided spring and damper",
        source: "assumption: the thesis names no kind",
        kind: Kind::Choice(Choice {
            words: &["rigid", "elastic"],
            get: |scene| usize::from(scene.mechanism.stop.kind == StopKind::Elastic),
            set: |scene, index| {
                scene.mechanism.stop.kind =
                    if index == 0 { StopKind::Rigid } else { StopKind::Elastic };
            },
        }),
    },
    Variable {
        key: "mechanism.stop.restitution",
        symbol: "e",
        aliases: &[],
        group: Group::Stop,
        meaning: "restitution of a rigid stop: w becomes -e w",
        source: "assumption",
        kind: number!(Number, Allowed::Between(0.0, 1.0), None, Linear, mechanism.stop.restitution),
    },
    Variable {
        key: "mechanism.stop.stiffness_n_m",
        symbol: "k_stop",
        aliases: &[],
        group: Group::Stop,
        meaning: "stiffness of an elastic stop",
        source: "assumption",
        kind: number!(Stiffness, Allowed::Positive, None, Log, mechanism.stop.stiffness_n_m),
    },
    Variable {
        key: "mechanism.stop.damping_n_s_m",
        symbol: "b_stop",
        aliases: &[],
        group: Group::Stop,
        meaning: "damping of an elastic stop (it only pushes)",
        source: "assumption",
        kind: number!(Damping, Allowed::NonNegative, None, Log, mechanism.stop.damping_n_s_m),
    },
    Variable {
        key: "contact.model",
        symbol: "model",
        aliases: &[],
        group: Group::Interface,
        meaning: "how the force between projectile and plate is modelled",
        source: "thesis section 8.2 and Table 8.1",
        kind: Kind::Choice(Choice {
            words: &["hydrodynamic", "half-sine", "initial-velocity", "lumped", "appendix"],
            get: |scene| MODELS.iter().position(|it| *it == scene.contact.model).unwrap_or(0),
            set: |scene, index| {
                scene.contact.model = MODELS[index.min(MODELS.len() - 1)];
            },
        }),
    },
    Variable {
        key: "contact.duration_s",
        symbol: "t_d",
        aliases: &[],
        group: Group::Interface,
        meaning: "duration of the half-sine force history",
        source: "thesis equation 8.9; auto: the hydrodynamic contact on a rigid mount",
        kind: optional!(Time, Allowed::Positive, "auto", contact.duration_s),
    },
    Variable {
        key: "contact.load_stiffness_n_m",
        symbol: "k_load",
        aliases: &[],
        group: Group::Interface,
        meaning: "stiffness of the lumped interface while it is pressed in",
        source: "thesis Figure 8.6; auto: as deep as the hydrodynamic model on a rigid mount",
        kind: optional!(Stiffness, Allowed::Positive, "auto", contact.load_stiffness_n_m),
    },
    Variable {
        key: "contact.unload_stiffness_n_m",
        symbol: "k_unload",
        aliases: &[],
        group: Group::Interface,
        meaning: "stiffness of the lumped interface while it springs back, k_load or more",
        source: "thesis Figure 8.6; auto: 100 k_load, an assumption",
        kind: optional!(Stiffness, Allowed::Positive, "auto", contact.unload_stiffness_n_m),
    },
    Variable {
        key: "contact.damping_n_s_m",
        symbol: "b_2",
        aliases: &[],
        group: Group::Interface,
        meaning: "damper of the lumped interface",
        source: "thesis Figure 8.4; Wu has none",
        kind: number!(Damping, Allowed::NonNegative, None, Log, contact.damping_n_s_m),
    },
    Variable {
        key: "contact.appendix.step_s",
        symbol: "dt",
        aliases: &[],
        group: Group::Interface,
        meaning: "time step of the listing",
        source: "thesis Appendix A.1",
        kind: number!(Time, Allowed::Positive, None, Log, contact.appendix.step_s),
    },
    quirk!(
        coupling,
        "coupling",
        "depth subtracts the plate's last increment only, or (mended) its whole motion",
        "A.2"
    ),
    quirk!(
        damper,
        "dampsign",
        "the damper's force has no sign, or (mended) it resists",
        "A.7 and A.9"
    ),
    quirk!(
        stopping,
        "stopping",
        "contact ends below 0.01 m/s after a step, or (mended) where both velocities are equal",
        "A.2"
    ),
    quirk!(
        afterwards,
        "after",
        "both bodies are one afterwards, or (mended) not after a perforation",
        "A.5 and A.7"
    ),
    quirk!(
        scheme,
        "scheme",
        "the force is held over the step, or (mended) Runge-Kutta for both bodies",
        "A.4 and A.8"
    ),
    quirk!(
        obliquity,
        "oblique",
        "the whole force acts on both bodies, or (mended) it is resolved on the normal",
        "A.2 to A.4"
    ),
    Variable {
        key: "contact.appendix.jumps",
        symbol: "jumps",
        aliases: &[],
        group: Group::Interface,
        meaning: "whether the scripts' jumps are heeded, or (ignored) the area is overwritten once the nose is buried",
        source: "thesis Appendix A.2",
        kind: Kind::Choice(Choice {
            words: &["meant", "ignored"],
            get: |scene| usize::from(scene.contact.appendix.jumps == Jumps::Ignored),
            set: |scene, index| {
                scene.contact.appendix.jumps =
                    if index == 0 { Jumps::Meant } else { Jumps::Ignored };
            },
        }),
    },
    Variable {
        key: "interface.law",
        symbol: "interface",
        aliases: &["law"],
        group: Group::Interface,
        meaning: "fused: together for good once at common speed; plastic: it carries what its strength allows",
        source: "fused: the thesis; plastic: a rigid-plastic interface",
        kind: Kind::Choice(Choice {
            words: &["fused", "plastic"],
            get: |scene| usize::from(scene.interface.law == InterfaceLaw::Plastic),
            set: |scene, index| {
                scene.interface.law =
                    if index == 0 { InterfaceLaw::Fused } else { InterfaceLaw::Plastic };
            },
        }),
    },
    Variable {
        key: "interface.grip",
        symbol: "g",
        aliases: &["grip"],
        group: Group::Interface,
        meaning: "grip: the greatest pull of the interface is g A S_y",
        source: "assumption: 0.1",
        kind: number!(Number, Allowed::NonNegative, None, Linear, interface.grip),
    },
    Variable {
        key: "run.tolerance",
        symbol: "tol",
        aliases: &["tolerance"],
        group: Group::Run,
        meaning: "relative accuracy asked of depth and time",
        source: "default of this program",
        kind: number!(Number, Allowed::Between(1e-14, 1e-2), None, Log, run.tolerance),
    },
    Variable {
        key: "run.horizon_s",
        symbol: "horizon",
        aliases: &[],
        group: Group::Run,
        meaning: "the time the run goes on to",
        source: "absent: chosen from the scene",
        kind: optional!(Time, Allowed::Positive, "auto", run.horizon_s),
    },
];

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::VARIABLES;

    #[test]
    fn names_are_unique() {
        let mut seen = HashSet::new();
        for variable in VARIABLES {
            for name in [variable.symbol, variable.key].iter().chain(variable.aliases) {
                assert!(seen.insert(*name), "{name} twice");
            }
        }
    }
}
