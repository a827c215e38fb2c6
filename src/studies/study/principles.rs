//! Tables 4.1 and 5.1 of the thesis (principles and the functions that serve them) and Table 7.1 (the concepts, rated).

/// A design principle of chapter 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Principle {
    /// The family it belongs to.
    pub family: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The thesis's section.
    pub section: &'static str,
    /// Its function, in other words.
    pub idea: &'static str,
    /// The functions that serve it, of those of chapter 5.
    pub functions: &'static [&'static str],
    /// The bundled preset that shows it.
    pub preset: &'static str,
}

const ORIENTATION: &str = "armor plate orientation";
const ACCELERATED: &str = "accelerated elements";
const STIFFNESS: &str = "controlled stiffness";
const LATERAL: &str = "lateral array";

/// The principles, in the order of Table 4.1.
pub const PRINCIPLES: [Principle; 7] = [
    Principle {
        family: "Energy rejection",
        name: "Ricochet induction",
        section: "4.2.1",
        idea: "turn the plate so far that the projectile ricochets with its energy",
        functions: &[ORIENTATION],
        preset: "oblique",
    },
    Principle {
        family: "Energy minimization",
        name: "Obliquity",
        section: "4.3.1",
        idea: "a slanted plate is thicker along the projectile's path",
        functions: &[ORIENTATION],
        preset: "oblique",
    },
    Principle {
        family: "Energy minimization",
        name: "Relative velocity reduction",
        section: "4.3.2",
        idea: "let the plate move away at impact, or dissipate energy in layers before it",
        functions: &[ACCELERATED],
        preset: "cocked",
    },
    Principle {
        family: "Energy dissipation",
        name: "Transfer rate minimization",
        section: "4.4.1",
        idea: "let the plate yield, so that the projectile has less velocity to lose",
        functions: &[STIFFNESS],
        preset: "constant-force",
    },
    Principle {
        family: "Energy dissipation",
        name: "Strain energy distribution",
        section: "4.4.2",
        idea: "let more material bear the load",
        functions: &[LATERAL, STIFFNESS],
        preset: "array-lateral",
    },
    Principle {
        family: "Energy dissipation",
        name: "Sectional density reduction",
        section: "4.4.3",
        idea: "spread the projectile's mass over a larger cross section",
        functions: &[ACCELERATED],
        preset: "rigid-mount",
    },
    Principle {
        family: "Energy dissipation",
        name: "Rotational or lateral kinetic energy transfer",
        section: "4.4.4",
        idea: "convert the projectile's energy into harmless motion",
        functions: &[ORIENTATION, LATERAL],
        preset: "concept-helical-spring",
    },
];

/// The criteria of Table 7.1 with their weights, percent.
pub const CRITERIA: [(&str, f64); 7] = [
    ("plate orientation", 12.0),
    ("controlled stiffness", 20.0),
    ("plate acceleration", 3.0),
    ("array compatibility", 10.0),
    ("mass efficiency", 10.0),
    ("manufacture, assembly", 10.0),
    ("ease of analysis", 35.0),
];

/// A concept of chapter 6 as Table 7.1 rates it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Concept {
    /// Its name.
    pub name: &'static str,
    /// Ratings from 1 (much worse than the reference) to 5 (much better), by criterion.
    pub ratings: [f64; 7],
    /// The total as printed.
    pub total: f64,
    /// The rank as printed.
    pub rank: usize,
    /// The bundled preset that shows it.
    pub preset: &'static str,
}

impl Concept {
    /// Ratings times weights.
    pub fn weighted(&self) -> f64 {
        self.ratings.iter().zip(CRITERIA).map(|(rating, (_, weight))| rating * weight / 100.0).sum()
    }
}

const fn concept(
    name: &'static str,
    ratings: [f64; 7],
    total: f64,
    rank: usize,
    preset: &'static str,
) -> Concept {
    Concept { name, ratings, total, rank, preset }
}

/// The concepts, in the table's order.
#[rustfmt::skip]
pub const CONCEPTS: [Concept; 8] = [
    concept("Emergent four-bar", [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0], 3.0, 4, "concept-emergent-four-bar"),
    concept("Buckling four-bar", [2.0, 3.0, 1.0, 3.0, 2.0, 3.0, 1.0], 2.02, 8, "concept-buckling-four-bar"),
    concept("Buckling cantilever", [2.0, 3.0, 1.0, 3.0, 3.0, 3.0, 2.0], 2.47, 5, "concept-buckling-cantilever"),
    concept("Cocked four-bar", [3.0, 4.0, 4.0, 3.0, 3.0, 3.0, 3.0], 3.23, 3, "concept-cocked-four-bar"),
    concept("Cocked cantilever", [3.0, 4.0, 4.0, 3.0, 4.0, 4.0, 4.0], 3.78, 1, "concept-cocked-cantilever"),
    concept("Bistable shuttle", [1.0, 2.0, 4.0, 3.0, 3.0, 4.0, 2.0], 2.34, 6, "concept-bistable-shuttle"),
    concept("Buckling tube", [2.0, 1.0, 1.0, 4.0, 3.0, 2.0, 2.0], 2.07, 7, "concept-buckling-tube"),
    concept("Helical rotating spring", [2.0, 4.0, 2.0, 4.0, 2.0, 2.0, 4.0], 3.3, 2, "concept-helical-spring"),
];
