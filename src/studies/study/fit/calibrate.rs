//! The strength of a scene's plate that gives the measured limit, or measured depths.

use std::sync::Arc;

use crate::model::run::Outcome;
use crate::model::scene::{Closure, Scene, Target};
use crate::model::simulate::{Settings, simulate};
use crate::model::variables::VariableError;
use crate::numerics::statistics::moments;
use crate::study::context::Context;
use crate::study::fit::{Logistic, MeasuredShot};
use crate::study::limit;

/// Maximum number of secant steps, and the relative error of limit or depth at which they end.
const STEPS: usize = 40;
const CLOSE: f64 = 1e-9;
/// Strengths that are looked at, Pa.
const RANGE_PA: (f64, f64) = (1e4, 1e12);

/// A strength found from depths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FromDepths {
    /// Mean, Pa.
    pub mean_pa: f64,
    /// Standard deviation, Pa; `None` for one shot.
    pub deviation_pa: Option<f64>,
    /// Shots it was found from.
    pub shots: usize,
    /// Shots whose depth no strength gives.
    pub left_out: usize,
}

/// The strength that suits the shots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// `S_y`, or `Y` where a closure makes the strength from it.
    pub symbol: &'static str,
    /// The scene's own, Pa.
    pub own_pa: f64,
    /// The scene's own limit, m/s.
    pub own_limit_m_s: Option<f64>,
    /// The strength whose limit is V50, Pa; `None` where no strength has it.
    pub from_limit_pa: Option<f64>,
    /// The strengths at the ends of V50's confidence interval, Pa.
    pub range_pa: (Option<f64>, Option<f64>),
    /// The strength that the depths of stopped shots give.
    pub from_depths: Option<FromDepths>,
}

/// Calibrate a scene's strength to a limit and to the depths of stopped shots.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn calibrate(
    scene: &Scene,
    logistic: &Logistic,
    shots: &[MeasuredShot],
    context: &mut Context<'_>,
) -> Result<Calibration, VariableError> {
    let own_limit_m_s = limit::alone(&Arc::new(scene.clone()), context)?.velocity_m_s();
    let own_pa = *strength_pa(&mut scene.target.clone());
    let mut for_limit = |velocity_m_s: f64| {
        let model = |strength_pa: f64| {
            let own = Arc::new(with_strength(scene, strength_pa));
            limit::alone(&own, context).ok()?.velocity_m_s()
        };
        solve(own_pa, velocity_m_s, 0.5, model)
    };
    let from_limit_pa = for_limit(logistic.v50_m_s);
    let range_pa = (
        logistic.range_m_s.0.and_then(&mut for_limit),
        logistic.range_m_s.1.and_then(&mut for_limit),
    );
    Ok(Calibration {
        symbol: if scene.target.closure == Closure::Given { "S_y" } else { "Y" },
        own_pa,
        own_limit_m_s,
        from_limit_pa,
        range_pa,
        from_depths: from_depths(scene, shots, context),
    })
}

fn from_depths(
    scene: &Scene,
    shots: &[MeasuredShot],
    context: &mut Context<'_>,
) -> Option<FromDepths> {
    let own_pa = *strength_pa(&mut scene.target.clone());
    let stopped = shots.iter().filter(|shot| !shot.perforated);
    let measured: Vec<(f64, f64)> =
        stopped.filter_map(|shot| Some((shot.velocity_m_s, shot.penetration_m?))).collect();
    let found: Vec<f64> = measured
        .iter()
        .filter_map(|(velocity_m_s, depth_m)| {
            let mut own = scene.clone();
            own.projectile.velocity_m_s = *velocity_m_s;
            solve(own_pa, *depth_m, -1.0, |strength_pa| {
                depth_of(&with_strength(&own, strength_pa), context)
            })
        })
        .collect();
    let n = found.len() as f64;
    let mean_pa = found.iter().sum::<f64>() / n;
    (!found.is_empty()).then(|| FromDepths {
        mean_pa,
        deviation_pa: moments(&found).map(|(_, deviation)| deviation),
        shots: found.len(),
        left_out: measured.len() - found.len(),
    })
}

fn depth_of(scene: &Scene, context: &mut Context<'_>) -> Option<f64> {
    let run = simulate(&Arc::new(scene.clone()), &Settings::BARE, &mut context.observer()).ok()?;
    // A shot that goes through has no depth; it counts as one as deep as the plate is thick.
    if run.outcome == Outcome::Perforated {
        return Some(scene.target.thickness_m);
    }
    run.final_penetration_m
}

