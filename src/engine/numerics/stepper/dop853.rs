//! DOP853: order eight with twelve stages, error estimates of order five and three.
//!
//! J. R. Dormand and P. J. Prince's pair in the form of E. Hairer, S. P. Nørsett and G. Wanner, *Solving Ordinary Differential
//! Equations I*, 2nd ed. (1993), section II.10, with its error measure (10.21), the starting step of section II.4 and a
//! proportional-integral controller (volume II, section IV.2).

use super::landing::Ends;
use super::{Count, Point, Reached, Start, Stepper, StopReason, System, is_finite};
use crate::numerics::explicit::tableau::{ERRORS, STAGES};

/// Stages of a step.
const S: usize = 12;
const SAFETY: f64 = 0.9;
const SHRINK_MAX: f64 = 1.0 / 3.0;
const GROW_MAX: f64 = 6.0;
/// Weight of the previous error in the controller.
const BETA: f64 = 0.04;
/// Exponent of the present error.
const ALPHA: f64 = 1.0 / 8.0 - 0.2 * BETA;

/// A step computed but not yet accepted: rates at the stages, and the end.
struct Trial<const N: usize> {
    k: [[f64; N]; S],
    y: [f64; N],
}

/// The method to a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dop853 {
    /// Bound of a step's error in each component, relative to the greater of 1 and the component's own size: scale the system so
    /// that 1 is what matters.
    pub tolerance: f64,
}

impl<const N: usize, S: System<N>> Stepper<N, S> for Dop853 {
    fn integrate(&self, system: &S, start: Start<N>, count: &mut Count) -> Reached<N> {
        let tolerance = self.tolerance;
        let (mut t, mut y) = (start.t, start.y);
        let mut f = system.rate(&y);
        count.evaluations += 1;
        let from = Point { y: &y, f: &f };
        let mut h = start.step.unwrap_or_else(|| first_step(system, from, tolerance, count));
        let (mut error_before, mut was_rejected, mut was_nan) = (1e-4f64, false, false);
        loop {
            if let Some(stop) = count.forbids(t, h) {
                let is_lost = was_nan && stop == StopReason::StepUnderflow;
                return Reached {
                    t,
                    y,
                    stop: if is_lost { StopReason::NonFinite } else { stop },
                    step: h,
                };
            }
            let from = Point { y: &y, f: &f };
            let trial = step(system, from, h, count);
            let error = error(&trial, &y, h, tolerance);
            let f_next = system.rate(&trial.y);
            count.evaluations += 1;
            was_nan = !(error.is_finite() && is_finite(&trial.y) && is_finite(&f_next));
            if was_nan || error > 1.0 {
                count.rejected += 1;
                was_rejected = true;
                h *= if was_nan { 0.1 } else { limited(SAFETY * error.powf(-ALPHA)) };
                continue;
            }
            count.steps += 1;
            let ends = Ends { h, y0: &y, f0: &f, y1: &trial.y, f1: &f_next };
            let anew = |s: f64| step(system, from, s * h, count).y;
            if let Some((index, part, y)) = ends.land(system.boundaries(), anew) {
                return Reached { t: t + part * h, y, stop: StopReason::Boundary(index), step: h };
            }
            t += h;
            let least = if error > 1e-10 { error } else { 1e-10 };
            let factor = limited(SAFETY * least.powf(-ALPHA) * error_before.powf(BETA));
            h *= if was_rejected && factor > 1.0 { 1.0 } else { factor };
            error_before = if error > 1e-4 { error } else { 1e-4 };
            was_rejected = false;
            (y, f) = (trial.y, f_next);
        }
    }
}

fn limited(factor: f64) -> f64 {
    factor.clamp(SHRINK_MAX, GROW_MAX)
}

/// The state from which stage I starts (I = 12: the end of the step).
fn stage<const I: usize, const N: usize>(y: &[f64; N], h: f64, k: &[[f64; N]]) -> [f64; N] {
    let mut sum = [0.0; N];
    for j in 0..I {
        let weight = STAGES[I - 1][j];
        if weight != 0.0 {
            for i in 0..N {
                sum[i] += weight * k[j][i];
            }
        }
    }
    std::array::from_fn(|i| y[i] + h * sum[i])
}

fn step<const N: usize>(
    system: &impl System<N>,
    Point { y, f }: Point<'_, N>,
    h: f64,
    count: &mut Count,
) -> Trial<N> {
    let mut k = [[0.0; N]; S];
    k[0] = *f;
    k[1] = system.rate(&stage::<1, N>(y, h, &k));
    k[2] = system.rate(&stage::<2, N>(y, h, &k));
    k[3] = system.rate(&stage::<3, N>(y, h, &k));
    k[4] = system.rate(&stage::<4, N>(y, h, &k));
    k[5] = system.rate(&stage::<5, N>(y, h, &k));
    k[6] = system.rate(&stage::<6, N>(y, h, &k));
    k[7] = system.rate(&stage::<7, N>(y, h, &k));
    k[8] = system.rate(&stage::<8, N>(y, h, &k));
    k[9] = system.rate(&stage::<9, N>(y, h, &k));
    k[10] = system.rate(&stage::<10, N>(y, h, &k));
    k[11] = system.rate(&stage::<11, N>(y, h, &k));
    count.evaluations += S - 1;
    Trial { y: stage::<12, N>(y, h, &k), k }
}

