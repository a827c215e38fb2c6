//! A measured force over displacement.

use std::sync::Arc;

use super::{Curve, Law, Piece, Spring, VariableError, parts};
use crate::model::units;
use crate::numerics::{larger, monotone, smaller};

/// Most points of a table: a measurement has fewer, and each is an event of the run.
const POINTS_MAX: usize = 2_000;

/// Rounding of what is computed from a point, relative to that: of differences of neighbours, twice.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

parts! {
    /// Points of a measured curve: the baseline's spring, 100 kN/m. One at x = 0, F = 0 at the start makes the law odd.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Table at (mechanism.spring.table) {
        /// (x m, F N) with rising x.
        pub points: Arc<[[f64; 2]]> = Arc::from([[0.0, 0.0], [0.01, 1e3], [0.05, 5e3]]);
    }
}

impl Table {
    fn is_odd(&self) -> bool {
        self.points[0][0] == 0.0 && self.points[0][1] == 0.0
    }
}

/// The slope of the line through two points, N/m.
fn chord(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]) / (to[0] - from[0])
}

/// The last of the points after one that lie, to their rounding, on one line with it, and between which the curve is that line; itself
/// where there is none.
fn straight_to(points: &[[f64; 2]], slopes: &[f64], from: usize) -> usize {
    let rounding_n = |a: [f64; 2], b: [f64; 2], slope: f64| {
        ROUNDING * (a[1].abs() + b[1].abs() + slope.abs() * (a[0].abs() + b[0].abs()))
    };
    // Slopes of the lines that miss no point so far by more.
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for to in from + 1..points.len() {
        let (before, here) = (points[to - 1], points[to]);
        let own = chord(before, here);
        let bends = |slope: f64| {
            (slope - own).abs() * (here[0] - before[0]) > rounding_n(before, here, own)
        };
        let whole = chord(points[from], here);
        if bends(slopes[to - 1]) || bends(slopes[to]) || !(least..=most).contains(&whole) {
            return to - 1;
        }
        let width = rounding_n(points[from], here, whole) / (here[0] - points[from][0]);
        (least, most) = (larger(least, whole - width), smaller(most, whole + width));
    }
    points.len() - 1
}

impl Law for Table {
    /// The points joined by shape-preserving cubics, those on a line by that line, and on along the tangents at both ends.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let points: Vec<[f64; 2]> =
            self.points.iter().map(|[x, force]| [*x, force * spring.count]).collect();
        let slopes = monotone::slopes(&points);
        let last = points.len() - 1;
        let scale_m = points[last][0] - points[0][0];
        let end = |at: usize| Piece::line(points[at][0], points[at][1], slopes[at]);
        let mut laws = Vec::with_capacity(points.len());
        let mut at = 0;
        while at < last {
            let to = straight_to(&points, &slopes, at);
            let law = if to > at {
                Piece::line(points[at][0], points[at][1], chord(points[at], points[to]))
            } else {
                let c = monotone::cubic(points[at], points[at + 1], [slopes[at], slopes[at + 1]]);
                Piece::Cubic { from_m: points[at][0], c }
            };
            laws.push((points[at][0], law));
            at = to.max(at + 1);
        }
        // A straight end goes on as the line beyond it.
        if straight_to(&points, &slopes, last - 1) < last {
            laws.push((points[last][0], end(last)));
        }
        if self.is_odd() {
            return Curve::odd(&laws, scale_m);
        }
        if straight_to(&points, &slopes, 0) == 0 {
            laws.insert(0, (f64::NEG_INFINITY, end(0)));
        }
        Curve::new(laws, scale_m)
    }

    /// A table has enough points, which are finite, rise in x, and reach the rest position.
    fn check(&self, path: &str) -> Result<(), VariableError> {
        let points = &self.points;
        let count = points.len();
        let is_finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
        let does_not_rise = |pair: &[[f64; 2]]| pair[1][0] <= pair[0][0];
        let wrong = if !(2..=POINTS_MAX).contains(&count) {
            format!(
                " has {count} points: it must have 2 to {POINTS_MAX}; write points = [[x, F], ...] in m and N, or file = \
                 \"curve.csv\""
            )
        } else if let Some(at) = points.iter().position(|point| !is_finite(point)) {
            format!(
                ": point {} is not finite: every x (m) and F (N) must be a number; remove the point",
                at + 1
            )
        } else if let Some(at) = points.windows(2).position(does_not_rise) {
            format!(
                ": x = {} m of point {} does not exceed x = {} m of the point before it: a table must rise in x; sort the points \
                 and leave only one at each x",
                units::shortest(points[at + 1][0]),
                at + 2,
                units::shortest(points[at][0])
            )
        } else if points[0][0] > 0.0 || points[count - 1][0] < 0.0 {
            format!(
                ": it goes from x = {} m, F = {} N to x = {} m, and the force at rest, x = 0, is not measured; add the point [0, 0], or subtract the first point from all",
                units::shortest(points[0][0]),
                units::shortest(points[0][1]),
                units::shortest(points[count - 1][0])
            )
        } else {
            return Ok(());
        };
        Err(VariableError(format!("{path}.table{wrong}")))
    }

    fn limits(&self, _: &Spring, side: f64) -> Vec<(f64, &'static str)> {
        let ends = self.points.first().zip(self.points.last());
        let Some(([first, _], [last, _])) = ends else { return Vec::new() };
        let behind = if self.is_odd() { -last } else { *first };
        let limit_m = if side > 0.0 { *last } else { behind };
        vec![(limit_m, "the table ends; the force goes on straight")]
    }
}
