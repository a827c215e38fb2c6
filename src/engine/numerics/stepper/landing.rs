//! The boundary that a step crosses first, landed on by new steps from the same start.
//!
//! Works on any method: the new step comes in as a function. A cubic through both ends of the step says where to look first, so that
//! no method needs a dense output of its own. Knows no method and no system.

use super::Boundary;
use crate::numerics::event::{SignChange, first_sign_change, land};
use crate::numerics::{larger, minimum};

/// Part of the distance at the start of a step within which a boundary that is only come near counts as landed on.
const NEAR: f64 = 1e-9;

/// A step of the length `h` from `y0` with rate `f0` to `y1` with rate `f1`.
pub(super) struct Ends<'a, const N: usize> {
    pub(super) h: f64,
    pub(super) y0: &'a [f64; N],
    pub(super) f0: &'a [f64; N],
    pub(super) y1: &'a [f64; N],
    pub(super) f1: &'a [f64; N],
}

impl<const N: usize> Ends<'_, N> {
    /// The cubic through both ends with their slopes, at a part `s` of the step.
    fn cubic(&self, s: f64) -> [f64; N] {
        std::array::from_fn(|i| {
            let rise = self.y1[i] - self.y0[i];
            let (a, b) = (self.h * self.f0[i] - rise, rise - self.h * self.f1[i]);
            self.y0[i] + s * (rise + (1.0 - s) * (a * (1.0 - s) + b * s))
        })
    }

    /// Where a boundary is crossed, by the cubic. It may dip below zero and come back: then `anew` gives the state where the cubic is
    /// lowest.
    fn crossing(
        &self,
        boundary: &Boundary<N>,
        anew: impl FnOnce(f64) -> [f64; N],
    ) -> Option<SignChange> {
        let at = |part: f64| boundary.at(&self.cubic(part));
        let at_end = boundary.at(self.y1);
        let falls = at_end <= 0.0;
        let may_dip = || boundary.along(self.f0) < 0.0 && boundary.along(self.f1) > 0.0;
        if !(falls || may_dip()) || !boundary.is_armed(self.y0) {
            return None;
        }
        if falls {
            return first_sign_change([(1.0, at_end)], at);
        }
        let lowest = minimum::in_bracket(0.0, 1.0, at);
        first_sign_change([(lowest, boundary.at(&anew(lowest)))], at)
    }

    /// The boundary that the cubic crosses first.
    pub(super) fn first(&self, boundaries: &[Boundary<N>]) -> Option<usize> {
        let crossed = boundaries.iter().enumerate().filter_map(|(index, boundary)| {
            Some((index, self.crossing(boundary, |s| self.cubic(s))?.part))
        });
        crossed.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
    }

    /// Lands on the boundary that is crossed first: its index, the part of the step, and the state there; `None` where none is, or
    /// where steps only come near one that the cubic crosses. `anew` gives the state at the end of a step of a part of the length.
    pub(super) fn land(
        &self,
        boundaries: &[Boundary<N>],
        mut anew: impl FnMut(f64) -> [f64; N],
    ) -> Option<(usize, f64, [f64; N])> {
        let landed = boundaries.iter().enumerate().filter_map(|(index, boundary)| {
            let sign_change = self.crossing(boundary, &mut anew)?;
            let anew = |part: f64| Some(anew(part));
            let (part, y) = boundary.land(self.y0, &sign_change, |s| self.cubic(s), anew)?;
            Some((index, part, y))
        });
        landed.min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

impl<const N: usize> Boundary<N> {
    /// Lands on this boundary: the part of the step from `start`, and the state there; `None` where steps only come near it.
    pub(crate) fn land(
        &self,
        start: &[f64; N],
        sign_change: &SignChange,
        dense: impl Fn(f64) -> [f64; N],
        mut anew: impl FnMut(f64) -> Option<[f64; N]>,
    ) -> Option<(f64, [f64; N])> {
        let near = larger(NEAR * self.at(start), self.noise(start));
        let anew = |part: f64| anew(part).map(|end| (end, end));
        // Nearer than rounding there is no coming.
        let value = |y: &[f64; N]| {
            let distance = self.at(y);
            if distance.abs() <= self.noise(y) { 0.0 } else { distance }
        };
        land(sign_change, dense, anew, value, |_| near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interpolant_reproduces_cubics() {
        let (f, slope) = (|s: f64| 1.0 - s + 2.0 * s * s * s, |s: f64| -1.0 + 6.0 * s * s);
        let h = 0.7;
        let (y0, f0, y1, f1) = ([f(0.0)], [slope(0.0)], [f(h)], [slope(h)]);
        let ends = Ends { h, y0: &y0, f0: &f0, y1: &y1, f1: &f1 };
        assert!((ends.cubic(0.3)[0] - f(0.3 * h)).abs() < 1e-15);
    }
}
