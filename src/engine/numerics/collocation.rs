//! Radau IIA collocation of y'' = f(y, y') for smooth, stiff and singular motions.
//!
//! With s stages the acceleration is a polynomial of degree s - 1 that equals f at the s nodes of a step. The order is 2 s - 1, and the
//! method is L-stable (E. Hairer and G. Wanner, *Solving Ordinary Differential Equations II* (1996), IV.5 and IV.8). The unknowns are the
//! stage accelerations; velocities follow by the matrix A of the method, positions by A squared. The caller repeats a rejected step with a
//! smaller step size.

use std::array;
use std::sync::LazyLock;

use newton_matrix::NewtonMatrix;

use crate::numerics::quadrature::{self, legendre, legendre_and_slope};
use crate::numerics::root::newton_root;
use crate::numerics::step::{
    Jacobian, Point, SecondOrderOde, Square, StagePredictor, Step, Stepper, dot, series,
};
use crate::numerics::{larger, smaller};

mod newton_matrix;

/// Maximum number of iterations of each method for the stage equations. A contraction rate of 0.2 reaches rounding error within it.
const ITERATIONS_MAX: usize = 20;
/// Contraction rate of Newton's iteration above which the Jacobian is evaluated anew. A new Jacobian then costs less than the additional
/// iterations with the old one.
const JACOBIAN_REUSE_RATE: f64 = 0.2;
/// Contraction rate above which the fixed-point iteration is replaced by Newton's method. One factorisation costs about as much as ten
/// iterations with an inexpensive right-hand side.
const SLOW_FIXED_POINT: f64 = 0.5;
/// Predicted number of further fixed-point iterations above which Newton's method from the initial guess costs less.
const ROUNDS_LEFT: i32 = 14;
/// Evaluations counted for one Jacobian, per stage and position: one difference quotient by position and one by velocity. The analytic
/// Jacobian with its factorisation takes about the same time.
const JACOBIAN: usize = 2;
/// Tolerance of the stage equations, relative to the tolerance of the step. The iteration error is then negligible beside the local error.
const SOLVED: f64 = 1e-2;
/// Tolerance of the stage equations in the second computation of an error estimate, relative to the error scales. From the same initial
/// guess both computations are left with nearly the same iteration error, which their difference does not show.
const SOLVED_SECOND: f64 = 1e-13;
/// Rounding error of the stage equations, relative to the error scales: a few units in the last place of a sum of ten terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Error norm that the step-size controller aims at; below 1, so that most steps are accepted.
const TARGET_ERROR_NORM: f64 = 0.5;
/// Largest step-size factor after an accepted step.
const GROWTH_MAX: f64 = 4.0;
/// Smallest and largest step-size factor after a rejected step.
const CUT: (f64, f64) = (0.1, 0.8);
/// Step-size factor after a step whose stage equations did not converge.
const AFTER_FAILURE: f64 = 0.25;
/// Coefficient of the filter of the error estimate. The real eigenvalue of A with nine stages is near 0.1: the filter damps stiff
/// components as the method does.
pub(crate) const FILTER: f64 = 0.1;

/// Number of Legendre polynomials in a table: the largest number of stages plus one.
const STAGES_MORE: usize = 12;

/// Acceleration of each position at each stage.
type Stages<const D: usize, const S: usize> = [[f64; S]; D];

/// Coefficients of the method with `S` stages.
#[derive(Debug)]
pub(crate) struct RadauIia<const S: usize> {
    /// Nodes in (0, 1]; the last is 1.
    nodes: [f64; S],
    /// Runge-Kutta matrix A by columns: row j has the contributions of node j to every node.
    a: Square<S>,
    square: Square<S>,
    /// Transformation of nodal values into Legendre coefficients, by columns.
    modes: Square<S>,
    /// Gauss-Legendre rule with `S` points, for the defect.
    gauss: [Gauss<S>; S],
}

/// Node of the Gauss-Legendre rule in (0, 1), its weight, and the Legendre polynomials at the node.
#[derive(Debug)]
struct Gauss<const S: usize> {
    at: f64,
    weight: f64,
    values: [f64; S],
}

