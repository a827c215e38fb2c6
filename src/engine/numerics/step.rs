//! Interface between second-order differential equations and one-step methods; dense output of a step.

use std::array;

use crate::numerics::quadrature::legendre;

/// Square matrix.
pub(crate) type Square<const D: usize> = [[f64; D]; D];

/// Partial derivatives of the accelerations by positions and by velocities.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jacobian<const D: usize> {
    pub(crate) place: Square<D>,
    pub(crate) speed: Square<D>,
}

/// System of `D` second-order differential equations, y'' = f(t, y, y').
pub(crate) trait SecondOrderOde<const D: usize> {
    /// Returns the accelerations at a point; `t` is the time since the start of the step.
    fn at(&self, t: f64, point: &Point<D>) -> [f64; D];

    /// Returns the Jacobian at a point.
    fn slopes(&self, point: &Point<D>) -> Jacobian<D>;

    /// Returns the error scales of positions and velocities at a point.
    fn sizes(&self, at: &Point<D>) -> Point<D>;

    /// Returns the rounding errors of the accelerations at a point; large if forces cancel.
    fn rounding(&self, _: f64, _: &Point<D>) -> [f64; D] {
        [0.0; D]
    }
}

/// Positions and velocities.
pub(crate) type Point<const D: usize> = ([f64; D], [f64; D]);

/// Single-step method with dense output.
pub(crate) trait Stepper<const S: usize> {
    /// Computes a step of size `h`; returns it with the size proposed for the next step. Adds to `evaluations`.
    ///
    /// # Errors
    /// The step is rejected: the error is the smaller step size to try.
    fn step<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: Point<D>,
        h: f64,
        near: Option<StagePredictor<D, S>>,
        evaluations: &mut usize,
    ) -> Result<(Step<D, S>, f64), f64>;

    /// Returns `true` if events are located within a step; otherwise they take effect at its end.
    fn locates(&self) -> bool {
        true
    }
}

/// Predictor of the stages: extrapolates the acceleration of the previous step from its fraction `from` over `over` of its step sizes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StagePredictor<const D: usize, const S: usize> {
    pub(crate) acceleration: [[f64; S]; D],
    pub(crate) from: f64,
    pub(crate) over: f64,
}

impl<const D: usize, const S: usize> StagePredictor<D, S> {
    /// Returns `true` if the predicted step is the beginning of the one whose acceleration this is.
    pub(crate) fn is_beginning(&self) -> bool {
        self.from == 0.0 && self.over <= 1.0
    }
}

/// Step with dense output: polynomials in the fraction theta of the step, 0 to 1.
#[derive(Clone, Debug)]
pub(crate) struct Step<const D: usize, const S: usize> {
    /// Step size.
    pub(crate) h: f64,
    /// Positions and velocities at the start.
    start: Point<D>,
    /// Legendre coefficients of the acceleration.
    pub(crate) acceleration: [[f64; S]; D],
    /// Coefficients of the changes of position and velocity in powers of x = 2 theta - 1, from x on.
    powers: [Point<D>; S],
    /// Sums of `powers` at x = -1, subtracted so that the change at the start is exactly zero.
    at_start: Point<D>,
    /// Positions and velocities at the end.
    pub(crate) end: Point<D>,
}

impl<const D: usize, const S: usize> Step<D, S> {
    /// Creates a step from the Legendre coefficients of the acceleration.
    ///
    /// The velocity is their integral. Its highest degree `S` counts as degree `S - 1` for the positions: at the nodes of Radau's rule these
    /// Legendre polynomials are equal.
    pub(crate) fn new(h: f64, [start, end]: [Point<D>; 2], acceleration: [[f64; S]; D]) -> Self {
        // A method with more stages would lose its highest degrees here.
        const { assert!(S <= STAGES_MAX) };
        let mut powers = [([0.0; D], [0.0; D]); S];
        let speed: [[f64; S]; D] = array::from_fn(|d| integral(start.1[d], h, &acceleration[d]));
        for (k, integral) in INTEGRALS.iter().enumerate().take(S) {
            for ((places, speeds), of_x) in powers.iter_mut().zip(integral) {
                for d in 0..D {
                    places[d] += h * speed[d][k] * of_x;
                    speeds[d] += h * acceleration[d][k] * of_x;
                }
            }
        }
        let at_start = sums(&powers, -1.0);
        Self { h, start, acceleration, powers, at_start, end }
    }

    /// Returns positions and velocities at a fraction of the step; valid slightly beyond the end.
    #[inline]
    pub(crate) fn at(&self, theta: f64) -> Point<D> {
        let changed = sums(&self.powers, 2.0 * theta - 1.0);
        let after = |get: fn(&Point<D>) -> &[f64; D]| {
            let [start, changed, at_start] = [&self.start, &changed, &self.at_start].map(get);
            array::from_fn(|d| start[d] + (changed[d] - at_start[d]))
        };
        (after(|point| &point.0), after(|point| &point.1))
    }
}

/// Returns the Legendre coefficients of the integral over a step of size `h`, with degree `S` added to `S - 1`.
fn integral<const S: usize>(start: f64, h: f64, coefficients: &[f64; S]) -> [f64; S] {
    let mut integral = [0.0; S];
    integral[0] = start;
    for (k, value) in coefficients.iter().enumerate() {
        let part = h * value / (4 * k + 2) as f64;
        integral[usize::min(k + 1, S - 1)] += part;
        if k > 0 {
            integral[k - 1] -= part;
        } else {
            integral[0] += part;
        }
    }
    integral
}

