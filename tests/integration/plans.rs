//! The contact kernel, which sweeps take, against the engine, which integrates the whole run, over thousands of random scenes.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};

use crate::random::{Random, scene, typed};

const DRAWN: usize = 4_000;
const TOLERANCE: f64 = 1e-13;
/// Greatest relative difference of depth, or of the exit time.
const DIFFERENCE_MAX: f64 = 1e-9;
/// Fewer comparisons than this would say nothing.
const COMPARED_MIN: usize = 1_000;
const SEED: u64 = 0x91a5_2007;

/// Whether it is arrested, and the depth or the exit time.
type Measure = (bool, f64);

fn of_run(run: &Run) -> Option<Measure> {
    if let Some(arrest) = run.first_arrest {
        return Some((true, arrest.penetration_m));
    }
    run.departure.exit_time_s.map(|t_s| (false, t_s))
}

fn by_engine(scene: &Arc<Scene>) -> Option<Measure> {
    of_run(&simulate(scene, &Settings::BARE, &mut |_| ControlFlow::Continue(())).unwrap())
}

fn by_kernel(scene: &Scene) -> Option<Measure> {
    let end = Contact::from_scene(scene)?.run(TOLERANCE)?;
    Some((end.arrested, if end.arrested { end.penetration_m } else { end.t_s }))
}

#[test]
fn the_kernel_agrees_with_the_engine() {
    let mut random = Random(SEED);
    let (mut compared, mut apart) = (0, Vec::new());
    for _ in 0..DRAWN {
        let changes = random.changes();
        let mut scene = Scene::clone(&scene(&changes));
        scene.run.tolerance = TOLERANCE;
        let Some(found) = by_kernel(&scene) else { continue };
        let Some(truth) = by_engine(&Arc::new(scene)) else { continue };
        compared += 1;
        let difference = (found.1 / truth.1 - 1.0).abs();
        if found.0 != truth.0 || difference > DIFFERENCE_MAX {
            apart.push(format!("{found:?} {truth:?} {difference:.1e} {}", typed(&changes)));
        }
    }
    assert!(compared >= COMPARED_MIN, "{compared}");
    assert!(apart.is_empty(), "{} of {compared}:\n{}", apart.len(), apart.join("\n"));
}
