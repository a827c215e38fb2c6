//! Kinds of springs: their table, and the trait of their laws.
//!
//! Each kind has a file with its parameters, force law, mass and range of validity. Chapters 5, 6, 9.4 and 9.5 of the thesis name the
//! kinds.

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::curve::Curve;
use crate::model::mechanism::piece::Piece;
use crate::model::power_law::{MIN_EXPONENT, PowerLaw};
use crate::model::variables::error::VariableError;
use crate::model::variables::part::{NO_VALUES, part, parts, placed};
use crate::model::variables::row::{Group, Row};

pub(in crate::model) mod beam;
mod bistable;
mod column;
mod constant;
mod crush;
mod helix;
mod normalised;
mod power_law;
pub(in crate::model) mod table;
mod wire;

pub use wire::{OwnMass, Wire};

/// Defines the spring and its kinds in the order of lists. A line has a module, its parameters, and the kinds with these parameters and
/// their words in files and on screens.
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
            pub struct Spring at (mechanism.spring: Spring) {
                $($common)+
                $(#[doc = concat!("Parameters of ", $("`", $word, "` "),+)] pub $field: $field::$part = $field::$part::default();)+
            }
        }

        labelled_enum! {
            /// Force law of a spring.
            pub enum SpringKind: word {
                $(#[$plain_meta])*
                PowerLaw = $plain,
                $($($(#[$kind_meta])* $kind = $word,)+)+
            }
        }

        impl Spring {
            /// Returns the law of the kind.
            pub(in crate::model) fn law(&self) -> &dyn Law {
                match self.kind {
                    SpringKind::PowerLaw => &power_law::Plain,
                    $($(SpringKind::$kind)|+ => &self.$field,)+
                }
            }
        }

        /// Returns the rows of the spring and of its kinds, which have an effect under a condition.
        pub(in crate::model) fn spring_rows<S>(used: fn(&S) -> bool) -> Vec<Row<S>>
        where
            S: AsRef<Spring> + AsMut<Spring>,
        {
            let of_kind = |listed, rows| placed(Group::Mechanism, listed, used, rows);
            let rows: [Vec<Row<S>>; _] = [
                of_kind(|_| true, Spring::rows()),
                $(of_kind(
                    |scene| matches!(part::<Spring>(scene).kind, $(SpringKind::$kind)|+),
                    $field::$part::rows(),
                ),)+
            ];
            rows.into_iter().flatten().collect()
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
            .when(|scene| part::<Spring>(scene).kind == SpringKind::PowerLaw)
            .source("thesis Table 9.2 (range searched; the text of 9.2.2 says 10 MN/m)");
        pub exponent: f64 = 1.0 => "n", "exponent", "spring exponent",
            number(Number, From(MIN_EXPONENT)).thesis_range(Some((0.1, 3.0))).is_log(true)
            .when(|scene| matches!(part::<Spring>(scene).kind, SpringKind::PowerLaw | SpringKind::Normalised))
            .used(|scene| !part::<Spring>(scene).is_absent())
            .source("thesis Table 9.2 (range searched)");
        pub count: f64 = 1.0 => "N_spring", "springs", "number of equal springs that act in parallel",
            number(Number, Positive)
            .when(|scene| part::<Spring>(scene).kind != SpringKind::PowerLaw || !part::<Spring>(scene).is_single())
            .source("thesis Figure 6.9; 1 unless given");
        pub own_mass: OwnMass = OwnMass::Ignored => "own_mass", "spring inertia",
            "whether the part of the spring that moves with the plate adds to its mass",
            choice().is_seldom(true).source("thesis section 8.3.1: springs are massless");
        pub mass_kg: Option<f64> = None => "m_spring", "spring mass", "the spring's whole mass",
            optional(Mass, NonNegative, "auto")
            .when(|scene| part::<Spring>(scene).own_mass == OwnMass::Counted || part::<Spring>(scene).mass_kg.is_some())
            .source("auto: of its beams, U/e_spring, or of a coil 4 rho G U/tau^2 (thesis section 9.5.1)");
        /// Wire of a coil spring, for its mass.
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

/// Law of a kind of spring. `self` has its own parameters, `spring` those of all kinds; both are valid.
pub(in crate::model) trait Law {
    /// Returns the law if it is a power law.
    fn power_law(&self, _: &Spring) -> Option<PowerLaw> {
        None
    }

    /// Returns the force over displacement. `_crushed_m` is the largest displacement so far of a spring that crushes, m.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        Curve::power(self.power_law(spring).unwrap_or(PowerLaw::NONE))
    }

    /// Checks the rules between the parameters.
    fn check(&self) -> Result<(), VariableError> {
        Ok(())
    }

    /// Returns the limits of validity on one side (1 or -1), m, nearest first, with a text about the behaviour beyond.
    fn limits(&self, _: &Spring, _side: f64) -> Vec<(f64, &'static str)> {
        Vec::new()
    }

    /// Returns the spring's own mass, kg, if it follows from the parameters or from a given energy per mass.
    fn mass_kg(&self, _: &Spring, _energy_j_kg: Option<f64>) -> Option<f64> {
        None
    }

    /// Returns the fraction of the mass that moves with the end, by the kinetic energy of the static shape; by default of a coil spring.
    fn moving_part(&self, _: &Spring) -> f64 {
        1.0 / 3.0
    }

    /// Returns the mass equivalent to geared rotation, kg.
    fn rotation_kg(&self) -> f64 {
        0.0
    }

    /// Returns the bending stress at a displacement, relative to the yield strength; `None` for a spring without bending.
    fn stress_ratio(&self, _: &Spring, _x_m: f64) -> Option<f64> {
        None
    }

    /// Returns the displacement at which the spring yields, m; `None` if another limit comes first.
    fn yields_at_m(&self, _: &Spring) -> Option<f64> {
        None
    }
}

impl Spring {
    /// Returns `true` for a single spring.
    pub fn is_single(&self) -> bool {
        (self.count - 1.0).abs() < f64::EPSILON
    }

    /// Returns `true` for a law without force.
    pub fn is_absent(&self) -> bool {
        self.power_law().is_some_and(PowerLaw::is_absent)
    }

    /// Returns the law if it is a power law.
    pub fn power_law(&self) -> Option<PowerLaw> {
        self.law().power_law(self)
    }

    /// Returns the fraction of the mass that moves with the end, by the kinetic energy of the static shape.
    pub fn moving_part(&self) -> f64 {
        self.law().moving_part(self)
    }

    /// Returns the displacement at which the spring yields, m; `None` if another limit comes first, or without bending.
    pub fn yields_at_m(&self) -> Option<f64> {
        self.law().yields_at_m(self)
    }
}
