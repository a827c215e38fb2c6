//! End of a run: conditions under which outcome and maximum displacement can no longer change.
//!
//! All conditions are work-energy bounds. The remaining energy limits displacement, velocity and force, and so what can still happen: a
//! deeper hole, a projectile pulled out, a new contact, a larger displacement. The functions depend only on contact mode and state.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::modes::{Contact, PlateConstraint};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::resolution::{NEGLIGIBLE, RESOLUTION};
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;
use crate::model::power_law::PowerLaw;
use crate::model::run::Outcome;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Relative excess of the peak interface load over the limit load below which the remaining slip follows from the energy. The slip velocity
/// scales as excess^1.5, the neglected drag as its square, excess^3.
const LAST_SLIPS: f64 = 2e-3;

impl Equations<'_> {
    /// Returns `true` if the plate is fixed, or does not move because its forces balance.
    pub(super) fn is_in_equilibrium(&self, state: &State) -> bool {
        let is_balanced = || {
            state.w_m_s.abs() < self.unresolved_m_s()
                && self.accelerations(state).1.abs() <= self.rounding(state).1
                && Rule::Balance.applies()
        };
        self.plate_rests() || is_balanced()
    }

    /// Returns the energy below which the bodies cannot separate at more than the negligible velocity, J.
    fn parting_j(&self) -> f64 {
        0.5 * self.setup.mass.projectile_kg * self.parting_m_s() * self.parting_m_s()
    }

    /// Returns the negligible velocity at which bodies separate, m/s.
    fn parting_m_s(&self) -> f64 {
        if Rule::Parting.applies() { RESOLUTION * self.setup.reference.velocity_m_s } else { 0.0 }
    }

    /// Returns `true` if the remaining energy cannot part the bodies or the fused bodies are in equilibrium.
    pub(super) fn is_at_rest(&self, state: &State) -> bool {
        // The energy is negative if the spring accelerates the plate without end.
        let has_none = self.energy_j(state) <= self.parting_j();
        has_none && self.mode.elastic.drives_away(self.displacement_m(state.x_m)).is_none()
            || self.is_in_equilibrium(state) && self.mode.contact == Contact::Fused
    }

    /// Returns the outcome if it is final.
    pub(super) fn outcome(&self, state: &State) -> Option<Outcome> {
        match self.mode.contact {
            Contact::Perforated => Some(Outcome::Perforated),
            Contact::Fused
                if !self.setup.interface.is_plastic || self.sticks_permanently(state) =>
            {
                Some(Outcome::Arrested)
            }
            Contact::FreeFlight if self.is_separated(state) => Some(Outcome::Separated),
            _ if self.rests_in_contact_j(state).is_some() => Some(Outcome::Arrested),
            _ => None,
        }
    }

    /// Returns the remaining energy in a contact without adhesion, J, if it can neither deepen the dent nor separate the bodies noticeably:
    /// then they move as one.
    fn rests_in_contact_j(&self, state: &State) -> Option<f64> {
        let ContactLaw::Lumped(lumped) = self.setup.law else { return None };
        let (goes_in, deepest_m) = (self.is_loading(), self.mode.deepest_m);
        let gives_j = lumped.gives_back_j(goes_in, deepest_m, state.q_m);
        let left_j = self.energy_left_j(state) + if self.is_touching() { gives_j } else { 0.0 };
        let deepens_j = lumped.deepens_j(goes_in, larger(deepest_m, state.q_m), NEGLIGIBLE);
        (left_j < self.parting_j() && left_j < deepens_j).then_some(left_j)
    }

    /// Returns the work needed to pull the projectile out of its hole, J; infinite for a fused interface.
    pub(super) fn pull_out_j(&self, state: &State) -> f64 {
        let ImpactParameters { interface, strength_pa, .. } = *self.setup;
        if interface.is_plastic {
            interface.grip * strength_pa * self.stuck_m3(state)[0]
        } else {
            f64::INFINITY
        }
    }

    /// Volumes that the nose has swept up to its place and up to the bottom of the hole, m³.
    pub(super) fn stuck_m3(&self, state: &State) -> [f64; 2] {
        let Equations { setup, mode } = self;
        mode.stuck_m3
            .unwrap_or_else(|| [state.q_m, mode.deepest_m].map(|q_m| setup.geometry.swept_m3(q_m)))
    }

    /// Returns an upper bound of the further depth of the hole, m, while the projectile slips back and forth above its bottom.
    ///
    /// Limit oscillation: the free oscillation whose peak interface load equals the friction force; with less energy the bodies no longer slip.
    /// Assumption: no slip is longer than the previous one, since the energy decreases. The bound is the sum over the slips towards the
    /// bottom:
    ///
    /// - The first slip covers the present gap.
    /// - Each further slip except the last starts with more energy than the limit oscillation. Their total length is at most half of what
    ///   friction needs to dissipate the energy above that, minus half of the gap.
    /// - The last slip is at most as long as the gap.
    ///
    /// Over this path the load in excess of friction does work on the projectile; the strength in excess of the load stops it at the
    /// bottom.
    ///
    /// `None` if the projectile is at the bottom, can be pushed deeper from rest, can reach a rigid stop, or if a deeper hole is weaker.
    pub(super) fn deepens_at_most_m(&self, state: &State) -> Option<f64> {
        let Equations { setup, mode } = self;
        let energy_j = self.energy_j(state);
        let gap_m = mode.deepest_m - state.q_m;
        let is_heavy = setup.weight_n > 0.0;
        let is_slipping =
            setup.interface.is_plastic && mode.contact == Contact::Fused && gap_m > 0.0;
        let slips = is_slipping && !is_heavy && Rule::DepthInterval.applies();
        if !slips || gap_m > state.q_m || self.meets_rigid_stop(state, energy_j) {
            return None;
        }
        let load_at_most_n = |energy_j: f64| {
            let [peak_push_n, peak_pull_n] = self.peak_load_bounds_n(state, energy_j);
            larger(peak_push_n, peak_pull_n)
        };
        let load_n = load_at_most_n(energy_j);
        let strength_at_n = |q_m: f64| setup.geometry.area_m2(q_m) * setup.strength_pa;
        let strength_n = strength_at_n(mode.deepest_m);
        let grip = smaller(setup.interface.grip, 1.0);
        let [here_n, bottom_n] = [state.q_m, mode.deepest_m].map(|q_m| grip * strength_at_n(q_m));
        let excess_at_n = |energy_j: f64| load_at_most_n(energy_j) - bottom_n;
        let spare_j = match (excess_at_n(0.0) < 0.0, load_n > bottom_n) {
            (_, false) => 0.0,
            (true, true) => energy_j - bracketed_root(0.0, energy_j, excess_at_n),
            (false, true) => energy_j,
        };
        let inwards_m = 0.5 * spare_j / here_n + 1.5 * gap_m;
        // The area may be convex in the depth: its least value bounds the friction.
        let excess_n = larger(load_n - smaller(here_n, bottom_n), 0.0);
        let deepens_m = excess_n * inwards_m / (strength_n - load_n);
        let most_m = mode.deepest_m + deepens_m;
        let is_held = load_n < strength_n
            && strength_at_n(most_m) >= strength_n
            && most_m < setup.geometry.exit_m;
        is_held.then_some(deepens_m)
    }

    /// Returns `true` if a plastic interface can no longer slip by a relevant amount.
    fn sticks_permanently(&self, state: &State) -> bool {
        if self.is_in_equilibrium(state) {
            return true;
        }
        let Equations { setup, mode } = self;
        let (energy_j, rounding_j) = (self.energy_j(state), self.energy_rounding_j(state));
        let strength_n = self.strength_n(state);
        let friction_j = larger(self.pull_out_j(state), self.parting_j());
        // The remaining energy can neither deepen the hole, after friction on the distance to its bottom, nor pull the projectile out
        // noticeably.
        let [here_m3, bottom_m3] = self.stuck_m3(state);
        let above_m3 = bottom_m3 - here_m3;
        let to_bottom_j = setup.interface.grip * setup.strength_pa * larger(above_m3, 0.0);
        let is_exhausted = |energy_j: f64| {
            let most_j = energy_j + rounding_j;
            most_j < to_bottom_j + NEGLIGIBLE * mode.deepest_m * strength_n && most_j < friction_j
        };
        let is_driven = setup.weight_n > 0.0 && self.drives_away(state).is_some();
        if is_exhausted(energy_j) && !is_driven && Rule::EnergySpent.applies() {
            return true;
        }
        if !self.leaves(state) && self.meets_rigid_stop(state, energy_j) {
            let on_arrival_j = energy_j - mode.elastic.energy(setup.stop.position_m);
            if !is_exhausted(on_arrival_j) {
                return false;
            }
        }
        let (limit_push_n, limit_pull_n) = self.limit_loads_n(state);
        let [peak_push_n, peak_pull_n] = self.peak_load_bounds_n(state, energy_j);
        let cannot_part = || {
            let range_m = self.range_m(state, energy_j);
            self.greatest_speed_m_s(state, energy_j, range_m) < self.parting_m_s()
        };
        if peak_push_n <= limit_push_n && (peak_pull_n <= limit_pull_n || cannot_part()) {
            return true;
        }
        // The following bound does not include the weight.
        if setup.weight_n > 0.0 || !Rule::SlipsWithinFriction.applies() {
            return false;
        }
        // Slips back and forth in the hole: each starts with more energy than the limit oscillation (see `deepens_at_most_m`). All slips
        // except the last thus have a total length of at most the excess energy over the friction. At the bottom their energy is at
        // most the work of the load in excess of friction, which limits the further depth.
        let (q_m, geometry) = (state.q_m, &setup.geometry);
        let excess_n = larger(peak_push_n, peak_pull_n) - limit_pull_n;
        let may_deepen_m = NEGLIGIBLE * mode.deepest_m * strength_n / excess_n;
        let way_m = smaller(q_m, larger(mode.deepest_m - q_m, may_deepen_m));
        let area = smaller(geometry.area_m2(q_m - way_m), geometry.area_m2(q_m + way_m));
        let friction_n = smaller(setup.interface.grip, 1.0) * setup.strength_pa * area;
        // Half: the last slip may take the rest.
        let left_j = energy_j - 0.5 * friction_n * way_m;
        let is_off_stop = !self.meets_rigid_stop(state, energy_j);
        let [peak_push_n, peak_pull_n] = self.peak_load_bounds_n(state, larger(left_j, 0.0));
        way_m > 0.0 && is_off_stop && larger(peak_push_n, peak_pull_n) <= friction_n
    }

    /// Returns the total remaining slip of an undamped oscillation whose peak load slightly exceeds the limit load, m.
    ///
    /// The oscillation loses energy in ever smaller slips, one per period, without reaching an end in finite time. Their sum follows from
    /// the energy: it is exhausted when the peak load equals the limit load of the deeper hole. `None` if the conditions do not hold: past
    /// its maximum displacement, at the bottom of the hole, nothing else that dissipates energy, and a small excess.
    pub(super) fn remaining_slip_m(&self, state: &State, farthest_m: f64) -> Option<f64> {
        let Equations { setup, mode } = self;
        let energy_j = self.energy_j(state);
        let far_m = self.max_reachable_displacement_m(state, energy_j);
        let is_past = state.w_m_s < 0.0 && far_m <= farthest_m;
        let is_joined = mode.contact == Contact::Fused && state.q_m >= mode.deepest_m;
        // The limit load of a plug decreases with each slip.
        let is_conservative = self.is_undamped() && setup.absorber.is_none() && !setup.shears();
        let is_conservative = is_conservative && setup.weight_n == 0.0;
        let may_slip = setup.interface.is_plastic
            && is_past
            && is_joined
            && is_conservative
            && Rule::LastSlips.applies();
        if !may_slip || self.meets_rigid_stop(state, energy_j) {
            return None;
        }
        let (limit_push_n, limit_pull_n) = self.limit_loads_n(state);
        let [peak_push_n, peak_pull_n] = self.peak_load_bounds_n(state, energy_j);
        let excess = peak_push_n / limit_push_n - 1.0;
        // The peak load occurs at the maximum displacement.
        let grows = mode.elastic.tangent(far_m) > 0.0
            && setup.interface_fraction() * mode.elastic.force(far_m) > limit_push_n;
        let is_small = excess > 0.0 && excess < LAST_SLIPS && grows;
        if !is_small || peak_pull_n > limit_pull_n {
            return None;
        }
        let (geometry, strength) = (&setup.geometry, setup.strength_pa);
        let swept_m3 = geometry.swept_m3(state.q_m);
        let overload_n = |travel_m: f64| {
            let q_m = state.q_m + travel_m;
            let left_j = energy_j - strength * (geometry.swept_m3(q_m) - swept_m3);
            self.peak_load_bounds_n(state, larger(left_j, 0.0))[0]
                - geometry.area_m2(q_m) * strength
        };
        let most_m = 0.5 * setup.mass.joined_kg * state.w_m_s * state.w_m_s / limit_push_n;
        let is_enough = overload_n(most_m) < 0.0;
        let travel_m = || bracketed_root(0.0, most_m, overload_n) * (1.0 + 4.0 * f64::EPSILON);
        is_enough.then(travel_m)
    }

    /// Returns the limit load in compression at the bottom of the hole, N.
    pub(super) fn strength_n(&self, state: &State) -> f64 {
        self.setup.geometry.area_m2(state.q_m) * self.setup.strength_pa
    }

    /// Returns the limit loads of the interface in compression and in tension, N.
    pub(super) fn limit_loads_n(&self, state: &State) -> (f64, f64) {
        let strength_n = self.strength_n(state);
        let friction_n = self.setup.interface.grip * strength_n;
        (if state.q_m >= self.mode.deepest_m { strength_n } else { friction_n }, friction_n)
    }

    /// Returns `true` if a projectile out of contact cannot come into contact again.
    fn is_separated(&self, state: &State) -> bool {
        let Equations { setup, mode } = self;
        let apart_m = setup.law.slack_m(mode.deepest_m) - state.q_m;
        if state.u_m_s > 0.0 || (apart_m <= 0.0 && state.u_m_s == 0.0) {
            return false;
        }
        let v = setup.projectile_m_s(state);
        let energy_j = self.energy_j(state);
        let range_m = self.range_m(state, energy_j);
        if v < -self.greatest_speed_m_s(state, energy_j, range_m) * setup.cos {
            return true;
        }
        if mode.spring.is_absent() && !setup.has_stop() {
            return state.u_m_s < 0.0 && (v <= 0.0 || setup.damper.is_absent());
        }
        let x_m = self.displacement_m(state.x_m);
        // The plate accelerates away from the projectile.
        if state.u_m_s < 0.0 && state.w_m_s >= 0.0 && self.drives_away(state) == Some(1.0) {
            return self.accelerations(state).1 >= 0.0;
        }
        // The projectile moves away and is beyond the range of the plate.
        v < 0.0 && (x_m - range_m[0]) * setup.cos < apart_m
    }

    /// Returns an upper bound of the overshoot of a damped plate beyond the equilibrium that spring and elastic stop drive it to, m.
    ///
    /// The velocity there is at most the larger of the present velocity and the terminal velocity for the maximum force on the way. The
    /// damper alone, or spring and stop alone, stop the plate from that velocity.
    fn overshoots_at_most_m(&self, state: &State, energy_j: f64, place_m: f64) -> f64 {
        let Equations { setup, mode } = self;
        let x_m = self.displacement_m(state.x_m);
        let is_driven = mode.elastic.rest_ahead(x_m) > x_m && x_m < place_m;
        if !is_driven || setup.damper.is_absent() || !Rule::Overshoot.applies() {
            return f64::INFINITY;
        }
        let goes_back = state.w_m_s < 0.0;
        let from_m = if goes_back { mode.elastic.reach(x_m, energy_j, -1.0) } else { x_m };
        let drives_n = -mode.elastic.forces_between(from_m, place_m).0;
        let arrives_m_s = larger(state.w_m_s, setup.damper.at_force(drives_n));
        let left_j = 0.5 * self.moving_kg() * arrives_m_s * arrives_m_s;
        let by_law_m =
            mode.elastic.reach(place_m, mode.elastic.energy(place_m) + left_j, 1.0) - place_m;
        smaller(by_law_m, coasting_m(setup.damper, self.moving_kg(), arrives_m_s))
    }

    /// Returns the maximum displacement of the plate after the outcome is final, m; infinite if nothing stops the plate, `None` if the
    /// simulation has to continue. `so_far_m` is the maximum up to now.
    pub(super) fn farthest_m(&self, state: &State, so_far_m: f64) -> Option<f64> {
        let Equations { setup, mode } = self;
        if mode.hold == PlateConstraint::Mount {
            return Some(so_far_m);
        }
        // Bodies that rest in a contact share the remaining energy.
        let rests_j = self.rests_in_contact_j(state);
        let moving_kg = if rests_j.is_some() { setup.mass.joined_kg } else { self.moving_kg() };
        let energy_j = rests_j.unwrap_or_else(|| self.energy_j(state));
        let x_m = self.displacement_m(state.x_m);
        // The plate reaches at least the equilibrium ahead, or its stop; its energy there has rounding errors.
        let end_m = smaller(mode.elastic.rest_ahead(x_m), setup.rigid_stop_m());
        let far_m = larger(end_m, so_far_m);
        let stroke_m = larger(far_m.abs(), far_m - setup.start.x_m);
        if let Some(coasts_m) = self.coasts_to_m(state, moving_kg, stroke_m) {
            return Some(larger(coasts_m, so_far_m));
        }
        if self.is_in_equilibrium(state) && !self.coasts(state) {
            return Some(far_m);
        }
        if let Some(way) = self.drives_away(state)
            && way * state.w_m_s >= 0.0
        {
            return Some(if way > 0.0 { f64::INFINITY } else { so_far_m });
        }
        if self.leaves(state) {
            return Some(so_far_m);
        }
        let reach_m = self.max_reachable_displacement_m(state, energy_j);
        if reach_m - far_m <= NEGLIGIBLE * stroke_m && Rule::Reach.applies() {
            return Some(far_m);
        }
        if self.overshoots_at_most_m(state, energy_j, far_m) <= NEGLIGIBLE * stroke_m {
            return Some(far_m);
        }
        let in_full = matches!(setup.numerics.method, IntegrationMethod::CollocationInFull(_));
        // Only the spring can reverse the motion.
        let by_spring = setup.damper.is_absent()
            && !setup.has_stop()
            && !in_full
            && Rule::SpringTurns.applies();
        by_spring.then(|| {
            if self.is_gone_backwards(state) { so_far_m } else { larger(reach_m, so_far_m) }
        })
    }

    /// Returns `true` if only the damper acts on a plate that moves forwards.
    fn coasts(&self, state: &State) -> bool {
        let x_m = self.displacement_m(state.x_m);
        !self.mode.is_pressed
            && state.w_m_s > 0.0
            && self.joined_weight_n() == 0.0
            && self.mode.spring.slack_until(x_m) > x_m
    }

    /// Returns the displacement at which a coasting plate comes to rest, m: where its damper alone stops it, or where spring or stop begin
    /// to press on it. `None` if it does not coast, or if it presses on them further than a negligible part of `stroke_m`.
    fn coasts_to_m(&self, state: &State, moving_kg: f64, stroke_m: f64) -> Option<f64> {
        if !self.coasts(state) {
            return None;
        }
        let Equations { setup, mode } = self;
        let x_m = self.displacement_m(state.x_m);
        let end_m = x_m + coasting_m(setup.damper, moving_kg, state.w_m_s);
        let stop_m = if setup.has_stop() { setup.stop.position_m } else { f64::INFINITY };
        let place_m = smaller(mode.spring.slack_until(x_m), stop_m);
        if end_m < place_m || place_m.is_infinite() {
            return Some(end_m);
        }
        let way_m = place_m - x_m;
        let arrives_m_s = coasting_m_s(setup.damper, moving_kg, (state.w_m_s, way_m));
        let energy_j = mode.elastic.energy(place_m) + 0.5 * moving_kg * arrives_m_s * arrives_m_s;
        let reach_m = smaller(mode.elastic.reach(place_m, energy_j, 1.0), setup.rigid_stop_m());
        (reach_m - place_m <= NEGLIGIBLE * larger(stroke_m, way_m)).then_some(place_m)
    }

    /// Returns `true` if the plate moves backwards without end: the spring drives it, or cannot take its energy.
    pub(super) fn is_gone_backwards(&self, state: &State) -> bool {
        let x_m = self.displacement_m(state.x_m);
        let escapes = || self.mode.elastic.reach(x_m, self.energy_j(state), -1.0).is_infinite();
        let is_driven = self.drives_away(state) == Some(-1.0);
        state.w_m_s < 0.0 && (is_driven || self.setup.damper.is_absent() && escapes())
    }
}

