//! Closed forms of arrest and perforation for a plate that is rigid, or free (without spring and damper).
//!
//! The relative motion is that of one body with the reduced mass mu (the mass of the projectile for a rigid plate). With the swept volume
//! V(q), d(u²)/dV = -2 (S + c u²)/mu and u² = [(S + c v²) exp(-2 c V/mu) - S]/c. The shot stops at V = mu/(2c) ln(1 + c v²/S). The
//! ballistic limit is v² = (S/c) (exp(2 c V/mu) - 1) with the volume V of the whole passage. The time is a quadrature. The displacement of
//! a free plate follows from the conservation of momentum.
//!
//! A nose that shears out a plug opens a hole of volume V in front of it and arrives with `u_1`. Picking up the plug reduces the relative
//! velocity by the factor `m_p/(m_p + m_k)`. The shot perforates if the remaining energy, with the reduced mass `mu_2` of `m_p + m_k` and
//! `m_2 - m_k`, exceeds the work W of shearing. The limit thus has `u_1`² = 2 W `(m_p + m_k)²/(mu_2 m_p²)`, and
//! v² = `u_1`² exp(x) + (S/c)(exp(x) - 1) with x = 2 c V/mu. Shearing follows u' = -(pi `D_p` `tau/mu_2`)(`h_p` - s), with hyperbolic
//! functions of time as solution.

use crate::model::contact::{AreaPiece, Geometry};
use crate::model::mechanism::{Mechanism, moving_plate_kg};
use crate::model::plug::Plug;
use crate::model::run::{Arrest, Departure, Outcome, Penetration, Run};
use crate::model::scene::{ContactModel, Criterion, Scene};
use crate::numerics::quadrature::converged;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Penetration of a body with the reduced mass.
#[derive(Clone, Copy, Debug)]
pub struct Passage<'a> {
    /// Depth and area laws.
    pub geometry: &'a Geometry,
    /// Inverse of the reduced mass, 1/mu, 1/kg.
    pub mobility_per_kg: f64,
    /// Strength `S_y`, Pa.
    pub strength_pa: f64,
    /// Drag coefficient times half the density, c, kg/m³.
    pub drag_kg_m3: f64,
    /// Relative velocity at first contact, m/s.
    pub velocity_m_s: f64,
    /// Shearing of the plug behind the hole; `None` for a nose without a plug.
    shearing: Option<Shearing>,
}

/// Shearing of a plug with a reduced mass.
#[derive(Clone, Copy, Debug)]
struct Shearing {
    plug: Plug,
    /// Inverse of the reduced mass with the plug, `1/mu_2`, 1/kg.
    mobility_per_kg: f64,
    /// Factor of the relative velocity when the plug is picked up.
    kept: f64,
}

impl Shearing {
    /// Returns the slip at which the projectile with its plug stops, from the relative velocity after the pick-up, m; `None` if it
    /// perforates.
    fn arrest_m(&self, slip_m_s: f64) -> Option<f64> {
        let Plug { thickness_m, work_j, slip_m, .. } = self.plug;
        let fraction = 0.5 * slip_m_s * slip_m_s / (self.mobility_per_kg * work_j);
        // W = F(0) (s_f - s_f²/(2 h_p)); the energy is expressed relative to the work through the whole thickness.
        let part = slip_m / thickness_m;
        let whole = fraction * part * (2.0 - part);
        (fraction < 1.0).then(|| thickness_m * whole / (1.0 + (1.0 - whole).sqrt()))
    }

    /// Returns the square of the relative velocity after the pick-up that leaves a given velocity after a slip, m²/s².
    fn slip_squared_before(&self, slip_m: f64, left: f64) -> f64 {
        let work_j = 0.5 * slip_m * (self.plug.force_n(0.0) + self.plug.force_n(slip_m));
        left + 2.0 * work_j * self.mobility_per_kg
    }

    /// Returns the time from the pick-up to a slip, from the relative velocities at both, s.
    fn time_s(&self, slip_m_s: f64, slip_m: f64, left_m_s: f64) -> f64 {
        let Plug { thickness_m, diameter_m, shear_pa, .. } = self.plug;
        let rate = (std::f64::consts::PI * diameter_m * shear_pa * self.mobility_per_kg).sqrt();
        ((thickness_m + slip_m_s / rate) / (thickness_m - slip_m + left_m_s / rate)).ln() / rate
    }
}

