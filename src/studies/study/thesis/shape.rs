//! Properties of curves that the thesis's sentences assert: rising, falling, levelling off, nearly linear.

pub(super) use crate::numerics::statistics::slope;
use crate::numerics::{larger, smaller};
use crate::study::thesis::value::Point;

/// The noise level, relative to the curve's whole range.
const NOISE: f64 = 1e-3;

pub(super) fn greatest(curve: &[Point]) -> f64 {
    curve.iter().map(|point| point.1).fold(f64::NEG_INFINITY, larger)
}

pub(super) fn least(curve: &[Point]) -> f64 {
    curve.iter().map(|point| point.1).fold(f64::INFINITY, smaller)
}

pub(super) fn range(curve: &[Point]) -> f64 {
    greatest(curve) - least(curve)
}

/// Rises all along, but for noise.
pub(super) fn rises(curve: &[Point]) -> bool {
    let noise = NOISE * range(curve);
    curve.windows(2).all(|pair| pair[1].1 >= pair[0].1 - noise)
        && curve.last().zip(curve.first()).is_some_and(|(last, first)| last.1 > first.1)
}

/// Falls all along, but for noise.
pub(super) fn falls(curve: &[Point]) -> bool {
    rises(&curve.iter().map(|point| (point.0, -point.1)).collect::<Vec<_>>())
}

/// Every slope is no steeper than the one before, but for noise.
pub(super) fn flattens(curve: &[Point]) -> bool {
    let slopes: Vec<f64> = curve
        .windows(2)
        .map(|pair| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs())
        .collect();
    let noise = 2.0 * NOISE * slopes.iter().copied().fold(0.0, larger);
    slopes.windows(2).all(|pair| pair[1] <= pair[0] + noise)
}

/// The value at `x`, on the straight line between the points around it.
pub(super) fn at(curve: &[Point], x: f64) -> f64 {
    if curve.len() < 2 {
        return f64::NAN;
    }
    let after = curve.partition_point(|point| point.0 < x).clamp(1, curve.len() - 1);
    let ((x0, y0), (x1, y1)) = (curve[after - 1], curve[after]);
    y0 + (y1 - y0) * (x - x0) / (x1 - x0)
}

/// How far a curve is from the straight line through its ends, relative to its range.
pub(super) fn curvature(curve: &[Point]) -> f64 {
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else { return f64::NAN };
    let slope = (last.1 - first.1) / (last.0 - first.0);
    let off = |point: &Point| (point.1 - first.1 - slope * (point.0 - first.0)).abs();
    curve.iter().map(off).fold(0.0, larger) / range(curve)
}

/// Where a falling curve crosses the middle between its ends.
pub(super) fn edge(curve: &[Point]) -> Option<f64> {
    let middle = 0.5 * (curve.first()?.1 + curve.last()?.1);
    let pair = curve.windows(2).find(|pair| pair[0].1 > middle && pair[1].1 <= middle)?;
    let part = (pair[0].1 - middle) / (pair[0].1 - pair[1].1);
    Some(pair[0].0 + part * (pair[1].0 - pair[0].0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(f: impl Fn(f64) -> f64) -> Vec<Point> {
        (0..=20).map(|i| (f64::from(i) / 10.0, f(f64::from(i) / 10.0))).collect()
    }

    #[test]
    fn shapes_are_distinguished() {
        let root = curve(f64::sqrt);
        assert!(rises(&root) && flattens(&root) && !falls(&root));
        let square = curve(|x| x * x);
        assert!(rises(&square) && !flattens(&square));
        assert!(falls(&curve(|x| -x)) && curvature(&curve(|x| -x)) < 1e-12);
        assert!((curvature(&square) - 0.25).abs() < 1e-12);
        assert!((slope(&curve(|x| 3.0 * x - 1.0)) - 3.0).abs() < 1e-12);
        assert!((at(&square, 1.05) - 1.105).abs() < 1e-12);
        let step = curve(|x| if x < 0.75 { 10.0 } else { 2.0 });
        assert!((edge(&step).unwrap() - 0.75).abs() < 0.06);
        assert!((range(&step) - 8.0).abs() < 1e-12);
        assert!(!rises(&curve(|x| (3.0 * x).sin())) && !falls(&curve(|x| (3.0 * x).sin())));
    }
}
