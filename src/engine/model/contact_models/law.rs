//! The force between the bodies as the loop takes it.

use super::half_sine::History;
use super::lumped::Lumped;
use crate::model::run::RunWarning;
use crate::model::scene::{ContactModel, Scene};

/// A projectile that arrives at common velocity within this part of the end of a history has not been overrun.
const AT_THE_END: f64 = 1e-3;

/// A contact model's law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) enum ContactLaw {
    /// The flow of the target at its strength, with an interface that may yield.
    Flow,
    /// A prescribed force history, after which the bodies are one.
    History(History),
    /// The bodies are one at once.
    AtOnce,
    /// A spring with hysteresis and a damper.
    Lumped(Lumped),
}

impl ContactLaw {
    /// Builds the contact law of a valid scene.
    pub(in crate::model) fn from_scene(scene: &Scene) -> Self {
        match scene.contact.model {
            ContactModel::Hydrodynamic | ContactModel::Appendix => Self::Flow,
            ContactModel::HalfSine => Self::History(History::from_scene(scene)),
            ContactModel::InitialVelocity => Self::AtOnce,
            ContactModel::Lumped => Self::Lumped(Lumped::from_scene(scene)),
        }
    }

    /// The travel on a rigid mount that stands for the depth, m, of the models that have an interface of their own.
    pub(in crate::model) fn on_rigid_mount_m(&self) -> Option<f64> {
        match self {
            Self::Flow | Self::AtOnce => None,
            Self::History(history) => Some(history.travel_m),
            Self::Lumped(lumped) => Some(lumped.on_rigid_mount_m()),
        }
    }

    /// When a prescribed history ends, s; never, of another law.
    pub(in crate::model) fn lasts_s(&self) -> f64 {
        if let Self::History(history) = self { history.duration_s } else { f64::INFINITY }
    }

    /// Says where a prescribed history has overrun the first common velocity.
    pub(in crate::model) fn overruns(&self, first_arrest_s: Option<f64>) -> Option<RunWarning> {
        let Self::History(History { duration_s, .. }) = *self else { return None };
        let early = first_arrest_s.filter(|t_s| *t_s < duration_s * (1.0 - AT_THE_END));
        early.map(|t_s| RunWarning::Overruns { t_s, duration_s })
    }

    /// Travel at which contact begins in a hole made by this travel, m.
    pub(in crate::model) fn slack_m(&self, deepest_m: f64) -> f64 {
        if let Self::Lumped(lumped) = self { lumped.dent_m(deepest_m) } else { 0.0 }
    }

    /// Travel that stands for the depth of the hole made by this travel, m; `None` where the model knows none.
    pub(in crate::model) fn hole_m(&self, deepest_m: f64) -> Option<f64> {
        match self {
            Self::Flow | Self::History(_) => Some(deepest_m),
            Self::AtOnce => None,
            Self::Lumped(lumped) => Some(lumped.dent_m(deepest_m)),
        }
    }
}
