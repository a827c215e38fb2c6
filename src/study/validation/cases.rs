//! The measurements, with where they come from and where the model must not be used; and those nothing can be checked by.

use super::{Case, NotChecked, Quantity};

const BORVIK: &str = "Borvik, Langseth, Hopperstad and Malo, IJIE 27 (2002) 19, by a reader's ledger of the paper: second-hand";
const SPHERE: &str =
    "Qiang et al. (2022), doi 10.1177/09544062221080139, quoting an experiment: second-hand";
const CORE: &str =
    "Forrestal, Borvik, Warren and Chen, Exp. Mech. 54 (2014) 471, by the REL database (CC BY 4.0)";
const REPORTS: &str =
    "Army Research Laboratory reports, by the REL database (Ryan et al. 2023, CC BY 4.0)";
const ROD: &str =
    "cavity-expansion fit for 6061-T6511 of the Piekutowski kind, on a public page: second-hand";
const CONCRETE: &str = "Li and Chen's shot 14, as worked on a public page: second-hand";

const HARDENED: &str = "hardened steel, HRC 53";
const HARD_CORE: &str = "hard core of an armour-piercing bullet; its hardness is not given";

/// A case of the first set: one steel, one projectile.
const fn borvik(
    id: &'static str,
    nose: &'static str,
    measured: f64,
    caution: &'static str,
) -> Case {
    Case {
        id,
        preset: "validation-borvik",
        set: &[],
        quantity: Quantity::Limit,
        measured,
        resolution: Some(5.0),
        nose,
        projectile: HARDENED,
        source: BORVIK,
        caution,
    }
}

/// A case of the hard core on 20 mm of aluminium.
const fn core(
    id: &'static str,
    set: &'static [(&'static str, &'static str)],
    quantity: Quantity,
    measured: f64,
    caution: &'static str,
) -> Case {
    Case {
        id,
        preset: "validation-ap-core",
        set,
        quantity,
        measured,
        resolution: None,
        nose: "ogive, here a sphere with the ogive's drag",
        projectile: HARD_CORE,
        source: CORE,
        caution,
    }
}

const SECANT: &str = "must not be used beyond about 20 deg: the measured limit goes with 1/cos(theta), the model's with its \
                      square root, since the plate's resistance does not turn with the plate";
const RATIO: &str = "the bullet's mass with its jacket is not given, so only the ratio to its own limit at 0 deg (501 m/s) is \
                     compared; it hardly depends on the strength";
const ALLOY: &str = "alloy strength and projectile are not given, so only the ratio to the limit at 0 deg is compared; it \
                     hardly depends on them";

/// The measurements, in the order of the field notes.
pub const CASES: [Case; 19] = [
    borvik(
        "borvik-hemispherical",
        "hemisphere",
        292.1,
        "one point: the plate failed by necking and a plug, which the law does not contain (at 278.9 m/s it held, cracked \
         through); both closures meet it, so it cannot tell them apart",
    ),
    Case {
        set: &[("Y", "460MPa")],
        ..borvik(
            "borvik-lower-yield",
            "hemisphere",
            292.1,
            "the nominal yield strength instead of the fitted 490 MPa: how far the answer moves with it",
        )
    },
    borvik(
        "borvik-blunt",
        "blunt",
        184.5,
        "must not be used for blunt noses: they shear out a plug early, which the law does not contain",
    ),
    borvik(
        "borvik-conical",
        "cone",
        290.6,
        "must not be used for cones: the area law is a sphere's. That it comes close is luck",
    ),
    Case {
        quantity: Quantity::Bulge,
        resolution: None,
        ..borvik(
            "borvik-bulge",
            "hemisphere",
            3.10e-3,
            "dishing is a rule for depth (one projectile diameter), not the plate's deflection, and must not be read as one",
        )
    },
    Case {
        id: "sphere-on-thin-steel",
        preset: "validation-thin-sphere",
        set: &[],
        quantity: Quantity::Limit,
        measured: 205.1,
        resolution: None,
        nose: "sphere",
        projectile: "steel sphere; its hardness is not given",
        source: SPHERE,
        caution: "h/D of 0.06 is far below what the law is made for: a thin plate stretches as a membrane. Agreement is luck",
    },
    Case {
        id: "sphere-lower-yield",
        preset: "validation-thin-sphere",
        set: &[("Y", "215MPa")],
        quantity: Quantity::Limit,
        measured: 205.1,
        resolution: None,
        nose: "sphere",
        projectile: "steel sphere; its hardness is not given",
        source: SPHERE,
        caution: "the yield strength of 304 steel is between 215 and 310 MPa: inside that spread nothing is shown",
    },
    core(
        "ap-core-on-aluminium",
        &[],
        Quantity::Limit,
        514.0,
        "the area law is not the ogive's own (N = 0.106), and h/D of 3 rules out dishing",
    ),
    core("ap-core-15-deg", &[("theta", "15deg")], Quantity::Limit, 535.0, SECANT),
    core("ap-core-30-deg", &[("theta", "30deg")], Quantity::Limit, 597.0, SECANT),
    core("ap-core-45-deg", &[("theta", "45deg")], Quantity::Limit, 723.0, SECANT),
    core("ap-bullet-15-deg", &[("theta", "15deg")], Quantity::Ratio, 516.0 / 501.0, RATIO),
    core("ap-bullet-30-deg", &[("theta", "30deg")], Quantity::Ratio, 580.0 / 501.0, RATIO),
    core("ap-bullet-45-deg", &[("theta", "45deg")], Quantity::Ratio, 718.0 / 501.0, RATIO),
    Case {
        source: REPORTS,
        ..core(
            "aa7085-30-deg",
            &[("theta", "30deg"), ("h", "18.5mm")],
            Quantity::Ratio,
            652.0 / 598.0,
            ALLOY,
        )
    },
    Case {
        source: REPORTS,
        ..core(
            "hard-steel-30-deg",
            &[
                ("theta", "30deg"),
                ("h", "9.8mm"),
                ("rho", "7850"),
                ("E", "200GPa"),
                ("Y", "1.5GPa"),
            ],
            Quantity::Ratio,
            965.0 / 865.0,
            "alloy strength and projectile are not given (1.5 GPa and the hard core are taken), so only the ratio to the \
             limit at 0 deg is compared; a core would not stay rigid in so hard a steel",
        )
    },
    Case {
        id: "rod-6061-strength",
        preset: "validation-rod-6061",
        set: &[],
        quantity: Quantity::Strength,
        measured: 5.04 * 276e6,
        resolution: None,
        nose: "ogive, here a sphere with the ogive's drag",
        projectile: "steel rod; its hardness is not given",
        source: ROD,
        caution: "no measurement but a finer expansion, A Y with A = 5.04, which contains hardening; its part that is linear in \
                  velocity (B = 0.983) is not in the model, so rods would go too deep",
    },
    Case {
        id: "ogive-in-concrete",
        preset: "validation-concrete",
        set: &[],
        quantity: Quantity::Depth,
        measured: 0.173,
        resolution: None,
        nose: "ogive, here a sphere with the ogive's drag",
        projectile: "steel; its hardness is not given",
        source: CONCRETE,
        caution: "must not be used for concrete: it spalls a crater on entry that resists less, which is not in the model",
    },
    Case {
        id: "ogive-in-concrete-drag",
        preset: "validation-concrete",
        set: &[("C_d", "1")],
        quantity: Quantity::Depth,
        measured: 0.173,
        resolution: None,
        nose: "ogive, here with a hemisphere's drag (N = 0.5)",
        projectile: "steel; its hardness is not given",
        source: CONCRETE,
        caution: "how far the nose's drag factor moves the answer: little, the strength decides",
    },
];

