//! Small dense linear systems.

/// Solve `matrix · x = right` in place by Gaussian elimination with scaled partial pivoting; the solution replaces `right`.
///
/// Returns `false`, with both arguments spoilt, when the matrix is singular to working precision or not finite.
pub fn solve<const N: usize>(matrix: &mut [[f64; N]; N], right: &mut [f64; N]) -> bool {
    for row in 0..N {
        let scale = matrix[row].iter().fold(0.0f64, |a, b| if b.abs() > a { b.abs() } else { a });
        if scale == 0.0 || !scale.is_finite() {
            return false;
        }
        for value in &mut matrix[row] {
            *value /= scale;
        }
        right[row] /= scale;
    }
    for column in 0..N {
        let mut pivot = column;
        for row in column + 1..N {
            if matrix[row][column].abs() > matrix[pivot][column].abs() {
                pivot = row;
            }
        }
        if matrix[pivot][column] == 0.0 || matrix[pivot][column].is_nan() {
            return false;
        }
        matrix.swap(pivot, column);
        right.swap(pivot, column);
        for row in column + 1..N {
            let factor = matrix[row][column] / matrix[column][column];
            if factor != 0.0 {
                let pivot_row = matrix[column];
                for (value, above) in matrix[row].iter_mut().zip(pivot_row).skip(column) {
                    *value -= factor * above;
                }
                right[row] -= factor * right[column];
            }
        }
    }
    for row in (0..N).rev() {
        let mut sum = right[row];
        for k in row + 1..N {
            sum -= matrix[row][k] * right[k];
        }
        right[row] = sum / matrix[row][row];
    }
    right.iter().all(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::solve;

    #[test]
    fn solves_a_badly_scaled_system_that_needs_pivoting() {
        // x = (1, 2, 3), rows scaled by 1e-30, 1, 1e30.
        let mut matrix = [[0.0, 1e-30, 2e-30], [1.0, 1.0, 1.0], [2e30, -1e30, 1e30]];
        let mut right = [8e-30, 6.0, 3e30];
        assert!(solve(&mut matrix, &mut right));
        for (x, exact) in right.iter().zip([1.0, 2.0, 3.0]) {
            assert!((x - exact).abs() < 1e-14);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        assert!(!solve(&mut [[1.0, 2.0], [2.0, 4.0]], &mut [1.0, 2.0]));
        assert!(!solve(&mut [[f64::NAN, 2.0], [2.0, 4.0]], &mut [1.0, 2.0]));
    }
}
