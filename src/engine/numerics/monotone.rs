//! Cubic interpolation that keeps the shape of the data: no overshoot where the data rise, fall or are level.
//!
//! F. N. Fritsch and J. Butland, *SIAM J. Sci. Stat. Comput.* 5 (1984) 300, as in PCHIP.

/// Slopes at the points of a table with rising x; at least two points.
pub(crate) fn slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let widths: Vec<f64> = points.windows(2).map(|pair| pair[1][0] - pair[0][0]).collect();
    let secants: Vec<f64> = points
        .windows(2)
        .map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]))
        .collect();
    let last = secants.len() - 1;
    let mut slopes = Vec::with_capacity(points.len());
    for at in 0..points.len() {
        slopes.push(if secants.len() == 1 {
            secants[0]
        } else if at == 0 {
            end([widths[0], widths[1]], [secants[0], secants[1]])
        } else if at > last {
            end([widths[last], widths[last - 1]], [secants[last], secants[last - 1]])
        } else {
            inner([widths[at - 1], widths[at]], [secants[at - 1], secants[at]])
        });
    }
    slopes
}

/// The weighted harmonic mean of the secants on both sides; level where they disagree in sign.
fn inner(h: [f64; 2], d: [f64; 2]) -> f64 {
    if d[0] * d[1] <= 0.0 {
        return 0.0;
    }
    let (a, b) = (2.0 * h[1] + h[0], h[1] + 2.0 * h[0]);
    (a + b) / (a / d[0] + b / d[1])
}

/// The one-sided three-point formula, kept from overshooting.
fn end(h: [f64; 2], d: [f64; 2]) -> f64 {
    let slope = ((2.0 * h[0] + h[1]) * d[0] - h[0] * d[1]) / (h[0] + h[1]);
    if slope * d[0] <= 0.0 {
        0.0
    } else if d[0] * d[1] <= 0.0 && slope.abs() > 3.0 * d[0].abs() {
        3.0 * d[0]
    } else {
        slope
    }
}

/// The cubic between two points with given slopes: coefficients of 1, z, z², z³ with z = x - `from[0]`.
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
