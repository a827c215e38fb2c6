//! The algorithm of the thesis's Appendix A: as printed, and with its coupling mended.
//!
//! The scripts m50, m200 and m300 are read as one loop. Each step: depth from the projectile's travel, area, one force; the
//! projectile by the trapezoid of old and new force (its travel by forward Euler); the plate by one Runge-Kutta step with the
//! force held. It ends when the relative velocity falls below 0.01 m/s or the area vanishes. What is wrong with it is on the
//! model page, section 6: depth subtracts only the plate's last increment, and the damper has no sign. Only the contact
//! is done here.

use crate::model::contact_phase::section::Faces;
use crate::model::contact_phase::{Answer, Ending, Refusal};
use crate::model::scene::{Mount, Scene};

/// Relative velocity at which the listing stops, m/s.
const SLOW_M_S: f64 = 0.01;

/// Which reading of the listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coupling {
    /// As printed.
    Printed,
    /// Depth from the whole relative travel, a damper that resists, and obliquity's cosine in both couplings.
    Mended,
}

/// The plate, and how it is carried.
struct Plate {
    mass_kg: f64,
    spring: (f64, f64),
    damper: (f64, f64),
    coupling: Coupling,
}

impl Plate {
    /// A.9: d/dt of (displacement, velocity) under the force.
    fn rate(&self, [x, w]: [f64; 2], force_n: f64) -> [f64; 2] {
        let power = |(coefficient, exponent): (f64, f64), z: f64| {
            if coefficient == 0.0 { 0.0 } else { coefficient * z.abs().powf(exponent) }
        };
        let sign = |z: f64| if z == 0.0 { 0.0 } else { 1f64.copysign(z) };
        let damper = power(self.damper, w)
            * match self.coupling {
                Coupling::Printed => 1.0,
                Coupling::Mended => sign(w),
            };
        [w, (force_n - damper - sign(x) * power(self.spring, x)) / self.mass_kg]
    }

    /// A.8: one Runge-Kutta step.
    fn step(&self, y: [f64; 2], force_n: f64, dt_s: f64) -> [f64; 2] {
        let ahead = |k: [f64; 2], part: f64| [y[0] + part * k[0], y[1] + part * k[1]];
        let k1 = self.rate(y, force_n);
        let k2 = self.rate(ahead(k1, 0.5 * dt_s), force_n);
        let k3 = self.rate(ahead(k2, 0.5 * dt_s), force_n);
        let k4 = self.rate(ahead(k3, dt_s), force_n);
        std::array::from_fn(|i| y[i] + dt_s * ((k1[i] + k4[i]) / 6.0 + (k2[i] + k3[i]) / 3.0))
    }
}

/// Run the listing's contact phase with steps of `dt_s` and at most `steps_max` of them.
///
/// # Errors
/// A [`Refusal`] when it does not come to an end, or blows up.
pub fn contact(
    scene: &Scene,
    dt_s: f64,
    coupling: Coupling,
    steps_max: usize,
) -> Result<Answer, Refusal> {
    let faces = Faces::of(scene);
    let (r, m_p) = (scene.projectile.tip_radius_m, scene.projectile.mass_kg);
    let (strength, drag) = (scene.target.flow_strength_pa, scene.drag_kg_m3());
    let plate = (scene.plate.mount == Mount::Sprung).then(|| plate_of(scene, coupling));
    let cos = match coupling {
        Coupling::Printed => 1.0,
        Coupling::Mended => faces.cos,
    };
    let start_m = if plate.is_some() { 0.0 - scene.plate.cocking_m } else { 0.0 };
    let stop_m = scene.mechanism.stop.position_m.filter(|_| plate.is_some());
    let (mut pen, mut v, mut y, mut force_before) =
        (0.0, scene.projectile.velocity_m_s, [start_m, 0.0], 0.0);
    let (mut travel, mut slip, mut last_increment, mut deepest) = (0.0, v, 0.0, 0.0);
    for i in 0..steps_max {
        pen += v * dt_s;
        travel += slip * dt_s;
        let depth = match coupling {
            Coupling::Printed => faces.depth(pen / r) * r - last_increment,
            Coupling::Mended => faces.depth(travel / r) * r,
        };
        if depth < 0.0 {
            return Err(Refusal::Separated);
        }
        let area = faces.area_at_depth(depth / r) * r * r;
        let force = area * (drag * slip * slip + strength);
        v -= dt_s * 0.5 * (force + force_before) / m_p;
        force_before = force;
        deepest = if depth > deepest { depth } else { deepest };
        if let Some(plate) = &plate {
            let next = plate.step(y, force * cos, dt_s);
            last_increment = next[0] - y[0];
            y = next;
        }
        slip = v - cos * y[1];
        if !(force.is_finite() && slip.is_finite() && y[0].is_finite()) {
            return Err(Refusal::NonFinite);
        }
        if stop_m.is_some_and(|stop| y[0] >= stop) {
            return Err(Refusal::StopWithinContact);
        }
        if slip < SLOW_M_S || area <= 0.0 {
            let ending = if area <= 0.0 { Ending::Perforation } else { Ending::Arrest };
            let (steps, evaluations) = (i + 1, 5 * (i + 1));
            let t_s = steps as f64 * dt_s;
            return Ok(Answer { ending, t_s, depth_m: deepest, steps, rejected: 0, evaluations });
        }
    }
    Err(Refusal::StepBudget)
}

