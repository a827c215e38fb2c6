//! Peak forces of mount and fused interface.

use std::array;

use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::Contact;
use crate::model::impact::state::State;
use crate::numerics::smaller;

/// Signs of the mechanism's force for compression and tension of the interface.
pub(super) const COMPRESSION_TENSION_SIGNS: [f64; 2] = [1.0, -1.0];

/// Peak forces of mount and fused interface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Loads {
    /// Peak of the total force of spring, damper and elastic stop, N.
    pub(super) mount_n: f64,
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