/// What the field notes list besides, in their order.
pub const NOT_CHECKED: [NotChecked; 10] = [
    NotChecked {
        id: "borvik-pairs",
        says: "impact and residual velocity of the 24 shots",
        why: "the pairs are not at hand: nothing shows how fast the model's shots are beyond the limit",
        source: BORVIK,
    },
    NotChecked {
        id: "borvik-plugs",
        says: "plugs of 15.1 to 36.0 g, holes of 19.3 to 23.8 mm",
        why: "the law opens a hole of the nose's diameter (20 mm) and has no plug; the numbers are of all noses together",
        source: BORVIK,
    },
    NotChecked {
        id: "weldox-constants",
        says: "Johnson-Cook constants of Weldox 460 E",
        why: "A = 490 MPa is the Y of the preset; hardening, strain rate, heat and fracture are not in the law",
        source: "Borvik et al. 2002, part II, Table 2: second-hand",
    },
    NotChecked {
        id: "sphere-second-hit",
        says: "127.2 m/s after two hits on the same spot",
        why: "each run starts on a whole plate: the model has no memory of a hit",
        source: SPHERE,
    },
    NotChecked {
        id: "oblique-pairs",
        says: "ten further pairs of limits at 0 and 30 deg (AA2060, 6055, 7017, 7085, hard steel)",
        why: "the numbers are not at hand",
        source: REPORTS,
    },
    NotChecked {
        id: "rod-6061-depths",
        says: "depths of the rod in 6061-T6511",
        why: "only the constants and the rod are at hand, no depth",
        source: ROD,
    },
    NotChecked {
        id: "yu-beam",
        says: "a free-free beam struck by a projectile bends and folds at a plastic hinge",
        why: "the abstract has no number; it shows that the model's rigid plate is not the middle of a beam, so the model must \
              not be used for the displacement of beams (as the thesis does in 8.3.2)",
        source: "Yu, Yang, Reid and Austin, IJSS 33 (1996) 2659, abstract",
    },
    NotChecked {
        id: "thesis-itself",
        says: "the baseline of 7.129 mm, and Yang and Xi's beam",
        why: "the first is a computation, the second cannot fail: rows 9.3-baseline and 8.18-validates of `cmra reproduce`",
        source: "thesis sections 8.3.2 and 9.3",
    },
    NotChecked {
        id: "not-found",
        says: "Virostek, Dual and Goldsmith 1987; Yang and Xi 2003; Forrestal, Okajima and Luk 1988; Forrestal, Brar and Luk \
               1991; Gupta, Iqbal and Sekhon; Rosenberg and Dekel; Wu; Abatan and Hu; Stone",
        why: "no numbers of theirs are at hand; the contact law's own experiments are among them",
        source: "literature",
    },
    NotChecked {
        id: "remembered-only",
        says: "further values of Forrestal, Okajima and Luk 1988, Gupta, Iqbal and Sekhon 2007, and Borvik's AA5083-H116",
        why: "known from memory only, and so no test values; the last has no hemispherical noses",
        source: "memory",
    },
];
