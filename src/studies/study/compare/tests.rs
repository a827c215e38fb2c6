//! The comparison against closed forms.

use super::*;
use crate::study::compare::map::{Map, default_axis};
use crate::study::context::{never_cancel, until};
use crate::study::quantities::find;
use crate::study::run_with;
use crate::study::sweep::{Axis, Spacing};
use crate::study::testing::scene;
use cmra_engine::model::simulate::Settings;

/// tau²/(4 rho G) of a steel coil: 7e8² / (4 * 7850 * 7.93e10) J/kg, by hand.
const STEEL_COIL_J_PER_KG: f64 = 196.7856;

fn plain(pairs: &str) -> ComparisonReport {
    let scene = Arc::new(scene(pairs));
    compare(&scene, Hardware::default(), &mut Context::new(1, &mut never_cancel)).unwrap()
}

/// Returns a quantity of the shot at the design velocity.
fn value(entry: &Entry, name: &str) -> f64 {
    find(name).unwrap().value(&entry.run).unwrap()
}

fn efficiency(pairs: &str) -> f64 {
    mass_efficiency(&scene(pairs), Hardware::default()).unwrap()
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a / b - 1.0).abs() <= relative
}

/// Closed form of the module documentation, for a mass ratio, an impact velocity, m/s, and an energy per mass, J/kg.
fn closed_form(gamma: f64, v: f64, e: f64) -> f64 {
    (1.0 + 1.0 / gamma) / (1.0 + v * v / (2.0 * gamma * (1.0 + gamma) * e))
}

/// Without dishing on a soft spring the comparison of runs is the closed form, whatever the plate's own thickness.
#[test]
fn a_soft_spring_without_dishing_pays_as_the_closed_form_says() {
    assert!((efficiency("dishing=false k=1 v_i=28.06") - 1.0).abs() < 5e-4);
    for (pairs, gamma, v) in [
        ("v_i=10", 1.0, 10.0),
        ("v_i=28.06 h=3mm", 1.0, 28.06),
        ("v_i=30 h=100mm", 1.0, 30.0),
        ("v_i=50 gamma=4", 4.0, 50.0),
        ("v_i=100 C_d=0", 1.0, 100.0),
    ] {
        let expected = closed_form(gamma, v, STEEL_COIL_J_PER_KG);
        let found = efficiency(&format!("dishing=false k=1 {pairs}"));
        assert!(close(found, expected, 1e-5), "{pairs}: {found} {expected}");
    }
    // A better absorber pays up to a higher velocity. Break-even is at (4 e)^(1/2).
    let at = |v: f64| efficiency(&format!("dishing=false k=1 e_spring=1e4 v_i={v}"));
    assert!(close(at(200.0), 1.0, 1e-5) && at(150.0) > 1.0 && at(250.0) < 1.0);
}

/// The capacity of a spring is proportional to its mass; the stored energy is proportional to v² (soft spring, shared momentum).
#[test]
fn a_spring_of_twice_the_mass_holds_the_shot_with_twice_the_energy() {
    let one = plain("k=1e3 v_i=20").entry(Candidate::Scene).unwrap().spring_kg.unwrap();
    let with = |times: f64| plain(&format!("k=1e3 v_i=20 m_spring={}", times * one));
    let limit = with(2.0).entry(Candidate::Scene).unwrap().limit_m_s.unwrap();
    assert!(close(limit, 20.0 * 2f64.sqrt(), 1e-4), "{limit}");
    // Half of that mass does not suffice for the design shot.
    let half = with(0.5);
    assert_eq!(half.entry(Candidate::Scene).unwrap().failure.unwrap().word, "spring full");
    assert_eq!(half.verdict().pays(), Some(false));
    assert!(half.entry(Candidate::Scene).unwrap().sized.is_err());
}

/// With the plastic interface, runs of some thicker plates end undecided. The thickness found stops the shot, a slightly smaller one does
/// not. In the second case every plate from a thickness of 0.432 mm on stops it.
#[test]
fn undecided_runs_of_thicker_plates_do_not_hide_the_thinnest_that_stops_the_shot() {
    let sized = |pairs: &str| sizing::sized(&scene(pairs), Hardware::default()).unwrap();
    let found = sized("interface=plastic v_i=84 gamma=4");
    let outcome = |thickness: f64| {
        let mut scene = found.scene.as_ref().clone();
        scene.target.thickness_m *= thickness;
        run_with(&scene, Settings::SERIES).unwrap().outcome
    };
    assert_eq!([1.0, 0.999].map(outcome), [Outcome::Arrested, Outcome::Perforated], "{found:?}");
    let found = sized("interface=plastic v_i=44 gamma=6");
    assert!(found.scene.target.thickness_m < 0.432e-3 && found.mass_efficiency() > 1.04);
}

