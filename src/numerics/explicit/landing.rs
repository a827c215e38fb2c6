//! Finding the boundary a step crosses first, and landing on it.
//!
//! Works on any method: the interpolant and the repeated step come in as functions. Knows no method and no system.

use super::Boundary;
use crate::numerics::larger;
use crate::numerics::root::in_bracket;

/// Halvings (or so) of a step that falls and rises again, in search of its lowest point.
const NARROWINGS: usize = 40;
/// Part of the distance at the start of a step within which a boundary that is only come near counts as landed on.
const NEAR: f64 = 1e-9;
/// Repeated steps after which the best so far has to do.
const REPEATS_MAX: usize = 30;

/// A step from `y0` with rate `f0` to `y1` with rate `f1`.
pub(super) struct Ends<'a, const N: usize> {
    pub(super) y0: &'a [f64; N],
    pub(super) f0: &'a [f64; N],
    pub(super) y1: &'a [f64; N],
    pub(super) f1: &'a [f64; N],
}

impl<const N: usize> Ends<'_, N> {
    /// Whether any boundary may be crossed: decided from the ends alone.
    pub(super) fn may_cross(&self, boundaries: &[Boundary<N>]) -> bool {
        boundaries.iter().any(|boundary| self.falls(boundary) || self.may_dip(boundary))
    }

    /// On its positive side, by more than the rounding of one just landed on.
    fn is_armed(&self, boundary: &Boundary<N>) -> bool {
        boundary.at(self.y0) > 2.0 * boundary.noise(self.y0)
    }

    fn falls(&self, boundary: &Boundary<N>) -> bool {
        self.is_armed(boundary) && boundary.at(self.y1) <= 0.0
    }

    fn may_dip(&self, boundary: &Boundary<N>) -> bool {
        self.is_armed(boundary) && boundary.along(self.f0) < 0.0 && boundary.along(self.f1) > 0.0
    }

    /// The boundary crossed first and the fraction of the step at which, by the interpolant `inside`.
    pub(super) fn first(
        &self,
        boundaries: &[Boundary<N>],
        inside: impl Fn(f64) -> [f64; N],
    ) -> Option<(usize, f64)> {
        let mut first: Option<(usize, f64)> = None;
        for (index, boundary) in boundaries.iter().enumerate() {
            let end = if self.falls(boundary) {
                1.0
            } else if self.may_dip(boundary) {
                let lowest = lowest(|s| boundary.at(&inside(s)));
                if boundary.at(&inside(lowest)) > 0.0 {
                    continue;
                }
                lowest
            } else {
                continue;
            };
            let s = in_bracket(0.0, end, |s| boundary.at(&inside(s)));
            if first.is_none_or(|(_, earlier)| s < earlier) {
                first = Some((index, s));
            }
        }
        first
    }
}

/// Where a function with one valley on (0, 1) is least: the better two thirds of the interval, again and again.
fn lowest(f: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (0.0, 1.0);
    for _ in 0..NARROWINGS {
        let (left, right) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
        if f(left) < f(right) {
            b = right;
        } else {
            a = left;
        }
    }
    0.5 * (a + b)
}

/// Land on a boundary near the fraction `guess` of a step: Newton's method on the step's length, each trial a step of its own.
///
/// `step` gives the state after a fraction of the step, and how fast it changes with that fraction. Gives the fraction and
/// the state; nothing where the steps only come near the boundary, which the interpolant seemed to touch.
pub(super) fn land<const N: usize>(
    boundary: &Boundary<N>,
    y0: &[f64; N],
    guess: f64,
    mut step: impl FnMut(f64) -> ([f64; N], [f64; N]),
) -> Option<(f64, [f64; N])> {
    // A repeated step may end beyond the one that crossed: the interpolant is less accurate than the step.
    let (mut low, mut high) = (0.0, 1.5);
    let mut s = guess;
    let noise = boundary.noise(y0);
    let mut best = (NEAR * boundary.at(y0).abs(), None);
    for _ in 0..REPEATS_MAX {
        let (y, change) = step(s);
        let distance = boundary.at(&y);
        if distance.abs() <= larger(best.0, noise) {
            best = (distance.abs(), Some((s, y)));
        }
        if distance.abs() <= noise {
            break;
        }
        if distance > 0.0 {
            low = s;
        } else {
            high = s;
        }
        let newton = s - distance / boundary.along(&change);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= 2.0 * f64::EPSILON * s {
            break;
        }
        s = next;
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEVEL: Boundary<1> = Boundary { offset: 0.0, slope: [1.0] };

    /// The state after a fraction s of a step that falls from 1 to a least value at s = 1/2 and rises again.
    fn dip(least: f64) -> impl Fn(f64) -> ([f64; 1], [f64; 1]) {
        move |s| {
            let from_lowest = 2.0 * s - 1.0;
            (
                [least + (1.0 - least) * from_lowest * from_lowest],
                [4.0 * (1.0 - least) * from_lowest],
            )
        }
    }

    #[test]
    fn a_step_that_crosses_is_landed_on_its_first_crossing() {
        let (s, y) = land(&LEVEL, &[1.0], 0.4, dip(-0.25)).unwrap();
        // 1.25 (2 s - 1)² = 0.25.
        assert!((s - 0.5 * (1.0 - 0.2f64.sqrt())).abs() < 1e-15, "{s}");
        assert!(y[0].abs() < 1e-15);
    }

    #[test]
    fn a_step_that_only_comes_near_is_not_landed_far_from_the_boundary() {
        assert_eq!(land(&LEVEL, &[1.0], 0.5, dip(1e-3)), None);
        let (s, y) = land(&LEVEL, &[1.0], 0.5, dip(1e-13)).unwrap();
        assert!((s - 0.5).abs() < 1e-3 && y[0] < 1e-9, "{s} {y:?}");
    }
}