impl<'a> Passage<'a> {
    /// Creates the passage of a shot on a rigid mount.
    pub fn rigid(scene: &Scene, geometry: &'a Geometry) -> Self {
        Self::unsprung(scene, geometry, false)
    }

    /// Creates the passage for a free plate (`moves`) or a rigid one; velocities are relative to the plate.
    pub fn unsprung(scene: &Scene, geometry: &'a Geometry, moves: bool) -> Self {
        let cos = geometry.nose.cos;
        let projectile_kg = scene.projectile.mass_kg;
        let mobility_per_kg = |plug_kg: f64| {
            let plate = if moves { cos * cos / (moving_plate_kg(scene) - plug_kg) } else { 0.0 };
            1.0 / (projectile_kg + plug_kg) + plate
        };
        let shearing = |plug: Plug| Shearing {
            plug,
            mobility_per_kg: mobility_per_kg(plug.mass_kg),
            kept: plug.kept(projectile_kg),
        };
        Self {
            geometry,
            mobility_per_kg: mobility_per_kg(0.0),
            shearing: Plug::from_scene(scene).map(shearing),
            strength_pa: scene.flow_strength_pa(),
            drag_kg_m3: scene.drag_kg_m3(),
            velocity_m_s: if moves {
                scene.closing_velocity_m_s()
            } else {
                scene.projectile.velocity_m_s
            },
        }
    }

    /// Returns the swept volume at which the shot stops, m³; `None` without strength.
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

    /// Returns the travel at which the shot stops, m; `None` for a perforation.
    pub fn arrest_m(&self) -> Option<f64> {
        let in_hole_m = || self.geometry.travel_at_volume_m(self.stopping_volume_m3()?);
        let in_plug_m =
            || Some(self.geometry.exit_m + self.shearing?.arrest_m(self.picked_up_m_s())?);
        in_hole_m().or_else(in_plug_m)
    }

    /// Returns the relative velocity after the plug is picked up; without a plug, after the nose is through, m/s.
    fn picked_up_m_s(&self) -> f64 {
        let kept = self.shearing.map_or(1.0, |shearing| shearing.kept);
        kept * self.slip_squared_at(self.geometry.exit_m).sqrt()
    }

    /// Returns the travel at which the resistance ends, m.
    fn through_m(&self) -> f64 {
        self.geometry.exit_m + self.shearing.map_or(0.0, |shearing| shearing.plug.slip_m)
    }

    /// Returns the relative velocity after a perforation, m/s; `None` if the shot is stopped.
    pub fn left_m_s(&self) -> Option<f64> {
        let picked_up_m_s = self.picked_up_m_s();
        let through = self
            .shearing
            .map_or(0.0, |shearing| shearing.slip_squared_before(shearing.plug.slip_m, 0.0));
        let is_through = self.arrest_m().is_none();
        is_through.then(|| larger(picked_up_m_s * picked_up_m_s - through, 0.0).sqrt())
    }

    /// Returns u² before a volume is swept from u² after (`left`), m²/s².
    fn slip_squared_before(&self, volume_m3: f64, left: f64) -> f64 {
        let (s, c) = (self.strength_pa, self.drag_kg_m3);
        if c == 0.0 {
            return left + 2.0 * s * volume_m3 * self.mobility_per_kg;
        }
        left + (s / c + left) * (self.decay_per_m3() * volume_m3).exp_m1()
    }

    /// Returns 2 c/mu, 1/m³: the relative decrease of u² by drag for a unit of swept volume.
    fn decay_per_m3(&self) -> f64 {
        2.0 * self.drag_kg_m3 * self.mobility_per_kg
    }

    /// Returns u² at a travel up to the arrest, m²/s².
    fn slip_squared_at(&self, travel_m: f64) -> f64 {
        let (v, volume_m3) = (self.velocity_m_s, self.geometry.swept_m3(travel_m));
        let stopped = self.slip_squared_before(volume_m3, 0.0);
        larger(v * v - stopped, 0.0) * (-self.decay_per_m3() * volume_m3).exp()
    }

