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
            self.powers[k][J] = product_at::<N, J>(&self.powers[k - 1], z, 0);
        }
        self.coefficient * self.powers[K - 1][J]
    }
}

/// coefficient · |z|^exponent sgn(z), away from zero.
#[derive(Clone, Copy)]
pub(super) struct Power<const N: usize> {
    law: PowerLaw,
    inverse: f64,
    force: [f64; N],
    /// i z[i].
    slope: [f64; N],
}

impl<const N: usize> Power<N> {
    pub(super) fn new(law: PowerLaw) -> Self {
        Self { law, inverse: 0.0, force: [0.0; N], slope: [0.0; N] }
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
            return self.force[0];
        }
        self.slope[J] = J as f64 * z[J];
        let by_slope = product_at::<N, J>(&self.slope, &self.force, 1);
        let by_value = product_at::<N, J>(z, &self.force, 1);
        let sum = (self.law.exponent + 1.0) / J as f64 * by_slope - by_value;
        self.force[J] = sum * self.inverse;
        self.force[J]
    }
}

/// Coefficient J of a², in two sums that the processor can add side by side.
#[inline]
pub(super) fn square_at<const N: usize, const J: usize>(a: &[f64; N]) -> f64 {
    let (mut first, mut second) = (0.0, 0.0);
    let half = J.div_ceil(2);
    let mut i = 0;
    while i + 1 < half {
        first += a[i] * a[J - i];
        second += a[i + 1] * a[J - i - 1];
        i += 2;
    }
    if i < half {
        first += a[i] * a[J - i];
    }
    let twice = 2.0 * (first + second);
    if J.is_multiple_of(2) { twice + a[J / 2] * a[J / 2] } else { twice }
}

/// Coefficient J of a·b, likewise; the terms from `from` up.
#[inline]
pub(super) fn product_at<const N: usize, const J: usize>(
    a: &[f64; N],
    b: &[f64; N],
    from: usize,
) -> f64 {
    let (mut first, mut second) = (0.0, 0.0);
    let mut i = from;
    while i < J {
        first += a[i] * b[J - i];
        second += a[i + 1] * b[J - i - 1];
        i += 2;
    }
    if i == J {
        first += a[J] * b[0];
    }
    first + second
}
