//! The load of the springs at a displacement: bending stress, yield margin, and whether the law still holds there.

use crate::model::mechanism::kinds::Bounds;
use crate::model::scene::Scene;
use crate::numerics::smaller;

/// Up to where a spring's law is good, and what happens beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The limit, in words.
    pub what: &'static str,
    /// The displacement at which this is the load, m.
    pub required_m: f64,
    /// The limit, m.
    pub limit_m: f64,
}

/// The greatest bending stress of the beams at a plate displacement, over their yield strength; `None` without beams.
pub fn stress_ratio(scene: &Scene, x_m: f64) -> Option<f64> {
    let spring = &scene.mechanism.spring;
    spring.law().stress_ratio(spring, x_m)
}

/// The limits that a plate displacement exceeds.
pub fn exceeded(scene: &Scene, x_m: f64) -> Vec<Limit> {
    let spring = &scene.mechanism.spring;
    let limit = |Bounds { what, low_m, high_m }| {
        let limit_m = if x_m < low_m { low_m } else { high_m };
        (x_m < low_m || x_m > high_m).then_some(Limit { what, required_m: x_m, limit_m })
    };
    spring.law().bounds(spring).into_iter().filter_map(limit).collect()
}

/// The least of limit over displacement at either end of the plate's way, of every limit; `None` where the spring has no limit.
pub fn travel_margin(scene: &Scene, from_m: f64, to_m: f64) -> Option<f64> {
    let spring = &scene.mechanism.spring;
    let ends = [from_m, to_m].into_iter().filter(|x_m| *x_m != 0.0);
    let margins = ends.flat_map(|x_m| {
        let limit = move |it: Bounds| if x_m < 0.0 { it.low_m } else { it.high_m };
        spring.law().bounds(spring).into_iter().map(move |it| limit(it) / x_m)
    });
    margins.reduce(smaller)
}
