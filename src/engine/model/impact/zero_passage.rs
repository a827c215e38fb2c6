//! Passage of the plate through the singular zero of its spring.
//!
//! Near its zero a power law has no derivative of some order by time, and steps towards it would shrink without end. By displacement the
//! spring's part is exact: with its energy V and the acceleration a by all other forces, w²/2 + V/m grows by the integral of a dx. Time and
//! motion of the projectile are integrals of dx/w. With x in proportion to a power of the variable of integration, all integrands are smooth,
//! and the integrals are those of Radau IIA collocation, once up to the zero and once from there on.

use std::array;

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::events::{event_function, possible_events};
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::modes::{Contact, Event, PlateConstraint};
use crate::model::impact::resolution::{NEGLIGIBLE, ROUNDING};
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;
use crate::model::power_law::PowerLaw;
use crate::numerics::collocation::ELEVEN;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Greatest distance from the zero, relative to that at which the spring has the whole energy, as a variable of integration: in the run and
/// in the second computation of an error estimate. At that distance the integrands have a singularity; eleven nodes leave an error of some
/// 1e-13 of the motion.
const REACH: [f64; 2] = [0.58, 0.5];
/// Step size towards the zero, relative to the time until the plate reaches it: as far as polynomials are accurate.
const APPROACH: f64 = 0.45;
/// Number of nodes of a passage up to the zero, and from there on.
const NODES: usize = 11;
/// Maximum number of iterations for the forces, for the state at a time, and for an end before another event. The forces need more only where
/// one changes so fast that the nodes do not resolve it.
const ROUNDS_MAX: usize = 10;

/// Passage of the plate through the zero of its spring.
#[derive(Debug)]
pub(super) struct ZeroPassage {
    from: State,
    zero: State,
    /// State at its end.
    pub(super) to: State,
    /// Work of the damper, J.
    damper_j: f64,
    /// Event at its end; `None` beyond the zero.
    pub(super) event: Option<Event>,
}

/// States at the nodes on the way to or from the zero, and the work of the damper, J.
type Way = ([State; NODES], f64);

