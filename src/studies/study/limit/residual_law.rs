//! Laws for the residual velocity after perforation, fitted by least squares.
//!
//! R. F. Recht and T. W. Ipson, *Journal of Applied Mechanics* 30 (1963) 384-390: `v_r = a (v² - v_bl²)^(1/2)`. J. P. Lambert and
//! G. H. Jonas, report BRL R-1852 (1976): `v_r = a (v^p - v_bl^p)^(1/p)`, with a, p and `v_bl` all fitted.

use serde::Serialize;

use cmra_engine::numerics::maximum;

/// Range of the fitted exponent.
const P: (f64, f64) = (1.0, 12.0);
/// Range of the fitted limit, relative to the smallest impact velocity that perforated.
const MIN_LIMIT: f64 = 0.3;

/// Law of the residual velocity: `v_r = a (v^p - v_bl^p)^(1/p)`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ResidualLaw {
    /// Residual velocity over impact velocity far above the limit.
    pub a: f64,
    /// Exponent; 2 in Recht and Ipson's law.
    pub p: f64,
    /// Limit velocity of the law, m/s.
    #[serde(rename = "v_bl_m_s")]
    pub limit_m_s: f64,
    /// RMS error of the fit, m/s.
    pub misfit_m_s: f64,
}

impl ResidualLaw {
    /// Fits Recht and Ipson's law with this limit to (impact, residual) velocities, m/s; `None` for fewer than two shots, or if the
    /// projectile leaves backwards.
    pub fn recht_ipson(shots: &[(f64, f64)], limit_m_s: f64) -> Option<Self> {
        Self::scaled(shots, 2.0, limit_m_s).filter(|law| law.a > 0.0)
    }

    /// Fits Lambert and Jonas's law to (impact, residual) velocities, m/s; `None` for fewer than four shots, or if the law does not fit
    /// them.
    pub fn lambert_jonas(shots: &[(f64, f64)]) -> Option<Self> {
        let least = shots.iter().map(|shot| shot.0).min_by(f64::total_cmp)?;
        if shots.len() < 4 {
            return None;
        }
        let fit =
            |p, limit| Self::scaled(shots, p, limit).map_or(f64::NEG_INFINITY, |it| -it.misfit_m_s);
        let limit_for =
            |p: f64| maximum::in_bracket(MIN_LIMIT * least, least, &|limit| fit(p, limit));
        let p = maximum::in_bracket(P.0, P.1, &|p| fit(p, limit_for(p)));
        Self::scaled(shots, p, limit_for(p)).filter(|law| law.a > 0.0)
    }

    /// Fits the factor `a` to the shots by least squares.
    fn scaled(shots: &[(f64, f64)], p: f64, limit_m_s: f64) -> Option<Self> {
        let (mut along, mut square) = (0.0, 0.0);
        for (v, residual) in shots {
            let s = shape(*v, p, limit_m_s);
            along += s * residual;
            square += s * s;
        }
        if shots.len() < 2 || square <= 0.0 {
            return None;
        }
        let a = along / square;
        let missed = shots.iter().map(|(v, it)| (it - a * shape(*v, p, limit_m_s)).powi(2));
        let misfit_m_s = (missed.sum::<f64>() / shots.len() as f64).sqrt();
        let is_known = a.is_finite() && misfit_m_s.is_finite();
        is_known.then_some(Self { a, p, limit_m_s, misfit_m_s })
    }

    /// Returns the residual velocity for an impact velocity, m/s; 0 up to the limit.
    pub fn residual_m_s(&self, impact_m_s: f64) -> f64 {
        self.a * shape(impact_m_s, self.p, self.limit_m_s)
    }
}

/// Computes `(v^p - limit^p)^(1/p)`, 0 up to the limit, without overflow for large exponents.
fn shape(v: f64, p: f64, limit: f64) -> f64 {
    // `powf` with exponent 2 or 1/2 may have a rounding error; a product or a square root is exact to half a unit in the last place.
    let is_square = p - 2.0 == 0.0;
    let fraction = limit / v;
    let ratio = if is_square { fraction * fraction } else { fraction.powf(p) };
    let left = 1.0 - ratio;
    let root = if is_square { left.sqrt() } else { left.powf(1.0 / p) };
    if ratio < 1.0 { v * root } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shots(a: f64, p: f64, limit: f64) -> Vec<(f64, f64)> {
        let at = |i: u32| limit * (1.0 + 1.5 * (f64::from(i) / 24.0).powi(2));
        (1..=24).map(|i| (at(i), a * (at(i).powf(p) - limit.powf(p)).powf(1.0 / p))).collect()
    }

    #[test]
    fn made_up_shots_give_their_own_laws_back() {
        for (a, p, limit) in [(0.95, 2.0, 232.3), (0.7, 3.1, 800.0), (1.0, 1.4, 50.0)] {
            let found = ResidualLaw::lambert_jonas(&shots(a, p, limit)).unwrap();
            assert!((found.a / a - 1.0).abs() < 1e-4, "{found:?}");
            assert!((found.p / p - 1.0).abs() < 1e-3, "{found:?}");
            assert!((found.limit_m_s / limit - 1.0).abs() < 1e-5, "{found:?}");
        }
        let found = ResidualLaw::recht_ipson(&shots(0.9, 2.0, 232.3), 232.3).unwrap();
        assert!((found.a - 0.9).abs() < 1e-12 && found.misfit_m_s < 1e-9, "{found:?}");
        assert!((found.residual_m_s(100.0)).abs() < 1e-300);
    }

    #[test]
    fn too_few_shots_are_no_law() {
        assert_eq!(ResidualLaw::recht_ipson(&[(300.0, 10.0)], 200.0), None);
        assert_eq!(ResidualLaw::lambert_jonas(&shots(1.0, 2.0, 100.0)[..3]), None);
        assert_eq!(ResidualLaw::lambert_jonas(&[]), None);
        // The projectile leaves backwards.
        assert_eq!(ResidualLaw::recht_ipson(&[(300.0, -10.0), (400.0, -5.0)], 200.0), None);
    }
}
