//! The thesis's spring, `k |x|^n sgn(x)`, from the coefficient and the exponent that every spring has.

use super::{Law, Spring};
use crate::model::mechanism::PowerLaw;
use crate::model::mechanism::curve::{Curve, SCALE_M};
use crate::model::mechanism::piece::Piece;

pub(super) struct Plain;

impl Law for Plain {
    fn power_law(&self, spring: &Spring) -> Option<PowerLaw> {
        let coefficient = spring.coefficient * spring.count;
        Some(PowerLaw { coefficient, exponent: spring.exponent })
    }
}

impl Curve {
    /// A power law as a curve, to be combined with others: a piece on either side of zero, or one where it goes smoothly through it.
    pub(in crate::model::mechanism) fn power(law: PowerLaw) -> Self {
        let side = |side: f64| Piece::Power { law, side };
        let (knots_m, pieces) = if law.is_smooth_at_zero() {
            (Vec::new(), vec![side(1.0)])
        } else {
            (vec![0.0], vec![side(-1.0), side(1.0)])
        };
        Self::new(knots_m, pieces, SCALE_M)
    }
}
