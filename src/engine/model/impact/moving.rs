//! What moves in a mode, as the integrator takes it: both bodies, the plate (with the projectile or without it), or the projectile in a
//! plate that rests.

use crate::model::contact_models::History;
use crate::model::impact::equations::{Equations, KNOWN, State};
use crate::model::impact::modes::Contact;
use crate::numerics::step::{Acceleration, Point, Slopes};

/// Part of the way to the zero of a steep spring that an iteration may go at once.
const OF_THE_WAY: f64 = 0.8;
/// The places that move in a mode.
pub(super) trait Moving<const D: usize>: Acceleration<D> {
    fn equations(&self) -> &Equations<'_>;
    fn point(&self, state: &State) -> Point<D>;
    /// The state at a time and a point, from that at the start of the step.
    fn state(&self, start: &State, t_s: f64, point: &Point<D>) -> State;
}

impl Moving<2> for Both<'_> {
    fn equations(&self) -> &Equations<'_> {
        &self.0
    }

    fn point(&self, state: &State) -> Point<2> {
        ([state.q_m, state.x_m], [state.u_m_s, state.w_m_s])
    }

    fn state(&self, _: &State, t_s: f64, ([q_m, x_m], [u_m_s, w_m_s]): &Point<2>) -> State {
        State { t_s, q_m: *q_m, u_m_s: *u_m_s, x_m: *x_m, w_m_s: *w_m_s }
    }
}

impl Moving<1> for Plate<'_> {
    fn equations(&self) -> &Equations<'_> {
        &self.0
    }

    fn point(&self, state: &State) -> Point<1> {
        ([state.x_m], [state.w_m_s])
    }

    /// A projectile that is through, or before the plate, keeps its velocity.
    fn state(&self, start: &State, t_s: f64, ([x_m], [w_m_s]): &Point<1>) -> State {
        let cos = self.0.setup.cos;
        let (mut q_m, mut u_m_s) = (start.q_m, 0.0);
        if self.0.mode.contact != Contact::Joined {
            let v = self.0.setup.projectile_m_s(start);
            q_m += v * (t_s - start.t_s) - cos * (x_m - start.x_m);
            u_m_s = v - cos * w_m_s;
        }
        State { t_s, q_m, u_m_s, x_m: *x_m, w_m_s: *w_m_s }
    }
}

impl Moving<1> for Projectile<'_> {
    fn equations(&self) -> &Equations<'_> {
        &self.0
    }

    fn point(&self, state: &State) -> Point<1> {
        ([state.q_m], [state.u_m_s])
    }

    fn state(&self, start: &State, t_s: f64, ([q_m], [u_m_s]): &Point<1>) -> State {
        State { t_s, q_m: *q_m, u_m_s: *u_m_s, ..*start }
    }
}

/// A state as far as the force of a contact depends on it that has no history of its own.
fn slipping(q_m: f64, u_m_s: f64) -> State {
    State { q_m, u_m_s, ..State::default() }
}

/// Both bodies, apart or in contact: travel and displacement.
pub(super) struct Both<'a>(pub(super) Equations<'a>);

impl Acceleration<2> for Both<'_> {
    fn at(&self, place: &[f64; 2], speed: &[f64; 2]) -> [f64; 2] {
        let setup = self.0.setup;
        let contact = self.0.contact_n(&slipping(place[0], speed[0]));
        let mechanism = self.0.mechanism_n(place[1], speed[1]);
        let plate = (contact * setup.cos - mechanism) / setup.plate_kg;
        [-contact / setup.projectile_kg - plate * setup.cos, plate]
    }

    fn slopes(&self, place: &[f64; 2], speed: &[f64; 2]) -> Slopes<2> {
        let setup = self.0.setup;
        let contact = self.0.contact_slopes(place[0], speed[0]);
        let mechanism = self.0.mechanism_slopes(place[1], speed[1]);
        let plate = 1.0 / setup.plate_kg;
        let slip = 1.0 / setup.projectile_kg + setup.cos * setup.cos * plate;
        let rows = |contact: f64, mechanism: f64| {
            [
                [-contact * slip, mechanism * setup.cos * plate],
                [contact * setup.cos * plate, -mechanism * plate],
            ]
        };
        Slopes { place: rows(contact.0, mechanism.0), speed: rows(contact.1, mechanism.1) }
    }

    fn without_passing(&self, from: Point<2>, to: Point<2>) -> f64 {
        self.0.without_passing(from.0[1], to.0[1])
    }

    fn is_steep(&self) -> bool {
        self.0.setup.spring.is_steep_at_zero()
    }

    fn sizes(&self, ([q, x], [u, w]): &Point<2>) -> Point<2> {
        let (travel, slip) = self.0.sizes_of_travel(*q, *u);
        let (place, speed) = self.0.sizes_of_plate(*x, *w);
        ([travel, place], [slip, speed])
    }

    fn rounding(&self, ([q, x], [u, w]): &Point<2>) -> [f64; 2] {
        let setup = self.0.setup;
        let contact = KNOWN * self.0.contact_n(&slipping(*q, *u)).abs();
        let plate = (contact * setup.cos + self.0.mechanism_rounding_n(*x, *w)) / setup.plate_kg;
        [contact / setup.projectile_kg + plate * setup.cos, plate]
    }
}

/// The plate, with the projectile or without it: displacement.
pub(super) struct Plate<'a>(pub(super) Equations<'a>);

