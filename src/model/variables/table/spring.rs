//! A spring and everything its kinds need: the same rows for the first spring and for the second.

use crate::model::scene::{Combination, OwnMass, Scene, Spring, SpringKind};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, has_force, has_wire, is_sprung};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Variable};

/// A slice of rows in groups. Each group begins with the springs to which it belongs, and among them those in which its rows have
/// an effect; each row has its kind, its path in the spring, its symbol, label and meaning, and what else there is to say of it.
macro_rules! rows {
    ($field:ident $suffix:literal $present:ident; $(
        $of_kind:expr, $acts:expr => {$(
            $kind:ident($($quantity:tt)*) $($path:ident).+: $symbol:literal, $label:literal, $meaning:literal
                $(.$more:ident($($value:expr)?))*;
        )+}
    )+) => {
        &[$($(
            $kind!($($quantity)*, mechanism.$field.$($path).+)
                .named(concat!($symbol, $suffix), $label)
                .means($meaning)
                .visible_when(Visible {
                    listed: |scene| {
                        let of_kind: fn(&Spring) -> bool = $of_kind;
                        $present(scene) && of_kind(&scene.mechanism.$field)
                    },
                    used: |scene| {
                        let conditions: [fn(&Spring) -> bool; 2] = [$of_kind, $acts];
                        let spring = &scene.mechanism.$field;
                        is_sprung(scene) && $present(scene) && conditions.iter().all(|holds| holds(spring))
                    },
                })
                $(.$more($($value)?))*,
        )+)+]
    };
}

