//! Spring of the thesis, `k |x|^n sgn(x)`, with the coefficient and the exponent that every spring has.

use super::{Law, PowerLaw, Spring};

pub(super) struct Plain;

impl Law for Plain {
    fn power_law(&self, spring: &Spring) -> Option<PowerLaw> {
        let coefficient = spring.coefficient * spring.count;
        Some(PowerLaw { coefficient, exponent: spring.exponent })
    }
}
