//! The first contact by the quickest way there is: the contact kernel where it takes the scene, else the simulation.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};

/// How the first contact ends: arrest, or the nose clear of the rear face.
pub(crate) struct FirstContact {
    /// When, s.
    pub(crate) t_s: f64,
    /// Depth then, m.
    pub(crate) depth_m: f64,
    /// Label of the solver: `kernel` for the contact kernel, `full` for the simulation.
    pub(crate) kernel: &'static str,
}

/// The first contact of a scene, to its own tolerance; `None` when neither arrest nor perforation is found.
pub(crate) fn first_contact(scene: &Arc<Scene>) -> Option<FirstContact> {
    if let Some(end) =
        Contact::from_scene(scene).and_then(|contact| contact.run(scene.run.tolerance))
    {
        return Some(FirstContact { t_s: end.t_s, depth_m: end.penetration_m, kernel: "kernel" });
    }
    let run = simulate(scene, &Settings::BARE, &mut |_| ControlFlow::Continue(())).ok()?;
    let arrest = run.first_arrest.map(|end| (end.t_s, end.penetration_m));
    let (t_s, depth_m) =
        arrest.or_else(|| run.departure.exit_time_s.zip(run.penetration.final_m))?;
    Some(FirstContact { t_s, depth_m, kernel: "full" })
}
