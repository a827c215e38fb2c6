//! Where the numerical promise holds: every result within ten times the tolerance, an honest estimate, an end within a second.
//!
//! From a tenth of the lower to ten times the upper bound of the thesis's Table 9.2, and the ranges of ordinary work for the
//! rest. Every kind of spring and stop, both interface laws. Outside, a run is never silently wrong: its estimate says how good
//! it is, or it ends with a named reason.

use crate::model::scene::Scene;
use crate::model::variables::{self, Kind};

/// The range of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The variable's symbol.
    pub symbol: &'static str,
    /// Least and greatest value, SI.
    pub from_to: (f64, f64),
}

const fn range(symbol: &'static str, from: f64, to: f64) -> Range {
    Range { symbol, from_to: (from, to) }
}

/// The ranges.
pub const RANGES: [Range; 10] = [
    range("b", 0.0, 2e4),
    range("m", 0.2, 5.0),
    range("k", 0.0, 7.5e7),
    range("n", 0.1, 5.0),
    range("gamma", 0.05, 70.0),
    range("d", 0.0, 1.0),
    range("v_i", 1.0, 3e3),
    range("h", 5e-4, 1.0),
    range("theta", 0.0, 80.0),
    range("S_y", 1e6, 1e10),
];

/// The ranges that a scene is outside of, in variables that it uses.
pub fn outside(scene: &Scene) -> Vec<Range> {
    let is_outside = |range: &Range| {
        let Ok(variable) = variables::find(range.symbol) else { return false };
        let Kind::Number(number) = &variable.kind else { return false };
        let (from, to) = range.from_to;
        variables::is_used(variable, scene)
            && (number.get)(scene).is_some_and(|value| !(value >= from && value <= to))
    };
    RANGES.into_iter().filter(is_outside).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_range_is_of_a_number_and_holds_the_baseline() {
        for Range { symbol, from_to } in RANGES {
            let variable = variables::find(symbol).unwrap();
            assert!(matches!(variable.kind, Kind::Number(_)), "{symbol}");
            assert!(from_to.0 < from_to.1, "{symbol}");
        }
        assert!(outside(&Scene::default()).is_empty());
    }

    #[test]
    fn a_value_beyond_its_range_is_named_where_it_is_used() {
        let mut scene = Scene::default();
        scene.mechanism.spring.coefficient = 1e9;
        scene.projectile.velocity_m_s = 0.1;
        scene.projectile.obliquity_deg = 85.0;
        let symbols = |scene: &Scene| -> Vec<&str> {
            outside(scene).iter().map(|range| range.symbol).collect()
        };
        assert_eq!(symbols(&scene), ["k", "v_i", "theta"]);
        scene.plate.mount = crate::model::scene::Mount::Rigid;
        assert_eq!(symbols(&scene), ["v_i", "theta"]);
    }
}
