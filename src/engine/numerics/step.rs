//! What methods that step through a motion have in common: the law of the motion, and each step as polynomials.

use crate::numerics::quadrature::{RECIPROCALS, legendre};

/// A square matrix.
pub(crate) type Square<const D: usize> = [[f64; D]; D];

/// Derivatives of the acceleration by places and by speeds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes<const D: usize> {
    pub(crate) place: Square<D>,
    pub(crate) speed: Square<D>,
}

/// The law of motion of `D` places.
pub(crate) trait Acceleration<const D: usize> {
    fn at(&self, place: &[f64; D], speed: &[f64; D]) -> [f64; D];

    fn slopes(&self, place: &[f64; D], speed: &[f64; D]) -> Slopes<D>;

    /// Whether a part of the law is infinitely steep at a zero of its own, where its derivative misleads.
    fn is_steep(&self) -> bool {
        false
    }

    /// The part of a change of place and speed after which no such part has passed its zero.
    fn without_passing(&self, _from: Point<D>, _to: Point<D>) -> f64 {
        1.0
    }

    /// What errors of places and speeds are relative to at a point.
    fn sizes(&self, at: &Point<D>) -> Point<D>;
}

/// Places and speeds.
pub(crate) type Point<const D: usize> = ([f64; D], [f64; D]);

/// A method that steps through motions.
pub(crate) trait Stepper<const S: usize> {
    /// A step of length `h` from a point and the length of the next, or else the length to try. Counts evaluations.
    ///
    /// # Errors
    /// The shorter length to try, where the step is not as accurate as it has to be.
    fn step<const D: usize>(
        &self,
        law: &impl Acceleration<D>,
        start: Point<D>,
        h: f64,
        near: Option<Near<D, S>>,
        evaluations: &mut usize,
    ) -> Result<(Step<D, S>, f64), f64>;

    /// Whether events are located, or only noticed after the step in which they happened.
    fn locates(&self) -> bool {
        true
    }
}

/// What is known of a step from another: its acceleration is about that of the other from a part `from` of it, over so many of its
/// lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near<const D: usize, const S: usize> {
    pub(crate) acceleration: [[f64; S]; D],
    pub(crate) from: f64,
    pub(crate) over: f64,
}

/// A step of length h, in Legendre polynomials of the part theta of it, 0 to 1.
#[derive(Clone, Debug)]
pub(crate) struct Step<const D: usize, const S: usize> {
    /// Its length.
    pub(crate) h: f64,
    /// Places and speeds at its start.
    pub(crate) start: Point<D>,
    /// Coefficients of the acceleration.
    pub(crate) acceleration: [[f64; S]; D],
    /// Coefficients of the speed as far as the places follow from it.
    pub(crate) speed: [[f64; S]; D],
    /// Places and speeds at its end.
    pub(crate) end: Point<D>,
}

impl<const D: usize, const S: usize> Step<D, S> {
    /// Places and speeds at a part of it; a little beyond its end, too.
    pub(crate) fn at(&self, theta: f64) -> Point<D> {
        self.after(&integrals(theta))
    }

    /// The same at the part to which the Legendre polynomials have these integrals.
    pub(crate) fn after(&self, integrals: &[f64; S]) -> Point<D> {
        let after =
            |start: f64, coefficients: &[f64; S]| start + self.h * dot(coefficients, integrals);
        let (place, speed) = &self.start;
        (
            std::array::from_fn(|d| after(place[d], &self.speed[d])),
            std::array::from_fn(|d| after(speed[d], &self.acceleration[d])),
        )
    }
}

/// Sums of Legendre polynomials of a part of a step, 0 to 1, with these coefficients.
pub(crate) fn series<const D: usize, const S: usize>(
    coefficients: &[[f64; S]; D],
    theta: f64,
) -> [f64; D] {
    let values = legendre(2.0 * theta - 1.0);
    coefficients.each_ref().map(|coefficients| dot(coefficients, &values))
}

/// The sum of the products of two rows.
pub(crate) fn dot<const S: usize>(one: &[f64; S], other: &[f64; S]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// The integral from 0 to theta of the Legendre polynomials of degree below S, shifted to (0, 1).
pub(crate) fn integrals<const S: usize>(theta: f64) -> [f64; S] {
    let x = 2.0 * theta - 1.0;
    let (mut before, mut now) = (1.0, x);
    std::array::from_fn(|k| {
        if k == 0 {
            return theta;
        }
        let degree = k as f64;
        let next = ((2.0 * degree + 1.0) * x * now - degree * before) * RECIPROCALS[k + 1];
        let integral = (next - before) * RECIPROCALS[2 * (2 * k + 1)];
        (before, now) = (now, next);
        integral
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the coefficient 2 of degree 1, y'' = 2 (2 theta - 1) on a step of 3, so that y' = 1 + 6 (theta² - theta). That of degree 2 is
    /// 6 (theta² - theta) + 1: it is the whole of y'.
    #[test]
    fn valid_places_are_the_integrals_of_the_speeds_and_these_of_the_accelerations() {
        let step: Step<1, 3> = Step {
            h: 3.0,
            start: ([5.0], [1.0]),
            acceleration: [[0.0, 2.0, 0.0]],
            speed: [[0.0, 0.0, 1.0]],
            end: ([5.0], [1.0]),
        };
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

    /// A gap that is zero where a step begins has to be zero on its polynomial too.
    #[test]
    fn valid_a_step_begins_exactly_where_it_begins() {
        assert_eq!(integrals::<9>(0.0).map(|integral| integral.abs().to_bits()), [0; 9]);
    }
}
