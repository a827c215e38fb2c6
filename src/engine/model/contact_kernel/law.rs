//! The force laws of the contact kernel, one Taylor coefficient at a time. They know no step and no event.

use crate::model::contact_kernel::expansion::{Coefficients, TERMS};
use crate::model::mechanism::PowerLaw;

/// coefficient · |z|^exponent sgn(z), away from zero unless it is linear.
#[derive(Clone, Copy)]
pub(super) struct Law {
    law: PowerLaw,
    is_linear: bool,
    inverse: f64,
    tangent: f64,
    force: Coefficients,
    /// i times the coefficient i of z.
    slope: Coefficients,
}

impl Law {
    pub(super) fn of(law: PowerLaw) -> Self {
        let zero = [0.0; TERMS];
        Self { law, is_linear: law.is_linear(), inverse: 0.0, tangent: 0.0, force: zero, slope: zero }
    }

    /// Coefficient J of the force, given the argument's coefficients up to J: from z f' = exponent f z',
    /// j `z[0]` `f[j]` = sum over i of (exponent (i) - (j - i)) `z[i]` `f[j - i]`.
    #[inline(always)]
    pub(super) fn term<const J: usize>(&mut self, z: &Coefficients) -> f64 {
        if self.is_linear {
            return self.law.coefficient * z[J];
        }
        let exponent = self.law.exponent;
        if const { J == 0 } {
            self.inverse = 1.0 / z[0];
            self.force[0] = self.law.coefficient * z[0].abs().powf(exponent).copysign(z[0]);
            self.tangent = exponent * self.force[0] * self.inverse;
            return self.force[0];
        }
        self.slope[J] = z[J] * J as f64;
        let per_order = 1.0 / J as f64;
        let more = exponent + 1.0;
        let older = if const { J > 2 } {
            let by_slope = product_from::<J, 2>(&self.slope, &self.force);
            let by_value = product_from::<J, 2>(z, &self.force);
            (more * per_order * by_slope - by_value) * self.inverse
        } else {
            0.0
        };
        let mut newest = self.tangent * z[J];
        if const { J > 1 } {
            // The youngest factors apart, so that a coefficient waits for the one before no longer than it must.
            let per_force = (more * per_order - 1.0) * z[1] * self.inverse;
            newest += per_force * self.force[J - 1];
        }
        if const { J > 2 } {
            let per_value = (more * (per_order * (J - 1) as f64) - 1.0) * self.force[1];
            newest += per_value * self.inverse * z[J - 1];
        }
        self.force[J] = older + newest;
        self.force[J]
    }
}
/// Coefficient J of a² but for the part of a\[J\], 2 a\[0\] a\[J\]; the newest coefficients come last, so that the
/// processor can add the others while it waits for them.
#[inline(always)]
pub(super) fn square_before<const J: usize>(a: &Coefficients) -> f64 {
    let (mut even, mut odd) = (0.0, 0.0);
    let mut i = J.div_ceil(2);
    while i > 1 {
        i -= 1;
        let term = a[i] * a[J - i];
        if i.is_multiple_of(2) {
            even += term;
        } else {
            odd += term;
        }
    }
    let twice = (even + odd) * 2.0;
    if const { J >= 2 && J.is_multiple_of(2) } { twice + a[J / 2] * a[J / 2] } else { twice }
}

/// Coefficient J of a·b without the first and the last FROM coefficients of either, the newest last.
#[inline(always)]
pub(super) fn product_from<const J: usize, const FROM: usize>(
    a: &Coefficients,
    b: &Coefficients,
) -> f64 {
    let (mut first, mut second) = (0.0, 0.0);
    let mut i = J.div_ceil(2);
    while i > FROM {
        i -= 1;
        first += a[i] * b[J - i];
        second += a[J - i] * b[i];
    }
    let sum = first + second;
    if const { J >= 2 * FROM && J.is_multiple_of(2) } { sum + a[J / 2] * b[J / 2] } else { sum }
}
