//! Gauss collocation over an interval at one end of which the solution is a series in non-integer powers.
//!
//! dy/dz = f(z, y) between two values of z on one side of 0, or up to 0, where f contains powers like |z|^0.3. With |z| ~ s^5
//! each power z^p becomes s^(5 p), times the s^4 of dz/ds: many times differentiable at s = 0, where Gauss points lie close
//! together anyway. The rule of N points, exact for polynomials of degree 2 N - 1, leaves an error that falls like N^-(10 p + 10)
//! for the power z^p, and exponentially where f is singular only beyond `far` (P. J. Davis and P. Rabinowitz, *Methods of
//! Numerical Integration*, 2nd ed. (1984), sections 2.12.6 and 4.6). The stages are found by Picard's iteration, which needs no
//! derivatives and converges where the solution changes by a part of itself. Everything is computed with two rules, whose
//! difference is the error of the poorer one; that of the other is a hundred times less, and more.

use std::sync::LazyLock;

use crate::numerics::larger;
use crate::numerics::quadrature::legendre;

/// The power by which the points are drawn together at the singular end.
const GRADE: i32 = 5;
/// Points of the two rules.
pub(crate) const POINTS: usize = 20;
const FEWER: usize = 14;
/// Picard's iteration: at most this many rounds, until what changes is this part of the scale.
const ROUNDS_MAX: usize = 40;
const SETTLED: f64 = 2e-16;
/// What a round may still change, relative to the scale, when it no longer becomes less.
const ROUNDING: f64 = 1e-15;
/// A rule on (0, 1) and the integrals of the polynomials through its points.
struct Rule<const N: usize> {
    node: [f64; N],
    weight: [f64; N],
    /// `upto[i][j]`: the integral from 0 to node i of the polynomial that is 1 at node j and 0 at the others.
    upto: [[f64; N]; N],
}

/// A solution at the points of the finer rule and at the end to which it goes.
#[derive(Clone, Debug)]
pub(crate) struct Graded<const D: usize> {
    /// In the order in which they are passed. The weights add up to the way from start to end.
    pub(crate) points: [Point<D>; POINTS],
    pub(crate) end: [f64; D],
    /// The greatest difference between the two rules at the end, relative to the scales.
    pub(crate) difference: f64,
    way: Way,
}

static RULE: LazyLock<Rule<POINTS>> = LazyLock::new(Rule::new);
static FEWER_RULE: LazyLock<Rule<FEWER>> = LazyLock::new(Rule::new);

/// Solve dy/dz = `rate`(z, y) between two places that are not on different sides of 0, from `y`; `scale` says what each
/// component's errors are measured by.
///
/// `None` when Picard's iteration does not settle, or meets what is not finite: the way is too long.
pub(crate) fn solve<const D: usize>(
    from: f64,
    to: f64,
    y: &[f64; D],
    scale: &[f64; D],
    rate: impl Fn(f64, &[f64; D]) -> [f64; D],
) -> Option<Graded<D>> {
    let way = Way::between(from, to);
    let (end, points) = RULE.solve(way, y, scale, &rate)?;
    let (poorer, _) = FEWER_RULE.solve(way, y, scale, &rate)?;
    let mut difference = 0.0;
    for ((a, b), scale) in end.iter().zip(&poorer).zip(scale) {
        difference = larger(difference, ((a - b) / scale).abs());
    }
    Some(Graded { points, end, difference, way })
}

/// The way from one place to another: z = far (from + (to - from) s)^5.
#[derive(Clone, Copy, Debug)]
struct Way {
    far: f64,
    from: f64,
    to: f64,
}

impl Way {
    fn between(from: f64, to: f64) -> Self {
        let far = if from.abs() > to.abs() { from } else { to };
        // The power is exact for 1.
        let root = |z: f64| (z / far).powf(1.0 / f64::from(GRADE));
        Self { far, from: root(from), to: root(to) }
    }

