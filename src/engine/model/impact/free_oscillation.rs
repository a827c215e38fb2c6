//! Free oscillation of the plate about the balance of contact and spring, as far as a computation leaves it out.
//!
//! On a stiff or steep spring the plate follows the contact force and oscillates about the balance. An L-stable method damps what it cannot
//! resolve, and two such computations of the same scene damp the same: their difference does not show it. The laws bound it instead.
//!
//! - From a short swing on a spring that holds the plate: it keeps its action, the integral of w dx over a period.
//! - From rest: the force F' t moves the plate by inertia alone, F' t³/6 m, until the spring balances it; the plate arrives there at a
//!   displacement x with a velocity above that of the balance. With n = 1 the amplitude is x/6^(1/2); with n = 1/3 the balance is the exact
//!   solution, and below there is no such start.
//! - At a corner of the area law: the forces of both pieces differ by dF. In the time of one radian of the oscillation this moves
//!   the balance by dF over the stiffness. For dF ~ t^r the amplitude is gamma(r + 1) times that: at most twice for r from 1 to 2.
//! - While the stiffness changes slowly, amplitude² times frequency is constant; a damper reduces it.

use std::f64::consts::PI;

use crate::model::impact::dense_output::DenseOutput;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::PlateConstraint;
use crate::model::impact::resolution::FIRST_ORDER;
use crate::model::impact::state::State;
use crate::numerics::collocation::FILTER;
use crate::numerics::{larger, smaller};

/// Phase in a step, rad, above which the method damps the oscillation: a little more than its number of stages.
const RESOLVED_RAD: f64 = 12.0;

/// Oscillation as the square root of its action: amplitude times the square root of the angular frequency, m/s^(1/2).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct FreeOscillation {
    /// Excited so far.
    excited: f64,
    /// Damped by the method so far.
    pub(super) left_out: f64,
    /// Whether the plate was locked in a slip of a plastic interface.
    pub(super) is_lost_in_slip: bool,
}

impl FreeOscillation {
    /// Adds the oscillation that a start from rest or from a short swing excites.
    pub(super) fn start(&mut self, equations: &Equations<'_>) {
        self.excited += equations.excited_at_start();
        if equations.mode.hold == PlateConstraint::Spring {
            // The action of the swing is at most 4 times amplitude times velocity, that of the later oscillation pi amplitude² frequency.
            let setup = equations.setup;
            let product = setup.first_swing_m() * setup.start.w_m_s.abs();
            self.excited += (4.0 / PI * product).sqrt();
        }
    }

    /// Adds the oscillation that the corner between the area laws of two modes excites, at a state after it.
    pub(super) fn corner(&mut self, [before, after]: [&Equations<'_>; 2], state: &State) {
        self.excited += after.excited_at_corner(before, state);
    }

    /// Follows a step.
    pub(super) fn step(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        let is_locked = equations.mode.hold == PlateConstraint::Spring;
        self.is_lost_in_slip |= is_locked && equations.is_touching() && !equations.is_loading();
        if self.excited == 0.0 {
            return;
        }
        let (from, to) = (&path.looks[0], path.end());
        let span_s = to.t_s - from.t_s;
        match equations.mode.hold {
            PlateConstraint::Free => {
                let slope_n_s_m = equations.damper_slope_n_s_m(to.w_m_s);
                self.excited *= (-0.5 * slope_n_s_m * span_s / equations.moving_kg()).exp();
                if equations.is_balanced(from) && equations.is_balanced(to) {
                    let most = equations.damped_at_most(from, span_s);
                    self.left_out = larger(self.left_out, smaller(self.excited, most));
                }
            }
            PlateConstraint::Spring => self.left_out = larger(self.left_out, self.excited),
            PlateConstraint::OnStop | PlateConstraint::Mount => {}
        }
    }
}

impl Equations<'_> {
    /// Returns the angular frequency of a small oscillation about a displacement, rad/s.
    fn radians_per_s(&self, at_m: f64) -> f64 {
        (self.mode.spring.tangent(at_m) / self.setup.mass.plate_kg).sqrt()
    }

    /// Returns the amplitudes of displacement, m, and velocity, m/s, at a displacement from the zero of the spring; 0 without stiffness.
    pub(super) fn amplitudes(&self, left_out: f64, at_m: f64) -> [f64; 2] {
        let radians_per_s = self.radians_per_s(at_m);
        if left_out == 0.0 || !radians_per_s.is_finite() || radians_per_s == 0.0 {
            return [0.0; 2];
        }
        let amplitude_m = left_out / radians_per_s.sqrt();
        [amplitude_m, amplitude_m * radians_per_s]
    }

    /// Returns `true` while the spring about balances the contact.
    fn is_balanced(&self, state: &State) -> bool {
        let push_n = self.contact_n(state) * self.setup.cos;
        let spring_n = self.mode.spring.force(self.displacement_m(state.x_m));
        self.is_touching() && (spring_n - push_n).abs() < FIRST_ORDER * push_n.abs()
    }

    /// Returns the oscillation that a step can damp: none in a few radians; in more, what the filtered error estimate of the step accepts.
    fn damped_at_most(&self, from: &State, span_s: f64) -> f64 {
        let radians_per_s = self.radians_per_s(self.displacement_m(from.x_m));
        let phase = span_s * radians_per_s;
        if phase < RESOLVED_RAD {
            return 0.0;
        }
        let accepted_m = self.setup.numerics.tolerance * self.error_scales(from).0[1];
        let filtered = 1.0 + (FILTER * phase).powi(2);
        accepted_m * filtered * radians_per_s.sqrt()
    }

