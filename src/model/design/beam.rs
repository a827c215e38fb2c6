//! A cantilever as the pseudo-rigid-body model sees it: two rigid links, a pin and a torsional spring.
//!
//! `P = K Theta/(gamma_l l cos Theta)`, `x = gamma_l l sin Theta`, `K = gamma_l K_Theta E I/l`; the load keeps its direction, the
//! bending moment at the root is `P (l - gamma_l l (1 - cos Theta))`. L. L. Howell, *Compliant Mechanisms* (2001), chapter 5;
//! thesis section 9.5.2.

use crate::numerics::root::in_bracket;

/// Stiffness coefficient of the torsional spring for a load across the beam.
pub const STIFFNESS_COEFFICIENT: f64 = 2.65;

/// A rectangular cantilever, loaded across at its free end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cantilever {
    /// E, Pa.
    pub modulus_pa: f64,
    /// Yield strength, Pa.
    pub yield_pa: f64,
    /// w, across the direction of bending, m.
    pub width_m: f64,
    /// h, in the direction of bending, m.
    pub height_m: f64,
    /// l, m.
    pub length_m: f64,
    /// `gamma_l`, the characteristic radius factor.
    pub radius_factor: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

impl Cantilever {
    /// Table 9.3: titanium 6-4; the density is not given there (4430 is the alloy's).
    pub const TABLE_9_3: Self = Self {
        modulus_pa: 113.8e9,
        yield_pa: 880e6,
        width_m: 0.03,
        height_m: 0.015,
        length_m: 0.3,
        radius_factor: 0.85,
        density_kg_m3: 4430.0,
    };

    /// K, N m/rad.
    pub fn torsional_n_m(&self) -> f64 {
        let inertia = self.width_m * self.height_m.powi(3) / 12.0;
        self.radius_factor * STIFFNESS_COEFFICIENT * self.modulus_pa * inertia / self.length_m
    }

    fn reach_m(&self) -> f64 {
        self.radius_factor * self.length_m
    }

    fn angle(&self, x_m: f64) -> f64 {
        (x_m / self.reach_m()).asin()
    }

    /// Force at the displacement x, N.
    pub fn force_n(&self, x_m: f64) -> f64 {
        let angle = self.angle(x_m);
        self.torsional_n_m() * angle / (self.reach_m() * angle.cos())
    }

    /// dP/dx, N/m.
    pub fn tangent_n_m(&self, x_m: f64) -> f64 {
        let (angle, reach) = (self.angle(x_m), self.reach_m());
        let cos = angle.cos();
        self.torsional_n_m() * (1.0 + angle * angle.tan()) / (reach * reach * cos * cos)
    }

    /// Energy stored at x, J.
    pub fn energy_j(&self, x_m: f64) -> f64 {
        0.5 * self.torsional_n_m() * self.angle(x_m).powi(2)
    }

    /// Greatest bending stress at x, Pa.
    pub fn stress_pa(&self, x_m: f64) -> f64 {
        let arm = self.length_m - self.reach_m() * (1.0 - self.angle(x_m).cos());
        let section = self.width_m * self.height_m * self.height_m / 6.0;
        self.force_n(x_m) * arm / section
    }

    /// The displacement at which it yields, m.
    pub fn yield_at_m(&self) -> f64 {
        in_bracket(0.0, 0.9 * self.reach_m(), |x| self.stress_pa(x) - self.yield_pa)
    }

    /// Its mass, kg.
    pub fn mass_kg(&self) -> f64 {
        self.density_kg_m3 * self.width_m * self.height_m * self.length_m
    }

    /// The mass at the tip that has the kinetic energy of the beam in its static shape: 33/140 of its mass, kg.
    pub fn tip_mass_kg(&self) -> f64 {
        33.0 / 140.0 * self.mass_kg()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_table_9_3() {
        let beam = Cantilever::TABLE_9_3;
        assert!((beam.torsional_n_m() - 7209.0).abs() < 1.0);
        assert!((beam.tangent_n_m(0.0) / 1e6 - 0.111).abs() < 5e-4);
        // K = 7200 and an arm of l - gamma l (1 - cos) give 0.0297.
        assert!((beam.yield_at_m() - 0.0297).abs() < 1e-4, "{}", beam.yield_at_m());
        assert!((beam.mass_kg() - 0.598).abs() < 1e-3);
        assert!((beam.tip_mass_kg() - 0.141).abs() < 1e-3);
    }

    #[test]
    fn force_is_the_derivative_of_the_energy_and_tangent_that_of_the_force() {
        let beam = Cantilever::TABLE_9_3;
        for x in [0.0, 0.01, 0.03, 0.1, 0.2] {
            let h = 1e-6;
            let force = (beam.energy_j(x + h) - beam.energy_j(x - h)) / (2.0 * h);
            let tangent = (beam.force_n(x + h) - beam.force_n(x - h)) / (2.0 * h);
            assert!((force - beam.force_n(x)).abs() < 1e-4 * (1.0 + force.abs()), "{x}");
            assert!((tangent / beam.tangent_n_m(x) - 1.0).abs() < 1e-6, "{x}");
        }
    }
}
