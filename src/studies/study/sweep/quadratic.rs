//! A response surface: the quadratic that fits a grid of two axes best, and how well it does.
//!
//! z = a + b u + c v + d u² + e u v + f v² by least squares over the points that have a value, with u and v the axes scaled
//! to -1 to 1 (by their spacing). G. E. P. Box and K. B. Wilson, *Journal of the Royal Statistical Society B* 13 (1951) 1-45.

use crate::numerics::linear::solve;

/// Coefficients of a quadratic in two variables.
const TERMS: usize = 6;

/// A fitted quadratic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    /// a to f of the formula.
    pub coefficients: [f64; TERMS],
    /// Part of the variance it explains, 1: all.
    pub r_squared: f64,
    /// Points it goes by.
    pub points: usize,
}

/// The six terms at a place, both coordinates -1 to 1.
fn terms(u: f64, v: f64) -> [f64; TERMS] {
    [1.0, u, v, u * u, u * v, v * v]
}

impl Quadratic {
    /// The best fit to points (u, v, value); values that are not finite are omitted. `None` for fewer than seven points, or
    /// where they do not tell the terms apart.
    pub fn through(points: impl Iterator<Item = (f64, f64, f64)>) -> Option<Self> {
        let points: Vec<_> = points.filter(|point| point.2.is_finite()).collect();
        if points.len() <= TERMS {
            return None;
        }
        let mean = points.iter().map(|point| point.2).sum::<f64>() / points.len() as f64;
        let mut matrix = [[0.0; TERMS]; TERMS];
        let mut right = [0.0; TERMS];
        for (u, v, value) in &points {
            let row = terms(*u, *v);
            for (a, line) in row.iter().zip(&mut matrix) {
                for (b, cell) in row.iter().zip(line) {
                    *cell += a * b;
                }
            }
            for (a, side) in row.iter().zip(&mut right) {
                // About the mean, so that a small variance does not drown in it.
                *side += a * (value - mean);
            }
        }
        if !solve(&mut matrix, &mut right) || right.iter().any(|value| !value.is_finite()) {
            return None;
        }
        right[0] += mean;
        let mut fit = Self { coefficients: right, r_squared: 1.0, points: points.len() };
        let total: f64 = points.iter().map(|point| (point.2 - mean).powi(2)).sum();
        let left: f64 =
            points.iter().map(|(u, v, value)| (value - fit.value(*u, *v)).powi(2)).sum();
        if total > 0.0 {
            fit.r_squared = 1.0 - left / total;
        }
        Some(fit)
    }

    /// Its value at a place.
    pub fn value(&self, u: f64, v: f64) -> f64 {
        terms(u, v).iter().zip(self.coefficients).map(|(term, factor)| term * factor).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(f: impl Fn(f64, f64) -> f64) -> Vec<(f64, f64, f64)> {
        let share = |i: u8| f64::from(i) / 10.0 - 1.0;
        let places = (0..=20).flat_map(|i| (0..=20).map(move |j| (share(i), share(j))));
        places.map(|(u, v)| (u, v, f(u, v))).collect()
    }

    #[test]
    fn a_quadratic_is_found_exactly_even_with_holes() {
        let exact = [5e3, -2.0, 0.5, 3.0, -1.5, 0.25];
        let f = |u: f64, v: f64| terms(u, v).iter().zip(exact).map(|(t, c)| t * c).sum::<f64>();
        let mut points = grid(f);
        points[7].2 = f64::NAN;
        let fit = Quadratic::through(points.into_iter()).unwrap();
        for (found, exact) in fit.coefficients.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-9, "{found} {exact}");
        }
        assert!((fit.r_squared - 1.0).abs() < 1e-12 && fit.points == 440);
    }

    /// u³ over the square: its best line is 3u/5, which explains 21/25 of its variance (continuous limit).
    #[test]
    fn what_it_cannot_follow_is_told_by_r_squared() {
        let fit = Quadratic::through(grid(|u, _| u.powi(3)).into_iter()).unwrap();
        assert!((fit.coefficients[1] - 0.6).abs() < 0.07, "{fit:?}");
        assert!((fit.r_squared - 0.84).abs() < 0.03, "{fit:?}");
        let flat = Quadratic::through(grid(|_, _| 7.0).into_iter()).unwrap();
        assert!((flat.value(0.3, -0.4) - 7.0).abs() < 1e-12);
    }

    #[test]
    fn too_few_points_and_points_on_a_line_have_none() {
        assert!(Quadratic::through(grid(|u, v| u + v).into_iter().take(6)).is_none());
        let line = grid(|u, _| u).into_iter().filter(|point| point.1 < -0.95);
        assert!(
            Quadratic::through(line)
                .is_none_or(|fit| fit.coefficients.iter().all(|c| c.is_finite()))
        );
    }
}
