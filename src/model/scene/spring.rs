//! The part of a scene that says what carries the plate elastically: the kind of spring, and what each kind needs. What a
//! kind means is in [`crate::model::mechanism`]; `variables` says which of them matter to which kind.

use std::sync::Arc;

use crate::model::defaulted::defaulted;
use crate::model::worded::worded;

defaulted! {
    /// One spring: its kind, and the parameters of every kind, so that none is lost on the way to another.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Spring {
        pub kind: SpringKind = SpringKind::PowerLaw,
        pub coefficient: f64 = 1e5,
        pub exponent: f64 = 1.0,
        pub normalised: Normalised = Normalised::default(),
        pub beam: Beam = Beam::default(),
        pub bistable: Bistable = Bistable::default(),
        pub constant: ConstantForce = ConstantForce::default(),
        pub column: Column = Column::default(),
        pub helix: Helix = Helix::default(),
        pub crush: Crush = Crush::default(),
        pub table: Table = Table::default(),
        pub count: f64 = 1.0,
        pub own_mass: OwnMass = OwnMass::Ignored,
        pub mass_kg: Option<f64> = None,
        pub wire: Wire = Wire::default(),
    }
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
        Bistable = "bistable",
        ConstantForce = "constant",
        /// An elastic rise, then a plateau.
        Column = "column",
        /// A linear spring that turns the plate as it yields.
        Helix = "helix",
        /// An absorber that is crushed at a constant force and unloads elastically.
        Crush = "crush",
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
        #[default]
        Alone = "alone",
        /// Both are displaced alike: their forces add.
        Parallel = "parallel",
        /// Both carry the same force: their displacements add.
        Series = "series",
    }
}

defaulted! {
    /// `F_ref (x/x_ref)^n`: a law that stays the same when units change.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Normalised {
        pub force_n: f64 = 1e3,
        pub displacement_m: f64 = 0.01,
    }

    /// A rectangular beam: that of Table 9.3 of the thesis, titanium 6-4, whose density it does not give.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Beam {
        pub length_m: f64 = 0.3,
        pub width_m: f64 = 0.03,
        pub height_m: f64 = 0.015,
        pub modulus_pa: f64 = 113.8e9,
        pub yield_pa: f64 = 880e6,
        pub density_kg_m3: f64 = 4430.0,
    }

    /// Two stable positions, the first at x = 0.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Bistable {
        pub second_m: f64 = 0.02,
        pub unstable_m: Option<f64> = None,
        pub barrier_n: f64 = 1e3,
    }

    /// A force that rises linearly and then stays.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct ConstantForce {
        pub force_n: f64 = 2e3,
        pub rise_m: f64 = 1e-3,
    }

    /// A column that buckles, or a notched tube that folds, elastically: it goes back the way it came.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Column {
        pub stiffness_n_m: f64 = 5e6,
        pub critical_n: f64 = 5e3,
        pub plateau_n: f64 = 3e3,
        pub fall_m: f64 = 2e-3,
    }

    /// A helical spring whose plate turns as it yields.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Helix {
        pub stiffness_n_m: f64 = 1e5,
        pub twist_rad_m: f64 = 50.0,
        pub inertia_kg_m2: f64 = 5e-6,
    }

    /// An absorber that only pushes: it is crushed at a constant force and unloads elastically from where it was crushed to.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Crush {
        pub force_n: f64 = 5e3,
        pub stroke_m: f64 = 0.05,
        pub stiffness_n_m: f64 = 1e7,
    }
}

impl Crush {
    /// The displacement at which an absorber that was never loaded begins to be crushed, m.
    pub fn rise_m(&self) -> f64 {
        self.force_n / self.stiffness_n_m
    }
}

defaulted! {
    /// Measured force against displacement, points (x m, F N) with rising x: the baseline's spring as a curve, 100 kN/m. One at x
    /// = 0, F = 0 at the start makes the law odd.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Table {
        pub points: Arc<[[f64; 2]]> = Arc::from([[0.0, 0.0], [0.01, 1e3], [0.05, 5e3]]),
    }

    /// The material a spring is wound of: spring steel.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Wire {
        pub density_kg_m3: f64 = 7850.0,
        pub shear_modulus_pa: f64 = 79.3e9,
        pub shear_strength_pa: f64 = 700e6,
    }
}

worded! {
    /// Whether a spring's own mass counts.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum OwnMass: word {
        #[default]
        Ignored = "ignored",
        /// The part that moves with the plate adds to the plate's.
        Counted = "counted",
    }
}
