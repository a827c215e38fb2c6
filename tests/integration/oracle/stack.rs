//! Stacks, plate by plate, each struck with the velocity that the one before it has left.

use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::Scene;
use cmra_oracle::Shot;

use super::{OFF, STEP_S, draw, program};

/// How long each plate is looked at, s.
const LOOK_S: f64 = 1e-3;
/// A projectile that has less of its residual velocity than this part is amplified too much to compare.
const SLOW: f64 = 0.05;

/// Oracle's result for one plate: the residual velocity, if any, and the depth.
struct Plate {
    left: Option<f64>,
    depth_m: f64,
}

impl Plate {
    fn new(scene: &Scene, step_s: f64) -> Option<Self> {
        let mut shot = Shot::new(scene, step_s);
        let arrived = shot.go_to(LOOK_S);
        let left = shot.exit.map(|exit| shot.velocity_m_s(exit.1));
        arrived.then(|| Self { left, depth_m: shot.depth_m(shot.deepest_m) })
    }
}

fn near(value: f64, exact: f64, off: f64) -> bool {
    (value - exact).abs() <= 1e-6 * exact.abs() + OFF * off + 1e-9
}

/// In what the program differs from the steps.
pub(crate) fn compare(words: &str) -> Vec<String> {
    let own = draw::read(words);
    let run = program(&own);
    let stack = run.stack.clone().unwrap();
    let struck: Vec<&Run> =
        std::iter::once(&run).chain(stack.behind.iter().map(|run| &**run)).collect();
    let (mut velocity, mut passed_m, mut passed) = (own.projectile.velocity_m_s, 0.0, 0);
    let mut found = Vec::new();
    for mut plate in draw::plates(&own) {
        let Some(run) = struck.get(passed) else {
            return vec![format!("plate {passed} is not struck")];
        };
        plate.projectile.velocity_m_s = velocity;
        let [coarse, fine] = [STEP_S, 0.5 * STEP_S].map(|step_s| Plate::new(&plate, step_s));
        let (Some(coarse), Some(fine)) = (coarse, fine) else { return found };
        let late = run.departure.exit_time_s.is_some_and(|t_s| t_s > 0.99 * LOOK_S);
        let slow = fine.left.is_some_and(|left| left < SLOW * velocity);
        if late || slow {
            return found;
        }
        let (Some(left), Some(told)) = (fine.left, run.departure.residual_velocity_m_s) else {
            if fine.left.is_some() || run.departure.exit_time_s.is_some() {
                found.push(format!(
                    "plate {passed} leaves {:?}",
                    run.departure.residual_velocity_m_s
                ));
            }
            // A run that is still moving has no outcome to compare.
            if let Some(depth_m) = run.penetration.final_m {
                let off_m = (coarse.depth_m - fine.depth_m).abs();
                let deep = depth_m > fine.depth_m || near(depth_m, fine.depth_m, off_m);
                let sums =
                    stack.penetration_m.is_some_and(|sum| near(sum, passed_m + depth_m, 0.0));
                let is_last = stack.outcome != Outcome::Perforated && struck.len() == passed + 1;
                if !(deep && sums && is_last) {
                    found.push(format!("{depth_m} deep in plate {passed}, not {}", fine.depth_m));
                }
            }
            return found;
        };
        if !near(told, left, coarse.left.map_or(f64::INFINITY, |coarse| coarse - left).abs()) {
            found.push(format!("plate {passed} leaves {told}, not {left}"));
        }
        velocity = told;
        passed_m += plate.target.thickness_m / plate.cos_obliquity();
        passed += 1;
    }
    let is_through = stack.outcome == Outcome::Perforated && struck.len() == passed;
    if !is_through || stack.residual_velocity_m_s != Some(velocity) {
        found.push(format!("{:?} left, not {velocity}", stack.residual_velocity_m_s));
    }
    found
}
