//! Energy of the bodies, and the displacements, speeds and loads that it still allows.

use crate::model::impact::equations::Equations;
use crate::model::impact::modes::Contact;
use crate::model::impact::state::State;
use crate::numerics::{larger, smaller};

impl Equations<'_> {
    /// Returns the energy of the plate (with the projectile if fused), the spring and the elastic stop, J.
    pub(super) fn energy_j(&self, state: &State) -> f64 {
        0.5 * self.moving_kg() * state.w_m_s * state.w_m_s + self.potential_j(state.x_m)
    }

    /// Returns the total energy of plate, projectile, spring and elastic stop, J.
    pub(super) fn energy_left_j(&self, state: &State) -> f64 {
        let v = self.setup.projectile_m_s(state);
        let apart_j = match self.mode.contact {
            Contact::Fused | Contact::Perforated => 0.0,
            _ => 0.5 * self.setup.mass.projectile_kg * v * v,
        };
        self.energy_j(state) + apart_j
    }

    /// Returns the greatest displacement of the plate, m, and its greatest velocity, m/s, that the energy allows.
    pub(super) fn swing(&self, state: &State) -> [f64; 2] {
        let energy_j = self.energy_j(state);
        [
            self.max_reachable_displacement_m(state, energy_j).abs(),
            (2.0 * energy_j / self.moving_kg()).sqrt(),
        ]
    }

    /// Returns the rounding error of the energy, J: that of forces which balance far from the zero of the spring.
    pub(super) fn energy_rounding_j(&self, state: &State) -> f64 {
        let x_m = self.displacement_m(state.x_m);
        self.mechanism_rounding_n(state.x_m, 0.0) * x_m.abs()
    }

    fn potential_j(&self, x_m: f64) -> f64 {
        self.mode.elastic.energy(self.displacement_m(x_m))
    }

    fn stops_rigidly(&self) -> bool {
        self.setup.stop.restitution.is_some()
    }

    /// Returns `true` without a damper and without a damping stop.
    pub(super) fn is_undamped(&self) -> bool {
        self.setup.damper.is_absent() && self.setup.stop.damping_n_s_m == 0.0
    }

    /// Returns an upper bound of the displacement of the plate with a given energy, m from the zero of the spring.
    pub(super) fn max_reachable_displacement_m(&self, state: &State, energy_j: f64) -> f64 {
        let by_spring = self.mode.elastic.reach(self.displacement_m(state.x_m), energy_j, 1.0);
        smaller(by_spring, self.setup.rigid_stop_m())
    }

    /// Returns `true` if the plate can reach its rigid stop with a given energy.
    pub(super) fn meets_rigid_stop(&self, state: &State, energy_j: f64) -> bool {
        self.stops_rigidly()
            && self.max_reachable_displacement_m(state, energy_j) >= self.setup.stop.position_m
    }

    /// Returns `true` if the plate moves backwards and no force acts on it there.
    pub(super) fn leaves(&self, state: &State) -> bool {
        let x_m = self.displacement_m(state.x_m);
        state.w_m_s <= 0.0 && self.mode.elastic.is_slack(f64::NEG_INFINITY, x_m)
    }

    /// Returns an upper bound of the speed of the plate (with the projectile if fused) with a given energy in the range of that energy, m/s:
    /// by the energy, and by the damper, which slows down what is faster than its balance with the greatest force of spring, elastic stop
    /// and weight.
    pub(super) fn greatest_speed_m_s(
        &self,
        state: &State,
        energy_j: f64,
        [back_m, reach_m]: [f64; 2],
    ) -> f64 {
        let Equations { setup, mode } = self;
        let free_j = larger(energy_j - mode.elastic.least_energy(back_m, reach_m), 0.0)
            + self.energy_rounding_j(state);
        let (least_n, most_n) = mode.elastic.forces_between(back_m, reach_m);
        let balance_m_s = setup.damper.at_force(larger(most_n, -least_n));
        smaller((2.0 * free_j / self.moving_kg()).sqrt(), larger(state.w_m_s.abs(), balance_m_s))
    }

    /// Returns the displacements between which the plate stays with a given energy, m from the zero of the spring.
    pub(super) fn range_m(&self, state: &State, energy_j: f64) -> [f64; 2] {
        let back_m = self.mode.elastic.reach(self.displacement_m(state.x_m), energy_j, -1.0);
        [back_m, self.max_reachable_displacement_m(state, energy_j)]
    }

    /// Returns upper bounds of the compression and the tension of the fused interface with a given energy, N.
    pub(super) fn peak_load_bounds_n(&self, state: &State, energy_j: f64) -> [f64; 2] {
        let Equations { setup, mode } = self;
        let has_nothing = mode.spring.is_absent() && !setup.has_stop();
        let range_m = self.range_m(state, energy_j);
        let [back_m, reach_m] = range_m;
        let (least_n, most_n) = mode.elastic.forces_between(back_m, reach_m);
        let speed = self.greatest_speed_m_s(state, energy_j, range_m);
        let stop_n =
            if reach_m > setup.stop.position_m { setup.stop.damping_n_s_m * speed } else { 0.0 };
        let damper_n = setup.damper.force(speed);
        let goes_on = has_nothing && state.w_m_s >= 0.0;
        let push_n = if self.leaves(state) { 0.0 } else { most_n + stop_n + damper_n };
        let pull_n = if goes_on { 0.0 } else { damper_n - least_n };
        let loads_n = [push_n, pull_n].map(|load_n| setup.interface_fraction() * load_n);
        self.loads_with_weight_n(loads_n)
    }

    /// Returns the direction in which spring and elastic stop accelerate the plate without end; `None` otherwise, or with a rigid stop.
    pub(super) fn drives_away(&self, state: &State) -> Option<f64> {
        let x_m = self.displacement_m(state.x_m);
        self.mode.elastic.drives_away(x_m).filter(|_| !self.stops_rigidly())
    }
}
