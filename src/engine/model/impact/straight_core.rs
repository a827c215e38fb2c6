//! A power law of a combination cannot be expanded at zero: for Taylor steps it is straight very close to it.

use std::sync::Arc;

use crate::model::mechanism::Spring;
use crate::model::mechanism::curve::{Curve, Segments};
use crate::model::mechanism::piece::Piece;

/// Half-width of the straight place around zero, m: beside a law that does nothing it changes the depth by 3e-10 at most. Within a
/// smaller one a steep law is too stiff.
const CORE_M: f64 = 1e-15;

/// The spring, straight about zero where it is a curve that cannot be expanded there.
pub(super) fn with_straight_core(spring: Spring) -> Spring {
    let Some(curve) = spring.curve() else { return spring };
    let above = curve.region(0.0);
    if !curve.piece(above).is_singular() {
        return spring;
    }
    let Segments { mut knots_m, mut pieces } = curve.segments().clone();
    let slope = (curve.force(CORE_M) - curve.force(-CORE_M)) / (2.0 * CORE_M);
    pieces.insert(above, Piece::line(0.0, curve.force(0.0), slope));
    knots_m.splice(above - 1..above, [-CORE_M, CORE_M]);
    Spring::Curve(Arc::new(Curve::new(Segments { knots_m, pieces }, curve.scale_m())))
}