pub(crate) static ELEVEN: LazyLock<RadauIia<11>> = LazyLock::new(RadauIia::new);
pub(crate) static RADAU_IIA_17: LazyLock<RadauIia<9>> = LazyLock::new(RadauIia::new);
pub(crate) static THREE: LazyLock<RadauIia<3>> = LazyLock::new(RadauIia::new);
pub(crate) static SEVEN: LazyLock<RadauIia<7>> = LazyLock::new(RadauIia::new);

/// Radau IIA method with a tolerance: a [`Stepper`].
pub(crate) struct Collocation<'a, const S: usize> {
    member: &'a RadauIia<S>,
    /// Relative tolerance of the local error.
    tolerance: f64,
    /// Part of it to which the stage equations are solved.
    solved: f64,
}

impl<const S: usize> Stepper<S> for Collocation<'_, S> {
    fn step<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: Point<D>,
        h: f64,
        near: Option<StagePredictor<D, S>>,
        evaluations: &mut usize,
    ) -> Result<(Step<D, S>, f64), f64> {
        let step = self.solve(law, start, h, near, evaluations);
        // Extrapolation from the previous step can be a poor initial guess.
        let anew = || near.and_then(|_| self.solve(law, start, h, None, evaluations));
        let step = step.or_else(anew).ok_or(AFTER_FAILURE * h)?;
        // The beginning of an accepted step has a smaller error.
        if near.is_some_and(|near| near.is_beginning()) {
            return Ok((step, h));
        }
        *evaluations += S;
        let excess = self.error_norm(law, &start, &step);
        let factor = (TARGET_ERROR_NORM / excess).powf(1.0 / RadauIia::<S>::ERROR_ORDER);
        if excess <= 1.0 {
            return Ok((step, h * smaller(factor, GROWTH_MAX)));
        }
        let cut = factor * factor;
        Err(h * if cut > CUT.0 { smaller(cut, CUT.1) } else { CUT.0 })
    }
}

impl<const S: usize> Collocation<'_, S> {
    /// Solves a step of size `h`; `None` if no iteration converges. The initial guess is extrapolated by `near`, otherwise the acceleration
    /// at the start.
    fn solve<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: Point<D>,
        h: f64,
        near: Option<StagePredictor<D, S>>,
        evaluations: &mut usize,
    ) -> Option<Step<D, S>> {
        let Self { member, tolerance, solved } = *self;
        let guess = match near {
            Some(StagePredictor { acceleration, from, over }) => {
                by_place(|i| series(&acceleration, from + over * member.nodes[i]))
            }
            None => guess(law, &start, h).map(|value| [value; S]),
        };
        let (place, speed) = law.sizes(&start);
        let weights = array::from_fn(|d| larger(h / speed[d], h * h / place[d]) / tolerance);
        let enough = solved + ROUNDING / tolerance;
        let equations =
            StageEquations { member, law, start, h, weights, tolerance, solved, enough };
        let stages = equations
            .by_fixed_point(guess, evaluations)
            .or_else(|| equations.by_newton(guess, evaluations))?;
        Some(member.polynomial(start, h, &stages))
    }

    /// Error norm of a step: the larger of two estimates over the tolerance. The step is accepted if it is at most 1.
    ///
    /// - Truncation estimate: the decay of the Legendre coefficients of the acceleration is extrapolated to about twice the degree. It
    ///   underestimates a discontinuity of a high derivative within the step.
    /// - Defect estimate: quadrature of the residual of the differential equation at the Gauss nodes. It misses a transient that decays
    ///   before the first node.
    fn error_norm<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: &Point<D>,
        step: &Step<D, S>,
    ) -> f64 {
        let h = step.h;
        let rounding = law.rounding(h, &step.end);
        let beyond = |value: f64, d: usize| larger(value.abs() - rounding[d], 0.0);
        let mut tail = ([0.0; D], [0.0; D]);
        let (from, last) = RadauIia::<S>::FALL;
        for d in 0..D {
            let modes = step.acceleration[d].map(|mode| beyond(mode, d));
            let high = modes[S - last..].iter().copied().fold(0.0, larger);
            let low = larger(modes[from], modes[from + 1]);
            let fall = if high < low { high / low } else { 1.0 };
            // The decay is measured over four degrees and extrapolated over six.
            let falling = if S > 4 { fall * fall.sqrt() } else { fall };
            tail.1[d] = h * high * falling;
            tail.0[d] = h * tail.1[d];
        }
        let mut defect = ([0.0; D], [0.0; D]);
        for Gauss { at, weight, values } in &self.member.gauss {
            for (d, wanted) in law.at(h * at, &step.at(*at)).into_iter().enumerate() {
                let given = dot(&step.acceleration[d], values);
                let missed = h * weight * beyond(wanted - given, d).copysign(wanted - given);
                defect.1[d] += missed;
                defect.0[d] += h * (1.0 - at) * missed;
            }
        }
        let slopes = [law.slopes(&step.end)];
        let mut filter = NewtonMatrix::zero();
        filter.set(&[[FILTER]], &[[FILTER * FILTER]], &slopes, h);
        let filtered = |error: [f64; D]| {
            let mut all = error.map(|error| [error]);
            // Singular for an infinite Jacobian at the end: the error remains unfiltered.
            if filter.solve(&mut all) { all.map(|[error]| error) } else { error }
        };
        let [before, after] = [start, &step.end].map(|point| law.sizes(point));
        [tail, defect].into_iter().fold(0.0, |worst, (place, speed)| {
            let (place, speed) = (filtered(place), filtered(speed));
            (0..D).fold(worst, |worst, d| {
                let place = place[d].abs() / larger(before.0[d], after.0[d]);
                let speed = speed[d].abs() / larger(before.1[d], after.1[d]);
                larger(larger(place, speed) / self.tolerance, worst)
            })
        })
    }
}

