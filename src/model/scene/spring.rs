//! The part of a scene that says what carries the plate elastically: the kind of spring, and what each kind needs. What a
//! kind means is in [`crate::model::mechanism`]; which variables matter to which kind is told by `variables`.

use crate::model::worded::worded;

use std::sync::Arc;

/// One spring: its kind, and the parameters of every kind, so that none is lost on the way to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// Which force law.
    pub kind: SpringKind,
    /// `k` >= 0 of the power law, N/m^n.
    pub coefficient: f64,
    /// `n` > 0 of the power law and of the normalised one.
    pub exponent: f64,
    /// The normalised power law.
    pub normalised: Normalised,
    /// The beam of the cantilever and of the fixed-guided pair.
    pub beam: Beam,
    /// The bistable mechanism.
    pub bistable: Bistable,
    /// The constant-force mechanism.
    pub constant: ConstantForce,
    /// The buckling column or notched tube.
    pub column: Column,
    /// The helical rotating spring.
    pub helix: Helix,
    /// The absorber that is crushed.
    pub crush: Crush,
    /// Measured force against displacement.
    pub table: Table,
    /// So many equal ones side by side, > 0.
    pub count: f64,
    /// Whether its own mass moves with the plate.
    pub own_mass: OwnMass,
    /// Its own mass, >= 0 kg; `None`: from its material.
    pub mass_kg: Option<f64>,
    /// What it is wound of, for its own mass where it is no beam.
    pub wire: Wire,
}

impl Spring {
    /// Whether there is exactly one of it.
    pub fn is_single(&self) -> bool {
        (self.count - 1.0).abs() < f64::EPSILON
    }
}

worded! {
    /// The spring's force law.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum SpringKind: word {
        /// `k |x|^n sgn(x)`.
        #[default]
        PowerLaw = "power-law",
        /// `F_ref |x/x_ref|^n sgn(x)`.
        Normalised = "normalised",
        /// A cantilever by its pseudo-rigid-body model.
        Cantilever = "prbm-cantilever",
        /// Beams that are fixed at one end and guided at the other: the sides of a four-bar.
        FixedGuided = "prbm-guided",
        /// A cubic force with two stable positions.
        Bistable = "bistable",
        /// A force that rises to its constant value.
        ConstantForce = "constant",
        /// An elastic rise, then a plateau.
        Column = "column",
        /// A linear spring that turns the plate as it gives way.
        Helix = "helix",
        /// An absorber that is crushed at a constant force and unloads elastically.
        Crush = "crush",
        /// A measured curve.
        Table = "table",
    }
}

impl SpringKind {
    /// Whether it is made of beams.
    pub fn is_beam(self) -> bool {
        matches!(self, Self::Cantilever | Self::FixedGuided)
    }
}

worded! {
    /// How the first and the second spring act together.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Combination: word {
        /// There is one spring only.
        #[default]
        Alone = "alone",
        /// Both are displaced alike: their forces add.
        Parallel = "parallel",
        /// Both carry the same force: their displacements add.
        Series = "series",
    }
}

/// `F_ref (x/x_ref)^n`: a law that stays the same when units change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normalised {
    /// `F_ref` >= 0 N.
    pub force_n: f64,
    /// `x_ref` > 0 m.
    pub displacement_m: f64,
}

/// A rectangular beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// l > 0 m.
    pub length_m: f64,
    /// w > 0, across the direction of bending, m.
    pub width_m: f64,
    /// h > 0, in the direction of bending, m.
    pub height_m: f64,
    /// E > 0 Pa.
    pub modulus_pa: f64,
    /// Yield strength > 0 Pa.
    pub yield_pa: f64,
    /// > 0 kg/m³.
    pub density_kg_m3: f64,
}

/// Two stable positions, the first at x = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bistable {
    /// The second stable position, > 0 m.
    pub second_m: f64,
    /// The unstable position between them; `None`: midway.
    pub unstable_m: Option<f64>,
    /// The force that takes it out of the first, > 0 N.
    pub barrier_n: f64,
}

