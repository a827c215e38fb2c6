//! Fronts of scenes whose answer is known.

use super::*;
use crate::study::context::never_cancel;
use crate::study::envelope::{self, Direction};
use crate::study::run_with;
use crate::study::testing::{axes, scene};
use cmra_engine::model::run::RunWarning;
use cmra_engine::model::simulate::Settings;

fn request(list: &[(&str, f64, f64)], minimise: &[&str]) -> Request {
    Request {
        over: axes(list),
        objectives: minimise.iter().map(|name| Objective::new(name, false).unwrap()).collect(),
        subject_to: Vec::new(),
        is_feasible: false,
        samples: 1024,
    }
}

fn at_most(name: &str, bound: f64) -> Constraint {
    Constraint { measure: named(name).unwrap(), at_most: true, bound }
}

fn solve(scene: &Scene, request: &Request) -> FrontReport {
    run(scene, request, &mut Context::new(2, &mut never_cancel)).unwrap()
}

/// A free plate: depth falls and travel of the projectile's momentum rises as gamma falls, so every gamma is on the front; with
/// depth and mass together only the lightest is.
#[test]
fn valid_front_of_a_free_plate() {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    let both = ["final_penetration_m", "first_arrest_plate_velocity_m_s"];
    let front = solve(&scene, &request(&[("gamma", 0.8, 7.0)], &both));
    assert!(front.designs.len() > 90);
    for design in &front.designs {
        let exact = 100.0 / (1.0 + design.values[0]);
        assert!((design.measures[1].unwrap() - exact).abs() < 1e-6 * exact);
    }
    let gammas = || front.designs.iter().map(|design| design.values[0]);
    assert_eq!((gammas().fold(9.0, f64::min), gammas().fold(0.0, f64::max)), (0.8, 7.0));
    let light = ["final_penetration_m", "plate_mass_kg"];
    let front = solve(&scene, &request(&[("gamma", 0.8, 7.0)], &light));
    assert!(matches!(&front.designs[..], [only] if only.values == [0.8]), "{:?}", front.designs);
}

#[test]
fn constraints_are_kept() {
    let bounds = [("gamma", 0.8, 7.0), ("k", 1e4, 7.5e6)];
    let mut asked = request(&bounds, &["final_penetration_m", "peak_mount_force_n"]);
    asked.subject_to = vec![at_most("stroke_m", 0.01)];
    let found = solve(&Scene::default(), &asked);
    assert!(!found.designs.is_empty());
    assert!(found.designs.iter().all(|design| design.measures[2].unwrap() <= 0.01));
    asked.subject_to.push(at_most("plate_mass_kg", 1e-3));
    assert!(solve(&Scene::default(), &asked).designs.is_empty());
}

/// Cocked plates are struck while the spring pulls: what the fused interface cannot carry in tension is no more feasible than what
/// it cannot carry in compression, by the warnings of the designs' own runs. Beside a design whose interface gives way stands what
/// the plastic one comes to.
#[test]
fn feasible_designs_have_no_warning_on_the_unsafe_side() {
    let bounds = [("gamma", 3.5, 7.0), ("k", 1e3, 7.5e6), ("d", 0.0, 0.5)];
    let mut asked = request(&bounds, &["final_penetration_m", "stroke_m"]);
    let scene = scene("own_mass=counted");
    let fails = |asked: &Request| {
        let front = solve(&scene, asked);
        assert!(!front.designs.is_empty());
        let fails = |design: &&Design| {
            let run = run_with(&front.scene(design), Settings::default()).unwrap();
            let is_overloaded = run.warnings.iter().any(|warning| {
                matches!(
                    warning,
                    RunWarning::InterfacePush { .. } | RunWarning::InterfacePull { .. }
                )
            });
            assert!(!is_overloaded || design.plastic.is_some(), "{design:?}");
            envelope::of_run(&run).iter().any(|it| it.direction == Direction::Unconservative)
        };
        front.designs.iter().filter(fails).count()
    };
    assert!(fails(&asked) > 5);
    asked.is_feasible = true;
    assert_eq!(fails(&asked), 0);
}
