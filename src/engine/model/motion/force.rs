//! Spring and damper forces, one Taylor coefficient at a time.

use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{PowerLaw, WHOLE_MAX, sign};
use crate::numerics::series::{Powers, power, product};

/// A force law whose coefficients are requested in order, 0 first.
pub(super) trait ForceTerm<const N: usize> {
    /// Coefficient j of the force, given the argument's coefficients up to j.
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64;
}

impl<const N: usize> ForceTerm<N> for Box<dyn ForceTerm<N>> {
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64 {
        self.as_mut().coefficient(z, j)
    }
}

pub(super) struct NoForce;

impl<const N: usize> ForceTerm<N> for NoForce {
    #[inline]
    fn coefficient(&mut self, _: &[f64; N], _: usize) -> f64 {
        0.0
    }
}

/// A linear force: the number is its coefficient.
impl<const N: usize> ForceTerm<N> for f64 {
    #[inline]
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64 {
        *self * z[j]
    }
}

/// A whole exponent from 2 on, by products.
pub(super) struct Whole<const N: usize> {
    coefficient: f64,
    exponent: usize,
    /// z^2, z^3, ... up to the exponent.
    powers: [[f64; N]; WHOLE_MAX - 1],
}

impl<const N: usize> Whole<N> {
    /// `side` is the side of zero, which an even power needs to be odd.
    pub(super) fn new(coefficient: f64, exponent: usize, side: f64) -> Self {
        let signed = if exponent.is_multiple_of(2) { coefficient * side } else { coefficient };
        Self { coefficient: signed, exponent, powers: [[0.0; N]; WHOLE_MAX - 1] }
    }
}

impl<const N: usize> ForceTerm<N> for Whole<N> {
    #[inline]
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64 {
        self.powers[0][j] = product(z, z, j);
        for k in 1..self.exponent - 1 {
            self.powers[k][j] = product(&self.powers[k - 1], z, j);
        }
        self.coefficient * self.powers[self.exponent - 2][j]
    }
}

/// Any other exponent; the argument must not be zero at the start.
pub(super) struct General<const N: usize> {
    law: PowerLaw,
    series: [f64; N],
}

impl<const N: usize> General<N> {
    pub(super) fn new(law: PowerLaw) -> Self {
        Self { law, series: [0.0; N] }
    }
}

impl<const N: usize> ForceTerm<N> for General<N> {
    #[inline]
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64 {
        self.series[j] = if j == 0 {
            z[0].abs().powf(self.law.exponent) * sign(z[0])
        } else {
            power(z, &self.series, self.law.exponent, j)
        };
        self.law.coefficient * self.series[j]
    }
}

/// Any analytic law, by its own Taylor series about where the argument starts.
pub(super) struct Along<'a, const N: usize> {
    piece: &'a Piece,
    degree: usize,
    jet: [f64; N],
    powers: Powers<N>,
}

impl<'a, const N: usize> Along<'a, N> {
    pub(super) fn new(piece: &'a Piece) -> Self {
        Self { piece, degree: piece.degree(), jet: [0.0; N], powers: Powers::new() }
    }
}

impl<const N: usize> ForceTerm<N> for Along<'_, N> {
    #[inline]
    fn coefficient(&mut self, z: &[f64; N], j: usize) -> f64 {
        if j == 0 {
            self.jet = self.piece.jet(z[0]);
            return self.jet[0];
        }
        self.jet[1] * z[j] + self.powers.beyond_linear(z, &self.jet, self.degree, j)
    }
}