/// Evaluates the polynomials with coefficients of x, x² and so on.
fn sums<const D: usize, const S: usize>(powers: &[Point<D>; S], x: f64) -> Point<D> {
    let (mut place, mut speed) = ([0.0; D], [0.0; D]);
    for (places, speeds) in powers.iter().rev() {
        for d in 0..D {
            place[d] = (place[d] + places[d]) * x;
            speed[d] = (speed[d] + speeds[d]) * x;
        }
    }
    (place, speed)
}

/// Largest number of stages of a method.
const STAGES_MAX: usize = 11;

/// Integrals of the Legendre polynomials over theta, as coefficients of x, x² and so on with x = 2 theta - 1.
const INTEGRALS: [[f64; STAGES_MAX]; STAGES_MAX] = {
    let mut table = [[0.0; STAGES_MAX]; STAGES_MAX];
    let (mut before, mut p, mut degree) = ([0.0; STAGES_MAX], [0.0; STAGES_MAX], 0);
    p[0] = 1.0;
    while degree < STAGES_MAX {
        let (k, mut next, mut j) = (degree as f64, [0.0; STAGES_MAX], 0);
        while j < STAGES_MAX {
            table[degree][j] = 0.5 * p[j] / (j + 1) as f64;
            let raised = if j > 0 { p[j - 1] } else { 0.0 };
            next[j] = ((2.0 * k + 1.0) * raised - k * before[j]) / (k + 1.0);
            j += 1;
        }
        (before, p, degree) = (p, next, degree + 1);
    }
    table
};

/// Evaluates Legendre series at the fraction theta of a step.
pub(crate) fn series<const D: usize, const S: usize>(
    coefficients: &[[f64; S]; D],
    theta: f64,
) -> [f64; D] {
    let values = legendre(2.0 * theta - 1.0);
    coefficients.each_ref().map(|coefficients| dot(coefficients, &values))
}

/// Returns the dot product.
pub(crate) fn dot<const S: usize>(one: &[f64; S], other: &[f64; S]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// y'' = -k y.
    pub(crate) struct Spring(pub(crate) f64);

    impl SecondOrderOde<1> for Spring {
        fn at(&self, _: f64, (place, _): &Point<1>) -> [f64; 1] {
            [-self.0 * place[0]]
        }

        fn slopes(&self, _: &Point<1>) -> Jacobian<1> {
            Jacobian { place: [[-self.0]], speed: [[0.0]] }
        }

        fn sizes(&self, _: &Point<1>) -> Point<1> {
            ([1.0], [1.0])
        }
    }

    /// With the coefficient 2 of degree 1, y'' = 2 (2 theta - 1) on a step of 3, so that y' = 1 + 6 (theta² - theta). That of degree 2 is
    /// 6 (theta² - theta) + 1: it is the whole of y'.
    #[test]
    fn valid_places_are_the_integrals_of_the_speeds_and_these_of_the_accelerations() {
        let ends = [([5.0], [1.0]); 2];
        let step = Step::new(3.0, ends, [[0.0, 2.0, 0.0]]);
        for theta in [0.0, 0.25, 0.5, 1.0] {
            let (place, speed) = step.at(theta);
            let exact = 1.0 + 6.0 * (theta * theta - theta);
            assert!((speed[0] - exact).abs() < 1e-14, "{theta}: {speed:?}");
            let way = 3.0 * (theta + 2.0 * theta.powi(3) - 3.0 * theta * theta);
            assert!((place[0] - 5.0 - way).abs() < 1e-14, "{theta}: {place:?}");
            let acceleration = series(&step.acceleration, theta)[0];
            assert!((acceleration - 2.0 * (2.0 * theta - 1.0)).abs() < 1e-14);
        }
    }

    /// The integral of `P_k` is `(P_(k+1) - P_(k-1))/(2 (2 k + 1))` over the parts of a step: the method with the most stages keeps its
    /// highest degree.
    #[test]
    fn valid_the_highest_degree_of_the_longest_method_is_in_its_states() {
        let mut acceleration = [[0.0; STAGES_MAX]];
        acceleration[0][STAGES_MAX - 1] = 1.0;
        let step = Step::new(3.0, [([0.0], [0.0]); 2], acceleration);
        for theta in [0.1, 0.25, 0.6] {
            let p = legendre::<{ STAGES_MAX + 1 }>(2.0 * theta - 1.0);
            let exact = 3.0 * (p[STAGES_MAX] - p[STAGES_MAX - 2]) / (4 * STAGES_MAX - 2) as f64;
            let (_, [speed]) = step.at(theta);
            assert!(exact.abs() > 1e-3 && (speed - exact).abs() < 1e-13, "{theta}: {speed}");
        }
    }

    /// A gap that is zero where a step begins has to be zero on its polynomial too.
    #[test]
    fn valid_a_step_begins_exactly_where_it_begins() {
        let start = ([0.1], [0.3]);
        let step = Step::new(0.7, [start; 2], [[0.9, 0.5, 0.7]]);
        assert_eq!(step.at(0.0), start);
    }
}
