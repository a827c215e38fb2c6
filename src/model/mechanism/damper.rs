//! The force law of the damper, from its parameters: the one place that knows them.

use crate::model::mechanism::PowerLaw;
use crate::model::scene::Damper;

/// The power law of a valid damper.
pub fn law(damper: &Damper) -> PowerLaw {
    PowerLaw { coefficient: damper.coefficient, exponent: damper.exponent }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_a_damper_resists_with_b_times_a_power_of_the_velocity() {
        let law = law(&Damper { coefficient: 3.0, exponent: 2.0 });
        assert!((law.force(2.0) - 12.0).abs() < 1e-14 && (law.force(-2.0) + 12.0).abs() < 1e-14);
    }
}
