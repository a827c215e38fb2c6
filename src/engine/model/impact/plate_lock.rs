//! Treatment of springs and dampers whose slope is infinite or singular at zero (exponent < 1, or not an integer).
//!
//! - Locked plate: a spring with infinite stiffness at zero displacement moves so little that the plate is treated as fixed. It unlocks
//!   when the force exceeds what the spring balances at a small displacement, and may lock again when the force has decreased.
//! - Quasi-static plate: after unlocking, spring and contact force balance; inertia is negligible.
//! - First moment: an analytic start replaces the first step from rest, where no polynomial is accurate.
//! - Approach to zero: the step size is limited so that a step ends before the singular point; a negligible remainder is skipped.
//! - Linearised damper: below a small velocity a damper with exponent < 1 is replaced by a linear one.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::modes::{Contact, PlateConstraint};
use crate::model::impact::parameters::{ImpactParameters, Masses};
use crate::model::impact::resolution::{FIRST_ORDER, NEGLIGIBLE, ROUNDING, TOLERANCE_RATIO};
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;
use crate::numerics::{larger, smaller};

/// Displacement at which a plate may lock again, relative to that at which it unlocks; the hysteresis avoids an immediate unlock.
const RELOCK_FRACTION: f64 = 0.5;
/// Step size towards the singular zero of the damper, relative to the time until the plate reaches it. The step then ends at about its own
/// length from the zero, where polynomials are accurate.
const SINGULARITY_STEP_FRACTION: f64 = 0.55;

impl ImpactParameters {
    /// Returns the displacement below which a plate counts as fixed, m: when first locked, or in all further bounces.
    pub(super) fn held_m(&self) -> f64 {
        self.threshold_factor() * ROUNDING * self.reference.length_m
    }

    /// Returns the factor on the thresholds of this file: smaller in the second computation of an error estimate, so that the difference of
    /// both shows what the rules omit.
    pub(super) fn threshold_factor(&self) -> f64 {
        if self.is_second() { TOLERANCE_RATIO } else { 1.0 }
    }

    /// Returns `true` for the second computation of an error estimate.
    pub(super) fn is_second(&self) -> bool {
        matches!(self.numerics.method, IntegrationMethod::Second(_))
    }

    /// Returns the displacement at which a relocked plate unlocks, m, for a travel of the projectile; negligible before the contact.
    pub(super) fn relock_displacement_m(&self, q_m: f64) -> f64 {
        // The tolerance of the run.
        let tolerance = (1.0 / TOLERANCE_RATIO) * self.numerics.tolerance;
        larger(tolerance * smaller(q_m, self.reference.length_m), self.held_m())
    }
}

