//! The force law of each kind of spring, from its parameters.
//!
//! Chapters 5, 6, 9.4 and 9.5 of the thesis name the kinds. Those of beams are in `beam.rs`.

use crate::model::mechanism::curve::{Curve, Segments};
use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{PowerKind, PowerLaw};
use crate::model::scene::{self, SpringKind};
use crate::numerics::{larger, monotone, smaller};

/// Half-width of the place around zero where a power law of a combination is straight, m: below what a run resolves.
const CORE_M: f64 = 1e-10;

/// The power law a spring is by itself, if it is one.
pub fn power_law(spring: &scene::Spring) -> Option<PowerLaw> {
    let law = |coefficient: f64, exponent: f64| {
        Some(PowerLaw { coefficient: coefficient * spring.count, exponent })
    };
    match spring.kind {
        SpringKind::PowerLaw => law(spring.coefficient, spring.exponent),
        SpringKind::Normalised => {
            let scale = spring.normalised.displacement_m.powf(spring.exponent);
            law(spring.normalised.force_n / scale, spring.exponent)
        }
        SpringKind::Helix => law(spring.helix.stiffness_n_m, 1.0),
        _ => None,
    }
}

/// The law of a valid spring as a curve, whatever its kind; an absorber is not crushed yet.
pub fn curve(spring: &scene::Spring) -> Curve {
    curve_after(spring, 0.0)
}

/// The same of an absorber that was crushed up to a displacement, m. Other kinds have no memory.
pub(super) fn curve_after(spring: &scene::Spring, crushed_m: f64) -> Curve {
    if let Some(law) = power_law(spring) {
        return power_curve(law);
    }
    let n = spring.count;
    match spring.kind {
        SpringKind::Cantilever | SpringKind::FixedGuided => spring.beam.curve(spring.kind, n),
        SpringKind::Bistable => bistable(spring, n),
        SpringKind::ConstantForce => constant(spring, n),
        SpringKind::Column => column(spring, n),
        SpringKind::Crush => crush(&spring.crush, n, crushed_m),
        SpringKind::Table => table(&spring.table.points, n),
        SpringKind::PowerLaw | SpringKind::Normalised | SpringKind::Helix => {
            power_curve(PowerLaw::NONE)
        }
    }
}

/// A power law that can be combined with others: straight very close to zero, where it may be singular.
fn power_curve(law: PowerLaw) -> Curve {
    let scale_m = 1e-3;
    if matches!(law.kind(), PowerKind::Absent | PowerKind::Linear) {
        let pieces = vec![Piece::line(0.0, 0.0, law.coefficient)];
        return Curve::new(Segments { knots_m: Vec::new(), pieces }, scale_m);
    }
    let core = Piece::line(0.0, 0.0, law.force(CORE_M) / CORE_M);
    let side = |side: f64| Piece::Power { law, side };
    let pieces = vec![side(-1.0), core, side(1.0)];
    Curve::new(Segments { knots_m: vec![-CORE_M, CORE_M], pieces }, scale_m)
}

/// C x (x - u) (x - s): stable at 0 and s, unstable at u; C from the greatest force on the way out of 0.
fn bistable(spring: &scene::Spring, count: f64) -> Curve {
    let s = spring.bistable.second_m;
    let u = spring.bistable.unstable_m.unwrap_or(0.5 * s);
    // The slope 3x² - 2(u + s)x + us is zero at the barrier.
    let sum = u + s;
    let top = (sum - (sum * sum - 3.0 * u * s).sqrt()) / 3.0;
    let factor = count * spring.bistable.barrier_n / (top * (top - u) * (top - s));
    let c = [0.0, factor * u * s, -factor * sum, factor];
    // One cubic all over; its zeros are knots, between which the energy only rises or only falls.
    let pieces = vec![Piece::Cubic { from_m: 0.0, c }; 4];
    Curve::new(Segments { knots_m: vec![0.0, u, s], pieces }, s)
}

fn constant(spring: &scene::Spring, count: f64) -> Curve {
    let (rise, force) = (spring.constant.rise_m, count * spring.constant.force_n);
    odd(&[(0.0, Piece::line(0.0, 0.0, force / rise)), (rise, Piece::line(0.0, force, 0.0))], rise)
}

