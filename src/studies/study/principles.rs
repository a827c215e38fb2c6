//! Tables 4.1 and 5.1 of the thesis (principles and the functions that serve them) and Table 7.1 (the concepts, rated).

/// Design principle of chapter 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Principle {
    /// Family of the principle.
    pub family: &'static str,
    /// Name of the principle.
    pub name: &'static str,
    /// Section of the thesis.
    pub section: &'static str,
    /// Idea of the principle, paraphrased.
    pub idea: &'static str,
    /// Functions of chapter 5 that serve the principle.
    pub functions: &'static [&'static str],
    /// The bundled preset that shows it.
    pub preset: &'static str,
}

/// Functions of chapter 5, each with its letter in the workbench.
pub const FUNCTIONS: [(char, &str); 4] =
    [('O', ORIENTATION), ('A', ACCELERATED), ('S', STIFFNESS), ('L', LATERAL)];

const ORIENTATION: &str = "armor plate orientation";
const ACCELERATED: &str = "accelerated elements";
const STIFFNESS: &str = "controlled stiffness";
const LATERAL: &str = "lateral array";

const fn principle(
    [family, name, section, idea]: [&'static str; 4],
    functions: &'static [&'static str],
    preset: &'static str,
) -> Principle {
    Principle { family, name, section, idea, functions, preset }
}

/// Principles in the order of Table 4.1.
#[rustfmt::skip]
pub const PRINCIPLES: [Principle; 7] = [
    principle(["Energy rejection", "Ricochet induction", "4.2.1",
        "turn the plate so far that the projectile ricochets with its energy"], &[ORIENTATION], "oblique"),
    principle(["Energy minimization", "Obliquity", "4.3.1",
        "a slanted plate is thicker along the projectile's path"], &[ORIENTATION], "oblique"),
    principle(["Energy minimization", "Relative velocity reduction", "4.3.2",
        "let the plate move away at impact, or dissipate energy in layers before it"], &[ACCELERATED], "cocked"),
    principle(["Energy dissipation", "Transfer rate minimization", "4.4.1",
        "let the plate yield, so that the projectile has less velocity to lose"], &[STIFFNESS], "constant-force"),
    principle(["Energy dissipation", "Strain energy distribution", "4.4.2",
        "let more material bear the load"], &[LATERAL, STIFFNESS], "array-lateral"),
    principle(["Energy dissipation", "Sectional density reduction", "4.4.3",
        "spread the projectile's mass over a larger cross section"], &[ACCELERATED], "rigid-mount"),
    principle(["Energy dissipation", "Rotational or lateral kinetic energy transfer", "4.4.4",
        "convert the projectile's energy into harmless motion"], &[ORIENTATION, LATERAL], "concept-helical-spring"),
];

/// Criteria of Table 7.1 with their weights, percent.
pub const CRITERIA: [(&str, f64); 7] = [
    ("plate orientation", 12.0),
    ("controlled stiffness", 20.0),
    ("plate acceleration", 3.0),
    ("array compatibility", 10.0),
    ("mass efficiency", 10.0),
    ("manufacture, assembly", 10.0),
    ("ease of analysis", 35.0),
];

/// Concept of chapter 6 with the ratings of Table 7.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Concept {
    /// Name of the concept.
    pub name: &'static str,
    /// Functions that the concept can provide, in the order of [`FUNCTIONS`].
    pub functions: &'static [&'static str],
    /// Ratings from 1 (much worse than the reference) to 5 (much better), by criterion.
    pub ratings: [f64; 7],
    /// Total as printed.
    pub total: f64,
    /// Rank as printed.
    pub rank: usize,
    /// The bundled preset that shows it.
    pub preset: &'static str,
}

impl Concept {
    /// Returns the sum of ratings times weights.
    pub fn weighted(&self) -> f64 {
        self.ratings.iter().zip(CRITERIA).map(|(rating, (_, weight))| rating * weight / 100.0).sum()
    }
}

const fn concept(
    name: &'static str,
    functions: &'static [&'static str],
    ratings: [f64; 7],
    total: f64,
    rank: usize,
    preset: &'static str,
) -> Concept {
    Concept { name, functions, ratings, total, rank, preset }
}

/// Concepts in the order of Table 7.1. Section 6.2 names the functions; section 6.2.1 those of both emergent and buckling four-bars.
#[rustfmt::skip]
pub const CONCEPTS: [Concept; 8] = [
    concept("Emergent four-bar", &[ORIENTATION, STIFFNESS, LATERAL],
        [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0], 3.0, 4, "concept-emergent-four-bar"),
    concept("Buckling four-bar", &[ORIENTATION, STIFFNESS, LATERAL],
        [2.0, 3.0, 1.0, 3.0, 2.0, 3.0, 1.0], 2.02, 8, "concept-buckling-four-bar"),
    concept("Buckling cantilever", &[ORIENTATION, STIFFNESS, LATERAL],
        [2.0, 3.0, 1.0, 3.0, 3.0, 3.0, 2.0], 2.47, 5, "concept-buckling-cantilever"),
    concept("Cocked four-bar", &[ACCELERATED, STIFFNESS, LATERAL],
        [3.0, 4.0, 4.0, 3.0, 3.0, 3.0, 3.0], 3.23, 3, "concept-cocked-four-bar"),
    concept("Cocked cantilever", &[ORIENTATION, ACCELERATED, STIFFNESS, LATERAL],
        [3.0, 4.0, 4.0, 3.0, 4.0, 4.0, 4.0], 3.78, 1, "concept-cocked-cantilever"),
    concept("Bistable shuttle", &[ORIENTATION, ACCELERATED, STIFFNESS, LATERAL],
        [1.0, 2.0, 4.0, 3.0, 3.0, 4.0, 2.0], 2.34, 6, "concept-bistable-shuttle"),
    concept("Buckling tube", &[STIFFNESS, LATERAL],
        [2.0, 1.0, 1.0, 4.0, 3.0, 2.0, 2.0], 2.07, 7, "concept-buckling-tube"),
    concept("Helical rotating spring", &[ACCELERATED, STIFFNESS, LATERAL],
        [2.0, 4.0, 2.0, 4.0, 2.0, 2.0, 4.0], 3.3, 2, "concept-helical-spring"),
];
