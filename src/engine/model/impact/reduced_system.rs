//! Active degrees of freedom of a mode: both bodies, the plate with or without the projectile, or the projectile in a resting plate.

use std::array;

use crate::model::impact::equations::Equations;
use crate::model::impact::modes::Contact;
use crate::model::impact::state::State;
use crate::numerics::step::{Jacobian, Point, SecondOrderOde};

/// Equations of motion from a state on, for `D` active degrees of freedom: travel of the projectile and displacement of the plate, or one.
pub(super) struct ReducedSystem<'a, const D: usize> {
    pub(super) equations: Equations<'a>,
    pub(super) start: State,
}

impl<const D: usize> ReducedSystem<'_, D> {
    /// Returns the index of the first active body.
    fn first(&self) -> usize {
        usize::from(D == 1 && !self.equations.plate_rests())
    }

    /// Selects the values of the active degrees of freedom from those of both bodies.
    fn moving<T: Copy>(&self, both: [T; 2]) -> [T; D] {
        let first = self.first();
        array::from_fn(|d| both[first + d])
    }

    pub(super) fn point(&self, state: &State) -> Point<D> {
        (self.moving([state.q_m, state.x_m]), self.moving([state.u_m_s, state.w_m_s]))
    }

    /// Returns the state at a point, after a time from the start.
    pub(super) fn state(&self, t: f64, (places, speeds): &Point<D>) -> State {
        let Self { equations: Equations { setup, mode }, start } = self;
        let mut both = [(start.q_m, start.u_m_s), (start.x_m, start.w_m_s)];
        for d in 0..D {
            both[self.first() + d] = (places[d], speeds[d]);
        }
        let [(q_m, u_m_s), (x_m, w_m_s)] = both;
        let state = State { t_s: start.t_s + t, q_m, u_m_s, x_m, w_m_s };
        if self.first() == 0 || mode.contact == Contact::Fused {
            return state;
        }
        // A projectile out of contact has a constant velocity.
        let v = setup.projectile_m_s(start);
        let q_m = start.q_m + v * t - setup.cos * (x_m - start.x_m);
        State { q_m, u_m_s: v - setup.cos * w_m_s, ..state }
    }
}

impl<const D: usize> SecondOrderOde<D> for ReducedSystem<'_, D> {
    fn at(&self, t: f64, point: &Point<D>) -> [f64; D] {
        self.moving(self.equations.accelerations(&self.state(t, point)).into())
    }

    /// Returns the Jacobian, independent of time: a force history depends on neither position nor velocity.
    fn slopes(&self, point: &Point<D>) -> Jacobian<D> {
        let Jacobian { place, speed } = self.equations.slopes(&self.state(0.0, point));
        let part = |rows: [[f64; 2]; 2]| self.moving(rows.map(|row| self.moving(row)));
        Jacobian { place: part(place), speed: part(speed) }
    }

    fn sizes(&self, point: &Point<D>) -> Point<D> {
        let (places, speeds) = self.equations.error_scales(&self.state(0.0, point));
        (self.moving(places), self.moving(speeds))
    }

    fn rounding(&self, t: f64, point: &Point<D>) -> [f64; D] {
        self.moving(self.equations.rounding(&self.state(t, point)).into())
    }
}
