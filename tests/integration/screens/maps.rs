//! Zoom of curves in Explore, and what the Limit tab says of a change of closure.

use std::sync::Arc;

use super::bench::Bench;
use super::{search, sweep};
use cmra::model::scene::Closure;
use cmra::tui::theme::GlyphSet;

/// A hard core on AA6082, as in `cmra compare`: of 271 to 285 m/s only the change of closure at h = D decides.
#[test]
fn the_change_of_closure_is_named_in_the_comparison() {
    let opened = || {
        let mut bench = Bench::ascii(120, 40);
        let mut scene = (*bench.app.scene).clone();
        scene.projectile.mass_kg = 5.3e-3;
        scene.projectile.tip_radius_m = 3.124e-3;
        scene.projectile.velocity_m_s = 278.0;
        scene.target.closure = Closure::ByThickness;
        scene.target.thickness_m = 0.012;
        scene.plate.mass_ratio = 41.63;
        scene.mechanism.spring.coefficient = 1.0;
        scene.mechanism.energy_j_kg = Some(18_200.0);
        (scene.target.yield_pa, scene.target.modulus_pa) = (260e6, 70e9);
        bench.app.scene = Arc::new(scene);
        bench.keys("3");
        search::answer(&mut bench);
        bench
    };
    let screen = opened().screen();
    assert!(screen.contains("just as thick as the projectile (h = D)"), "{screen}");
}

/// As in Run, the axis of values is that of what is in view.
#[test]
fn curves_that_are_zoomed_have_the_values_in_view() {
    let labels = |bench: &Bench| {
        let screen = bench.screen();
        let of = |line: &str| Some(line.split_once("||")?.1.split_once('+')?.0.trim().parse().ok());
        let labels: Vec<f64> = screen.lines().filter_map(of).flatten().collect();
        labels.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b))
            - labels.iter().fold(f64::INFINITY, |a, b| a.min(*b))
    };
    let mut bench = sweep::open("figure-9.4", 21, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    let whole = labels(&bench);
    bench.keys("++");
    assert!(labels(&bench) < 0.5 * whole, "{whole}: {}", bench.screen());
}
