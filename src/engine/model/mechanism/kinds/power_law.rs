//! The thesis's spring, `k |x|^n sgn(x)`, from the coefficient and the exponent that every spring has.

use super::{Law, Spring};
use crate::model::mechanism::curve::{Curve, Segments};
use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{PowerKind, PowerLaw};

/// Half-width of the place around zero where a power law of a combination is straight, m: beside a law that does nothing it changes the
/// depth by 3e-10 at most. Within a smaller one a steep law is too stiff.
const CORE_M: f64 = 1e-15;

pub(super) struct Plain;

impl Law for Plain {
    fn power_law(&self, spring: &Spring) -> Option<PowerLaw> {
        let coefficient = spring.coefficient * spring.count;
        Some(PowerLaw { coefficient, exponent: spring.exponent })
    }

    fn has_exponent(&self) -> bool {
        true
    }

    fn is_coil(&self) -> bool {
        true
    }
}

impl Curve {
    /// A power law that can be combined with others: straight very close to zero, where it may be singular.
    pub(in crate::model::mechanism) fn power(law: PowerLaw) -> Self {
        let scale_m = 1e-3;
        if matches!(law.kind(), PowerKind::Absent | PowerKind::Linear) {
            let pieces = vec![Piece::line(0.0, 0.0, law.coefficient)];
            return Self::new(Segments { knots_m: Vec::new(), pieces }, scale_m);
        }
        let core = Piece::line(0.0, 0.0, law.force(CORE_M) / CORE_M);
        let side = |side: f64| Piece::Power { law, side };
        let pieces = vec![side(-1.0), core, side(1.0)];
        Self::new(Segments { knots_m: vec![-CORE_M, CORE_M], pieces }, scale_m)
    }
}
