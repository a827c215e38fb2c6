//! Morris's elementary effects of any function of the unit cube (*Technometrics* 33 (1991) 161-174): what one input's step does,
//! at many places. Their mean magnitude mu* (Campolongo, Cariboni and Saltelli, *Environmental Modelling & Software* 22 (2007)
//! 1509-1518) measures how much an input matters, their standard deviation how much that depends on the other inputs.

use crate::numerics::random::Random;
use crate::numerics::statistics::moments;
use crate::study::sensitivity::Function;

/// Levels of every input: 0, 1/3, 2/3 and 1, and steps of two of them.
const STEP: f64 = 2.0 / 3.0;
const LEVEL: f64 = 1.0 / 3.0;

/// The effects of one input, in units of the function for the input's whole range; `None` where fewer than two are known.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Effect {
    /// Mean.
    pub mean: Option<f64>,
    /// mu*, mean magnitude.
    pub magnitude: Option<f64>,
    /// sigma, standard deviation.
    pub deviation: Option<f64>,
    /// Steps of which both ends have a value.
    pub used: usize,
}

/// The effects of a function of a given number of inputs along a given number of trajectories, each of which costs one evaluation an input and
/// one more. `None` when the function was stopped.
pub fn morris(
    inputs: usize,
    trajectories: usize,
    seed: u64,
    function: Function<'_>,
) -> Option<Vec<Effect>> {
    let mut random = Random::new(seed);
    let mut effects = vec![Vec::new(); inputs];
    for _ in 0..trajectories {
        let (points, order) = trajectory(inputs, &mut random);
        let values = function(&points)?;
        for (step, input) in order.into_iter().enumerate() {
            let ran = points[step + 1][input] - points[step][input];
            let effect = (values[step + 1] - values[step]) / ran;
            if effect.is_finite() {
                effects[input].push(effect);
            }
        }
    }
    Some(effects.iter().map(|effects| summary(effects)).collect())
}

/// Points that differ in one input each from the one before, and the order of the inputs.
fn trajectory(inputs: usize, random: &mut Random) -> (Vec<Vec<f64>>, Vec<usize>) {
    let mut order: Vec<usize> = (0..inputs).collect();
    for last in (1..inputs).rev() {
        order.swap(last, random.below(last + 1));
    }
    // Each input starts on one of the two lower levels and rises, or from its mirror image and falls.
    let mut rises = Vec::new();
    let mut point = Vec::new();
    for _ in 0..inputs {
        let low = LEVEL * random.below(2) as f64;
        let rise = random.below(2) == 0;
        rises.push(rise);
        point.push(if rise { low } else { low + STEP });
    }
    let mut points = vec![point.clone()];
    for input in &order {
        point[*input] += if rises[*input] { STEP } else { -STEP };
        point[*input] = point[*input].clamp(0.0, 1.0);
        points.push(point.clone());
    }
    (points, order)
}

fn summary(effects: &[f64]) -> Effect {
    let own = moments(effects);
    let magnitudes: Vec<f64> = effects.iter().map(|effect| effect.abs()).collect();
    Effect {
        mean: own.map(|(mean, _)| mean),
        magnitude: moments(&magnitudes).map(|(mean, _)| mean),
        deviation: own.map(|(_, deviation)| deviation),
        used: effects.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn effects(inputs: usize, trajectories: usize, f: fn(&[f64]) -> f64) -> Vec<Effect> {
        let function: Function<'_> = &mut |points| Some(points.iter().map(|x| f(x)).collect());
        morris(inputs, trajectories, 1, function).unwrap()
    }

    #[test]
    fn a_plane_has_its_slopes_and_no_deviation() {
        let found = effects(3, 20, |x| 2.0 * x[0] - 3.0 * x[1] + 7.0);
        for (effect, slope) in found.iter().zip([2.0f64, -3.0, 0.0]) {
            assert!((effect.mean.unwrap() - slope).abs() < 1e-12);
            assert!((effect.magnitude.unwrap() - slope.abs()).abs() < 1e-12);
            assert!(effect.deviation.unwrap() < 1e-12);
            assert_eq!(effect.used, 20);
        }
    }

    /// The effect of one factor of a product is the other: uniform on the four levels, mean 1/2, deviation sqrt(5)/6.
    #[test]
    fn a_product_has_the_moments_of_its_levels() {
        let found = effects(2, 20_000, |x| x[0] * x[1]);
        for effect in found {
            assert!((effect.mean.unwrap() - 0.5).abs() < 0.01);
            assert!((effect.deviation.unwrap() - 5f64.sqrt() / 6.0).abs() < 0.01);
        }
    }

    #[test]
    fn opposite_effects_do_not_cancel_in_mu_star_and_missing_values_are_omitted() {
        // Rises on the lower half and falls by as much on the upper.
        let bend = effects(1, 400, |x| (x[0] - 0.5).abs() * if x[0] > 0.4 { 0.0 } else { 1.0 });
        assert!(bend[0].magnitude.unwrap() > 0.1);
        let holes = effects(2, 200, |x| if x[0] > 0.9 { f64::NAN } else { x[1] });
        assert!((50..150).contains(&holes[0].used), "{}", holes[0].used);
        assert!((holes[1].mean.unwrap() - 1.0).abs() < 1e-12);
        let none = effects(1, 5, |_| f64::NAN);
        assert_eq!(none[0], Effect::default());
    }
}
