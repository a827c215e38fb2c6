//! Bounds by energy: how far the plate can go with what is left, how hard the interface can be loaded, how deep the hole can get.

use super::Body;
use crate::model::run::Mode;
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, smaller};

/// Energy below this part of the projectile's at first contact counts as none: velocities of 1e-12 of the impact's.
pub(in crate::model::impact) const NO_ENERGY: f64 = 1e-24;
/// How far a stop that yields to a spring driving the plate away is followed, m.
const STOP_TRAVEL_MAX_M: f64 = 1e3;
/// How many times the path that the energy above the holding oscillation pays for is left to slips: the last one may take some
/// more.
const SLIP_RESERVE: f64 = 1.25;

impl Body<'_> {
    pub(in crate::model::impact) fn moving_kg(&self) -> f64 {
        if self.mode == Mode::Fused { self.problem.joined_kg } else { self.problem.plate_kg }
    }

    /// Energy of the plate (with the projectile, when joined), spring and elastic stop, J.
    pub(in crate::model::impact) fn energy_j(&self) -> f64 {
        let w = self.state.plate_m_s;
        0.5 * self.moving_kg() * w * w + self.potential_j(self.state.plate_m)
    }

    /// Energy in spring and elastic stop at a displacement, J.
    pub(super) fn potential_j(&self, x: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let pressed = larger(x - mechanism.stop_at_m, 0.0);
        let stop = mechanism
            .elastic_stop()
            .map_or(0.0, |stop| 0.5 * stop.stiffness_n_m * pressed * pressed);
        mechanism.spring.energy(x) + stop
    }

    /// Energy of plate, projectile, spring and elastic stop, J.
    pub(in crate::model::impact) fn energy_left_j(&self) -> f64 {
        let apart_j = if self.mode == Mode::Fused {
            0.0
        } else {
            let v = self.state.projectile_m_s(self.problem.cos);
            0.5 * self.problem.projectile_kg * v * v
        };
        self.energy_j() + apart_j
    }

    /// Whether what still moves has no more than this part of the projectile's energy at first contact.
    pub(in crate::model::impact) fn has_less_than(&self, part: f64) -> bool {
        let problem = self.problem;
        let v = problem.velocity_m_s;
        let at_start = 0.5 * problem.projectile_kg * v * v;
        // Where the spring drives the plate away, its energy is less than nothing.
        self.energy_j() <= part * at_start
            && problem.mechanism.spring.drives_away(self.state.plate_m).is_none()
    }

    /// How far forward the plate can go with this energy, m; infinite when nothing stops it.
    pub(in crate::model::impact) fn reach_with(&self, energy: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let spring = mechanism.spring.forward(self.state.plate_m, energy);
        smaller(spring, mechanism.stop_at_m + self.pressed_with(energy))
    }

    /// How far the plate can press its elastic stop with this energy, m; zero where it does not come so far. It is found by
    /// itself: as a difference of displacements it would keep few digits far from the spring's zero.
    fn pressed_with(&self, energy: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let Some(stop) = mechanism.elastic_stop() else { return 0.0 };
        let spring_reach = mechanism.spring.forward(self.state.plate_m, energy);
        if spring_reach <= mechanism.stop_at_m {
            return 0.0;
        }
        let at = mechanism.stop_at_m;
        let stiffness = stop.stiffness_n_m;
        let pull = |pressed: f64| mechanism.spring.force(at + pressed) + stiffness * pressed;
        let missing = |pressed: f64| {
            mechanism.spring.energy(at + pressed) + 0.5 * stiffness * pressed * pressed - energy
        };
        let mut far = smaller(spring_reach - at, (2.0 * energy.abs() / stiffness).sqrt());
        // A spring that drives the plate away presses it farther than that.
        while far > 0.0 && missing(far) < 0.0 && far < spring_reach - at && far < STOP_TRAVEL_MAX_M
        {
            far = 2.0 * far + mechanism.spring.force(at + far).abs() / stiffness;
        }
        if missing(far) < 0.0 && far >= STOP_TRAVEL_MAX_M {
            return f64::INFINITY;
        }
        // Of the two places with this potential the farther one: beyond where spring and stop hold each other.
        let near = larger(self.state.plate_m - at, 0.0);
        let lowest = if pull(near) < 0.0 { in_bracket(near, far, pull) } else { near };
        in_bracket(lowest, far, missing)
    }

    /// Whether the plate cannot go farther than it has been, whatever becomes of the energy there is.
    pub(in crate::model::impact) fn displacement_is_greatest(&self, so_far: f64) -> bool {
        self.reach_with(self.energy_left_j()) <= so_far * (1.0 + 1e-12)
    }

    /// Whether the plate has left its elastic stop with nothing to bring it back.
    fn leaves_for_good(&self) -> bool {
        let mechanism = &self.problem.mechanism;
        mechanism.spring.is_absent()
            && self.state.plate_m_s <= 0.0
            && !self.stop_touches
            && self.state.plate_m <= mechanism.stop_at_m
    }

    /// The most the interface can be pushed with this much energy left, N.
    pub(in crate::model::impact) fn push_at(&self, energy_j: f64) -> f64 {
        if self.leaves_for_good() {
            // A damper holds back: it pulls.
            return 0.0;
        }
        let mechanism = &self.problem.mechanism;
        let speed = (2.0 * energy_j / self.moving_kg()).sqrt();
        let reach = self.reach_with(energy_j);
        let spring = mechanism.spring.greatest_push(self.state.plate_m, energy_j, reach);
        let stop = mechanism.elastic_stop().map_or(0.0, |stop| {
            let pressed = self.pressed_with(energy_j);
            if pressed > 0.0 || self.stop_touches {
                stop.stiffness_n_m * pressed + stop.damping_n_s_m * speed
            } else {
                0.0
            }
        });
        self.problem.interface_fraction * (spring + stop + mechanism.damper.force(speed))
    }

    /// The most the interface can be pulled with this much energy left, N.
    pub(in crate::model::impact) fn pull_at(&self, energy_j: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        if mechanism.spring.is_absent() && self.state.plate_m_s >= 0.0 && mechanism.stop.is_none() {
            // Nothing sends the plate back: the damper only pushes against the projectile.
            return 0.0;
        }
        let speed = (2.0 * energy_j / self.moving_kg()).sqrt();
        let spring = mechanism.spring.greatest_pull(self.state.plate_m, energy_j);
        self.problem.interface_fraction * (spring + mechanism.damper.force(speed))
    }

    /// Whether a projectile that still slips to and fro within its hole neither comes to its bottom nor out of it.
    ///
    /// Each slip begins with more energy than the oscillation has in which the friction just holds, and loses some of it. So the
    /// paths of all slips to come but the last add up to no more than what the friction needs to take the energy above that.
    pub(in crate::model::impact) fn yielding_stays_within(&self, energy_j: f64) -> bool {
        let (geometry, q) = (&self.problem.geometry, self.state.travel_m);
        let way = smaller(q, self.deepest_m - q);
        let mechanism = &self.problem.mechanism;
        if way <= 0.0 || mechanism.rigid_stop().is_some() {
            return false;
        }
        let area = smaller(geometry.area_m2(q - way), geometry.area_m2(q + way));
        let friction = self.problem.grip * self.problem.strength_pa * area;
        let left_j = energy_j - friction * way / SLIP_RESERVE;
        left_j >= self.potential_j(self.state.plate_m)
            && self.push_at(left_j) <= friction
            && self.pull_at(left_j) <= friction
    }

    /// The greatest depth for which there is energy left, m: all of it at work at the bottom of the hole. `None` where that would
    /// be enough to perforate, or where a spring may give more than it has taken.
    pub(in crate::model::impact) fn depth_at_most_m(&self) -> Option<f64> {
        let problem = self.problem;
        let geometry = &problem.geometry;
        problem.mechanism.spring.power().filter(|_| problem.flows())?;
        let swept = geometry.swept_m3(self.deepest_m) + self.energy_left_j() / problem.strength_pa;
        if swept.is_nan() || swept >= geometry.swept_m3(geometry.exit_m) {
            return None;
        }
        let travel_m =
            in_bracket(self.deepest_m, geometry.exit_m, |q| geometry.swept_m3(q) - swept);
        Some(geometry.depth_m(travel_m))
    }
}
