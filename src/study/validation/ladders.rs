//! Ladders: the same shot on plates of many thicknesses, pairs at 0 and 30 deg, and hits at the same place.

use super::cases::{REPORTS, SPHERE, core};
use super::{Case, Class, Quantity};

/// The papers behind the ladders are not named where they were found.
const LADDER: &str = "V50 ladder of a 7.62 mm armour-piercing bullet in a public test suite: second-hand, its paper is not at hand";
const DERIVED: &str = "V50 ladder of a 7.62 mm armour-piercing bullet on rolled armour steel, derived from finite elements: second-hand";

const ALLOY: &str = "the alloy's strength is not given, so only the ratio to the limit at 0 deg is compared; it hardly depends on it. \
                     Computed with the bare core of the bullet (CAL30 APM2, 10.7 g)";
const HARD: &str = "the steel's strength is not given (1.5 GPa is taken), so only the ratio to the limit at 0 deg is compared; a core \
                    would not stay rigid in so hard a steel";
const LARGER: &str = "shot with CAL50 APM2, computed with the core of CAL30: the ratio hardly depends on the projectile. Strength as \
                      for the plate of 9.8 mm";
const MILD: &str = "computed as the bare core, Y = 250 MPa, cavity expansion. Beyond h/D of 3 it is too low: hardening and strain rate \
                    are not in the law";
const RHA: &str = "UNCONSERVATIVE for thin hard plate: must not be used below h/D of about 2.5. The plate fails by a plug long before \
                   the hole is opened by cavity expansion (Y = 900 MPa, bare core)";
const REPEAT: &str = "UNCONSERVATIVE: every hit goes on where the last one stopped, in a plate that is as strong as before. The measured \
                      plate has cracked and stretched: the limit falls faster than with the root of the number of hits";

/// A core on a steel plate.
macro_rules! steel {
    ($id:literal, $yield:literal, $thickness:literal, $class:expr, $limit:expr, $source:expr, $caution:expr) => {
        Case {
            source: $source,
            ..core(
                $id,
                &[("rho", "7850"), ("E", "200GPa"), ("Y", $yield), ("h", $thickness)],
                $class,
                $limit,
                $caution,
            )
        }
    };
}

/// A pair of limits at 0 and 30 deg on aluminium.
macro_rules! pair {
    ($id:literal, $thickness:literal, $straight:literal, $oblique:literal) => {
        Case {
            source: REPORTS,
            ..core(
                $id,
                &[("theta", "30deg"), ("h", $thickness)],
                Class::ObliqueRatio,
                $oblique / $straight,
                ALLOY,
            )
        }
    };
}

/// The same on a hard steel.
macro_rules! hard_pair {
    ($id:literal, $thickness:literal, $straight:literal, $oblique:literal, $caution:expr) => {
        Case {
            source: REPORTS,
            ..core(
                $id,
                &[
                    ("theta", "30deg"),
                    ("h", $thickness),
                    ("rho", "7850"),
                    ("E", "200GPa"),
                    ("Y", "1.5GPa"),
                ],
                Class::ObliqueRatio,
                $oblique / $straight,
                $caution,
            )
        }
    };
}

/// So many equal hits of the sphere on the thin plate.
const fn hits(id: &'static str, count: u8, measured: f64) -> Case {
    Case {
        id,
        preset: "validation-thin-sphere",
        set: &[],
        class: Class::RepeatHits,
        quantity: Quantity::RepeatLimit(count),
        measured,
        resolution: None,
        nose: "sphere",
        projectile: "steel sphere; its hardness is not given",
        source: SPHERE,
        caution: REPEAT,
    }
}

/// The ladders, class by class.
pub(super) static LADDERS: &[Case] = &[
    pair!("pair-aa2060-21.6mm", "21.6mm", 642.0, 707.0),
    pair!("pair-aa6055-19.0mm", "19mm", 543.0, 576.0),
    pair!("pair-aa6055-19.1mm", "19.1mm", 532.0, 592.0),
    pair!("pair-aa7017-t6-19.3mm", "19.3mm", 564.0, 641.0),
    pair!("pair-aa7017-t7-20.0mm", "20mm", 569.0, 633.0),
    pair!("pair-aa7085-t711-18.5mm", "18.5mm", 598.0, 652.0),
    pair!("pair-aa7085-t711-18.6mm", "18.6mm", 598.0, 668.0),
    pair!("pair-aa7085-t721-18.5mm", "18.5mm", 567.0, 614.0),
    hard_pair!("pair-uhh-9.8mm", "9.8mm", 865.0, 965.0, HARD),
    hard_pair!("pair-uhh-12.2mm", "12.2mm", 686.0, 796.0, LARGER),
    steel!("mild-steel-4.7mm", "250MPa", "4.7mm", Class::CoreOnMildSteel, 274.0, LADDER, MILD),
    steel!("mild-steel-6mm", "250MPa", "6mm", Class::CoreOnMildSteel, 304.5, LADDER, MILD),
    steel!("mild-steel-10mm", "250MPa", "10mm", Class::CoreOnMildSteel, 400.5, LADDER, MILD),
    steel!("mild-steel-12mm", "250MPa", "12mm", Class::CoreOnMildSteel, 447.5, LADDER, MILD),
    steel!("mild-steel-16mm", "250MPa", "16mm", Class::CoreOnMildSteel, 533.0, LADDER, MILD),
    steel!("mild-steel-20mm", "250MPa", "20mm", Class::CoreOnMildSteel, 682.5, LADDER, MILD),
    steel!("mild-steel-25mm", "250MPa", "25mm", Class::CoreOnMildSteel, 791.0, LADDER, MILD),
    steel!("rha-6mm", "900MPa", "6mm", Class::CoreOnArmourSteel, 320.0, DERIVED, RHA),
    steel!("rha-8mm", "900MPa", "8mm", Class::CoreOnArmourSteel, 425.0, DERIVED, RHA),
    steel!("rha-10mm", "900MPa", "10mm", Class::CoreOnArmourSteel, 515.0, DERIVED, RHA),
    steel!("rha-12mm", "900MPa", "12mm", Class::CoreOnArmourSteel, 620.0, DERIVED, RHA),
    steel!("rha-14mm", "900MPa", "14mm", Class::CoreOnArmourSteel, 720.0, DERIVED, RHA),
    steel!("rha-16mm", "900MPa", "16mm", Class::CoreOnArmourSteel, 830.0, DERIVED, RHA),
    hits("sphere-second-hit", 2, 127.2),
    hits("sphere-second-hit-fe", 2, 121.3),
    hits("sphere-third-hit-fe", 3, 95.0),
];
