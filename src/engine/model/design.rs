//! Formulas a designer works with that need no simulation: ricochet, Stone's depth, and collisions. Thesis chapters 2, 4 and 5.

use crate::model::scene::Scene;

/// A projectile as Tate's formula sees it: a long rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod {
    /// `rho_p`, kg/m³, > 0.
    pub density_kg_m3: f64,
    /// `Y_p`, Pa, > 0.
    pub strength_pa: f64,
    /// `v_p`, m/s, > 0.
    pub velocity_m_s: f64,
    /// l, m, > 0.
    pub length_m: f64,
    /// d, m, > 0.
    pub diameter_m: f64,
}

impl Rod {
    /// A scene's shot, taken as a rod of its mass and radius.
    pub fn of(scene: &Scene) -> Self {
        let shot = &scene.projectile;
        let section = std::f64::consts::PI * shot.tip_radius_m * shot.tip_radius_m;
        Self {
            density_kg_m3: shot.density_kg_m3,
            strength_pa: shot.strength_pa,
            velocity_m_s: shot.velocity_m_s,
            length_m: shot.mass_kg / (shot.density_kg_m3 * section),
            diameter_m: 2.0 * shot.tip_radius_m,
        }
    }

    /// Tate's critical obliquity, degrees from the plate's normal: beyond it ricochet or break-up is likely. Thesis equation
    /// 2.3; made for long rods, whose deceleration it omits: a rough guide.
    pub fn critical_obliquity_deg(&self, target_density_kg_m3: f64) -> f64 {
        let (l, d) = (self.length_m, self.diameter_m);
        let pressure = self.density_kg_m3 * self.velocity_m_s * self.velocity_m_s;
        let ratio = (self.density_kg_m3 / target_density_kg_m3).sqrt();
        let cube =
            2.0 / 3.0 * pressure / self.strength_pa * (l * l + d * d) / (l * d) * (1.0 + ratio);
        cube.cbrt().atan().to_degrees()
    }
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

#[cfg(test)]
mod tests {
    use super::*;

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
        let rod = Rod {
            density_kg_m3: 7850.0,
            strength_pa: 1e9,
            velocity_m_s: 100.0,
            length_m: 0.03,
            diameter_m: 0.0127,
        };
        let tangent = |rod: &Rod| rod.critical_obliquity_deg(2710.0).to_radians().tan();
        let faster = Rod { velocity_m_s: 800.0, ..rod };
        assert!((tangent(&faster) / tangent(&rod) - 4.0).abs() < 1e-9);
        let stronger = Rod { strength_pa: 8e9, ..rod };
        assert!((tangent(&rod) / tangent(&stronger) - 2.0).abs() < 1e-9);
        let depth = |v: f64, r: f64| stone_depth_m(0.03, v, r, 2710.0, 1e6);
        assert!((depth(200.0, 0.01) / depth(100.0, 0.01) - 4.0).abs() < 1e-12);
        assert!((depth(100.0, 0.01) / depth(100.0, 0.02) - 4.0).abs() < 1e-12);
    }
}
