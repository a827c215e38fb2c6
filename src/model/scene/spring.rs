//! The part of a scene that says what carries the plate elastically: the kind of spring, and what each kind needs. What a
//! kind means is in [`crate::model::mechanism`]; which variables matter to which kind is told by `variables`.

use std::sync::Arc;

use crate::model::defaulted::defaulted;
use crate::model::worded::worded;

defaulted! {
    /// One spring: its kind, and the parameters of every kind, so that none is lost on the way to another.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Spring {
        /// Which force law.
        pub kind: SpringKind = SpringKind::PowerLaw,
        /// `k` >= 0 of the power law, N/m^n.
        pub coefficient: f64 = 1e5,
        /// `n` > 0 of the power law and of the normalised one.
        pub exponent: f64 = 1.0,
        /// The normalised power law.
        pub normalised: Normalised = Normalised::default(),
        /// The beam of the cantilever and of the fixed-guided pair.
        pub beam: Beam = Beam::default(),
        /// The bistable mechanism.
        pub bistable: Bistable = Bistable::default(),
        /// The constant-force mechanism.
        pub constant: ConstantForce = ConstantForce::default(),
        /// The buckling column or notched tube.
        pub column: Column = Column::default(),
        /// The helical rotating spring.
        pub helix: Helix = Helix::default(),
        /// The absorber that is crushed.
        pub crush: Crush = Crush::default(),
        /// Measured force against displacement.
        pub table: Table = Table::default(),
        /// So many equal ones side by side, > 0.
        pub count: f64 = 1.0,
        /// Whether its own mass moves with the plate.
        pub own_mass: OwnMass = OwnMass::Ignored,
        /// Its own mass, >= 0 kg; `None`: from its material.
        pub mass_kg: Option<f64> = None,
        /// What it is wound of, for its own mass where it is no beam.
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

defaulted! {
    /// `F_ref (x/x_ref)^n`: a law that stays the same when units change.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Normalised {
        /// `F_ref` >= 0 N.
        pub force_n: f64 = 1e3,
        /// `x_ref` > 0 m.
        pub displacement_m: f64 = 0.01,
    }

    /// A rectangular beam: that of Table 9.3 of the thesis, titanium 6-4, whose density it does not give.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Beam {
        /// l > 0 m.
        pub length_m: f64 = 0.3,
        /// w > 0, across the direction of bending, m.
        pub width_m: f64 = 0.03,
        /// h > 0, in the direction of bending, m.
        pub height_m: f64 = 0.015,
        /// E > 0 Pa.
        pub modulus_pa: f64 = 113.8e9,
        /// Yield strength > 0 Pa.
        pub yield_pa: f64 = 880e6,
        /// > 0 kg/m³.
        pub density_kg_m3: f64 = 4430.0,
    }

    /// Two stable positions, the first at x = 0.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Bistable {
        /// The second stable position, > 0 m.
        pub second_m: f64 = 0.02,
        /// The unstable position between them; `None`: midway.
        pub unstable_m: Option<f64> = None,
        /// The force that takes it out of the first, > 0 N.
        pub barrier_n: f64 = 1e3,
    }

    /// A force that rises linearly and then stays.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct ConstantForce {
        /// >= 0 N.
        pub force_n: f64 = 2e3,
        /// Over which displacement it rises, > 0 m.
        pub rise_m: f64 = 1e-3,
    }

    /// A column that buckles, or a notched tube that folds, elastically: it goes back the way it came.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Column {
        /// Before it buckles, > 0 N/m.
        pub stiffness_n_m: f64 = 5e6,
        /// The force at which it does, > 0 N.
        pub critical_n: f64 = 5e3,
        /// The force afterwards, >= 0 N.
        pub plateau_n: f64 = 3e3,
        /// Over which displacement the force goes from the one to the other, > 0 m.
        pub fall_m: f64 = 2e-3,
    }

    /// A helical spring whose plate turns as it gives way.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Helix {
        /// Axial stiffness, >= 0 N/m.
        pub stiffness_n_m: f64 = 1e5,
        /// dphi/dx, rad/m.
        pub twist_rad_m: f64 = 50.0,
        /// Moment of inertia of what turns, >= 0 kg m².
        pub inertia_kg_m2: f64 = 5e-6,
    }

    /// An absorber that only pushes: it is crushed at a constant force and unloads elastically from where it was crushed to.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Crush {
        /// The force at which it is crushed, > 0 N.
        pub force_n: f64 = 5e3,
        /// The displacement at which it is flat and as stiff as when it unloads, > force over stiffness, m.
        pub stroke_m: f64 = 0.05,
        /// Before it is crushed, and when it unloads, > 0 N/m.
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
    /// Measured force against displacement: the baseline's spring as a curve, 100 kN/m.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Table {
        /// (x m, F N), x rising; one at x = 0, F = 0 at the start makes the law odd.
        pub points: Arc<[[f64; 2]]> = Arc::from([[0.0, 0.0], [0.01, 1e3], [0.05, 5e3]]),
    }

    /// The material a spring is wound of: spring steel.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Wire {
        /// > 0 kg/m³.
        pub density_kg_m3: f64 = 7850.0,
        /// G > 0 Pa.
        pub shear_modulus_pa: f64 = 79.3e9,
        /// tau > 0, the shear stress it may have, Pa.
        pub shear_strength_pa: f64 = 700e6,
    }
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
