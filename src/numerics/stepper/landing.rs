//! The boundary that a step crosses first, located on its dense output and landed on by new steps.
//!
//! Works on any method: dense output and the new step come in as functions. Knows no method and no system.

use super::Boundary;
use crate::numerics::event::{SignChange, first_sign_change, land};
use crate::numerics::{larger, minimum};

/// Part of the distance at the start of a step within which a boundary that is only come near counts as landed on.
const NEAR: f64 = 1e-9;

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

    /// From its positive side to the other.
    fn falls(&self, boundary: &Boundary<N>) -> bool {
        boundary.is_armed(self.y0) && boundary.at(self.y1) <= 0.0
    }

    fn may_dip(&self, boundary: &Boundary<N>) -> bool {
        boundary.is_armed(self.y0) && boundary.along(self.f0) < 0.0 && boundary.along(self.f1) > 0.0
    }

    /// The boundary that is crossed first, and where, by the dense output.
    pub(super) fn first(
        &self,
        boundaries: &[Boundary<N>],
        dense: &impl Fn(f64) -> [f64; N],
    ) -> Option<(usize, SignChange)> {
        let crossed = boundaries.iter().enumerate().filter_map(|(index, boundary)| {
            let at = |part: f64| boundary.at(&dense(part));
            let sample = if self.falls(boundary) {
                (1.0, boundary.at(self.y1))
            } else if self.may_dip(boundary) {
                let lowest = minimum::in_bracket(0.0, 1.0, at);
                (lowest, at(lowest))
            } else {
                return None;
            };
            Some((index, first_sign_change([sample], at)?))
        });
        crossed.min_by(|a, b| a.1.part.total_cmp(&b.1.part))
    }

    /// Lands on the boundary that is crossed first: its index, the part of the step, and the state there; `None` where none is, or
    /// where steps only come near the one that the dense output seems to cross. `anew` gives the state at the end of a step of a
    /// part of the length.
    pub(super) fn land(
        &self,
        boundaries: &[Boundary<N>],
        dense: impl Fn(f64) -> [f64; N],
        mut anew: impl FnMut(f64) -> [f64; N],
    ) -> Option<(usize, f64, [f64; N])> {
        let (index, sign_change) = self.first(boundaries, &dense)?;
        let boundary = &boundaries[index];
        let near = larger(NEAR * boundary.at(self.y0), boundary.noise(self.y0));
        let anew = |part: f64| {
            let end = anew(part);
            Some((end, end))
        };
        let (part, y) = land(&sign_change, dense, anew, |y| boundary.at(y), |_| near)?;
        Some((index, part, y))
    }
}