#[test]
fn a_rigid_plate_is_its_own_solid_plate() {
    for pairs in ["", "theta=30deg", "C_d=0", "h=3mm"] {
        let found = plain(pairs);
        let rigid = found.entry(Candidate::Rigid).unwrap();
        assert!(close(rigid.mass_efficiency().unwrap(), 1.0, 1e-8), "{pairs} {rigid:?}");
        let solid = found.entry(Candidate::Solid).unwrap();
        let own = found.entry(Candidate::Scene).unwrap();
        assert!(close(solid.areal_kg_m2.unwrap(), own.areal_kg_m2.unwrap(), 1e-15));
    }
}

/// Without dishing a perforation takes the volume pi R² h, and the limit depends on volume over reduced mass alone. A free plate is
/// equivalent to a rigid plate thicker by the factor 1 + 1/gamma, with or without drag.
#[test]
fn a_free_plate_is_worth_one_plus_one_over_gamma() {
    for (pairs, gamma) in [("gamma=1 C_d=0", 1.0), ("gamma=1", 1.0), ("gamma=4", 4.0)] {
        let found = plain(&format!("dishing=false {pairs}"));
        let free = found.entry(Candidate::Free).unwrap();
        assert!(close(free.mass_efficiency().unwrap(), 1.0 + 1.0 / gamma, 1e-8), "{pairs}");
    }
}

/// A heavy projectile that any touch drives through a plate that comes towards it is limited by that plate's own velocity: a slower one
/// does not reach it.
#[test]
fn a_shot_too_slow_to_reach_the_plate_is_no_cancelled_one() {
    let report = plain("w_0=5 S_y=1.5e6 m_p=40");
    assert_eq!(report.entries.len(), Candidate::ALL.len());
    let own = report.entry(Candidate::Scene).unwrap();
    assert!(close(own.perforation.velocity_m_s().unwrap(), 5.0, 1e-8), "{:?}", own.perforation);
    assert!(own.at_limit.is_none());
}

/// After the arrest plate and projectile oscillate together; at the turning point the spring stores all of their kinetic energy.
#[test]
fn the_spring_stores_what_the_swing_brings() {
    let found = plain("k=1e5");
    let own = found.entry(Candidate::Scene).unwrap();
    let farthest = value(own, "max_plate_displacement_m");
    let stored = value(own, "stored_energy_j");
    assert!(close(value(own, "peak_mount_force_n"), 1e5 * farthest, 1e-12));
    assert!(close(stored, 0.5e5 * farthest * farthest, 1e-12));
    // At the turning point both bodies are at rest: the mount has received the whole momentum.
    assert!(close(value(own, "mount_impulse_n_s"), 2.95, 1e-6));
    assert!(close(own.spring_kg.unwrap(), 5.081e-3 * stored, 1e-3));
    assert!(found.depth_over_solid().unwrap() < 1.0);
}

#[test]
fn areal_mass_is_all_mass_over_the_face_of_the_plate() {
    let found = plain("gamma=2 m_spring=0.059");
    // The spring weighs as much as the plate, so the solid plate has twice the thickness.
    let solid = found.entry(Candidate::Solid).unwrap();
    assert!(close(solid.run.scene.target.thickness_m, 2.0 * 0.0254, 1e-14));
    assert!(close(found.face_m2 * 2710.0 * 0.0254, 0.059, 1e-14));
    let areal = found.entry(Candidate::Scene).unwrap().areal_kg_m2.unwrap();
    assert!(close(areal, 2.0 * 2710.0 * 0.0254, 1e-14));
}

