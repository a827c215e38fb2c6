//! Power law `F_ref |x/x_ref|^n sgn(x)`, with coefficients independent of the units.

use super::{Law, PowerLaw, Spring, parts};

parts! {
    /// Power law by its force at a reference displacement.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Normalised at (mechanism.spring: Spring.normalised) {
        pub force_n: f64 = 1e3 => "F_ref", "reference force",
            "force of the normalised power law at x_ref: F_ref |x/x_ref|^n sgn(x)",
            number(Force, NonNegative).is_log(true).source("assumption: the law that no unit changes");
        pub displacement_m: f64 = 0.01 => "x_ref", "reference travel",
            "displacement at which the normalised power law has the force F_ref", number(Length, Positive);
    }
}

impl Law for Normalised {
    fn power_law(&self, spring: &Spring) -> Option<PowerLaw> {
        let scale = self.displacement_m.powf(spring.exponent);
        let coefficient = self.force_n / scale * spring.count;
        Some(PowerLaw { coefficient, exponent: spring.exponent })
    }
}
