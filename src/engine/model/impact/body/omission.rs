//! A singular power law cannot be expanded at its zero: it is omitted in a neighbourhood so small that this does not matter.

use super::Body;
use crate::numerics::{larger, smaller};

/// Half-width of the neighbourhood of zero in which a singular power law is omitted, relative to the greatest value seen.
/// A spring gives on one side of it what it takes on the other; a damper does not, and a plate may creep near zero.
const CLEAR_OF_SPRING: f64 = 1e-6;
const CLEAR_OF_DAMPER: f64 = 1e-9;
/// Tolerance from which down the spring's neighbourhood shrinks.
const CLEAR_AT: f64 = 1e-9;
/// Part of the plate's energy, or of the other forces, that a law may have where it is omitted.
const PASSING: f64 = 1e-3;
/// The neighbourhood takes at least this part of the time reached to cross: time has no finer resolution.
const CLOCK: f64 = 1e-13;
/// The least distance, relative to the tip's radius and the impact velocity: where nothing drives the plate yet, there is no
/// other measure.
const LEAST: f64 = 1e-13;
/// The least half-width relative to the greatest displacement seen: less than that is lost in rounding.
const FINEST: f64 = 1e-12;

impl Body<'_> {
    /// Omits the singular spring until the plate is clear of zero, and gives the time that this takes, s. The distance is fixed
    /// now: one that shrank on the way would never be reached.
    pub(in crate::model::impact) fn omit_spring(&mut self) -> f64 {
        let least = LEAST * self.problem.geometry.nose.radius_m;
        let (x, w) = (self.state.plate_m, self.state.plate_m_s);
        self.x_zero.clear = if x * w < 0.0 {
            // As far on the other side as on this one: then what the spring takes it also gives.
            larger(x.abs(), FINEST * self.plate_scale_m)
        } else if x == 0.0 && w != 0.0 {
            // From zero itself there is no other side: as close as the time resolves.
            let closest = larger(CLOCK * self.state.t_s * w.abs(), FINEST * self.plate_scale_m);
            // A plate that a model starts with a velocity has no time and no path behind it.
            if closest > 0.0 { closest } else { least }
        } else {
            larger(larger(self.near_zero_m(), 2.0 * x.abs()), least)
        };
        self.x_zero.omitted = true;
        self.x_zero.clear / w.abs()
    }

    pub(in crate::model::impact) fn omit_damper(&mut self) -> f64 {
        let least = LEAST * self.problem.velocity_m_s;
        let near = larger(self.near_zero_m_s(), 2.0 * self.state.plate_m_s.abs());
        self.w_zero.clear = larger(near, least);
        self.w_zero.omitted = true;
        self.w_zero.clear / self.motion().accelerations(&self.state).plate_m_s2.abs()
    }

    /// Restores an omitted law as soon as its argument has left the neighbourhood of zero. A plate that only touched zero is on
    /// the side on which it is, so that its next passage is not taken for a return.
    pub(in crate::model::impact) fn restore_omitted(&mut self) {
        let (x, w) = (self.state.plate_m, self.state.plate_m_s);
        self.x_zero.leave(x, FINEST * self.plate_scale_m);
        self.w_zero.leave(w, FINEST * self.speed_scale_m_s);
    }

    /// How close to zero displacement the singular spring is omitted: so close that it holds little of the plate's energy.
    pub(in crate::model::impact) fn near_zero_m(&self) -> f64 {
        let (spring, w) = (self.spring(), self.state.plate_m_s);
        let energy = 0.5 * self.problem.plate_kg * w * w;
        // Tighter computations come closer, so that two of them do not omit the same.
        let closer = smaller((self.tolerance / CLEAR_AT).sqrt(), 1.0);
        let clear_m = CLEAR_OF_SPRING * closer * self.plate_scale_m;
        let passing = smaller(clear_m, spring.at_integral(PASSING * energy));
        larger(passing, CLOCK * self.state.t_s * w.abs())
    }

    /// How close to zero velocity the singular damper is omitted: so close that other forces turn the plate round.
    pub(super) fn near_zero_m_s(&self) -> f64 {
        let damper = self.problem.mechanism.damper;
        let motion = self.motion();
        let rate = motion.accelerations(&self.state).plate_m_s2;
        let damping = motion.damper.force(self.state.plate_m_s) * motion.plate_mobility;
        let others = (rate + damping).abs();
        let turning = damper.at_force(PASSING * others * self.problem.plate_kg);
        larger(
            smaller(CLEAR_OF_DAMPER * self.speed_scale_m_s, turning),
            CLOCK * self.state.t_s * others,
        )
    }
}
