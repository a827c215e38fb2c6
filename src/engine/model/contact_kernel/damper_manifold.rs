//! A plate whose damper is so strong that it follows the forces at once: its velocity is that of the slow manifold.
//!
//! With the rate lambda = b/m the balance b w = F cos - k x - m w' is solved for w term by term, first without inertia; each
//! further pass takes m w' from the one before and gains a factor of lambda times the step (Hairer and Wanner, *Solving
//! Ordinary Differential Equations II*, section VI.3: the slow manifold of a singular perturbation). The transient at first
//! contact, over within some 1/lambda, leaves the plate where `delay` says.

use crate::model::contact_kernel::expansion::{Area, Constants, Series};
use crate::model::contact_kernel::law::{product_at, square_at};

/// Passes: each gains three digits and more where this expansion is used.
const PASSES: usize = 4;
/// Rounds for the first coefficient, each of which gains as many digits as drag is small against the damper.
const ROUNDS: usize = 6;
/// Time constants of the damper within the contact from which on it is used.
const RATES_MIN: f64 = 2e3;
/// Spring against damper: k/b per rate of the damper at most.
const SPRING_MAX: f64 = 1e-3;
/// Part of the tolerance that transients may take.
const SHARE: f64 = 0.3;

/// The strong damper, and a spring that is slow against it.
#[derive(Clone, Copy, Debug)]
pub(super) struct DamperManifold {
    pub(super) damper_n_s_m: f64,
    pub(super) spring_n_m: f64,
}

impl DamperManifold {
    /// Whether the plate follows within the tolerance in a contact of this duration, s, and length, m.
    pub(super) fn follows(
        &self,
        constants: &Constants,
        contact_s: f64,
        travel_m: f64,
        growth_n_s: f64,
        tolerance: f64,
    ) -> bool {
        let rate = self.damper_n_s_m * constants.plate_mobility;
        rate * contact_s >= RATES_MIN
            && self.spring_n_m <= SPRING_MAX * self.damper_n_s_m * rate
            && self.delay_m(constants, growth_n_s) <= SHARE * tolerance * travel_m
    }

    /// How far the plate is ahead of the slow motion once the transient of first contact is over, m.
    pub(super) fn delay_m(&self, constants: &Constants, growth_n_s: f64) -> f64 {
        let rate = self.damper_n_s_m * constants.plate_mobility;
        growth_n_s * constants.cos / (self.damper_n_s_m * rate * rate)
    }

    /// Expand from `state` = (travel, slip, plate, speed); the speed is found again.
    pub(super) fn expand<const N: usize>(
        &self,
        constants: &Constants,
        state: [f64; 4],
        unit_s: f64,
        area: Area,
    ) -> Series<N> {
        let mut inertia = [0.0; N];
        let mut series = self.pass(constants, state, unit_s, area, &inertia);
        for _ in 1..PASSES {
            let per_rate = 1.0 / (self.damper_n_s_m * constants.plate_mobility * unit_s);
            for (j, (inertia, next)) in inertia.iter_mut().zip(&series.speed[1..]).enumerate() {
                *inertia = per_rate * (j + 1) as f64 * next;
            }
            series = self.pass(constants, state, unit_s, area, &inertia);
        }
        series
    }

    /// One pass, with m w'/b given.
    fn pass<const N: usize>(
        &self,
        constants: &Constants,
        state: [f64; 4],
        unit_s: f64,
        Area { origin_m, a }: Area,
        inertia: &[f64; N],
    ) -> Series<N> {
        let Constants { strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, .. } =
            *constants;
        let slowing = slip_mobility - cos * cos * plate_mobility;
        let mobility = 1.0 / self.damper_n_s_m;
        let zero = [0.0; N];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: zero };
        let (mut offset, mut area) = (zero, zero);
        let (pressure, projectile) = (&mut [0.0; N], &mut [0.0; N]);
        (s.travel[0], s.plate[0]) = (state[0], state[2]);
        projectile[0] = state[1] + cos * state[3];
        s.slip[0] = state[1];
        macro_rules! order {
            ($($j:literal)*) => { $( if const { $j < N } {
                const J: usize = $j;
                offset[J] = s.travel[J] - if J == 0 { origin_m } else { 0.0 };
                area[J] = a[1] * offset[J] + a[2] * square_at::<N, J>(&offset)
                    + if J == 0 { a[0] } else { 0.0 };
                let mut force;
                if J == 0 {
                    force = 0.0;
                    for _ in 0..ROUNDS {
                        pressure[0] = strength_pa + drag_kg_m3 * s.slip[0] * s.slip[0];
                        force = area[0] * pressure[0];
                        s.speed[0] =
                            mobility * (cos * force - self.spring_n_m * s.plate[0]) - inertia[0];
                        s.slip[0] = projectile[0] - cos * s.speed[0];
                    }
                } else {
                    // All but the part of the slip's coefficient J, which is not known yet, ...
                    pressure[J] = drag_kg_m3 * square_at::<N, J>(&s.slip);
                    force = product_at::<N, J>(&area, pressure);
                    // ... and that part, linear in it.
                    let drag = 2.0 * drag_kg_m3 * s.slip[0];
                    let by_slip = area[0] * drag;
                    let known = cos * (force + by_slip * projectile[J]) - self.spring_n_m * s.plate[J];
                    s.speed[J] = (mobility * known - inertia[J]) / (1.0 + cos * cos * by_slip * mobility);
                    s.slip[J] = projectile[J] - cos * s.speed[J];
                    pressure[J] += drag * s.slip[J];
                    force += by_slip * s.slip[J];
                }
                if const { J + 1 < N } {
                    let h = unit_s / (J + 1) as f64;
                    s.travel[J + 1] = h * s.slip[J];
                    s.plate[J + 1] = h * s.speed[J];
                    projectile[J + 1] = -h * slowing * force;
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        s
    }
}
