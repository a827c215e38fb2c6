//! Families, principles and functions of thesis Tables 4.1 and 5.1, and the presets that show them.

/// A function a mechanism can supply (chapter 5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// The plate is turned to the projectile (5.1.1).
    PlateOrientation,
    /// The force that resists the plate is shaped (5.1.2).
    ControlledStiffness,
    /// Stored energy sets the plate moving (5.1.3).
    AcceleratedElements,
    /// Elements beside each other share the load (5.1.4).
    LateralArray,
}

impl Function {
    /// All functions, in the order of chapter 5.
    pub const ALL: [Self; 4] = [
        Self::PlateOrientation,
        Self::ControlledStiffness,
        Self::AcceleratedElements,
        Self::LateralArray,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::PlateOrientation => "armor plate orientation",
            Self::ControlledStiffness => "controlled stiffness",
            Self::AcceleratedElements => "accelerated elements",
            Self::LateralArray => "lateral array",
        }
    }

    /// The bundled presets that show it, or come nearest.
    pub fn presets(self) -> &'static [&'static str] {
        match self {
            Self::PlateOrientation => &["oblique"],
            Self::ControlledStiffness => {
                &["constant-force", "concept-bistable-shuttle", "figure-9.5"]
            }
            Self::AcceleratedElements => &["concept-cocked-cantilever", "cocked", "figure-9.3"],
            Self::LateralArray => &["array-lateral", "array-stacked"],
        }
    }
}

/// A design principle (chapter 4) with the functions that serve it (Table 5.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Principle {
    /// The family it belongs to.
    pub family: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The thesis's section.
    pub section: &'static str,
    /// What it does, in other words.
    pub idea: &'static str,
    /// The functions that serve it.
    pub functions: &'static [Function],
    /// What this program computes of it.
    pub computed: &'static str,
    /// The bundled preset that shows it, if one does.
    pub preset: Option<&'static str>,
}

use Function::{AcceleratedElements, ControlledStiffness, LateralArray, PlateOrientation};

/// Tables 4.1 and 5.1.
pub const PRINCIPLES: [Principle; 7] = [
    Principle {
        family: "Energy rejection",
        name: "Ricochet induction",
        section: "4.2.1",
        idea: "turn the plate so far that the projectile glances off with its energy",
        functions: &[PlateOrientation],
        computed: "Tate's critical obliquity, as a warning on theta",
        preset: Some("oblique"),
    },
    Principle {
        family: "Energy minimization",
        name: "Obliquity",
        section: "4.3.1",
        idea: "a slanted plate is thicker along the projectile's path",
        functions: &[PlateOrientation],
        computed: "theta: effective thickness, oblique section, forces along the normal",
        preset: Some("oblique"),
    },
    Principle {
        family: "Energy minimization",
        name: "Relative velocity reduction",
        section: "4.3.2",
        idea: "let the plate already move away, or spend energy in layers before it",
        functions: &[AcceleratedElements],
        computed: "d: a cocked spring is released at contact",
        preset: Some("cocked"),
    },
    Principle {
        family: "Energy dissipation",
        name: "Transfer rate minimization",
        section: "4.4.1",
        idea: "let the plate yield, so that the projectile has less velocity to lose",
        functions: &[ControlledStiffness],
        computed: "k, n, b and gamma: how the plate answers within the contact",
        preset: Some("constant-force"),
    },
    Principle {
        family: "Energy dissipation",
        name: "Strain energy distribution",
        section: "4.4.2",
        idea: "let more material bear the load",
        functions: &[LateralArray, ControlledStiffness],
        computed: "more plate behind the shot: gamma, N_spring; within the plate the model knows only its dishing",
        preset: Some("array-lateral"),
    },
    Principle {
        family: "Energy dissipation",
        name: "Sectional density reduction",
        section: "4.4.3",
        idea: "spread the projectile's mass over a larger cross section",
        functions: &[AcceleratedElements],
        computed: "R and m_p: the projectile itself stays rigid and straight",
        preset: Some("rigid-mount"),
    },
    Principle {
        family: "Energy dissipation",
        name: "Rotational or lateral kinetic energy transfer",
        section: "4.4.4",
        idea: "turn the projectile's energy into motion that does no harm",
        functions: &[PlateOrientation, LateralArray],
        computed: "the plate's motion and, on a helix, its rotation, in the energy ledger",
        preset: Some("concept-helical-spring"),
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_seven_principles_in_three_families_and_every_function_serves_one() {
        let mut families: Vec<&str> = PRINCIPLES.iter().map(|it| it.family).collect();
        families.dedup();
        assert_eq!(families.len(), 3);
        for function in Function::ALL {
            assert!(PRINCIPLES.iter().any(|it| it.functions.contains(&function)));
            assert!(!function.presets().is_empty() && !function.name().is_empty());
        }
    }
}
