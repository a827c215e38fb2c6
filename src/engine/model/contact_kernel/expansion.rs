//! Taylor expansion of the contact kernel, and its step size.
//!
//! Time can be graded: with t = s³ a force like t^n becomes s^(3n), which is smoother. The steps after a singular start then grow several
//! times as fast.

use crate::model::contact::AreaLaw;
use crate::model::contact_kernel::Contact;
use crate::model::power_law::PowerLaw;
use crate::numerics::{larger, smaller};

/// Number of terms of an expansion.
const TERMS: usize = 14;
type Coefficients = [f64; TERMS];

/// Travel, relative velocity, displacement and velocity of the plate.
pub(super) type State = [f64; 4];

/// Maximum step size, in units of the expansion.
const REACH_MAX: f64 = 20.0;

/// Series of the four components of the state, in the variable of the step.
pub(super) struct Series {
    pub(super) travel: Coefficients,
    pub(super) slip: Coefficients,
    plate: Coefficients,
    pub(super) speed: Coefficients,
}

impl Series {
    /// Returns the state at `span`.
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

    /// Returns the derivative of the plate's velocity at `span`.
    pub(super) fn acceleration(&self, span: f64) -> f64 {
        (1..TERMS).rev().fold(0.0, |sum, j| sum * span + self.speed[j] * j as f64)
    }

    /// Returns the step size, in units of the expansion, for which the truncation error is below the tolerance; NaN if a term is. The error
    /// scales are those of depth and time, and `plate_m` if it is smaller than the travel.
    #[inline(always)]
    pub(super) fn trusted(&self, tolerance: f64, velocity_m_s: f64, plate_m: f64) -> f64 {
        let length_m = self.travel[0].abs() + self.travel[1].abs();
        let weight = larger(length_m / plate_m, 1.0);
        let size = |j: usize| {
            (self.travel[j].abs() + weight * self.plate[j].abs()) / length_m
                + (self.slip[j].abs() + self.speed[j].abs()) / velocity_m_s
        };
        // The last two terms: one of them can vanish by symmetry.
        let reach = tolerance / (size(TERMS - 2) + size(TERMS - 1));
        let order = if reach < 1.0 { TERMS - 2 } else { TERMS - 1 };
        smaller(reach.powf(1.0 / order as f64), REACH_MAX)
    }
}

/// Time along a step: t = (s + unit · sigma)³, or proportional to sigma without grading.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeGrading {
    /// dt/dsigma at first, s.
    pub(super) unit_s: f64,
    /// Ratio unit/s; 0 without grading.
    pub(super) grade: f64,
}

impl TimeGrading {
    /// Returns the time from the start of the step to `span`, s.
    pub(super) fn elapsed_s(self, span: f64) -> f64 {
        let part = self.grade * span;
        self.unit_s * span * (1.0 + part * (1.0 + part / 3.0))
    }

    /// Returns the grading of the next step, after a step of accuracy up to `trusted` that ended at `span`.
    pub(super) fn next(self, span: f64, trusted: f64) -> Self {
        let farther = 1.0 + self.grade * span;
        let unit_s = self.unit_s * trusted * farther * farther * farther;
        Self { unit_s, grade: self.grade * trusted }
    }

    /// Returns coefficient j of dz/dt · dt/dsigma, in the unit at the start.
    #[inline(always)]
    fn along(self, z: &Coefficients, j: usize) -> f64 {
        if j == 0 || self.grade == 0.0 {
            z[j]
        } else if j == 1 {
            2.0 * self.grade * z[0] + z[1]
        } else {
            self.grade * (self.grade * z[j - 2] + 2.0 * z[j - 1]) + z[j]
        }
    }
}

/// Series of a power law; the argument is not zero unless the law is linear.
struct Force {
    law: PowerLaw,
    is_linear: bool,
    inverse: f64,
    terms: Coefficients,
}

impl Force {
    fn new(law: PowerLaw) -> Self {
        Self { law, is_linear: law.is_linear(), inverse: 0.0, terms: [0.0; TERMS] }
    }

