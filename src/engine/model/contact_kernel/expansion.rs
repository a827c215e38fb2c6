//! The contact kernel's Taylor expansion, unrolled at compile time for each spring and damper, and how far it is trusted.
//!
//! Orders that an expansion does not have, because J or N exclude them, are behind `const { .. }`, so that the compiler does not
//! inline them.
//!
//! Same recurrence as `motion.rs`. The clock may be graded: with t = s³ a force that starts like t^(3n) is far smoother in s,
//! so that the steps grow from the singular start several times as fast.

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::contact_kernel::law::{Damping, Law, product_before, square_at, square_before};
use crate::model::mechanism::moving_plate_kg;
use crate::model::scene::Scene;
use crate::numerics::larger;
use crate::numerics::taylor::rough_root;

/// The four series, in the step's own variable from 0 to 1.
pub(super) struct Series<const N: usize> {
    pub(super) travel: [f64; N],
    pub(super) slip: [f64; N],
    pub(super) plate: [f64; N],
    pub(super) speed: [f64; N],
}

impl<const N: usize> Series<N> {
    /// (travel, slip, plate, speed) at `span`, evaluated together.
    #[inline(always)]
    pub(super) fn state(&self, span: f64) -> [f64; 4] {
        let mut state = [0.0; 4];
        for j in (0..N).rev() {
            let terms = [self.travel[j], self.slip[j], self.plate[j], self.speed[j]];
            for (value, term) in state.iter_mut().zip(terms) {
                *value = *value * span + term;
            }
        }
        state
    }

    /// How fast the slip changes at `span`.
    #[inline(always)]
    pub(super) fn slip_slope(&self, span: f64) -> f64 {
        let mut sum = 0.0;
        for j in (1..N).rev() {
            sum = sum * span + self.slip[j] * j as f64;
        }
        sum
    }
}

/// The constants of the contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    pub(super) strength_pa: f64,
    pub(super) drag_kg_m3: f64,
    pub(super) slip_mobility: f64,
    pub(super) plate_mobility: f64,
    pub(super) cos: f64,
    pub(super) velocity_m_s: f64,
}

impl Constants {
    /// Those of a scene whose plate moves or stays where it is.
    pub(super) fn of(scene: &Scene, cos: f64, moves: bool) -> Self {
        let plate_mobility = if moves { 1.0 / moving_plate_kg(scene) } else { 0.0 };
        Self {
            strength_pa: scene.flow_strength_pa(),
            drag_kg_m3: scene.drag_kg_m3(),
            slip_mobility: 1.0 / scene.projectile.mass_kg + cos * cos * plate_mobility,
            plate_mobility,
            cos,
            velocity_m_s: scene.projectile.velocity_m_s,
        }
    }

    /// The relative motion alone, where the contact force slows the slip by so much, 1/kg.
    pub(super) fn passage<'a>(&self, geometry: &'a Geometry, mobility_per_kg: f64) -> Passage<'a> {
        Passage {
            geometry,
            mobility_per_kg,
            strength_pa: self.strength_pa,
            drag_kg_m3: self.drag_kg_m3,
            velocity_m_s: self.velocity_m_s,
        }
    }
}

/// The area on a piece of the travel: a0 + a1 (q - origin) + a2 (q - origin)².
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    pub(super) origin_m: f64,
    pub(super) a: [f64; 3],
}

/// Time along a step.
#[derive(Clone, Copy, Debug)]
pub(super) enum StepTime {
    /// t = start + unit · sigma.
    Even { unit_s: f64 },
    /// t = (s + unit · sigma)³.
    Graded {
        /// s^(1/3).
        s: f64,
        /// s^(1/3).
        unit: f64,
    },
}

impl StepTime {
    /// The first three coefficients of dt/dsigma, s.
    pub(super) fn rates(self) -> [f64; 3] {
        match self {
            Self::Even { unit_s } => [unit_s, 0.0, 0.0],
            Self::Graded { s, unit } => {
                [3.0 * unit * s * s, 6.0 * unit * unit * s, 3.0 * unit * unit * unit]
            }
        }
    }

    /// The time that passes up to `span`, s.
    pub(super) fn elapsed_s(self, span: f64) -> f64 {
        match self {
            Self::Even { unit_s } => span * unit_s,
            Self::Graded { s, unit } => {
                let d = span * unit;
                d * (3.0 * s * (s + d) + d * d)
            }
        }
    }

    /// The clock of the next step, after one that was trusted up to `trusted` and ended at `span`.
    pub(super) fn next(self, span: f64, trusted: f64) -> Self {
        match self {
            Self::Even { unit_s } => Self::Even { unit_s: unit_s * trusted },
            Self::Graded { s, unit } => {
                let next = s + span * unit;
                Self::Graded { s: next, unit: unit * trusted * next / s }
            }
        }
    }

    /// The same start with another unit.
    pub(super) fn shorter(self, factor: f64) -> Self {
        match self {
            Self::Even { unit_s } => Self::Even { unit_s: unit_s * factor },
            Self::Graded { s, unit } => Self::Graded { s, unit: unit * factor },
        }
    }
}