/// Straight up to the critical force, a smooth way to the plateau, and on along it.
fn column(spring: &scene::Spring, count: f64) -> Curve {
    let column = &spring.column;
    let onset = column.critical_n / column.stiffness_n_m;
    let folded = onset + column.fall_m;
    let (critical, plateau) = (count * column.critical_n, count * column.plateau_n);
    let fall = monotone::cubic([onset, critical], [folded, plateau], [0.0, 0.0]);
    odd(
        &[
            (0.0, Piece::line(0.0, 0.0, count * column.stiffness_n_m)),
            (onset, Piece::Cubic { from_m: onset, c: fall }),
            (folded, Piece::line(0.0, plateau, 0.0)),
        ],
        folded,
    )
}

/// Nothing where the absorber has set, an elastic rise up to where it was crushed last, a constant force up to its stroke, and
/// solid from there on.
fn crush(crush: &scene::Crush, count: f64, crushed_m: f64) -> Curve {
    let (force, stiffness) = (count * crush.force_n, count * crush.stiffness_n_m);
    let (rise, stroke) = (crush.rise_m(), crush.stroke_m);
    let from = smaller(larger(crushed_m, rise), stroke);
    let elastic = |at: f64| Piece::line(at, force, stiffness);
    let mut knots_m = vec![from - rise];
    let mut pieces = vec![Piece::line(0.0, 0.0, 0.0), elastic(from)];
    if from < stroke {
        knots_m.extend([from, stroke]);
        pieces.extend([Piece::line(from, force, 0.0), elastic(stroke)]);
    }
    Curve::new(Segments { knots_m, pieces }, stroke)
}

/// The points joined by shape-preserving cubics, and on along the tangents at both ends.
fn table(points: &[[f64; 2]], count: f64) -> Curve {
    let points: Vec<[f64; 2]> = points.iter().map(|[x, force]| [*x, force * count]).collect();
    let slopes = monotone::slopes(&points);
    let last = points.len() - 1;
    let scale_m = points[last][0] - points[0][0];
    let end = |at: usize| Piece::line(points[at][0], points[at][1], slopes[at]);
    let mut laws = Vec::with_capacity(points.len());
    for at in 0..last {
        let c = monotone::cubic(points[at], points[at + 1], [slopes[at], slopes[at + 1]]);
        laws.push((points[at][0], Piece::Cubic { from_m: points[at][0], c }));
    }
    laws.push((points[last][0], end(last)));
    if points[0][0] == 0.0 && points[0][1] == 0.0 {
        return odd(&laws, scale_m);
    }
    let knots_m = laws.iter().map(|(from, _)| *from).collect();
    let pieces = std::iter::once(end(0)).chain(laws.into_iter().map(|(_, piece)| piece)).collect();
    Curve::new(Segments { knots_m, pieces }, scale_m)
}

/// The odd law whose positive side has these pieces, each from where it begins; the first begins at 0.
fn odd(laws: &[(f64, Piece)], scale_m: f64) -> Curve {
    let mirrored = laws.iter().rev().map(|(_, piece)| mirror(piece));
    let straight = straight_through_zero(&laws[0].1);
    let skip = usize::from(straight);
    let pieces: Vec<Piece> =
        mirrored.chain(laws.iter().skip(skip).map(|(_, piece)| piece.clone())).collect();
    let behind = laws.iter().skip(1).rev().map(|(from, _)| -from);
    let ahead = laws.iter().skip(skip).map(|(from, _)| *from);
    Curve::new(Segments { knots_m: behind.chain(ahead).collect(), pieces }, scale_m)
}

/// Whether a piece is its own mirror image: then zero is not a knot.
fn straight_through_zero(piece: &Piece) -> bool {
    matches!(piece, Piece::Cubic { from_m, c } if *from_m == 0.0 && c[0] == 0.0 && c[2] == 0.0)
}

/// -F(-x) of a cubic.
fn mirror(piece: &Piece) -> Piece {
    match piece {
        Piece::Cubic { from_m, c } => {
            Piece::Cubic { from_m: -from_m, c: [-c[0], c[1], -c[2], c[3]] }
        }
        _ => piece.clone(),
    }
}
