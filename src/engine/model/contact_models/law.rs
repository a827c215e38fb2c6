//! Contact law of the integration loop.

use crate::model::contact_models::half_sine::History;
use crate::model::contact_models::lumped::Lumped;
use crate::model::run::RunWarning;
use crate::model::scene::{ContactModel, Scene};

/// Tolerance of the time of first arrest, relative to the duration of a force history, within which no warning is given.
const AT_THE_END: f64 = 1e-3;

/// Law of a contact model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) enum ContactLaw {
    /// Flow of the target at its strength, with an interface that can slip.
    Flow,
    /// Prescribed force history, then a perfectly inelastic impact.
    History(History),
    /// Perfectly inelastic impact at first contact.
    AtOnce,
    /// Spring with hysteresis and a damper.
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

    /// Returns the travel on a rigid mount that represents the depth, m, for models with their own interface.
    pub(in crate::model) fn on_rigid_mount_m(&self) -> Option<f64> {
        match self {
            Self::Flow | Self::AtOnce => None,
            Self::History(history) => Some(history.travel_m),
            Self::Lumped(lumped) => Some(lumped.on_rigid_mount_m()),
        }
    }

    /// Returns the end time of the force history, s; infinite for other contact laws.
    pub(in crate::model) fn lasts_s(&self) -> f64 {
        if let Self::History(history) = self { history.duration_s } else { f64::INFINITY }
    }

    /// Returns a warning if the force history continues after the first arrest.
    pub(in crate::model) fn overruns(&self, first_arrest_s: Option<f64>) -> Option<RunWarning> {
        let Self::History(History { duration_s, .. }) = *self else { return None };
        let early = first_arrest_s.filter(|t_s| *t_s < duration_s * (1.0 - AT_THE_END));
        early.map(|t_s| RunWarning::Overruns { t_s, duration_s })
    }

    /// Returns the travel at which contact starts in a hole of a given maximum travel, m.
    pub(in crate::model) fn slack_m(&self, deepest_m: f64) -> f64 {
        if let Self::Lumped(lumped) = self { lumped.dent_m(deepest_m) } else { 0.0 }
    }

    /// Returns the travel that represents the depth of a hole of a given maximum travel, m; `None` for a model without depth.
    pub(in crate::model) fn hole_m(&self, deepest_m: f64) -> Option<f64> {
        match self {
            Self::Flow | Self::History(_) => Some(deepest_m),
            Self::AtOnce => None,
            Self::Lumped(lumped) => Some(lumped.dent_m(deepest_m)),
        }
    }
}
