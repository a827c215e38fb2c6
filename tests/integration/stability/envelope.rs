//! Where the numerical promise holds: every result within ten times the tolerance, an honest estimate, an end within a second.
//!
//! From a tenth of the lower to ten times the upper bound of the thesis's Table 9.2, and the ranges of ordinary work for the
//! rest. Every kind of spring and stop, both interface laws. Outside, a run is never silently wrong: its estimate says how good
//! it is, or it ends with a named reason.

use cmra_engine::model::scene::{Mount, Scene};
use cmra_engine::model::variables;

/// Symbols, and the least and the greatest value of each, SI.
const RANGES: [(&str, f64, f64); 10] = [
    ("b", 0.0, 2e4),
    ("m", 0.2, 5.0),
    ("k", 0.0, 7.5e7),
    ("n", 0.1, 5.0),
    ("gamma", 0.05, 70.0),
    ("d", 0.0, 1.0),
    ("v_i", 1.0, 3e3),
    ("h", 5e-4, 1.0),
    ("theta", 0.0, 80.0),
    ("S_y", 1e6, 1e10),
];

/// The symbols of the ranges that a scene is outside of, in variables that it uses.
pub(super) fn outside(scene: &Scene) -> Vec<&'static str> {
    let is_outside = |(symbol, from, to): &(&str, f64, f64)| {
        let variable = variables::find(symbol).unwrap();
        let number = variable.number().unwrap();
        let value = (number.get)(scene);
        variables::is_used(variable, scene)
            && value.is_some_and(|value| !(*from..=*to).contains(&value))
    };
    RANGES.iter().filter(|range| is_outside(range)).map(|(symbol, ..)| *symbol).collect()
}

#[test]
fn every_range_is_of_a_number_and_holds_the_baseline() {
    for (symbol, from, to) in RANGES {
        assert!(variables::find(symbol).unwrap().number().is_some(), "{symbol}");
        assert!(from < to, "{symbol}");
    }
    assert!(outside(&Scene::default()).is_empty());
}

#[test]
fn a_value_beyond_its_range_is_named_where_it_is_used() {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 1e9;
    scene.projectile.velocity_m_s = 0.1;
    scene.projectile.obliquity_deg = 85.0;
    assert_eq!(outside(&scene), ["k", "v_i", "theta"]);
    scene.plate.mount = Mount::Rigid;
    assert_eq!(outside(&scene), ["v_i", "theta"]);
}
