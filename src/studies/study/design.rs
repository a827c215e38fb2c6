//! Formulas a designer works with that need no simulation: ricochet, Stone's depth, and collisions. Thesis chapters 2, 4 and 5.

use cmra_engine::model::mechanism::Spring;
use cmra_engine::model::scene::{Projectile, Scene};

/// Length of the rod of its mass and radius, as which Tate's formula sees a shot, m.
pub fn rod_length_m(shot: &Projectile) -> f64 {
    let section_m2 = std::f64::consts::PI * shot.tip_radius_m * shot.tip_radius_m;
    shot.mass_kg / (shot.density_kg_m3 * section_m2)
}

/// Tate's critical obliquity, degrees from the plate's normal: beyond it ricochet or break-up is likely. Thesis equation
/// 2.3; made for long rods, whose deceleration it omits: a rough guide.
pub fn critical_obliquity_deg(scene: &Scene) -> f64 {
    let Scene { projectile: shot, target, .. } = scene;
    let (l, d) = (rod_length_m(shot), 2.0 * shot.tip_radius_m);
    let pressure = shot.density_kg_m3 * shot.velocity_m_s * shot.velocity_m_s;
    let ratio = (shot.density_kg_m3 / target.density_kg_m3).sqrt();
    let cube = 2.0 / 3.0 * pressure / shot.strength_pa * (l * l + d * d) / (l * d) * (1.0 + ratio);
    cube.cbrt().atan().to_degrees()
}

/// Stone's depth of a blunt projectile in a thick slab, m; thesis equation 2.4. `target_m2_s2` is `c_t`: for the formula to
/// give a length it must be the square of a speed, although the thesis calls it a property of the material.
pub fn stone_depth_m(
    mass_kg: f64,
    velocity_m_s: f64,
    radius_m: f64,
    target_density_kg_m3: f64,
    target_m2_s2: f64,
) -> f64 {
    let per_area =
        mass_kg * velocity_m_s * velocity_m_s / (2.0 * std::f64::consts::PI * radius_m * radius_m);
    per_area * 2.0 / (target_density_kg_m3 * target_m2_s2)
}

/// Velocities of two bodies after a perfectly elastic collision.
pub fn elastic(m_a: f64, v_a: f64, m_b: f64, v_b: f64) -> [f64; 2] {
    let centre = inelastic(m_a, v_a, m_b, v_b);
    [2.0 * centre - v_a, 2.0 * centre - v_b]
}

/// The common velocity after a perfectly inelastic one; thesis equation 2.2.
pub fn inelastic(m_a: f64, v_a: f64, m_b: f64, v_b: f64) -> f64 {
    (m_a * v_a + m_b * v_b) / (m_a + m_b)
}

/// Maximum number of iterations for the work of the weight.
const WEIGHED_MAX: usize = 1000;

/// Work of the weight up to the greatest displacement of bodies with an energy, their own and that of a spring which alone stops them, J;
/// `None` if it does not stop them.
pub fn work_of_weight_j(
    spring: &Spring,
    start_m: f64,
    energy_j: f64,
    weight_n: f64,
) -> Option<f64> {
    let mut work_j = 0.0;
    // Each round adds the work over what the last one went farther: a sum of ever smaller parts, as the spring force there exceeds the weight.
    for _ in 0..if weight_n > 0.0 { WEIGHED_MAX } else { 0 } {
        let far_m = spring.reach(start_m, energy_j + work_j, 1.0);
        let next_j = weight_n * (far_m - start_m);
        if !next_j.is_finite() {
            return None;
        }
        let is_close = next_j - work_j <= f64::EPSILON * (energy_j + next_j);
        work_j = next_j;
        if is_close {
            break;
        }
    }
    Some(work_j)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cmra_engine::model::variables::changed;

    #[test]
    fn valid_elastic_collisions_keep_momentum_and_energy_and_invert_relative_velocity() {
        for (m_a, v_a, m_b, v_b) in
            [(1.0, 10.0, 1.0, 0.0), (0.03, 100.0, 0.2, -5.0), (4.0, 1.0, 0.5, 3.0)]
        {
            let [w_a, w_b] = elastic(m_a, v_a, m_b, v_b);
            assert!((m_a * (w_a - v_a) + m_b * (w_b - v_b)).abs() < 1e-12);
            let energy = m_a * (w_a * w_a - v_a * v_a) + m_b * (w_b * w_b - v_b * v_b);
            assert!(energy.abs() < 1e-10);
            assert!(((v_a - v_b) - (w_b - w_a)).abs() < 1e-12);
        }
        assert!((inelastic(1.0, 100.0, 1.0, 0.0) - 50.0).abs() < 1e-12);
    }

    #[test]
    fn tate_and_stone_have_the_powers_they_should() {
        let tangent = |pairs| {
            critical_obliquity_deg(&changed(Scene::default(), pairs).unwrap()).to_radians().tan()
        };
        assert!((tangent("v_i=800") / tangent("v_i=100") - 4.0).abs() < 1e-9);
        assert!((tangent("Y_p=1GPa") / tangent("Y_p=8GPa") - 2.0).abs() < 1e-9);
        let depth = |v: f64, r: f64| stone_depth_m(0.03, v, r, 2710.0, 1e6);
        assert!((depth(200.0, 0.01) / depth(100.0, 0.01) - 4.0).abs() < 1e-12);
        assert!((depth(100.0, 0.01) / depth(100.0, 0.02) - 4.0).abs() < 1e-12);
    }
}
