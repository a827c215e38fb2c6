//! Fronts of scenes whose answer is known.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::*;
use crate::model::run::Warning;
use crate::model::simulate::{Settings, simulate};
use crate::study::context::{to_its_end, until};
use crate::study::testing::axes;

const EFFORT: EvolutionOptions = EvolutionOptions { population: 40, generations: 30, seed: 1 };

fn task(list: &[(&str, f64, f64)], minimise: &[&str]) -> Task {
    Task {
        axes: axes(list),
        objectives: objectives(minimise, &[] as &[&str]).unwrap(),
        constraints: Vec::new(),
        laws: vec![InterfaceLaw::Fused],
        effort: EFFORT,
    }
}

fn at_most(name: &str, bound: f64) -> Constraint {
    Constraint { measure: named(name).unwrap(), at_most: true, bound, is_feasibility: false }
}

fn solve(scene: &Scene, task: &Task) -> Vec<Front> {
    optimise(scene, task, &mut Context::new(2, &mut to_its_end)).unwrap()
}

/// A free plate: depth falls and travel of the projectile's momentum rises as gamma falls, so every gamma is on the front; with
/// depth and mass together only the lightest is.
#[test]
fn valid_front_of_a_free_plate() {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    let both = ["final_penetration_m", "first_arrest_plate_velocity_m_s"];
    let found = solve(&scene, &task(&[("gamma", 0.8, 7.0)], &both));
    let front = &found[0];
    assert!(front.designs.len() > 30 && front.is_complete && front.generations == 30);
    for design in &front.designs {
        let exact = 100.0 / (1.0 + design.values[0]);
        assert!((design.measures[1].unwrap() - exact).abs() < 1e-6 * exact);
    }
    let gammas: Vec<f64> = front.designs.iter().map(|design| design.values[0]).collect();
    let (least, most) =
        (gammas.iter().copied().fold(9.0, f64::min), gammas.iter().copied().fold(0.0, f64::max));
    assert!(least < 0.85 && most > 6.9, "{least} {most}");
    let light =
        solve(&scene, &task(&[("gamma", 0.8, 7.0)], &["final_penetration_m", "plate_mass_kg"]));
    assert_eq!(light[0].designs.len(), 1);
    assert!((light[0].designs[0].values[0] - 0.8).abs() < 1e-3);
}

#[test]
fn the_designs_of_the_thesis_stand_on_it_or_off_it() {
    let bounds = [("gamma", 0.8, 7.0), ("d", 0.0, 0.5), ("k", 1e3, 7.5e6), ("n", 0.1, 3.0)];
    let mut asked = task(&bounds, &USUAL);
    asked.laws = vec![InterfaceLaw::Fused, InterfaceLaw::Plastic];
    asked.effort = EvolutionOptions { population: 40, generations: 8, seed: 3 };
    let found = solve(&Scene::default(), &asked);
    assert_eq!(found.iter().map(|front| front.law).collect::<Vec<_>>(), asked.laws);
    let front = &found[0];
    assert_eq!(front.candidates.len(), 1 + RECOMMENDED.len());
    for candidate in &front.candidates {
        let value = |at: usize| candidate.measures[at];
        match candidate.standing {
            Standing::Dominated { by } => {
                let better = &front.designs[by].measures;
                let pairs: Vec<(f64, f64)> =
                    (0..4).map(|at| (better[at].unwrap(), value(at).unwrap())).collect();
                assert!(pairs.iter().all(|(a, b)| a <= b) && pairs.iter().any(|(a, b)| a < b));
            }
            Standing::OnFront => assert!(value(0).is_some()),
            // The stop is hit: the force on the mount has no bound.
            Standing::NoValue(_) => assert_eq!(candidate.name, "stopped"),
            Standing::Breaks(_) | Standing::Impossible => panic!("{candidate:?}"),
        }
    }
    // Cocked all the way the plastic interface gives way.
    let all_the_way = &found[1].candidates[3];
    assert_eq!(all_the_way.name, "cocked, all the way");
    assert!(matches!(all_the_way.standing, Standing::NoValue(_)), "{all_the_way:?}");
}

