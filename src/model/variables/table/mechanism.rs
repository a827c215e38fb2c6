//! Damper, the way two springs act together, and stop.

use super::TABLE_9_2;
use crate::model::scene::{Combination, StopKind};
use crate::model::units::Quantity;
use crate::model::variables::visible::{
    Visible, has_stop, has_stop_of, is_sprung, is_stack, may_stop,
};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Step, Variable};

/// The damper.
pub(super) const DAMPER: &[Variable] = &[
    Variable {
        key: "mechanism.damper.coefficient",
        symbol: "b",
        label: "damping",
        aliases: &[],
        visible: Visible::used_when(is_sprung),
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
        label: "damper exponent",
        aliases: &[],
        visible: Visible::used_when(|scene| {
            is_sprung(scene) && scene.mechanism.damper.coefficient > 0.0
        }),
        group: Group::Mechanism,
        meaning: "damper exponent",
        source: "thesis section 9.2.2: 1",
        kind: number!(Number, Allowed::Positive, None, Log, mechanism.damper.exponent),
    },
];

/// Whether there is a second spring, and what the springs weigh for what they take up.
pub(super) const COMBINATION: &[Variable] = &[
    Variable {
        key: "mechanism.combination",
        symbol: "combine",
        label: "second spring",
        aliases: &[],
        visible: Visible::used_when(is_sprung),
        group: Group::Mechanism,
        meaning: "whether a second spring acts with the first: none, side by side, or one behind the other",
        source: "thesis section 6.2.8; one spring in chapter 9",
        kind: Kind::Choice(Choice {
            words: &["alone", "parallel", "series"],
            get: |scene| match scene.mechanism.combination {
                Combination::Alone => 0,
                Combination::Parallel => 1,
                Combination::Series => 2,
            },
            set: |scene, index| {
                scene.mechanism.combination =
                    [Combination::Alone, Combination::Parallel, Combination::Series][index.min(2)];
            },
        }),
    },
    Variable {
        key: "mechanism.energy_j_kg",
        symbol: "e_spring",
        label: "specific energy",
        aliases: &[],
        visible: Visible { listed: |scene| scene.mechanism.energy_j_kg.is_some(), used: is_sprung },
        group: Group::Mechanism,
        meaning: "energy per mass of the spring or absorber, which gives its least mass",
        source: "auto: tau^2/(4 rho G) of the wire; the library of absorbers has others",
        kind: optional!(SpecificEnergy, Allowed::Positive, "auto", mechanism.energy_j_kg),
    },
];

/// The mechanical stop.
pub(super) const STOP: &[Variable] = &[
    Variable {
        key: "mechanism.stop.position_m",
        symbol: "x_stop",
        label: "stop position",
        aliases: &["stop"],
        visible: Visible::used_when(may_stop),
        group: Group::Stop,
        meaning: "where the plate meets a mechanical stop",
        source: "thesis sections 9.5.1 and 9.6",
        kind: optional!(Length, Allowed::Any, "none", mechanism.stop.position_m),
    },
    Variable {
        key: "mechanism.stop.kind",
        symbol: "stop_kind",
        label: "kind of stop",
        aliases: &[],
        visible: Visible::used_when(has_stop),
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
        label: "restitution",
        aliases: &[],
        visible: Visible::used_when(|scene| has_stop_of(scene, StopKind::Rigid)),
        group: Group::Stop,
        meaning: "restitution of a rigid stop: w becomes -e w",
        source: "assumption",
        kind: number!(Number, Allowed::Between(0.0, 1.0), None, Linear, mechanism.stop.restitution),
    },
    Variable {
        key: "mechanism.stop.stiffness_n_m",
        symbol: "k_stop",
        label: "stop stiffness",
        aliases: &[],
        visible: Visible::used_when(|scene| has_stop_of(scene, StopKind::Elastic)),
        group: Group::Stop,
        meaning: "stiffness of an elastic stop",
        source: "assumption",
        kind: number!(Stiffness, Allowed::Positive, None, Log, mechanism.stop.stiffness_n_m),
    },
    Variable {
        key: "mechanism.stop.damping_n_s_m",
        symbol: "b_stop",
        label: "stop damping",
        aliases: &[],
        visible: Visible::used_when(|scene| has_stop_of(scene, StopKind::Elastic)),
        group: Group::Stop,
        meaning: "damping of an elastic stop (it only pushes)",
        source: "assumption",
        kind: number!(Damping, Allowed::NonNegative, None, Log, mechanism.stop.damping_n_s_m),
    },
];

/// What stands behind the plate.
pub(super) const STACK: &[Variable] = &[
    Variable {
        key: "stack.base_thickness_m",
        symbol: "h_base",
        label: "base thickness",
        aliases: &["base"],
        visible: Visible::ALWAYS,
        group: Group::Stack,
        meaning: "thickness of a base plate behind the elements, on a rigid mount",
        source: "thesis section 6.2.8; no value there. none: the plate stands alone",
        kind: optional!(Length, Allowed::Positive, "none", stack.base_thickness_m),
    },
    Variable {
        key: "stack.base_strength_pa",
        symbol: "S_base",
        label: "base strength",
        aliases: &[],
        visible: Visible::listed_when(is_stack),
        group: Group::Stack,
        meaning: "flow strength of the base plate",
        source: "plate: that of the scene's plate",
        kind: optional!(Pressure, Allowed::NonNegative, "plate", stack.base_strength_pa),
    },
    Variable {
        key: "stack.elements",
        symbol: "elements",
        label: "elements",
        aliases: &[],
        visible: Visible::listed_when(is_stack),
        group: Group::Stack,
        meaning: "how many equal elements, each a plate on its mechanism, stand one behind the other",
        source: "thesis section 6.2.8; 1 throughout chapter 9",
        kind: number!(Number, Allowed::Between(1.0, 50.0), None, Linear, stack.elements),
    },
    Variable {
        key: "stack.gap_m",
        symbol: "gap",
        label: "gap",
        aliases: &[],
        visible: Visible::listed_when(is_stack),
        group: Group::Stack,
        meaning: "clear distance behind each plate: a warning where a plate travels farther",
        source: "none: enough",
        kind: optional!(Length, Allowed::Positive, "none", stack.gap_m),
    },
];
