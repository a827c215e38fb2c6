//! Laws that are not smooth at zero: how a plate leaves and approaches that, and when one that is infinitely steep there holds it.

use crate::model::contact_models::Law;
use crate::model::impact::equations::{Equations, Setup, State};
use crate::model::impact::modes::{Event, Hold};
use crate::numerics::{larger, smaller};

/// Length of the first moments in which the contact's force is taken to grow with the time, in passages of a tip radius or, where it is
/// shorter, the time in which the contact stops the projectile: they change the velocities by about the square of this.
const FIRST_MOMENT: f64 = 1e-6;
/// How many times farther, or faster, its inertia alone must let a plate move that is to follow the balance of a law: the square of the
/// oscillations about that, in radians, which leave a part of one over it.
const FOLLOWS: f64 = 1e2;
/// Part of the tip radius by which a steep spring, and of the impact velocity by which a steep damper, may yield while it is taken to
/// hold the plate: the travel is as far off at most.
const HELD: f64 = 1e-13;
/// Part of what a steep law holds at which it takes hold again: it does not let go at once.
const AGAIN: f64 = 0.5;
/// Passages of a tip radius for which a damper that takes hold of the plate does not let go: to hold for less saves no steps.
const SOON: f64 = 1e-3;
/// How many times what a step may be off by, of the depth, a plate may move that its steep spring has taken hold of again: the tolerance of
/// a run.
const RETURNED: f64 = 1e2;
/// Part of the way to the zero of a law that is not smooth there that a step goes.
const APPROACH: f64 = 0.55;

impl Setup {
    /// Displacement by which a steep spring may yield while it is taken to hold the plate at first.
    pub(super) fn held_m(&self) -> f64 {
        HELD * self.geometry.nose.radius_m
    }

    /// The same once it has taken hold again, at a travel of the projectile.
    pub(super) fn returned_m(&self, q_m: f64) -> f64 {
        RETURNED * self.tolerance * smaller(q_m, self.geometry.nose.radius_m)
    }
}