impl Equations<'_> {
    /// Returns the maximum step size towards the singular zero of the spring, s; `None` if the plate does not move towards one, or if the
    /// energy in the spring is negligible.
    pub(super) fn towards_zero_s(&self, state: &State) -> Option<f64> {
        let spring = &self.setup.spring;
        spring.power().filter(|law| !law.is_smooth_on_each_side())?;
        let (x_m, w_m_s) = (self.displacement_m(state.x_m), state.w_m_s);
        if self.mode.hold != PlateConstraint::Free || x_m * w_m_s >= 0.0 {
            return None;
        }
        let (square, given) = (w_m_s * w_m_s, 2.0 * spring.energy(x_m) / self.moving_kg());
        // Velocity at the zero, if the plate gets there.
        let there_m_s = larger(square + given - 2.0 * self.others(state).1 * x_m, 0.0).sqrt();
        let way_s = 2.0 * x_m.abs() / (w_m_s.abs() + there_m_s);
        // No step has to end before a zero where the spring is this weak, if no passage leads across it.
        let least = match self.setup.numerics.method {
            IntegrationMethod::Collocation(_) | IntegrationMethod::Second(_) => {
                self.setup.threshold_factor() * NEGLIGIBLE.sqrt()
            }
            _ => ROUNDING,
        };
        (given > 2.0 * least * square).then_some(APPROACH * way_s)
    }

    /// Returns the greatest energy of the spring, relative to the kinetic energy at the zero. Methods that are there for comparison step
    /// through everything that counts.
    fn passed_at_most(&self, law: PowerLaw) -> f64 {
        let is_steady = self.setup.law == ContactLaw::Flow || !self.is_touching();
        let at = |reach: f64| reach.powf(f64::from(power(law)) * (law.exponent + 1.0));
        match self.setup.numerics.method {
            _ if !Rule::ZeroPassed.applies() => 0.0,
            IntegrationMethod::Collocation(_) if is_steady => at(REACH[0]),
            IntegrationMethod::Second(_) if is_steady => at(REACH[1]),
            _ => ROUNDING,
        }
    }

    /// Returns the passage through the zero of the spring, or to an event before it; `None` if the plate is too far from it, for ends close
    /// beyond it, and at the horizon.
    pub(super) fn zero_passage(&self, state: &State, horizon_s: f64) -> Option<ZeroPassage> {
        let Equations { setup, mode } = self;
        let law = setup.spring.power().filter(|law| !law.is_smooth_on_each_side())?;
        let (from_m, w_m_s) = (self.displacement_m(state.x_m), state.w_m_s);
        if mode.hold != PlateConstraint::Free || mode.is_pressed || from_m * w_m_s >= 0.0 {
            return None;
        }
        let kinetic_j = 0.5 * self.moving_kg() * w_m_s * w_m_s + law.integral(from_m);
        // Other forces may do no more work than the spring.
        let changed_j = self.passed_at_most(law) * kinetic_j;
        let others_n = self.moving_kg() * self.others(state).1.abs();
        let reach_m = smaller(law.at_integral(changed_j), changed_j / others_n);
        if from_m.abs() > reach_m {
            return None;
        }
        let (inward, inward_j) = self.way(state, 0.0)?;
        let zero = inward[NODES - 1];
        if let Some((node, event)) = self.first_event(state, &inward) {
            let before = if node > 0 { inward[node - 1] } else { *state };
            return self.up_to_event(state, [&before, &inward[node]], event);
        }
        let mut to_m = reach_m.copysign(w_m_s);
        for _ in 0..ROUNDS_MAX {
            let Some((outward, outward_j)) = self.way(&zero, to_m) else {
                to_m = -from_m;
                continue;
            };
            match self.first_event(&zero, &outward) {
                None => {
                    let (to, damper_j) = (outward[NODES - 1], inward_j + outward_j);
                    let passage = ZeroPassage { from: *state, zero, to, damper_j, event: None };
                    return (to.t_s <= horizon_s).then_some(passage);
                }
                Some((0, _)) => return None,
                Some((node, _)) => to_m = self.displacement_m(outward[node - 1].x_m),
            }
        }
        None
    }

    /// Returns the way of fused bodies to an event that precedes the zero, between two states; `None` unless it is between them. Without a grip
    /// they part where the damper balances the spring, too close to the zero for a step to end there.
    fn up_to_event(&self, state: &State, ends: [&State; 2], event: Event) -> Option<ZeroPassage> {
        let gap = |state: &State| event_function(self, event, state);
        let [before, after] = ends;
        let is_fused = self.mode.contact == Contact::Fused;
        if !is_fused || gap(before) <= 0.0 || gap(after) > 0.0 {
            return None;
        }
        let from_m = self.displacement_m(state.x_m);
        // Of the way there, for a root relative to it.
        let there = |part: f64| self.way(state, (1.0 - part) * from_m);
        let part = |at: &State| 1.0 - self.displacement_m(at.x_m) / from_m;
        let missing = |part: f64| there(part).map_or(0.0, |(states, _)| gap(&states[NODES - 1]));
        let (states, damper_j) = there(bracketed_root(part(before), part(after), missing))?;
        let to = states[NODES - 1];
        Some(ZeroPassage { from: *state, zero: to, to, damper_j, event: Some(event) })
    }

    /// Returns the accelerations of projectile and plate by all forces but the spring's.
    fn others(&self, state: &State) -> (f64, f64) {
        let at_zero = State { x_m: -self.mode.origin_m, ..*state };
        let (slip, plate) = self.accelerations(&at_zero);
        (slip + plate * self.setup.cos, plate)
    }

    /// Returns the states on the way to a displacement on the same side of the zero, or at it; `None` if the iteration does not converge
    /// fast.
    fn way(&self, from: &State, to_m: f64) -> Option<Way> {
        let Equations { setup, mode } = self;
        let law = setup.spring.power()?;
        let kg = self.moving_kg();
        let from_m = self.displacement_m(from.x_m);
        let far_m = if from_m.abs() > to_m.abs() { from_m } else { to_m };
        let power = power(law);
        let part = |x_m: f64| (x_m / far_m).powf(1.0 / f64::from(power));
        let (from_z, to_z) = (part(from_m), part(to_m));
        let places = ELEVEN.nodes().map(|node| {
            let z = from_z + (to_z - from_z) * node;
            let before = far_m * z.powi(power - 1);
            (before * z, f64::from(power) * before * (to_z - from_z))
        });
        let spring: [f64; NODES] =
            places.map(|(x_m, _)| (law.integral(from_m) - law.integral(x_m)) / kg);
        let v = setup.projectile_m_s(from);
        let mut states = [*from; NODES];
        let mut forces = [self.others(from); NODES];
        // Changes of the forces, as changes of the velocities.
        let lasts_s = ((to_m - from_m) / from.w_m_s).abs();
        let (slip_m_s, plate_m_s) = (setup.reference.velocity_m_s, from.w_m_s.abs());
        for _ in 0..ROUNDS_MAX {
            let gained = ELEVEN.integrals(&array::from_fn(|i| forces[i].1 * places[i].1));
            let speed = |i: usize| from.w_m_s * from.w_m_s + 2.0 * (gained[i] + spring[i]);
            let speeds: [f64; NODES] = array::from_fn(|i| speed(i).sqrt().copysign(from.w_m_s));
            let rates: [f64; NODES] = array::from_fn(|i| places[i].1 / speeds[i]);
            let spans_s = ELEVEN.integrals(&rates);
            let faster = ELEVEN.integrals(&array::from_fn(|i| forces[i].0 * rates[i]));
            let ways_m = ELEVEN.integrals(&array::from_fn(|i| (v + faster[i]) * rates[i]));
            let mut change = 0.0;
            for i in 0..NODES {
                let (x_m, w_m_s) = (places[i].0, speeds[i]);
                let t_s = from.t_s + spans_s[i];
                states[i] = State { t_s, x_m: x_m - mode.origin_m, w_m_s, ..*from };
                if mode.contact != Contact::Fused {
                    states[i].q_m += ways_m[i] - setup.cos * (x_m - from_m);
                    states[i].u_m_s = v + faster[i] - setup.cos * w_m_s;
                }
                let (slip, plate) = self.others(&states[i]);
                let of_slip = (slip - forces[i].0).abs() * lasts_s / slip_m_s;
                let of_plate = (plate - forces[i].1).abs() * lasts_s / plate_m_s;
                change += of_slip + of_plate;
                forces[i] = (slip, plate);
            }
            // It contracts fast: the next change is far smaller.
            if change <= ROUNDING {
                let powers = array::from_fn(|i| self.damper_n(speeds[i]) * places[i].1);
                return Some((states, ELEVEN.integrals(&powers)[NODES - 1]));
            }
        }
        None
    }

    /// Returns the first node at which an event function is not positive, or about which it may not be, and the event.
    fn first_event(&self, start: &State, states: &[State; NODES]) -> Option<(usize, Event)> {
        let is_other = |event: &Event| !matches!(event, Event::KnotAhead | Event::KnotBehind);
        let of_event = |event: Event| {
            let gap = |state: &State| event_function(self, event, state);
            let gaps = states.each_ref().map(gap);
            let first = (0..NODES).find(|&node| {
                let (here, after) = (gaps[node], gaps.get(node + 1).copied());
                let before = if node > 0 { gaps[node - 1] } else { gap(start) };
                // The parabola through three samples is at most an eighth of its bend below the least.
                let bend = after.map_or(0.0, |after| before - 2.0 * here + after);
                let is_least = here < before && after.is_some_and(|after| here < after);
                here <= 0.0 || is_least && here < 0.5 * bend
            });
            first.map(|node| (node, event))
        };
        let events = possible_events(self.setup, self.mode).filter(is_other);
        events.filter_map(of_event).min_by_key(|(node, _)| *node)
    }

    /// Returns the works in the hole, of the damper and of the weight on a passage, J. The first follows from the balance of energy.
    pub(super) fn passage_works_j(&self, passage: &ZeroPassage) -> [f64; 3] {
        let ZeroPassage { from, to, damper_j, .. } = passage;
        let weight_j = self.weight_work_j(from, to);
        let energy_j = |state: &State| {
            self.kinetic_j(state) + self.setup.spring.energy(self.displacement_m(state.x_m))
        };
        let lost_j = energy_j(from) - energy_j(to) + weight_j - damper_j;
        [if self.is_touching() { lost_j } else { 0.0 }, *damper_j, weight_j]
    }

    /// Returns the state at a fraction of the displacement of a passage.
    pub(super) fn passes(&self, passage: &ZeroPassage, fraction: f64) -> State {
        let ZeroPassage { from, zero, to, .. } = passage;
        let [from_m, to_m] = [from, to].map(|state| self.displacement_m(state.x_m));
        let x_m = (1.0 - fraction) * from_m + fraction * to_m;
        let start = if x_m * from_m >= 0.0 { from } else { zero };
        match fraction {
            0.0 => *from,
            1.0 => *to,
            _ => self.way(start, x_m).map_or(*start, |(states, _)| states[NODES - 1]),
        }
    }

    /// Returns the state at a fraction of the time of a passage.
    pub(super) fn passes_at_time(&self, passage: &ZeroPassage, fraction: f64) -> State {
        let ZeroPassage { from, to, .. } = passage;
        let t_s = from.t_s + fraction * (to.t_s - from.t_s);
        let mut place = fraction;
        // Newton's method: time is nearly in proportion to the displacement.
        let mut state = self.passes(passage, place);
        for _ in 0..ROUNDS_MAX {
            let change = state.w_m_s * (t_s - state.t_s) / (to.x_m - from.x_m);
            place += change;
            state = self.passes(passage, place);
            // It converges quadratically.
            if change.abs() < NEGLIGIBLE.sqrt() {
                break;
            }
        }
        state
    }
}

