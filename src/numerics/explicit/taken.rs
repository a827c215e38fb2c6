//! A step of an explicit method, to look for boundaries on. Knows no method.

use std::cell::RefCell;

use super::{Boundary, Count, System};
use crate::numerics::arc::Arc;
use crate::numerics::event::{self, Fall};
use crate::numerics::{larger, minimum};

/// Part of the distance at the start of a step within which a boundary that is only come near counts as landed on.
const NEAR: f64 = 1e-9;

/// A step from `y0` with rate `f0` to `y1` with rate `f1`.
#[derive(Clone, Copy)]
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

    fn falls(&self, boundary: &Boundary<N>) -> bool {
        boundary.is_armed(self.y0) && boundary.at(self.y1) <= 0.0
    }

    fn may_dip(&self, boundary: &Boundary<N>) -> bool {
        boundary.is_armed(self.y0) && boundary.along(self.f0) < 0.0 && boundary.along(self.f1) > 0.0
    }
}

/// A step that was taken: its ends, its dense output, and how a part of it is stepped anew.
pub(super) struct Taken<'a, const N: usize, Y, D, S> {
    pub(super) system: RefCell<&'a mut Y>,
    pub(super) count: RefCell<&'a mut Count>,
    pub(super) ends: Ends<'a, N>,
    pub(super) dense: D,
    pub(super) step: S,
}

impl<const N: usize, Y, D, S> Arc for Taken<'_, N, Y, D, S>
where
    D: Fn(f64) -> [f64; N],
    S: Fn(&mut Y, &mut Count, f64) -> [f64; N],
{
    type State = [f64; N];
    type Step = [f64; N];

    fn dense(&self, part: f64) -> [f64; N] {
        (self.dense)(part)
    }

    fn anew(&self, part: f64) -> Option<[f64; N]> {
        Some((self.step)(&mut self.system.borrow_mut(), &mut self.count.borrow_mut(), part))
    }

    fn end(&self, _: f64, step: &[f64; N]) -> [f64; N] {
        *step
    }
}

impl<const N: usize, Y: System<N>, D, S> Taken<'_, N, Y, D, S>
where
    D: Fn(f64) -> [f64; N],
    S: Fn(&mut Y, &mut Count, f64) -> [f64; N],
{
    /// The boundary crossed first, and where.
    pub(super) fn first(&self) -> Option<(usize, Fall)> {
        let system = self.system.borrow();
        let falls = system.boundaries().iter().enumerate().filter_map(|(index, boundary)| {
            let height = |part: f64| boundary.at(&self.dense(part));
            // The dense output is that of the step at its end up to rounding only.
            let sample = if self.ends.falls(boundary) {
                (1.0, boundary.at(self.ends.y1))
            } else if self.ends.may_dip(boundary) {
                let lowest = minimum::in_bracket(0.0, 1.0, height);
                (lowest, height(lowest))
            } else {
                return None;
            };
            Some((index, event::fall([sample], height)?))
        });
        falls.min_by(|a, b| a.1.part.total_cmp(&b.1.part))
    }

    /// The part of the step and the state on the boundary; `None` where the steps only come near it, which the dense output seemed to
    /// touch.
    pub(super) fn land(&self, index: usize, fall: &Fall) -> Option<(f64, [f64; N])> {
        let boundary = self.system.borrow().boundaries()[index];
        let y0 = self.ends.y0;
        let near = if self.ends.falls(&boundary) {
            f64::INFINITY
        } else {
            larger(NEAR * boundary.at(y0).abs(), boundary.noise(y0))
        };
        event::land(self, fall, |y| boundary.at(y), |_| near)
    }
}
