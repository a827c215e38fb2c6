//! What the Limit tab says of a change of closure.

use std::sync::Arc;

use super::bench::Bench;
use super::search;
use cmra::model::scene::Closure;

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
