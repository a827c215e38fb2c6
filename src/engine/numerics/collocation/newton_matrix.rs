//! Matrix of Newton's method for the stage equations.

use std::array;

use super::Stages;
use crate::numerics::step::{Jacobian, Square};

/// Matrix of `D` by `D` blocks of size `S`, factored by Gauss-Jordan elimination with partial pivoting, for several right-hand sides.
pub(super) struct NewtonMatrix<const D: usize, const S: usize> {
    /// Columns of the factors; the diagonal has the reciprocals.
    columns: [[Stages<D, S>; S]; D],
    /// Row exchanged with each diagonal row.
    pivots: [[usize; S]; D],
}

impl<const D: usize, const S: usize> NewtonMatrix<D, S> {
    /// Creates a matrix without factors.
    pub(super) fn zero() -> Self {
        Self { columns: [[[[0.0; S]; D]; S]; D], pivots: [[0; S]; D] }
    }

    /// Factors the matrix 1 - h J' A - h² J A² of Newton's method, with the derivatives J' by velocity and J by position at the stages.
    pub(super) fn set(
        &mut self,
        a: &Square<S>,
        square: &Square<S>,
        slopes: &[Jacobian<D>; S],
        h: f64,
    ) {
        for (e, columns) in self.columns.iter_mut().enumerate() {
            for d in 0..D {
                let by_speed: [f64; S] = array::from_fn(|i| h * slopes[i].speed[d][e]);
                let by_place: [f64; S] = array::from_fn(|i| h * h * slopes[i].place[d][e]);
                for (column, (a, square)) in columns.iter_mut().zip(a.iter().zip(square)) {
                    column[d] = array::from_fn(|i| -a[i] * by_speed[i] - square[i] * by_place[i]);
                }
            }
            for (j, column) in columns.iter_mut().enumerate() {
                column[e][j] += 1.0;
            }
        }
        let (columns, pivots) = (self.columns.as_flattened_mut(), self.pivots.as_flattened_mut());
        for (at, pivot) in pivots.iter_mut().enumerate() {
            let (done, rest) = columns.split_at_mut(at + 1);
            let column = done[at].as_flattened_mut();
            *pivot = at;
            for row in at + 1..column.len() {
                if column[row].abs() > column[*pivot].abs() {
                    *pivot = row;
                }
            }
            column.swap(at, *pivot);
            column[at] = 1.0 / column[at];
            for other in rest {
                eliminate(&done[at], (at, *pivot), other);
            }
        }
    }

    /// Replaces the right-hand side by the solution; returns `false` if that is not finite.
    pub(super) fn solve(&self, right: &mut Stages<D, S>) -> bool {
        let (columns, pivots) = (self.columns.as_flattened(), self.pivots.as_flattened());
        for (at, (column, pivot)) in columns.iter().zip(pivots).enumerate() {
            eliminate(column, (at, *pivot), right);
        }
        right.as_flattened().iter().all(|value| value.is_finite())
    }
}

/// Eliminates the unknown of a column from all other rows, after the exchange with the pivot row.
fn eliminate<const D: usize, const S: usize>(
    column: &Stages<D, S>,
    (at, pivot): (usize, usize),
    values: &mut Stages<D, S>,
) {
    let (column, values) = (column.as_flattened(), values.as_flattened_mut());
    values.swap(at, pivot);
    let unknown = values[at] * column[at];
    for (value, factor) in values.iter_mut().zip(column) {
        *value -= factor * unknown;
    }
    values[at] = unknown;
}
