//! The initial velocity of thesis equations 8.10 and 8.11: a perfectly inelastic collision that takes no time.
//!
//! `w(0) = m_p v/(m_p + m_2)`, and both bodies are one from then on. The model has no force and no depth.

use std::sync::Arc;

use super::{About, ContactLaw, Hole, Scales};
use crate::model::event_function::{ActiveEvents, EventFunction, EventId};
use crate::model::motion::ContactForce;
use crate::model::run::Mode;
use crate::model::scene::Scene;

pub(super) const ABOUT: About = About {
    place: 4,
    strength: "simple",
    limit: "the impact takes no time; cannot perforate",
    parameters: |_| String::new(),
    of: |scene, _| Arc::new(InitialVelocity::of(scene)),
};

/// A collision at once.
#[derive(Clone, Copy, Debug, PartialEq)]
struct InitialVelocity {
    scales: Scales,
}

impl InitialVelocity {
    /// One nose radius at impact velocity stands for the contact that takes no time.
    fn of(scene: &Scene) -> Self {
        let (r, v) = (scene.projectile.tip_radius_m, scene.projectile.velocity_m_s);
        let force_n = scene.projectile.mass_kg * v * v / r;
        Self { scales: Scales { travel_m: r, duration_s: r / v, force_n } }
    }
}

impl ContactLaw for InitialVelocity {
    fn force(&self, _mode: Mode, _hole: &Hole<'_>) -> ContactForce {
        ContactForce::None
    }

    /// The bodies are one from the first moment on.
    fn add_events(&self, mode: Mode, _hole: &Hole<'_>, events: &mut ActiveEvents) {
        if mode == Mode::Penetrating {
            events.add(EventId::HistoryEnd, EventFunction::time_up_to(0.0));
        }
    }

    fn scales(&self) -> Scales {
        self.scales
    }
}
