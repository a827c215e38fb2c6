//! The force laws of the contact kernel, one Taylor coefficient at a time, each compiled for itself. They know no step and no
//! event.

use crate::model::mechanism::PowerLaw;

pub(super) trait Law<const N: usize>: Copy {
    /// Whether it is one analytic function on both sides of zero.
    const TWO_SIDED: bool;
    /// Coefficient J of the force, given the argument's coefficients up to J.
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64;
}

/// A damper along an expansion, which may need to know what it holds back.
pub(super) trait Damping<const N: usize>: Copy {
    /// Coefficient J of the force, given the velocity's coefficients up to J and that of all else that drives the velocity, and
    /// what a force takes from it.
    fn against<const J: usize>(&mut self, w: &[f64; N], driving: f64, per_force: f64) -> f64;
}

impl<const N: usize, L: Law<N>> Damping<N> for L {
    #[inline(always)]
    fn against<const J: usize>(&mut self, w: &[f64; N], _driving: f64, _per_force: f64) -> f64 {
        self.term::<J>(w)
    }
}

/// coefficient · sqrt(w) for a velocity that starts from rest without a jerk, like t²: the root y, which starts like t, follows
/// from (J + 1) · coefficient J + 1 of y² = driving - per force · coefficient · y.
#[derive(Clone, Copy)]
pub(super) struct RootFromRest<const N: usize> {
    coefficient: f64,
    root: [f64; N],
}

impl<const N: usize> RootFromRest<N> {
    pub(super) fn new(coefficient: f64) -> Self {
        Self { coefficient, root: [0.0; N] }
    }
}

impl<const N: usize> Damping<N> for RootFromRest<N> {
    #[inline(always)]
    fn against<const J: usize>(&mut self, _w: &[f64; N], driving: f64, per_force: f64) -> f64 {
        let held = per_force * self.coefficient;
        if const { J == 1 } {
            self.root[1] = 2.0 * driving / (held + (held * held + 8.0 * driving).sqrt());
        } else if const { J > 1 } {
            let mut older = 0.0;
            for i in 2..J {
                older += self.root[i] * self.root[J + 1 - i];
            }
            let next = (J + 1) as f64;
            self.root[J] = (driving - next * older) / (2.0 * next * self.root[1] + held);
        }
        self.coefficient * self.root[J]
    }
}

/// coefficient · z; zero for no law at all.
#[derive(Clone, Copy)]
pub(super) struct Linear(pub(super) f64);

impl<const N: usize> Law<N> for Linear {
    const TWO_SIDED: bool = true;
    #[inline(always)]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        self.0 * z[J]
    }
}

/// coefficient · z², where z is positive.
#[derive(Clone, Copy)]
pub(super) struct Square<const N: usize>(f64);

impl<const N: usize> Square<N> {
    pub(super) fn of(law: PowerLaw) -> Self {
        Self(law.coefficient)
    }
}

impl<const N: usize> Law<N> for Square<N> {
    const TWO_SIDED: bool = false;
    #[inline(always)]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        self.0 * square_at::<N, J>(z)
    }
}

/// coefficient · |z|^exponent sgn(z), away from zero.
#[derive(Clone, Copy)]
pub(super) struct Power<const N: usize> {
    coefficient: f64,
    exponent: f64,
    inverse: f64,
    tangent: f64,
    force: [f64; N],
    /// i times the coefficient i of z.
    slope: [f64; N],
}

impl<const N: usize> Power<N> {
    pub(super) fn of(PowerLaw { coefficient, exponent }: PowerLaw) -> Self {
        Self { coefficient, exponent, inverse: 0.0, tangent: 0.0, force: [0.0; N], slope: [0.0; N] }
    }

    /// Start where argument and force are known.
    #[inline(always)]
    pub(super) fn start(&mut self, z: f64, force: f64) {
        self.inverse = 1.0 / z;
        self.force[0] = force;
        self.tangent = self.exponent * force * self.inverse;
    }

    /// What coefficient J of the argument, taken as zero when it was requested, adds to that of the force.
    #[inline(always)]
    pub(super) fn add<const J: usize>(&mut self, z: f64) {
        self.slope[J] = z * J as f64;
        self.force[J] += self.tangent * z;
    }
}

impl<const N: usize> Law<N> for Power<N> {
    const TWO_SIDED: bool = false;
    /// From z f' = exponent f z': j `z[0]` `f[j]` = sum over i of (exponent (i) - (j - i)) `z[i]` `f[j - i]`.
    #[inline(always)]
    fn term<const J: usize>(&mut self, z: &[f64; N]) -> f64 {
        if const { J == 0 } {
            let power = z[0].abs().powf(self.exponent).copysign(z[0]);
            self.start(z[0], self.coefficient * power);
            return self.force[0];
        }
        self.slope[J] = z[J] * J as f64;
        let per_order = 1.0 / J as f64;
        let more = self.exponent + 1.0;
        let older = if const { J > 2 } {
            let by_slope = product_from::<N, J, 2>(&self.slope, &self.force);
            let by_value = product_from::<N, J, 2>(z, &self.force);
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
    let twice = (even + odd) * 2.0;
    if const { J >= 2 && J.is_multiple_of(2) } { twice + a[J / 2] * a[J / 2] } else { twice }
}

/// Coefficient J of a·b but for the parts of a\[J\] and b\[J\], likewise.
#[inline(always)]
pub(super) fn product_before<const N: usize, const J: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    product_from::<N, J, 1>(a, b)
}

/// Coefficient J of a·b without the first and the last FROM coefficients of either, the newest last.
#[inline(always)]
fn product_from<const N: usize, const J: usize, const FROM: usize>(
    a: &[f64; N],
    b: &[f64; N],
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

/// Coefficient J of a².
#[inline(always)]
pub(super) fn square_at<const N: usize, const J: usize>(a: &[f64; N]) -> f64 {
    if const { J == 0 } { a[0] * a[0] } else { square_before::<N, J>(a) + a[0] * a[J] * 2.0 }
}
