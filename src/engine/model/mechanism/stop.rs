//! The stop: its parameters, and the one rule of a rigid one, the velocity of the plate after it meets the stop.

use crate::model::variables::part::parts;
use crate::model::variables::visible::{has_stop, has_stop_of};
use crate::model::worded::worded;

parts! {
    /// A mechanical stop, which acts on the plate.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Stop {
        pub position_m: Option<f64> = None => "x_stop", "stop position", "where the plate meets a mechanical stop",
            optional(Length, Any, "none").also(&["stop"]).from("thesis sections 9.5.1 and 9.6");
        pub kind: StopKind = StopKind::Rigid => "stop_kind", "kind of stop",
            "rigid: an impact with restitution; elastic: a one-sided spring and damper",
            choice().used_when(has_stop).from("assumption: the thesis names no kind");
        pub restitution: f64 = 0.0 => "e", "restitution", "restitution of a rigid stop: w becomes -e w",
            number(Number, Between(0.0, 1.0)).used_when(|scene| has_stop_of(scene, StopKind::Rigid));
        pub stiffness_n_m: f64 = 1e8 => "k_stop", "stop stiffness", "stiffness of an elastic stop",
            number(Stiffness, Positive).log().used_when(|scene| has_stop_of(scene, StopKind::Elastic));
        pub damping_n_s_m: f64 = 0.0 => "b_stop", "stop damping", "damping of an elastic stop (it only pushes)",
            number(Damping, NonNegative).log().used_when(|scene| has_stop_of(scene, StopKind::Elastic));
    }
}

worded! {
    /// The kind of stop.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum StopKind: word {
        #[default]
        Rigid = "rigid",
        Elastic = "elastic",
    }
}

/// A rebound slower than this part of the velocities of the impact, per tolerance, is a rest: a plate that leaves its stop with less
/// drifts apart from one at rest by less than the tolerance.
pub(in crate::model) const SLOW: f64 = 1e-3;
/// So is one whose height is below this part of the displacements: their digits end there.
pub(in crate::model) const HEIGHT_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A plate that meets its rigid stop, in any units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) struct Hit {
    pub(in crate::model) velocity: f64,
    /// Acceleration by all forces but the stop's, forwards.
    pub(in crate::model) acceleration: f64,
    /// The velocities below which it rests.
    pub(in crate::model) slow: f64,
    /// The displacements that matter.
    pub(in crate::model) length_scale: f64,
}

impl Stop {
    /// The velocity after a hit: -e times that before, or 0 for a plate that stays.
    pub(in crate::model) fn rebound(&self, hit: &Hit) -> f64 {
        let after = -self.restitution * hit.velocity;
        let height = 0.5 * after * after / hit.acceleration.abs();
        let is_within_rounding =
            hit.acceleration > 0.0 && height <= HEIGHT_ROUNDING * hit.length_scale;
        if after.abs() <= hit.slow || is_within_rounding { 0.0 } else { after }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plate_rebounds_with_its_restitution_unless_it_is_too_slow_or_does_not_rise() {
        for (restitution, velocity, acceleration, exact) in [
            (0.5, 2.0, 1e3, -1.0),
            (1.0, 2.0, -1e3, -2.0),
            (0.0, 2.0, 1e3, 0.0),
            // 1e-9 of 100 m/s.
            (0.5, 1e-7, 0.0, 0.0),
            (0.5, 4e-7, 0.0, -2e-7),
            // 2e-7 m/s against 1e6 m/s² rises by 2e-20 m, below the rounding of 1 mm; pulled away it leaves.
            (0.5, 4e-7, 1e6, 0.0),
            (0.5, 4e-7, -1e6, -2e-7),
        ] {
            let hit = Hit { velocity, acceleration, slow: 1e-7, length_scale: 1e-3 };
            let after = Stop { restitution, ..Stop::default() }.rebound(&hit);
            assert!((after - exact).abs() < 1e-22, "{restitution} {hit:?}: {after}");
        }
    }
}
