//! The two engines beside each other on random scenes: the one that answers, and the one that estimates its errors.

use std::sync::Arc;

use cmra::model::impact::Stepping;
use cmra::model::impact::step_by;
use cmra::model::run::Run;
use cmra::model::scene::{InterfaceLaw, Scene};
use cmra::model::simulate::{Settings, simulate};

use crate::oracle::draw;
use crate::random::{Random, scene, typed};

/// Scenes of each sort.
const SCENES: usize = 1_500;
/// Agreement that is counted, relative.
const CLOSE: [f64; 2] = [1e-8, 1e-9];
/// Part of the impact velocity, and of a metre, below which differences of what passes through zero are not relative to it.
const NO_SPEED: f64 = 1e-3;
const NO_WAY_M: f64 = 1e-6;

/// What is compared: name, value, and the least size it is relative to.
fn results(run: &Run) -> Vec<(&'static str, Option<f64>, f64)> {
    let speed = NO_SPEED * run.scene.projectile.velocity_m_s;
    let way = NO_WAY_M + run.scene.start_m().abs();
    let arrest = run.first_arrest;
    vec![
        ("first arrest", arrest.map(|arrest| arrest.penetration_m), 0.0),
        ("time of first arrest", arrest.map(|arrest| arrest.t_s), 0.0),
        ("displacement at first arrest", arrest.map(|arrest| arrest.plate_displacement_m), way),
        ("velocity at first arrest", arrest.map(|arrest| arrest.plate_velocity_m_s), speed),
        ("depth", run.final_penetration_m, 0.0),
        ("contact force", run.peak_contact_force_n, 0.0),
        ("displacement", run.max_plate_displacement_m, way),
        ("residual velocity", run.residual_velocity_m_s, speed),
        ("time of exit", run.exit_time_s, 0.0),
        ("time of separation", run.separation.map(|it| it.t_s), 0.0),
        ("velocity of separation", run.separation.map(|it| it.velocity_m_s), speed),
        ("interface demand", run.interface_demand_ratio, 0.0),
    ]
}

/// Greatest relative difference of two runs, and of which result.
fn difference(one: &Run, other: &Run) -> (&'static str, f64) {
    let pairs = results(one).into_iter().zip(results(other));
    let differences = pairs.filter_map(|((name, a, least), (_, b, _))| {
        let (a, b) = (a?, b?);
        Some((name, (a - b).abs() / b.abs().max(least)))
    });
    differences.fold(("nothing", 0.0), |most, one| if one.1 > most.1 { one } else { most })
}

fn compare(words: &[(String, Arc<Scene>)]) {
    let (mut close, mut alike, mut decided, mut steps) = ([0; 2], 0, 0, [0; 2]);
    for (typed, scene) in words {
        let go_on = &mut |_: f64| std::ops::ControlFlow::Continue(());
        let one = simulate(scene, &Settings::BARE, go_on).unwrap();
        let Some(other) = step_by(Stepping::Collocation(1e-12), scene).unwrap() else { continue };
        if !(one.end.is_complete() && other.end.is_complete()) {
            println!("{:?} and {:?}: {typed}", one.end, other.end);
            continue;
        }
        decided += 1;
        steps = [steps[0] + one.cost.steps, steps[1] + other.cost.steps];
        if one.outcome != other.outcome {
            println!("{} and {}: {typed}", one.outcome, other.outcome);
            continue;
        }
        alike += 1;
        let (name, off) = difference(&one, &other);
        for (close, most) in close.iter_mut().zip(CLOSE) {
            *close += usize::from(off <= most);
        }
        if off > CLOSE[1] {
            println!("{name} differs by {off:.1e}: {typed}");
        }
    }
    println!(
        "{decided} of {} decided by both, {alike} alike; {close:?} within {CLOSE:?}; {steps:?} steps",
        words.len()
    );
    assert!(100 * decided > 97 * words.len() && 100 * alike > 98 * decided);
    assert!(1000 * close[0] > 990 * alike, "{close:?} of {alike}");
}

/// Both on scenes as a way to draw them has them.
fn compare_drawn(seed: u64, draw: fn(&mut Random) -> String) {
    let mut random = Random(seed);
    let mut one = || {
        let typed = draw(&mut random);
        let scene = Arc::new(draw::read(&typed));
        (typed, scene)
    };
    compare(&(0..SCENES).map(|_| one()).collect::<Vec<_>>());
}

#[test]
#[ignore = "takes minutes: some thousand scenes by both engines"]
fn the_two_engines_agree_on_moderate_scenes() {
    compare_drawn(5_001, draw::plain);
}

#[test]
#[ignore = "takes minutes: some thousand scenes by both engines"]
fn the_two_engines_agree_on_springs_of_every_kind() {
    compare_drawn(5_003, draw::curved);
}

#[test]
#[ignore = "takes minutes: some thousand scenes by both engines"]
fn the_two_engines_agree_on_every_contact_model() {
    compare_drawn(5_004, draw::modelled);
}

#[test]
#[ignore = "takes minutes: some thousand scenes by both engines"]
fn the_two_engines_agree_on_demanding_scenes() {
    let mut random = Random(5_002);
    let mut one = |index: usize| {
        let changes = random.changes();
        let mut own = Scene::clone(&scene(&changes));
        own.run.tolerance = 1e-9;
        let is_plastic = index.is_multiple_of(3);
        if is_plastic {
            own.interface.law = InterfaceLaw::Plastic;
        }
        let law = if is_plastic { " --set interface=plastic" } else { "" };
        (format!("{}{law}", typed(&changes)), Arc::new(own))
    };
    compare(&(0..SCENES).map(&mut one).collect::<Vec<_>>());
}
