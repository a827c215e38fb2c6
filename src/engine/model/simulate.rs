//! From a scene to its run: validate, simulate by the model that the scene names, follow the shot through the rest of a stack.
//!
//! Pure functions: no clock, no file, no thread.

use std::sync::Arc;

use crate::model::appendix::listing;
use crate::model::impact;
use crate::model::run::{EndReason, Run};
pub use crate::model::run::{Look, Observer, Settings};
use crate::model::scene::{ContactModel, InterfaceLaw, Scene};
use crate::model::stack;
use crate::model::variables::{self, VariableError};

/// Simulate one impact.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense. Anything that goes wrong later is reported in
/// [`Run::end`], with the part that was computed.
pub fn simulate(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    if scene.contact.model == ContactModel::Appendix {
        return Ok(listing::run(scene, *settings, observer));
    }
    let mut run = impact::run(scene, *settings, observer);
    let mut unseen = |look: &Look<'_>| observer(&Look { so_far: &|| None, ..*look });
    let behind = &mut |plate: Scene| simulate(&Arc::new(plate), settings, &mut unseen);
    run.stack = stack::follow(scene, &mut run, behind)?.map(Arc::new);
    Ok(run)
}

/// The same shot on a plastic interface, without series and estimate: what to hold against a fused one, which carries whatever it is
/// asked. `None` where the scene has no interface, is a stack, or is on the plastic law itself, and where the observer ends it.
pub fn plastic_beside(scene: &Scene, observer: Observer<'_>) -> Option<Run> {
    let is_fused = scene.interface.law == InterfaceLaw::Fused
        && scene.contact.model == ContactModel::Hydrodynamic
        && scene.is_sprung();
    if !is_fused || scene.is_stack() {
        return None;
    }
    let mut plastic = scene.clone();
    plastic.interface.law = InterfaceLaw::Plastic;
    let run = simulate(&Arc::new(plastic), &Settings::BARE, observer).ok()?;
    (run.end != EndReason::Cancelled).then_some(run)
}

/// A run without series and estimate, for tests.
#[cfg(test)]
pub(in crate::model) fn bare_run(scene: &Scene) -> Run {
    let go_on = &mut |_: &Look<'_>| std::ops::ControlFlow::Continue(());
    simulate(&Arc::new(scene.clone()), &Settings::BARE, go_on).expect("a valid scene")
}
