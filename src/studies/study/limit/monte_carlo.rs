//! The limit for scattered inputs: V50, its spread, and the probability that the scene's own shot perforates.

use std::sync::Arc;

use crate::model::scene::Scene;
use crate::numerics::random::Random;
use crate::numerics::statistics::{Z95, moments, quantile, wilson};
use crate::study::context::Context;
use crate::study::limit::search::{Scan, ShotRunner};
use crate::study::limit::{Criterion, Limit};
use crate::study::monte_carlo::{Draw, usual_tolerances};

/// Each sample's limit is searched within this factor of the nominal one, with a given number of points, to this relative width; where
/// it is not there, over all velocities.
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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

/// The result. A sample without a limit in the range of velocities counts as below or above all limits; what falls among such samples
/// is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SampledLimit {
    /// The request.
    pub sampling: Sampling,
    /// Samples with a limit.
    pub found: usize,
    /// Samples that everything in the range of velocities perforates.
    pub below: usize,
    /// Samples that nothing in it perforates.
    pub above: usize,
    /// Samples whose limit runs do not decide: they have no rank.
    pub undecided: usize,
    /// Half of the limits lie below this, m/s.
    pub v50_m_s: Option<f64>,
    /// Its 95 % confidence interval, from order statistics, m/s.
    pub v50_95_m_s: (Option<f64>, Option<f64>),
    /// Standard deviation of the limits, m/s; `None` where one is not known.
    pub deviation_m_s: Option<f64>,
    /// One in twenty lies below this, and one in twenty above the other, m/s.
    pub range90_m_s: (Option<f64>, Option<f64>),
    /// Part of the samples that the scene's own velocity perforates, of those of which that is known; NaN without any.
    pub perforated: f64,
    /// Its 95 % confidence interval (Wilson's).
    pub perforated95: (f64, f64),
}

/// The limits of sampled scenes, with every input of Monte Carlo's own that a limit depends on. `None` when stopped.
pub(super) fn sample(
    scene: &Arc<Scene>,
    sampling: Sampling,
    nominal_m_s: f64,
    criterion: Criterion,
    context: &mut Context<'_>,
) -> Option<SampledLimit> {
    let mut tolerances = usual_tolerances(scene, sampling.deviation);
    tolerances.retain(|tolerance| tolerance.symbol() != "v_i");
    let mut errors = Random::new(!sampling.seed);
    let mut limits: Vec<f64> = Vec::new();
    let (mut undecided, mut known, mut through) = (0, 0_usize, 0_usize);
    let own_m_s = scene.projectile.velocity_m_s;
    let near = Scan {
        low_m_s: nominal_m_s / WITHIN,
        high_m_s: nominal_m_s * WITHIN,
        points: POINTS,
        width: WIDTH,
    };
    let stop = context.stop();
    let limit_of = |sample: &[f64]| {
        let mut own = Scene::clone(scene);
        for (tolerance, value) in tolerances.iter().zip(sample) {
            (tolerance.number().set)(&mut own, Some(*value));
        }
        let watch = &mut |_, _: Option<&()>| stop.flow();
        let context = &mut Context::new(1, watch);
        let mut range = ShotRunner { scene: &Arc::new(own), criterion, context };
        let mut limit = range.limit(near);
        if matches!(limit, Limit::Always | Limit::Never) {
            limit = range.limit(Scan { width: WIDTH, ..Scan::WHOLE });
        }
        (!context.is_stopped() && limit != Limit::Unknown).then_some(limit)
    };
    let mut draw = Draw::new(scene, &tolerances, sampling.seed);
    let drawn = draw.each_batch(sampling.samples, context, |samples, context| {
        let limit_of = |sample: &Vec<f64>| limit_of(sample);
        for limit in context.map_items(samples, limit_of, |context, _| context.goes_on()) {
            let factor = sampling.model.factor(&mut errors);
            let is_through = is_perforated(limit, factor, own_m_s);
            known += usize::from(is_through.is_some());
            through += usize::from(is_through == Some(true));
            match limit {
                Limit::Found { velocity_m_s, .. } => limits.push(factor * velocity_m_s),
                Limit::Always => limits.push(f64::NEG_INFINITY),
                Limit::Never => limits.push(f64::INFINITY),
                Limit::Between { .. } => undecided += 1,
                Limit::Unknown => {}
            }
        }
    });
    if drawn.is_err() || context.is_stopped() {
        return None;
    }
    let perforated = through as f64 / known as f64;
    let of = |is: fn(f64) -> bool| limits.iter().filter(|limit| is(**limit)).count();
    let mut sampled = SampledLimit {
        sampling,
        found: of(f64::is_finite),
        below: of(|limit| limit == f64::NEG_INFINITY),
        above: of(|limit| limit == f64::INFINITY),
        undecided,
        perforated,
        perforated95: wilson(perforated, known as f64),
        ..SampledLimit::default()
    };
    sampled.rank(limits);
    Some(sampled)
}