    /// Returns the peak contact force up to a travel, N: F = A (S + c u²), dF/dq = (A' - 2 c A²/mu) (S + c u²).
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
            // The peak of a blunt nose is at the start.
            let at_ends_n = larger(force_n(*from_m), force_n(to_m));
            larger(force_n(bracketed_root(*from_m, to_m, rise)), at_ends_n)
        });
        greatest_n.fold(0.0, larger)
    }

    /// Returns the ballistic limit, m/s: the relative impact velocity above which the shot perforates.
    pub fn limit_velocity_m_s(&self) -> f64 {
        let at_plug = self.shearing.map_or(0.0, |shearing| {
            let picked_up = shearing.slip_squared_before(shearing.plug.slip_m, 0.0);
            picked_up / (shearing.kept * shearing.kept)
        });
        self.slip_squared_before(self.geometry.swept_m3(self.geometry.exit_m), at_plug).sqrt()
    }

    /// Returns the volume swept in the last `ahead_m` before `end_m`, m³, without cancellation.
    fn swept_before_m3(&self, ahead_m: f64, end_m: f64) -> f64 {
        let swept = |piece: &AreaPiece| {
            // Distances of the ends of the piece from `end_m`, the smaller first.
            let near = larger(end_m - piece.to_m, 0.0);
            let far = smaller(end_m - piece.from_m, ahead_m);
            let is_swept = far > near;
            is_swept.then(|| piece.swept_before_m3(&self.geometry.nose, end_m - near, far - near))
        };
        let passed = self.geometry.pieces().iter().take_while(|piece| piece.from_m < end_m);
        passed.filter_map(swept).sum()
    }

    /// Returns the time to the arrest at a travel, or to the exit, s, to rounding error. With q = end (1 - s²) the integrand 2 end s/u is
    /// smooth up to an arrest.
    pub fn time_s(&self, arrest_m: Option<f64>) -> f64 {
        let hole_m = self.geometry.exit_m;
        let slip_m = arrest_m.map_or(f64::INFINITY, |arrest_m| arrest_m - hole_m);
        let Some(shearing) = self.shearing.filter(|_| slip_m > 0.0) else {
            return self.hole_s(arrest_m);
        };
        let slip_m = smaller(slip_m, shearing.plug.slip_m);
        let left_m_s = if arrest_m.is_some() { 0.0 } else { self.left_m_s().unwrap_or(0.0) };
        self.hole_s(None) + shearing.time_s(self.picked_up_m_s(), slip_m, left_m_s)
    }

    /// Returns the time to the arrest in the hole, or to the end of the hole, s.
    fn hole_s(&self, arrest_m: Option<f64>) -> f64 {
        let end_m = arrest_m.unwrap_or(self.geometry.exit_m);
        if end_m <= 0.0 {
            return 0.0;
        }
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

/// Returns `true` for a free or a rigid plate with the hydrodynamic contact model.
pub fn is_unsprung(scene: &Scene) -> bool {
    let mechanism = Mechanism::from_scene(scene);
    let acts = !mechanism.is_absent() || mechanism.stop.is_some() || scene.weight_n() > 0.0;
    scene.contact.model == ContactModel::Hydrodynamic && !acts
}

/// Returns `true` if the ballistic limit has a closed form: one rigid or free plate, with the criterion of passage.
fn has_limit(scene: &Scene) -> bool {
    is_unsprung(scene) && !scene.is_stack() && scene.target.criterion == Criterion::Passage
}

/// Returns the ballistic limit of a rigid or free plate, m/s; `None` for a mechanism, a stack, another contact model or another criterion.
pub fn ballistic_limit_m_s(scene: &Scene) -> Option<f64> {
    if !has_limit(scene) {
        return None;
    }
    let geometry = Geometry::from_scene(scene);
    let passage = Passage::unsprung(scene, &geometry, scene.is_sprung());
    let plate_m_s = scene.plate_velocity_m_s() * scene.cos_obliquity();
    Some(passage.limit_velocity_m_s() + plate_m_s)
}

/// Returns the velocity of the projectile with its plug behind a rigid or free plate, m/s; `None` up to the ballistic limit, or without a
/// closed form.
pub fn residual_velocity_m_s(scene: &Scene) -> Option<f64> {
    if !has_limit(scene) {
        return None;
    }
    let geometry = Geometry::from_scene(scene);
    let passage = Passage::unsprung(scene, &geometry, scene.is_sprung());
    let left_m_s = passage.left_m_s()?;
    let plate_m_s = passage.plate_m_s(scene, passage.through_m(), left_m_s);
    Some(left_m_s + plate_m_s * scene.cos_obliquity())
}

impl Passage<'_> {
    /// Returns the velocity of a free plate along its normal, m/s, at a travel with a given relative velocity. Changes of both velocities
    /// have a constant ratio, before and after the pick-up of a plug.
    fn plate_m_s(&self, scene: &Scene, travel_m: f64, left_m_s: f64) -> f64 {
        if !scene.is_sprung() {
            return 0.0;
        }
        let (cos, plate_kg) = (self.geometry.nose.cos, moving_plate_kg(scene));
        let w_m_s = scene.plate_velocity_m_s();
        let gained = |lost_m_s: f64, kg: f64, mobility: f64| lost_m_s * cos / (kg * mobility);
        let Some(shearing) = self.shearing.filter(|_| travel_m > self.geometry.exit_m) else {
            return w_m_s + gained(self.velocity_m_s - left_m_s, plate_kg, self.mobility_per_kg);
        };
        let picked_up_m_s = self.picked_up_m_s();
        let in_hole_m_s = self.velocity_m_s - picked_up_m_s / shearing.kept;
        let rest_kg = plate_kg - shearing.plug.mass_kg;
        w_m_s
            + gained(in_hole_m_s, plate_kg, self.mobility_per_kg)
            + gained(picked_up_m_s - left_m_s, rest_kg, shearing.mobility_per_kg)
    }
}

