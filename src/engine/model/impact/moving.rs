//! What moves in a mode, as the integrator takes it: both bodies, the plate (with the projectile or without it), or the projectile
//! in a plate that rests.

use crate::model::impact::equations::{Equations, State};
use crate::model::impact::modes::Contact;
use crate::numerics::step::{Acceleration, Point, Slopes};

/// The motion of `D` places from a state on.
#[derive(Debug)]
pub(super) struct Moving<'a, const D: usize> {
    pub(super) equations: Equations<'a>,
    pub(super) start: State,
}

/// Which places move.
pub(super) trait Places<const D: usize> {
    /// Of something for the projectile's travel and something for the plate's displacement what is for the places that move.
    fn moving<T>(&self, travel: T, displacement: T) -> [T; D];

    /// The state at a point, after a time from the start.
    fn state(&self, t: f64, point: &Point<D>) -> State;
}

impl Places<2> for Moving<'_, 2> {
    fn moving<T>(&self, travel: T, displacement: T) -> [T; 2] {
        [travel, displacement]
    }

    fn state(&self, t: f64, ([q_m, x_m], [u_m_s, w_m_s]): &Point<2>) -> State {
        let t_s = self.start.t_s + t;
        State { t_s, q_m: *q_m, u_m_s: *u_m_s, x_m: *x_m, w_m_s: *w_m_s }
    }
}

impl Places<1> for Moving<'_, 1> {
    fn moving<T>(&self, travel: T, displacement: T) -> [T; 1] {
        [if self.equations.plate_rests() { travel } else { displacement }]
    }

    fn state(&self, t: f64, ([place], [speed]): &Point<1>) -> State {
        let Self { equations: Equations { setup, mode }, start } = self;
        let t_s = start.t_s + t;
        if self.equations.plate_rests() {
            return State { t_s, q_m: *place, u_m_s: *speed, ..*start };
        }
        let state = State { t_s, x_m: *place, w_m_s: *speed, ..*start };
        if mode.contact == Contact::Fused {
            return state;
        }
        // A projectile that is through, or before the plate, keeps its velocity.
        let v = setup.projectile_m_s(start);
        let q_m = start.q_m + v * t - setup.cos * (place - start.x_m);
        State { q_m, u_m_s: v - setup.cos * speed, ..state }
    }
}

impl<const D: usize> Moving<'_, D>
where
    Self: Places<D>,
{
    pub(super) fn point(&self, state: &State) -> Point<D> {
        (self.moving(state.q_m, state.x_m), self.moving(state.u_m_s, state.w_m_s))
    }
}

impl<const D: usize> Acceleration<D> for Moving<'_, D>
where
    Self: Places<D>,
{
    fn at(&self, t: f64, point: &Point<D>) -> [f64; D] {
        let (slip, plate) = self.equations.accelerations(&self.state(t, point));
        self.moving(slip, plate)
    }

    /// Whatever the time: a force history has no slope by place or speed.
    fn slopes(&self, point: &Point<D>) -> Slopes<D> {
        let Slopes { place, speed } = self.equations.slopes(&self.state(0.0, point));
        let part = |rows: [[f64; 2]; 2]| {
            let [slip, plate] =
                rows.map(|[travel, displacement]| self.moving(travel, displacement));
            self.moving(slip, plate)
        };
        Slopes { place: part(place), speed: part(speed) }
    }

    fn sizes(&self, point: &Point<D>) -> Point<D> {
        let State { q_m, u_m_s, x_m, w_m_s, .. } = self.state(0.0, point);
        let (travel, slip) = self.equations.sizes_of_travel(q_m, u_m_s);
        let (place, speed) = self.equations.sizes_of_plate(x_m, w_m_s);
        (self.moving(travel, place), self.moving(slip, speed))
    }

    fn rounding(&self, t: f64, point: &Point<D>) -> [f64; D] {
        let (slip, plate) = self.equations.rounding(&self.state(t, point));
        self.moving(slip, plate)
    }
}
