//! The plate at its rigid stop: when it is met, whether it holds the plate, and when it lets go.

use super::Course;
use crate::model::interaction::pair::{Push, Q, STOP, V, W, X};
use crate::model::run::EventKind;

/// A plate that has this part of the impact velocity left on a rigid stop comes to rest there.
const RESTS_BELOW: f64 = 1e-6;
/// Hits that are told of, however slow the plate is.
const TOLD: usize = 8;
/// Part of two forces by which they differ although they are meant to be equal.
const ROUNDING: f64 = 1e-12;

impl Course<'_> {
    /// When a plate held by its stop is let go by a pulse that fades.
    pub(super) fn release_time(&self) -> Option<f64> {
        let Push::Pulse { amplitude, duration } = self.pair.push else { return None };
        let back = self.pair.spring_force(self.y[X]);
        if !self.pair.held || back <= 0.0 {
            return None;
        }
        let part = back / (amplitude * self.pair.cos);
        let release = duration * (1.0 - part.asin() / std::f64::consts::PI);
        (part < 1.0 && release > self.t).then_some(release)
    }

    /// Whether the plate is where it is to meet its rigid stop already, and is pressed on it: no boundary falls there.
    pub(super) fn is_on_stop(&self) -> bool {
        let pair = &self.pair;
        if pair.is_still() || pair.rigid_stop().is_none() || self.y[X] < pair.stop_at {
            return false;
        }
        self.y[W] > 0.0 || self.y[W] == 0.0 && self.presses_stop()
    }

    /// Whether a plate at rest at its stop is pressed on it, or is about to be.
    fn presses_stop(&self) -> bool {
        let (pair, y) = (&self.pair, &self.y);
        let back = pair.spring_force(y[X]);
        if pair.joined {
            return back < 0.0;
        }
        let (forward, growth, scale) = match pair.push {
            Push::None => (0.0, 0.0, 0.0),
            Push::Pulse { amplitude, duration } => {
                (pair.push.force(self.t, y[Q], y[V]), 0.5 * duration - self.t, amplitude)
            }
            Push::Spring { stiffness, damping, .. } => {
                let push = pair.push.force(self.t, y[Q], y[V]);
                (push, stiffness * y[V] - damping * push, stiffness * y[Q].abs())
            }
        };
        let net = forward * pair.cos - back;
        let rounding = ROUNDING * (scale + back.abs());
        net > rounding || net >= -rounding && growth > 0.0
    }

    /// The rigid stop: the plate comes back with its restitution, or rests on it.
    pub(super) fn hit_stop(&mut self) {
        let Some(stop) = self.pair.rigid_stop() else { return };
        let is_told = self.hits < TOLD || self.y[W] > RESTS_BELOW;
        if self.y[W] > 0.0 && is_told {
            self.event(EventKind::StopHit);
        }
        let before = 0.5 * self.pair.moving_mass() * self.y[W] * self.y[W];
        self.y[X] = self.pair.stop_at;
        self.y[W] *= -stop.restitution;
        if self.y[W].abs() < RESTS_BELOW {
            self.y[W] = 0.0;
            let idle = self.pair.joined && self.pair.spring_force(self.y[X]) == 0.0;
            if idle || self.presses_stop() {
                self.pair.held = true;
                self.event(EventKind::StopHold);
            }
        }
        if self.pair.joined {
            self.y[V] = self.y[W] * self.pair.cos;
        }
        self.y[STOP] += before - 0.5 * self.pair.moving_mass() * self.y[W] * self.y[W];
        self.point();
    }

    pub(super) fn release(&mut self) {
        self.pair.held = false;
        self.event(EventKind::StopRelease);
    }
}