/// Stage equations of a step: each stage acceleration equals the right-hand side at its node.
struct StageEquations<'a, L, const D: usize, const S: usize> {
    member: &'a RadauIia<S>,
    law: &'a L,
    start: Point<D>,
    h: f64,
    /// Weights of the accelerations in the norm: change of position or velocity, over the error scale times the tolerance.
    weights: [f64; D],
    /// Relative tolerance of the local error.
    tolerance: f64,
    /// Norm of the iteration error at which the equations count as solved, without rounding errors.
    solved: f64,
    /// Norm of the iteration error at which the equations count as solved, with rounding errors.
    enough: f64,
}

impl<L: SecondOrderOde<D>, const D: usize, const S: usize> StageEquations<'_, L, D, S> {
    /// Returns the expected contraction rate of the fixed-point iteration: h times the Jacobian at the start, over S. The eigenvalues of A
    /// are about 1/S.
    fn contraction_rate(&self) -> f64 {
        let Jacobian { place, speed } = self.law.slopes(&self.start);
        let part = self.h / S as f64;
        let rate = |by_place: &f64, by_speed: &f64| part * (by_speed.abs() + part * by_place.abs());
        let rates = place.as_flattened().iter().zip(speed.as_flattened());
        rates.fold(0.0, |worst, (by_place, by_speed)| larger(rate(by_place, by_speed), worst))
    }

    /// Solves by fixed-point iteration; `None` unless it contracts fast.
    ///
    /// The error of a stiff component can be below the tolerance and above the component itself. Newton's method damps such an error.
    fn by_fixed_point(
        &self,
        mut stages: Stages<D, S>,
        evaluations: &mut usize,
    ) -> Option<Stages<D, S>> {
        let contracts = self.contraction_rate() <= SLOW_FIXED_POINT;
        if !contracts {
            return None;
        }
        let mut before = f64::INFINITY;
        for round in 0..ITERATIONS_MAX {
            *evaluations += S;
            let change = self.residual(&stages, &self.points(&stages));
            add(&mut stages, &change);
            let norm = self.norm(&change);
            // Nothing is known about the contraction of the first change.
            let contraction = if round > 0 { norm / before } else { 1.0 };
            if norm <= self.solved || norm * contraction <= self.enough {
                return Some(stages);
            }
            let left = norm * contraction.powi(ROUNDS_LEFT);
            let contracts = contraction <= SLOW_FIXED_POINT && left <= self.enough;
            if (round > 0 && !contracts) || !norm.is_finite() {
                // A change this small is rounding error.
                return (norm < 10.0 * self.enough).then_some(stages);
            }
            before = norm;
        }
        None
    }

    /// Solves by Newton's method, with a new Jacobian if the contraction is slow; `None` if the iteration diverges.
    fn by_newton(&self, mut stages: Stages<D, S>, evaluations: &mut usize) -> Option<Stages<D, S>> {
        let Self { member, law, ref start, h, solved, enough, .. } = *self;
        let mut newton = NewtonMatrix::zero();
        let mut is_old = true;
        let mut before = f64::INFINITY;
        for round in 1..=ITERATIONS_MAX {
            let points = self.points(&stages);
            let is_new = is_old;
            if is_old {
                let slopes = array::from_fn(|i| law.slopes(&points[i]));
                newton.set(&member.a, &member.square, &slopes, h);
                *evaluations += JACOBIAN * D * S;
            }
            *evaluations += S;
            let mut change = self.residual(&stages, &points);
            if !newton.solve(&mut change) {
                return None;
            }
            add(&mut stages, &change);
            let norm = self.norm(&change);
            if !norm.is_finite() || (round > 3 && norm > 2.0 * before) {
                return None;
            }
            // Nothing is known about the contraction of the first change.
            let contraction = if before.is_finite() { norm / before } else { 1.0 };
            // With a new Jacobian the convergence is quadratic.
            let next = if is_new { contraction * contraction } else { contraction };
            let ahead = if contraction < 1.0 { norm * next } else { norm };
            // Changes that no longer decrease are rounding error if they are below ten times the tolerance, or below the solution for
            // the rounding errors of the accelerations, assumed equal at all stages.
            let stalls = before.is_finite() && contraction > 0.5 && {
                let mut rounding = law.rounding(0.0, start).map(|rounding| [rounding; S]);
                newton.solve(&mut rounding);
                norm < 10.0 * enough || norm < self.norm(&rounding)
            };
            if norm <= solved || ahead <= enough || stalls {
                return Some(stages);
            }
            // The first contraction rate is about the relative change of the Jacobian, and thus of the stages.
            let slow = if before.is_finite() { contraction } else { norm * self.tolerance };
            is_old = slow > JACOBIAN_REUSE_RATE;
            before = norm;
        }
        None
    }

    fn points(&self, stages: &Stages<D, S>) -> [Point<D>; S] {
        self.member.points(self.start, self.h, stages)
    }

    /// Returns the residual: accelerations at the stage points minus the stages.
    fn residual(&self, stages: &Stages<D, S>, points: &[Point<D>; S]) -> Stages<D, S> {
        let mut residual = by_place(|i| self.law.at(self.h * self.member.nodes[i], &points[i]));
        for (residual, stage) in residual.as_flattened_mut().iter_mut().zip(stages.as_flattened()) {
            *residual -= stage;
        }
        residual
    }

    /// Returns the weighted maximum norm; infinite or NaN if a component is.
    fn norm(&self, change: &Stages<D, S>) -> f64 {
        change.iter().zip(self.weights).fold(0.0, |norm, (change, weight)| {
            change.iter().fold(norm, |norm, change| larger(weight * change.abs(), norm))
        })
    }
}