/// A force that rises linearly and then stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantForce {
    /// >= 0 N.
    pub force_n: f64,
    /// Over which displacement it rises, > 0 m.
    pub rise_m: f64,
}

/// A column that buckles, or a notched tube that folds, elastically: it goes back the way it came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Before it buckles, > 0 N/m.
    pub stiffness_n_m: f64,
    /// The force at which it does, > 0 N.
    pub critical_n: f64,
    /// The force afterwards, >= 0 N.
    pub plateau_n: f64,
    /// Over which displacement the force goes from the one to the other, > 0 m.
    pub fall_m: f64,
}

/// A helical spring whose plate turns as it gives way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Helix {
    /// Axial stiffness, >= 0 N/m.
    pub stiffness_n_m: f64,
    /// dphi/dx, rad/m.
    pub twist_rad_m: f64,
    /// Moment of inertia of what turns, >= 0 kg m².
    pub inertia_kg_m2: f64,
}

/// An absorber that only pushes: it is crushed at a constant force and unloads elastically from where it was crushed to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crush {
    /// The force at which it is crushed, > 0 N.
    pub force_n: f64,
    /// The displacement at which it is flat and as stiff as when it unloads, > force over stiffness, m.
    pub stroke_m: f64,
    /// Before it is crushed, and when it unloads, > 0 N/m.
    pub stiffness_n_m: f64,
}

impl Crush {
    /// The displacement at which an absorber that was never loaded begins to be crushed, m.
    pub fn rise_m(&self) -> f64 {
        self.force_n / self.stiffness_n_m
    }
}

/// Measured force against displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// (x m, F N), x rising; one at x = 0, F = 0 at the start makes the law odd.
    pub points: Arc<[[f64; 2]]>,
}

/// The material a spring is wound of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wire {
    /// > 0 kg/m³.
    pub density_kg_m3: f64,
    /// G > 0 Pa.
    pub shear_modulus_pa: f64,
    /// tau > 0, the shear stress it may have, Pa.
    pub shear_strength_pa: f64,
}

worded! {
    /// Whether a spring's own mass counts.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum OwnMass: word {
        /// Springs are massless, as the thesis has them.
        #[default]
        Ignored = "ignored",
        /// The part that moves with the plate adds to the plate's.
        Counted = "counted",
    }
}

impl Default for Spring {
    fn default() -> Self {
        Self {
            kind: SpringKind::PowerLaw,
            coefficient: 1e5,
            exponent: 1.0,
            normalised: Normalised { force_n: 1e3, displacement_m: 0.01 },
            beam: Beam::default(),
            bistable: Bistable { second_m: 0.02, unstable_m: None, barrier_n: 1e3 },
            constant: ConstantForce { force_n: 2e3, rise_m: 1e-3 },
            column: Column { stiffness_n_m: 5e6, critical_n: 5e3, plateau_n: 3e3, fall_m: 2e-3 },
            helix: Helix { stiffness_n_m: 1e5, twist_rad_m: 50.0, inertia_kg_m2: 5e-6 },
            crush: Crush { force_n: 5e3, stroke_m: 0.05, stiffness_n_m: 1e7 },
            table: Table::default(),
            count: 1.0,
            own_mass: OwnMass::Ignored,
            mass_kg: None,
            wire: Wire::default(),
        }
    }
}

/// Table 9.3 of the thesis: titanium 6-4, whose density it does not give (4430).
impl Default for Beam {
    fn default() -> Self {
        Self {
            length_m: 0.3,
            width_m: 0.03,
            height_m: 0.015,
            modulus_pa: 113.8e9,
            yield_pa: 880e6,
            density_kg_m3: 4430.0,
        }
    }
}

/// The baseline's spring as a curve: 100 kN/m.
impl Default for Table {
    fn default() -> Self {
        Self { points: Arc::from([[0.0, 0.0], [0.01, 1e3], [0.05, 5e3]]) }
    }
}

/// Spring steel.
impl Default for Wire {
    fn default() -> Self {
        Self { density_kg_m3: 7850.0, shear_modulus_pa: 79.3e9, shear_strength_pa: 700e6 }
    }
}
