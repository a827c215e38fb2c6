//! The outcome of a shot and the greatest displacement, as far as nothing can change them any more.

use std::f64::consts::PI;

use super::{Body, NO_ENERGY};
use crate::model::motion::State;
use crate::model::run::{Mode, Outcome};
use crate::numerics::larger;

/// A later change of depth below this part of the tolerance does not count.
const NEGLIGIBLE: f64 = 1e-3;
/// Nor does one below this part of the depth, or of the displacement, however tight the tolerance.
const ROUNDING: f64 = 1e-12;
/// Energy below this part of all there was with which bodies that are not joined are at rest.
const AT_REST: f64 = 1e-9;
/// Slips in a row, none of which deepened the hole noticeably, after which a projectile that cannot be pulled out counts
/// as arrested: an undamped mount rattles for ever.
const FRUITLESS_SLIPS_MAX: usize = 24;

/// Part of its speed with which a damped plate is waited for at its stop.
const ARRIVES: f64 = 1e-3;

#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(in crate::model::impact) enum MaximumDisplacement {
    Known(f64),
    Unbounded,
    #[default]
    Pending,
}

impl Body<'_> {
    /// The outcome, if nothing can change it any more; else `Moving`.
    pub(in crate::model::impact) fn outcome(&self) -> Outcome {
        match self.mode {
            Mode::Perforated => Outcome::Perforated,
            Mode::Fused if !self.problem.plastic || self.holds_for_good() => Outcome::Arrested,
            Mode::FreeFlight if self.is_separated_for_good() => Outcome::Separated,
            Mode::FreeFlight | Mode::Penetrating | Mode::Closing | Mode::Withdrawing
                if self.rests_in_contact() =>
            {
                Outcome::Arrested
            }
            _ => Outcome::Moving,
        }
    }

    /// Whether everything is at rest in a contact that does not join the bodies.
    fn rests_in_contact(&self) -> bool {
        let stored_j = self.problem.contact.stored_j(self.mode, &self.hole());
        stored_j.is_some_and(|stored_j| {
            self.energy_left_j() + stored_j < AT_REST * self.problem.energy_j
        })
    }

    /// Plastic and together: whether the interface will hold whatever comes.
    fn holds_for_good(&self) -> bool {
        if self.is_at_rest() || self.has_less_than(NO_ENERGY) || self.is_thrown_back_freely() {
            return true;
        }
        let mechanism = &self.problem.mechanism;
        let (push, pull) = self.interface_limits_n();
        let energy = self.energy_j();
        let strength = self.interface_n();
        let depth = self.problem.geometry.depth_m(self.deepest_m);
        // What is left could neither deepen the hole noticeably nor pull the projectile out of it.
        let pull_out = self.problem.grip
            * self.problem.strength_pa
            * self.problem.geometry.swept_m3(self.state.travel_m);
        let negligible = larger(NEGLIGIBLE * self.problem.scene.run.tolerance, ROUNDING);
        let is_nothing = |energy: f64| energy < negligible * depth * strength && energy < pull_out;
        if is_nothing(energy) {
            return true;
        }
        if self.yields_since_deeper > FRUITLESS_SLIPS_MAX && energy < pull_out {
            return true;
        }
        let returns = !mechanism.spring.is_absent() || self.state.plate_m_s > 0.0;
        if mechanism.rigid_stop().is_some()
            && returns
            && self.reach_with(energy) >= mechanism.stop_at_m
        {
            // Only what the spring does not hold when the plate meets its stop is left to the projectile.
            let on_arrival = energy - mechanism.spring.energy(mechanism.stop_at_m);
            if !is_nothing(on_arrival) {
                return false;
            }
        }
        self.push_at(energy) <= push && self.pull_at(energy) <= pull
            || self.yielding_stays_within(energy)
    }

    /// Whether the plate goes back where nothing acts on it any more: thrown back by an absorber, which only pushes.
    fn is_thrown_back_freely(&self) -> bool {
        let mechanism = &self.problem.mechanism;
        let goes_back = self.state.plate_m_s < 0.0 && mechanism.damper.is_absent();
        goes_back
            && !self.stop_touches
            && mechanism.spring.curve().is_some_and(|curve| {
                let forces = curve.forces_between(f64::NEG_INFINITY, self.state.plate_m);
                forces.0 >= 0.0 && forces.1 <= 0.0
            })
    }

    fn is_separated_for_good(&self) -> bool {
        let State { travel_m, slip_m_s, plate_m, plate_m_s, .. } = self.state;
        let problem = self.problem;
        let apart_m = problem.contact.slack_m(self.deepest_m) - travel_m;
        if slip_m_s > 0.0 || (apart_m <= 0.0 && slip_m_s == 0.0) {
            return false;
        }
        let v = self.state.projectile_m_s(problem.cos);
        let mechanism = &problem.mechanism;
        let energy = self.energy_j();
        let speed = (2.0 * energy / problem.plate_kg).sqrt();
        if v < -speed * problem.cos {
            return true;
        }
        if mechanism.spring.is_absent() && mechanism.stop.is_none() {
            let keeps_going = mechanism.damper.is_absent();
            return slip_m_s < 0.0 && (v <= 0.0 || plate_m_s < 0.0 || keeps_going);
        }
        // The plate is driven away from it, ever faster.
        let driven = || mechanism.spring.drives_away(plate_m) == Some(1.0);
        if slip_m_s < 0.0 && plate_m_s >= 0.0 && mechanism.stop.is_none() && driven() {
            return self.motion().accelerations(&self.state).plate_m_s2 >= 0.0;
        }
        // The projectile flies away, and is already beyond the plate's greatest displacement backwards.
        let back = mechanism.spring.backward(plate_m, energy);
        v < 0.0 && (plate_m + back) * problem.cos < apart_m
    }

    /// The greatest displacement, as far as it is known. Only once the outcome is decided.
    pub(in crate::model::impact) fn maximum_displacement(
        &self,
        so_far: f64,
    ) -> MaximumDisplacement {
        let mechanism = &self.problem.mechanism;
        let w = self.state.plate_m_s;
        let is_over = self.is_at_rest() || self.has_less_than(NO_ENERGY) || self.rests_in_contact();
        if self.problem.rigid || is_over {
            return MaximumDisplacement::Known(so_far);
        }
        if mechanism.stop.is_none()
            && let Some(way) = mechanism.spring.drives_away(self.state.plate_m)
            && way * w >= 0.0
        {
            return if way > 0.0 {
                MaximumDisplacement::Unbounded
            } else {
                MaximumDisplacement::Known(so_far)
            };
        }
        let reach = self.reach_with(self.energy_j());
        let stroke = so_far - self.problem.start_m;
        let negligible = larger(ROUNDING * so_far.abs(), NEGLIGIBLE * self.tolerance * stroke);
        if reach - so_far <= negligible {
            return MaximumDisplacement::Known(so_far);
        }
        let springless = mechanism.spring.is_absent();
        let damped = !mechanism.damper.is_absent() || self.stop_touches;
        if mechanism.stop.is_none() && !damped && !springless {
            // The oscillation ends where all energy is in the spring, if it holds the plate at all.
            let back = mechanism.spring.backward(self.state.plate_m, self.energy_j());
            return if w < 0.0 && back.is_infinite() {
                MaximumDisplacement::Known(so_far)
            } else if reach.is_finite() {
                MaximumDisplacement::Known(larger(reach, so_far))
            } else {
                MaximumDisplacement::Unbounded
            };
        }
        if springless && w <= 0.0 && !self.stop_touches {
            return MaximumDisplacement::Known(so_far);
        }
        if springless && !self.stop_touches {
            let coasting = self.coasting(so_far);
            let is_short =
                matches!(coasting, MaximumDisplacement::Known(x) if x < mechanism.stop_at_m);
            if is_short || mechanism.stop.is_none() {
                return coasting;
            }
        }
        MaximumDisplacement::Pending
    }

    /// How long a plate without spring takes to its stop at its present speed, or to press an elastic one, s; `None` where it is
    /// struck on the way, or its damper leaves it next to no speed.
    pub(in crate::model::impact) fn time_at_stop_s(&self) -> Option<f64> {
        let mechanism = &self.problem.mechanism;
        let stop = mechanism.stop?;
        if !mechanism.spring.is_absent() || self.is_sliding() || self.is_still() {
            return None;
        }
        if self.stop_touches {
            return Some(PI * (self.moving_kg() / stop.stiffness_n_m).sqrt());
        }
        let (gap_m, w) = (mechanism.stop_at_m - self.state.plate_m, self.state.plate_m_s);
        let comes = w > 0.0 && gap_m >= 0.0 && self.speed_left_after(gap_m) > ARRIVES;
        comes.then(|| gap_m / w)
    }

    /// The part of its speed that the damper alone leaves the plate after a distance: `w^(2-m)` falls by b (2-m)/M with each metre.
    fn speed_left_after(&self, distance_m: f64) -> f64 {
        let damper = self.problem.mechanism.damper;
        let (power, w) = (2.0 - damper.exponent, self.state.plate_m_s);
        let lost = damper.coefficient * distance_m / self.moving_kg() / w.powf(power);
        if power == 0.0 { (-lost).exp() } else { larger(1.0 - power * lost, 0.0).powf(1.0 / power) }
    }

    /// Without a spring: the damper's travel in closed form, x + M w^(2-m)/(b (2-m)), finite for m < 2.
    fn coasting(&self, so_far: f64) -> MaximumDisplacement {
        let damper = self.problem.mechanism.damper;
        let (m, w) = (damper.exponent, self.state.plate_m_s);
        if damper.is_absent() || m >= 2.0 {
            return MaximumDisplacement::Unbounded;
        }
        let travel = self.moving_kg() * w.powf(2.0 - m) / (damper.coefficient * (2.0 - m));
        MaximumDisplacement::Known(larger(self.state.plate_m + travel, so_far))
    }
}
