//! Lumped-parameter model of Wu, thesis Figures 8.4 to 8.8: a spring with hysteresis and a damper between projectile and plate.
//!
//! The interface loads with `k_load` and unloads with the larger `k_unload`. The residual dent is `delta_max (1 - k_load/k_unload)`;
//! reloading follows `k_unload` up to `delta_max`. The interface has no tension. The dent is the depth; the model has no rear face.

use crate::model::closed_form::hydrodynamic_on_rigid_mount;
use crate::model::scene::Scene;

/// Default ratio of unloading to loading stiffness: a hundredth of the dent and a tenth of the velocity are recovered.
const UNLOAD_PER_LOAD: f64 = 100.0;

/// Returns loading and unloading stiffness of the lumped interface, N/m. The default loading stiffness gives the travel of the hydrodynamic
/// contact on a rigid mount.
pub(in crate::model) fn stiffnesses_n_m(scene: &Scene) -> (f64, f64) {
    let load_n_m = scene.contact.load_stiffness_n_m.unwrap_or_else(|| {
        let speed_per_s = scene.projectile.velocity_m_s / hydrodynamic_on_rigid_mount(scene).1;
        scene.projectile.mass_kg * speed_per_s * speed_per_s
    });
    (load_n_m, scene.contact.unload_stiffness_n_m.unwrap_or(UNLOAD_PER_LOAD * load_n_m))
}

/// Lumped interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) struct Lumped {
    load_n_m: f64,
    unload_n_m: f64,
    damping_n_s_m: f64,
    /// Projectile mass, kg.
    mass_kg: f64,
    velocity_m_s: f64,
}

impl Lumped {
    pub(super) fn from_scene(scene: &Scene) -> Self {
        let (load_n_m, unload_n_m) = stiffnesses_n_m(scene);
        Self {
            load_n_m,
            unload_n_m,
            damping_n_s_m: scene.contact.damping_n_s_m,
            mass_kg: scene.projectile.mass_kg,
            velocity_m_s: scene.projectile.velocity_m_s,
        }
    }

    /// Returns the residual dent of a maximum travel, m.
    pub(super) fn dent_m(&self, deepest_m: f64) -> f64 {
        deepest_m * (1.0 - self.load_n_m / self.unload_n_m)
    }

    /// Returns stiffness, N/m, and travel at zero force, m, of the loading or the unloading branch.
    fn branch(&self, goes_in: bool, deepest_m: f64) -> (f64, f64) {
        if goes_in { (self.load_n_m, 0.0) } else { (self.unload_n_m, self.dent_m(deepest_m)) }
    }

    /// Returns the force at a travel and a relative velocity, on the loading branch or on the unloading branch (there as if it could pull),
    /// N.
    pub(in crate::model) fn force_n(
        &self,
        goes_in: bool,
        deepest_m: f64,
        (q_m, u_m_s): (f64, f64),
    ) -> f64 {
        let (stiffness, slack_m) = self.branch(goes_in, deepest_m);
        stiffness * (q_m - slack_m) + self.damping_n_s_m * u_m_s
    }

    /// Returns the derivatives of the force by travel, N/m, and by relative velocity, N s/m.
    pub(in crate::model) fn slopes(&self, goes_in: bool) -> (f64, f64) {
        (self.branch(goes_in, 0.0).0, self.damping_n_s_m)
    }

    /// Returns the recoverable energy of the interface spring at a travel, J.
    pub(in crate::model) fn gives_back_j(&self, goes_in: bool, deepest_m: f64, q_m: f64) -> f64 {
        let force_n = self.force_n(goes_in, deepest_m, (q_m, 0.0));
        0.5 * force_n * force_n / self.unload_n_m
    }

    /// Returns the energy that deepens a dent by a small fraction of the travel that made it, J, if the damper takes nothing: that of the
    /// fraction alone on the way in, later that up to this travel as well.
    pub(in crate::model) fn deepens_j(&self, goes_in: bool, deepest_m: f64, fraction: f64) -> f64 {
        let again = if goes_in { 0.0 } else { 0.5 * self.load_n_m / self.unload_n_m };
        (again + fraction) * self.load_n_m * deepest_m * deepest_m
    }

    /// Returns the dent on a rigid mount, m, from the maximum travel of m q'' + b q' + k q = 0 with q(0) = 0 and the impact velocity.
    ///
    /// With r = b/(2 m) and w = (k/m)^(1/2) the maximum travel is v/w exp(-r t) with t = atan(s/r)/s, s = (w² - r²)^(1/2) below critical
    /// damping. Above, with s = (r² - w²)^(1/2), it is v/(r + s) exp(-ln(1 + z)/z) with z = 2 s/(r - s) = 2 s (r + s)/w². Both forms are
    /// free of cancellation.
    pub(super) fn on_rigid_mount_m(&self) -> f64 {
        let (m, v) = (self.mass_kg, self.velocity_m_s);
        let (r, w) = (0.5 * self.damping_n_s_m / m, (self.load_n_m / m).sqrt());
        let s = ((w - r).abs() * (w + r)).sqrt();
        let travel_m = if w > r {
            v / w * (-r * s.atan2(r) / s).exp()
        } else {
            let z = 2.0 * s * (r + s) / (w * w);
            let fraction = if z > 0.0 { z.ln_1p() / z } else { 1.0 };
            v / (r + s) * (-fraction).exp()
        };
        self.dent_m(travel_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    /// `v/(l_2 - l_1) (exp(-l_1 t) - exp(-l_2 t))` at its turn in 60-digit arithmetic, below and above the critical damping; at it
    /// `v/(w e)`, and without a damper `v/w`. The dent is 99 % of it.
    #[test]
    fn valid_the_dent_on_a_rigid_mount_keeps_its_digits_at_any_damping() {
        let critical_m = 0.99 * 100.0 * (0.0295f64 / 1e6).sqrt() / 1f64.exp();
        let critical = format!("k_load=1e6 b_2={:e}", 2.0 * (0.0295f64 * 1e6).sqrt());
        for (pairs, dent_m) in [
            ("k_load=1 b_2=1e9", 2.9205e-9),
            ("k_load=1 b_2=1e7", 2.920_499_999_999_97e-7),
            ("k_load=1e7 b_2=1e5", 2.919_687_506_583_499e-5),
            ("k_load=1e4 b_2=100", 0.026_926_022_766_453_114),
            ("k_load=1e6 b_2=10", 0.016_257_238_270_444_225),
            ("k_load=1e6 b_2=0", 0.99 * 100.0 * (0.0295f64 / 1e6).sqrt()),
            (&critical, critical_m),
        ] {
            let found_m = Lumped::from_scene(&scene_with(&format!("model=lumped {pairs}")))
                .on_rigid_mount_m();
            assert!((found_m / dent_m - 1.0).abs() < 1e-14, "{pairs}: {found_m} {dent_m}");
        }
    }
}
