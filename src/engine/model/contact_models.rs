//! How projectile and plate push on each other: the contact models of thesis section 8.2 and Table 8.1, on one simulation.
//!
//! A model gives the force of each mode, the events that end the mode, and what follows. The simulation does the rest, with
//! every spring, damper and stop. What a model does not contain is absent from the run: no depth where it knows none, no peak
//! force where the collision takes no time. The listing of Appendix A is a scheme of its own: see `appendix`.

use std::cell::LazyCell;
use std::fmt::Debug;
use std::sync::Arc;

use crate::model::closed_form::{Ending, Passage, Rule};
use crate::model::contact::Geometry;
use crate::model::event_function::ActiveEvents;
use crate::model::motion::{ContactForce, State};
use crate::model::run::{Mode, Warning};
use crate::model::scene::{ContactModel, Scene};
use crate::model::units::engineering;

mod flow_strength;
mod half_sine;
mod initial_velocity;
mod law;
mod lumped;

pub(super) use half_sine::History;
pub(super) use law::Law;

impl ContactModel {
    /// What it is.
    pub fn about(self) -> &'static About {
        match self {
            Self::Hydrodynamic => &flow_strength::ABOUT,
            Self::HalfSine => &half_sine::ABOUT,
            Self::InitialVelocity => &initial_velocity::ABOUT,
            Self::Lumped => &lumped::ABOUT,
            Self::Appendix => &flow_strength::APPENDIX,
        }
    }
}

/// What a contact model is.
#[derive(Debug)]
pub struct About {
    /// Its place in comparisons, which are in the order of Table 8.1.
    pub place: usize,
    /// What Table 8.1 calls its strength, in other words.
    pub strength: &'static str,
    /// What limits it.
    pub limit: &'static str,
    /// Its parameters in a scene, in words; empty if none have to be chosen.
    pub parameters: fn(&Scene) -> String,
    of: fn(&Scene, &Geometry) -> Arc<dyn ContactLaw>,
}

/// `k_unload` over `k_load` unless given: a hundredth of the dent springs back, a tenth of the speed.
const UNLOAD_PER_LOAD: f64 = 100.0;

pub(super) trait ContactLaw: Debug + Send + Sync {
    fn force(&self, mode: Mode, hole: &Hole<'_>) -> ContactForce;

    /// Adds the events that end a mode in which the bodies are not joined.
    fn add_events(&self, mode: Mode, hole: &Hole<'_>, events: &mut ActiveEvents);

    /// The mode after common velocity is reached.
    fn at_common_velocity(&self) -> Mode {
        Mode::Fused
    }

    /// The mode of a projectile that goes deeper again after it was on its way out.
    fn turned_forward(&self) -> Mode {
        Mode::Closing
    }

    /// Sizes of the contact.
    fn scales(&self) -> Scales;

    /// Travel at which contact begins in a hole made by this travel, m.
    fn slack_m(&self, _deepest_m: f64) -> f64 {
        0.0
    }

    /// Travel that stands for the hole's depth, m; `None` where the model knows none.
    fn hole_m(&self, _deepest_m: f64) -> Option<f64> {
        None
    }

    /// The same on a rigid mount, m.
    fn hole_on_rigid_mount_m(&self) -> Option<f64> {
        None
    }

    /// Energy in a contact that comes to rest without joining the bodies, J.
    fn stored_j(&self, _mode: Mode, _hole: &Hole<'_>) -> Option<f64> {
        None
    }

    /// What it does not contain of a run with this first common velocity, s.
    fn note(&self, _first_arrest_s: Option<f64>) -> Option<Warning> {
        None
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Hole<'a> {
    pub(super) geometry: &'a Geometry,
    pub(super) state: State,
    /// Greatest travel so far, m.
    pub(super) deepest_m: f64,
    pub(super) still: bool,
}

/// Sizes of a contact, by order of magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scales {
    pub(super) travel_m: f64,
    pub(super) duration_s: f64,
    pub(super) force_n: f64,
}

pub(super) fn of(scene: &Scene, geometry: &Geometry) -> Arc<dyn ContactLaw> {
    (scene.contact.model.about().of)(scene, geometry)
}

/// A parameter for readers, with a note where it was left open.
fn shown(value: f64, unit: &'static str, given: Option<f64>) -> String {
    let auto = if given.is_none() { " (auto)" } else { "" };
    format!("{}{auto}", engineering(value, unit, 4))
}

/// The parameters of the models, with what was left open filled in.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Values {
    duration_s: f64,
    load_stiffness_n_m: f64,
    unload_stiffness_n_m: f64,
}

impl Values {
    /// The values a valid scene's models work with: what is left open is taken from the hydrodynamic contact on a rigid mount.
    fn of(scene: &Scene) -> Self {
        let contact = &scene.contact;
        let own = LazyCell::new(|| hydrodynamic_on_rigid_mount(scene));
        let load_stiffness_n_m = contact.load_stiffness_n_m.unwrap_or_else(|| {
            let speed_per_s = scene.projectile.velocity_m_s / own.1;
            scene.projectile.mass_kg * speed_per_s * speed_per_s
        });
        let unload = contact.unload_stiffness_n_m;
        Self {
            duration_s: contact.duration_s.unwrap_or_else(|| own.0),
            load_stiffness_n_m,
            unload_stiffness_n_m: unload.unwrap_or(UNLOAD_PER_LOAD * load_stiffness_n_m),
        }
    }
}

/// How long the hydrodynamic contact lasts on a rigid mount, s, and how far the projectile travels in it, m. A plate that is
/// perforated counts with its exit.
fn hydrodynamic_on_rigid_mount(scene: &Scene) -> (f64, f64) {
    let geometry = Geometry::of(scene);
    let passage = Passage::rigid(scene, &geometry);
    let ending = passage.ending();
    let end_s = passage.history(ending, Rule::FINE).last().map(|moment| moment.t_s);
    let at_speed_s = geometry.exit_m / scene.projectile.velocity_m_s;
    let travel_m = match ending {
        Ending::Arrest { travel_m } => travel_m,
        Ending::Exit { .. } => geometry.exit_m,
    };
    (end_s.filter(|end_s| end_s.is_finite()).unwrap_or(at_speed_s), travel_m)
}

#[cfg(test)]
mod tests;