/// Adds a change to each stage.
fn add<const D: usize, const S: usize>(stages: &mut Stages<D, S>, change: &Stages<D, S>) {
    for (stage, change) in stages.as_flattened_mut().iter_mut().zip(change.as_flattened()) {
        *stage += change;
    }
}

/// Returns the integrals from 0 to theta of the Legendre polynomials of degree below S, shifted to (0, 1).
fn integrals<const S: usize>(theta: f64) -> [f64; S] {
    let p = legendre::<STAGES_MORE>(2.0 * theta - 1.0);
    array::from_fn(|k| if k == 0 { theta } else { (p[k + 1] - p[k - 1]) / (4 * k + 2) as f64 })
}

impl<const S: usize> RadauIia<S> {
    fn new() -> Self {
        let order = S as f64;
        // The nodes are the roots of P_S - P_(S-1), which lie near the maxima of a cosine; the last is 1.
        let mut nodes = [1.0; S];
        for (i, node) in nodes.iter_mut().enumerate().take(S - 1) {
            let guess = -((2 * i + 1) as f64 / (2.0 * order - 1.0) * std::f64::consts::PI).cos();
            let x = newton_root(guess, |x| {
                let (high, low) = (legendre_and_slope(S, x), legendre_and_slope(S - 1, x));
                (high.0 - low.0, high.1 - low.1)
            });
            *node = 0.5 * (1.0 + x);
        }
        // The Legendre polynomials are orthogonal on the nodes with Radau's weights.
        let modes = nodes.map(|node| {
            let x = 2.0 * node - 1.0;
            let p = legendre::<STAGES_MORE>(x);
            let weight = (1.0 + x) / (2.0 * order * order * p[S - 1] * p[S - 1]);
            array::from_fn(|k| (2 * k + 1) as f64 * weight * p[k])
        });
        let integrals = nodes.map(integrals);
        let a = modes.map(|modes| integrals.map(|integrals| dot(&integrals, &modes)));
        let square = a.map(|column| times(&a, &column));
        let gauss = quadrature::rule().map(|(x, weight)| Gauss {
            at: 0.5 * (1.0 + x),
            weight: 0.5 * weight,
            values: legendre(x),
        });
        Self { nodes, a, square, modes, gauss }
    }

