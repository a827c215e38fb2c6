//! Goals whose answer is known in closed form.

use std::f64::consts::PI;

use super::*;
use crate::study::context::never_cancel;
use crate::study::sweep::Spacing;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::Mount;
use cmra_oracle::assert_near;

fn goal(name: &str, ends: (f64, f64), measure: &str, target: f64) -> Request {
    let over = Axis::new(name, ends, 33, Spacing::Linear).unwrap();
    Request { over, goal: Goal { measure: named(measure).unwrap(), target } }
}

fn found(scene: &Scene, request: &Request) -> SeekReport {
    on(2, scene, request).unwrap()
}

fn on(threads: usize, scene: &Scene, request: &Request) -> Result<SeekReport, StudyError> {
    run(scene, request, &mut Context::new(threads, &mut never_cancel))
}

/// Swept volume for a depth p <= R of a hemisphere under dishing, m³.
fn volume(scene: &Scene, p: f64) -> f64 {
    let (r, h) = (scene.projectile.tip_radius_m, scene.target.thickness_m);
    (h + 2.0 * r) / h * PI * (r * p * p - p.powi(3) / 3.0)
}

/// On a rigid mount the velocity for a depth is v² = (S/c)(exp(2cV/m) - 1).
#[test]
fn valid_velocity_for_a_depth_on_a_rigid_mount() {
    let mut scene = Scene::default();
    scene.plate.mount = Mount::Rigid;
    for depth_m in [1e-3, 3e-3, 5.5e-3] {
        let (s, c) = (scene.target.flow_strength_pa, scene.drag_kg_m3());
        let exponent = 2.0 * c * volume(&scene, depth_m) / scene.projectile.mass_kg;
        let exact = (s / c * exponent.exp_m1()).sqrt();
        let report = found(&scene, &goal("v_i", (5.0, 150.0), "final_penetration_m", depth_m));
        assert_eq!(report.solutions().count(), 1, "{depth_m}");
        assert_near(report.solutions().next().unwrap().place.at, exact, 1e-9);
        assert_eq!(
            report.solutions().next().unwrap().outcome,
            Some(PointOutcome::Ended(Outcome::Arrested))
        );
        assert!(report.lines.len() == 1);
    }
}

/// Beyond the limit there is no depth: the gap is reported, and the depth just before it is still found.
#[test]
fn perforations_are_a_gap_and_not_a_number() {
    let mut scene = Scene::default();
    scene.plate.mount = Mount::Rigid;
    let report = found(&scene, &goal("v_i", (100.0, 400.0), "final_penetration_m", 0.02));
    assert_eq!(report.solutions().count(), 1);
    let gap = report.of_kind(Kind::Gap).last().unwrap();
    assert_eq!(
        (gap.outcome, gap.until.unwrap().at),
        (Some(PointOutcome::Ended(Outcome::Perforated)), 400.0)
    );
    assert!(
        gap.place.at > 232.295_378 && report.solutions().next().unwrap().place.at < 232.295_378
    );
}

/// A free plate of 6 kg/m² is 6/2710 m thick, and perforated.
#[test]
fn valid_areal_mass_of_a_plate_that_does_not_hold() {
    let scene = crate::study::testing::scene("k=0 v_i=300");
    let report = found(&scene, &goal("h", (1e-3, 5e-3), "areal_mass_kg_m2", 6.0));
    let solution = report.solutions().next().unwrap();
    assert_near(solution.place.at, 6.0 / 2710.0, 1e-9);
    assert_eq!(solution.outcome, Some(PointOutcome::Ended(Outcome::Perforated)));
}
