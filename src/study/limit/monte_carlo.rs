//! The limit for scattered inputs: V50, its spread, and the probability that the scene's own shot perforates.

use std::sync::Arc;

use crate::model::scene::Scene;
use crate::numerics::random::Random;
use crate::numerics::statistics::{moments, quantile, wilson};
use crate::study::context::Context;
use crate::study::limit::search::{Range, Scan};
use crate::study::limit::{Criterion, Limit};
use crate::study::monte_carlo::{Draw, usual_tolerances};

/// Each sample's limit is searched within this factor of the nominal one, with a given number of points, to this relative width.
const WITHIN: f64 = 2.0;
const POINTS: usize = 9;
const WIDTH: f64 = 1e-5;
/// How far the model itself is off, by `cmra validate`.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ModelError {
    /// Model over measurement, less 1: negative where limits come out low; > -1.
    pub bias: f64,
    /// Standard deviation of the logarithm of model over measurement, >= 0.
    pub spread: f64,
}

impl ModelError {
    /// The correction factor of a computed limit.
    fn factor(self, random: &mut Random) -> f64 {
        let spread = if self.spread > 0.0 { (self.spread * random.normal()).exp() } else { 1.0 };
        spread / (1.0 + self.bias)
    }
}

/// The request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Relative standard deviation of every scattered input, > 0.
    pub deviation: f64,
    /// Number of samples, >= 2.
    pub samples: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The error of the model, in every limit besides.
    pub model: ModelError,
}

/// The result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledLimit {
    /// The request.
    pub sampling: Sampling,
    /// Samples with a limit near the nominal one.
    pub found: usize,
    /// Samples without.
    pub without: usize,
    /// Half of the limits lie below this, m/s.
    pub v50_m_s: f64,
    /// Standard deviation of the limits, m/s.
    pub deviation_m_s: f64,
    /// One in twenty lies below this, and one in twenty above the other, m/s.
    pub range90_m_s: (f64, f64),
    /// Part of the samples that the scene's own velocity perforates.
    pub perforated: f64,
    /// Its 95 % confidence interval (Wilson's).
    pub perforated95: (f64, f64),
}

/// The limits of sampled scenes, with every input of Monte Carlo's own that a limit depends on. `None` when stopped, or when too few
/// have a limit.
pub(super) fn sample(
    scene: &Arc<Scene>,
    sampling: Sampling,
    nominal_m_s: f64,
    criterion: Criterion,
    context: &mut Context<'_>,
) -> Option<SampledLimit> {
    let scene = &Scene { target: scene.target_in_effect(), ..Scene::clone(scene) };
    let mut tolerances = usual_tolerances(scene, sampling.deviation);
    tolerances.retain(|tolerance| tolerance.symbol() != "v_i");
    let mut errors = Random::new(!sampling.seed);
    let mut limits = Vec::new();
    let (mut without, mut through) = (0, 0_usize);
    let own_m_s = scene.projectile.velocity_m_s;
    let scan = Scan {
        low_m_s: nominal_m_s / WITHIN,
        high_m_s: nominal_m_s * WITHIN,
        points: POINTS,
        width: WIDTH,
    };
    let stop = context.stop();
    let limit_of = |sample: &[f64]| {
        let mut own = scene.clone();
        for (tolerance, value) in tolerances.iter().zip(sample) {
            (tolerance.number().set)(&mut own, Some(*value));
        }
        let watch = &mut |_, _: Option<&()>| stop.flow();
        let context = &mut Context::new(1, watch);
        let limit = Range { scene: &Arc::new(own), criterion, context }.limit(scan);
        (!context.is_stopped() && limit != Limit::Unknown).then_some(limit)
    };
    let mut draw = Draw::new(scene, &tolerances, sampling.seed);
    let drawn = draw.each_batch(sampling.samples, context, |samples, context| {
        let limit_of = |sample: &Vec<f64>| limit_of(sample);
        for limit in context.map_items(samples, limit_of, |context, _| context.goes_on()) {
            let factor = sampling.model.factor(&mut errors);
            match limit {
                Limit::Found { velocity_m_s, .. } => {
                    through += usize::from(factor * velocity_m_s < own_m_s);
                    limits.push(factor * velocity_m_s);
                }
                // Beyond the bracket on a known side.
                Limit::Always => {
                    without += 1;
                    through += usize::from(own_m_s > factor * scan.low_m_s);
                }
                Limit::Between { .. } | Limit::Never | Limit::Unknown => without += 1,
            }
        }
    });
    if drawn.is_err() || context.is_stopped() {
        return None;
    }
    limits.sort_by(f64::total_cmp);
    let (_, deviation_m_s) = moments(&limits)?;
    let samples = sampling.samples as f64;
    let perforated = through as f64 / samples;
    Some(SampledLimit {
        sampling,
        found: limits.len(),
        without,
        v50_m_s: quantile(&limits, 0.5),
        deviation_m_s,
        range90_m_s: (quantile(&limits, 0.05), quantile(&limits, 0.95)),
        perforated,
        perforated95: wilson(perforated, samples),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A model that comes out 4 % low measures 1/0.96 of it; without spread the factor is that alone, with spread its logarithm has
    /// the deviation.
    #[test]
    fn the_error_of_the_model_is_a_factor_on_each_limit() {
        let mut random = Random::new(7);
        let low = ModelError { bias: -0.04, spread: 0.0 };
        assert!((low.factor(&mut random) - 1.0 / 0.96).abs() < 1e-15);
        let wide = ModelError { bias: 0.0, spread: 0.1 };
        let logs: Vec<f64> = (0..20_000).map(|_| wide.factor(&mut random).ln()).collect();
        let (mean, deviation) = moments(&logs).unwrap();
        assert!(mean.abs() < 3e-3 && (deviation - 0.1).abs() < 2e-3, "{mean} {deviation}");
    }
}