    /// z and dz/ds at a part `s` of the way.
    fn at(&self, s: f64) -> (f64, f64) {
        let steep = self.to - self.from;
        let place = self.from + steep * s;
        (self.far * place.powi(GRADE), self.far * f64::from(GRADE) * place.powi(GRADE - 1) * steep)
    }
}

/// The part s of the way at which a point is.
pub(crate) fn part_at(point: usize) -> f64 {
    RULE.node[point]
}

impl<const D: usize> Graded<D> {
    /// (z, y) at a part s of the way, by the polynomials through the points: second barycentric form with the weights of Gauss
    /// points (J.-P. Berrut and L. N. Trefethen, *Barycentric Lagrange interpolation*, SIAM Review 46 (2004), section 5).
    pub(crate) fn between(&self, s: f64) -> (f64, [f64; D]) {
        let (mut above, mut below, mut sign) = ([0.0; D], 0.0, 1.0);
        let nodes = RULE.node.iter().zip(&RULE.weight);
        for ((node, weight), Point { y, .. }) in nodes.zip(&self.points) {
            if s.to_bits() == node.to_bits() {
                return (self.way.at(s).0, *y);
            }
            let part = sign * (node * (1.0 - node) * weight).sqrt() / (s - node);
            for (above, y) in above.iter_mut().zip(y) {
                *above += part * y;
            }
            (below, sign) = (below + part, -sign);
        }
        (self.way.at(s).0, above.map(|above| above / below))
    }
}

/// A point of a rule.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point<const D: usize> {
    pub(crate) z: f64,
    /// The weight of dz there.
    pub(crate) dz: f64,
    pub(crate) y: [f64; D],
}

impl<const N: usize> Rule<N> {
    /// The points are the zeros of the Legendre polynomial of degree N, by Newton's method; the integrals follow from
    /// (2 k + 1) P(k) = P'(k + 1) - P'(k - 1).
    fn new() -> Self {
        let mut rule = Self { node: [0.0; N], weight: [0.0; N], upto: [[0.0; N]; N] };
        let mut at = [0.0; N];
        for (i, x) in at.iter_mut().enumerate() {
            *x = -(std::f64::consts::PI * (i as f64 + 0.75) / (N as f64 + 0.5)).cos();
            for _ in 0..8 {
                let p = legendre::<N>(*x);
                let slope = N as f64 * (*x * p[N] - p[N - 1]) / (*x * *x - 1.0);
                *x -= p[N] / slope;
            }
        }
        for j in 0..N {
            let p = legendre::<N>(at[j]);
            let slope = N as f64 * (at[j] * p[N] - p[N - 1]) / (at[j] * at[j] - 1.0);
            rule.node[j] = 0.5 + 0.5 * at[j];
            rule.weight[j] = 1.0 / ((1.0 - at[j] * at[j]) * slope * slope);
            for (i, x) in at.iter().enumerate() {
                let q = legendre::<N>(*x);
                let mut sum = 1.0 + x;
                for k in 1..N {
                    sum += p[k] * (q[k + 1] - q[k - 1]);
                }
                rule.upto[i][j] = 0.5 * rule.weight[j] * sum;
            }
        }
        rule
    }

