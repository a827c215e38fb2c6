//! The contact kernel's Taylor expansion, unrolled at compile time for each spring and damper, and how far it is trusted.
//!
//! Orders that an expansion does not have, because J excludes them, are behind `const { .. }`, so that the compiler does not
//! inline them.
//!
//! Time may be graded: with t = s³ a force that starts like t^(3n) is far smoother in s, so that the steps grow from the singular
//! start several times as fast.

use crate::model::contact_kernel::law::{Law, product_from, square_before};
use crate::model::mechanism::moving_plate_kg;
use crate::model::scene::Scene;
use crate::numerics::larger;

/// Terms of an expansion.
pub(super) const TERMS: usize = 14;
pub(super) type Coefficients = [f64; TERMS];

/// Travel, slip, plate displacement and plate velocity.
pub(super) type State = [f64; 4];

/// Greatest step in units of the expansion's own.
const REACH_MAX: f64 = 20.0;

/// The four series, in the step's own variable from 0 to 1.
pub(super) struct Series {
    pub(super) travel: Coefficients,
    pub(super) slip: Coefficients,
    pub(super) plate: Coefficients,
    pub(super) speed: Coefficients,
}

impl Series {
    /// The state at `span`.
    #[inline(always)]
    pub(super) fn state(&self, span: f64) -> State {
        let mut state = [0.0; 4];
        for j in (0..TERMS).rev() {
            let terms = [self.travel[j], self.slip[j], self.plate[j], self.speed[j]];
            for (value, term) in state.iter_mut().zip(terms) {
                *value = *value * span + term;
            }
        }
        state
    }

    /// How large the last terms are in what matters to depth and time, relative. The plate's displacement is measured against
    /// `plate_m`, m, if that is less than the travel.
    #[inline(always)]
    fn last_terms(&self, velocity_m_s: f64, plate_m: f64) -> f64 {
        let length = self.travel[0].abs() + self.travel[1].abs();
        let weight = larger(length / plate_m, 1.0);
        let (mut lengths, mut speeds) = (0.0, 0.0);
        // Two terms: one may vanish by symmetry.
        for j in TERMS - 2..TERMS {
            lengths += self.travel[j].abs() + weight * self.plate[j].abs();
            speeds += self.slip[j].abs() + self.speed[j].abs();
        }
        lengths / length + speeds / velocity_m_s
    }

    /// The part of the unit for which the truncated terms stay below the tolerance.
    #[inline(always)]
    pub(super) fn trusted(&self, tolerance: f64, velocity_m_s: f64, plate_m: f64) -> f64 {
        let reach = tolerance / self.last_terms(velocity_m_s, plate_m);
        let order = if reach < 1.0 { TERMS - 2 } else { TERMS - 1 };
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
}

/// How fast a series changes at `span`.
#[inline(always)]
pub(super) fn slope(series: &Coefficients, span: f64) -> f64 {
    let mut sum = 0.0;
    for j in (1..TERMS).rev() {
        sum = sum * span + series[j] * j as f64;
    }
    sum
}

/// The constants of the contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    pub(super) strength_pa: f64,
    pub(super) drag_kg_m3: f64,
    /// What a unit of contact force takes from the slip, 1/kg.
    pub(super) slip_mobility: f64,
    /// What a unit of force gives the plate, 1/kg; zero if it cannot move.
    pub(super) plate_mobility: f64,
    pub(super) cos: f64,
    pub(super) velocity_m_s: f64,
}

/// The area on a piece of the travel: a0 + a1 (q - origin) + a2 (q - origin)².
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    pub(super) origin_m: f64,
    pub(super) a: [f64; 3],
}

/// Time along a step, t = (s + unit · sigma)³, or in proportion to sigma where it is not graded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock {
    /// dt/dsigma at first, s.
    pub(super) unit_s: f64,
    /// unit/s; zero of a clock that is not graded.
    pub(super) grade: f64,
}

impl Clock {
    /// The time that passes up to `span`, s.
    pub(super) fn elapsed_s(self, span: f64) -> f64 {
        let part = self.grade * span;
        self.unit_s * span * (1.0 + part * (1.0 + part / 3.0))
    }

    /// The time of the next step, after one that was trusted up to `trusted` and ended at `span`.
    pub(super) fn next(self, span: f64, trusted: f64) -> Self {
        let farther = 1.0 + self.grade * span;
        let unit_s = self.unit_s * trusted * farther * farther * farther;
        Self { unit_s, grade: self.grade * trusted }
    }
}

impl Constants {
    /// Those of a scene.
    pub(super) fn of(scene: &Scene, cos: f64) -> Self {
        let plate_mobility = if scene.is_rigid() { 0.0 } else { 1.0 / moving_plate_kg(scene) };
        Self {
            strength_pa: scene.flow_strength_pa(),
            drag_kg_m3: scene.drag_kg_m3(),
            slip_mobility: 1.0 / scene.projectile.mass_kg + cos * cos * plate_mobility,
            plate_mobility,
            cos,
            velocity_m_s: scene.projectile.velocity_m_s,
        }
    }