#[test]
fn preload_is_the_energy_of_the_cocked_spring_and_a_rigid_stop_has_no_greatest_force() {
    let found = plain("k=1e5 d=5mm");
    let own = found.entry(Candidate::Scene).unwrap();
    assert!(close(own.run.ledger.initial_spring_j, 0.5 * 1e5 * 25e-6, 1e-14));
    let farthest = value(own, "max_plate_displacement_m");
    assert!(close(value(own, "stroke_m"), farthest + 5e-3, 1e-14));
    let stopped = plain("k=1e5 x_stop=5mm");
    assert_eq!(stopped.uncounted, ["stop"]);
    let run = &stopped.entry(Candidate::Scene).unwrap().run;
    assert_eq!(find("peak_mount_force_n").unwrap().value(run), None);
}

#[test]
fn the_map_is_the_closed_form() {
    let axis = |name, ends, count| Axis::new(name, ends, count, Spacing::Linear).unwrap();
    let axes = [axis("v_i", (10.0, 90.0), 41), axis("gamma", (0.5, 7.0), 4)];
    let base = scene("dishing=false k=1");
    let compute = |threads: usize| {
        let mut watch = never_cancel;
        let context = &mut Context::new(threads, &mut watch);
        Map::compute(&base, &axes, Hardware::default(), context).unwrap()
    };
    let map = compute(1);
    assert!(map.is_complete());
    for y in 0..4 {
        let gamma = map.y().value(y);
        for x in [0, 20, 40] {
            let expected = closed_form(gamma, map.x().value(x), STEEL_COIL_J_PER_KG);
            assert!(close(map.cell(x, y).unwrap().unwrap(), expected, 1e-4));
        }
    }
    assert_eq!(map.cells, compute(2).cells, "no digit depends on the threads");
    let mut watch = until(20);
    let context = &mut Context::new(1, &mut watch);
    let cut = Map::compute(&base, &axes, Hardware::default(), context).unwrap();
    let computed = cut.cells.iter().flatten().count();
    assert!(!cut.is_complete() && computed == 27, "passes of 3, 3 and 5 points, a piece of 16");
    assert_eq!(cut.shown(5, 3), cut.cell(4, 2), "a coarser point stands for it");
    assert!(default_axis(&base, "gama", 5).is_err() && default_axis(&base, "x_stop", 5).is_err());
}

#[test]
fn the_limit_if_the_spring_survives_is_that_of_the_comparison() {
    let limit = |pairs: &str| limit_if_spring_survives_m_s(&scene(pairs)).unwrap();
    let pairs = "k=1e3 v_i=20 m_spring=10g";
    let compared = plain(pairs).entry(Candidate::Scene).unwrap().limit_m_s.unwrap();
    assert!(close(limit(pairs), compared, 1e-15));
    // A spring of unknown mass has no energy limit, so the limit is that of the plate alone.
    for pairs in ["k=1e3 h=3mm v_i=300", "mount=rigid"] {
        let own = crate::study::limit::velocity_m_s(&scene(pairs)).unwrap();
        assert!(close(limit(pairs), own, 1e-15), "{pairs}");
    }
    assert!((limit("mount=rigid") - 232.295_378).abs() < 5e-7);
    // A beam that is cocked beyond its yield survives no shot, however slow: also not the slowest that reaches the plate.
    for plate in ["", "w_0=5.895"] {
        let cocked = format!("spring=prbm-guided d=120mm v_i=60 gamma=5 {plate}");
        assert!(limit_if_spring_survives_m_s(&scene(&cocked)).is_err(), "{cocked}");
    }
    let beyond = limit_if_spring_survives_m_s(&scene("k=0 gamma=0.05")).unwrap_err();
    assert!(beyond.contains("beyond 3000 m/s"), "{beyond}");
}

/// A first pass computes every 16th row: the row nearest to row 31 is row 32, not row 16.
#[test]
fn a_partial_map_has_the_nearest_of_its_lines() {
    let free = scene("k=0");
    let axes = map::default_axes(&free).unwrap();
    let mut whole =
        Map::compute(&free, &axes, Hardware::Own, &mut Context::new(1, &mut never_cancel)).unwrap();
    for x in 0..41 {
        for y in 0..41 {
            let is_first = x % 16 == 0 && y % 16 == 0;
            whole.cells[x * 41 + y] = is_first.then_some(Ok(1.0));
        }
    }
    for (own, nearest) in [(0, 0), (7, 0), (9, 16), (31, 32), (40, 32)] {
        assert_eq!((whole.row(own).0, whole.column(own).0), (nearest, nearest), "{own}");
    }
}
