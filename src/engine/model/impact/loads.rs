//! Peak loads of mount, spring and fused interface, and the maximum speed, which a geared inertia turns with.

use std::array;

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::Contact;
use crate::model::impact::resolution::{NEGLIGIBLE, RESOLUTION};
use crate::model::impact::results::ImpactRun;
use crate::model::impact::state::State;
use crate::model::mechanism::load;
use crate::model::run::EventKind;
use crate::numerics::{larger, smaller};

/// Signs of the mechanism's force for compression and tension of the interface.
pub(super) const COMPRESSION_TENSION_SIGNS: [f64; 2] = [1.0, -1.0];

/// Peak loads of mount, spring and fused interface, and the maximum speed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Loads {
    /// Peak of the total force of spring, damper and elastic stop, N.
    pub(super) mount_n: f64,
    /// Minimum displacement of the plate, m: how far it goes back.
    pub(super) backmost_m: f64,
    /// Maximum speed of the plate, m/s; without rotation only at ends of steps and before events.
    pub(super) fastest_m_s: f64,
    /// Peak compression and tension of the fused interface, relative to its limit load in compression.
    pub(super) ratios: Option<[f64; 2]>,
    /// Times at which compression and tension first exceed the limit loads, s.
    pub(super) exceeded_s: [Option<f64>; 2],
    /// Whether the interface has a limit load of zero.
    pub(super) no_strength: bool,
}

impl Loads {
    /// Returns the forces of the mechanism forwards and backwards above which a recorded peak can increase, N.
    pub(super) fn known_n(&self, equations: &Equations<'_>, state: &State) -> [f64; 2] {
        match equations.joint_n(state) {
            Some(strength_n) if strength_n > 0.0 => {
                let per_ratio_n = strength_n / equations.setup.interface_fraction();
                let ratios = self.ratios.unwrap_or_default();
                let carried_n = equations.carried_weight_n() / equations.setup.interface_fraction();
                array::from_fn(|direction| {
                    let by_interface_n = ratios[direction] * per_ratio_n
                        - COMPRESSION_TENSION_SIGNS[direction] * carried_n;
                    smaller(by_interface_n, self.mount_n)
                })
            }
            _ => [self.mount_n; 2],
        }
    }
}

impl Equations<'_> {
    /// Returns the limit loads of the fused interface, relative to that in compression.
    pub(super) fn limit_load_ratios(&self) -> [f64; 2] {
        [1.0, self.setup.interface.grip]
    }

    /// Returns the limit load of the fused interface, N; `None` if the bodies are not fused.
    pub(super) fn joint_n(&self, state: &State) -> Option<f64> {
        let is_joined = self.mode.contact == Contact::Fused && self.setup.law == ContactLaw::Flow;
        (is_joined && !self.plate_rests()).then(|| self.strength_n(state))
    }
}

