//! Law of a run's mechanism over the plate displacement: force, stiffness, stress, and the range used by the run.

use std::sync::Arc;

use crate::report::chart::Mark;
use cmra_engine::model::mechanism::{Mechanism, load};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::numerics::{larger, smaller};

/// Ratio of the drawn range to the maximum displacement, or to the yield point if that is farther and shown.
const BEYOND: f64 = 1.15;
/// Multiple of the maximum displacement within which a yield point is shown.
const YIELD_SHOWN: f64 = 2.5;
/// Number of points of a drawn law.
const POINTS: u32 = 400;

/// Springs and elastic stop of a run.
pub struct Law {
    scene: Arc<Scene>,
    mechanism: Mechanism,
    start_m: f64,
    reached_m: f64,
    yield_m: Option<f64>,
}

impl Law {
    /// Creates the law of a run whose plate moved; `None` without spring and elastic stop.
    pub fn from_run(run: &Run) -> Option<Self> {
        let scene = Arc::clone(&run.scene);
        let mechanism = Mechanism::from_scene(&scene);
        let start_m = run.scene.start_m();
        let reached = run.max_plate_displacement_m.or(run.at_least.plate_displacement_m);
        let reached_m = reached.filter(|it| *it > start_m)?;
        if mechanism.spring.is_absent() && mechanism.elastic_stop().is_none() {
            return None;
        }
        let yields = scene.mechanism.spring.yields_at_m();
        let yield_m = yields.filter(|at| *at < YIELD_SHOWN * reached_m);
        Some(Self { scene, mechanism, start_m, reached_m, yield_m })
    }

    /// Returns the stiffness and compression of the elastic stop; `None` without contact.
    fn stop(&self, x_m: f64) -> Option<(f64, f64)> {
        let stop = self.mechanism.elastic_stop()?;
        let pressed_m = x_m - stop.position_m?;
        (pressed_m > 0.0).then_some((stop.stiffness_n_m, pressed_m))
    }

    /// Returns the force of springs and elastic stop on the mount, N.
    pub fn force(&self, x_m: f64) -> f64 {
        let stopped = self.stop(x_m).map_or(0.0, |(stiffness, depth_m)| stiffness * depth_m);
        self.mechanism.spring.force(x_m) + stopped
    }

    /// Returns the stiffness, N/m.
    pub fn stiffness(&self, x_m: f64) -> f64 {
        self.mechanism.spring.tangent(x_m) + self.stop(x_m).map_or(0.0, |(stiffness, _)| stiffness)
    }

    /// Returns the maximum stress over the yield strength; NaN if no spring has a strength.
    pub fn stress(&self, x_m: f64) -> f64 {
        load::stress_ratio(&self.scene, x_m).unwrap_or(f64::NAN)
    }

    /// Returns the drawn displacement range, m: from the cocked or neutral position to beyond the maximum of the run.
    pub fn range_m(&self) -> (f64, f64) {
        let end_m = self.yield_m.map_or(self.reached_m, |at| larger(at, self.reached_m));
        let low_m = smaller(self.start_m, 0.0);
        (low_m, low_m + BEYOND * (end_m - low_m))
    }

    /// Samples a value of the law over its range.
    pub fn points(&self, get: fn(&Self, f64) -> f64) -> Vec<(f64, f64)> {
        let (low_m, end_m) = self.range_m();
        let at = |point: u32| low_m + (end_m - low_m) * f64::from(point) / f64::from(POINTS);
        (0..=POINTS).map(at).map(|x_m| (x_m, get(self, x_m))).collect()
    }

    /// Returns the marks for the range used by the run, and for the limits.
    pub fn marks(&self) -> Vec<Mark<'static>> {
        let mut marks = vec![Mark::new(self.reached_m, "greatest displacement").tag("max")];
        marks.extend((self.start_m < 0.0).then(|| Mark::new(self.start_m, "cocked")));
        let stop_at_m = self.mechanism.stop.and_then(|stop| stop.position_m);
        marks.extend(stop_at_m.map(|at_m| Mark::new(at_m, "stop")));
        marks.extend(self.yield_m.map(|at| Mark::new(at, "yield")));
        marks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::plain_run;
    use crate::study::testing::scene;

    /// A spring of 1e5 N/m: 1 kN at 10 mm. An elastic stop of 1e6 N/m from 20 mm on adds 5 kN at 25 mm.
    #[test]
    fn the_law_is_that_of_spring_and_elastic_stop() {
        let run = plain_run(&scene("k=1e5 x_stop=0.02 stop_kind=elastic k_stop=1e6")).unwrap();
        let law = Law::from_run(&run).unwrap();
        for (x_m, force_n, stiffness_n_m) in [(0.01, 1e3, 1e5), (0.025, 2.5e3 + 5e3, 1.1e6)] {
            assert!((law.force(x_m) - force_n).abs() < 1e-9 * force_n, "{}", law.force(x_m));
            assert!((law.stiffness(x_m) - stiffness_n_m).abs() < 1e-9 * stiffness_n_m);
        }
        assert!(law.stress(0.01).is_nan(), "a power law has no strength");
        let names: Vec<String> = law.marks().iter().map(|mark| mark.name.to_string()).collect();
        assert_eq!(names, ["greatest displacement", "stop"]);
    }
}