/// Whether a shot perforates what has this limit times a factor; `None` where that is not known.
fn is_perforated(limit: Limit, factor: f64, shot_m_s: f64) -> Option<bool> {
    match limit {
        Limit::Found { velocity_m_s, .. } => Some(factor * velocity_m_s < shot_m_s),
        Limit::Always => Some(true),
        Limit::Never => Some(false),
        Limit::Between { stopped_m_s, perforated_m_s } => {
            let is_through = perforated_m_s.is_some_and(|it| factor * it <= shot_m_s);
            let is_stopped = stopped_m_s.is_some_and(|it| factor * it >= shot_m_s);
            (is_through || is_stopped).then_some(is_through)
        }
        Limit::Unknown => None,
    }
}

impl SampledLimit {
    /// Takes quantiles and spread from limits, m/s; those beyond the range are infinite.
    fn rank(&mut self, mut limits: Vec<f64>) {
        limits.sort_by(f64::total_cmp);
        if limits.is_empty() {
            return;
        }
        let known = |value: f64| value.is_finite().then_some(value);
        let below = |share: f64| known(quantile(&limits, share.clamp(0.0, 1.0)));
        let half = 0.5 * Z95 / (limits.len() as f64).sqrt();
        self.v50_m_s = below(0.5);
        self.v50_95_m_s = (below(0.5 - half), below(0.5 + half));
        self.range90_m_s = (below(0.05), below(0.95));
        let are_known = limits.iter().all(|limit| limit.is_finite());
        self.deviation_m_s = moments(&limits).map(|it| it.1).filter(|_| are_known);
    }
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

    /// A limit between 100 and 110 m/s, 10 % more by the model's error: a shot at 115 m/s is between 110 and 121.
    #[test]
    fn between_two_shots_a_third_has_no_outcome() {
        let between = Limit::Between { stopped_m_s: Some(100.0), perforated_m_s: Some(110.0) };
        let of = |shot_m_s| is_perforated(between, 1.1, shot_m_s);
        assert_eq!([109.0, 115.0, 122.0].map(of), [Some(false), None, Some(true)]);
        let open = Limit::Between { stopped_m_s: None, perforated_m_s: None };
        assert_eq!([1.0, 1e4].map(|shot_m_s| is_perforated(open, 1.1, shot_m_s)), [None, None]);
    }

    /// Of eight samples one is perforated by everything and three by nothing: the median lies between 30 and 40, half a rank from each,
    /// and the upper quantile is beyond the range.
    #[test]
    fn samples_beyond_the_range_keep_their_rank() {
        let mut sampled = SampledLimit::default();
        let (above, below) = (f64::INFINITY, f64::NEG_INFINITY);
        sampled.rank(vec![above, 20.0, 10.0, above, 30.0, below, 40.0, above]);
        assert_eq!((sampled.v50_m_s, sampled.range90_m_s), (Some(35.0), (None, None)));
        assert_eq!(sampled.deviation_m_s, None);
        sampled.rank(vec![1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(sampled.v50_m_s, Some(3.0));
    }
}
