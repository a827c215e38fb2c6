//! The designs chapter 9 of the thesis recommends, in numbers. Where it says "low" or "as much as is reasonable" the end of Table
//! 9.2 or the value of its own figures stands, and the note says which.

use crate::model::scene::Scene;
use crate::model::variables;
use crate::study::with_numbers;

/// A recommended design.
#[derive(Clone, Copy, Debug)]
pub struct Recommended {
    /// A short name.
    pub name: &'static str,
    /// The section, and how its words became numbers.
    pub source: &'static str,
    /// Variables by symbol and their values, in the stored unit; all others are those of the scene.
    pub values: &'static [(&'static str, f64)],
}

/// A scene with the values of a recommended design; `None` where that makes no sense.
pub fn scene_of(recommended: &Recommended, scene: &Scene) -> Option<Scene> {
    let own = with_numbers(scene.clone(), recommended.values).ok()?;
    variables::validate(&own).is_ok().then_some(own)
}

/// All of them.
pub static RECOMMENDED: [Recommended; 5] = [
    Recommended {
        name: "uncocked",
        source: "9.5.1: light, soft, no damper, not cocked, so n = 1.5; k of Figure 9.6's caption",
        values: &[("gamma", 0.8), ("d", 0.0), ("b", 0.0), ("k", 1e5), ("n", 1.5)],
    },
    Recommended {
        name: "limited cocking",
        source: "9.3.2: a positive but limited cocking distance, here a tenth of Table 9.2's; k and n of Figure 9.3",
        values: &[("gamma", 0.8), ("d", 0.05), ("b", 0.0), ("k", 1e5), ("n", 1.0)],
    },
    Recommended {
        name: "cocked, all the way",
        source: "9.6: light, cocked, a minimal exponent, no damper, each at its end of Table 9.2; k of Figure 9.12",
        values: &[("gamma", 0.8), ("d", 0.5), ("b", 0.0), ("k", 1e5), ("n", 0.1)],
    },
    Recommended {
        name: "cocked cantilever",
        source: "9.5.2: the beam of Table 9.3 cocked to its yield, 0.111 MN/m at 0.03 m",
        values: &[("gamma", 1.0), ("d", 0.03), ("b", 0.0), ("k", 1.11e5), ("n", 1.0)],
    },
    Recommended {
        name: "stopped",
        source: "9.5.1, 9.6: soft, with a stop after common speed, here at 10 mm",
        values: &[("gamma", 0.8), ("d", 0.0), ("b", 0.0), ("k", 1e5), ("n", 1.5), ("x_stop", 0.01)],
    },
];
