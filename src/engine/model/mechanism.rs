//! Springs, dampers and stops: force, energy and limits.
//!
//! Signs: a spring force is positive for x > 0 if it acts towards the neutral position, a damper force is positive for w > 0 if it resists;
//! both act on the plate as -force. Thesis equations 8.1, 8.2, 9.2, 9.3 with the signs that its Appendix lacks: both laws are odd.

use crate::model::scene::{Scene, Stop, StopKind};

pub mod curve;
pub mod inertia;
pub(in crate::model) mod kinds;
pub mod load;
pub mod piece;
mod spring;

pub use crate::model::power_law::PowerLaw;
pub use inertia::{Inertia, moving_plate_kg};
pub use spring::Spring;

/// Mechanism that carries the plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// Combined law of all springs.
    pub spring: Spring,
    /// Damper.
    pub damper: PowerLaw,
    /// Stop, if there is one.
    pub stop: Option<Stop>,
}

impl Mechanism {
    /// Creates the mechanism of a scene; without force on a rigid mount.
    pub fn from_scene(scene: &Scene) -> Self {
        let laws = &scene.mechanism;
        let sprung = scene.is_sprung();
        Self {
            spring: if sprung { Spring::new(laws, 0.0) } else { Spring::NONE },
            damper: laws.damper.only_if(sprung),
            stop: laws.stop.position_m.filter(|_| sprung).map(|_| laws.stop),
        }
    }

    /// Returns `true` without spring and damper.
    pub fn is_absent(&self) -> bool {
        self.spring.is_absent() && self.damper.is_absent()
    }

    /// Whether spring and damper are analytic, through zero as well.
    pub fn is_analytic(&self) -> bool {
        self.spring.is_analytic() && self.damper.is_smooth_at_zero()
    }

    /// Returns the elastic stop, if there is one.
    pub fn elastic_stop(&self) -> Option<Stop> {
        self.stop.filter(|stop| stop.kind == StopKind::Elastic)
    }

    /// Returns the rigid stop, if there is one.
    pub fn rigid_stop(&self) -> Option<Stop> {
        self.stop.filter(|stop| stop.kind == StopKind::Rigid)
    }
}

#[cfg(test)]
mod tests;
