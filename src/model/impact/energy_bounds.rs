//! What can still happen at the most, by the energy that is left: how far the plate, how deep the hole, whether slips end inside it.

use crate::model::impact::track::Track;
use crate::model::run::Mode;
use crate::numerics::root::in_bracket;
use crate::numerics::smaller;

/// How many times the path that the energy above the holding swing pays for is left to slips: the last one may take some more.
const SLIP_RESERVE: f64 = 1.25;

impl Track<'_> {
    /// Whether a projectile that still slips to and fro within its hole neither comes to its bottom nor out of it.
    ///
    /// Each slip begins with more energy than the swing has in which the friction just holds, and loses some of it. So the paths of
    /// all slips to come but the last add up to no more than what the friction needs to take the energy above that.
    pub(super) fn slips_stay_within(&self, energy_j: f64) -> bool {
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

    /// Whether the plate cannot go farther than it has been, whatever becomes of the energy there is.
    pub(super) fn has_been_farthest(&self) -> bool {
        let so_far = self.record.farthest_m;
        self.reach_with(self.energy_left_j()) <= so_far * (1.0 + 1e-12)
    }

    /// The greatest depth for which there is energy left, m: all of it at work at the bottom of the hole. `None` where that would be
    /// enough to perforate, or where a spring may give more than it has taken.
    pub(super) fn depth_at_most_m(&self) -> Option<f64> {
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

    /// Energy of plate, projectile, spring and elastic stop, J.
    pub(super) fn energy_left_j(&self) -> f64 {
        let apart_j = if self.mode == Mode::Fused {
            0.0
        } else {
            let v = self.state.slip_m_s + self.state.plate_m_s * self.problem.cos;
            0.5 * self.problem.projectile_kg * v * v
        };
        self.energy_j() + apart_j
    }
}
