//! The load of the springs at a displacement: bending stress, yield margin, and whether the law still holds there.

use crate::model::mechanism::kinds::Bounds;
use crate::model::scene::{self, Combination, Scene};
use crate::numerics::{larger, smaller};

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
    displaced(&scene.mechanism, x_m)
        .filter_map(|(spring, x)| spring.law().stress_ratio(spring, x))
        .reduce(larger)
}

/// The limits that a plate displacement exceeds.
pub fn exceeded(scene: &Scene, x_m: f64) -> Vec<Limit> {
    let mut found = Vec::new();
    for (spring, required_m) in displaced(&scene.mechanism, x_m) {
        for Bounds { what, low_m, high_m } in spring.law().bounds(spring) {
            let limit_m = if required_m < low_m { low_m } else { high_m };
            if required_m < low_m || required_m > high_m {
                found.push(Limit { what, required_m, limit_m });
            }
        }
    }
    found
}

/// The least of limit over displacement at either end of the plate's way, of every spring and limit; `None` where no spring has a
/// limit.
pub fn travel_margin(scene: &Scene, from_m: f64, to_m: f64) -> Option<f64> {
    let mut least = None;
    for x_m in [from_m, to_m] {
        for (spring, required_m) in displaced(&scene.mechanism, x_m) {
            for Bounds { low_m, high_m, .. } in spring.law().bounds(spring) {
                let limit_m = if required_m < 0.0 { low_m } else { high_m };
                let margin = limit_m / required_m;
                if required_m != 0.0 {
                    least = Some(least.map_or(margin, |least| smaller(least, margin)));
                }
            }
        }
    }
    least
}

/// The springs that act, each with its displacement at a displacement of the plate, m.
fn displaced(
    mechanism: &scene::Mechanism,
    x_m: f64,
) -> impl Iterator<Item = (&scene::Spring, f64)> {
    let in_series = mechanism.combination == Combination::Series;
    let whole = in_series.then(|| super::Spring::of(mechanism));
    let curve = whole.as_ref().and_then(super::Spring::curve);
    let each = curve.map_or([x_m; 2], |curve| {
        let first = curve.piece(curve.region(x_m)).split(x_m);
        [first, x_m - first]
    });
    mechanism.acting().zip(each)
}
