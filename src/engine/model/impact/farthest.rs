//! Maximum displacement of the plate, the reversal there, and plates that have neither.

use crate::model::impact::resolution::{NEGLIGIBLE, RESOLUTION};
use crate::model::impact::results::ImpactRun;
use crate::model::impact::state::State;
use crate::model::run::{Event, EventKind};
use crate::numerics::larger;

impl ImpactRun<'_> {
    /// Returns `true` if the plate has not reached its final maximum displacement.
    pub(super) fn is_before_max_displacement(&self) -> bool {
        let reached_m = self.record.farthest_m;
        self.decided.is_some_and(|(_, far_m)| far_m - reached_m > RESOLUTION * far_m.abs())
    }

    /// Returns the maximum displacement, m; up to the horizon if nothing stops the plate.
    pub(super) fn max_displacement_m(&self) -> Option<f64> {
        let so_far_m = self.record.farthest_m;
        match self.decided {
            Some((_, far_m)) if far_m.is_finite() => Some(larger(far_m, so_far_m)),
            Some(_) => (!self.has_no_horizon()).then_some(so_far_m),
            // For an undecided run it is final if the energy allows no more; not with the weight, which adds energy.
            None if self.setup.weight_n > 0.0 => None,
            None => {
                let equations = self.equations();
                let reach_m = equations.max_reachable_displacement_m(
                    &self.state,
                    equations.energy_left_j(&self.state),
                );
                (reach_m - so_far_m <= NEGLIGIBLE * so_far_m.abs()).then_some(so_far_m)
            }
        }
    }

    /// Returns `true` if the spring drives the plate without end: its force has no bound, or no end.
    pub(super) fn is_driven_away(&self) -> bool {
        let is_endless = self.decided.is_some_and(|(_, far_m)| far_m.is_infinite());
        let least_j = || self.mode.elastic.least_energy(self.state.x_m, f64::INFINITY);
        is_endless && self.has_no_horizon() && least_j().is_infinite()
    }

    /// Returns displacement, m, and time, s, of the reversal at the maximum displacement. A run that is decided just before it ends with a
    /// constant deceleration; a plate that only approaches its maximum has none at rest.
    pub(super) fn turn(&self) -> Option<[f64; 2]> {
        if self.setup.is_rigid_mount {
            return None;
        }
        let far_m = self.record.farthest_m;
        let is_there = |x_m: f64| far_m - x_m <= RESOLUTION * far_m.abs();
        self.record.turn.filter(|[x_m, _]| is_there(*x_m)).or_else(|| {
            let equations = self.equations();
            let x_m = equations.displacement_m(self.state.x_m);
            let at_rest = State { w_m_s: 0.0, ..self.state };
            let left_s = -self.state.w_m_s / equations.accelerations(&at_rest).1;
            let turns =
                !self.is_before_max_displacement() && is_there(x_m) && !equations.plate_rests();
            let is_soon = left_s > 0.0 && left_s * self.state.w_m_s <= RESOLUTION * far_m.abs();
            (self.decided.is_some() && turns && is_soon).then_some([far_m, self.state.t_s + left_s])
        })
    }

    /// Marks the reversal at the maximum displacement. One on a stop has the events of the stop.
    pub(super) fn mark_turn(&self, events: &mut Vec<Event>) {
        let Some([_, t_s]) = self.turn() else { return };
        let place = events.partition_point(|event| event.t_s < t_s);
        if events.get(place).is_none_or(|event| event.t_s > t_s) {
            events.insert(place, Event { t_s, kind: EventKind::GreatestDisplacement });
        }
    }
}