    /// Returns the oscillation of a plate that a contact force proportional to time pushes from rest against its spring.
    fn excited_at_start(&self) -> f64 {
        let setup = self.setup;
        // With this exponent the balance is the exact solution.
        let self_similar = 1.0 / 3.0;
        let Some(law) = setup.spring.power().filter(|law| law.exponent > self_similar) else {
            return 0.0;
        };
        let state = State { u_m_s: setup.reference.velocity_m_s, ..State::default() };
        let starts = setup.start.x_m == 0.0 && setup.start.w_m_s == 0.0 && !law.is_absent();
        if !starts || self.contact_n(&state) > 0.0 {
            return 0.0;
        }
        // x = F' t³/6 m and k x^n = F' t.
        let rate_n_s = self.rate_n_s(&state);
        let part = (6.0 * setup.mass.plate_kg / rate_n_s).cbrt() * rate_n_s / law.coefficient;
        let balanced_m = part.powf(1.0 / (law.exponent - self_similar));
        // Amplitude on a linear spring, relative to the displacement of the balance.
        let amplitude = (1.0_f64 / 6.0).sqrt();
        amplitude * balanced_m * self.radians_per_s(balanced_m).sqrt()
    }

    /// Returns the oscillation that the corner between the area law of another mode and the present one excites.
    fn excited_at_corner(&self, before: &Equations<'_>, state: &State) -> f64 {
        let at_m = match self.mode.hold {
            PlateConstraint::Free if self.is_balanced(state) => self.displacement_m(state.x_m),
            PlateConstraint::Spring => self.quasi_static_state(state).0,
            _ => return 0.0,
        };
        let (radians_per_s, slope_n_m) = (self.radians_per_s(at_m), self.mode.spring.tangent(at_m));
        let excited_m = |direction: f64| {
            let q_m = state.q_m + direction * state.u_m_s / radians_per_s;
            let there = State { q_m, ..*state };
            (self.contact_n(&there) - before.contact_n(&there)).abs() * self.setup.cos / slope_n_m
        };
        // At most twice the shift of the balance within one radian.
        let excited = 2.0 * larger(excited_m(1.0), excited_m(-1.0)) * radians_per_s.sqrt();
        if excited.is_finite() { excited } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::modes::{Contact, HybridMode};
    use crate::model::impact::tests::{is_near, look};

    /// On a linear spring x = (F'/k)(t - sin(w t)/w) from rest, with w² = k/m; F' is (2/3) 2 pi R (`S_y` + `C_d` rho v²/2) v.
    #[test]
    fn valid_a_start_from_rest_oscillates_as_on_a_linear_spring() {
        let start = |pairs: &str| {
            look(pairs, Contact::Penetrating, [0.0; 4], |it, _| {
                it.amplitudes(it.excited_at_start(), 1e-6)[0]
            })
        };
        let rate_n_s = PI * 0.0127 / 1.5 * (1.52e8 + 6.775e6) * 100.0;
        let exact_m = rate_n_s / 1e9 / (1e9 / 0.0295f64).sqrt();
        assert!(is_near(start("gamma=1 k=1e9"), exact_m, 1e-12), "{exact_m:e}");
        for pairs in ["gamma=1 k=1e9 n=0.3", "gamma=1 k=1e9 d=1mm", "gamma=1 k=0"] {
            assert!(start(pairs) < f64::MIN_POSITIVE, "{pairs}");
        }
    }

    /// Where the dishing ends, at a travel of h + 2 R, the depth of the nose grows 1.5 times as fast. A slope of the force that grows by J
    /// excites J/(k w); the bound is twice that.
    #[test]
    fn valid_a_corner_of_the_area_law_oscillates_by_the_change_of_its_slope() {
        let q_m = 2e-3 + 0.0127;
        let (contact, pairs) = (Contact::Penetrating, "gamma=1 k=1e9 h=2mm C_d=0 v_i=400");
        let found = look(pairs, contact, [q_m, 50.0, 0.0, 0.0], |it, at| {
            let [before, after] =
                [at.q_m.next_down(), at.q_m].map(|q_m| it.setup.geometry.piece(q_m));
            let before = HybridMode { piece: before, ..it.mode.clone() };
            let after = HybridMode { piece: after, ..it.mode.clone() };
            let [before, after] = [&before, &after].map(|mode| Equations { setup: it.setup, mode });
            let x_m = after.contact_n(at) / 1e9;
            let balanced = State { x_m, ..*at };
            let excited = after.excited_at_corner(&before, &balanced);
            let jump_m = after.contact_slopes(q_m, 50.0).0 - before.contact_slopes(q_m, 50.0).0;
            // Off the balance a corner is nothing that a step could damp.
            let off = State { x_m: 2.0 * x_m, ..*at };
            assert!(after.excited_at_corner(&before, &off) < f64::MIN_POSITIVE);
            (after.amplitudes(excited, x_m)[0], jump_m)
        });
        let exact_m = found.1.abs() * 50.0 / 1e9 / (1e9 / 0.0295f64).sqrt();
        assert!(found.0 > 1.5 * exact_m && found.0 < 2.5 * exact_m, "{found:?} {exact_m:e}");
    }
}
