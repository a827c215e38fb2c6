//! The battery: named stiff and extreme scenes, and what makes each one hard.

use std::sync::Arc;

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, VariableError};

/// A named scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// A short name.
    pub name: &'static str,
    /// What makes it hard.
    pub why: &'static str,
    /// Changes to Table 9.1 with gamma = 1 and neither spring nor damper, as `--set` takes them.
    pub changes: &'static str,
}

impl Case {
    /// The scene.
    ///
    /// # Errors
    /// A [`VariableError`] when a change is not understood, which a test rules out.
    pub fn scene(&self) -> Result<Arc<Scene>, VariableError> {
        let mut scene = Scene::default();
        scene.mechanism.spring.coefficient = 0.0;
        for change in self.changes.split_whitespace() {
            let (name, value) = change.split_once('=').unwrap_or((change, ""));
            variables::set_by_name(&mut scene, name, value, Bare::Si)?;
        }
        Ok(Arc::new(scene))
    }
}

const fn case(name: &'static str, changes: &'static str, why: &'static str) -> Case {
    Case { name, why, changes }
}

/// All of them; every fifth is in the quick battery.
pub const CASES: &[Case] = &[
    case("n 0.1, k 1e6", "k=1e6 n=0.1", "spring holds the plate within 7e-18 m"),
    case("n 0.3, k 1e5", "k=1e5 n=0.3", "infinite stiffness at the start"),
    case("n 0.5, k 1e6", "k=1e6 n=0.5", "turns back within the contact"),
    case("n 0.05, k 1e4", "k=1e4 n=0.05", "nearly a constant force, flips at x = 0"),
    case("n 0.05, k 3e4", "k=3e4 n=0.05", "force law a step; rides its slow manifold"),
    case("n 0.2, k 1e5", "k=1e5 n=0.2", "the edge of Figure 9.6"),
    case("n 0.3, k 1e6", "k=1e6 n=0.3", "slow manifold x = (F/k)^(1/n)"),
    case("n 6, k 1e12", "k=1e12 n=6", "force nothing, then a wall"),
    case("n 6, d 1 m", "k=1e6 n=6 d=1", "cocked against a sixth power"),
    case("k 1e9", "k=1e9", "34 oscillations of the plate"),
    case("k 1e12", "k=1e12", "1000 oscillations in the contact"),
    case("k 1e12, gamma 1e-4", "k=1e12 gamma=1e-4", "100 000 oscillations in the contact"),
    case("k 1e12, n 3", "k=1e12 n=3", "stiffness grows with travel"),
    case("k 1e-6", "k=1e-6", "a spring weaker than rounding"),
    case("b 2000, k 1e5", "b=2000 k=1e5", "damper and spring of equal weight"),
    case("b 1e5", "b=1e5", "decay 600 times faster than the contact"),
    case("b 1e8", "b=1e8", "decay 600 000 times faster than the contact"),
    case("b 1e8, gamma 1e-4", "b=1e8 gamma=1e-4", "decay in 3e-14 s"),
    case("b 1e4, m 0.2", "b=1e4 m=0.2", "infinite damping slope at w = 0"),
    case("b 1e5, m 0.2", "b=1e5 m=0.2", "damper stronger than the contact force"),
    case("b 100, m 0.5", "b=100 m=0.5", "stops in finite time"),
    case("b 1e8, m 3", "b=1e8 m=3", "cubic damper: stiff fast, limp slow"),
    case("b 1e3, k 1e6, n 0.5", "b=1e3 k=1e6 n=0.5", "singular spring with a damper"),
    case("b, m 0.5, k, n 0.5", "b=1e3 m=0.5 k=1e6 n=0.5", "both laws singular at the start"),
    case("gamma 1e-4", "gamma=1e-4", "a plate lighter than a hair"),
    case("gamma 1e-4, k 1e5", "gamma=1e-4 k=1e5", "light plate on the thesis's spring"),
    case("gamma 1e6, k 1e5", "gamma=1e6 k=1e5", "a plate of 30 t"),
    case("gamma 1e6, n 0.3", "gamma=1e6 k=1e6 n=0.3", "heavy plate, singular start"),
    case("v 1 mm/s", "v_i=1e-3", "depth of micrometres"),
    case("v 1 mm/s, k 1e9", "v_i=1e-3 k=1e9", "barely touches, stiff mount"),
    case("v 1 mm/s, n 0.3", "v_i=1e-3 k=1e5 n=0.3", "contact force below the spring's step"),
    case("v 3000", "v_i=3000", "drag a hundred times the strength"),
    case("v 3000, k 1e9", "v_i=3000 k=1e9", "fast and stiff"),
    case("v 3000, h 5 m, b 1e5", "v_i=3000 h=5 b=1e5", "deep, fast, over-damped"),
    case("d 0.5, k 1e5", "d=0.5 k=1e5", "thrown forward at the projectile"),
    case("d 1, k 1e9", "d=1 k=1e9", "contact over in microseconds, travel in milliseconds"),
    case("d 1, k 1e9, gamma 1e-4", "d=1 k=1e9 gamma=1e-4", "accelerates at 3e14 m/s2"),
    case("d 0.5, k 1e5, plastic", "d=0.5 k=1e5 interface=plastic", "resumes, then perforates"),
    case("foil 3 mm, 400 m/s", "h=0.003 v_i=400 k=1e5", "rear face before the nose is buried"),
    case("foil 10 um", "h=1e-5 k=1e5", "area pieces a thousandth of R"),
    case("foil 10 um, 1 m/s", "h=1e-5 v_i=1 k=1e5", "close to the ballistic limit of a foil"),
    case("plate 5 m, 3000 m/s", "h=5 v_i=3000 k=1e5", "exit face far away"),
    case("theta 85", "theta=85deg k=1e5", "glancing: sections of a grazing sphere"),
    case("theta 85, k 1e9", "theta=85deg k=1e9", "glancing on a stiff mount"),
    case("theta 85, foil", "theta=85deg h=1e-4 k=1e5", "all pieces of the area overlap"),
    case("zero strength", "S_y=0 k=1e5", "drag alone: never quite stops"),
    case("zero drag", "C_d=0 k=1e5", "strength alone"),
    case("no force at all", "S_y=0 C_d=0 k=1e5", "passes through untouched"),
    case("stop, zero gap", "k=1e5 x_stop=0", "held from the first moment"),
    case("stop, zero gap, e 1", "k=1e5 x_stop=0 e=1", "must not rattle for ever"),
    case("stop at 1 mm", "k=1e5 x_stop=0.001", "hit within the contact"),
    case(
        "stop at 1 mm, plastic",
        "k=1e5 x_stop=0.001 interface=plastic",
        "hole deepens at the stop",
    ),
    case(
        "elastic stop 1e12",
        "k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e12",
        "a wall that oscillates at its natural frequency",
    ),
    case(
        "damped elastic stop",
        "k=1e4 x_stop=0.000169 stop_kind=elastic k_stop=1.28e8 b_stop=342 v_i=300 h=0.05",
        "lets go, presses again at once",
    ),
    case("gamma 0.8, plastic", "gamma=0.8 k=7.5e6 interface=plastic", "pulls out on the rebound"),
    case("k 1e9, plastic", "k=1e9 interface=plastic", "interface yields at every oscillation"),
    case(
        "plastic, n 0.22, g 0",
        "n=0.224606 k=3.69828e6 d=4.23982e-5 gamma=1.60596 v_i=5.85981 h=0.00155542 S_y=2.96422e7 C_d=0.401782 interface=plastic g=0",
        "yields at every passage of a singular zero",
    ),
    case(
        "held, then perforated",
        "n=3 k=23231.6 gamma=2.86964 v_i=994.013 h=0.00629821 S_y=4.55128e7 C_d=0.458388 dishing=false x_stop=3.69573e-4",
        "stop takes the plate within the contact",
    ),
    case(
        "b 20, m 0.29, no drag",
        "m=0.290733 b=19.6376 gamma=2.51221 v_i=288.844 h=0.0173945 theta=23.5572deg S_y=3.75715e6 C_d=0 dishing=false",
        "a start whose smallness misleads",
    ),
    case(
        "b 39, m 0.36, foil",
        "m=0.358358 b=38.5484 gamma=0.0909033 v_i=150.388 h=1.83202e-4 theta=28.2262deg S_y=9.95406e8 C_d=1.4367 interface=plastic",
        "light foil on a singular damper",
    ),
    case(
        "n 0.19, m 0.22, light",
        "n=0.188339 m=0.216286 k=835039 b=1.3593 gamma=0.0412862 v_i=718.078 h=0.00573461 S_y=8.02754e8 C_d=0.0235985",
        "both laws singular, fast plate",
    ),
    case(
        "elastic stop, n 0.4",
        "n=0.398867 k=1.4128e6 d=4.77061e-5 gamma=0.286063 v_i=109.674 h=0.0851212 S_y=6.74302e7 interface=plastic g=0 x_stop=-4.77061e-5 stop_kind=elastic k_stop=2.86321e9",
        "rattles on a stop without gap",
    ),
    case(
        "all at once",
        "n=0.3 k=1e7 b=1e4 m=0.5 gamma=0.01 theta=60deg h=0.004 v_i=300 interface=plastic",
        "singular, light, oblique, thin, plastic",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_a_valid_scene_with_a_name_of_its_own() {
        assert!(CASES.len() >= 50);
        for (index, case) in CASES.iter().enumerate() {
            let scene = case.scene().unwrap_or_else(|error| panic!("{}: {error}", case.name));
            variables::validate(&scene).unwrap_or_else(|error| panic!("{}: {error}", case.name));
            assert!(CASES[..index].iter().all(|other| other.name != case.name), "{}", case.name);
            assert!(case.name.chars().count() <= 23, "{}", case.name);
        }
    }
}
