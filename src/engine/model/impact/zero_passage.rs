//! Passage of the plate through the singular zero of its spring.
//!
//! Near its zero the spring has a small fraction of the energy of the moving mass. The plate passes from x to about -x in the time 2 x/w: the
//! spring shifts it by k x^n T²/(2 (n + 2) m), all other forces are those half way, and the velocity follows from the energy. What is left
//! out is of second order in the fraction of the spring, and of third order in the change of velocity by the other forces.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::events::{event_function, possible_events};
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::modes::{Contact, Event, PlateConstraint};
use crate::model::impact::resolution::{ROUNDING, TOLERANCE_RATIO};
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;

/// Energy of the spring, relative to twice the kinetic energy, below which the plate passes its zero at once.
const PASSED_ENERGY: f64 = 1e-6;
/// Change of the velocities by other forces meanwhile, relative to these.
const PASSED_CHANGE: f64 = 3e-5;

impl Equations<'_> {
    /// Returns the largest fraction of the energy of the spring and of the velocities that a passage neglects to first order. Methods that are
    /// there for comparison step through everything else.
    fn passed_fractions(&self) -> [f64; 2] {
        if !Rule::ZeroPassed.applies() {
            return [0.0; 2];
        }
        let is_steady = self.setup.law == ContactLaw::Flow || !self.is_touching();
        let fraction = match self.setup.numerics.method {
            IntegrationMethod::Collocation(_) if is_steady => 1.0,
            IntegrationMethod::Second(_) if is_steady => TOLERANCE_RATIO,
            _ => return [ROUNDING; 2],
        };
        [fraction * PASSED_ENERGY, fraction * PASSED_CHANGE]
    }

    /// Returns the time until the plate reaches the singular zero of its spring, s; `None` if it does not move towards one, or passes it at
    /// once.
    pub(super) fn until_zero_s(&self, state: &State) -> Option<f64> {
        self.next_zero(state).filter(|(_, counts)| *counts).map(|(way_s, _)| way_s)
    }

    /// Returns the time until the plate reaches the singular zero of its spring, s, and whether the energy in the spring is not small; `None`
    /// if the plate does not move towards such a zero.
    fn next_zero(&self, state: &State) -> Option<(f64, bool)> {
        let spring = &self.setup.spring;
        spring.power().filter(|law| !law.is_smooth_at_zero())?;
        let (x_m, w_m_s) = (self.displacement_m(state.x_m), state.w_m_s);
        let way_s = -x_m / w_m_s;
        let [fraction, _] = self.passed_fractions();
        let counts = spring.energy(x_m) > fraction * self.moving_kg() * w_m_s * w_m_s;
        (self.mode.hold == PlateConstraint::Free && way_s > 0.0).then_some((way_s, counts))
    }

    /// Returns the state beyond the zero of the spring; `None` if the plate does not pass it at once, or another event can precede.
    pub(super) fn passed_zero(&self, state: &State) -> Option<State> {
        let Equations { setup, mode } = self;
        let (way_s, false) = self.next_zero(state)? else { return None };
        let law = setup.spring.power().filter(|_| !mode.is_pressed)?;
        let lasts_s = 2.0 * way_s;
        let at_zero = State { x_m: -mode.origin_m, ..*state };
        let [_, fraction] = self.passed_fractions();
        let is_small = |by: f64, of: f64| lasts_s * by.abs() < fraction * of.abs();
        let are_small = |slip: f64, plate: f64| {
            is_small(plate, state.w_m_s) && (!self.is_touching() || is_small(slip, state.u_m_s))
        };
        let (slip, plate) = self.accelerations(&at_zero);
        // A strong damper could stop the plate half way, where it has no force.
        if !are_small(slip, plate) {
            return None;
        }
        let half_way = State {
            t_s: state.t_s + way_s,
            q_m: state.q_m + state.u_m_s * way_s,
            u_m_s: state.u_m_s + slip * way_s,
            w_m_s: state.w_m_s + plate * way_s,
            ..at_zero
        };
        let (slip, plate) = self.accelerations(&half_way);
        if !are_small(slip, plate) {
            return None;
        }
        let from_m = self.displacement_m(state.x_m);
        let spring_m =
            0.5 * law.force(from_m) * lasts_s * lasts_s / (self.moving_kg() * (law.exponent + 2.0));
        let to_m = -from_m + 0.5 * plate * lasts_s * lasts_s - spring_m;
        let gained = plate * (to_m - from_m)
            + (law.integral(from_m) - law.integral(to_m)) / self.moving_kg();
        let (x_m, w_m_s) = (
            to_m - mode.origin_m,
            (state.w_m_s * state.w_m_s + 2.0 * gained).sqrt().copysign(state.w_m_s),
        );
        let mut to = State { t_s: state.t_s + lasts_s, x_m, w_m_s, ..*state };
        if mode.contact != Contact::Fused {
            let v_m_s = setup.projectile_m_s(state);
            let slows_m_s = (slip + plate * setup.cos) * lasts_s;
            to.q_m += (v_m_s + 0.5 * slows_m_s) * lasts_s - setup.cos * (to_m - from_m);
            to.u_m_s = v_m_s + slows_m_s - setup.cos * w_m_s;
        }
        let is_other = |event: &Event| !matches!(event, Event::KnotAhead | Event::KnotBehind);
        let mut others = possible_events(setup, mode).filter(is_other);
        let goes_on = others.all(|event| event_function(self, event, &to) > 0.0);
        goes_on.then_some(to)
    }

    /// Returns the works in the hole, of the damper and of the weight on a passage, J. The first follows from the balance of energy.
    pub(super) fn passage_works_j(&self, [from, to]: [&State; 2]) -> [f64; 3] {
        let weight_j = self.weight_work_j(from, to);
        let damper_j = self.damper_n(from.w_m_s) * from.w_m_s * (to.t_s - from.t_s);
        let energy_j = |state: &State| {
            self.kinetic_j(state) + self.setup.spring.energy(self.displacement_m(state.x_m))
        };
        let lost_j = energy_j(from) - energy_j(to) + weight_j - damper_j;
        [if self.is_touching() { lost_j } else { 0.0 }, damper_j, weight_j]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::modes::HybridMode;
    use crate::model::impact::tests::{is_near, look};

    /// The time from x to about -x is the integral of dx over the velocity, which follows from the energy: here by the midpoint rule.
    #[test]
    fn valid_a_plate_alone_passes_in_the_time_of_its_energy() {
        for (n, from_m) in [(0.5, 3e-7), (0.2, 5e-9), (1.5, 1e-4), (2.5, 1.5e-3)] {
            let pairs = format!("gamma=1 k=1e5 n={n}");
            let k_kg = 1e5 / 0.0295;
            let state = [0.1, 30.0, from_m, -20.0];
            let passed = look(&pairs, Contact::Perforated, state, |it, at| {
                let mode =
                    HybridMode { hold: PlateConstraint::Free, w_side: -1.0, ..it.mode.clone() };
                let it = Equations { setup: it.setup, mode: &mode };
                it.passed_zero(at)
            });
            let passed = passed.unwrap();
            let square = |x: f64| {
                400.0 + 2.0 * k_kg / (n + 1.0) * (from_m.powf(n + 1.0) - x.abs().powf(n + 1.0))
            };
            let count = 200_000;
            let step_m = (from_m - passed.x_m) / f64::from(count);
            let at = |i: i32| square(from_m - step_m * (f64::from(i) + 0.5)).sqrt();
            let exact_s: f64 = (0..count).map(|i| step_m / at(i)).sum();
            // It lasts 2 x/w.
            assert!(is_near(from_m / 10.0, exact_s, 3e-12), "n={n}: {passed:?} {exact_s:e}");
            assert!(is_near(passed.w_m_s, -square(passed.x_m).sqrt(), 1e-15), "n={n}");
            assert!((passed.x_m / from_m + 1.0).abs() > 1e-9, "n={n}: {passed:?}");
        }
    }

    /// Friction of g A S on a projectile that slips at 3 m/s in a hole: the momentum of both bodies is conserved but for the spring's.
    #[test]
    fn valid_a_passage_in_the_hole_conserves_momentum_and_books_no_slip_zero() {
        let passes = |u_m_s: f64| {
            let state = [4e-3, u_m_s, 4e-9, -7.0];
            look("gamma=7 k=1e6 n=0.5 interface=plastic", Contact::Closing, state, |it, at| {
                let mode =
                    HybridMode { hold: PlateConstraint::Free, w_side: -1.0, ..it.mode.clone() };
                let it = Equations { setup: it.setup, mode: &mode };
                it.passed_zero(at).map(|to| {
                    let momentum = |it: &Equations<'_>, at: &State| {
                        it.setup.mass.projectile_kg * it.setup.projectile_m_s(at)
                            + it.setup.mass.plate_kg * at.w_m_s
                    };
                    (momentum(&it, &to) / momentum(&it, at) - 1.0, to.u_m_s / at.u_m_s - 1.0)
                })
            })
        };
        let (momentum, slip) = passes(3.0).unwrap();
        assert!(momentum.abs() < 1e-12 && slip < 0.0 && slip > -1e-4, "{momentum:e} {slip:e}");
        // A slip that may end meanwhile is followed by steps.
        assert_eq!(passes(1e-4), None);
    }

    /// A damper b w^5 takes more than the velocity on the way to the zero; half way, at a velocity near zero, it would have no force.
    #[test]
    fn a_plate_that_its_damper_stops_passes_no_zero() {
        let state = [0.1, 30.0, 4e-3, -1.0];
        let passes = |b: f64| {
            let pairs = format!("gamma=1 k=1 n=2.3 m=5 b={b}");
            look(&pairs, Contact::Perforated, state, |it, at| {
                let mode =
                    HybridMode { hold: PlateConstraint::Free, w_side: -1.0, ..it.mode.clone() };
                Equations { setup: it.setup, mode: &mode }.passed_zero(at).is_some()
            })
        };
        // b w^4 x / m_2 is the relative change of the velocity on the way.
        assert!(passes(1e-5) && !passes(0.0295 / 4e-3) && !passes(1.0));
    }
}
