//! Monotone piecewise cubic interpolation: the interpolant is monotone where the data are.
//!
//! F. N. Fritsch and J. Butland, *SIAM J. Sci. Stat. Comput.* 5 (1984) 300, as in PCHIP.

/// Returns the slopes at the points of a table with increasing x and at least two points.
pub(crate) fn slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let stretch = |pair: &[[f64; 2]]| {
        let width = pair[1][0] - pair[0][0];
        [width, (pair[1][1] - pair[0][1]) / width]
    };
    let stretches: Vec<[f64; 2]> = points.windows(2).map(stretch).collect();
    let last = stretches.len() - 1;
    if last == 0 {
        return vec![stretches[0][1]; 2];
    }
    let mut slopes = vec![end(stretches[0], stretches[1])];
    slopes.extend(stretches.windows(2).map(|pair| inner(pair[0], pair[1])));
    slopes.push(end(stretches[last], stretches[last - 1]));
    slopes
}

/// Returns the weighted harmonic mean of the secants of two adjacent intervals; 0 if their signs differ. Each interval has its width and
/// its secant.
fn inner([width, secant]: [f64; 2], [width_after, secant_after]: [f64; 2]) -> f64 {
    if secant * secant_after <= 0.0 {
        return 0.0;
    }
    let (a, b) = (2.0 * width_after + width, width_after + 2.0 * width);
    (a + b) / (a / secant + b / secant_after)
}

/// Returns the slope at an end by the one-sided three-point formula, limited so that the interpolant stays monotone.
fn end([width, secant]: [f64; 2], [width_next, secant_next]: [f64; 2]) -> f64 {
    let slope = secant + width * (secant - secant_next) / (width + width_next);
    if slope * secant <= 0.0 {
        0.0
    } else if secant * secant_next <= 0.0 && slope.abs() > 3.0 * secant.abs() {
        3.0 * secant
    } else {
        slope
    }
}

/// Returns the cubic Hermite interpolant of two points with slopes: coefficients of 1, z, z², z³ with z = x - `from[0]`.
pub(crate) fn cubic(from: [f64; 2], to: [f64; 2], slopes: [f64; 2]) -> [f64; 4] {
    let h = to[0] - from[0];
    let secant = (to[1] - from[1]) / h;
    [
        from[1],
        slopes[0],
        (3.0 * secant - 2.0 * slopes[0] - slopes[1]) / h,
        (slopes[0] + slopes[1] - 2.0 * secant) / (h * h),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_overshoot_between_points() {
        // Fritsch and Carlson's RPN 14 data: level, a steep rise, level again.
        let points = [
            [7.99, 0.0],
            [8.09, 2.764_29e-5],
            [8.19, 4.374_98e-2],
            [8.7, 0.169_183],
            [9.2, 0.469_428],
            [10.0, 0.943_74],
            [12.0, 0.998_636],
            [15.0, 0.999_919],
            [20.0, 0.999_994],
        ];
        let slopes = slopes(&points);
        for at in 0..points.len() - 1 {
            let c = cubic(points[at], points[at + 1], [slopes[at], slopes[at + 1]]);
            let mut before = points[at][1];
            for i in 1..=50 {
                let z = (points[at + 1][0] - points[at][0]) * f64::from(i) / 50.0;
                let value = c[0] + z * (c[1] + z * (c[2] + z * c[3]));
                assert!(value >= before - 1e-12 && value <= points[at + 1][1] + 1e-12);
                before = value;
            }
        }
    }
}
