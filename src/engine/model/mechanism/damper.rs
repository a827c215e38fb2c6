//! The damper: its parameters and its force law.

use crate::model::mechanism::PowerLaw;
use crate::model::variables::part::{TABLE_9_2, parts};

parts! {
    /// A power-law damper.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Damper at (mechanism.damper) {
        pub coefficient: f64 = 0.0 => "b", "damping", "damper coefficient: the damper's force is b |w|^m sgn(w)",
            number(DamperCoefficient, NonNegative).called("damping").searched(0.0, 2000.0).log().from(TABLE_9_2);
        pub exponent: f64 = 1.0 => "m", "damper exponent", "damper exponent",
            number(Number, Positive).log().used_when(|scene| !scene.mechanism.damper.is_absent())
            .from("thesis section 9.2.2: 1");
    }
}

impl Damper {
    /// Whether there is none.
    pub fn is_absent(&self) -> bool {
        self.coefficient == 0.0
    }

    /// The force law of a valid damper.
    pub fn law(&self) -> PowerLaw {
        PowerLaw { coefficient: self.coefficient, exponent: self.exponent }
    }
}