impl Equations<'_> {
    /// Passage of a tip radius at the impact velocity, s.
    fn passage_s(&self) -> f64 {
        self.setup.geometry.nose.radius_m / self.setup.velocity_m_s
    }

    fn first_moment_s(&self) -> f64 {
        let Setup { velocity_m_s, projectile_kg, .. } = *self.setup;
        let slope_n_m = self.contact_slopes(0.0, velocity_m_s).0;
        FIRST_MOMENT * smaller(self.passage_s(), (projectile_kg / slope_n_m).sqrt())
    }

    /// The first moments of a contact with an uncocked plate whose spring or damper is steep at zero, by the balance of forces: the
    /// plate yields to the contact's, which grows with the time unless a damper makes it begin at once, as far as its inertia, its
    /// spring or its damper lets it, whichever holds it most.
    pub(super) fn after_first_moment(&self) -> State {
        let t_s = self.first_moment_s();
        let setup = self.setup;
        let v = setup.velocity_m_s;
        let moment = State { t_s, q_m: v * t_s, u_m_s: v, ..State::default() };
        let force_n = self.contact_n(&moment);
        let at_once = self.contact_n(&State { u_m_s: v, ..State::default() }) > 0.0;
        let grows = if at_once { 0.0 } else { 1.0 };
        let push_n = force_n * setup.cos;
        let inertia = (grows + 1.0) * (grows + 2.0) * setup.plate_kg;
        let by_inertia = (push_n * t_s * t_s / inertia, grows + 2.0);
        let at_m = setup.spring.at_force(push_n);
        let by_spring = (at_m, grows * push_n / (at_m * setup.spring.tangent(at_m)));
        let power = grows / setup.damper.exponent + 1.0;
        let by_damper = (setup.damper.at_force(push_n) * t_s / power, power);
        let (x_m, power) = [by_spring, by_damper]
            .into_iter()
            .fold(by_inertia, |least, other| if other.0 < least.0 { other } else { least });
        let w_m_s = power * x_m / t_s;
        let lost_m_s = force_n * t_s / ((grows + 1.0) * setup.projectile_kg);
        State {
            q_m: moment.q_m - setup.cos * x_m,
            u_m_s: v - lost_m_s - setup.cos * w_m_s,
            x_m,
            w_m_s,
            ..moment
        }
    }

    /// The steep law that holds the plate at first, if one does, and the displacement up to which a spring does, m: inertia alone would
    /// let the plate move much farther by the time the law yields, so that it follows the balance of contact and law from there on.
    pub(super) fn holds_at_first(&self) -> Option<(Hold, f64)> {
        let setup = self.setup;
        if !setup.starts_steep() || setup.law != Law::Flow {
            return None;
        }
        let state = State { u_m_s: setup.velocity_m_s, ..State::default() };
        let rate_n_s = self.rate_n_s(&state).abs();
        let by_inertia_m_s = |held_n: f64| held_n * held_n / rate_n_s / (2.0 * setup.plate_kg);
        let by_inertia_m = |held_n: f64| by_inertia_m_s(held_n) * held_n / rate_n_s / 3.0;
        let (spring_n, damper_n) = (self.held_n(Hold::Spring), self.held_n(Hold::Damper));
        let mut held_m = self.mode.held_m;
        let follows = by_inertia_m(spring_n) / (FOLLOWS * held_m);
        if follows < 1.0 {
            // The way by inertia grows with the force's third power: below an exponent of a third it is the farther, the earlier.
            let earlier = 1.0 - 3.0 * held_m * setup.spring.tangent(held_m) / spring_n;
            held_m *= if earlier > 0.0 { follows.powf(1.0 / earlier) } else { 0.0 };
        }
        let spring_n = if spring_n > 0.0 { setup.spring.force(held_m) } else { 0.0 };
        let is_followed = by_inertia_m_s(damper_n) > FOLLOWS * self.held_m_s();
        let damper_n = if is_followed { damper_n } else { 0.0 };
        let hold = if spring_n > damper_n { Hold::Spring } else { Hold::Damper };
        let held_s = larger(spring_n, damper_n) / rate_n_s;
        (held_s > self.first_moment_s()).then_some((hold, held_m))
    }

    /// How fast the contact's force on a plate at rest grows, N/s.
    fn rate_n_s(&self, state: &State) -> f64 {
        let slopes = self.contact_slopes(state.q_m, state.u_m_s);
        let slows_m_s2 = self.contact_n(state) / self.setup.projectile_kg;
        (slopes.0 * state.u_m_s - slopes.1 * slows_m_s2) * self.setup.cos
    }

    /// Whether a steep damper takes hold of the plate: it is as good as at rest, and what drives it does not make the damper yield soon.
    fn is_held_by_damper(&self, state: &State) -> bool {
        let soon_n = self.rate_n_s(state).abs() * SOON * self.passage_s();
        state.w_m_s.abs() < AGAIN * self.held_m_s()
            && self.net_n(state, Hold::Damper).abs() + soon_n < AGAIN * self.held_n(Hold::Damper)
    }

    /// Whether a steep spring takes hold of the plate again: the force that has displaced it falls, and it can move by no more any more
    /// than what a step may be off by many times over, and less than it has moved.
    fn is_held_by_spring(&self, state: &State, farthest_m: f64) -> bool {
        let spring = &self.setup.spring;
        let held_m = AGAIN * self.setup.returned_m(state.q_m);
        let speed_j = 0.5 * self.moving_kg() * state.w_m_s * state.w_m_s;
        self.setup.law == Law::Flow
            && spring.is_steep_at_zero()
            && held_m < farthest_m
            && self.net_n(state, Hold::Spring).abs() < spring.force(held_m)
            && speed_j + spring.energy(self.displacement_m(state.x_m)) < spring.energy(held_m)
            && self.rate_n_s(state) <= 0.0
    }

    /// The event of a steep law that takes hold of a plate which has moved this far.
    pub(super) fn takes_hold(&self, state: &State, farthest_m: f64) -> Option<Event> {
        if self.mode.hold != Hold::Free || !self.setup.is_steep() {
            None
        } else if self.is_held_by_damper(state) {
            Some(Event::DamperHolds)
        } else {
            self.is_held_by_spring(state, farthest_m).then_some(Event::SpringHolds)
        }
    }

    fn held_m_s(&self) -> f64 {
        HELD * self.setup.velocity_m_s
    }

    /// The force that a steep spring holds with a displacement, or a steep damper with a velocity, that does not count, N.
    fn held_n(&self, hold: Hold) -> f64 {
        let Setup { spring, damper, .. } = self.setup;
        match hold {
            Hold::Spring if spring.is_steep_at_zero() => spring.force(self.mode.held_m),
            Hold::Damper if damper.is_steep_at_zero() => damper.force(self.held_m_s()),
            _ => 0.0,
        }
    }

    /// The force that a law has to hold: of a damper also that of a spring that is tight.
    fn net_n(&self, state: &State, hold: Hold) -> f64 {
        let contact_n = self.contact_n(state) * self.setup.cos;
        if hold == Hold::Spring { contact_n } else { contact_n - self.mechanism_n(state.x_m, 0.0) }
    }

    /// What the steep law that holds the plate could hold besides, N.
    pub(super) fn spare_n(&self, state: &State) -> f64 {
        let hold = self.mode.hold;
        self.held_n(hold) - self.net_n(state, hold).abs()
    }

    /// Displacement and velocity of a plate that a steep law has held and that begins to follow the force.
    pub(super) fn balanced(&self, state: &State) -> (f64, f64) {
        let Setup { spring, damper, .. } = self.setup;
        let net_n = self.net_n(state, self.mode.hold);
        if self.mode.hold == Hold::Spring {
            let x_m = spring.at_force(net_n.abs()).copysign(net_n);
            return (x_m - self.mode.origin_m, self.rate_n_s(state) / spring.tangent(x_m));
        }
        // The force has grown with the time, the velocity with its power 1/m.
        let w_m_s = damper.at_force(net_n.abs()).copysign(net_n);
        (state.x_m + w_m_s * state.t_s / (1.0 / damper.exponent + 1.0), w_m_s)
    }

    /// The zero of a spring that is not smooth there: the time until the plate comes to it, s, and whether the energy that is left in the
    /// spring still counts; `None` where the plate does not come to one.
    fn next_zero(&self, state: &State) -> Option<(f64, bool)> {
        let spring = &self.setup.spring;
        spring.power().filter(|law| !law.is_smooth_at_zero())?;
        let (x_m, w_m_s) = (self.displacement_m(state.x_m), state.w_m_s);
        let way_s = -x_m / w_m_s;
        let counts = spring.energy(x_m) > HELD * self.moving_kg() * w_m_s * w_m_s;
        (self.mode.hold == Hold::Free && way_s > 0.0).then_some((way_s, counts))
    }

    /// Whether the plate is so close to the zero of such a spring that it is as well as far on the other side: no other force does
    /// anything meanwhile, and there is no stop between.
    pub(super) fn passes_zero(&self, state: &State) -> bool {
        let Some((way_s, false)) = self.next_zero(state) else { return false };
        let (slip, plate) = self.accelerations(&State { x_m: -self.mode.origin_m, ..*state });
        way_s * larger(slip.abs(), plate.abs()) < HELD * state.w_m_s.abs()
            && self.setup.stop_at_m.abs() > self.displacement_m(state.x_m).abs()
    }

    /// The time in which the plate comes as close to the zero of a law that is not smooth there as a step may take it, s: short of
    /// that it is as far away as the step is long, where no polynomial is far off. Infinite where so little is left that it may pass.
    pub(super) fn approach_s(&self, state: &State) -> f64 {
        let Setup { damper, .. } = self.setup;
        let by_spring = self.next_zero(state).filter(|(_, counts)| *counts);
        let mut least_s = by_spring.map_or(f64::INFINITY, |(way_s, _)| way_s);
        if !damper.is_smooth_at_zero() {
            let w_m_s = state.w_m_s;
            let way_s = -w_m_s / self.accelerations(state).1;
            let counts = damper.force(w_m_s).abs() * way_s > self.moving_kg() * self.held_m_s();
            if way_s > 0.0 && counts {
                least_s = smaller(least_s, way_s);
            }
        }
        APPROACH * least_s
    }
}