    /// y at the end, and at the points of the rule.
    fn solve<const D: usize>(
        &self,
        way: Way,
        y: &[f64; D],
        scale: &[f64; D],
        rate: &impl Fn(f64, &[f64; D]) -> [f64; D],
    ) -> Option<([f64; D], [Point<D>; N])> {
        let at = self.node.map(|s| way.at(s));
        let mut stages = [*y; N];
        let mut before = f64::INFINITY;
        let mut slopes = [[0.0; D]; N];
        for round in 0..=ROUNDS_MAX {
            for ((slope, stage), (z, dz)) in slopes.iter_mut().zip(&stages).zip(at) {
                *slope = rate(z, stage).map(|slope| slope * dz);
            }
            let mut change = 0.0;
            for (stage, row) in stages.iter_mut().zip(&self.upto) {
                for d in 0..D {
                    let gained: f64 = row.iter().zip(&slopes).map(|(a, slope)| a * slope[d]).sum();
                    let next = y[d] + gained;
                    change = larger(change, ((next - stage[d]) / scale[d]).abs());
                    stage[d] = next;
                }
            }
            if !change.is_finite() || round == ROUNDS_MAX {
                return None;
            }
            if change <= SETTLED || (change >= before && change <= ROUNDING) {
                break;
            }
            before = change;
        }
        let end = std::array::from_fn(|d| {
            y[d] + self.weight.iter().zip(&slopes).map(|(w, slope)| w * slope[d]).sum::<f64>()
        });
        let points = std::array::from_fn(|i| {
            let (z, dz) = at[i];
            Point { z, dz: self.weight[i] * dz, y: stages[i] }
        });
        Some((end, points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_integrate_polynomials_exactly_from_zero_to_each_point() {
        for power in 0..POINTS {
            let degree = i32::try_from(power).unwrap();
            let f = |s: f64| s.powi(degree);
            let whole = |s: f64| s.powi(degree + 1) / f64::from(degree + 1);
            for (node, row) in RULE.node.iter().zip(&RULE.upto) {
                let sum: f64 = row.iter().zip(&RULE.node).map(|(a, s)| a * f(*s)).sum();
                assert!((sum - whole(*node)).abs() < 4e-16, "{power} up to {node}: {sum}");
            }
            let sum: f64 = RULE.weight.iter().zip(&RULE.node).map(|(w, s)| w * f(*s)).sum();
            assert!((sum - whole(1.0)).abs() < 4e-16, "{power}: {sum}");
        }
    }

    /// y' = z^p y has the solution exp(z^(p+1)/(p+1)), both ways.
    #[test]
    fn non_integer_powers_are_solved_to_rounding() {
        for p in [0.05f64, 0.3, 0.5, 0.7, 1.4, 2.3] {
            let exact = (0.5f64.powf(p + 1.0) / (p + 1.0)).exp();
            let rate = |z: f64, y: &[f64; 1]| [z.abs().powf(p) * y[0]];
            let out = solve(0.0, 0.5, &[1.0], &[1.0], rate).unwrap();
            let error = (out.end[0] / exact - 1.0).abs();
            assert!(
                error < 1e-13 && out.difference < 1e-11,
                "{p}: {error:e}, {:e}",
                out.difference
            );
            let back = solve(0.5, 0.0, &[exact], &[1.0], rate).unwrap();
            assert!((back.end[0] - 1.0).abs() < 1e-13, "{p}: {}", back.end[0]);
        }
    }

    #[test]
    fn the_points_are_in_order_and_their_weights_add_up_to_the_way() {
        let rate = |_: f64, _: &[f64; 1]| [1.0];
        let back = solve(-2.0, 0.0, &[0.0], &[1.0], rate).unwrap();
        assert!((back.end[0] - 2.0).abs() < 1e-14);
        assert!(back.points.windows(2).all(|pair| pair[0].z < pair[1].z));
        let way: f64 = back.points.iter().map(|point| point.dz).sum();
        assert!((way - 2.0).abs() < 1e-14);
    }

    #[test]
    fn the_dense_output_goes_through_the_points() {
        let solved = solve(0.01, 1.0, &[0.01], &[1.0], |_, _| [1.0]).unwrap();
        let (_, [at_point]) = solved.between(part_at(7));
        assert_eq!(at_point.to_bits(), solved.points[7].y[0].to_bits());
        let (z, [between]) = solved.between(0.3);
        assert!((between / z - 1.0).abs() < 1e-13, "{between} {z}");
    }

    #[test]
    fn a_solution_that_does_not_converge_is_refused() {
        let explodes = |_: f64, y: &[f64; 1]| [y[0] * y[0]];
        assert!(solve(0.0, 2.0, &[1.0], &[1.0], explodes).is_none());
        let broken = |_: f64, _: &[f64; 1]| [f64::NAN];
        assert!(solve(0.0, 1.0, &[1.0], &[1.0], broken).is_none());
    }
}