/// The strength that is calibrated, Pa.
fn strength_pa(target: &mut Target) -> &mut f64 {
    match target.closure {
        Closure::Given => &mut target.flow_strength_pa,
        Closure::DoubleYield | Closure::Cavity | Closure::ByThickness => &mut target.yield_pa,
    }
}

fn with_strength(scene: &Scene, value_pa: f64) -> Scene {
    let mut own = scene.clone();
    *strength_pa(&mut own.target) = value_pa;
    own
}

/// The strength at which the model gives the wanted value, by secants of logarithms; `power` is how the value goes with the strength, roughly.
fn solve(
    start_pa: f64,
    wanted: f64,
    power: f64,
    mut model: impl FnMut(f64) -> Option<f64>,
) -> Option<f64> {
    let mut missed = |log: f64| model(log.exp()).map(|value| (value / wanted).ln());
    let mut at = start_pa.ln();
    let mut error = missed(at)?;
    let mut slope = power;
    for _ in 0..STEPS {
        if error.abs() < CLOSE {
            return Some(at.exp());
        }
        // No further than a factor of e at once: the next secant corrects it.
        let next = (at - error / slope).clamp(at - 1.0, at + 1.0);
        if !(RANGE_PA.0.ln()..=RANGE_PA.1.ln()).contains(&next) {
            return None;
        }
        let next_error = missed(next)?;
        let secant = (next_error - error) / (next - at);
        // A secant of the wrong sign is noise or a kink: the known power serves.
        slope = if secant * power > 0.0 { secant } else { power };
        (at, error) = (next, next_error);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::context::to_its_end;
    use crate::study::fit::Estimator;
    use crate::study::testing::rigid;

    fn logistic(v50_m_s: f64) -> Logistic {
        Logistic {
            v50_m_s,
            scale_m_s: 3.0,
            range_m_s: (Some(0.9 * v50_m_s), None),
            method: Estimator::Firth,
        }
    }

    /// A rigid mount's limit goes with the root of the strength, and is 232.295378 m/s at 1.52e8 Pa.
    #[test]
    fn strength_from_a_limit_of_a_rigid_mount() {
        let found =
            calibrate(&rigid(), &logistic(300.0), &[], &mut Context::new(1, &mut to_its_end))
                .unwrap();
        let exact = 1.52e8 * (300.0f64 / 232.295_378).powi(2);
        assert!((found.from_limit_pa.unwrap() / exact - 1.0).abs() < 1e-7, "{found:?}");
        assert!((found.range_pa.0.unwrap() / exact - 0.81).abs() < 1e-6, "{found:?}");
        assert_eq!((found.symbol, found.range_pa.1, found.from_depths), ("S_y", None, None));
        assert!((found.own_limit_m_s.unwrap() - 232.295_378).abs() < 1e-5);
    }

    /// On a spring, and by a closure: the limit of the strength that is found is the limit wanted; and the depth on a rigid mount is
    /// 7.113055 mm at 1.52e8 Pa and 100 m/s (closed form).
    #[test]
    fn strength_on_a_spring_and_from_depths() {
        let mut scene = Scene::default();
        scene.target.closure = Closure::DoubleYield;
        scene.target.yield_pa = 1e8;
        let found = calibrate(&scene, &logistic(250.0), &[], &mut Context::new(1, &mut to_its_end))
            .unwrap();
        assert_eq!(found.symbol, "Y");
        scene.target.yield_pa = found.from_limit_pa.unwrap();
        let limit = limit::alone(&Arc::new(scene), &mut Context::new(1, &mut to_its_end)).unwrap();
        assert!((limit.velocity_m_s().unwrap() / 250.0 - 1.0).abs() < 1e-8);
        let shot = MeasuredShot {
            velocity_m_s: 100.0,
            perforated: false,
            residual_m_s: None,
            penetration_m: Some(7.113_055e-3),
        };
        let mut soft = rigid();
        soft.target.flow_strength_pa = 1e8;
        let found =
            calibrate(&soft, &logistic(250.0), &[shot], &mut Context::new(1, &mut to_its_end))
                .unwrap();
        let depths = found.from_depths.unwrap();
        assert!((depths.mean_pa / 1.52e8 - 1.0).abs() < 1e-6, "{depths:?}");
        assert_eq!((depths.shots, depths.deviation_pa), (1, None));
    }
}
