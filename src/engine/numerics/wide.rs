//! Numbers in the lanes of a vector: the same arithmetic on one number or on as many as the processor's vectors hold.
//!
//! A kernel written for [`Real`] runs on `f64` for a single problem and on [`Wide`] for several at once; lane by lane the results
//! are the same to the last digit, since nothing is contracted or reordered. Which vectors there are is found out when the
//! program runs ([`Arch::dispatch`](pulp::Arch::dispatch)). Whatever is to be compiled for them must be inlined into what is
//! dispatched.

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::Simd;

/// A number, or one in each lane of a vector.
pub(crate) trait Real:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + Div<Output = Self>
{
    /// The same value in each lane, in a number of this kind.
    #[must_use]
    fn alike(self, value: f64) -> Self;
    /// Its amount.
    #[must_use]
    fn abs(self) -> Self;
    /// A function of this and another number, lane by lane.
    #[must_use]
    fn each(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;
    /// The number in a lane; there is at least one.
    fn lane(&self, lane: usize) -> f64;
}

impl Real for f64 {
    #[inline(always)]
    fn alike(self, value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn each(self, other: Self, f: impl Fn(Self, Self) -> Self) -> Self {
        f(self, other)
    }

    #[inline(always)]
    fn lane(&self, _lane: usize) -> Self {
        *self
    }
}

/// As many numbers as a vector of the processor holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide<S: Simd> {
    simd: S,
    lanes: S::f64s,
}

impl<S: Simd> Wide<S> {
    /// The first numbers of a slice, which has at least as many as there are lanes.
    #[inline(always)]
    pub(crate) fn load(simd: S, numbers: &[f64]) -> Self {
        Self { simd, lanes: S::as_simd_f64s(numbers).0[0] }
    }

    /// Put the numbers into a slice, which has room for them.
    #[inline(always)]
    pub(crate) fn store(self, numbers: &mut [f64]) {
        S::as_mut_simd_f64s(numbers).0[0] = self.lanes;
    }

    #[inline(always)]
    fn with(self, lanes: S::f64s) -> Self {
        Self { lanes, ..self }
    }
}

impl<S: Simd> Neg for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.with(self.simd.neg_f64s(self.lanes))
    }
}

impl<S: Simd> Add for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(self.simd.add_f64s(self.lanes, other.lanes))
    }
}

impl<S: Simd> Sub for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(self.simd.sub_f64s(self.lanes, other.lanes))
    }
}

impl<S: Simd> Mul for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(self.simd.mul_f64s(self.lanes, other.lanes))
    }
}

impl<S: Simd> Mul<f64> for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * self.alike(factor)
    }
}

impl<S: Simd> Div for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(self.simd.div_f64s(self.lanes, other.lanes))
    }
}

impl<S: Simd> Real for Wide<S> {
    #[inline(always)]
    fn alike(self, value: f64) -> Self {
        self.with(self.simd.splat_f64s(value))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.with(self.simd.abs_f64s(self.lanes))
    }

    #[inline(always)]
    fn each(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut lanes = [self.lanes];
        let others = [other.lanes];
        let others: &[f64] = pulp::bytemuck::cast_slice(&others);
        for (lane, other) in pulp::bytemuck::cast_slice_mut(&mut lanes).iter_mut().zip(others) {
            *lane = f(*lane, *other);
        }
        self.with(lanes[0])
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        pulp::bytemuck::cast_slice(std::slice::from_ref(&self.lanes))[lane]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::{Arch, WithSimd};

    /// A bit of everything.
    #[inline(always)]
    fn formula<R: Real>(a: R, b: R) -> R {
        let power = a.abs().each(b, f64::powf);
        (a * b - power / b) * 3.0 + a.alike(0.1) + -b
    }

    struct Compare;

    impl WithSimd for Compare {
        type Output = usize;

        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) -> usize {
            let a: Vec<f64> = (0..16).map(|i| 0.3 * f64::from(i) - 2.2).collect();
            let b: Vec<f64> = (0..16).map(|i| 1.0 + 0.17 * f64::from(i)).collect();
            let wide = formula(Wide::load(simd, &a), Wide::load(simd, &b));
            let mut stored = [0.0; 16];
            wide.store(&mut stored);
            for lane in 0..S::F64_LANES {
                let one = formula(a[lane], b[lane]);
                assert_eq!(wide.lane(lane).to_bits(), one.to_bits(), "{lane}");
                assert_eq!(stored[lane].to_bits(), one.to_bits(), "{lane}");
            }
            S::F64_LANES
        }
    }

    #[test]
    fn each_lane_is_the_single_number_to_the_last_digit() {
        assert!(Arch::new().dispatch(Compare) >= 1);
        assert_eq!(Compare.with_simd(pulp::Scalar::new()), 1);
    }
}
