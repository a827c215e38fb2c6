//! The kinds of spring: the table of them, and the law of each.
//!
//! A kind is one file: its parameters, its force law, its own mass, and its range of validity. Chapters 5, 6, 9.4 and 9.5 of
//! the thesis name the kinds.

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::curve::Curve;
use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{MIN_EXPONENT, PowerLaw};
use crate::model::scene::{OwnMass, Scene, Wire};
use crate::model::variables::part::{NO_VALUES, parts, placed};
use crate::model::variables::{Group, Variable, VariableError};

mod beam;
mod bistable;
mod column;
mod constant;
mod crush;
mod helix;
mod normalised;
mod power_law;
mod table;

pub use beam::Beam;
pub use table::Table;

/// Defines the spring and the kinds in the order of lists. A line has the module of a kind, its parameters, and the kind, or those
/// of the same parameters, with the words for files and screens.
macro_rules! kinds {
    (
        $(#[$meta:meta])*
        pub struct Spring { $($common:tt)+ }

        $(#[$plain_meta:meta])*
        PowerLaw = $plain:literal;
        $($field:ident: $part:ident { $($(#[$kind_meta:meta])* $kind:ident = $word:literal),+ })+
    ) => {
        parts! {
            $(#[$meta])*
            pub struct Spring at (mechanism.spring) {
                $($common)+
                $(#[doc = concat!("Parameters of ", $("`", $word, "` "),+)] pub $field: $field::$part = $field::$part::default();)+
            }
        }

        labelled_enum! {
            /// The spring's force law.
            pub enum SpringKind: word {
                $(#[$plain_meta])*
                PowerLaw = $plain,
                $($($(#[$kind_meta])* $kind = $word,)+)+
            }
        }

        impl Spring {
            /// The law of its kind.
            pub(in crate::model) fn law(&self) -> &dyn Law {
                match self.kind {
                    SpringKind::PowerLaw => &power_law::Plain,
                    $($(SpringKind::$kind)|+ => &self.$field,)+
                }
            }
        }

        /// The rows of the spring.
        pub(in crate::model) fn spring_rows() -> Vec<Variable> {
            let of_kind = |listed, rows| placed(Group::Mechanism, listed, Scene::is_sprung, rows);
            [
                of_kind(|_| true, Spring::rows()),
                $(of_kind(
                    |scene| matches!(scene.mechanism.spring.kind, $(SpringKind::$kind)|+),
                    $field::$part::rows(),
                ),)+
                of_kind(is_mass_of_wire, Wire::rows()),
            ]
            .concat()
        }
    };
}

kinds! {
    /// Spring of a scene: its kind, and the parameters of all kinds. Changing the kind keeps the parameters of the others.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Spring {
        pub kind: SpringKind = SpringKind::PowerLaw => "spring", "force law", "the spring's force law",
            choice().own_name("spring_kind").source("thesis equation 9.3, chapters 5 and 6");
        pub coefficient: f64 = 1e5 => "k", "stiffness", "spring coefficient: the spring's force is k |x|^n sgn(x)",
            number(SpringCoefficient, NonNegative).own_name("stiffness").thesis_range(Some((0.0, 7.5e6))).is_log(true)
            .when(|scene| scene.mechanism.spring.kind == SpringKind::PowerLaw)
            .source("thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)");
        pub exponent: f64 = 1.0 => "n", "exponent", "spring exponent",
            number(Number, From(MIN_EXPONENT)).thesis_range(Some((0.1, 3.0))).is_log(true)
            .when(|scene| matches!(scene.mechanism.spring.kind, SpringKind::PowerLaw | SpringKind::Normalised))
            .used(|scene| !scene.mechanism.spring.is_absent())
            .source("thesis Table 9.2 (range searched)");
        pub count: f64 = 1.0 => "N_spring", "springs", "number of equal springs that act in parallel",
            number(Number, Positive)
            .when(|scene| scene.mechanism.spring.kind != SpringKind::PowerLaw || !scene.mechanism.spring.is_single())
            .source("thesis Figure 6.9; 1 unless given");
        pub own_mass: OwnMass = OwnMass::Ignored => "own_mass", "spring inertia",
            "whether the part of the spring that moves with the plate adds to its mass",
            choice().is_seldom(true).source("thesis section 8.3.1: springs are massless");
        pub mass_kg: Option<f64> = None => "m_spring", "spring mass", "the spring's whole mass",
            optional(Mass, NonNegative, "auto")
            .when(|scene| scene.mechanism.spring.own_mass == OwnMass::Counted || scene.mechanism.spring.mass_kg.is_some())
            .source("auto: of its beams, U/e_spring, or of a coil 4 rho G U/tau^2 (thesis section 9.5.1)");
        /// The wire it is wound of, where its mass follows from that.
        pub wire: Wire = Wire::default();
    }

    /// `k |x|^n sgn(x)`.
    PowerLaw = "power-law";
    normalised: Normalised { Normalised = "normalised" }
    beam: Beam { Cantilever = "prbm-cantilever", FixedGuided = "prbm-guided" }
    bistable: Bistable { Bistable = "bistable" }
    constant: ConstantForce { ConstantForce = "constant" }
    column: Column { Column = "column" }
    helix: Helix { Helix = "helix" }
    crush: Crush { Crush = "crush" }
    table: Table { Table = "table" }
}

/// The law of a kind of spring. `self` are its own parameters, `spring` has those of every kind; both are valid.
pub(in crate::model) trait Law {
    /// The power law it is by itself, if it is one.
    fn power_law(&self, _: &Spring) -> Option<PowerLaw> {
        None
    }

    /// Returns the force over displacement. `_crushed_m` is the largest displacement so far of a spring that crushes, m.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        Curve::power(self.power_law(spring).unwrap_or(PowerLaw::NONE))
    }

    /// Checks the rules between its parameters.
    fn check(&self) -> Result<(), VariableError> {
        Ok(())
    }

    /// Up to which displacements on one side, 1 or -1, it is valid, m, and what happens beyond, in words; the nearest first.
    fn limits(&self, _: &Spring, _side: f64) -> Vec<(f64, &'static str)> {
        Vec::new()
    }

    /// Returns the spring's own mass, kg, if it follows from the parameters or from a given energy per mass.
    fn mass_kg(&self, _: &Spring, _energy_j_kg: Option<f64>) -> Option<f64> {
        None
    }

    /// The part of its mass that moves with its end: that with the kinetic energy of its static shape, here of a coil spring.
    fn moving_part(&self, _: &Spring) -> f64 {
        1.0 / 3.0
    }

    /// The additional mass with the kinetic energy of what turns as it yields, kg.
    fn rotation_kg(&self) -> f64 {
        0.0
    }

    /// The bending stress at a displacement over the yield strength, of a spring that bends.
    fn stress_ratio(&self, _: &Spring, _x_m: f64) -> Option<f64> {
        None
    }

    /// The displacement at which it yields before any other limit, m.
    fn yields_at_m(&self, _: &Spring) -> Option<f64> {
        None
    }
}

impl Spring {
    /// Whether there is exactly one of it.
    pub fn is_single(&self) -> bool {
        (self.count - 1.0).abs() < f64::EPSILON
    }

    /// Whether it is a power law without force.
    pub fn is_absent(&self) -> bool {
        self.power_law().is_some_and(PowerLaw::is_absent)
    }

    /// The power law it is by itself, if it is one.
    pub fn power_law(&self) -> Option<PowerLaw> {
        self.law().power_law(self)
    }

    /// The displacement at which it yields, m; `None` where other limits come first or it does not bend.
    pub fn yields_at_m(&self) -> Option<f64> {
        self.law().yields_at_m(self)
    }
}

/// Without a given energy per mass a coil's mass follows from its wire.
fn is_mass_of_wire(scene: &Scene) -> bool {
    let mechanism = &scene.mechanism;
    let is_coil = mechanism.spring.power_law().is_some();
    is_coil && mechanism.energy_j_kg.is_none() && mechanism.has_springs()
}
