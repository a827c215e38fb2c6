//! Two springs as one: in parallel, or in series.

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

/// Both carry the same force: the displacements add. Both laws must rise everywhere.
pub(super) fn series(a: &Curve, b: &Curve) -> Curve {
    let mut forces: Vec<f64> = Vec::new();
    for curve in [a, b] {
        forces.extend(curve.segments().knots_m.iter().map(|knot| curve.force(*knot)));
    }
    forces.sort_by(f64::total_cmp);
    // Two knots at forces that differ by rounding are one.
    forces.dedup_by(|x, y| (*x - *y).abs() <= 1e-13 * (x.abs() + y.abs()));
    let at = |curve: &Curve, force: f64| curve.displaced_by(force);
    let knots: Vec<[f64; 2]> = forces.iter().map(|force| [at(a, *force), at(b, *force)]).collect();
    let knots_m = knots.iter().map(|ends| ends[0] + ends[1]).collect();
    let pieces = inside(&forces)
        .into_iter()
        .enumerate()
        .map(|(region, force)| {
            let of = |curve: &Curve| curve.piece(curve.region(at(curve, force))).clone();
            let low_m = if region == 0 { [f64::NEG_INFINITY; 2] } else { knots[region - 1] };
            let high_m = knots.get(region).copied().unwrap_or([f64::INFINITY; 2]);
            Piece::Series { laws: Box::new([of(a), of(b)]), low_m, high_m }
        })
        .collect();
    Curve::new(Segments { knots_m, pieces }, a.scale_m() + b.scale_m())
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
