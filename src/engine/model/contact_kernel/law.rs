//! The force laws of the contact kernel, one Taylor coefficient at a time, each compiled for itself. They know no step and no
//! event.

use crate::model::contact_kernel::expansion::{Coefficients, TERMS};
use crate::model::mechanism::PowerLaw;

pub(super) trait Law: Copy {
    /// Coefficient J of the force, given the argument's coefficients up to J.
    fn term<const J: usize>(&mut self, z: &Coefficients) -> f64;
}

/// coefficient · z; zero for no law at all.
#[derive(Clone, Copy)]
pub(super) struct Linear(pub(super) f64);

impl Law for Linear {
    #[inline(always)]
    fn term<const J: usize>(&mut self, z: &Coefficients) -> f64 {
        self.0 * z[J]
    }
}

/// coefficient · |z|^exponent sgn(z), away from zero.
#[derive(Clone, Copy)]
pub(super) struct Power {
    law: PowerLaw,
    inverse: f64,
    tangent: f64,
    force: Coefficients,
    /// i times the coefficient i of z.
    slope: Coefficients,
}

impl Power {
    pub(super) fn of(law: PowerLaw) -> Self {
        Self { law, inverse: 0.0, tangent: 0.0, force: [0.0; TERMS], slope: [0.0; TERMS] }
    }
}

impl Law for Power {
    /// From z f' = exponent f z': j `z[0]` `f[j]` = sum over i of (exponent (i) - (j - i)) `z[i]` `f[j - i]`.
    #[inline(always)]
    fn term<const J: usize>(&mut self, z: &Coefficients) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients of z = 2 (1 + s): those of 3 |z|^1.5 are 3 · 2^1.5 binomial(1.5, j), on the other side of zero their negatives.
    #[test]
    fn a_power_is_the_binomial_series_on_either_side_of_zero() {
        for side in [1.0, -1.0] {
            let mut z = [0.0; TERMS];
            (z[0], z[1]) = (2.0 * side, 2.0 * side);
            let mut law = Power::of(PowerLaw { coefficient: 3.0, exponent: 1.5 });
            let found = [
                law.term::<0>(&z),
                law.term::<1>(&z),
                law.term::<2>(&z),
                law.term::<3>(&z),
                law.term::<4>(&z),
            ];
            let mut exact = side * 3.0 * 2f64.powf(1.5);
            for (j, found) in found.into_iter().enumerate() {
                assert!((found - exact).abs() < 1e-14, "{side} {j}: {found} {exact}");
                exact *= (1.5 - j as f64) / (j + 1) as f64;
            }
        }
    }

    #[test]
    fn products_of_geometric_series_count_their_terms() {
        let ones = [1.0; TERMS];
        // 1/(1 - s) squared has the coefficients J + 1; without the ends as many fewer as are left out.
        assert!((square_before::<7>(&ones) - 6.0).abs() < 1e-15);
        assert!((square_before::<8>(&ones) - 7.0).abs() < 1e-15);
        assert!((product_from::<7, 1>(&ones, &ones) - 6.0).abs() < 1e-15);
        assert!((product_from::<8, 2>(&ones, &ones) - 5.0).abs() < 1e-15);
    }
}