/// Returns duration, s, and travel, m, of the hydrodynamic contact on a rigid mount, up to the exit for a perforation.
pub(super) fn hydrodynamic_on_rigid_mount(scene: &Scene) -> (f64, f64) {
    let geometry = Geometry::from_scene(scene);
    let passage = Passage::rigid(scene, &geometry);
    let arrest_m = passage.arrest_m();
    let end_s = passage.time_s(arrest_m);
    let at_speed_s = geometry.exit_m / scene.projectile.velocity_m_s;
    (if end_s.is_finite() { end_s } else { at_speed_s }, arrest_m.unwrap_or(geometry.exit_m))
}

/// Computes the results of a shot at a rigid or free plate in closed form. Returns `None` for other plates, other contact models, oblique
/// shots (their swept volumes are integrals) and runs with a horizon.
pub(super) fn results(scene: &Scene) -> Option<Run> {
    let is_oblique = scene.projectile.obliquity_deg != 0.0;
    if !is_unsprung(scene) || is_oblique || scene.run.horizon_s.is_some() {
        return None;
    }
    let geometry = Geometry::from_scene(scene);
    let passage = Passage::unsprung(scene, &geometry, scene.is_sprung());
    let arrest_m = passage.arrest_m();
    let end_m = arrest_m.unwrap_or_else(|| passage.through_m());
    let end_s = passage.time_s(arrest_m);
    let left_m_s = passage.left_m_s().unwrap_or(0.0);
    let (v, w) = (passage.velocity_m_s, scene.plate_velocity_m_s());
    let plate_m_s = passage.plate_m_s(scene, end_m, left_m_s);
    // The displacement of the plate is the relative displacement times the mass fraction of projectile and plug.
    let shearing = passage.shearing.filter(|_| end_m > geometry.exit_m);
    let of_plug = shearing.map_or(0.0, |it| it.plug.mass_kg * (end_m - geometry.exit_m));
    let moved_m = if scene.is_sprung() {
        let m_p = scene.projectile.mass_kg;
        (m_p * (v * end_s - end_m) - of_plug) / (m_p + moving_plate_kg(scene))
    } else {
        0.0
    };
    let exit_s = arrest_m.is_none().then_some(end_s);
    let of_plug_n = shearing.map_or(0.0, |shearing| shearing.plug.force_n(0.0));
    Some(Run {
        outcome: if arrest_m.is_some() { Outcome::Arrested } else { Outcome::Perforated },
        first_arrest: arrest_m.map(|_| Arrest {
            t_s: end_s,
            penetration_m: geometry.depth_m(end_m),
            plate_displacement_m: scene.start_m() + w * end_s + moved_m,
            plate_velocity_m_s: plate_m_s,
        }),
        penetration: Penetration {
            final_m: Some(geometry.depth_m(end_m)),
            ..Penetration::default()
        },
        peak_contact_force_n: Some(larger(passage.peak_n(end_m), of_plug_n)),
        // The shot only accelerates the plate.
        max_plate_displacement_m: (plate_m_s <= 0.0).then(|| scene.start_m()),
        departure: Departure {
            residual_velocity_m_s: exit_s.map(|_| left_m_s + plate_m_s),
            exit_time_s: exit_s,
            ..Departure::default()
        },
        ..Run::default()
    })
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;
    use crate::model::run::RunSnapshot;
    use crate::model::simulate::{Settings, bare_run, simulate};
    use crate::model::variables::scene_with;

    /// Reference values: the closed form in 30-digit arithmetic.
    #[test]
    fn valid_times_of_rigid_and_free_plates() {
        let time_s = |moves: bool| {
            let scene = scene_with("gamma=1");
            let geometry = Geometry::from_scene(&scene);
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
            // Stopped in the hole ahead of the plug, in the plug, and through; without a hole; ductile shearing to the rear face.
            "mount=rigid nose=blunt closure=cylindrical UTS=180MPa v_i=100",
            "mount=rigid nose=blunt closure=cylindrical UTS=180MPa v_i=330",
            "mount=rigid nose=blunt closure=cylindrical UTS=180MPa v_i=500",
            "k=0 nose=fragment closure=cylindrical Y=276MPa UTS=310MPa v_i=400 h=10mm gamma=3",
            "k=0 nose=fragment closure=cylindrical Y=276MPa UTS=310MPa v_i=700 h=20mm gamma=3 w_0=-20 d=1mm",
            "k=0 nose=fragment closure=cylindrical Y=276MPa UTS=310MPa v_i=450 h=20mm gamma=3",
        ] {
            let scene = scene_with(pairs);
            let values = |run: &Run| {
                let arrest = run.first_arrest;
                [
                    run.penetration.final_m,
                    run.peak_contact_force_n,
                    run.departure.residual_velocity_m_s,
                    run.departure.exit_time_s,
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

    /// Oblique shots into plates thinner than the slender shot is long, where the peak lies beside a corner of the area law. The closed
    /// form of the force over the travel is searched on a grid, dense at the corners, and about its greatest value.
    #[test]
    fn valid_the_peak_of_an_oblique_slender_shot_is_that_of_its_closed_form() {
        let mut random = crate::numerics::random::Random::new(5);
        let mut beside = 0;
        for _ in 0..60 {
            let between = |from: f64, to: f64, part: f64| from + (to - from) * part;
            let mut next = |from: f64, to: f64| between(from, to, random.unit());
            let (mass_kg, angle_deg) = (10f64.powf(next(-1.0, 1.5)), next(20.0, 70.0));
            let (thickness_mm, v) = (next(3.0, 12.0), next(50.0, 400.0));
            let pairs =
                format!("k=0 R=1mm m_p={mass_kg} theta={angle_deg}deg h={thickness_mm}mm v_i={v}");
            let scene = scene_with(&pairs);
            let geometry = Geometry::from_scene(&scene);
            let passage = Passage::unsprung(&scene, &geometry, true);
            let force_n = |q_m: f64| {
                let pressure_pa =
                    passage.strength_pa + passage.drag_kg_m3 * passage.slip_squared_at(q_m);
                geometry.area_m2(q_m) * pressure_pa
            };
            let mut peak_n = 0.0;
            for piece in geometry.pieces() {
                let end_m = smaller(passage.arrest_m().unwrap_or(geometry.exit_m), piece.to_m);
                let of = |s: f64| {
                    force_n(piece.from_m + (end_m - piece.from_m) * s.powi(3) * (4.0 - 3.0 * s))
                };
                let grid: Vec<f64> = (0..=200u8).map(|i| of(f64::from(i) / 200.0)).collect();
                let best = (0..grid.len()).max_by(|a, b| grid[*a].total_cmp(&grid[*b])).unwrap();
                let cell = |i: usize| i.min(200) as f64 / 200.0;
                let (a, b) = (cell(best.saturating_sub(1)), cell(best + 1));
                let at = crate::numerics::maximum::in_bracket(a, b, &of);
                let inside_n = of(at);
                beside += usize::from(inside_n > grid[0].max(grid[200]) && at > 0.9);
                peak_n = larger(peak_n, larger(inside_n, grid[best]));
                if end_m < piece.to_m {
                    break;
                }
            }
            let found_n = bare_run(&scene).peak_contact_force_n.unwrap();
            assert!((found_n / peak_n - 1.0).abs() < 2e-12, "{pairs}: {found_n} {peak_n}");
        }
        assert!(beside > 10, "{beside}");
        // The same formula in another program.
        let scene = Arc::new(scene_with("m_p=10 R=1mm h=4mm theta=60deg k=0"));
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let run = simulate(&scene, &Settings::default(), go_on).unwrap();
        let error = (run.peak_contact_force_n.unwrap() / 498.805_577_770_0 - 1.0).abs();
        assert!(error < 1e-12 && error <= run.error_of("peak_contact_force_n").unwrap());
    }

    const FRAGMENT_20_MM: &str =
        "nose=fragment m_p=53.78g R=9.95mm closure=cylindrical mount=rigid";
    const AA2139: &str = "h=38.7mm rho=2810 Y=414MPa UTS=462MPa E=73.1GPa";

    fn with_laws(pairs: &str) -> Scene {
        scene_with(&format!("closure=cylindrical mount=rigid {pairs}"))
    }

    /// The formulas of the head of this file in another program, with Brent's method and adaptive quadrature.
    #[test]
    fn valid_limits_and_residual_velocities_of_measured_shots() {
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-6;
        let on_5059 = format!("{FRAGMENT_20_MM} h=25.1mm rho=2660 Y=254MPa UTS=365MPa E=70.9GPa");
        let on_2139 = format!("{FRAGMENT_20_MM} {AA2139}");
        for (pairs, limit) in [
            (
                "nose=pointed m_p=5.3g R=3.1242mm h=25.4mm rho=2700 Y=276MPa UTS=310MPa E=68.3GPa C_d=0.212",
                581.574_273,
            ),
            (
                "nose=pointed theta=30deg m_p=25.9g R=5.44195mm h=8.4mm rho=7850 Y=1867.3535MPa UTS=2067MPa E=207GPa",
                684.105_170,
            ),
            (&on_5059, 439.180_621),
            (&on_2139, 926.906_828),
            (&format!("{on_2139} mount=sprung k=0 m_2=0.5kg"), 999.684_335),
            (
                "nose=fragment m_p=13.4g R=6.3mm h=10.4mm rho=7850 Y=1350MPa UTS=1640MPa E=207GPa",
                754.446_252,
            ),
            (
                "nose=blunt m_p=197g R=10mm h=12mm rho=7850 Y=490MPa UTS=567MPa E=200GPa",
                148.336_189,
            ),
        ] {
            let found = ballistic_limit_m_s(&with_laws(pairs)).unwrap();
            assert!(near(found, limit), "{pairs}: {found}");
        }
        for (pairs, residual) in [
            (format!("{on_5059} v_i=600"), 294.924_987),
            (format!("{on_2139} v_i=1200"), 437.693_460),
        ] {
            assert!(near(residual_velocity_m_s(&with_laws(&pairs)).unwrap(), residual), "{pairs}");
        }
        assert_eq!(residual_velocity_m_s(&with_laws(&format!("{on_2139} v_i=900"))), None);
    }

    /// A heavy free plate is a rigid one; without its plug the hole alone resists, as under a hemisphere of the same drag through as much.
    #[test]
    fn valid_plug_laws_have_their_limits() {
        let rigid = with_laws(&format!("{FRAGMENT_20_MM} {AA2139} v_i=1200"));
        let heavy =
            with_laws(&format!("{FRAGMENT_20_MM} {AA2139} v_i=1200 mount=sprung k=0 gamma=1e9"));
        let near = |a: f64, b: f64, part: f64| (a / b - 1.0).abs() < part;
        assert!(near(
            ballistic_limit_m_s(&heavy).unwrap(),
            ballistic_limit_m_s(&rigid).unwrap(),
            1e-8
        ));
        assert!(near(
            residual_velocity_m_s(&heavy).unwrap(),
            residual_velocity_m_s(&rigid).unwrap(),
            1e-8
        ));
        let scene = with_laws("nose=blunt Y=276MPa UTS=310MPa");
        let geometry = Geometry::from_scene(&scene);
        let mut passage = Passage::rigid(&scene, &geometry);
        let shearing = passage.shearing.as_mut().unwrap();
        (shearing.plug.work_j, shearing.kept) = (0.0, 1.0);
        (shearing.plug.shear_pa, shearing.plug.slip_m) = (0.0, 0.0);
        let round = format!("Y=276MPa UTS=310MPa h={}", geometry.exit_m);
        let hole = ballistic_limit_m_s(&with_laws(&round)).unwrap();
        assert!(near(passage.limit_velocity_m_s(), hole, 1e-12));
        // Without hardening the strength is that of U = Y.
        let strength = |pairs: &str| with_laws(pairs).flow_strength_pa();
        assert!((strength("UTS=75.8MPa") - strength("")).abs() < 1e-6);
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
            let geometry = Geometry::from_scene(&scene);
            geometry.depth_m(Passage::unsprung(&scene, &geometry, true).arrest_m().unwrap())
        };
        assert!((depth("C_d=1e-9") / depth("C_d=0") - 1.0).abs() < 1e-9);
    }
}