/// The rows of one spring; `$suffix` distinguishes its symbols from those of the other.
macro_rules! spring_rows {
    ($field:ident, $suffix:literal, $present:ident, $k_range:expr, $n_range:expr) => {
        rows! { $field $suffix $present;
            always, always => {
                choice(SpringKind) kind: "spring", "force law", "the spring's force law"
                    .from("thesis equation 9.3, chapters 5 and 6");
            }
            |spring| spring.kind == SpringKind::PowerLaw, always => {
                number(SpringCoefficient, Allowed::NonNegative) coefficient: "k", "stiffness",
                    "spring coefficient: the spring's force is k |x|^n sgn(x)"
                    .searched($k_range)
                    .log()
                    .from("thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)");
            }
            |spring| matches!(spring.kind, SpringKind::PowerLaw | SpringKind::Normalised), has_force => {
                number(Number, Allowed::Positive) exponent: "n", "exponent", "spring exponent"
                    .searched($n_range)
                    .log()
                    .from("thesis Table 9.2 (range searched)");
            }
            |spring| spring.kind != SpringKind::PowerLaw || !spring.is_single(), always => {
                number(Number, Allowed::Positive) count: "N_spring", "springs", "number of equal springs that act in parallel"
                    .from("thesis Figure 6.9; 1 unless given");
            }
            always, always => {
                choice(OwnMass) own_mass: "own_mass", "spring inertia",
                    "whether the part of the spring that moves with the plate adds to its mass"
                    .from("thesis section 8.3.1: springs are massless");
            }
            |spring| spring.own_mass == OwnMass::Counted || spring.mass_kg.is_some(), always => {
                optional(Mass, Allowed::NonNegative, "auto") mass_kg: "m_spring", "spring mass", "the spring's whole mass"
                    .from("auto: of its beams, or 4 rho G U/tau^2 (thesis section 9.5.1)");
            }
            |spring| spring.kind == SpringKind::Normalised, always => {
                number(Force, Allowed::NonNegative) normalised.force_n: "F_ref", "reference force",
                    "force of the normalised power law at x_ref: F_ref |x/x_ref|^n sgn(x)"
                    .log()
                    .from("assumption: the law that no unit changes");
                number(Length, Allowed::Positive) normalised.displacement_m: "x_ref", "reference travel",
                    "displacement at which the normalised power law has the force F_ref";
            }
            |spring| spring.kind.is_beam(), always => {
                number(Length, Allowed::Positive) beam.length_m: "l_beam", "beam length", "length of a beam"
                    .from(TABLE_9_3);
                number(Length, Allowed::Positive) beam.width_m: "w_beam", "beam width", "width of a beam, across the bending"
                    .from(TABLE_9_3);
                number(Length, Allowed::Positive) beam.height_m: "h_beam", "beam height",
                    "height of a beam, in the direction of bending"
                    .from(TABLE_9_3);
                number(Pressure, Allowed::Positive) beam.modulus_pa: "E_beam", "beam modulus", "modulus of elasticity of a beam"
                    .from("thesis Table 9.3: titanium 6-4");
                number(Pressure, Allowed::Positive) beam.yield_pa: "Y_beam", "beam strength", "yield strength of a beam"
                    .from("thesis Table 9.3: titanium 6-4");
                number(Density, Allowed::Positive) beam.density_kg_m3: "rho_beam", "beam density", "density of a beam"
                    .from("titanium 6-4; Table 9.3 does not give it");
            }
            |spring| spring.kind == SpringKind::Bistable, always => {
                number(Length, Allowed::Positive) bistable.second_m: "x_2", "second position",
                    "second stable position; the first is x = 0"
                    .from(NO_VALUES);
                optional(Length, Allowed::Positive, "midway") bistable.unstable_m: "x_u", "unstable point",
                    "unstable position between the stable ones: near 0 means much energy stored in the first"
                    .from("absent: midway, both equally deep");
                number(Force, Allowed::Positive) bistable.barrier_n: "F_bar", "barrier force",
                    "greatest force on the way out of the first stable position"
                    .log()
                    .from(NO_VALUES);
            }
            |spring| spring.kind == SpringKind::ConstantForce, always => {
                number(Force, Allowed::NonNegative) constant.force_n: "F_c", "constant force", "the constant force"
                    .log()
                    .from(NO_VALUES);
                number(Length, Allowed::Positive) constant.rise_m: "x_c", "ramp length",
                    "displacement over which the constant force is reached";
            }
            |spring| spring.kind == SpringKind::Column, always => {
                number(Stiffness, Allowed::Positive) column.stiffness_n_m: "k_col", "column stiffness",
                    "stiffness of the column before it buckles"
                    .log()
                    .from(NO_VALUES);
                number(Force, Allowed::Positive) column.critical_n: "F_crit", "buckling force", "force at which the column buckles"
                    .log()
                    .from(NO_VALUES);
                number(Force, Allowed::NonNegative) column.plateau_n: "F_plat", "plateau force", "force of the buckled column"
                    .log();
                number(Length, Allowed::Positive) column.fall_m: "x_fall", "fall length",
                    "displacement over which the force goes from F_crit to F_plat";
            }
            |spring| spring.kind == SpringKind::Helix, always => {
                number(Stiffness, Allowed::NonNegative) helix.stiffness_n_m: "k_helix", "helix stiffness",
                    "axial stiffness of the helical rotating spring"
                    .log()
                    .from(NO_VALUES);
                number(Number, Allowed::Any) helix.twist_rad_m: "twist", "twist", "turn of the plate per displacement, rad/m";
                number(Number, Allowed::NonNegative) helix.inertia_kg_m2: "I_z", "inertia",
                    "moment of inertia of what turns, kg m2: the plate gains I_z twist^2"
                    .log()
                    .from("thesis section 6.2.7; values are assumptions");
            }
            |spring| spring.kind == SpringKind::Crush, always => {
                number(Force, Allowed::Positive) crush.force_n: "F_crush", "crush force", "force at which the absorber is crushed"
                    .log();
                number(Length, Allowed::Positive) crush.stroke_m: "x_crush", "crush length",
                    "displacement at which the absorber is flat and solid";
                number(Stiffness, Allowed::Positive) crush.stiffness_n_m: "k_crush", "crush stiffness",
                    "stiffness before the absorber is crushed and when it unloads"
                    .log();
            }
            has_wire, always => {
                number(Density, Allowed::Positive) wire.density_kg_m3: "rho_wire", "wire density", "density of the wire"
                    .from("spring steel");
                number(Pressure, Allowed::Positive) wire.shear_modulus_pa: "G_wire", "shear modulus", "shear modulus of the wire"
                    .from("spring steel");
                number(Pressure, Allowed::Positive) wire.shear_strength_pa: "tau_wire", "wire strength",
                    "shear stress the wire may have"
                    .from("spring steel");
            }
        }
    };
}

const TABLE_9_3: &str = "thesis Table 9.3";
const NO_VALUES: &str = "assumption: the thesis gives no values";

/// How many of the first rows a plain power law has.
pub(super) const PLAIN: usize = 3;

pub(super) const FIRST: &[Variable] =
    spring_rows!(spring, "", is_first, Some((0.0, 7.5e6)), Some((0.1, 3.0)));

/// The second, where two are combined.
pub(super) const SECOND: &[Variable] = spring_rows!(second, "_2", is_combined, None, None);

fn always(_: &Spring) -> bool {
    true
}

fn is_first(_: &Scene) -> bool {
    true
}

fn is_combined(scene: &Scene) -> bool {
    scene.mechanism.combination != Combination::Alone
}