#[test]
fn constraints_are_kept() {
    let bounds = [("gamma", 0.8, 7.0), ("k", 1e4, 7.5e6)];
    let mut asked = task(&bounds, &["final_penetration_m", "peak_mount_force_n"]);
    asked.constraints = vec![at_most("stroke_m", 0.01), at_most("plate_mass_kg", 1e-3)];
    // The scene itself breaks both.
    assert_eq!(
        solve(&Scene::default(), &asked)[0].candidates[0].standing,
        Standing::Breaks(vec![0, 1])
    );
    asked.constraints.pop();
    let found = solve(&Scene::default(), &asked);
    assert!(!found[0].designs.is_empty());
    assert!(found[0].designs.iter().all(|design| design.measures[2].unwrap() <= 0.01));
    assert_eq!(found[0].candidates[0].standing, Standing::Breaks(vec![0]));
}

#[test]
fn a_front_shows_its_parts_and_keeps_them_when_stopped() {
    let list = [("gamma", 0.8, 7.0), ("k", 1e3, 7.5e6)];
    let effort = EvolutionOptions { population: 20, generations: 20, seed: 1 };
    let task = Task { effort, ..task(&list, &["final_penetration_m", "stroke_m"]) };
    let (mut parts, mut stop) = (0, until::<Front>(200));
    let watch = &mut |progress, front: Option<&Front>| {
        parts += usize::from(front.is_some());
        stop(progress, front)
    };
    let fronts = optimise(&Scene::default(), &task, &mut Context::new(1, watch)).unwrap();
    let front = &fronts[0];
    assert!(parts >= 8 && !front.is_complete && !front.designs.is_empty(), "{parts}");
    assert!(front.runs > 200 && front.runs < 420);
}

/// The heaviest free plate that keeps a depth of 4.568088344392 mm weighs as much as the projectile (model page, section 2).
#[test]
fn valid_greatest_mass_under_a_constraint() {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    let mut heavy = task(&[("gamma", 0.3, 7.0)], &[]);
    heavy.objectives = objectives(&[] as &[&str], &["plate_mass_kg"]).unwrap();
    heavy.constraints = vec![at_most("final_penetration_m", 4.568_088_344_392e-3)];
    let found = solve(&scene, &heavy);
    let design = &found[0].designs[0];
    assert!((design.values[0] - 1.0).abs() < 1e-7, "{design:?}");
    assert!(design.measures[1].unwrap() <= 4.568_088_344_392e-3);
}

/// Cocked plates are struck while the spring pulls: what the fused interface cannot carry in tension is no more feasible than what
/// it cannot carry in compression, by the warnings of the designs' own runs.
#[test]
fn feasible_designs_break_no_interface() {
    let bounds = [("gamma", 0.8, 7.0), ("k", 1e3, 7.5e6), ("d", 0.0, 0.5)];
    let mut asked = task(&bounds, &["final_penetration_m", "stroke_m"]);
    asked.effort = EvolutionOptions { population: 20, generations: 6, seed: 1 };
    let breaches = |asked: &Task| {
        let front = &solve(&Scene::default(), asked)[0];
        assert!(front.designs.len() > 5);
        let breaks = |design: &&Design| {
            let (scene, settings) = (front.scene(asked, design), Settings::default());
            let run = simulate(&Arc::new(scene), &settings, &mut |_| ControlFlow::Continue(()));
            let of_interface = |warning: &Warning| {
                matches!(warning, Warning::InterfacePush { .. } | Warning::InterfacePull { .. })
            };
            run.unwrap().warnings.iter().any(of_interface)
        };
        front.designs.iter().filter(breaks).count()
    };
    assert!(breaches(&asked) > 5);
    asked.constraints = feasibility().collect();
    assert_eq!(breaches(&asked), 0);
}