    /// Returns the nodes in (0, 1]; the last is 1.
    pub(crate) fn nodes(&self) -> &[f64; S] {
        &self.nodes
    }

    /// Returns the integrals from 0 to each node, from values at the nodes.
    pub(crate) fn integrals(&self, values: &[f64; S]) -> [f64; S] {
        times(&self.a, values)
    }

    /// Returns the method with a relative tolerance of the local error.
    pub(crate) fn to(&self, tolerance: f64) -> Collocation<'_, S> {
        Collocation { member: self, tolerance, solved: SOLVED }
    }

    /// As a method that steps to this tolerance and shares no error of its iterations with one that is less accurate.
    pub(crate) fn for_second(&self, tolerance: f64) -> Collocation<'_, S> {
        let solved = smaller(SOLVED, SOLVED_SECOND / tolerance);
        Collocation { member: self, tolerance, solved }
    }

    /// Index of the first Legendre coefficient whose decay is measured, and number of trailing coefficients that it is compared with.
    const FALL: (usize, usize) = if S > 4 { (S - 6, 2) } else { (0, 1) };

    /// Exponent of the step size in the error estimate, for the step-size controller; at most the order of the method.
    const ERROR_ORDER: f64 = if S > 4 { S + 6 } else { 2 * S - 1 } as f64;

    /// Returns positions and velocities at the nodes.
    fn points<const D: usize>(
        &self,
        (place, speed): Point<D>,
        h: f64,
        stages: &Stages<D, S>,
    ) -> [Point<D>; S] {
        let one = stages.each_ref().map(|stages| times(&self.a, stages));
        let two = stages.each_ref().map(|stages| times(&self.square, stages));
        array::from_fn(|i| {
            let way = |d: usize| place[d] + h * (self.nodes[i] * speed[d] + h * two[d][i]);
            (array::from_fn(way), array::from_fn(|d| speed[d] + h * one[d][i]))
        })
    }

    fn polynomial<const D: usize>(
        &self,
        start: Point<D>,
        h: f64,
        stages: &Stages<D, S>,
    ) -> Step<D, S> {
        let acceleration = stages.each_ref().map(|stages| times(&self.modes, stages));
        // All but the first two Legendre polynomials have no mean and no first moment.
        let end = (
            array::from_fn(|d| {
                let change = 0.5 * acceleration[d][0] - acceleration[d][1] / 6.0;
                start.0[d] + h * (start.1[d] + h * change)
            }),
            array::from_fn(|d| start.1[d] + h * acceleration[d][0]),
        );
        Step::new(h, [start, end], acceleration)
    }
}

