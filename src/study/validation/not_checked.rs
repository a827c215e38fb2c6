//! What is known of, and nothing can be checked by.

use super::NotChecked;
use super::cases::{BORVIK, ROD, SPHERE};

/// What is known of besides the cases, and why it checks nothing.
pub const NOT_CHECKED: [NotChecked; 9] = [
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
        id: "hits-apart",
        says: "hits do not weaken each other from about two diameters apart (finite elements)",
        why: "each hit is computed on a whole plate, as if it were far enough from all others",
        source: SPHERE,
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