impl Equations<'_> {
    /// Returns the duration of the first moment, s, by the shortest time scale of the contact: `R / v_i`, or that of its stiffness or damping.
    ///
    /// Within it the contact force is constant or proportional to time. The relative error of the velocities is about the square of the
    /// duration relative to the time scale.
    fn first_moment_s(&self) -> f64 {
        let ImpactParameters { reference, cos, .. } = *self.setup;
        let Masses { projectile_kg, plate_kg, .. } = self.setup.mass;
        let (slope_n_m, slope_n_s_m) = self.contact_slopes(0.0, reference.velocity_m_s);
        let by_place_s = smaller(self.setup.passage_s(), (projectile_kg / slope_n_m.abs()).sqrt());
        let slipping_kg = 1.0 / (1.0 / projectile_kg + cos * cos / plate_kg);
        self.setup.threshold_factor()
            * NEGLIGIBLE.sqrt()
            * smaller(by_place_s, slipping_kg / slope_n_s_m.abs())
    }

    /// Returns the state after the first moment of a contact, for an uncocked plate whose spring is singular at zero.
    ///
    /// The contact force grows linearly in time; it is constant if the contact has a damper. The displacement of the plate is the smallest
    /// of those with inertia, spring or damper alone, each a power of time.
    ///
    /// Also returns the work of the contact and the work of the damper, J.
    pub(super) fn after_first_moment(&self) -> (State, [f64; 2]) {
        let t_s = self.first_moment_s();
        let setup = self.setup;
        // A plug that is picked up at once has reduced the velocity.
        let v = setup.reference.velocity_m_s * setup.kept;
        let moment = State { t_s, q_m: v * t_s, u_m_s: v, ..State::default() };
        let force_n = self.contact_n(&moment);
        let at_once = self.contact_n(&State { u_m_s: v, ..State::default() }) > 0.0;
        let grows = if at_once { 0.0 } else { 1.0 };
        let push_n = force_n * setup.cos;
        let inertia = (grows + 1.0) * (grows + 2.0) * setup.mass.plate_kg;
        let by_inertia = (push_n * t_s * t_s / inertia, grows + 2.0);
        let at_m = setup.spring.at_force(push_n);
        let by_spring = (at_m, grows * push_n / (at_m * setup.spring.tangent(at_m)));
        let power = grows / setup.damper.exponent + 1.0;
        let by_damper = (setup.damper.at_force(push_n) * t_s / power, power);
        let (x_m, power) = [by_spring, by_damper]
            .into_iter()
            .fold(by_inertia, |least, other| if other.0 < least.0 { other } else { least });
        let w_m_s = power * x_m / t_s;
        let lost_m_s = force_n * t_s / ((grows + 1.0) * setup.mass.projectile_kg);
        // The velocity of the plate is a power of the time.
        let damper_power = (setup.damper.exponent + 1.0) * (power - 1.0) + 1.0;
        let damper_j = setup.damper.force(w_m_s) * w_m_s * t_s / damper_power;
        let plate_j =
            0.5 * setup.mass.plate_kg * w_m_s * w_m_s + setup.spring.energy(x_m) + damper_j;
        let contact_j = setup.mass.projectile_kg * lost_m_s * (v - 0.5 * lost_m_s) - plate_j;
        let state = State {
            q_m: moment.q_m - setup.cos * x_m,
            u_m_s: v - lost_m_s - setup.cos * w_m_s,
            x_m,
            w_m_s,
            ..moment
        };
        (state, [contact_j, damper_j])
    }

    /// Returns the displacement at which a plate that is locked from the start unlocks, m; `None` if it is not locked.
    ///
    /// The plate is locked if inertia alone would allow a much larger displacement by that time. After unlocking it is then quasi-static.
    pub(super) fn initial_lock_displacement_m(&self) -> Option<f64> {
        let setup = self.setup;
        // A swing this short is rounding error.
        let is_at_rest =
            setup.start.w_m_s == 0.0 || setup.first_swing_m() < ROUNDING * setup.reference.length_m;
        let starts_steep = is_at_rest && setup.starts_at_steep_zero();
        if !starts_steep || !Rule::InitialLock.applies() || setup.law != ContactLaw::Flow {
            return None;
        }
        let state = State { u_m_s: setup.reference.velocity_m_s, ..State::default() };
        // The contact force of a blunt nose does not start from zero.
        if self.contact_n(&state) > 0.0 {
            return None;
        }
        let rate_n_s = self.rate_n_s(&state).abs();
        let mut held_m = self.mode.held_m;
        let held_n = setup.spring.force(held_m);
        let by_inertia_m = (held_n / rate_n_s).powi(2) * held_n / (6.0 * setup.mass.plate_kg);
        // Inertia changes the displacement by about the inverse of the ratio of both: at most by the order after the first.
        let inertia_ratio = FIRST_ORDER * FIRST_ORDER * by_inertia_m / held_m;
        if inertia_ratio < 1.0 {
            // The displacement with inertia alone grows as the cube of the force: the ratio scales as x^(3n-1). For n < 1/3 a smaller
            // displacement satisfies the condition, otherwise none does.
            let decay_exponent = 1.0 - 3.0 * held_m * setup.spring.tangent(held_m) / held_n;
            held_m *=
                if decay_exponent > 0.0 { inertia_ratio.powf(1.0 / decay_exponent) } else { 0.0 };
        }
        let held_s = setup.spring.force(held_m) / rate_n_s;
        (held_s > self.first_moment_s()).then_some(held_m)
    }

    /// Returns the time derivative of the contact force on a plate at rest, N/s.
    pub(super) fn rate_n_s(&self, state: &State) -> f64 {
        let slopes = self.contact_slopes(state.q_m, state.u_m_s);
        let slows_m_s2 = self.contact_n(state) / self.setup.mass.projectile_kg;
        (slopes.0 * state.u_m_s - slopes.1 * slows_m_s2) * self.setup.cos
    }

    /// Returns `true` if the plate locks again: the contact force decreases, and the remaining energy and force allow only a displacement
    /// that is a small multiple of the step tolerance and does not exceed the maximum displacement so far.
    pub(super) fn locks_again(&self, state: &State, farthest_m: f64) -> bool {
        let spring = &self.setup.spring;
        let can_lock = Rule::Relock.applies()
            && self.mode.hold == PlateConstraint::Free
            && self.setup.law == ContactLaw::Flow
            && spring.is_steep_at_zero();
        if !can_lock {
            return false;
        }
        let unlocks_m = self.setup.relock_displacement_m(state.q_m);
        let (x_m, push_n) = (self.displacement_m(state.x_m), self.push_n(state));
        let speed_j = 0.5 * self.moving_kg() * state.w_m_s * state.w_m_s;
        // A plate that rides on its spring, and never came to where it would unlock, needs no hysteresis.
        let rides = speed_j < FIRST_ORDER * spring.energy(x_m);
        let least_m = RELOCK_FRACTION * unlocks_m;
        let held_m = if rides { larger(least_m, smaller(unlocks_m, farthest_m)) } else { least_m };
        // The second computation locks where the difference of both is not to show it: where the displacement is negligible, or after a
        // greater one, where its own lock would count as an error of the first.
        let may_lock = match self.setup.numerics.method {
            IntegrationMethod::Second(first) => {
                least_m * first / self.setup.numerics.tolerance < farthest_m
                    || farthest_m < NEGLIGIBLE * self.setup.reference.length_m
            }
            _ => true,
        };
        // Energy of spring and push: with less than at the maximum the plate does not reach it again.
        let well_j = |x_m: f64| spring.energy(x_m) - push_n * x_m;
        // Fused bodies without a damper keep it.
        let is_fused = self.mode.contact == Contact::Fused;
        let rounding_j = if is_fused { ROUNDING * spring.energy(farthest_m) } else { 0.0 };
        may_lock
            && (!is_fused || spring.energy(held_m) < self.pull_out_j(state))
            && push_n < spring.force(farthest_m)
            && speed_j + well_j(x_m) < well_j(farthest_m) + rounding_j
            && push_n.abs() < spring.force(held_m)
            && speed_j + spring.energy(x_m) < spring.energy(held_m)
            && self.rate_n_s(state) <= 0.0
    }

    /// Returns `true` if the plate starts at rest, or at the zero of its spring, where a law is neither steep nor analytic.
    pub(super) fn starts_at_singularity(&self) -> bool {
        let ImpactParameters { damper, ref spring, start, .. } = *self.setup;
        let by_spring = || spring.power().is_some_and(|law| !law.is_smooth_at_zero());
        self.mode.hold == PlateConstraint::Free
            && (start.w_m_s == 0.0 && !damper.is_smooth_at_zero()
                || start.x_m == 0.0 && by_spring())
    }

    /// Returns the force on a locked plate that its spring has to balance, N.
    fn push_n(&self, state: &State) -> f64 {
        self.contact_n(state) * self.setup.cos + self.joined_weight_n()
    }

    /// Returns the additional force that the stiff spring could balance before the plate unlocks, N.
    pub(super) fn lock_margin_n(&self, state: &State) -> f64 {
        self.setup.spring.force(self.mode.held_m) - self.push_n(state).abs()
    }

    /// Returns displacement and velocity of the quasi-static plate: spring force = contact force - inertia - damping, to first order. With
    /// any other state an unlocked plate would oscillate.
    ///
    /// The spring is taken as a power law about its balance, x ~ p^a with a = 1/n; then x''/x = a (a - 1) (p'/p)² + a p''/p.
    pub(super) fn quasi_static_state(&self, state: &State) -> (f64, f64) {
        let (spring, push_n) = (&self.setup.spring, self.push_n(state));
        let x_m = spring.at_force(push_n.abs()).copysign(push_n);
        let slope_n_m = spring.tangent(x_m);
        let balanced = (x_m - self.mode.origin_m, self.rate_n_s(state) / slope_n_m);
        let power = push_n / (slope_n_m * x_m);
        let rate = self.rate_n_s(state) / push_n;
        let bend = self.force_second_derivative_n_s2(state) / push_n;
        // The third derivative of the force is left out.
        let growth = power * (power - 1.0) * rate * rate + power * bend;
        let growth_rate =
            rate * (2.0 * power * (power - 1.0) * (bend - rate * rate) - power * bend);
        let inertia_m = self.setup.mass.plate_kg * x_m / slope_n_m;
        let lag_m = inertia_m * growth;
        let lag_m_s = (2.0 * power - 1.0) * rate * lag_m + inertia_m * growth_rate;
        let damper = self.setup.damper;
        let damped_m = damper.force(balanced.1) / slope_n_m;
        let damped_m_s = (damper.exponent + 1.0) * (power - 1.0) * rate * damped_m;
        let (off_m, off_m_s) = (lag_m + damped_m, lag_m_s + damped_m_s);
        let is_small =
            off_m.abs() < FIRST_ORDER * x_m.abs() && off_m_s.abs() < FIRST_ORDER * balanced.1.abs();
        if is_small && Rule::Lag.applies() {
            (balanced.0 - off_m, balanced.1 - off_m_s)
        } else {
            balanced
        }
    }

    /// Returns the second time derivative of the contact force on a plate at rest, by central differences, N/s².
    fn force_second_derivative_n_s2(&self, state: &State) -> f64 {
        let slows_m_s2 = self.contact_n(state) / self.setup.mass.projectile_kg;
        let by_place_s = smaller(self.setup.passage_s(), (state.q_m / state.u_m_s).abs());
        // Rounding and truncation of a central difference are about equal at this interval.
        let moment_s = f64::EPSILON.cbrt() * smaller(by_place_s, (state.u_m_s / slows_m_s2).abs());
        let rate_at = |t_s: f64| {
            let q_m = state.q_m + state.u_m_s * t_s;
            self.rate_n_s(&State { q_m, u_m_s: state.u_m_s - slows_m_s2 * t_s, ..*state })
        };
        (rate_at(moment_s) - rate_at(-moment_s)) / (2.0 * moment_s)
    }

    /// Returns the coefficient of the linearised damper, N s/m; `None` above the velocity below which it applies.
    fn creep_slope_n_s_m(&self, w_m_s: f64) -> Option<f64> {
        let ImpactParameters { damper, creep_m_s, .. } = *self.setup;
        (w_m_s.abs() < creep_m_s).then(|| damper.force(creep_m_s) / creep_m_s)
    }

    /// Returns the force of the damper, N.
    pub(super) fn damper_n(&self, w_m_s: f64) -> f64 {
        let force_n = || self.setup.damper.force_on(self.mode.w_side, w_m_s);
        self.creep_slope_n_s_m(w_m_s).map_or_else(force_n, |slope_n_s_m| slope_n_s_m * w_m_s)
    }

    /// Returns the derivative of the damper's force at a non-zero velocity, N s/m.
    pub(super) fn damper_slope_n_s_m(&self, w_m_s: f64) -> f64 {
        self.creep_slope_n_s_m(w_m_s).unwrap_or_else(|| self.setup.damper.tangent(w_m_s))
    }

    /// Returns the error of the plate's acceleration, m/s²: rounding of the forces, and the damper's force for the error of the velocity.
    pub(super) fn acceleration_error_m_s2(&self, state: &State) -> f64 {
        let off_n = self.damper_slope_n_s_m(state.w_m_s)
            * self.setup.numerics.tolerance
            * self.error_scales(state).1[1];
        self.rounding(state).1 + off_n / self.moving_kg()
    }

    /// Returns the maximum step size towards a singular zero of the spring or the damper, s; infinite if none is approached, or if the
    /// remainder is negligible.
    pub(super) fn approach_s(&self, state: &State) -> f64 {
        let ImpactParameters { damper, creep_m_s, reference, .. } = *self.setup;
        let mut least_s = self.towards_zero_s(state).unwrap_or(f64::INFINITY);
        if !damper.is_smooth_at_zero() && state.w_m_s.abs() > creep_m_s {
            let (w_m_s, acceleration) = (state.w_m_s, self.accelerations(state).1);
            let way_s = -w_m_s / acceleration;
            let counts = damper.force(w_m_s).abs() * way_s
                > ROUNDING * self.moving_kg() * reference.velocity_m_s;
            // If the forces balance, only the error of the acceleration remains.
            let is_resolved = acceleration.abs() > self.acceleration_error_m_s2(state);
            if way_s > 0.0 && counts && is_resolved {
                least_s = smaller(least_s, SINGULARITY_STEP_FRACTION * way_s);
            }
        }
        if Rule::Approach.applies() { least_s } else { f64::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::tests::{is_near, look};

    /// `F = 2 pi R (2/3) (S_y + C_d rho v²/2) v t` at first. Alone it has moved the plate by `F t²/(6 m_2)`, 100 x, when it is k x^n.
    #[test]
    fn valid_a_steep_spring_holds_until_the_plate_follows_its_balance() {
        let held = |it: &Equations<'_>, _: &State| it.initial_lock_displacement_m();
        let held_m = look("gamma=1 k=3e5 n=0.3", Contact::Penetrating, [0.0; 4], held).unwrap();
        let rate_n_s = std::f64::consts::PI * 0.0127 / 1.5 * (1.52e8 + 6.775e6) * 100.0;
        let t_s = 3e5 * held_m.powf(0.3) / rate_n_s;
        assert!(is_near(rate_n_s * t_s.powi(3) / (6.0 * 0.0295), 100.0 * held_m, 1e-9));
        assert_eq!(look("gamma=1 k=1e5 n=0.3", Contact::Penetrating, [0.0; 4], held), None);
    }

    /// `k x^n = F - m_2 x''`, where F slows the projectile: the velocity is the way's, and inertia takes some 2e-5 of F.
    #[test]
    fn valid_a_plate_that_is_let_go_is_where_its_spring_balances_the_contact() {
        let found = |it: &Equations<'_>, at: &State| (it.contact_n(at), it.quasi_static_state(at));
        let at = |q, u| look("k=1e6 n=0.2", Contact::Penetrating, [q, u, 0.0, 0.0], found);
        let (now_n, (x_m, w_m_s)) = at(3e-3, 80.0);
        let slows_m_s2 = now_n / 0.0295;
        let ahead = |t: f64| at(3e-3 + (80.0 - 0.5 * slows_m_s2 * t) * t, 80.0 - slows_m_s2 * t).1;
        let [(later_m, later_m_s), (before_m, before_m_s)] = [1e-9, -1e-9].map(ahead);
        let plate_n = 0.0295 * (later_m_s - before_m_s) / 2e-9;
        assert!(plate_n.abs() > 1e-6 * now_n, "{plate_n}");
        assert!(is_near(1e6 * x_m.powf(0.2), now_n - plate_n, 1e-9));
        assert!(is_near(w_m_s, (later_m - before_m) / 2e-9, 1e-6));
    }

    /// The remaining energy cannot pull the projectile out of a hole with a grip; without a grip it can.
    #[test]
    fn a_steep_spring_holds_joined_bodies_that_stay_so() {
        for (more, expected) in
            [("", true), ("interface=plastic", true), ("interface=plastic g=0", false)]
        {
            let pairs = format!("k=1e5 n=0.5 {more}");
            let state = [5e-3, 0.0, 0.0, 0.0];
            let found = look(&pairs, Contact::Fused, state, |it, at| it.locks_again(at, 1e-3));
            assert_eq!(found, expected, "{more}");
        }
    }
    /// At 0.1 mm/s the damper's 100 N hold the spring's: a velocity that is off by 1e-12 of itself, as a step may leave it, sends it
    /// nowhere.
    #[test]
    fn a_plate_approaches_no_zero_by_what_its_velocity_is_off_by() {
        let is_near_s = |fraction: f64, within_s: f64| {
            let state = [5e-3, 0.0, -1e-3, 1e-4 * (1.0 + fraction)];
            look("k=1e5 b=1e4 m=0.5", Contact::Fused, state, |it, at| it.approach_s(at) < within_s)
        };
        assert!(!is_near_s(1e-12, f64::INFINITY) && is_near_s(1e-3, 1e-3));
    }
}
