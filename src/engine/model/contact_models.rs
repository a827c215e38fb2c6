//! How projectile and plate push on each other: the contact models of thesis section 8.2 and Table 8.1, on one loop.
//!
//! A model gives its force; `impact` has the modes and events. What a model does not contain is absent from the run: no depth where it
//! knows none, no peak force where the collision takes no time. The listing of Appendix A is a scheme of its own: see `appendix`.

use std::cell::LazyCell;

use crate::model::closed_form::{Ending, Passage};
use crate::model::contact::Geometry;
use crate::model::scene::{ContactModel, Scene};
use crate::model::units::engineering;

mod half_sine;
mod law;
mod lumped;

pub(super) use half_sine::History;
pub(super) use law::Law;

impl ContactModel {
    /// What it is.
    pub fn about(self) -> &'static About {
        match self {
            Self::Hydrodynamic => &FLOW_STRENGTH,
            Self::HalfSine => &half_sine::ABOUT,
            Self::InitialVelocity => &INITIAL_VELOCITY,
            Self::Lumped => &lumped::ABOUT,
            Self::Appendix => &APPENDIX,
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
}

/// The hydrodynamic model, F = A (S + c u²).
const FLOW_STRENGTH: About = About {
    place: 1,
    strength: "simple",
    limit: "models the contact force as a modified fluid drag",
    parameters: |_| String::new(),
};

/// The initial velocity of equations 8.10 and 8.11, `w(0) = m_p v/(m_p + m_2)`: a perfectly inelastic collision that takes no time.
const INITIAL_VELOCITY: About = About {
    place: 4,
    strength: "simple",
    limit: "the impact takes no time; cannot perforate",
    parameters: |_| String::new(),
};

/// The hydrodynamic model by the listing of Appendix A.
const APPENDIX: About = About {
    place: 5,
    strength: "the method of chapter 9",
    limit: "not in Table 8.1",
    parameters: |scene| {
        let step_s = scene.contact.appendix.step_s;
        format!("dt = {}", shown(step_s, "s", Some(step_s)))
    },
};

/// `k_unload` over `k_load` unless given: a hundredth of the dent springs back, a tenth of the speed.
const UNLOAD_PER_LOAD: f64 = 100.0;

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
    let end_s = passage.time_s(ending);
    let at_speed_s = geometry.exit_m / scene.projectile.velocity_m_s;
    let travel_m = match ending {
        Ending::Arrest { travel_m } => travel_m,
        Ending::Exit { .. } => geometry.exit_m,
    };
    (if end_s.is_finite() { end_s } else { at_speed_s }, travel_m)
}

#[cfg(test)]
mod tests;
