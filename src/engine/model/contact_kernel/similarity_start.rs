//! The first moment of a contact whose spring or damper is singular at zero, where the plate is at rest.
//!
//! There the plate's velocity follows a power of time, w = W t^p, between two limits: p = 2 by inertia against a force that
//! grows in proportion to time, and the law's own exponent where the law holds against the force. With p from the
//! logarithmic derivative of the balance m w p/t + D(w) + K(w t/(p + 1)) = F the state is right to a few per cent, and what
//! is wrong with it is forgotten like (start/contact)^p, so that the start may be placed early enough for any tolerance.

use crate::model::mechanism::PowerLaw;
use crate::numerics::{larger, smaller};

/// Error of the state's velocity, relative: with the tolerance it says how early the start has to be.
const VELOCITY_ERROR: f64 = 0.04;
/// Part of the contact's duration at which it is placed at the latest.
const LATEST: f64 = 0.02;

#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// Singular spring that starts at zero; coefficient zero without one.
    pub(super) spring: PowerLaw,
    /// Singular damper; coefficient zero without one.
    pub(super) damper: PowerLaw,
    /// Force on the plate at first contact (a preload), N.
    pub(super) force_n: f64,
    /// How fast it grows, N/s.
    pub(super) growth_n_s: f64,
    pub(super) plate_kg: f64,
}

/// The plate a moment after first contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moved {
    pub(super) t_s: f64,
    pub(super) by_m: f64,
    pub(super) w_m_s: f64,
}

/// The part of the contact's duration up to which what is left of the state's error, after growing with time from a preload or
/// with its square from rest, is below the tolerance.
pub(super) fn part(tolerance: f64, is_preloaded: bool) -> f64 {
    let left = tolerance / VELOCITY_ERROR;
    smaller(if is_preloaded { left } else { left.sqrt() }, LATEST)
}

impl Start {
    /// The plate so early in a contact of the given duration that the error left is below the tolerance.
    pub(super) fn place(&self, contact_s: f64, tolerance: f64) -> Moved {
        let t_s = part(tolerance, self.force_n > 0.0) * contact_s;
        let force = self.force_n + self.growth_n_s * t_s;
        let growth = self.growth_n_s * t_s / force;
        let by_inertia = 1.0 + growth;
        let guess = force * t_s / (self.plate_kg * by_inertia);
        let w = self.balance(guess, by_inertia, t_s, force);
        let inertia = self.plate_kg * w * by_inertia / t_s;
        let (d, k) = (self.damper.force(w), self.spring.force(w * t_s / (by_inertia + 1.0)));
        let p = (inertia + growth * force - self.spring.exponent * k)
            / (inertia + self.damper.exponent * d + self.spring.exponent * k);
        let p = larger(p, 0.1);
        let w_m_s = self.balance(w, p, t_s, force);
        Moved { t_s, by_m: w_m_s * t_s / (p + 1.0), w_m_s }
    }

    /// The velocity at which inertia, damper and spring hold the force: a step of Newton's method on the logarithm, where powers
    /// are lines.
    fn balance(&self, w: f64, p: f64, t_s: f64, force: f64) -> f64 {
        let inertia = self.plate_kg * w * p / t_s;
        let (d, k) = (self.damper.force(w), self.spring.force(w * t_s / (p + 1.0)));
        let sum = inertia + d + k;
        let slope = (inertia + self.damper.exponent * d + self.spring.exponent * k) / sum;
        w * (force / sum).powf(1.0 / slope)
    }
}
