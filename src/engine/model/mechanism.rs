//! Springs, dampers and stops: force, energy and limits.
//!
//! Signs: a spring force is positive when it pushes the plate back towards its neutral position from x > 0, a damper force
//! when it resists w > 0; both act on the plate as -force. Thesis equations 8.1, 8.2, 9.2, 9.3 with the signs its
//! Appendix lacks: both laws are odd.

use crate::model::scene::{Scene, Stop, StopKind};

pub mod curve;
pub mod inertia;
pub(in crate::model) mod kinds;
pub mod load;
pub mod piece;
mod spring;

pub use inertia::{Inertia, moving_plate_kg};
pub use spring::Spring;

/// Least exponent of a power law. Below it the force is constant within a factor of 1000 over all numbers, and the displacement of a
/// force underflows.
pub(in crate::model) const MIN_EXPONENT: f64 = 0.01;

/// An odd power law: `coefficient |z|^exponent sgn(z)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// >= 0.
    pub coefficient: f64,
    /// > 0.
    pub exponent: f64,
}

impl PowerLaw {
    /// No force.
    pub const NONE: Self = Self { coefficient: 0.0, exponent: 1.0 };

    /// Whether there is no force.
    pub fn is_absent(self) -> bool {
        self.coefficient == 0.0
    }

    /// The law where it acts, else none of the same exponent.
    #[must_use]
    pub fn only_if(self, acts: bool) -> Self {
        if acts { self } else { Self { coefficient: 0.0, ..self } }
    }

    /// Whether its tangent at zero is infinite.
    pub fn is_steep_at_zero(self) -> bool {
        !self.is_absent() && self.exponent < 1.0
    }

    /// Velocity below which a steep damper is taken as linear, m/s, under a shot of this velocity; 0 of any other law. Less than that does
    /// not count: the travel is as far off at most as a part of 1e-13 of the tip radius.
    pub fn creep_m_s(self, impact_m_s: f64) -> f64 {
        if self.is_steep_at_zero() { 1e-13 * impact_m_s } else { 0.0 }
    }

    /// Whether it is linear, or no law at all.
    pub fn is_linear(self) -> bool {
        self.is_absent() || matches!(self.exponent, 1.0)
    }

    /// Whether the law is one analytic function through zero (linear, cubic, ...).
    pub fn is_smooth_at_zero(self) -> bool {
        self.is_absent() || matches!(self.exponent, 1.0 | 3.0 | 5.0)
    }

    /// The force at `z`, which may be infinite.
    pub fn force(self, z: f64) -> f64 {
        if self.is_absent() {
            0.0
        } else if self.is_linear() {
            self.coefficient * z
        } else {
            self.coefficient * z.abs().powf(self.exponent) * sign(z)
        }
    }

    /// The force on one side of zero, 1 or -1: a square goes on smoothly a little beyond it, any other law oddly.
    pub fn force_on(self, side: f64, z: f64) -> f64 {
        match self.exponent {
            2.0 => self.coefficient * z * z * side,
            3.0 => self.coefficient * z * z * z,
            _ => self.force(z),
        }
    }

    /// The derivative of the force at `z`; infinite at zero for exponents below one.
    pub fn tangent(self, z: f64) -> f64 {
        if self.is_linear() {
            return self.coefficient;
        }
        self.coefficient * self.exponent * z.abs().powf(self.exponent - 1.0)
    }

    /// The integral of the force from 0 to `z`: for a spring, the energy it stores.
    pub fn integral(self, z: f64) -> f64 {
        if self.is_absent() {
            return 0.0;
        }
        self.coefficient / (self.exponent + 1.0) * z.abs().powf(self.exponent + 1.0)
    }

    /// The |z| at which the force is `force`; infinite when there is no law.
    pub fn at_force(self, force: f64) -> f64 {
        if self.is_absent() {
            return f64::INFINITY;
        }
        (force.abs() / self.coefficient).powf(1.0 / self.exponent)
    }

    /// The |z| at which the integral is `integral`; infinite when there is no law.
    pub fn at_integral(self, integral: f64) -> f64 {
        if self.is_absent() {
            return f64::INFINITY;
        }
        ((self.exponent + 1.0) * integral / self.coefficient).powf(1.0 / (self.exponent + 1.0))
    }
}

/// Sign of a number, zero for zero.
pub fn sign(z: f64) -> f64 {
    if z == 0.0 { 0.0 } else { z.signum() }
}

/// The mechanism that carries the plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// The springs together.
    pub spring: Spring,
    /// The damper.
    pub damper: PowerLaw,
    /// The stop, if there is one.
    pub stop: Option<Stop>,
}

impl Mechanism {
    /// The mechanism of a scene; a rigid mount has none.
    pub fn from_scene(scene: &Scene) -> Self {
        let laws = &scene.mechanism;
        let sprung = scene.is_sprung();
        Self {
            spring: if sprung { Spring::new(laws, 0.0) } else { Spring::NONE },
            damper: laws.damper.only_if(sprung),
            stop: laws.stop.position_m.filter(|_| sprung).map(|_| laws.stop),
        }
    }

    /// Whether neither spring nor damper acts.
    pub fn is_absent(&self) -> bool {
        self.spring.is_absent() && self.damper.is_absent()
    }

    /// Whether spring and damper are analytic, through zero as well.
    pub fn is_analytic(&self) -> bool {
        self.spring.is_analytic() && self.damper.is_smooth_at_zero()
    }

    /// The elastic stop, if there is one.
    pub fn elastic_stop(&self) -> Option<Stop> {
        self.stop.filter(|stop| stop.kind == StopKind::Elastic)
    }

    /// The rigid stop, if there is one.
    pub fn rigid_stop(&self) -> Option<Stop> {
        self.stop.filter(|stop| stop.kind == StopKind::Rigid)
    }
}

#[cfg(test)]
mod tests;
