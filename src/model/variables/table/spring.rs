//! A spring and everything its kinds need: the same rows for the first spring and for the second.

use crate::model::scene::{Combination, OwnMass, Scene, Spring, SpringKind};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, has_force, has_wire, is_sprung};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Variable};

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
            choice!(SpringKind, mechanism.$field.kind)
                .named(concat!("spring", $suffix), "force law")
                .visible_when(of_spring!($field, $present, |_| true))
                .means("the spring's force law")
                .from("thesis equation 9.3, chapters 5 and 6"),
            number!(SpringCoefficient, Allowed::NonNegative, mechanism.$field.coefficient)
                .named(concat!("k", $suffix), "stiffness")
                .searched($k_range)
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::PowerLaw))
                .means("spring coefficient: the spring's force is k |x|^n sgn(x)")
                .from("thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)"),
            number!(Number, Allowed::Positive, mechanism.$field.exponent)
                .named(concat!("n", $suffix), "exponent")
                .searched($n_range)
                .log()
                .visible_when(of_spring!($field, $present, |spring| matches!(spring.kind, SpringKind::PowerLaw | SpringKind::Normalised), has_force))
                .means("spring exponent")
                .from("thesis Table 9.2 (range searched)"),
            number!(Number, Allowed::Positive, mechanism.$field.count)
                .named(concat!("N_spring", $suffix), "springs")
                .visible_when(of_spring!($field, $present, |spring| spring.kind != SpringKind::PowerLaw || !spring.is_single()))
                .means("how many equal springs act side by side")
                .from("thesis Figure 6.9; 1 unless given"),
            choice!(OwnMass, mechanism.$field.own_mass)
                .named(concat!("own_mass", $suffix), "spring inertia")
                .visible_when(of_spring!($field, $present, |_| true))
                .means("whether the part of the spring that moves with the plate adds to its mass")
                .from("thesis section 8.3.1: springs are massless"),
            optional!(Mass, Allowed::NonNegative, "auto", mechanism.$field.mass_kg)
                .named(concat!("m_spring", $suffix), "spring mass")
                .visible_when(of_spring!($field, $present, |spring| spring.own_mass == OwnMass::Counted || spring.mass_kg.is_some()))
                .means("the spring's whole mass")
                .from("auto: of its beams, or 4 rho G U/tau^2 (thesis section 9.5.1)"),
            number!(Force, Allowed::NonNegative, mechanism.$field.normalised.force_n)
                .named(concat!("F_ref", $suffix), "reference force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Normalised))
                .means("force of the normalised power law at x_ref: F_ref |x/x_ref|^n sgn(x)")
                .from("assumption: the law that no unit changes"),
            number!(Length, Allowed::Positive, mechanism.$field.normalised.displacement_m)
                .named(concat!("x_ref", $suffix), "reference travel")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Normalised))
                .means("displacement at which the normalised power law has the force F_ref"),
            number!(Length, Allowed::Positive, mechanism.$field.beam.length_m)
                .named(concat!("l_beam", $suffix), "beam length")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("length of a beam")
                .from("thesis Table 9.3"),
            number!(Length, Allowed::Positive, mechanism.$field.beam.width_m)
                .named(concat!("w_beam", $suffix), "beam width")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("width of a beam, across the bending")
                .from("thesis Table 9.3"),
            number!(Length, Allowed::Positive, mechanism.$field.beam.height_m)
                .named(concat!("h_beam", $suffix), "beam height")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("height of a beam, in the direction of bending")
                .from("thesis Table 9.3"),
            number!(Pressure, Allowed::Positive, mechanism.$field.beam.modulus_pa)
                .named(concat!("E_beam", $suffix), "beam modulus")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("modulus of elasticity of a beam")
                .from("thesis Table 9.3: titanium 6-4"),
            number!(Pressure, Allowed::Positive, mechanism.$field.beam.yield_pa)
                .named(concat!("Y_beam", $suffix), "beam strength")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("yield strength of a beam")
                .from("thesis Table 9.3: titanium 6-4"),
            number!(Density, Allowed::Positive, mechanism.$field.beam.density_kg_m3)
                .named(concat!("rho_beam", $suffix), "beam density")
                .visible_when(of_spring!($field, $present, |spring| spring.kind.is_beam()))
                .means("density of a beam")
                .from("titanium 6-4; Table 9.3 does not give it"),
            number!(Length, Allowed::Positive, mechanism.$field.bistable.second_m)
                .named(concat!("x_2", $suffix), "second position")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable))
                .means("second stable position; the first is x = 0")
                .from("assumption: the thesis gives no values"),
            optional!(Length, Allowed::Positive, "midway", mechanism.$field.bistable.unstable_m)
                .named(concat!("x_u", $suffix), "unstable point")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable))
                .means("unstable position between the stable ones: near 0 means much energy stored in the first")
                .from("absent: midway, both equally deep"),
            number!(Force, Allowed::Positive, mechanism.$field.bistable.barrier_n)
                .named(concat!("F_bar", $suffix), "barrier force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Bistable))
                .means("greatest force on the way out of the first stable position")
                .from("assumption: the thesis gives no values"),
            number!(Force, Allowed::NonNegative, mechanism.$field.constant.force_n)
                .named(concat!("F_c", $suffix), "constant force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::ConstantForce))
                .means("the constant force")
                .from("assumption: the thesis gives no values"),
            number!(Length, Allowed::Positive, mechanism.$field.constant.rise_m)
                .named(concat!("x_c", $suffix), "ramp length")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::ConstantForce))
                .means("displacement over which the constant force is reached"),
            number!(Stiffness, Allowed::Positive, mechanism.$field.column.stiffness_n_m)
                .named(concat!("k_col", $suffix), "column stiffness")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Column))
                .means("stiffness of the column before it buckles")
                .from("assumption: the thesis gives no values"),
            number!(Force, Allowed::Positive, mechanism.$field.column.critical_n)
                .named(concat!("F_crit", $suffix), "buckling force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Column))
                .means("force at which the column buckles")
                .from("assumption: the thesis gives no values"),
            number!(Force, Allowed::NonNegative, mechanism.$field.column.plateau_n)
                .named(concat!("F_plat", $suffix), "plateau force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Column))
                .means("force of the buckled column"),
            number!(Length, Allowed::Positive, mechanism.$field.column.fall_m)
                .named(concat!("x_fall", $suffix), "fall length")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Column))
                .means("displacement over which the force goes from F_crit to F_plat"),
            number!(Stiffness, Allowed::NonNegative, mechanism.$field.helix.stiffness_n_m)
                .named(concat!("k_helix", $suffix), "helix stiffness")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix))
                .means("axial stiffness of the helical rotating spring")
                .from("assumption: the thesis gives no values"),
            number!(Number, Allowed::Any, mechanism.$field.helix.twist_rad_m)
                .named(concat!("twist", $suffix), "twist")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix))
                .means("turn of the plate per displacement, rad/m"),
            number!(Number, Allowed::NonNegative, mechanism.$field.helix.inertia_kg_m2)
                .named(concat!("I_z", $suffix), "inertia")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Helix))
                .means("moment of inertia of what turns, kg m2: the plate gains I_z twist^2")
                .from("thesis section 6.2.7; values are assumptions"),
            number!(Force, Allowed::Positive, mechanism.$field.crush.force_n)
                .named(concat!("F_crush", $suffix), "crush force")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush))
                .means("force at which the absorber is crushed"),
            number!(Length, Allowed::Positive, mechanism.$field.crush.stroke_m)
                .named(concat!("x_crush", $suffix), "crush length")
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush))
                .means("displacement at which the absorber is flat and solid"),
            number!(Stiffness, Allowed::Positive, mechanism.$field.crush.stiffness_n_m)
                .named(concat!("k_crush", $suffix), "crush stiffness")
                .log()
                .visible_when(of_spring!($field, $present, |spring| spring.kind == SpringKind::Crush))
                .means("stiffness before the absorber is crushed and when it unloads"),
            number!(Density, Allowed::Positive, mechanism.$field.wire.density_kg_m3)
                .named(concat!("rho_wire", $suffix), "wire density")
                .visible_when(of_spring!($field, $present, has_wire))
                .means("density of the wire")
                .from("spring steel"),
            number!(Pressure, Allowed::Positive, mechanism.$field.wire.shear_modulus_pa)
                .named(concat!("G_wire", $suffix), "shear modulus")
                .visible_when(of_spring!($field, $present, has_wire))
                .means("shear modulus of the wire")
                .from("spring steel"),
            number!(Pressure, Allowed::Positive, mechanism.$field.wire.shear_strength_pa)
                .named(concat!("tau_wire", $suffix), "wire strength")
                .visible_when(of_spring!($field, $present, has_wire))
                .means("shear stress the wire may have")
                .from("spring steel"),
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
