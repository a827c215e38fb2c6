//! Radau IIA collocation of order 5 with three stages, for systems in which a quantity may be known only through a
//! function of the unknown.
//!
//! The system is d/dt g(y) = f(t, y) with g acting on each component by itself. With g(y) = y it is an ordinary differential
//! equation; where y is a stiff force and g(y) the small displacement that causes it, Newton's method sees a smooth, flat
//! function instead of one with infinite slope. The method is L-stable: E. Hairer and G. Wanner, *Solving Ordinary Differential
//! Equations II*, 2nd ed. (1996), section IV.8, tableau IV.5.6 (page 74), error estimate (8.19)/(8.20), step control (8.21).

use crate::numerics::linear::solve;

const STAGES: usize = 3;

/// A system d/dt g(y) = f(t, y) of N components.
pub(crate) trait ImplicitSystem<const N: usize> {
    /// g(y).
    fn carried(&self, y: &[f64; N]) -> [f64; N];
    /// dg/dy, component by component.
    fn carried_slope(&self, y: &[f64; N]) -> [f64; N];
    /// f(y) so long after the start of the step.
    fn rate(&self, after: f64, y: &[f64; N]) -> [f64; N];
    /// df/dy; `jacobian[i][j]` is the derivative of component i by component j of y.
    fn jacobian(&self, y: &[f64; N]) -> [[f64; N]; N];
    /// Scale of each component of g against which Newton's corrections are measured, > 0.
    fn scale(&self) -> [f64; N];
}

/// A component by its unknown y: the value g(y), and the force that depends on it, with their derivatives by y.
pub(crate) struct Unfolded {
    pub(crate) value: f64,
    pub(crate) slope: f64,
    pub(crate) force: f64,
    pub(crate) force_slope: f64,
}

/// A step that Newton's method has solved.
#[derive(Clone, Debug)]
pub(crate) struct Step<const N: usize> {
    /// y at the three collocation points; the last is the end of the step.
    pub(crate) stages: [[f64; N]; STAGES],
    /// Estimated local error relative to the scales, largest component.
    pub(crate) error: f64,
    pub(crate) iterations: usize,
}

/// The collocation points, as fractions of the step.
pub(crate) const NODES: [f64; STAGES] = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];
/// Weights of the end value (they equal the last row of the matrix).
pub(crate) const WEIGHTS: [f64; STAGES] =
    [0.376_403_062_700_467_3, 0.512_485_826_188_421_6, 0.111_111_111_111_111_1];
const MATRIX: [[f64; STAGES]; STAGES] = [
    [0.196_815_477_223_660_4, -0.065_535_425_850_198_39, 0.023_770_974_348_220_15],
    [0.394_424_314_739_087_3, 0.292_073_411_665_228_5, -0.041_548_752_125_997_93],
    WEIGHTS,
];
/// Real eigenvalue of the inverse matrix (the reciprocal of (6 + 81^(1/3) - 9^(1/3))/30).
const GAMMA_0: f64 = 3.637_834_252_744_496;
const ERROR_WEIGHTS: [f64; STAGES] =
    [-10.048_809_399_827_416, 1.382_142_733_160_748_7, -0.333_333_333_333_333_3];
/// Iterations of Newton's method in a step, at most.
pub(crate) const NEWTON_MAX: usize = 25;
/// Changes below which Newton's method has come to where rounding keeps it, once it no longer halves them; and where it has not
/// for some rounds.
const STALLED: f64 = 1e-12;
const STALLED_LONG: f64 = 1e-11;
const LONG: usize = 4;

