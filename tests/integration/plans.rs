//! Omitted terms change nothing: the contact kernel and the closed forms against the general path, which integrates all it is given, over
//! thousands of random scenes.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::Arc;

use cmra::model::contact_kernel::Contact;
use cmra::model::impact::by_taylor_steps;
use cmra::model::run::Run;
use cmra::model::scene::Scene;
use cmra::model::simulate::{Settings, simulate};

use crate::random::{Random, scene, typed};

const DRAWN: usize = 4_000;
const TOLERANCE: f64 = 1e-13;
/// Greatest relative difference of depth, or of the exit time.
const DIFFERENCE_MAX: f64 = 1e-11;
/// Fewer comparisons than this of a plan would say nothing.
const COMPARED_MIN: usize = 1_000;
const SEED: u64 = 0x91a5_2007;

/// Whether it is arrested, and the depth or the exit time.
type Measure = (bool, f64);

fn of_run(run: &Run) -> Option<Measure> {
    if let Some(arrest) = run.first_arrest {
        return Some((true, arrest.penetration_m));
    }
    run.exit_time_s.map(|t_s| (false, t_s))
}

fn general(scene: &Arc<Scene>) -> Option<Measure> {
    of_run(&by_taylor_steps(scene).unwrap()?)
}

fn ordinary(scene: &Arc<Scene>) -> Option<Measure> {
    let settings = Settings { series: false, estimate: false };
    of_run(&simulate(scene, &settings, &mut |_| ControlFlow::Continue(())).unwrap())
}

fn by_kernel(scene: &Scene) -> Option<Measure> {
    let end = Contact::of(scene).run(TOLERANCE)?;
    Some((end.arrested, if end.arrested { end.penetration_m } else { end.t_s }))
}

#[test]
fn every_plan_agrees_with_the_general_path() {
    let mut random = Random(SEED);
    let mut compared: BTreeMap<&str, usize> = BTreeMap::new();
    let mut apart = Vec::new();
    for _ in 0..DRAWN {
        let changes = random.changes();
        let mut scene = Scene::clone(&scene(&changes));
        scene.run.tolerance = TOLERANCE;
        let scene = Arc::new(scene);
        let Some(truth) = general(&scene) else { continue };
        for (plan, found) in [("ordinary", ordinary(&scene)), ("contact kernel", by_kernel(&scene))]
        {
            let Some(found) = found else { continue };
            *compared.entry(plan).or_default() += 1;
            let difference = (found.1 / truth.1 - 1.0).abs();
            if found.0 != truth.0 || difference > DIFFERENCE_MAX {
                apart.push(format!(
                    "{plan} {found:?} {truth:?} {difference:.1e} {}",
                    typed(&changes)
                ));
            }
        }
    }
    println!("{compared:?}, {} apart", apart.len());
    for line in &apart {
        println!("{line}");
    }
    assert!(compared.values().all(|count| *count >= COMPARED_MIN), "{compared:?}");
    assert!(apart.is_empty(), "{} of {compared:?}; for example {}", apart.len(), apart[0]);
}
