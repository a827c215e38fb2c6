//! Closed forms: arrest and perforation of a plate that is rigid, or free of spring and damper.
//!
//! Relative motion of two bodies that only push on each other is that of one body of the reduced mass mu (the projectile's own
//! mass for a rigid plate). With V(q) the volume swept, d(u²)/dV = -2 (S + c u²)/mu, so that
//! u² = [(S + c v²) exp(-2 c V/mu) - S]/c: the shot stops where V = mu/(2c) ln(1 + c v²/S), and has its ballistic limit at
//! v² = (S/c) (exp(2 c V/mu) - 1) with V the volume of the whole passage. Time is one quadrature.

use crate::model::contact::{AreaPiece, Geometry};
use crate::model::mechanism::moving_plate_kg;
use crate::model::scene::Scene;
use crate::numerics::quadrature::converged;
use crate::numerics::{larger, smaller};

/// One-body penetration with a reduced mass.
#[derive(Clone, Copy, Debug)]
pub struct Passage<'a> {
    /// Depth and area laws.
    pub geometry: &'a Geometry,
    /// 1/mu, 1/kg.
    pub mobility_per_kg: f64,
    /// `S_y`, Pa.
    pub strength_pa: f64,
    /// c, kg/m³.
    pub drag_kg_m3: f64,
    /// Relative velocity at first contact, m/s.
    pub velocity_m_s: f64,
}

impl<'a> Passage<'a> {
    /// A scene's shot on a rigid mount.
    pub fn rigid(scene: &Scene, geometry: &'a Geometry) -> Self {
        Self::unsprung(scene, geometry, false)
    }

    /// The same on a plate that moves freely, or not at all; velocities are those relative to the plate.
    pub fn unsprung(scene: &Scene, geometry: &'a Geometry, moves: bool) -> Self {
        let cos = geometry.nose.cos;
        let plate = if moves { cos * cos / moving_plate_kg(scene) } else { 0.0 };
        Self {
            geometry,
            mobility_per_kg: 1.0 / scene.projectile.mass_kg + plate,
            strength_pa: scene.flow_strength_pa(),
            drag_kg_m3: scene.drag_kg_m3(),
            velocity_m_s: if moves {
                scene.closing_velocity_m_s()
            } else {
                scene.projectile.velocity_m_s
            },
        }
    }

    /// Volume that stops the shot, m³; `None` when nothing stops it (no strength).
    pub fn stopping_volume_m3(&self) -> Option<f64> {
        let (s, c, v) = (self.strength_pa, self.drag_kg_m3, self.velocity_m_s);
        if s == 0.0 {
            return None;
        }
        if c == 0.0 {
            return Some(0.5 * v * v / (s * self.mobility_per_kg));
        }
        Some(0.5 / (c * self.mobility_per_kg) * (c * v * v / s).ln_1p())
    }

    /// Travel at which the shot comes to rest, m; `None` where it perforates.
    pub fn arrest_m(&self) -> Option<f64> {
        self.stopping_volume_m3().and_then(|volume| self.geometry.travel_at_volume_m(volume))
    }

    /// u² before a volume is swept, m²/s², where it is `left` (m/s)² after that.
    fn slip_squared_before(&self, volume_m3: f64, left: f64) -> f64 {
        let (s, c) = (self.strength_pa, self.drag_kg_m3);
        if c == 0.0 {
            return left + 2.0 * s * volume_m3 * self.mobility_per_kg;
        }
        left + (s / c + left) * (2.0 * c * self.mobility_per_kg * volume_m3).exp_m1()
    }

    /// The ballistic limit, m/s: relative impact velocities above it perforate.
    pub fn limit_velocity_m_s(&self) -> f64 {
        self.slip_squared_before(self.geometry.swept_m3(self.geometry.exit_m), 0.0).sqrt()
    }

    /// The volume swept in the last `ahead_m` before `end_m`, m³, without cancellation.
    fn swept_before_m3(&self, ahead_m: f64, end_m: f64) -> f64 {
        let swept = |piece: &AreaPiece| {
            // Distances of the piece's ends from the end, the nearer one first.
            let near = larger(end_m - piece.to_m, 0.0);
            let far = smaller(end_m - piece.from_m, ahead_m);
            let is_swept = far > near;
            is_swept.then(|| piece.swept_before_m3(&self.geometry.nose, end_m - near, far - near))
        };
        self.geometry.pieces().iter().filter_map(swept).sum()
    }

    /// How long it takes to the arrest at this travel, or to the exit, to rounding, s: with q = end (1 - s²) the integrand 2 end s/u is
    /// smooth up to an arrest.
    pub fn time_s(&self, arrest_m: Option<f64>) -> f64 {
        let end_m = arrest_m.unwrap_or(self.geometry.exit_m);
        let left = if arrest_m.is_some() {
            0.0
        } else {
            let whole_m3 = self.geometry.swept_m3(end_m);
            self.slip_squared_before(-whole_m3, self.velocity_m_s * self.velocity_m_s)
        };
        let slip = |s: f64| {
            self.slip_squared_before(self.swept_before_m3(end_m * s * s, end_m), left).sqrt()
        };
        let joints = self.geometry.pieces().iter().filter(|piece| piece.to_m < end_m);
        let joints = joints.map(|piece| ((end_m - piece.to_m) / end_m).sqrt());
        let bounds: Vec<f64> = [1.0].into_iter().chain(joints).chain([0.0]).collect();
        let between = |pair: &[f64]| converged(pair[1], pair[0], |s| 2.0 * end_m * s / slip(s));
        bounds.windows(2).map(between).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    /// The same closed form in 30-digit arithmetic.
    #[test]
    fn valid_times_of_rigid_and_free_plates() {
        let time_s = |moves: bool| {
            let scene = scene_with("gamma=1");
            let geometry = Geometry::of(&scene);
            let passage = Passage::unsprung(&scene, &geometry, moves);
            passage.time_s(passage.arrest_m())
        };
        assert!((time_s(false) / 1.850_116_460_604_822e-4 - 1.0).abs() < 1e-14);
        assert!((time_s(true) / 113.407_312_427_867_64e-6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn no_drag_is_the_limit_of_little_drag() {
        let depth = |drag: &str| {
            let scene = scene_with(drag);
            let geometry = Geometry::of(&scene);
            geometry.depth_m(Passage::unsprung(&scene, &geometry, true).arrest_m().unwrap())
        };
        assert!((depth("C_d=1e-9") / depth("C_d=0") - 1.0).abs() < 1e-9);
    }
}
