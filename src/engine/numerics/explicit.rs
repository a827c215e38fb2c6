//! Explicit Runge-Kutta methods for comparison: the classical method with a fixed step size, and DOP853.
//!
//! W. Kutta, *Zeitschrift für Mathematik und Physik* 46 (1901) 435-453; J. R. Dormand and P. J. Prince's pair of order eight with error
//! estimates of order five and three, in the form of E. Hairer, S. P. Nørsett and G. Wanner, *Solving Ordinary Differential Equations
//! I*, 2nd ed. (1993), section II.10. The dense output is the quintic Hermite interpolant of positions, velocities and accelerations at
//! both ends.

use crate::numerics::larger;
use crate::numerics::step::{Point, SecondOrderOde, StagePredictor, Step, Stepper};
use tableau::{ERRORS, STAGES};

mod tableau;

/// Number of Legendre coefficients of the dense output: the acceleration is a cubic, the velocity of degree four.
pub(crate) const COEFFICIENTS: usize = 5;

/// Safety factor of the step-size controller of DOP853. This value and the limits below are those of the published program.
const SAFETY: f64 = 0.9;
/// Smallest step-size factor.
const CUT_MAX: f64 = 1.0 / 3.0;
/// Largest step-size factor.
const GROWTH_MAX: f64 = 6.0;
/// Step-size factor after a step with a result that is not finite.
const AFTER_FAILURE: f64 = 0.1;
/// Rounding errors of a position below which the cubic part of the acceleration is not determined: six of each in its first moment.
const ROUNDED: f64 = 12.0;
/// Order of DOP853.
const ORDER: f64 = 8.0;

/// Runge-Kutta matrix without its first row, which is zero; the last row has the weights.
const CLASSICAL: [[f64; 4]; 4] = [
    [0.5, 0.0, 0.0, 0.0],
    [0.0, 0.5, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
];

/// Classical Runge-Kutta method of order four with a fixed step size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rk4 {
    /// Step size; positive.
    pub(crate) step: f64,
    /// Whether events are located within the step; otherwise they take effect at its end.
    pub(crate) locates: bool,
}

/// DOP853, an embedded method of order eight with adaptive step size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dop853 {
    /// Relative tolerance of the local error.
    pub(crate) tolerance: f64,
}

impl Stepper<COEFFICIENTS> for Rk4 {
    fn locates(&self) -> bool {
        self.locates
    }

    fn step<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: Point<D>,
        h: f64,
        _: Option<StagePredictor<D, COEFFICIENTS>>,
        evaluations: &mut usize,
    ) -> Result<(Step<D, COEFFICIENTS>, f64), f64> {
        if h > self.step {
            return Err(self.step);
        }
        let (step, _) = of_stages(law, start, h, &CLASSICAL, evaluations);
        Ok((step, self.step))
    }
}

impl Stepper<COEFFICIENTS> for Dop853 {
    fn step<const D: usize>(
        &self,
        law: &impl SecondOrderOde<D>,
        start: Point<D>,
        h: f64,
        _: Option<StagePredictor<D, COEFFICIENTS>>,
        evaluations: &mut usize,
    ) -> Result<(Step<D, COEFFICIENTS>, f64), f64> {
        let (step, rates) = of_stages(law, start, h, &STAGES, evaluations);
        let [before, after] = [&start, &step.end].map(|point| law.sizes(point));
        let of = |weights: &[f64; 12], get: fn(&Point<D>) -> &[f64; D], d: usize| -> f64 {
            weights.iter().zip(&rates).map(|(weight, rate)| weight * get(rate)[d]).sum()
        };
        let (mut fifth, mut third) = (0.0, 0.0);
        for get in [(|point| &point.0) as fn(&Point<D>) -> &[f64; D], |point| &point.1] {
            for d in 0..D {
                let scale = self.tolerance * larger(get(&before)[d], get(&after)[d]);
                fifth += (h * of(&ERRORS[1], get, d) / scale).powi(2);
                third += (h * of(&ERRORS[0], get, d) / scale).powi(2);
            }
        }
        let mix = fifth + 0.01 * third;
        let error = if mix == 0.0 { 0.0 } else { fifth / (mix * (2 * D) as f64).sqrt() };
        if !error.is_finite() {
            return Err(AFTER_FAILURE * h);
        }
        let next = h * (SAFETY * error.powf(-1.0 / ORDER)).clamp(CUT_MAX, GROWTH_MAX);
        if error > 1.0 { Err(next) } else { Ok((step, next)) }
    }
}

/// Computes a step from a Runge-Kutta matrix; also returns the derivatives (velocities and accelerations) at the stages.
fn of_stages<const D: usize, const N: usize>(
    law: &impl SecondOrderOde<D>,
    start: Point<D>,
    h: f64,
    rows: &[[f64; N]; N],
    evaluations: &mut usize,
) -> (Step<D, COEFFICIENTS>, [Point<D>; N]) {
    let mut rates = [([0.0; D], [0.0; D]); N];
    let (mut at, mut part) = (start, 0.0);
    for (stage, row) in rows.iter().enumerate() {
        rates[stage] = (at.1, law.at(h * part, &at));
        (at, part) = (start, row.iter().sum());
        for (weight, (speed, acceleration)) in row.iter().zip(&rates[..=stage]) {
            for d in 0..D {
                at.0[d] += h * weight * speed[d];
                at.1[d] += h * weight * acceleration[d];
            }
        }
    }
    *evaluations += N + 1;
    (through(h, start, at, [rates[0].1, law.at(h, &at)]), rates)
}