/// Returns p in x = X z^p, with the variable of integration z: high enough that V, in proportion to z^(p (n + 1)), is smooth.
fn power(law: PowerLaw) -> i32 {
    let is_smooth_by_square = matches!(law.exponent, 0.5) || law.exponent > 1.0;
    if is_smooth_by_square { 2 } else { 3 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::modes::HybridMode;
    use crate::model::impact::tests::{is_near, look};
    use crate::numerics::incomplete_beta::incomplete_beta;
    use crate::numerics::quadrature::gauss;

    /// Looks at a state (q, u, x, w) of a plate that moves freely backwards.
    fn passing<T>(
        pairs: &str,
        contact: Contact,
        state: [f64; 4],
        of: impl Fn(&Equations<'_>, &State, Option<ZeroPassage>) -> T,
    ) -> T {
        look(pairs, contact, state, |it, at| {
            let mode = HybridMode { hold: PlateConstraint::Free, w_side: -1.0, ..it.mode.clone() };
            let it = Equations { setup: it.setup, mode: &mode };
            of(&it, at, it.zero_passage(at, f64::INFINITY))
        })
    }

    /// Alone on k x^n a plate of energy E comes from the part z of it in the spring to the zero in X/(n+1) (m/2E)^(1/2) B(z; 1/(n+1), 1/2),
    /// where X is its greatest displacement.
    #[test]
    fn valid_a_plate_alone_passes_in_the_time_of_its_energy() {
        let kg = 0.0295;
        for n in [0.05, 0.2, 0.3, 0.5, 0.55, 0.7, 0.9, 1.2, 1.5, 1.8, 2.5, 4.0f64] {
            let (power, k) = (n + 1.0, 1e5);
            let way_s = |x: f64, energy: f64| {
                let far = (power * energy / k).powf(1.0 / power);
                let part = k * x.abs().powf(power) / (power * energy);
                let beta = incomplete_beta([part, 1.0 - part], [1.0 / power, 0.5]);
                far / power * (kg / (2.0 * energy)).sqrt() * beta
            };
            let law = PowerLaw { coefficient: k, exponent: n };
            let most = REACH[0].powf(power * f64::from(super::power(law)));
            for part in [0.9 * most, 1e-3 * most] {
                let energy = 0.5 * kg * 400.0 / (1.0 - part);
                let from_m = (part * power * energy / k).powf(1.0 / power);
                let pairs = format!("gamma=1 k={k} n={n}");
                let state = [0.1, 30.0, from_m, -20.0];
                let to = passing(&pairs, Contact::Perforated, state, |_, _, it| it.unwrap().to);
                let exact_s = way_s(from_m, energy) + way_s(to.x_m, energy);
                let passed_s = to.t_s - 1e-4;
                assert!(is_near(passed_s, exact_s, 1e-12), "n={n}: {passed_s:e} {exact_s:e}");
                let left = energy - k * to.x_m.abs().powf(power) / power;
                assert!(is_near(to.w_m_s, -(2.0 * left / kg).sqrt(), 1e-14), "n={n}");
                assert!(to.x_m < 0.0, "n={n}: {to:?}");
            }
        }
    }

    /// Along the cylinder behind the nose g A S is constant: w² grows by twice its acceleration times the way, besides what the spring gives,
    /// and the projectile slows evenly, for the time that the integral of dx/w gives.
    #[test]
    fn valid_friction_in_the_hole_slows_both_bodies_on_a_passage() {
        let friction_n = 0.1 * std::f64::consts::PI * 6.35e-3 * 6.35e-3 * 1.52e8;
        let pairs = "gamma=7 k=1e6 n=0.5 interface=plastic";
        let [u, x, w] = [-9.0, 6e-5, -7.0];
        let state = [12e-3, u, x, w];
        let to = passing(pairs, Contact::Withdrawing, state, |_, _, it| it.unwrap().to);
        let (shot_kg, plate_kg) = (0.0295, 7.0 * 0.0295);
        let plate = |x: f64| 1e6 / 1.5 * x.abs().powf(1.5) / plate_kg;
        let square =
            |at: f64| w * w + 2.0 * (plate(x) - plate(at)) - 2.0 * friction_n / plate_kg * (at - x);
        assert!(is_near(to.w_m_s, -square(to.x_m).sqrt(), 1e-14), "{to:?}");
        // In x = z² the integrand is smooth.
        let half_s = |far: f64| {
            gauss(0.0, far.abs().sqrt(), 8, |z| 2.0 * z / square(z * z * far.signum()).sqrt())
        };
        let t_s = half_s(x) + half_s(to.x_m);
        assert!(is_near(to.t_s - 1e-4, t_s, 1e-12), "{:e} {t_s:e}", to.t_s - 1e-4);
        let v = u + w + friction_n / shot_kg * t_s;
        assert!(is_near(to.u_m_s, v - to.w_m_s, 1e-12), "{to:?} {v}");
        let way_m = (u + w + 0.5 * friction_n / shot_kg * t_s) * t_s - (to.x_m - x);
        assert!(is_near(to.q_m - 12e-3, way_m, 1e-11), "{to:?} {way_m:e}");
    }

    /// A passage ends before a slip does. One that would end before the zero, or about there, is followed by steps.
    #[test]
    fn a_passage_books_no_end_of_a_slip() {
        let end_of = |u_m_s: f64| {
            let state = [4e-3, u_m_s, 2e-5, -7.0];
            let pairs = "gamma=7 k=1e6 n=0.5 interface=plastic";
            passing(pairs, Contact::Closing, state, |_, _, it| it.map(|it| it.to))
        };
        let [far, near] = [3.0, 0.3].map(|u_m_s| end_of(u_m_s).unwrap());
        assert!(far.u_m_s > 0.0 && near.u_m_s > 0.0 && far.x_m < near.x_m && near.x_m < 0.0);
        assert!(end_of(1e-3).is_none());
    }

    #[test]
    fn states_on_a_passage_lead_from_its_start_to_its_end() {
        let pairs = "gamma=7 k=1e6 n=0.5 interface=plastic";
        let state = [4e-3, 3.0, 2e-5, -7.0];
        passing(pairs, Contact::Closing, state, |equations, at, it| {
            let passage = it.unwrap();
            assert_eq!(
                (equations.passes(&passage, 0.0), equations.passes(&passage, 1.0)),
                (*at, passage.to)
            );
            let span_s = passage.to.t_s - at.t_s;
            for part in [0.1, 0.5, 0.9] {
                let (place, time) =
                    (equations.passes(&passage, part), equations.passes_at_time(&passage, part));
                let way_m = passage.to.x_m - at.x_m;
                assert!(is_near(place.x_m - at.x_m, part * way_m, 1e-12), "{part}: {place:?}");
                assert!(is_near(time.t_s - at.t_s, part * span_s, 1e-9), "{part}: {time:?}");
            }
        });
    }

    /// A damper b w^5 takes more than the velocity on the way to the zero; half way, at a velocity near zero, it would have no force.
    #[test]
    fn a_plate_that_its_damper_stops_passes_no_zero() {
        let state = [0.1, 30.0, 4e-3, -1.0];
        let passes = |b: f64| {
            let pairs = format!("gamma=1 k=1 n=2.3 m=5 b={b}");
            passing(&pairs, Contact::Perforated, state, |_, _, it| it.is_some())
        };
        // b w^4 x / m_2 is the relative change of the velocity on the way.
        assert!(passes(1e-5) && !passes(0.0295 / 4e-3) && !passes(1.0));
    }

    /// With b w the velocity falls by b/m times the way where the spring is weak, and the damper takes b w on it.
    #[test]
    fn valid_a_damper_takes_its_force_along_the_way() {
        let state = [0.1, 30.0, 1e-3, -1.0];
        let works_j =
            passing("gamma=1 k=1e-9 n=2.3 b=0.2", Contact::Perforated, state, |it, _, found| {
                let passage = found.unwrap();
                let way_m = 1e-3 - passage.to.x_m;
                let exact_j = 0.2 * (way_m - 0.5 * 0.2 / 0.0295 * way_m * way_m);
                (it.passage_works_j(&passage)[1], exact_j)
            });
        assert!(is_near(works_j.0, works_j.1, 1e-9), "{works_j:?}");
    }
}