impl ImpactRun<'_> {
    /// Returns `true` if later motion can increase the peak loads of mount, spring or interface, or the energy of a geared inertia.
    pub(super) fn loads_may_grow(&mut self) -> bool {
        let Self { setup, ref mode, ref state, ref record, .. } = *self;
        let equations = Equations { setup, mode };
        let is_joined = mode.contact == Contact::Fused;
        if equations.is_in_equilibrium(state) || equations.drives_away(state).is_some() {
            return false;
        }
        let energy_j = equations.energy_j(state);
        // A rigid stop exerts an unbounded force.
        if equations.meets_rigid_stop(state, energy_j)
            && record.events.iter().all(|event| event.kind != EventKind::StopHit)
        {
            return true;
        }
        // A slip ends where the bodies stick, and load their interface anew.
        if setup.interface.is_plastic && setup.law == ContactLaw::Flow && equations.is_touching() {
            return true;
        }
        let bounds = equations.peak_load_bounds_n(state, energy_j);
        let most_n = equations.mechanism_bounds_n(bounds);
        let limits_n: [f64; 2] = equations.limit_loads_n(state).into();
        let slips = is_joined
            && setup.interface.is_plastic
            && (0..2).any(|way| bounds[way] > limits_n[way]);
        let [back_m, reach_m] = equations.range_m(state, energy_j);
        let exceeds =
            is_joined && !setup.interface.is_plastic && bounds[0] > equations.strength_n(state);
        let speed_m_s = equations.greatest_speed_m_s(state, energy_j, [back_m, reach_m]);
        let damped_j = setup.damper.force(speed_m_s) * (reach_m - back_m);
        let is_conserved = (setup.damper.is_absent() || damped_j <= NEGLIGIBLE * energy_j)
            && !slips
            && !(setup.has_stop() && reach_m >= setup.stop.position_m);
        if !is_conserved
            || setup.absorber.is_some()
            || (exceeds && record.loads.exceeded_s[0].is_none())
        {
            // A plastic interface carries no more than its limit load; its tension is no result.
            let carried = if setup.interface.is_plastic {
                [smaller(bounds[0], limits_n[0]), 0.0]
            } else {
                bounds
            };
            let carried_n = equations.mechanism_bounds_n(carried);
            let known_n = record.loads.known_n(&equations, state);
            let grows = (0..2).any(|way| {
                carried_n[way] > known_n[way] * (1.0 + RESOLUTION)
                    || most_n[way] > record.loads.mount_n * (1.0 + RESOLUTION)
            });
            let turns_faster = setup.mass.turning_kg > 0.0
                && speed_m_s > record.loads.fastest_m_s * (1.0 + RESOLUTION);
            return grows || turns_faster || self.is_loaded_more_at(back_m);
        }
        // The energy is conserved on the way to the peak of the spring force and back.
        let Self { setup, ref mode, ref state, ref mut record, .. } = *self;
        record.note_loads(&Equations { setup, mode }, state, most_n, |_| None);
        record.loads.fastest_m_s = larger(speed_m_s, record.loads.fastest_m_s);
        self.note_way_back(back_m);
        false
    }

    /// Records a displacement behind the plate that it reaches; an infinite one only past a limit of the spring.
    fn note_way_back(&mut self, back_m: f64) {
        if back_m.is_finite() || self.is_past_limit(back_m) {
            let known_m = &mut self.record.loads.backmost_m;
            *known_m = smaller(back_m, *known_m);
        }
    }

    fn is_past_limit(&self, x_m: f64) -> bool {
        load::travel_margin(self.scene, [x_m; 2]).is_some_and(|margin| margin < 1.0)
    }

    /// Returns `true` if a swing of fused bodies is still to load their interface, which a short one does no less than a long one.
    pub(super) fn follows_short_swing(&mut self) -> bool {
        self.mode.contact == Contact::Fused && self.loads_may_grow()
    }

    /// Returns `true` if the spring stores more at a displacement behind the plate, or is closer to its limits there, than so far.
    /// Records that a plate which nothing stops is past all limits.
    fn is_loaded_more_at(&mut self, back_m: f64) -> bool {
        let (spring, known_m) = (&self.setup.spring, self.record.loads.backmost_m);
        let far_m = self.decided.map_or(self.record.farthest_m, |(_, far_m)| far_m);
        if !(far_m.is_finite() && back_m < known_m) {
            return false;
        }
        if back_m.is_infinite() {
            if self.equations().is_gone_backwards(&self.state) {
                self.note_way_back(back_m);
                return false;
            }
            return self.is_past_limit(back_m);
        }
        let margin = |ends_m: [f64; 2]| load::travel_margin(self.scene, ends_m);
        let known_j = spring.greatest_energy(known_m, far_m);
        spring.greatest_energy(back_m, known_m) > known_j * (1.0 + RESOLUTION)
            || margin([back_m; 2])
                .zip(margin([known_m, far_m]))
                .is_some_and(|(there, known)| there < known * (1.0 - RESOLUTION))
    }
}