    /// Expand from a state on a piece of this area.
    #[inline(always)]
    pub(super) fn expand(
        &self,
        mut spring: Law,
        mut damper: Law,
        state: State,
        clock: Clock,
        Area { origin_m, a }: Area,
    ) -> Series {
        let zero = [0.0; TERMS];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: zero };
        let (mut offset, mut area, mut pressure) = (zero, zero, zero);
        let (mut slowing, mut driving) = (zero, zero);
        (s.travel[0], s.slip[0], s.plate[0], s.speed[0]) = (state[0], state[1], state[2], state[3]);
        // Velocities that pressure and mechanism would give in a unit of the clock.
        let Clock { unit_s, grade } = clock;
        let (strength, drag) = (
            self.strength_pa * self.slip_mobility * unit_s,
            self.drag_kg_m3 * self.slip_mobility * unit_s,
        );
        let per_force = self.plate_mobility * unit_s;
        let share = self.cos * self.plate_mobility / self.slip_mobility;
        offset[0] = state[0] - origin_m;
        area[0] = a[0] + offset[0] * (a[1] + a[2] * offset[0]);
        // What a coefficient of the slip adds to that of the pressure, and to that of the force.
        let by_slip = drag * state[1] * 2.0;
        let by_slip_there = area[0] * by_slip;
        macro_rules! orders {
            ($($j:literal)*) => { $( {
                const J: usize = $j;
                let f;
                if J == 0 {
                    pressure[0] = strength + drag * s.slip[0] * s.slip[0];
                    f = area[0] * pressure[0];
                } else {
                    offset[J] = s.travel[J];
                    let curvature = square_before::<J>(&offset) + offset[0] * offset[J] * 2.0;
                    area[J] = a[1] * offset[J] + a[2] * curvature;
                    let older = drag * square_before::<J>(&s.slip);
                    pressure[J] = older + by_slip * s.slip[J];
                    let known = product_from::<J, 1>(&area, &pressure) + area[J] * pressure[0];
                    f = known + area[0] * older + by_slip_there * s.slip[J];
                }
                let g = per_force * (spring.term::<J>(&s.plate) + damper.term::<J>(&s.speed));
                slowing[J] = self.cos * g - f;
                driving[J] = share * f - g;
                let per_order = 1.0 / (J + 1) as f64;
                s.travel[J + 1] = along::<J>(&s.slip, grade) * (unit_s * per_order);
                s.slip[J + 1] = along::<J>(&slowing, grade) * per_order;
                s.plate[J + 1] = along::<J>(&s.speed, grade) * (unit_s * per_order);
                s.speed[J + 1] = along::<J>(&driving, grade) * per_order;
            } )* };
        }
        orders!(0 1 2 3 4 5 6 7 8 9 10 11 12);
        s
    }
}

/// Coefficient J of dz/dt · dt/dsigma, in units of the clock's first rate.
#[inline(always)]
fn along<const J: usize>(z: &Coefficients, grade: f64) -> f64 {
    if const { J == 0 } || !(grade > 0.0) {
        z[J]
    } else if const { J == 1 } {
        2.0 * grade * z[0] + z[1]
    } else {
        grade * (grade * z[J - 2] + 2.0 * z[J - 1]) + z[J]
    }
}

/// x^(1/order) to within a per cent, which is all a step needs, at a tenth of the price: the digits of a number, read as an
/// integer, are its logarithm by straight lines, and a parabola makes up for most of that on the way back.
///
/// For x >= 0 and order >= 9; infinite for infinite x, NaN for NaN.
#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    reason = "orders from 9 on keep the exponent within 120"
)]
fn rough_root(x: f64, order: f64) -> f64 {
    const ONE: u64 = 1.0f64.to_bits();
    const STEP: f64 = 1.0 / (1u64 << 52) as f64;
    if !x.is_finite() {
        return x;
    }
    let log = (x.to_bits().wrapping_sub(ONE)).cast_signed() as f64 * STEP / order;
    // The floor, or one less where nothing is left: then the part is 1.
    let whole = log as i64 - i64::from(log < 0.0);
    let part = log - whole as f64;
    // Exact at both ends of [0, 1] and in between to 3 in 1000.
    let mantissa = 1.0 + part * (0.6565 + 0.3435 * part);
    mantissa * f64::from_bits(ONE.wrapping_add_signed(whole << 52))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rough_root_is_right_to_a_per_cent() {
        for order in [9.0, 10.0, 11.0, 13.0, 17.0] {
            let mut x = 1e-300;
            while x < 1e300 {
                let error = rough_root(x, order) / f64::powf(x, 1.0 / order) - 1.0;
                assert!(error.abs() < 0.01, "{x} {order}: {error}");
                x *= 1.37;
            }
            // A zero reads as 2^-1023: its root is small, not zero.
            assert!(rough_root(0.0, order) < 1e-17);
            assert!(rough_root(f64::INFINITY, order).is_infinite());
            assert!(rough_root(f64::NAN, order).is_nan());
        }
    }
}
