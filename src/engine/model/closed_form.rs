//! Closed forms: arrest and perforation of a plate that is rigid, or free of spring and damper.
//!
//! Relative motion of two bodies that only push on each other is that of one body of the reduced mass mu (the projectile's own
//! mass for a rigid plate). With V(q) the volume swept, d(u²)/dV = -2 (S + c u²)/mu, so that
//! u² = [(S + c v²) exp(-2 c V/mu) - S]/c: the shot stops where V = mu/(2c) ln(1 + c v²/S), and has its ballistic limit at
//! v² = (S/c) (exp(2 c V/mu) - 1) with V the volume of the whole passage. Time is one quadrature. A free plate is moved as far as the
//! momentum of both bodies asks.

use crate::model::contact::{AreaPiece, Geometry};
use crate::model::mechanism::{Mechanism, moving_plate_kg};
use crate::model::run::{Arrest, Outcome, Run};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::quadrature::converged;
use crate::numerics::root::in_bracket;
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
        left + (s / c + left) * (self.decay_per_m3() * volume_m3).exp_m1()
    }

    /// 2 c/mu, 1/m³: the part that drag takes of u² per volume swept.
    fn decay_per_m3(&self) -> f64 {
        2.0 * self.drag_kg_m3 * self.mobility_per_kg
    }

    /// u² after a travel that is not farther than the arrest, m²/s².
    fn slip_squared_at(&self, travel_m: f64) -> f64 {
        let (v, volume_m3) = (self.velocity_m_s, self.geometry.swept_m3(travel_m));
        let stopped = self.slip_squared_before(volume_m3, 0.0);
        larger(v * v - stopped, 0.0) * (-self.decay_per_m3() * volume_m3).exp()
    }

    /// The greatest contact force up to a travel, N: F = A (S + c u²) grows by dF/dq = (A' - 2 c A²/mu) (S + c u²).
    fn peak_n(&self, end_m: f64) -> f64 {
        let (nose, decay_per_m3) = (&self.geometry.nose, self.decay_per_m3());
        let passed = self.geometry.pieces().iter().take_while(|piece| piece.from_m < end_m);
        let greatest_n = passed.map(|AreaPiece { from_m, to_m, law }| {
            let to_m = smaller(*to_m, end_m);
            let area_m2 = |q_m: f64| law.area_m2(nose, q_m);
            let rise = |q_m: f64| law.slope_m(nose, q_m) - decay_per_m3 * area_m2(q_m).powi(2);
            let force_n = |q_m: f64| {
                area_m2(q_m) * (self.strength_pa + self.drag_kg_m3 * self.slip_squared_at(q_m))
            };
            larger(force_n(in_bracket(*from_m, to_m, rise)), force_n(to_m))
        });
        greatest_n.fold(0.0, larger)
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
        let passed = self.geometry.pieces().iter().take_while(|piece| piece.from_m < end_m);
        passed.filter_map(swept).sum()
    }

    /// How long it takes to the arrest at this travel, or to the exit, to rounding, s: with q = end (1 - s²) the integrand 2 end s/u is
    /// smooth up to an arrest.
    pub fn time_s(&self, arrest_m: Option<f64>) -> f64 {
        let end_m = arrest_m.unwrap_or(self.geometry.exit_m);
        let left = if arrest_m.is_some() { 0.0 } else { self.slip_squared_at(end_m) };
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

/// Whether nothing but the shot moves the plate, or nothing at all, and the contact has the law of these closed forms.
pub fn is_unsprung(scene: &Scene) -> bool {
    let mechanism = Mechanism::of(scene);
    let acts = !mechanism.is_absent() || mechanism.stop.is_some();
    scene.contact.model == ContactModel::Hydrodynamic && !acts
}

/// What becomes of a shot into a plate that is rigid, or that nothing but the shot moves. `None` of other plates and contact models, of a
/// shot at an angle, whose swept volumes are integrals themselves, and of a run with a horizon.
pub(super) fn results(scene: &Scene) -> Option<Run> {
    let is_oblique = scene.projectile.obliquity_deg != 0.0;
    if !is_unsprung(scene) || is_oblique || scene.run.horizon_s.is_some() {
        return None;
    }
    let geometry = Geometry::of(scene);
    let passage = Passage::unsprung(scene, &geometry, scene.is_sprung());
    let arrest_m = passage.arrest_m();
    let end_m = arrest_m.unwrap_or(geometry.exit_m);
    let end_s = passage.time_s(arrest_m);
    let left_m_s = if arrest_m.is_some() { 0.0 } else { passage.slip_squared_at(end_m).sqrt() };
    // What the projectile loses of its velocity relative to the plate the plate gains by its part of the mass.
    let m_p = scene.projectile.mass_kg;
    let part = if scene.is_sprung() { m_p / (m_p + moving_plate_kg(scene)) } else { 0.0 };
    let (v, w) = (passage.velocity_m_s, scene.plate_velocity_m_s());
    let plate_m_s = w + part * (v - left_m_s);
    let exit_s = arrest_m.is_none().then_some(end_s);
    Some(Run {
        outcome: if arrest_m.is_some() { Outcome::Arrested } else { Outcome::Perforated },
        first_arrest: arrest_m.map(|_| Arrest {
            t_s: end_s,
            penetration_m: geometry.depth_m(end_m),
            plate_displacement_m: scene.start_m() + w * end_s + part * (v * end_s - end_m),
            plate_velocity_m_s: plate_m_s,
        }),
        final_penetration_m: Some(geometry.depth_m(end_m)),
        peak_contact_force_n: Some(passage.peak_n(end_m)),
        // The shot only makes the plate faster.
        max_plate_displacement_m: (plate_m_s <= 0.0).then(|| scene.start_m()),
        residual_velocity_m_s: exit_s.map(|_| left_m_s + plate_m_s),
        exit_time_s: exit_s,
        ..Run::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::simulate::bare_run;
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

    /// The engine steps through the motion and the closed forms do not.
    #[test]
    fn valid_results_are_those_of_the_simulation() {
        for pairs in [
            "mount=rigid",
            "mount=rigid C_d=0",
            "mount=rigid v_i=500 h=3mm",
            "mount=rigid v_i=5000 h=1m",
            "mount=rigid R=0.6mm",
            "k=0 gamma=1",
            "k=0 w_0=-30 d=2mm interface=plastic",
            "k=0 v_i=400 h=3mm w_0=10",
            "k=0 v_i=5 gamma=50",
            "k=0 w_0=-200 d=2mm",
            "k=0 S_y=0",
            "mount=rigid S_y=0 h=1m",
            "k=0 v_i=900 h=20mm dishing=off",
        ] {
            let scene = scene_with(pairs);
            let values = |run: &Run| {
                let arrest = run.first_arrest;
                [
                    run.final_penetration_m,
                    run.peak_contact_force_n,
                    run.residual_velocity_m_s,
                    run.exit_time_s,
                    run.max_plate_displacement_m,
                    arrest.map(|arrest| arrest.t_s),
                    arrest.map(|arrest| arrest.plate_displacement_m),
                    arrest.map(|arrest| arrest.plate_velocity_m_s),
                ]
            };
            let (run, exact) = (bare_run(&scene), results(&scene).unwrap());
            assert_eq!(run.outcome, exact.outcome, "{pairs}");
            for pair in values(&run).into_iter().zip(values(&exact)) {
                let near =
                    |(found, exact): (f64, f64)| (found - exact).abs() <= 1e-12 * exact.abs();
                let is_near = pair.0.zip(pair.1).is_none_or(near);
                assert!(is_near && pair.0.is_some() == pair.1.is_some(), "{pairs}: {pair:?}");
            }
        }
    }

    #[test]
    fn what_moves_by_a_mechanism_or_at_an_angle_has_no_closed_form() {
        let others = ["k=1e5", "k=0 b=10", "k=0 x_stop=1mm", "mount=rigid theta=1deg"];
        let models = ["mount=rigid model=half-sine", "mount=rigid horizon=1ms"];
        assert!(others.into_iter().chain(models).all(|it| results(&scene_with(it)).is_none()));
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
