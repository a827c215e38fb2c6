//! The load of the springs at a displacement: bending stress, yield margin, and whether the law still holds there.

use crate::model::power_law::sign;
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

/// The limits on the side of a plate displacement; none at zero.
fn limits(scene: &Scene, x_m: f64) -> impl Iterator<Item = Limit> {
    let spring = &scene.mechanism.spring;
    let all = if x_m == 0.0 { Vec::new() } else { spring.law().limits(spring, sign(x_m)) };
    all.into_iter().map(move |(limit_m, what)| Limit { what, required_m: x_m, limit_m })
}

/// The limits exceeded at either end of the plate's way, each at the end where it is exceeded most.
pub fn exceeded(scene: &Scene, ends_m: [f64; 2]) -> Vec<Limit> {
    let mut exceeded: Vec<Limit> = Vec::new();
    for limit in ends_m.into_iter().flat_map(|x_m| limits(scene, x_m)) {
        let excess = |it: &Limit| it.required_m.abs() - it.limit_m.abs();
        match exceeded.iter_mut().find(|known| known.what == limit.what) {
            Some(known) if excess(&limit) > excess(known) => *known = limit,
            None if excess(&limit) > 0.0 => exceeded.push(limit),
            _ => {}
        }
    }
    exceeded
}

/// The least of limit over displacement at either end of the plate's way, of every limit; `None` where the spring has no limit.
pub fn travel_margin(scene: &Scene, ends_m: [f64; 2]) -> Option<f64> {
    let limits = ends_m.into_iter().flat_map(|x_m| limits(scene, x_m));
    limits.map(|it| it.limit_m / it.required_m).reduce(smaller)
}
