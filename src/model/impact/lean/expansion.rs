//! The lean contact's Taylor expansion, unrolled at compile time for each spring and damper, and how far it is trusted.
//!
//! Same recurrence as `motion.rs`. The clock may be graded: with t = s³ a force that starts like t^(3n) is far smoother in s,
//! so that the steps grow from the singular start several times as fast.

use crate::model::impact::lean::law::{Law, product_before, square_at, square_before};
use crate::numerics::larger;

/// The four series, in the step's own variable from 0 to 1.
pub(super) struct Series<const N: usize> {
    pub(super) travel: [f64; N],
    pub(super) slip: [f64; N],
    pub(super) plate: [f64; N],
    pub(super) speed: [f64; N],
}

impl<const N: usize> Series<N> {
    /// (travel, slip, plate, speed) at `span`, side by side.
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
}

/// What stays the same along the way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    pub(super) strength_pa: f64,
    pub(super) drag_kg_m3: f64,
    pub(super) slip_mobility: f64,
    pub(super) plate_mobility: f64,
    pub(super) cos: f64,
    pub(super) velocity_m_s: f64,
}

/// Time along a step.
#[derive(Clone, Copy, Debug)]
pub(super) enum Clock {
    /// t = start + unit · sigma.
    Even {
        /// s.
        unit_s: f64,
    },
    /// t = (s + unit · sigma)³.
    Graded {
        /// s^(1/3).
        s: f64,
        /// s^(1/3).
        unit: f64,
    },
}

impl Clock {
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
    /// Expand from `state` = (travel, slip, plate, speed) on a piece whose area is a0 + a1 (q - origin) + a2 (q - origin)².
    #[inline]
    pub(super) fn expand<const N: usize, const GRADED: bool>(
        &self,
        (mut spring, mut damper): (impl Law<N>, impl Law<N>),
        state: [f64; 4],
        rates: [f64; 3],
        (origin_m, a): (f64, [f64; 3]),
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
        let by_slip = 2.0 * drag * state[1];
        let by_slip_there = area[0] * by_slip;
        macro_rules! order {
            ($($j:literal)*) => { $( if $j < N {
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
                let g = per_force * (spring.term::<J>(&s.plate) + damper.term::<J>(&s.speed));
                slowing[J] = self.cos * g - f;
                driving[J] = share * f - g;
                if J + 1 < N {
                    let per_order = 1.0 / (J + 1) as f64;
                    s.travel[J + 1] = per_order * unit_s * along::<N, J, GRADED>(&s.slip, rates);
                    s.slip[J + 1] = per_order * along::<N, J, GRADED>(&slowing, rates);
                    s.plate[J + 1] = per_order * unit_s * along::<N, J, GRADED>(&s.speed, rates);
                    s.speed[J + 1] = per_order * along::<N, J, GRADED>(&driving, rates);
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        s
    }

    /// The part of the unit for which the truncated terms stay below the tolerance, in what matters to depth and time.
    #[inline]
    pub(super) fn trusted<const N: usize>(&self, s: &Series<N>, tolerance: f64) -> f64 {
        let length = s.travel[0].abs() + s.travel[1].abs();
        let (per_length, per_speed) = (1.0 / length, 1.0 / self.velocity_m_s);
        let size = |j: usize| {
            let lengths = larger(s.travel[j].abs(), s.plate[j].abs()) * per_length;
            larger(lengths, larger(s.slip[j].abs(), s.speed[j].abs()) * per_speed)
        };
        // The last two terms: one of them may vanish by symmetry.
        let reach = (tolerance / larger(size(N - 1), size(N - 2))).ln();
        let order = if reach < 0.0 { N - 2 } else { N - 1 };
        let step = (reach / order as f64).exp();
        // Zero terms give an infinite reach; a NaN gives none.
        if step.is_nan() {
            0.0
        } else if step < REACH_MAX {
            step
        } else {
            REACH_MAX
        }
    }
}

/// Greatest step in units of the expansion's own.
const REACH_MAX: f64 = 20.0;

/// Coefficient J of dz/dt · dt/dsigma, in units of the clock's first rate.
#[inline]
fn along<const N: usize, const J: usize, const GRADED: bool>(z: &[f64; N], rates: [f64; 3]) -> f64 {
    let mut older = 0.0;
    if GRADED && J >= 2 {
        older += rates[2] * z[J - 2];
    }
    if GRADED && J >= 1 {
        older += rates[1] * z[J - 1];
    }
    if GRADED { older + z[J] } else { z[J] }
}