/// Solve one step of length `h` from `y`; `None` when Newton's method does not converge.
///
/// `guess` are the stages to start from (the constant `y`, or a better guess).
pub(crate) fn step<const N: usize, const M: usize>(
    system: &impl ImplicitSystem<N>,
    y: &[f64; N],
    h: f64,
    guess: [[f64; N]; STAGES],
) -> Option<Step<N>> {
    debug_assert_eq!(M, STAGES * N, "M is the size of the Newton system");
    let start = system.carried(y);
    let scale = system.scale();
    let mut stages = guess;
    let mut iterations = 0;
    let mut last_change = f64::INFINITY;
    let mut stalls = 0;
    loop {
        iterations += 1;
        if iterations > NEWTON_MAX {
            return None;
        }
        let (mut matrix, mut right) = newton_system::<N, M>(system, &stages, &start, h);
        if !solve(&mut matrix, &mut right) {
            return None;
        }
        let mut change = 0.0f64;
        for i in 0..STAGES {
            let slope = system.carried_slope(&stages[i]);
            for k in 0..N {
                let delta = right[i * N + k];
                stages[i][k] += delta;
                let moved = (slope[k] * delta).abs() / scale[k];
                change = if moved > change { moved } else { change };
                // A component that g flattens is compared with its own size.
                let own = delta.abs() / (stages[i][k].abs() + f64::MIN_POSITIVE);
                if slope[k] == 0.0 && own > 1e-6 {
                    change = if own > change { own } else { change };
                }
            }
        }
        if !change.is_finite() {
            return None;
        }
        let halves = change < 0.5 * last_change;
        stalls = if halves { 0 } else { stalls + 1 };
        let stalled = stalls > 0 && change < STALLED || stalls >= LONG && change < STALLED_LONG;
        if change < 1e-15 || stalled {
            break;
        }
        last_change = change;
    }
    let error = estimate(system, y, &start, &stages, h)?;
    Some(Step { stages, error, iterations })
}

fn newton_system<const N: usize, const M: usize>(
    system: &impl ImplicitSystem<N>,
    stages: &[[f64; N]; STAGES],
    start: &[f64; N],
    h: f64,
) -> ([[f64; M]; M], [f64; M]) {
    let mut matrix = [[0.0; M]; M];
    let mut right = [0.0; M];
    for i in 0..STAGES {
        let carried = system.carried(&stages[i]);
        let slope = system.carried_slope(&stages[i]);
        for k in 0..N {
            right[i * N + k] += start[k] - carried[k];
            matrix[i * N + k][i * N + k] += slope[k];
        }
    }
    for j in 0..STAGES {
        let rate = system.rate(h * NODES[j], &stages[j]);
        let jacobian = system.jacobian(&stages[j]);
        for i in 0..STAGES {
            let weight = h * MATRIX[i][j];
            for k in 0..N {
                right[i * N + k] += weight * rate[k];
                for l in 0..N {
                    matrix[i * N + k][j * N + l] -= weight * jacobian[k][l];
                }
            }
        }
    }
    (matrix, right)
}

/// Hairer's embedded estimate, filtered through the stiff part so that decayed transients do not count.
fn estimate<const N: usize>(
    system: &impl ImplicitSystem<N>,
    y: &[f64; N],
    start: &[f64; N],
    stages: &[[f64; N]; STAGES],
    h: f64,
) -> Option<f64> {
    let mut right = system.rate(0.0, y);
    for (stage, weight) in stages.iter().zip(ERROR_WEIGHTS) {
        let carried = system.carried(stage);
        for k in 0..N {
            right[k] += weight * (carried[k] - start[k]) / h;
        }
    }
    let end = &stages[STAGES - 1];
    let (jacobian, slope) = (system.jacobian(end), system.carried_slope(end));
    let mut matrix = [[0.0; N]; N];
    for k in 0..N {
        for l in 0..N {
            matrix[k][l] = -jacobian[k][l];
        }
        matrix[k][k] += GAMMA_0 / h * slope[k];
    }
    if !solve(&mut matrix, &mut right) {
        return None;
    }
    let scale = system.scale();
    let mut error = 0.0;
    for k in 0..N {
        let relative = (slope[k] * right[k]).abs() / scale[k];
        error = if relative > error || relative.is_nan() { relative } else { error };
    }
    error.is_finite().then_some(error)
}

/// The factor by which to change a step whose estimated error is `error` when `tolerance` is asked.
pub(crate) fn step_factor(error: f64, tolerance: f64) -> f64 {
    if error == 0.0 {
        return 8.0;
    }
    let factor = 0.9 * (tolerance / error).powf(0.25);
    factor.clamp(0.125, 8.0)
}