impl Constants {
    /// Expand from `state` = (travel, slip, plate, speed) on a piece of this area.
    #[inline(always)]
    pub(super) fn expand<const N: usize, const GRADED: bool>(
        &self,
        mut spring: impl Law<N>,
        mut damper: impl Damping<N>,
        state: [f64; 4],
        rates: [f64; 3],
        Area { origin_m, a }: Area,
    ) -> Series<N> {
        let zero = [0.0; N];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: zero };
        let (mut offset, mut area, mut pressure) = (zero, zero, zero);
        let (mut slowing, mut driving) = (zero, zero);
        (s.travel[0], s.slip[0], s.plate[0], s.speed[0]) = (state[0], state[1], state[2], state[3]);
        // Velocities that pressure and mechanism would give in a unit of the clock.
        let unit_s = rates[0];
        let (strength, drag) = (
            self.strength_pa * self.slip_mobility * unit_s,
            self.drag_kg_m3 * self.slip_mobility * unit_s,
        );
        let per_force = self.plate_mobility * unit_s;
        let share = self.cos * self.plate_mobility / self.slip_mobility;
        let rates = [unit_s, rates[1] / unit_s, rates[2] / unit_s];
        offset[0] = state[0] - origin_m;
        area[0] = a[0] + offset[0] * (a[1] + a[2] * offset[0]);
        // What a coefficient of the slip adds to that of the pressure, and to that of the force.
        let by_slip = drag * state[1] * 2.0;
        let by_slip_there = area[0] * by_slip;
        macro_rules! order {
            ($($j:literal)*) => { $( if const { $j < N } {
                const J: usize = $j;
                let f;
                if J == 0 {
                    pressure[0] = strength + drag * s.slip[0] * s.slip[0];
                    f = area[0] * pressure[0];
                } else {
                    offset[J] = s.travel[J];
                    area[J] = a[1] * offset[J] + a[2] * square_at::<N, J>(&offset);
                    let older = drag * square_before::<N, J>(&s.slip);
                    pressure[J] = older + by_slip * s.slip[J];
                    let known = product_before::<N, J>(&area, &pressure) + area[J] * pressure[0];
                    f = known + area[0] * older + by_slip_there * s.slip[J];
                }
                let held = spring.term::<J>(&s.plate);
                let pushed = share * f;
                let damped = damper.against::<J>(&s.speed, pushed - per_force * held, per_force);
                let g = per_force * (held + damped);
                slowing[J] = self.cos * g - f;
                driving[J] = pushed - g;
                if const { J + 1 < N } {
                    let per_order = 1.0 / (J + 1) as f64;
                    s.travel[J + 1] = along::<N, J, GRADED>(&s.slip, rates) * (unit_s * per_order);
                    s.slip[J + 1] = along::<N, J, GRADED>(&slowing, rates) * per_order;
                    s.plate[J + 1] = along::<N, J, GRADED>(&s.speed, rates) * (unit_s * per_order);
                    s.speed[J + 1] = along::<N, J, GRADED>(&driving, rates) * per_order;
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        s
    }

    /// How large the last terms are in what matters to depth and time, relative. The plate's displacement is measured against
    /// `plate_m`, m, if that is less than the travel.
    #[inline(always)]
    pub(super) fn last_terms<const N: usize>(&self, s: &Series<N>, plate_m: f64) -> f64 {
        let length = s.travel[0].abs() + s.travel[1].abs();
        let share = larger(length / plate_m, 1.0);
        let (mut lengths, mut speeds) = (0.0, 0.0);
        // Two terms: one may vanish by symmetry.
        for j in N - 2..N {
            lengths += s.travel[j].abs() + share * s.plate[j].abs();
            speeds += s.slip[j].abs() + s.speed[j].abs();
        }
        lengths / length + speeds / self.velocity_m_s
    }
}

/// The part of the unit for which truncated terms of that size stay below the tolerance.
#[inline]
pub(super) fn trusted<const N: usize>(last_terms: f64, tolerance: f64) -> f64 {
    let reach = tolerance / last_terms;
    let order = if reach < 1.0 { N - 2 } else { N - 1 };
    let step = rough_root(reach, order as f64);
    // Zero terms give an infinite reach; a NaN gives none.
    if step.is_nan() {
        0.0
    } else if step < REACH_MAX {
        step
    } else {
        REACH_MAX
    }
}

/// Greatest step in units of the expansion's own.
const REACH_MAX: f64 = 20.0;

/// Coefficient J of dz/dt · dt/dsigma, in units of the clock's first rate.
#[inline(always)]
fn along<const N: usize, const J: usize, const GRADED: bool>(z: &[f64; N], rates: [f64; 3]) -> f64 {
    if const { GRADED && J >= 2 } {
        (rates[2] * z[J - 2] + rates[1] * z[J - 1]) + z[J]
    } else if const { GRADED && J == 1 } {
        rates[1] * z[0] + z[1]
    } else {
        z[J]
    }
}
