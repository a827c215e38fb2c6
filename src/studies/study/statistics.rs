//! Statistics of samples: moments, quantiles, confidence intervals of a proportion, and the least-squares slope.

use std::f64::consts::FRAC_PI_2;

use cmra_engine::numerics::root::bracketed_root;

/// Standard normal quantile for a two-sided 95 % interval.
pub const Z95: f64 = 1.959_963_984_540_054;

/// Returns mean and sample standard deviation; `None` for fewer than two values.
pub fn moments(values: &[f64]) -> Option<(f64, f64)> {
    let count = values.len();
    if count < 2 {
        return None;
    }
    let n = count as f64;
    // Shifted by a value: a small variance beside a large mean would be lost to cancellation.
    let origin = values[count / 2];
    let (mut sum, mut squares) = (0.0, 0.0);
    for value in values {
        sum += value - origin;
        squares += (value - origin).powi(2);
    }
    let variance = (squares - sum * sum / n) / (n - 1.0);
    Some((origin + sum / n, if variance > 0.0 { variance.sqrt() } else { 0.0 }))
}

/// Sorts items by a value in ascending order. The sort is stable; NaN comes last.
pub fn sorted_by<T>(mut items: Vec<T>, value: impl Fn(&T) -> f64) -> Vec<T> {
    items.sort_by(|a, b| value(a).total_cmp(&value(b)));
    items
}

/// Returns a quantile of sorted values by linear interpolation.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in the list")]
pub fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    let last = sorted.len() - 1;
    let place = fraction * last as f64;
    let below = (place as usize).min(last);
    if place <= below as f64 {
        return sorted[below]; // its neighbour may be infinite, and none of it is NaN
    }
    let above = (below + 1).min(last);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// Returns Wilson's 95 % interval for the proportion `p` of `n` trials (*Journal of the American Statistical Association* 22 (1927)
/// 209-212).
pub fn wilson(p: f64, n: f64) -> (f64, f64) {
    let z2 = Z95 * Z95;
    let centre = (p + 0.5 * z2 / n) / (1.0 + z2 / n);
    let half = Z95 / (1.0 + z2 / n) * (p * (1.0 - p) / n + 0.25 * z2 / (n * n)).sqrt();
    // The bound is exactly 0 or 1 there; the formula gives rounding error.
    (if p > 0.0 { centre - half } else { 0.0 }, if p < 1.0 { centre + half } else { 1.0 })
}

/// Returns a quantile of Student's t distribution for an integer number of degrees of freedom >= 1 and a fraction in (0.5, 1).
///
/// The distribution function is the finite sum of Abramowitz and Stegun 26.7.3 and 26.7.4; its root is bracketed in atan(t/sqrt(nu)).
pub fn student_quantile(fraction: f64, freedom: usize) -> f64 {
    let within = 2.0 * fraction - 1.0;
    let excess = |angle: f64| student_within(angle, freedom) - within;
    bracketed_root(0.0, FRAC_PI_2, excess).tan() * (freedom as f64).sqrt()
}

/// Returns the probability that |t| < tan(angle) sqrt(nu).
fn student_within(angle: f64, freedom: usize) -> f64 {
    let is_odd = freedom % 2 == 1;
    let (sine, cosine) = angle.sin_cos();
    let (mut term, mut sum) = if is_odd { (cosine, cosine) } else { (1.0, 1.0) };
    if freedom == 1 {
        sum = 0.0;
    }
    for power in (if is_odd { 3 } else { 2 }..=freedom.saturating_sub(2)).step_by(2) {
        let power = power as f64;
        term *= (power - 1.0) / power * cosine * cosine;
        sum += term;
    }
    if is_odd { (angle + sine * sum) / FRAC_PI_2 } else { sine * sum }
}

/// Returns the slope of the least-squares line through points (x, y); not finite if all x are equal.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let covariance: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    covariance / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_interval_of_wilson() {
        // E. B. Wilson's formula for 10 of 100, as tabulated by R. G. Newcombe, *Statistics in Medicine* 17 (1998), by hand.
        let (low, high) = wilson(0.1, 100.0);
        assert!((low - 0.0552).abs() < 1e-4 && (high - 0.1744).abs() < 1e-4, "{low} {high}");
        assert_eq!((wilson(0.0, 1000.0).0, wilson(1.0, 7.0).1), (0.0, 1.0));
    }

    /// Independent: `scipy.stats.t.ppf(0.95, freedom)`.
    #[test]
    fn valid_quantiles_of_student() {
        for (freedom, expected) in [
            (1, 6.313_751_514_675_037),
            (2, 2.919_985_580_353_724_2),
            (3, 2.353_363_434_801_823_3),
            (4, 2.131_846_786_326_649_5),
            (27, 1.703_288_445_722_126_5),
            (83, 1.663_420_174_918_884_8),
            (368, 1.649_004_810_816_203_2),
        ] {
            let found = student_quantile(0.95, freedom);
            assert!((found / expected - 1.0).abs() < 1e-10, "{freedom}: {found} {expected}");
        }
    }

    #[test]
    fn equal_values_stay_in_their_order_and_nan_stands_last() {
        let items = vec![("a", 2.0), ("b", f64::NAN), ("c", -1.0), ("d", 2.0)];
        let names: Vec<&str> = sorted_by(items, |item| item.1).iter().map(|item| item.0).collect();
        assert_eq!(names, ["c", "a", "d", "b"]);
    }

    #[test]
    fn quantiles_lie_between_the_values() {
        let sorted = [1.0, 2.0, 4.0];
        for (fraction, value) in [(0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.75, 3.0), (1.0, 4.0)] {
            assert!((quantile(&sorted, fraction) - value).abs() < 1e-15);
        }
        // A whole rank is the value itself, whatever lies above it.
        let open = [10.0, 20.0, f64::INFINITY];
        assert_eq!((quantile(&open, 0.5), quantile(&open, 0.75)), (20.0, f64::INFINITY));
        assert_eq!((quantile(&open, 0.0), quantile(&open, 1.0)), (10.0, f64::INFINITY));
    }

    #[test]
    fn moments_of_a_few_values_beside_a_great_mean() {
        // 1, 2, 3, 4 have the mean 2.5 and the variance 5/3.
        let (mean, deviation) = moments(&[1.0, 2.0, 3.0, 4.0].map(|it| it + 1e9)).unwrap();
        assert!((mean - 2.5 - 1e9).abs() < 1e-6);
        assert!((deviation - (5.0_f64 / 3.0).sqrt()).abs() < 1e-9);
        assert_eq!(moments(&[1.0]), None);
    }
}
