//! The force between projectile and plate, what holds them together, and how the run is computed.

use crate::model::scene::{ContactModel, InterfaceLaw, Jumps, Reading};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, is_hydrodynamic, is_listing};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Step, Variable};

/// A quirk of the listing: printed or corrected.
macro_rules! quirk {
    ($field:ident, $symbol:literal, $label:literal, $meaning:literal, $where:literal) => {
        Variable {
            key: concat!("contact.appendix.", stringify!($field)),
            symbol: $symbol,
            label: $label,
            aliases: &[],
            visible: Visible::when(is_listing),
            group: Group::Interface,
            meaning: $meaning,
            source: concat!("thesis Appendix ", $where),
            kind: Kind::Choice(Choice {
                words: &["printed", "corrected"],
                get: |scene| usize::from(scene.contact.appendix.$field == Reading::Corrected),
                set: |scene, index| {
                    scene.contact.appendix.$field =
                        if index == 0 { Reading::Printed } else { Reading::Corrected };
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

/// Contact, interface and analysis.
pub(super) const ROWS: &[Variable] = &[
    Variable {
        key: "contact.model",
        symbol: "model",
        label: "contact model",
        aliases: &[],
        visible: Visible::ALWAYS,
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
        label: "pulse duration",
        aliases: &[],
        visible: Visible::when(|scene| scene.contact.model == ContactModel::HalfSine),
        group: Group::Interface,
        meaning: "duration of the half-sine force history",
        source: "thesis equation 8.9; auto: the hydrodynamic contact on a rigid mount",
        kind: optional!(Time, Allowed::Positive, "auto", contact.duration_s),
    },
    Variable {
        key: "contact.load_stiffness_n_m",
        symbol: "k_load",
        label: "loading",
        aliases: &[],
        visible: Visible::when(|scene| scene.contact.model == ContactModel::Lumped),
        group: Group::Interface,
        meaning: "stiffness of the lumped interface while it is pressed in",
        source: "thesis Figure 8.6; auto: as deep as the hydrodynamic model on a rigid mount",
        kind: optional!(Stiffness, Allowed::Positive, "auto", contact.load_stiffness_n_m),
    },
    Variable {
        key: "contact.unload_stiffness_n_m",
        symbol: "k_unload",
        label: "unloading",
        aliases: &[],
        visible: Visible::when(|scene| scene.contact.model == ContactModel::Lumped),
        group: Group::Interface,
        meaning: "stiffness of the lumped interface while it springs back, k_load or more",
        source: "thesis Figure 8.6; auto: 100 k_load, an assumption",
        kind: optional!(Stiffness, Allowed::Positive, "auto", contact.unload_stiffness_n_m),
    },
    Variable {
        key: "contact.damping_n_s_m",
        symbol: "b_2",
        label: "interface damper",
        aliases: &[],
        visible: Visible::when(|scene| scene.contact.model == ContactModel::Lumped),
        group: Group::Interface,
        meaning: "damper of the lumped interface",
        source: "thesis Figure 8.4; Wu has none",
        kind: number!(Damping, Allowed::NonNegative, None, Log, contact.damping_n_s_m),
    },
    Variable {
        key: "contact.appendix.step_s",
        symbol: "dt",
        label: "time step",
        aliases: &[],
        visible: Visible::when(is_listing),
        group: Group::Interface,
        meaning: "time step of the listing",
        source: "thesis Appendix A.1",
        kind: number!(Time, Allowed::Positive, None, Log, contact.appendix.step_s),
    },
    quirk!(
        coupling,
        "coupling",
        "nose depth",
        "depth subtracts the plate's last increment only, or (corrected) its whole motion",
        "A.2"
    ),
    quirk!(
        damper,
        "dampsign",
        "damper sign",
        "the damper's force has no sign, or (corrected) it resists",
        "A.7 and A.9"
    ),
    quirk!(
        stopping,
        "stopping",
        "end of contact",
        "contact ends below 0.01 m/s after a step, or (corrected) where both velocities are equal",
        "A.2"
    ),
    quirk!(
        afterwards,
        "after",
        "after contact",
        "both bodies are one afterwards, or (corrected) not after a perforation",
        "A.5 and A.7"
    ),
    quirk!(
        scheme,
        "scheme",
        "time stepping",
        "the force is held over the step, or (corrected) Runge-Kutta for both bodies",
        "A.4 and A.8"
    ),
    quirk!(
        obliquity,
        "oblique",
        "oblique force",
        "the whole force acts on both bodies, or (corrected) it is resolved on the normal",
        "A.2 to A.4"
    ),
    Variable {
        key: "contact.appendix.jumps",
        symbol: "jumps",
        label: "code jumps",
        aliases: &[],
        visible: Visible::when(is_listing),
        group: Group::Interface,
        meaning: "whether the listing's jumps work as meant, or (ignored) the area is overwritten once the nose is buried",
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
        label: "interface law",
        aliases: &["law"],
        visible: Visible::used_when(is_hydrodynamic),
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
        label: "grip",
        aliases: &["grip"],
        visible: Visible::used_when(|scene| {
            is_hydrodynamic(scene) && scene.interface.law == InterfaceLaw::Plastic
        }),
        group: Group::Interface,
        meaning: "grip: the greatest pull of the interface is g A S_y",
        source: "assumption: 0.1",
        kind: number!(Number, Allowed::NonNegative, None, Linear, interface.grip),
    },
    Variable {
        key: "run.tolerance",
        symbol: "tol",
        label: "tolerance",
        aliases: &["tolerance"],
        visible: Visible::ALWAYS,
        group: Group::Run,
        meaning: "relative accuracy asked of depth and time",
        source: "default of this program",
        kind: number!(Number, Allowed::Between(1e-14, 1e-2), None, Log, run.tolerance),
    },
    Variable {
        key: "run.horizon_s",
        symbol: "horizon",
        label: "end of the run",
        aliases: &[],
        visible: Visible::ALWAYS,
        group: Group::Run,
        meaning: "the time the run goes on to",
        source: "absent: chosen from the scene",
        kind: optional!(Time, Allowed::Positive, "auto", run.horizon_s),
    },
];
