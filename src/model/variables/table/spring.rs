//! A spring and everything its kinds need: the same rows for the first spring and for the second.

use crate::model::scene::{Combination, OwnMass, Scene, Spring, SpringKind};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, has_force, has_wire, is_sprung};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Step, Variable};

/// Where a row of a spring matters: where the spring is present and of a kind, and, to have an effect, more.
macro_rules! of_spring {
    ($field:ident, $present:ident, $kind:expr) => {
        of_spring!($field, $present, $kind, |_| true)
    };
    ($field:ident, $present:ident, $kind:expr, $acts:expr) => {
        Visible {
            listed: |scene| {
                let kind: fn(&Spring) -> bool = $kind;
                $present(scene) && kind(&scene.mechanism.$field)
            },
            used: |scene| {
                let (kind, acts): (fn(&Spring) -> bool, fn(&Spring) -> bool) = ($kind, $acts);
                let spring = &scene.mechanism.$field;
                is_sprung(scene) && $present(scene) && kind(spring) && acts(spring)
            },
        }
    };
}

/// The rows of one spring; `$suffix` tells its symbols from those of the other.
macro_rules! spring_rows {
    ($field:ident, $suffix:literal, $present:ident, $k_range:expr, $n_range:expr) => {
        &[
            Variable {
                key: concat!("mechanism.", stringify!($field), ".kind"),
                symbol: concat!("spring", $suffix),
                label: "force law",
                aliases: &[],
                visible: of_spring!($field, $present, |_| true),
                group: Group::Mechanism,
                meaning: "the spring's force law",
                source: "thesis equation 9.3, chapters 5 and 6",
                kind: Kind::Choice(Choice {
                    words: &SpringKind::WORDS,
                    get: |scene| {
                        let kind = scene.mechanism.$field.kind;
                        SpringKind::ALL.iter().position(|it| *it == kind).unwrap_or(0)
                    },
                    set: |scene, index| {
                        let last = SpringKind::ALL.len() - 1;
                        scene.mechanism.$field.kind = SpringKind::ALL[index.min(last)];
                    },
                }),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".coefficient"),
                symbol: concat!("k", $suffix),
                label: "stiffness",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::PowerLaw),
                group: Group::Mechanism,
                meaning: "spring coefficient: the spring's force is k |x|^n sgn(x)",
                source: "thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)",
                kind: number!(SpringCoefficient, Allowed::NonNegative, $k_range, Log, mechanism.$field.coefficient),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".exponent"),
                symbol: concat!("n", $suffix),
                label: "exponent",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| matches!(spring.kind, SpringKind::PowerLaw | SpringKind::Normalised), has_force),
                group: Group::Mechanism,
                meaning: "spring exponent",
                source: "thesis Table 9.2 (range searched)",
                kind: number!(Number, Allowed::Positive, $n_range, Log, mechanism.$field.exponent),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".count"),
                symbol: concat!("N_spring", $suffix),
                label: "springs",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind != SpringKind::PowerLaw || !spring.is_single()),
                group: Group::Mechanism,
                meaning: "how many equal springs act side by side",
                source: "thesis Figure 6.9; 1 unless given",
                kind: number!(Number, Allowed::Positive, None, Linear, mechanism.$field.count),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".own_mass"),
                symbol: concat!("own_mass", $suffix),
                label: "spring inertia",
                aliases: &[],
                visible: of_spring!($field, $present, |_| true),
                group: Group::Mechanism,
                meaning: "whether the part of the spring that moves with the plate adds to its mass",
                source: "thesis section 8.3.1: springs are massless",
                kind: Kind::Choice(Choice {
                    words: &["ignored", "counted"],
                    get: |scene| {
                        usize::from(scene.mechanism.$field.own_mass == OwnMass::Counted)
                    },
                    set: |scene, index| {
                        scene.mechanism.$field.own_mass =
                            if index == 0 { OwnMass::Ignored } else { OwnMass::Counted };
                    },
                }),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".mass_kg"),
                symbol: concat!("m_spring", $suffix),
                label: "spring mass",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.own_mass == OwnMass::Counted || spring.mass_kg.is_some()),
                group: Group::Mechanism,
                meaning: "the spring's whole mass",
                source: "auto: of its beams, or 4 rho G U/tau^2 (thesis section 9.5.1)",
                kind: optional!(Mass, Allowed::NonNegative, "auto", mechanism.$field.mass_kg),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".normalised.force_n"),
                symbol: concat!("F_ref", $suffix),
                label: "reference force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Normalised),
                group: Group::Mechanism,
                meaning: "force of the normalised power law at x_ref: F_ref |x/x_ref|^n sgn(x)",
                source: "assumption: the law that no unit changes",
                kind: number!(Force, Allowed::NonNegative, None, Log, mechanism.$field.normalised.force_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".normalised.displacement_m"),
                symbol: concat!("x_ref", $suffix),
                label: "reference travel",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Normalised),
                group: Group::Mechanism,
                meaning: "displacement at which the normalised power law has the force F_ref",
                source: "assumption",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.normalised.displacement_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.length_m"),
                symbol: concat!("l_beam", $suffix),
                label: "beam length",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "length of a beam",
                source: "thesis Table 9.3",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.beam.length_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.width_m"),
                symbol: concat!("w_beam", $suffix),
                label: "beam width",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "width of a beam, across the bending",
                source: "thesis Table 9.3",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.beam.width_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.height_m"),
                symbol: concat!("h_beam", $suffix),
                label: "beam height",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "height of a beam, in the direction of bending",
                source: "thesis Table 9.3",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.beam.height_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.modulus_pa"),
                symbol: concat!("E_beam", $suffix),
                label: "beam modulus",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "modulus of elasticity of a beam",
                source: "thesis Table 9.3: titanium 6-4",
                kind: number!(Pressure, Allowed::Positive, None, Linear, mechanism.$field.beam.modulus_pa),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.yield_pa"),
                symbol: concat!("Y_beam", $suffix),
                label: "beam strength",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "yield strength of a beam",
                source: "thesis Table 9.3: titanium 6-4",
                kind: number!(Pressure, Allowed::Positive, None, Linear, mechanism.$field.beam.yield_pa),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".beam.density_kg_m3"),
                symbol: concat!("rho_beam", $suffix),
                label: "beam density",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind.is_beam()),
                group: Group::Mechanism,
                meaning: "density of a beam",
                source: "titanium 6-4; Table 9.3 does not give it",
                kind: number!(Density, Allowed::Positive, None, Linear, mechanism.$field.beam.density_kg_m3),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".bistable.second_m"),
                symbol: concat!("x_2", $suffix),
                label: "second position",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable),
                group: Group::Mechanism,
                meaning: "second stable position; the first is x = 0",
                source: "assumption: the thesis gives no values",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.bistable.second_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".bistable.unstable_m"),
                symbol: concat!("x_u", $suffix),
                label: "unstable point",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable),
                group: Group::Mechanism,
                meaning: "unstable position between the stable ones: near 0 means much energy stored in the first",
                source: "absent: midway, both equally deep",
                kind: optional!(Length, Allowed::Positive, "midway", mechanism.$field.bistable.unstable_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".bistable.barrier_n"),
                symbol: concat!("F_bar", $suffix),
                label: "barrier force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable),
                group: Group::Mechanism,
                meaning: "greatest force on the way out of the first stable position",
                source: "assumption: the thesis gives no values",
                kind: number!(Force, Allowed::Positive, None, Log, mechanism.$field.bistable.barrier_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".constant.force_n"),
                symbol: concat!("F_c", $suffix),
                label: "constant force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::ConstantForce),
                group: Group::Mechanism,
                meaning: "the constant force",
                source: "assumption: the thesis gives no values",
                kind: number!(Force, Allowed::NonNegative, None, Log, mechanism.$field.constant.force_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".constant.rise_m"),
                symbol: concat!("x_c", $suffix),
                label: "ramp length",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::ConstantForce),
                group: Group::Mechanism,
                meaning: "displacement over which the constant force is reached",
                source: "assumption",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.constant.rise_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".column.stiffness_n_m"),
                symbol: concat!("k_col", $suffix),
                label: "column stiffness",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Column),
                group: Group::Mechanism,
                meaning: "stiffness of the column before it buckles",
                source: "assumption: the thesis gives no values",
                kind: number!(Stiffness, Allowed::Positive, None, Log, mechanism.$field.column.stiffness_n_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".column.critical_n"),
                symbol: concat!("F_crit", $suffix),
                label: "buckling force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Column),
                group: Group::Mechanism,
                meaning: "force at which the column buckles",
                source: "assumption: the thesis gives no values",
                kind: number!(Force, Allowed::Positive, None, Log, mechanism.$field.column.critical_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".column.plateau_n"),
                symbol: concat!("F_plat", $suffix),
                label: "plateau force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Column),
                group: Group::Mechanism,
                meaning: "force of the buckled column",
                source: "assumption",
                kind: number!(Force, Allowed::NonNegative, None, Log, mechanism.$field.column.plateau_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".column.fall_m"),
                symbol: concat!("x_fall", $suffix),
                label: "fall length",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Column),
                group: Group::Mechanism,
                meaning: "displacement over which the force goes from F_crit to F_plat",
                source: "assumption",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.column.fall_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".helix.stiffness_n_m"),
                symbol: concat!("k_helix", $suffix),
                label: "helix stiffness",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix),
                group: Group::Mechanism,
                meaning: "axial stiffness of the helical rotating spring",
                source: "assumption: the thesis gives no values",
                kind: number!(Stiffness, Allowed::NonNegative, None, Log, mechanism.$field.helix.stiffness_n_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".helix.twist_rad_m"),
                symbol: concat!("twist", $suffix),
                label: "twist",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix),
                group: Group::Mechanism,
                meaning: "turn of the plate per displacement, rad/m",
                source: "assumption",
                kind: number!(Number, Allowed::Any, None, Linear, mechanism.$field.helix.twist_rad_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".helix.inertia_kg_m2"),
                symbol: concat!("I_z", $suffix),
                label: "inertia",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix),
                group: Group::Mechanism,
                meaning: "moment of inertia of what turns, kg m2: the plate gains I_z twist^2",
                source: "thesis section 6.2.7; values are assumptions",
                kind: number!(Number, Allowed::NonNegative, None, Log, mechanism.$field.helix.inertia_kg_m2),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".crush.force_n"),
                symbol: concat!("F_crush", $suffix),
                label: "crush force",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush),
                group: Group::Mechanism,
                meaning: "force at which the absorber is crushed",
                source: "assumption",
                kind: number!(Force, Allowed::Positive, None, Log, mechanism.$field.crush.force_n),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".crush.stroke_m"),
                symbol: concat!("x_crush", $suffix),
                label: "crush length",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush),
                group: Group::Mechanism,
                meaning: "displacement at which the absorber is flat and solid",
                source: "assumption",
                kind: number!(Length, Allowed::Positive, None, Linear, mechanism.$field.crush.stroke_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".crush.stiffness_n_m"),
                symbol: concat!("k_crush", $suffix),
                label: "crush stiffness",
                aliases: &[],
                visible: of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush),
                group: Group::Mechanism,
                meaning: "stiffness before the absorber is crushed and when it unloads",
                source: "assumption",
                kind: number!(Stiffness, Allowed::Positive, None, Log, mechanism.$field.crush.stiffness_n_m),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".wire.density_kg_m3"),
                symbol: concat!("rho_wire", $suffix),
                label: "wire density",
                aliases: &[],
                visible: of_spring!($field, $present, has_wire),
                group: Group::Mechanism,
                meaning: "density of the wire",
                source: "spring steel",
                kind: number!(Density, Allowed::Positive, None, Linear, mechanism.$field.wire.density_kg_m3),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".wire.shear_modulus_pa"),
                symbol: concat!("G_wire", $suffix),
                label: "shear modulus",
                aliases: &[],
                visible: of_spring!($field, $present, has_wire),
                group: Group::Mechanism,
                meaning: "shear modulus of the wire",
                source: "spring steel",
                kind: number!(Pressure, Allowed::Positive, None, Linear, mechanism.$field.wire.shear_modulus_pa),
            },
            Variable {
                key: concat!("mechanism.", stringify!($field), ".wire.shear_strength_pa"),
                symbol: concat!("tau_wire", $suffix),
                label: "wire strength",
                aliases: &[],
                visible: of_spring!($field, $present, has_wire),
                group: Group::Mechanism,
                meaning: "shear stress the wire may have",
                source: "spring steel",
                kind: number!(Pressure, Allowed::Positive, None, Linear, mechanism.$field.wire.shear_strength_pa),
            },
        ]
    };
}

/// How many of the first rows a plain power law has.
pub(super) const PLAIN: usize = 3;

/// The first spring.
pub(super) const FIRST: &[Variable] =
    spring_rows!(spring, "", always, Some((0.0, 7.5e6)), Some((0.1, 3.0)));

/// The second, where two are combined.
pub(super) const SECOND: &[Variable] = spring_rows!(second, "_2", is_combined, None, None);

fn always(_: &Scene) -> bool {
    true
}

fn is_combined(scene: &Scene) -> bool {
    scene.mechanism.combination != Combination::Alone
}