fn plate_of(scene: &Scene, coupling: Coupling) -> Plate {
    let (spring, damper) = (scene.mechanism.spring, scene.mechanism.damper);
    Plate {
        mass_kg: scene.plate_mass_kg(),
        spring: (spring.coefficient, spring.exponent),
        damper: (damper.coefficient, damper.exponent),
        coupling,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The constants of the listing on a plate of the thesis: 2024 aluminium, twice 75.8 `MPa`.
    fn listing() -> Scene {
        let mut scene = Scene::default();
        scene.target.density_kg_m3 = 2780.0;
        scene.target.flow_strength_pa = 2.0 * 75.8e6;
        scene
    }

    fn depth_mm(scene: &Scene, dt_s: f64, coupling: Coupling) -> f64 {
        contact(scene, dt_s, coupling, 1_000_000).unwrap().depth_m * 1e3
    }

    #[test]
    fn valid_time_step_ladder_of_the_listing_on_a_rigid_plate() {
        let mut scene = listing();
        scene.plate.mount = Mount::Rigid;
        let ladder = [(2e-6, 7.1809), (1e-6, 7.1519), (5e-7, 7.1375), (2e-7, 7.1289)];
        for (dt_s, expected) in ladder {
            for coupling in [Coupling::Printed, Coupling::Mended] {
                let depth = depth_mm(&scene, dt_s, coupling);
                assert!((depth - expected).abs() < 6e-5, "{dt_s}: {depth}");
            }
        }
    }

    #[test]
    fn valid_share_of_the_baseline_with_and_without_the_coupling_error() {
        let printed = depth_mm(&listing(), 1e-6, Coupling::Printed) / 7.129 * 100.0;
        assert!((printed - 82.4).abs() < 0.06, "{printed}");
        let mended = depth_mm(&listing(), 1e-6, Coupling::Mended) / 7.129 * 100.0;
        assert!((mended - 64.4).abs() < 0.06, "{mended}");
    }

    #[test]
    fn valid_depths_of_a_cocked_plate() {
        let expected = [(0.01, 5.769, 4.468), (0.1, 5.025, 3.560), (0.5, 2.856, 1.686)];
        for (cocking_m, printed, mended) in expected {
            let mut scene = listing();
            scene.plate.cocking_m = cocking_m;
            let depth = depth_mm(&scene, 1e-6, Coupling::Printed);
            assert!((depth - printed).abs() < 2e-3, "{cocking_m}: {depth}");
            let depth = depth_mm(&scene, 1e-6, Coupling::Mended);
            assert!((depth - mended).abs() < 2e-3, "{cocking_m}: {depth}");
        }
    }

    #[test]
    fn a_short_budget_and_a_stop_are_told() {
        let mut scene = listing();
        assert_eq!(contact(&scene, 1e-6, Coupling::Printed, 20), Err(Refusal::StepBudget));
        scene.mechanism.stop.position_m = Some(1e-3);
        let refused = contact(&scene, 1e-6, Coupling::Mended, 1_000);
        assert_eq!(refused, Err(Refusal::StopWithinContact));
    }
}
