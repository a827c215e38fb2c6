//! Two springs in parallel as one.

use crate::model::mechanism::curve::{Curve, Segments};
use crate::model::mechanism::piece::Piece;

/// Both displaced alike: the forces add.
pub(super) fn parallel(a: &Curve, b: &Curve) -> Curve {
    let mut knots_m = a.segments().knots_m.clone();
    knots_m.extend_from_slice(&b.segments().knots_m);
    knots_m.sort_by(f64::total_cmp);
    knots_m.dedup();
    let pieces = inside(&knots_m)
        .into_iter()
        .map(|x| {
            let of = |curve: &Curve| curve.piece(curve.region(x)).clone();
            Piece::Parallel(Box::new([of(a), of(b)]))
        })
        .collect();
    let scale_m = if a.scale_m() < b.scale_m() { b.scale_m() } else { a.scale_m() };
    Curve::new(Segments { knots_m, pieces }, scale_m)
}

/// A place inside each stretch between marks, the outer two included.
fn inside(marks: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (marks.first(), marks.last()) else {
        return vec![0.0];
    };
    let width = if last > first { last - first } else { 1.0 };
    let mut places = vec![first - width];
    places.extend(marks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    places.push(last + width);
    places
}
