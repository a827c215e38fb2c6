//! Recht and Ipson's law for the residual velocity after perforation, `v_r = a (v² - v_bl²)^(1/2)`, fitted by least squares.
//!
//! R. F. Recht and T. W. Ipson, *Journal of Applied Mechanics* 30 (1963) 384-390.

use serde::Serialize;

/// The law, with what it misses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ResidualLaw {
    /// Part of the velocity that is left far beyond the limit.
    pub a: f64,
    /// The limit it goes through, m/s.
    #[serde(rename = "v_bl_m_s")]
    pub limit_m_s: f64,
    /// Root mean square of what it misses, m/s.
    pub misfit_m_s: f64,
}

impl ResidualLaw {
    /// Through (impact, residual) velocities, m/s, with this limit; `None` with fewer than two, or where the projectile leaves
    /// backwards.
    pub fn of(shots: &[(f64, f64)], limit_m_s: f64) -> Option<Self> {
        let shaped = || shots.iter().map(|(v, residual)| (shape(*v, limit_m_s), residual));
        let square: f64 = shaped().map(|(s, _)| s * s).sum();
        let a = shaped().map(|(s, residual)| s * residual).sum::<f64>() / square;
        let missed = shaped().map(|(s, residual)| (residual - a * s).powi(2));
        let misfit_m_s = (missed.sum::<f64>() / shots.len() as f64).sqrt();
        let is_known = shots.len() > 1 && a.is_finite() && a > 0.0 && misfit_m_s.is_finite();
        is_known.then_some(Self { a, limit_m_s, misfit_m_s })
    }

    /// Velocity left of an impact velocity, m/s; 0 up to the limit.
    pub fn residual_m_s(&self, impact_m_s: f64) -> f64 {
        self.a * shape(impact_m_s, self.limit_m_s)
    }
}

/// (v² - limit²)^(1/2), 0 up to the limit.
fn shape(v: f64, limit: f64) -> f64 {
    let part = limit / v;
    if part < 1.0 { v * (1.0 - part * part).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_few_shots_are_no_law() {
        assert_eq!(ResidualLaw::of(&[(300.0, 10.0)], 200.0), None);
        // The projectile leaves backwards.
        assert_eq!(ResidualLaw::of(&[(300.0, -10.0), (400.0, -5.0)], 200.0), None);
    }
}
