//! Mechanism that carries the plate: springs, damper and stop.

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::kinds::{OwnMass, Spring, SpringKind};
use crate::model::power_law::{MIN_EXPONENT, PowerLaw};
use crate::model::scene::bodies::{Plate, is_sprung};
use crate::model::scene::contact::{Contact, is_listing};
use crate::model::variables::part::{TABLE_9_2, part, parts, rows};

parts! {
    /// Springs, damper and stop.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Mechanism at (mechanism: Mechanism) {
        /// Damper.
        pub damper: PowerLaw = PowerLaw::NONE;
        /// First spring.
        pub spring: Spring = Spring::default();
        pub combination: Combination = Combination::Alone => "combine", "second spring",
            "a second spring: none (alone), or a power law parallel to the first spring (parallel)",
            choice().is_seldom(true).source("thesis section 6.2.8; one spring in chapter 9");
        /// Power law of the second spring; no effect if the first spring is alone.
        pub second: PowerLaw = PowerLaw { coefficient: 1e5, exponent: 1.0 };
        pub energy_j_kg: Option<f64> = None => "e_spring", "specific energy",
            "energy per mass of the spring or absorber, which gives its least mass; without it only that of coils is known",
            optional(SpecificEnergy, Positive, "auto").aliases(&["energy_j"]).is_seldom(true).listed(|scene| part::<Mechanism>(scene).energy_j_kg.is_some())
            .source("auto: tau^2/(4 rho G) of the wire; the library of absorbers has others");
        /// Stop.
        pub stop: Stop = Stop::default();
    }

    /// Mechanical stop, which acts on the plate.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Stop at (mechanism: Mechanism.stop) reads(Plate, Contact) {
        pub position_m: Option<f64> = None => "x_stop", "stop position", "where the plate meets a mechanical stop",
            optional(Length, Any, "none").aliases(&["stop"]).source("thesis sections 9.5.1 and 9.6");
        pub kind: StopKind = StopKind::Rigid => "stop_kind", "kind of stop",
            "rigid: an impact with restitution; elastic: a one-sided spring and damper",
            choice().used(has_stop).source("assumption: the thesis names no kind");
        pub restitution: f64 = 0.0 => "e", "restitution", "restitution of a rigid stop: w becomes -e w",
            number(Number, Between(0.0, 1.0)).used(|scene| has_stop_of(scene, StopKind::Rigid));
        pub stiffness_n_m: f64 = 1e8 => "k_stop", "stop stiffness", "stiffness of an elastic stop",
            number(Stiffness, Positive).is_log(true).used(|scene| has_stop_of(scene, StopKind::Elastic));
        pub damping_n_s_m: f64 = 0.0 => "b_stop", "stop damping", "damping of an elastic stop (it only pushes)",
            number(Damping, NonNegative).is_log(true).used(|scene| has_stop_of(scene, StopKind::Elastic));
    }
}

labelled_enum! {
    /// Arrangement of the first and the second spring.
    pub enum Combination: word {
        Alone = "alone",
        /// Springs in parallel: equal displacement, added forces.
        Parallel = "parallel",
    }

    /// Kind of stop.
    pub enum StopKind: word {
        Rigid = "rigid",
        Elastic = "elastic",
    }
}

rows! {
    /// Returns the rows of the damper.
    fn damper_rows at (mechanism: Mechanism.damper);
    coefficient: f64 => "b", "damping", "damper coefficient: the damper's force is b |w|^m sgn(w)",
        number(DamperCoefficient, NonNegative).own_name("damping").thesis_range(Some((0.0, 2000.0))).is_log(true).source(TABLE_9_2);
    exponent: f64 => "m", "damper exponent", "damper exponent",
        number(Number, From(MIN_EXPONENT)).is_log(true).used(|scene| !part::<Mechanism>(scene).damper.is_absent()).source("thesis section 9.2.2: 1");
}

rows! {
    /// Returns the rows of the second spring's power law.
    fn second_rows at (mechanism: Mechanism.second);
    coefficient: f64 => "k_2", "second stiffness", "coefficient of the second spring: its force is k_2 |x|^n_2 sgn(x)",
        number(SpringCoefficient, NonNegative).is_log(true).source("thesis section 6.2.8");
    exponent: f64 => "n_2", "second exponent", "exponent of the second spring",
        number(Number, From(MIN_EXPONENT)).is_log(true).used(|scene| part::<Mechanism>(scene).second.coefficient > 0.0).source("thesis section 6.2.8");
}

/// Returns `true` if the plate can meet a stop.
pub(in crate::model) fn may_stop<S: AsRef<Plate> + AsRef<Contact>>(scene: &S) -> bool {
    is_sprung(scene) && !is_listing(scene)
}

/// Returns `true` if the plate has a stop.
pub(super) fn has_stop<S>(scene: &S) -> bool
where
    S: AsRef<Plate> + AsRef<Contact> + AsRef<Mechanism>,
{
    may_stop(scene) && part::<Mechanism>(scene).stop.position_m.is_some()
}

/// Returns `true` if the plate has a stop of this kind.
fn has_stop_of<S>(scene: &S, kind: StopKind) -> bool
where
    S: AsRef<Plate> + AsRef<Contact> + AsRef<Mechanism>,
{
    has_stop(scene) && part::<Mechanism>(scene).stop.kind == kind
}

impl Mechanism {
    /// Returns the law of the second spring; `PowerLaw::NONE` if it does not act.
    pub fn second_law(&self) -> PowerLaw {
        self.second.only_if(self.combination == Combination::Parallel)
    }

    /// Returns `true` if there is a spring.
    pub fn has_springs(&self) -> bool {
        !(self.spring.is_absent() && self.second_law().is_absent())
    }

    /// Returns the energy capacity per mass of the spring or absorber, J/kg: given, or from the wire; `None` for springs other than coils.
    pub fn specific_energy_j_kg(&self) -> Option<f64> {
        self.energy_j_kg
            .or_else(|| self.spring.power_law().map(|_| self.spring.wire.specific_energy_j_kg()))
    }

    /// Returns `true` if a spring is a coil; every power law is assumed to be one.
    pub fn has_coil(&self) -> bool {
        let laws = [self.spring.power_law(), Some(self.second_law())];
        laws.into_iter().flatten().any(|law| !law.is_absent())
    }

    /// Returns the minimum mass of springs for a stored energy, J, kg; `None` if that energy or the specific energy is unknown.
    pub fn min_spring_kg(&self, stored_j: Option<f64>) -> Option<f64> {
        let stored_j = stored_j?;
        if stored_j == 0.0 { Some(0.0) } else { Some(stored_j / self.specific_energy_j_kg()?) }
    }

    /// Returns `true` for the mechanism of the thesis: one massless power law `k |x|^n`.
    pub fn is_plain(&self) -> bool {
        let spring = &self.spring;
        self.combination == Combination::Alone
            && spring.kind == SpringKind::PowerLaw
            && spring.own_mass == OwnMass::Ignored
            && spring.is_single()
    }
}