impl Acceleration<1> for Plate<'_> {
    fn at(&self, place: &[f64; 1], speed: &[f64; 1]) -> [f64; 1] {
        [-self.0.mechanism_n(place[0], speed[0]) / self.0.moving_kg()]
    }

    fn slopes(&self, place: &[f64; 1], speed: &[f64; 1]) -> Slopes<1> {
        let (by_place, by_speed) = self.0.mechanism_slopes(place[0], speed[0]);
        let kg = self.0.moving_kg();
        Slopes { place: [[-by_place / kg]], speed: [[-by_speed / kg]] }
    }

    fn without_passing(&self, from: Point<1>, to: Point<1>) -> f64 {
        self.0.without_passing(from.0[0], to.0[0])
    }

    fn is_steep(&self) -> bool {
        self.0.setup.spring.is_steep_at_zero()
    }

    fn sizes(&self, ([x], [w]): &Point<1>) -> Point<1> {
        let (place, speed) = self.0.sizes_of_plate(*x, *w);
        ([place], [speed])
    }

    fn rounding(&self, ([x], [w]): &Point<1>) -> [f64; 1] {
        [self.0.mechanism_rounding_n(*x, *w) / self.0.moving_kg()]
    }
}

/// The projectile in a plate that rests: travel.
pub(super) struct Projectile<'a>(pub(super) Equations<'a>);

impl Acceleration<1> for Projectile<'_> {
    fn at(&self, place: &[f64; 1], speed: &[f64; 1]) -> [f64; 1] {
        [-self.0.contact_n(&slipping(place[0], speed[0])) / self.0.setup.projectile_kg]
    }

    fn slopes(&self, place: &[f64; 1], speed: &[f64; 1]) -> Slopes<1> {
        let (by_place, by_speed) = self.0.contact_slopes(place[0], speed[0]);
        let kg = self.0.setup.projectile_kg;
        Slopes { place: [[-by_place / kg]], speed: [[-by_speed / kg]] }
    }

    fn sizes(&self, ([q], [u]): &Point<1>) -> Point<1> {
        let (travel, slip) = self.0.sizes_of_travel(*q, *u);
        ([travel], [slip])
    }
}

/// Both bodies under a prescribed force history, which the projectile follows whatever the plate does: displacement and time.
pub(super) struct Driven<'a>(pub(super) Equations<'a>, pub(super) History);

impl Acceleration<2> for Driven<'_> {
    fn at(&self, place: &[f64; 2], speed: &[f64; 2]) -> [f64; 2] {
        let Equations { setup, .. } = self.0;
        if self.0.plate_rests() {
            return [0.0; 2];
        }
        let mechanism = self.0.mechanism_n(place[0], speed[0]);
        [(self.1.force_n(place[1]) * setup.cos - mechanism) / setup.plate_kg, 0.0]
    }

    fn slopes(&self, place: &[f64; 2], speed: &[f64; 2]) -> Slopes<2> {
        let Equations { setup, .. } = self.0;
        if self.0.plate_rests() {
            return Slopes { place: [[0.0; 2]; 2], speed: [[0.0; 2]; 2] };
        }
        let (by_place, by_speed) = self.0.mechanism_slopes(place[0], speed[0]);
        let (rate, kg) = (self.1.rate_n_s(place[1]) * setup.cos, setup.plate_kg);
        Slopes {
            place: [[-by_place / kg, rate / kg], [0.0; 2]],
            speed: [[-by_speed / kg, 0.0], [0.0; 2]],
        }
    }

    fn without_passing(&self, from: Point<2>, to: Point<2>) -> f64 {
        self.0.without_passing(from.0[0], to.0[0])
    }

    fn is_steep(&self) -> bool {
        self.0.setup.spring.is_steep_at_zero()
    }

    fn sizes(&self, ([x, _], [w, _]): &Point<2>) -> Point<2> {
        let (place, speed) = self.0.sizes_of_plate(*x, *w);
        ([place, self.1.duration_s], [speed, 1.0])
    }

    fn rounding(&self, ([x, t], [w, _]): &Point<2>) -> [f64; 2] {
        let setup = self.0.setup;
        let contact = KNOWN * self.1.force_n(*t).abs();
        [(contact * setup.cos + self.0.mechanism_rounding_n(*x, *w)) / setup.plate_kg, 0.0]
    }
}

impl Moving<2> for Driven<'_> {
    fn equations(&self) -> &Equations<'_> {
        &self.0
    }

    fn point(&self, state: &State) -> Point<2> {
        ([state.x_m, state.t_s], [state.w_m_s, 1.0])
    }

    fn state(&self, start: &State, t_s: f64, ([x_m, _], [w_m_s, _]): &Point<2>) -> State {
        let Self(Equations { setup, .. }, history) = self;
        let way_m = history.travel_m(t_s) - history.travel_m(start.t_s);
        State {
            t_s,
            q_m: start.q_m + way_m - setup.cos * (x_m - start.x_m),
            u_m_s: history.velocity_m_s(t_s) - setup.cos * w_m_s,
            x_m: *x_m,
            w_m_s: *w_m_s,
        }
    }
}

impl Equations<'_> {
    /// The part of a way of the plate that does not pass the zero of a spring that is infinitely steep there.
    fn without_passing(&self, from_m: f64, to_m: f64) -> f64 {
        let [from_m, to_m] = [from_m, to_m].map(|x_m| self.displacement_m(x_m));
        let passes = self.setup.spring.is_steep_at_zero() && from_m * to_m < 0.0;
        if passes { OF_THE_WAY * from_m / (from_m - to_m) } else { 1.0 }
    }
}
