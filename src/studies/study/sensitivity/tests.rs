//! The study on scenes whose answer is known.

use super::*;
use crate::study::testing::scene;

/// What Monte Carlo scatters varies too: of a plate by its face and a closure by cavity the shot, the plate and its material; of the
/// baseline the shot and the plate besides the ranges of Table 9.2. E close to Y has no range: it must be greater than any Y.
#[test]
fn the_usual_variables_are_those_that_the_scene_uses() {
    let usual = |pairs: &str| -> Vec<(&str, (f64, f64))> {
        let axes = usual_axes(&scene(pairs)).unwrap();
        axes.iter().map(|axis| (axis.symbol(), axis.ends())).collect()
    };
    let symbols = |pairs: &str| -> Vec<&str> { usual(pairs).iter().map(|it| it.0).collect() };
    let shot = ["v_i", "m_p", "R", "h", "rho"];
    let baseline = [&["gamma", "d", "b", "k", "n"][..], &shot, &["S_y", "C_d"]].concat();
    assert_eq!(symbols(""), baseline);
    assert_eq!(usual("")[5], ("v_i", (96.0, 104.0)));
    assert_eq!(usual("")[0], ("gamma", (0.8, 7.0)));
    let cavity = "closure=cavity dishing=off face=0.3";
    let plate = [&["d", "b", "k", "n"][..], &shot, &["Y", "E", "C_d"]].concat();
    assert_eq!(symbols(cavity), plate);
    assert_eq!(symbols("mount=rigid"), [&shot[..], &["S_y", "C_d"]].concat());
    let soft = symbols("closure=cavity dishing=off mount=rigid Y=69e9");
    assert!(soft.contains(&"Y") && !soft.contains(&"E"), "{soft:?}");
}
