//! Damper, the way two springs act together, and stop.

use super::TABLE_9_2;
use crate::model::scene::{Combination, StopKind};
use crate::model::units::Quantity;
use crate::model::variables::visible::{
    Visible, has_stop, has_stop_of, is_sprung, is_stack, may_stop,
};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Variable};

pub(super) const DAMPER: &[Variable] = &[
    number!(DamperCoefficient, Allowed::NonNegative, mechanism.damper.coefficient)
        .named("b", "damping")
        .searched(Some((0.0, 2000.0)))
        .log()
        .used_when(is_sprung)
        .means("damper coefficient: the damper's force is b |w|^m sgn(w)")
        .from(TABLE_9_2),
    number!(Number, Allowed::Positive, mechanism.damper.exponent)
        .named("m", "damper exponent")
        .log()
        .used_when(|scene| is_sprung(scene) && !scene.mechanism.damper.is_absent())
        .means("damper exponent")
        .from("thesis section 9.2.2: 1"),
];

/// Whether there is a second spring, and what the springs weigh for what they take up.
pub(super) const COMBINATION: &[Variable] = &[
    choice!(Combination, mechanism.combination)
        .named("combine", "second spring")
        .used_when(is_sprung)
        .means("a second spring: none (alone), parallel to the first one, or in series with it")
        .from("thesis section 6.2.8; one spring in chapter 9"),
    optional!(SpecificEnergy, Allowed::Positive, "auto", mechanism.energy_j_kg)
        .named("e_spring", "specific energy")
        .visible_when(Visible {
            listed: |scene| scene.mechanism.energy_j_kg.is_some(),
            used: is_sprung,
        })
        .means("energy per mass of the spring or absorber, which gives its least mass")
        .from("auto: tau^2/(4 rho G) of the wire; the library of absorbers has others"),
];

pub(super) const STOP: &[Variable] = &[
    optional!(Length, Allowed::Any, "none", mechanism.stop.position_m)
        .named("x_stop", "stop position")
        .also(&["stop"])
        .used_when(may_stop)
        .means("where the plate meets a mechanical stop")
        .from("thesis sections 9.5.1 and 9.6"),
    choice!(StopKind, mechanism.stop.kind)
        .named("stop_kind", "kind of stop")
        .used_when(has_stop)
        .means("rigid: an impact with restitution; elastic: a one-sided spring and damper")
        .from("assumption: the thesis names no kind"),
    number!(Number, Allowed::Between(0.0, 1.0), mechanism.stop.restitution)
        .named("e", "restitution")
        .used_when(|scene| has_stop_of(scene, StopKind::Rigid))
        .means("restitution of a rigid stop: w becomes -e w"),
    number!(Stiffness, Allowed::Positive, mechanism.stop.stiffness_n_m)
        .named("k_stop", "stop stiffness")
        .log()
        .used_when(|scene| has_stop_of(scene, StopKind::Elastic))
        .means("stiffness of an elastic stop"),
    number!(Damping, Allowed::NonNegative, mechanism.stop.damping_n_s_m)
        .named("b_stop", "stop damping")
        .log()
        .used_when(|scene| has_stop_of(scene, StopKind::Elastic))
        .means("damping of an elastic stop (it only pushes)"),
];

/// The stack behind the plate.
pub(super) const STACK: &[Variable] = &[
    optional!(Length, Allowed::Positive, "none", stack.base_thickness_m)
        .named("h_base", "base thickness")
        .also(&["base"])
        .means("thickness of a base plate behind the elements, on a rigid mount")
        .from("thesis section 6.2.8; no value there. none: the plate stands alone"),
    optional!(Pressure, Allowed::NonNegative, "plate", stack.base_strength_pa)
        .named("S_base", "base strength")
        .listed_when(is_stack)
        .means("flow strength of the base plate")
        .from("plate: that of the scene's plate"),
    number!(Number, Allowed::Between(1.0, 50.0), stack.elements)
        .named("elements", "elements")
        .listed_when(is_stack)
        .means("how many equal elements, each a plate on its mechanism, stand one behind the other")
        .from("thesis section 6.2.8; 1 throughout chapter 9"),
    optional!(Length, Allowed::Positive, "none", stack.gap_m)
        .named("gap", "gap")
        .listed_when(is_stack)
        .means("clear distance behind each plate: a warning where a plate travels farther")
        .from("none: enough"),
];
