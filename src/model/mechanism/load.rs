//! The load of the springs at a displacement: bending stress, yield margin, and whether the law still holds there.

use crate::model::mechanism::inertia::acting;
use crate::model::mechanism::piece::Piece;
use crate::model::scene::{self, Combination, Scene, SpringKind};
use crate::numerics::root::in_bracket;
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
    let shares = shares(&scene.mechanism, x_m);
    let ratios = acting(&scene.mechanism).zip(shares).filter(|(spring, _)| spring.kind.is_beam());
    ratios
        .map(|(spring, x)| spring.beam.stress_pa(spring.kind, x) / spring.beam.yield_pa)
        .reduce(larger)
}

/// The displacement of a spring of beams at which they yield, m; `None` where other limits come first or there are no beams.
pub fn yields_at_m(spring: &scene::Spring) -> Option<f64> {
    let limit = spring.beam.limit_m();
    let excess = |x: f64| spring.beam.stress_pa(spring.kind, x) - spring.beam.yield_pa;
    (spring.kind.is_beam() && excess(limit) > 0.0).then(|| in_bracket(0.0, limit, excess))
}

/// The limits that a plate displacement exceeds.
pub fn exceeded(scene: &Scene, x_m: f64) -> Vec<Limit> {
    let shares = shares(&scene.mechanism, x_m);
    let mut found = Vec::new();
    for (spring, required_m) in acting(&scene.mechanism).zip(shares) {
        for (what, low_m, high_m) in limits(spring) {
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
        let shares = shares(&scene.mechanism, x_m);
        for (spring, required_m) in acting(&scene.mechanism).zip(shares) {
            for (_, low_m, high_m) in limits(spring) {
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

/// Each limit of a spring: what it is, and the displacements between which it is kept, m.
fn limits(spring: &scene::Spring) -> Vec<(&'static str, f64, f64)> {
    let mut limits = Vec::new();
    if spring.kind.is_beam() {
        if let Some(at) = yields_at_m(spring) {
            limits.push(("the beam yields, and the law is elastic", -at, at));
        }
        let end = spring.beam.limit_m();
        limits.push((
            "the pseudo-rigid body follows no beam farther; the force goes on straight",
            -end,
            end,
        ));
    }
    if spring.kind == SpringKind::Crush {
        let what = "the absorber is crushed flat; it is solid from there on";
        limits.push((what, f64::NEG_INFINITY, spring.crush.stroke_m));
    }
    if spring.kind == SpringKind::Table {
        let points = &spring.table.points;
        if let (Some(first), Some(last)) = (points.first(), points.last()) {
            let odd = first[0] == 0.0 && first[1] == 0.0;
            let low = if odd { -last[0] } else { first[0] };
            limits.push(("the table ends; the force goes on straight", low, last[0]));
        }
    }
    limits
}

/// The displacement of each spring at a displacement of the plate, m.
fn shares(mechanism: &scene::Mechanism, x_m: f64) -> [f64; 2] {
    if mechanism.combination != Combination::Series {
        return [x_m; 2];
    }
    let whole = super::Spring::of(mechanism);
    let Some(curve) = whole.curve() else {
        return [x_m; 2];
    };
    let piece: &Piece = curve.piece(curve.region(x_m));
    let first = piece.split(x_m);
    [first, x_m - first]
}
