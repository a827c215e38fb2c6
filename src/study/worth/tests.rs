//! The comparison against closed forms.

use super::*;
use crate::model::units::Bare;

fn report(pairs: &str, masses: Masses) -> Report {
    let mut scene = Scene::default();
    for pair in pairs.split_whitespace() {
        let (name, value) = pair.split_once('=').unwrap();
        variables::set_by_name(&mut scene, name, value, Bare::Si).unwrap();
    }
    compare(&Arc::new(scene), masses, &mut |_, _| ControlFlow::Continue(())).unwrap()
}

fn plain(pairs: &str) -> Report {
    report(pairs, Masses::default())
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a / b - 1.0).abs() <= relative
}

#[test]
fn valid_depths_and_limits_of_the_model_page() {
    let found = plain("");
    let (rigid, free) = (found.of(Candidate::Rigid).unwrap(), found.of(Candidate::Free).unwrap());
    assert!((rigid.depth_m.unwrap() - 7.113_055e-3).abs() < 5e-10);
    assert!(close(free.depth_m.unwrap(), 4.568_088_344_392e-3, 1e-12));
    assert!((rigid.limit.velocity_m_s().unwrap() - 232.295_378).abs() < 5e-7);
    assert!((free.limit.velocity_m_s().unwrap() - 347.708_052).abs() < 5e-7);
    // Momentum: a rigid mount takes all of it; nothing holds a free plate.
    assert!(close(rigid.impulse_n_s.unwrap(), 2.95, 1e-15));
    assert!(free.impulse_n_s.is_none() && free.mount_force_n.is_none() && free.stroke_m.is_none());
    assert!(found.is_complete);
}

#[test]
fn a_rigid_plate_is_its_own_solid_plate() {
    for pairs in ["", "theta=30deg", "C_d=0", "h=3mm"] {
        let found = plain(pairs);
        let rigid = found.of(Candidate::Rigid).unwrap();
        assert!(close(rigid.mass_efficiency.unwrap(), 1.0, 1e-12), "{pairs} {rigid:?}");
        let solid = found.of(Candidate::Solid).unwrap();
        assert!(close(solid.mass_efficiency.unwrap(), 1.0, 1e-12), "{pairs} {solid:?}");
        let own = found.of(Candidate::Scene).unwrap();
        assert!(close(solid.areal_kg_m2.unwrap(), own.areal_kg_m2.unwrap(), 1e-15));
    }
}

/// Without dishing a passage takes the volume pi R² h, and the limit depends on volume over reduced mass alone: a free plate is
/// worth a rigid one thicker by 1 + 1/gamma, with drag or without.
#[test]
fn a_free_plate_is_worth_one_plus_one_over_gamma() {
    for (pairs, gamma) in [("gamma=1 C_d=0", 1.0), ("gamma=1", 1.0), ("gamma=4", 4.0)] {
        let found = plain(&format!("dishing=false {pairs}"));
        let free = found.of(Candidate::Free).unwrap();
        assert!(close(free.mass_efficiency.unwrap(), 1.0 + 1.0 / gamma, 1e-12), "{pairs}");
    }
}

/// After the arrest plate and projectile swing as one; at the turn all of it is in the spring.
#[test]
fn the_spring_stores_what_the_swing_brings() {
    let found = plain("k=1e5");
    let own = found.of(Candidate::Scene).unwrap();
    let farthest = own.back_face_m.unwrap();
    assert!(close(own.mount_force_n.unwrap(), 1e5 * farthest, 1e-12));
    assert!(close(found.spring_energy_j.unwrap(), 0.5e5 * farthest * farthest, 1e-12));
    // At the turn both bodies are at rest: the mount has all of the momentum.
    assert!(close(own.impulse_n_s.unwrap(), 2.95, 1e-6), "{:?}", own.impulse_n_s);
    assert!(close(found.spring_kg.unwrap(), 5.081e-3 * found.spring_energy_j.unwrap(), 1e-3));
    assert!(found.depth_over_solid().unwrap() < 1.0);
}

#[test]
fn areal_mass_is_all_mass_over_the_face_of_the_plate() {
    let masses = Masses { spring_kg: Some(0.0295), mount_kg: 0.0295 };
    let found = report("gamma=2", masses);
    // Spring and mount weigh as much as the plate: twice the thickness.
    let solid = found.of(Candidate::Solid).unwrap();
    assert!(close(solid.scene.target.thickness_m, 2.0 * 0.0254, 1e-14));
    assert!(close(found.face_m2 * 2710.0 * 0.0254, 0.059, 1e-14));
    assert!(found.of(Candidate::Scene).unwrap().mass_efficiency.unwrap() < 1.0);
}

#[test]
fn preload_is_the_energy_of_the_cocked_spring_and_a_rigid_stop_has_no_greatest_force() {
    let found = plain("k=1e5 d=5mm");
    let own = found.of(Candidate::Scene).unwrap();
    assert!(close(own.preload_j.unwrap(), 0.5 * 1e5 * 25e-6, 1e-14));
    assert!(close(own.stroke_m.unwrap(), own.back_face_m.unwrap() + 5e-3, 1e-14));
    let stopped = plain("k=1e5 x_stop=5mm");
    assert!(stopped.of(Candidate::Scene).unwrap().mount_force_n.is_none());
}

#[test]
fn what_does_not_exist_is_absent() {
    let found = plain("k=0 b=0");
    let own = found.of(Candidate::Scene).unwrap();
    assert!(own.stroke_m.is_none() && own.preload_j.is_none() && own.mount_force_n.is_none());
    // No spring, no mass of a spring: the solid plate is the rigid one.
    assert_eq!(found.spring_kg, Some(0.0));
    let perforated = plain("v_i=400");
    let own = perforated.of(Candidate::Rigid).unwrap();
    assert!(own.depth_m.is_none() && own.residual_m_s.is_some());
    let mut asked = 0;
    let stop = &mut |_, _| {
        asked += 1;
        if asked > 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let cut = compare(&Arc::new(Scene::default()), Masses::default(), stop).unwrap();
    assert!(!cut.is_complete && cut.entries.is_empty());
}