/// Returns the distance over which a damper alone stops a mass, m: M w^(2-m)/(b (2-m)) for m < 2, else infinite.
fn coasting_m(damper: PowerLaw, kg: f64, w_m_s: f64) -> f64 {
    let power = 2.0 - damper.exponent;
    if damper.is_absent() || power <= 0.0 {
        return f64::INFINITY;
    }
    kg * w_m_s.powf(power) / (damper.coefficient * power)
}

/// Returns the velocity of a mass after a distance with a damper alone, m/s: `(w^(2-m) - (2-m) b x/M)^(1/(2-m))`, and w exp(-b x/M) for
/// m = 2.
fn coasting_m_s(damper: PowerLaw, kg: f64, (w_m_s, way_m): (f64, f64)) -> f64 {
    let power = 2.0 - damper.exponent;
    // Relative to the present velocity: its powers neither overflow nor underflow.
    let part = damper.coefficient * way_m / (kg * w_m_s.powf(power));
    if power == 0.0 {
        return w_m_s * (-part).exp();
    }
    w_m_s * larger(1.0 - power * part, 0.0).powf(1.0 / power)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::modes::HybridMode;
    use crate::model::impact::tests::{is_near, look};
    use crate::model::impact::transitions::first;
    use crate::model::variables::scene_with;

    /// Outcomes of two bodies of 29.5 g. The interface carries half of the spring's force; the limit loads are 15 kN and 1.5 kN.
    #[rustfmt::skip]
    const OUTCOMES: [(&str, Contact, [f64; 4], Option<Outcome>); 11] = [
        ("k=1e5", Contact::Perforated, [0.1, 50.0, 0.0, 10.0], Some(Outcome::Perforated)),
        ("k=1e5", Contact::Fused, [5e-3, 0.0, 0.0, 50.0], Some(Outcome::Arrested)),
        ("k=1e5", Contact::Penetrating, [5e-3, 9.0, 0.0, 50.0], None),
        // At 50 m/s the interface carries 1.4 kN of a spring of 5e4 N/m at most, 19 kN of one of 1e7.
        ("k=5e4 interface=plastic", Contact::Fused, [5e-3, 0.0, 0.0, 50.0], Some(Outcome::Arrested)),
        ("k=1e7 interface=plastic", Contact::Fused, [5e-3, 0.0, 0.0, 50.0], None),
        ("k=1e7 interface=plastic g=2", Contact::Fused, [5e-3, 0.0, 0.0, 50.0], None),
        ("k=1e5 interface=plastic x_stop=1mm", Contact::Fused, [5e-3, 0.0, 0.0, 50.0], None),
        // The projectile flies back at 60 m/s, the plate can at most at 50; at 40 they may meet again.
        ("k=1e5", Contact::FreeFlight, [-1e-3, -10.0, 0.0, -50.0], Some(Outcome::Separated)),
        ("k=1e5", Contact::FreeFlight, [-1e-3, -90.0, 0.0, 50.0], None),
        ("k=0", Contact::FreeFlight, [-1e-3, -1.0, 0.0, 50.0], Some(Outcome::Separated)),
        ("k=0", Contact::FreeFlight, [-1e-3, 1.0, 0.0, 50.0], None),
    ];

    #[test]
    fn an_outcome_is_decided_where_no_energy_is_left_to_change_it() {
        for (pairs, contact, state, expected) in OUTCOMES {
            let found = look(pairs, contact, state, |it, state| (it.outcome(state), ())).0;
            assert_eq!(found, expected, "{pairs} {contact:?} {state:?}");
        }
    }

    /// Equilibrium half a millimetre from the zero of the spring and from the onset of the stop, which push equally hard.
    #[test]
    fn valid_a_plate_stands_where_spring_and_stop_hold_each_other() {
        let pairs = "k=1e5 interface=plastic x_stop=-1mm stop_kind=elastic k_stop=1e5";
        let found = |x_m: f64, w_m_s: f64| {
            look(pairs, Contact::Fused, [5e-3, 0.0, x_m, w_m_s], |it, at| {
                (it.is_in_equilibrium(at), it.outcome(at))
            })
        };
        assert_eq!(found(5e-4, 0.0), (true, Some(Outcome::Arrested)));
        assert!(!found(5e-4, 1e-3).0 && !found(6e-4, 0.0).0);
    }

    /// 59 g at 50 m/s: x = w (M/k)^(1/2) on a spring, M w/b on a damper, less on both.
    #[test]
    fn valid_the_greatest_displacement_is_where_the_energy_is_spent() {
        let state = [5e-3, 0.0, 0.0, 50.0];
        let far = |pairs: &str| {
            look(pairs, Contact::Fused, state, |equations, state| equations.farthest_m(state, 0.0))
        };
        assert!(is_near(far("k=1e5 gamma=1").unwrap(), 50.0 * (0.059f64 / 1e5).sqrt(), 1e-14));
        assert!(is_near(far("k=0 b=100 gamma=1").unwrap(), 0.059 * 50.0 / 100.0, 1e-14));
        assert_eq!(far("k=0"), Some(f64::INFINITY));
        assert_eq!(far("k=0 b=100 m=2"), Some(f64::INFINITY));
        assert_eq!(far("k=0 b=100 x_stop=1mm"), Some(1e-3));
        let elastic = "k=0 b=100 x_stop=1mm stop_kind=elastic k_stop=1e6";
        for pending in ["k=1e5 b=100", "k=1e5 x_stop=1mm", elastic] {
            assert_eq!(far(pending), None, "{pending}");
        }
    }

    /// `M w' = -b w^m` by the classical Runge-Kutta method with fixed steps of distance, `M dw/dx = -b w^(m-1)`.
    #[test]
    fn valid_a_coasting_plate_keeps_the_velocity_that_its_damper_leaves() {
        for (exponent, b, w, x) in [
            (2.0, 3.0, 7.0, 0.4),
            (3.0, 2.0, 5.0, 1.5),
            (1.0, 2.0, 9.0, 1.2),
            (0.5, 4.0, 9.0, 0.5),
            (2.5, 1.0, 4.0, 3.0),
        ] {
            let slope = |w: f64| -b * w.powf(exponent - 1.0) / 0.7;
            let h = x / 2000.0;
            let expected = (0..2000).fold(w, |w, _| {
                let first = slope(w);
                let second = slope(w + 0.5 * h * first);
                let third = slope(w + 0.5 * h * second);
                let last = slope(w + h * third);
                w + h / 6.0 * (first + 2.0 * (second + third) + last)
            });
            let damper = PowerLaw { coefficient: b, exponent };
            let found = coasting_m_s(damper, 0.7, (w, x));
            assert!(is_near(found, expected, 1e-9), "{exponent}: {found} {expected}");
        }
        // What would stop earlier does not arrive.
        let damper = PowerLaw { coefficient: 2.0, exponent: 1.0 };
        assert_eq!(coasting_m_s(damper, 0.7, (1.0, 0.4)).to_bits(), 0);
    }

    /// 59 g on 100 kN/m from 1 mm before its zero: with 0.65 of the critical damping they go exp(-pi 0.65/(1 - 0.65²)^(1/2)) of that beyond
    /// it; against 1 MN s/m they come to it with k x/b at most, and stop within M w/b.
    #[test]
    fn valid_a_plate_that_is_driven_to_its_rest_goes_no_farther_than_its_damper_lets_it() {
        let over_m = |damping: f64| {
            let pairs = format!("gamma=1 k=1e5 b={damping}");
            look(&pairs, Contact::Fused, [5e-3, 0.0, -1e-3, 0.0], |it, at| {
                it.overshoots_at_most_m(at, it.energy_j(at), 0.0)
            })
        };
        let part = 100.0 / (2.0 * (0.059f64 * 1e5).sqrt());
        let overshoot = (-std::f64::consts::PI * part / (1.0 - part * part).sqrt()).exp();
        assert!(over_m(100.0) >= 1e-3 * overshoot && over_m(0.0).is_infinite());
        assert!(is_near(over_m(1e6), 0.059 * (1e5 * 1e-3 / 1e6) / 1e6, 1e-12));
    }

    /// The energy is that of spring and stop, each half of stiffness times the square of its way.
    #[test]
    fn valid_an_elastic_stop_takes_what_the_spring_does_not() {
        let pairs = "k=1e5 x_stop=1mm stop_kind=elastic k_stop=1e6";
        let reach_m = |energy_j: f64| {
            look(pairs, Contact::Fused, [5e-3, 0.0, 0.0, 0.0], |it, state| {
                it.max_reachable_displacement_m(state, energy_j)
            })
        };
        let (x, stop) = (3e-3, 2e-3);
        let energy_j = 0.5 * (1e5 * x * x + 1e6 * stop * stop);
        assert!((reach_m(energy_j) / x - 1.0).abs() < 1e-14);
        assert!((reach_m(0.5 * 1e5 * 1e-8) / 1e-4 - 1.0).abs() < 1e-14);
        // A rigid stop gives way to nothing.
        let rigid = look("k=1e5 x_stop=1mm", Contact::Fused, [0.0; 4], |it, state| {
            it.max_reachable_displacement_m(state, 10.0)
        });
        assert!((rigid - 1e-3).abs() < 1e-18);
    }

    /// Along the cylinder behind the nose A S stays what it is: the slips take all energy above 2 (A S)²/k, over the path E/(A S).
    #[test]
    fn valid_the_last_slips_take_the_energy_above_the_oscillation_that_holds() {
        let pairs = "k=1e7 gamma=1 interface=plastic g=2";
        let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
        let strength_n = setup.geometry.area_m2(0.012) * setup.strength_pa;
        let holding_j = 2.0 * strength_n * strength_n / 1e7;
        let energy_j = 1.001 * 1.001 * holding_j;
        let w_m_s = -(2.0 * energy_j / setup.mass.joined_kg).sqrt();
        let mode = HybridMode { contact: Contact::Fused, deepest_m: 0.012, ..first(&setup).0 };
        let state = State { q_m: 0.012, w_m_s, ..State::default() };
        let travel_m =
            Equations { setup: &setup, mode: &mode }.remaining_slip_m(&state, 1.0).unwrap();
        let expected_m = (energy_j - holding_j) / strength_n;
        assert!((travel_m / expected_m - 1.0).abs() < 1e-10, "{travel_m} {expected_m}");
    }
}