/// Returns the quintic Hermite interpolant between two points, given the accelerations there.
fn through<const D: usize>(
    h: f64,
    start: Point<D>,
    end: Point<D>,
    [first, last]: [[f64; D]; 2],
) -> Step<D, COEFFICIENTS> {
    let mut acceleration = [[0.0; COEFFICIENTS]; D];
    for d in 0..D {
        // Legendre coefficients of the acceleration: its mean gives the change of velocity, its first moment the change of position.
        let mean = (end.1[d] - start.1[d]) / h;
        let moment = ((end.0[d] - start.0[d]) / h - start.1[d]) / h;
        let bend = 0.5 * (first[d] + last[d]) - mean;
        let from_places = 0.5 * (last[d] - first[d]) - (3.0 * mean - 6.0 * moment);
        // On a short step the difference of the positions is rounding.
        let rounding = f64::EPSILON * (start.0[d].abs() + h * start.1[d].abs());
        let is_resolved = h * h * from_places.abs() > ROUNDED * rounding;
        let twist = if is_resolved { from_places } else { 0.0 };
        let tilt = 0.5 * (last[d] - first[d]) - twist;
        acceleration[d] = [mean, tilt, bend, twist, 0.0];
    }
    Step::new(h, [start, end], acceleration)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::step::series;
    use crate::numerics::step::tests::Spring;

    const OSCILLATOR: Spring = Spring(1.0);
    const START: Point<1> = ([1.0], [0.0]);

    /// Errors of the place at the end of a step and in its middle.
    fn errors(stepper: &impl Stepper<COEFFICIENTS>, h: f64) -> [f64; 2] {
        let (step, _) = stepper.step(&OSCILLATOR, START, h, None, &mut 0).unwrap();
        [1.0, 0.5].map(|part| (step.at(part).0[0] - (part * h).cos()).abs())
    }

    #[test]
    fn valid_half_the_step_leaves_two_to_the_order_and_one_of_the_error() {
        let rate = |stepper: &dyn Fn(f64) -> [f64; 2], h: f64, which: usize| {
            (stepper(h)[which] / stepper(0.5 * h)[which]).log2()
        };
        let classical = |h: f64| errors(&Rk4 { step: 1.0, locates: true }, h);
        let high = |h: f64| errors(&Dop853 { tolerance: 1.0 }, h);
        // The place of a step of even order begins to err one power later.
        assert!((rate(&classical, 0.2, 0) - 6.0).abs() < 0.5, "{}", rate(&classical, 0.2, 0));
        assert!(rate(&high, 1.0, 0) > 8.5, "{}", rate(&high, 1.0, 0));
        assert!((rate(&high, 0.5, 1) - 6.0).abs() < 0.5, "{}", rate(&high, 0.5, 1));
    }

    #[test]
    fn valid_a_step_ends_where_its_polynomials_end() {
        let (step, _) =
            Dop853 { tolerance: 1.0 }.step(&OSCILLATOR, START, 1.0, None, &mut 0).unwrap();
        let (place, speed) = step.at(1.0);
        assert!(
            (place[0] - step.end.0[0]).abs() < 1e-15 && (speed[0] - step.end.1[0]).abs() < 1e-15
        );
        let accelerations = [0.0, 1.0].map(|part| series(&step.acceleration, part)[0]);
        assert!((accelerations[0] + 1.0).abs() < 1e-14, "{accelerations:?}");
        assert!((accelerations[1] + step.end.0[0]).abs() < 1e-14, "{accelerations:?}");
    }

    /// 7 mm from the origin, in a step of 4 ps: a velocity by the change of position alone would be off by 1e-6 m/s.
    #[test]
    fn valid_the_velocity_on_a_short_step_is_not_that_of_rounded_positions() {
        let (w_m_s, acceleration) = (0.065, 3e4);
        for h in [4e-12, 1e-9, 1e-6] {
            let end = 0.007 + (w_m_s + 0.5 * acceleration * h) * h;
            let ends = [([0.007], [w_m_s]), ([end], [w_m_s + acceleration * h])];
            let step = through(h, ends[0], ends[1], [[acceleration]; 2]);
            for part in [0.1, 0.3, 0.5, 0.8] {
                let exact = w_m_s + acceleration * part * h;
                let (_, speed) = step.at(part);
                assert!((speed[0] / exact - 1.0).abs() < 1e-14, "{h:e} {part}: {speed:?}");
            }
        }
    }

    #[test]
    fn valid_the_tolerance_of_dop853_bounds_the_error_of_a_step() {
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let method = Dop853 { tolerance };
            let (mut h, mut evaluations) = (10.0, 0);
            let step = loop {
                match method.step(&OSCILLATOR, START, h, None, &mut evaluations) {
                    Ok((step, _)) => break step,
                    Err(shorter) => h = shorter,
                }
            };
            let error = (step.end.0[0] - step.h.cos()).abs();
            assert!(error < tolerance && error > 1e-7 * tolerance, "{tolerance:e}: {error:e}");
            assert_eq!(evaluations % 13, 0);
        }
    }

    /// Their sums are the nodes; the weights of the end integrate powers up to the eighth exactly.
    #[test]
    fn valid_the_rows_of_dop853_satisfy_the_conditions_of_quadrature() {
        let nodes: Vec<f64> =
            std::iter::once(0.0).chain(STAGES[..11].iter().map(|row| row.iter().sum())).collect();
        for power in 0..8 {
            let sum: f64 =
                STAGES[11].iter().zip(&nodes).map(|(weight, node)| weight * node.powi(power)).sum();
            let exact = 1.0 / f64::from(power + 1);
            assert!((sum / exact - 1.0).abs() < 1e-13, "{power}: {sum}");
        }
        for errors in ERRORS {
            assert!(errors.iter().sum::<f64>().abs() < 1e-14);
        }
    }
}