    /// Returns coefficient j from those of the argument up to j. From z f' = exponent f z',
    /// j `z[0]` `f[j]` = sum over i of (exponent (i) - (j - i)) `z[i]` `f[j - i]`.
    #[inline(always)]
    fn term(&mut self, z: &Coefficients, j: usize) -> f64 {
        let PowerLaw { coefficient, exponent } = self.law;
        if self.is_linear {
            return coefficient * z[j];
        }
        if j == 0 {
            self.inverse = 1.0 / z[0];
            self.terms[0] = self.law.force(z[0]);
        } else {
            let part = |i: usize| {
                ((exponent + 1.0) * (i as f64 / j as f64) - 1.0) * z[i] * self.terms[j - i]
            };
            // The latest coefficients come last: the other terms do not wait for them.
            let mut sum = 0.0;
            for i in 1..j {
                sum += part(i + 1);
            }
            self.terms[j] = (sum + part(1)) * self.inverse;
        }
        self.terms[j]
    }
}

/// Returns coefficient j of a·b without the terms of the first and the last coefficients.
#[inline(always)]
fn between(a: &Coefficients, b: &Coefficients, j: usize) -> f64 {
    let mut sum = 0.0;
    for i in 1..j {
        sum += a[i] * b[j - i];
    }
    sum
}

impl Contact {
    /// Expands the solution from a state on a piece of the area law; `None` if the area is not a polynomial.
    #[inline(always)]
    pub(super) fn expand(
        &self,
        [spring, damper]: [PowerLaw; 2],
        state: State,
        clock: TimeGrading,
        area: AreaLaw,
    ) -> Option<Series> {
        let AreaLaw::Quadratic { origin_m, a } = area else { return None };
        let (mut spring, mut damper) = (Force::new(spring), Force::new(damper));
        let zero = [0.0; TERMS];
        let [mut travel, mut slip, mut plate, mut speed] = [zero; 4];
        let [mut offset, mut area, mut pressure, mut slowing, mut driving] = [zero; 5];
        [travel[0], slip[0], plate[0], speed[0]] = state;
        // Changes of velocity by pressure and mechanism in one unit of the grading.
        let TimeGrading { unit_s, .. } = clock;
        let per_pressure = self.slip_mobility * unit_s;
        let (strength, drag) = (self.strength_pa * per_pressure, self.drag_kg_m3 * per_pressure);
        // The contribution of the velocity coefficient to the pressure is added last, to shorten the dependency chain.
        let by_slip = 2.0 * drag * state[1];
        let per_force = self.plate_mobility * unit_s;
        let fraction = self.cos * self.plate_mobility / self.slip_mobility;
        macro_rules! unrolled {
            ($($j:literal)*) => { $( {
                const J: usize = $j;
                offset[J] = travel[J];
                let f;
                if J == 0 {
                    offset[0] -= origin_m;
                    area[0] = a[0] + offset[0] * (a[1] + a[2] * offset[0]);
                    pressure[0] = strength + drag * slip[0] * slip[0];
                    f = area[0] * pressure[0];
                } else {
                    let curvature = between(&offset, &offset, J) + 2.0 * offset[0] * offset[J];
                    area[J] = a[1] * offset[J] + a[2] * curvature;
                    let older = drag * between(&slip, &slip, J);
                    pressure[J] = older + by_slip * slip[J];
                    let known = between(&area, &pressure, J) + area[J] * pressure[0];
                    f = known + area[0] * older + area[0] * by_slip * slip[J];
                }
                let g = per_force * (spring.term(&plate, J) + damper.term(&speed, J));
                slowing[J] = self.cos * g - f;
                driving[J] = fraction * f - g;
                let per_order = 1.0 / (J + 1) as f64;
                travel[J + 1] = clock.along(&slip, J) * (unit_s * per_order);
                slip[J + 1] = clock.along(&slowing, J) * per_order;
                plate[J + 1] = clock.along(&speed, J) * (unit_s * per_order);
                speed[J + 1] = clock.along(&driving, J) * per_order;
            } )* };
        }
        unrolled!(0 1 2 3 4 5 6 7 8 9 10 11 12);
        Some(Series { travel, slip, plate, speed })
    }
}