/// The collocation polynomial at fraction `s` of the step (0: its start, 1: its end).
pub(crate) fn interpolate<const N: usize>(y: &[f64; N], step: &Step<N>, s: f64) -> [f64; N] {
    let points = [0.0, NODES[0], NODES[1], NODES[2]];
    let mut out = [0.0; N];
    for i in 0..points.len() {
        let mut basis = 1.0;
        for j in 0..points.len() {
            if i != j {
                basis *= (s - points[j]) / (points[i] - points[j]);
            }
        }
        let values = if i == 0 { y } else { &step.stages[i - 1] };
        for k in 0..N {
            out[k] += basis * values[k];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y' = -rate (y - cos t) - sin t, t' = 1: Prothero and Robinson, stiff for a large rate; from y(0) = 1 the solution is cos t.
    struct Relax(f64);

    impl ImplicitSystem<2> for Relax {
        fn carried(&self, y: &[f64; 2]) -> [f64; 2] {
            *y
        }
        fn carried_slope(&self, _: &[f64; 2]) -> [f64; 2] {
            [1.0; 2]
        }
        fn rate(&self, _: f64, y: &[f64; 2]) -> [f64; 2] {
            [-self.0 * (y[0] - y[1].cos()) - y[1].sin(), 1.0]
        }
        fn jacobian(&self, y: &[f64; 2]) -> [[f64; 2]; 2] {
            [[-self.0, -self.0 * y[1].sin() - y[1].cos()], [0.0, 0.0]]
        }
        fn scale(&self) -> [f64; 2] {
            [1.0; 2]
        }
    }

    fn fixed(rate: f64, steps: usize) -> f64 {
        let h = 1.0 / steps as f64;
        let mut y = [1.0, 0.0];
        for _ in 0..steps {
            let step = step::<2, 6>(&Relax(rate), &y, h, [y; 3]).unwrap();
            y = step.stages[2];
        }
        (y[0] - 1f64.cos()).abs()
    }

    #[test]
    fn tableau_satisfies_the_order_conditions() {
        for i in 0..STAGES {
            for q in 1..=STAGES {
                let sum: f64 =
                    (0..STAGES).map(|j| MATRIX[i][j] * NODES[j].powf(q as f64 - 1.0)).sum();
                assert!((sum - NODES[i].powf(q as f64) / q as f64).abs() < 1e-15);
            }
        }
        for q in 1..=5 {
            let sum: f64 = (0..STAGES).map(|j| WEIGHTS[j] * NODES[j].powi(q - 1)).sum();
            assert!((sum - 1.0 / f64::from(q)).abs() < 1e-15);
        }
    }

    #[test]
    fn observed_order_is_five_on_a_smooth_problem() {
        let order = (fixed(1.0, 8) / fixed(1.0, 16)).log2();
        assert!((order - 5.0).abs() < 0.3, "{order}");
    }

    #[test]
    fn a_rate_of_1e12_needs_no_small_steps() {
        assert!(fixed(1e12, 4) < 1e-6);
    }

    #[test]
    fn missing_convergence_is_reported() {
        struct Wild;
        impl ImplicitSystem<1> for Wild {
            fn carried(&self, y: &[f64; 1]) -> [f64; 1] {
                *y
            }
            fn carried_slope(&self, _: &[f64; 1]) -> [f64; 1] {
                [1.0]
            }
            fn rate(&self, _: f64, y: &[f64; 1]) -> [f64; 1] {
                [if y[0] > 0.5 { f64::NAN } else { 1.0 }]
            }
            fn jacobian(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
                [[0.0]]
            }
            fn scale(&self) -> [f64; 1] {
                [1.0]
            }
        }
        assert!(step::<1, 3>(&Wild, &[0.0], 1.0, [[0.0]; 3]).is_none());
    }

    #[test]
    fn interpolation_reproduces_cubics() {
        let f = |s: f64| 1.0 + s - 2.0 * s * s + 3.0 * s * s * s;
        let step = Step { stages: NODES.map(|s| [f(s)]), error: 0.0, iterations: 0 };
        let value = interpolate(&[f(0.0)], &step, 0.37)[0];
        assert!((value - f(0.37)).abs() < 1e-14);
    }
}