/// The error of a step over the tolerance: Hairer's mixture of the fifth- and third-order estimates.
fn error<const N: usize>(trial: &Trial<N>, y: &[f64; N], h: f64, tolerance: f64) -> f64 {
    let (mut fifth, mut third) = (0.0, 0.0);
    for i in 0..N {
        let size = if y[i].abs() > trial.y[i].abs() { y[i].abs() } else { trial.y[i].abs() };
        let scale = tolerance * (1.0 + size);
        let (mut five, mut three) = (0.0, 0.0);
        for (j, k) in trial.k.iter().enumerate() {
            five += ERRORS[1][j] * k[i];
            three += ERRORS[0][j] * k[i];
        }
        fifth += (five / scale) * (five / scale);
        third += (three / scale) * (three / scale);
    }
    let mix = fifth + 0.01 * third;
    if mix == 0.0 { 0.0 } else { h * fifth / (mix * N as f64).sqrt() }
}

/// Hairer's starting step: an Euler step shows the second derivative.
fn first_step<const N: usize>(
    system: &impl System<N>,
    Point { y, f }: Point<'_, N>,
    tolerance: f64,
    count: &mut Count,
) -> f64 {
    let norm = |z: &[f64; N]| {
        let sum: f64 =
            z.iter().zip(y).map(|(z, y)| (z / (tolerance * (1.0 + y.abs()))).powi(2)).sum();
        (sum / N as f64).sqrt()
    };
    let (size, speed) = (norm(y), norm(f));
    let euler = if size < 1e-5 || speed < 1e-5 { 1e-6 } else { 0.01 * size / speed };
    let ahead = system.rate(&std::array::from_fn(|i| y[i] + euler * f[i]));
    count.evaluations += 1;
    let bend = norm(&std::array::from_fn(|i| ahead[i] - f[i])) / euler;
    let most = if bend > speed { bend } else { speed };
    let step = if most <= 1e-15 { 1e-3 * euler } else { (0.01 / most).powf(1.0 / 8.0) };
    let step = if step < 100.0 * euler { step } else { 100.0 * euler };
    if step.is_finite() { step } else { euler }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{BELL, Bell};
    use super::*;

    /// y' = y: nothing hides the first coefficient that is missed, as it does where error constants nearly cancel.
    struct Growth;

    impl System<1> for Growth {
        fn rate(&self, y: &[f64; 1]) -> [f64; 1] {
            *y
        }
    }

    /// The times of the stages within a step: a rate that is 1 all along gives them.
    fn nodes() -> [f64; S] {
        std::array::from_fn(|i| if i == 0 { 0.0 } else { STAGES[i - 1].iter().sum() })
    }

    fn bell(t: f64) -> f64 {
        1.0 / (1.0 + t * t)
    }

    #[test]
    fn tableau_satisfies_the_quadrature_conditions() {
        for i in 1..=S {
            for later in &STAGES[i - 1][i..] {
                assert!(later.abs() < f64::MIN_POSITIVE, "{i}");
            }
        }
        let nodes = nodes();
        for q in 1..=8 {
            let sum: f64 = (0..S).map(|j| STAGES[11][j] * nodes[j].powi(q - 1)).sum();
            assert!((sum - 1.0 / f64::from(q)).abs() < 1e-14, "{q}");
        }
        // The embedded formulas: of order 3 and 5, so that the differences vanish on lower powers.
        for q in 1..=5 {
            let moment = |w: &[f64; S]| (0..S).map(|j| w[j] * nodes[j].powi(q - 1)).sum::<f64>();
            assert!(moment(&ERRORS[1]).abs() < 1e-14, "{q}");
            assert!(q > 3 || moment(&ERRORS[0]).abs() < 1e-14, "{q}");
        }
    }

    #[test]
    fn stages_satisfy_the_simplifying_conditions_of_order_eight() {
        // sum_i b_i c_i^k (sum_j a_ij c_j^(l-1) - c_i^l / l) = 0 for the trees of one branch, k + l + 1 <= 8.
        let nodes = nodes();
        for l in 1..=7i32 {
            for k in 0..=(7 - l) {
                let mut sum = 0.0;
                for i in 1..S {
                    let inner: f64 = (0..i).map(|j| STAGES[i - 1][j] * nodes[j].powi(l - 1)).sum();
                    let defect = inner - nodes[i].powi(l) / f64::from(l);
                    sum += STAGES[11][i] * nodes[i].powi(k) * defect;
                }
                assert!(sum.abs() < 2e-14, "l {l} k {k}: {sum}");
            }
        }
    }

    /// Slope of log error over log step by two step sizes.
    #[test]
    fn the_observed_order_is_eight() {
        let fixed = |steps: usize| {
            let h = 6.0 / steps as f64;
            let mut y = [1.0];
            for _ in 0..steps {
                let f = Growth.rate(&y);
                y = step(&Growth, Point { y: &y, f: &f }, h, &mut Count::up_to(1)).y;
            }
            (y[0] / 6f64.exp() - 1.0).abs()
        };
        let order = (fixed(12) / fixed(24)).log2();
        assert!((order - 8.0).abs() < 0.3, "{order}");
    }

    #[test]
    fn the_error_follows_the_tolerance() {
        for tolerance in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
            let method = Dop853 { tolerance };
            let end = method.integrate(&Bell::up_to(5.0), BELL, &mut Count::up_to(10_000));
            assert_eq!(end.stop, StopReason::Boundary(0));
            let error = (end.y[0] - bell(5.0)).abs();
            assert!(error < 10.0 * tolerance, "{tolerance}: {error}");
        }
    }
}
