//! Measured force-displacement curve.

use std::sync::Arc;

use super::{Curve, Law, Piece, Spring, VariableError, parts};
use crate::model::units;
use crate::numerics::{larger, monotone};

/// Maximum number of points of a table; each is an event of the run.
const POINTS_MAX: usize = 2_000;

/// Tolerance for three points on one line, relative to the maximum force of the table; above rounding error.
const ROUNDING: f64 = 1e-12;

parts! {
    /// Points of a measured curve; by default of a spring with 100 kN/m. A first point x = 0, F = 0 makes the law odd.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Table at (mechanism.spring: Spring.table) {
        /// Points (x in m, F in N) with increasing x.
        pub points: Arc<[[f64; 2]]> = Arc::from([[0.0, 0.0], [0.01, 1e3], [0.05, 5e3]]);
    }
}

impl Table {
    fn is_odd(&self) -> bool {
        self.points[0][0] == 0.0 && self.points[0][1] == 0.0
    }
}

impl Law for Table {
    /// Returns the monotone cubic interpolant of the points, linear for points on a line, with tangents beyond both ends.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let mut points: Vec<[f64; 2]> =
            self.points.iter().map(|[x, force]| [*x, force * spring.count]).collect();
        let mut slopes = monotone::slopes(&points);
        let last = points.len() - 1;
        let scale_m = points[last][0] - points[0][0];
        let rounding_n = ROUNDING * points.iter().map(|point| point[1].abs()).fold(0.0, larger);
        // A point on the tangent beyond the end.
        points.push([points[last][0] + scale_m, points[last][1] + slopes[last] * scale_m]);
        slopes.push(slopes[last]);
        let line = |at: usize| Piece::line(points[at][0], points[at][1], slopes[at]);
        let before = (!self.is_odd()).then(|| (f64::NEG_INFINITY, line(0)));
        let mut laws = Vec::from_iter(before);
        for at in 0..=last {
            let (from, to) = (points[at], points[at + 1]);
            // A piece continues if it also has the point and the slope at the next knot.
            let goes_on = |piece: &Piece| {
                let slope_off = piece.tangent(to[0]) - slopes[at + 1];
                let off_n = [piece.force(to[0]) - to[1], slope_off * (to[0] - from[0])];
                off_n.iter().all(|off_n| off_n.abs() <= rounding_n)
            };
            if !laws.last().is_some_and(|(_, before)| goes_on(before)) {
                let c = monotone::cubic(from, to, [slopes[at], slopes[at + 1]]);
                let cubic = Piece::Cubic { from_m: from[0], c };
                laws.push((from[0], if goes_on(&line(at)) { line(at) } else { cubic }));
            }
        }
        if self.is_odd() { Curve::odd(&laws, scale_m) } else { Curve::new(laws, scale_m) }
    }

    /// Checks that the table has enough points, which are finite and increasing in x and include the rest position.
    fn check(&self) -> Result<(), VariableError> {
        let points = &self.points;
        let count = points.len();
        let is_finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
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
        } else if let Some(at) = points.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
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
        let key = "mechanism.spring.table";
        Err(VariableError::together(&[key], format!("{key}{wrong}")))
    }

    fn limits(&self, _: &Spring, side: f64) -> Vec<(f64, &'static str)> {
        let (first, last) = (self.points[0][0], self.points[self.points.len() - 1][0]);
        let behind = if self.is_odd() { -last } else { first };
        let limit_m = if side > 0.0 { last } else { behind };
        vec![(limit_m, "the table ends; the force goes on straight")]
    }
}
