//! The limit when the inputs scatter: V50, its spread, and the chance that the scene's own shot goes through.

use std::sync::Arc;

use crate::model::scene::{Closure, Scene, SpringKind};
use crate::numerics::random::Random;
use crate::study::limit::Limit;
use crate::study::limit::search::Range;

/// Each sample's limit is looked for within this factor of the nominal one, with so many points, to this relative width.
const WITHIN: f64 = 2.0;
const POINTS: usize = 9;
const WIDTH: f64 = 1e-5;
/// Standard normal quantile of a two-sided 95 % interval.
const Z95: f64 = 1.959_963_984_540_054;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattering {
    /// Relative standard deviation of every scattered input, > 0.
    pub deviation: f64,
    /// Number of samples, >= 2.
    pub samples: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// What was asked for.
    pub scattering: Scattering,
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

/// The limits of scattered scenes: masses, lengths, strength, density, drag, spring and damper coefficients each times a
/// lognormal factor of its own. `None` when stopped, or when too few have a limit.
pub(super) fn scatter(
    scene: &Arc<Scene>,
    scattering: Scattering,
    nominal_m_s: f64,
    range: &mut Range<'_, '_>,
) -> Option<Scatter> {
    let mut random = Random::new(scattering.seed);
    let mut limits = Vec::new();
    let (mut without, mut through) = (0, 0usize);
    let own_m_s = scene.projectile.velocity_m_s;
    let range_criterion = range.criterion;
    for _ in 0..scattering.samples {
        if !range.goes_on() {
            return None;
        }
        let sample = Arc::new(scattered(scene, scattering.deviation, &mut random));
        // Shots within a sample are not counted: a sample is one piece of work. It can be stopped all the same.
        let (done, total) = (range.done.min(range.total), range.total);
        let mut watch = |_: usize, _: usize| (range.watch)(done, total);
        let mut own = Range::new(&sample, 1, &mut watch);
        own.criterion = range_criterion;
        let around = (nominal_m_s / WITHIN, nominal_m_s * WITHIN);
        match own.limit(around, POINTS, WIDTH) {
            Limit::Found { velocity_m_s, .. } => {
                through += usize::from(velocity_m_s < own_m_s);
                limits.push(velocity_m_s);
            }
            // Beyond the bracket on a known side.
            Limit::Always => {
                without += 1;
                through += usize::from(own_m_s > around.0);
            }
            Limit::Unknown => return None,
            Limit::Between { .. } | Limit::Never => without += 1,
        }
    }
    limits.sort_by(f64::total_cmp);
    if limits.len() < 2 {
        return None;
    }
    let count = limits.len() as f64;
    let mean = limits.iter().sum::<f64>() / count;
    let variance = limits.iter().map(|limit| (limit - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let samples = scattering.samples as f64;
    let perforated = through as f64 / samples;
    Some(Scatter {
        scattering,
        found: limits.len(),
        without,
        v50_m_s: quantile(&limits, 0.5),
        deviation_m_s: variance.sqrt(),
        range90_m_s: (quantile(&limits, 0.05), quantile(&limits, 0.95)),
        perforated,
        perforated95: wilson(perforated, samples),
    })
}

fn scattered(scene: &Scene, deviation: f64, random: &mut Random) -> Scene {
    let mut own = scene.clone();
    let target = &mut own.target;
    let hardness = match target.closure {
        Closure::Given => &mut target.flow_strength_pa,
        Closure::DoubleYield | Closure::Cavity => &mut target.yield_pa,
    };
    let mechanism = &mut own.mechanism;
    // Laws without a coefficient scatter in how many springs there are: in force.
    let strength = match mechanism.spring.kind {
        SpringKind::PowerLaw => &mut mechanism.spring.coefficient,
        SpringKind::Normalised
        | SpringKind::Cantilever
        | SpringKind::FixedGuided
        | SpringKind::Bistable
        | SpringKind::ConstantForce
        | SpringKind::Column
        | SpringKind::Helix
        | SpringKind::Table => &mut mechanism.spring.count,
    };
    // The order is part of what a seed means.
    for value in [
        &mut own.projectile.mass_kg,
        &mut own.projectile.tip_radius_m,
        &mut target.thickness_m,
        &mut target.density_kg_m3,
        hardness,
        &mut target.drag_coefficient,
        &mut own.plate.mass_ratio,
        &mut own.plate.cocking_m,
        &mut mechanism.damper.coefficient,
        strength,
    ] {
        *value *= (deviation * random.normal()).exp();
    }
    // A stop stays in front of the plate it stops.
    if let Some(position_m) = own.mechanism.stop.position_m.as_mut() {
        let start_m = -own.plate.cocking_m;
        *position_m = if *position_m > start_m { *position_m } else { start_m };
    }
    own
}

/// Quantile of sorted values, interpolated.
pub(in crate::study) fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let (mut below, mut beyond) = (0, sorted.len());
    while beyond - below > 1 {
        let middle = below + (beyond - below) / 2;
        if middle as f64 <= place { below = middle } else { beyond = middle }
    }
    let above = if below + 1 < sorted.len() { below + 1 } else { below };
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// Wilson's interval of a proportion (*Journal of the American Statistical Association* 22 (1927) 209-212).
pub(in crate::study) fn wilson(p: f64, n: f64) -> (f64, f64) {
    let z2 = Z95 * Z95;
    let centre = (p + 0.5 * z2 / n) / (1.0 + z2 / n);
    let half = Z95 / (1.0 + z2 / n) * (p * (1.0 - p) / n + 0.25 * z2 / (n * n)).sqrt();
    (centre - half, centre + half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_interval_of_wilson() {
        // E. B. Wilson's formula for 10 of 100, as tabulated by R. G. Newcombe, *Statistics in Medicine* 17 (1998), by hand.
        let (low, high) = wilson(0.1, 100.0);
        assert!((low - 0.0552).abs() < 1e-4 && (high - 0.1744).abs() < 1e-4, "{low} {high}");
        let (low, _) = wilson(0.0, 50.0);
        assert!(low.abs() < 1e-15);
    }

    #[test]
    fn quantiles_lie_between_the_values() {
        let sorted = [1.0, 2.0, 4.0];
        for (share, value) in [(0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.75, 3.0), (1.0, 4.0)] {
            assert!((quantile(&sorted, share) - value).abs() < 1e-15);
        }
    }
}