/// Returns the product of a matrix, given by columns, and a vector.
fn times<const S: usize>(columns: &Square<S>, values: &[f64; S]) -> [f64; S] {
    let mut sum = [0.0; S];
    for (column, value) in columns.iter().zip(values) {
        for (sum, of_column) in sum.iter_mut().zip(column) {
            *sum += of_column * value;
        }
    }
    sum
}

/// Transposes stage-by-stage values into position-by-position values.
fn by_place<const D: usize, const S: usize>(values: impl Fn(usize) -> [f64; D]) -> Stages<D, S> {
    let mut stages = [[0.0; S]; D];
    for i in 0..S {
        for (stages, value) in stages.iter_mut().zip(values(i)) {
            stages[i] = value;
        }
    }
    stages
}

/// Returns the initial guess of the stages: the acceleration at the start, or 0 if it would change the velocity by more than itself.
fn guess<const D: usize>(law: &impl SecondOrderOde<D>, start: &Point<D>, h: f64) -> [f64; D] {
    let (first, speed) = (law.at(0.0, start), start.1);
    array::from_fn(|d| {
        let is_modest = (h * first[d]).abs() <= speed[d].abs() || speed[d] == 0.0;
        if is_modest && first[d].is_finite() { first[d] } else { 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::numerics::step::tests::Spring;

    /// y'' = -y'², which slows like 1/t: not linear in the speed.
    struct Drag;

    impl SecondOrderOde<1> for Drag {
        fn at(&self, _: f64, (_, speed): &Point<1>) -> [f64; 1] {
            [-speed[0] * speed[0]]
        }

        fn slopes(&self, (_, speed): &Point<1>) -> Jacobian<1> {
            Jacobian { place: [[0.0]], speed: [[-2.0 * speed[0]]] }
        }

        fn sizes(&self, _: &Point<1>) -> Point<1> {
            ([1.0], [1.0])
        }
    }

    fn step<const S: usize>(
        member: &RadauIia<S>,
        law: &impl SecondOrderOde<1>,
        start: Point<1>,
        h: f64,
    ) -> Step<1, S> {
        member.to(1e-15).solve(law, start, h, None, &mut 0).unwrap()
    }

    const ONE_FAST: Point<1> = ([0.0], [1.0]);
    const ONE_OFF: Point<1> = ([1.0], [0.0]);

    /// Greatest error of place and speed after a step of a whole.
    fn error<const S: usize>(member: &RadauIia<S>, h: f64) -> f64 {
        let (place, speed) = step(member, &Drag, ONE_FAST, h).end;
        larger((place[0] - h.ln_1p()).abs(), (speed[0] - 1.0 / (1.0 + h)).abs())
    }

    #[test]
    fn valid_the_nodes_are_those_of_radau() {
        // Two stages: 1/3 and 1.
        let two = RadauIia::<2>::new();
        let [third, whole] = two.nodes;
        assert!((third - 1.0 / 3.0).abs() < 1e-15 && (whole - 1.0).abs() < 1e-15, "{two:?}");
        // Constants and the highest power are integrated exactly, to the end up to degree 16.
        let integral =
            |power: i32| times(&RADAU_IIA_17.a, &RADAU_IIA_17.nodes.map(|node| node.powi(power)));
        let [constant, eighth] = [0, 8].map(integral);
        for (i, node) in RADAU_IIA_17.nodes.iter().enumerate() {
            assert!((constant[i] - node).abs() < 1e-14, "{constant:?} {node}");
            assert!((eighth[i] - node.powi(9) / 9.0).abs() < 1e-14);
        }
        assert!((integral(16)[8] - 1.0 / 17.0).abs() < 1e-14);
        let gauss: f64 = RADAU_IIA_17.gauss.iter().map(|node| node.weight * node.at.powi(17)).sum();
        assert!((gauss - 1.0 / 18.0).abs() < 1e-14);
    }

    #[test]
    fn valid_half_the_step_leaves_two_to_the_order_of_the_error() {
        // The pole at -1 keeps the error from its order 13 until the step is short.
        for (h, least) in [(2.0, 9.0), (1.0, 10.5), (0.7, 11.0)] {
            let rate = (error(&SEVEN, h) / error(&SEVEN, 0.5 * h)).log2();
            assert!(rate > least, "{h}: {rate}");
        }
        let [seven, nine] = [error(&SEVEN, 2.0), error(&RADAU_IIA_17, 2.0)];
        assert!(nine < 0.01 * seven, "{nine:e} {seven:e}");
    }

    /// y'' = -y, with the number of its Jacobians.
    #[derive(Debug)]
    struct Counted(Cell<usize>);

    impl SecondOrderOde<1> for Counted {
        fn at(&self, _: f64, (place, _): &Point<1>) -> [f64; 1] {
            [-place[0]]
        }

        fn slopes(&self, _: &Point<1>) -> Jacobian<1> {
            self.0.set(self.0.get() + 1);
            Jacobian { place: [[-1.0]], speed: [[0.0]] }
        }

        fn sizes(&self, _: &Point<1>) -> Point<1> {
            ([1.0], [1.0])
        }
    }

    #[test]
    fn valid_a_smooth_step_factors_no_jacobian() {
        let law = Counted(Cell::new(0));
        let end = step(&RADAU_IIA_17, &law, ONE_OFF, 1.0).end;
        assert!((end.0[0] - 1f64.cos()).abs() < 1e-15 && (end.1[0] + 1f64.sin()).abs() < 1e-15);
        // One tells that the step is not stiff.
        assert_eq!(law.0.get(), 1);
        // The iteration would contract by about h²/81.
        step(&RADAU_IIA_17, &law, ONE_OFF, 10.0);
        assert!(law.0.get() > 9, "{law:?}");
    }

    /// cos t: iterations from the constant first guess leave the same error in both members, which the judging one has to go below.
    #[test]
    fn valid_a_second_computation_is_right_to_rounding_where_a_loose_step_stops() {
        let start = ([1.0], [0.0]);
        let off = |method: Collocation<'_, 9>, h: f64| {
            let step = method.solve(&Spring(1.0), start, h, None, &mut 0).unwrap();
            larger((step.end.0[0] - h.cos()).abs(), (step.end.1[0] + h.sin()).abs())
        };
        for h in [0.05, 0.2, 0.4] {
            assert!(off(RADAU_IIA_17.for_second(1e-7), h) < 1e-13, "{h}");
            assert!(off(RADAU_IIA_17.to(1e-7), h) < 1e-9, "{h}");
        }
        assert!(off(RADAU_IIA_17.to(1e-7), 0.4) > 1e-13);
    }

    #[test]
    fn valid_a_stiff_oscillation_is_damped_and_a_slow_one_is_followed() {
        let slow = step(&RADAU_IIA_17, &Spring(1.0), ONE_OFF, 1.0);
        assert!((slow.end.0[0] - 1f64.cos()).abs() < 1e-15);
        let stiff = step(&RADAU_IIA_17, &Spring(1e12), ONE_OFF, 1.0);
        assert!(stiff.end.0[0].abs() < 1e-3, "{:?}", stiff.end);
    }

    #[test]
    fn valid_the_estimate_of_a_step_is_not_below_its_error_and_falls_fast() {
        let mut before = f64::INFINITY;
        for h in [4.0, 2.0, 1.0, 0.5] {
            let method = SEVEN.to(1e-15);
            let step = step(&SEVEN, &Drag, ONE_FAST, h);
            let estimate = method.error_norm(&Drag, &ONE_FAST, &step) * method.tolerance;
            assert!(estimate > error(&SEVEN, h), "{h}: {estimate:e}");
            assert!(estimate < 0.1 * before, "{h}: {estimate:e} {before:e}");
            before = estimate;
        }
    }
}
