//! The force laws of the lean contact, one Taylor coefficient at a time, each compiled for itself. They know no step and no event.

use crate::model::mechanism::{PowerLaw, sign};

/// A force law along an expansion.
pub(super) trait Law<const N: usize>: Copy {
    /// Whether the law can be expanded at its zero.
    const SMOOTH: bool;
    /// Whether it is one analytic function on both sides of zero.
    const TWO_SIDED: bool;
    /// Coefficient J of the force, given the argument's coefficients up to J.
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64;
}

/// coefficient · z; zero for no law at all.
#[derive(Clone, Copy)]
pub(super) struct Linear(pub(super) f64);

impl<const N: usize> Law<N> for Linear {
    const SMOOTH: bool = true;
    const TWO_SIDED: bool = true;
    #[inline]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        self.0 * z[J]
    }
}

/// coefficient · z^K, on the side of zero where z starts.
#[derive(Clone, Copy)]
pub(super) struct Whole<const N: usize, const K: usize> {
    coefficient: f64,
    /// z², z³, ...
    powers: [[f64; N]; K],
}

impl<const N: usize, const K: usize> Whole<N, K> {
    /// The law on the side of zero on which its argument is.
    pub(super) fn new(law: PowerLaw, side: f64) -> Self {
        let coefficient = if K % 2 == 1 { law.coefficient } else { law.coefficient * side };
        Self { coefficient, powers: [[0.0; N]; K] }
    }
}

impl<const N: usize, const K: usize> Law<N> for Whole<N, K> {
    const SMOOTH: bool = true;
    const TWO_SIDED: bool = K % 2 == 1;
    #[inline]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        self.powers[0][J] = z[J];
        for k in 1..K {
            self.powers[k][J] = product_at::<N, J>(&self.powers[k - 1], z);
        }
        self.coefficient * self.powers[K - 1][J]
    }
}

/// coefficient · |z|^exponent sgn(z), away from zero.
#[derive(Clone, Copy)]
pub(super) struct Power<const N: usize> {
    law: PowerLaw,
    inverse: f64,
    /// df/dz at the start.
    tangent: f64,
    force: [f64; N],
    /// i z[i].
    slope: [f64; N],
}

impl<const N: usize> Power<N> {
    pub(super) fn new(law: PowerLaw) -> Self {
        Self { law, inverse: 0.0, tangent: 0.0, force: [0.0; N], slope: [0.0; N] }
    }
}

impl<const N: usize> Law<N> for Power<N> {
    const SMOOTH: bool = false;
    const TWO_SIDED: bool = false;
    /// From z f' = exponent f z': j `z[0]` `f[j]` = sum over i of (exponent (i) - (j - i)) `z[i]` `f[j - i]`.
    #[inline]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        if J == 0 {
            self.inverse = 1.0 / z[0];
            self.force[0] = self.law.coefficient * z[0].abs().powf(self.law.exponent) * sign(z[0]);
            self.tangent = self.law.exponent * self.force[0] * self.inverse;
            return self.force[0];
        }
        self.slope[J] = J as f64 * z[J];
        let by_slope = product_before::<N, J>(&self.slope, &self.force);
        let by_value = product_before::<N, J>(z, &self.force);
        let sum = (self.law.exponent + 1.0) / J as f64 * by_slope - by_value;
        self.force[J] = sum * self.inverse + self.tangent * z[J];
        self.force[J]
    }
}

/// Coefficient J of a² but for the part of a\[J\], 2 a\[0\] a\[J\]; the newest coefficients come last, so that the
/// processor can add the others while it waits for them.
#[inline]
pub(super) fn square_before<const N: usize, const J: usize>(a: &[f64; N]) -> f64 {
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
    let twice = 2.0 * (even + odd);
    if J >= 2 && J.is_multiple_of(2) { twice + a[J / 2] * a[J / 2] } else { twice }
}

/// Coefficient J of a·b but for the parts of a\[J\] and b\[J\], likewise.
#[inline]
pub(super) fn product_before<const N: usize, const J: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let (mut first, mut second) = (0.0, 0.0);
    let mut i = J.div_ceil(2);
    while i > 1 {
        i -= 1;
        first += a[i] * b[J - i];
        second += a[J - i] * b[i];
    }
    let sum = first + second;
    if J >= 2 && J.is_multiple_of(2) { sum + a[J / 2] * b[J / 2] } else { sum }
}

/// Coefficient J of a².
#[inline]
pub(super) fn square_at<const N: usize, const J: usize>(a: &[f64; N]) -> f64 {
    if J == 0 { a[0] * a[0] } else { square_before::<N, J>(a) + 2.0 * a[0] * a[J] }
}

/// Coefficient J of a·b.
#[inline]
pub(super) fn product_at<const N: usize, const J: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    if J == 0 { a[0] * b[0] } else { product_before::<N, J>(a, b) + a[J] * b[0] + a[0] * b[J] }
}
