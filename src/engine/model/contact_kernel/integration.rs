//! The integration of a contact from step to step, compiled for its kinds of spring and damper: the step size of each expansion, and
//! the ends of slip and of a piece of travel.

use std::ops::ControlFlow;

use crate::model::contact::AreaLaw;
use crate::model::contact_kernel::expansion::{Area, Series, State, Clock, slope};
use crate::model::contact_kernel::law::Law;
use crate::model::contact_kernel::{Contact, ContactEnd};
use crate::numerics::crossing::{dips, rise, zero};
use crate::numerics::larger;

/// Steps after which the simulation is the faster method.
pub(super) const STEPS_MAX: usize = 6000;
/// Part of its unit below which a step is tried again with a shorter one.
const SHORT: f64 = 0.02;
/// The least part of its unit that a step is shortened to at once.
const SHORTER_MIN: f64 = 1e-3;

/// Part of the tolerance for each of the many steps of a plate that oscillates fast.
const STEEP_PART: f64 = 0.2;

/// Where a contact is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Progress {
    pub(super) t_s: f64,
    pub(super) state: State,
    pub(super) clock: Clock,
    pub(super) piece: usize,
    pub(super) max_displacement_m: f64,
    pub(super) steps: usize,
}

/// How well the steps have to be known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    /// Of depth and time, relative.
    pub(super) tolerance: f64,
    /// The plate's displacement matters against this, m; infinite where it matters only against the travel.
    pub(super) plate_m: f64,
}

impl Contact {
    /// Go on by steps to the end; `None` where the simulation must take over.
    pub(super) fn integrate(&self, progress: Progress, accuracy: Accuracy) -> Option<ContactEnd> {
        self.by_laws(progress, accuracy)
    }

    fn by_laws(
        &self,
        mut progress: Progress,
        accuracy: Accuracy,
    ) -> Option<ContactEnd> {
        let velocity_m_s = self.constants.velocity_m_s;
        let (spring, damper) = (Law::of(self.spring), Law::of(self.damper));
        while progress.steps < STEPS_MAX {
            let area = self.area_law(progress.piece)?;
            progress.steps += 1;
            let Progress { state, clock, .. } = progress;
            let series =
                self.constants.expand(spring, damper, state, clock, area);
            let plate_m = self.plate_scale_m(state[2], accuracy);
            let trusted = series.trusted(accuracy.tolerance, velocity_m_s, plate_m);
            if let ControlFlow::Break(end) = self.advance(&mut progress, trusted, &series) {
                return end;
            }
        }
        None
    }

    /// Against what the plate's displacement is measured at `plate_m`, m. On a spring that is steep at zero it oscillates about a place
    /// that is tiny at first; its oscillations fade more slowly than that grows, and no step may lose the plate.
    fn plate_scale_m(&self, plate_m: f64, accuracy: Accuracy) -> f64 {
        match self.steep_reach_m {
            Some(reach_m) => STEEP_PART * (plate_m * larger(reach_m, plate_m)).sqrt(),
            None => accuracy.plate_m,
        }
    }

    /// The area on a piece; `None` where it is not a polynomial.
    pub(super) fn area_law(&self, piece: usize) -> Option<Area> {
        match self.geometry.pieces().get(piece)?.law {
            AreaLaw::Quadratic { origin_m, a } => Some(Area { origin_m, a }),
            AreaLaw::Partial { .. } => None,
        }
    }

    /// Take a step as far as it is trusted, or to what ends it before. Breaks with the end of the contact, or with nothing where the
    /// simulation must take over.
    #[inline(always)]
    fn advance(
        &self,
        progress: &mut Progress,
        trusted: f64,
        series: &Series,
    ) -> ControlFlow<Option<ContactEnd>> {
        if trusted < SHORT {
            // The unit is far too long for what happens now.
            let part = larger(2.0 * trusted, SHORTER_MIN);
            progress.clock.unit_s *= part;
            progress.clock.grade *= part;
            return ControlFlow::Continue(());
        }
        let to_m = self.geometry.pieces()[progress.piece].to_m;
        let (mut span, mut state) = (trusted, series.state(trusted));
        let stops = state[1] <= 0.0;
        if !stops && slope(&series.slip, span) > 0.0 && dips(&series.slip, span) {
            return ControlFlow::Break(None);
        }
        if stops {
            span = zero(&series.slip, span);
            state = series.state(span);
        }
        // Travel only grows up to the arrest: the piece's end may lie before it.
        let at_end = state[0] >= to_m;
        if at_end {
            span = rise(&series.travel, to_m, span);
            state = series.state(span);
        }
        progress.t_s += progress.clock.elapsed_s(span);
        progress.state = state;
        // A step is shorter than half an oscillation, so there is one maximum at most.
        if series.speed[0] > 0.0 && state[3] < 0.0 {
            let top = series.state(zero(&series.speed, span));
            progress.max_displacement_m = larger(progress.max_displacement_m, top[2]);
        }
        progress.max_displacement_m = larger(progress.max_displacement_m, state[2]);
        if !self.passes(&state) {
            return ControlFlow::Break(None);
        }
        if stops && !at_end {
            return ControlFlow::Break(Some(self.end(true, progress)));
        }
        if at_end {
            progress.state[0] = to_m;
            progress.piece += 1;
            if progress.piece == self.geometry.pieces().len() {
                return ControlFlow::Break(Some(self.end(false, progress)));
            }
        }
        progress.clock = progress.clock.next(span, trusted);
        ControlFlow::Continue(())
    }

    /// Whether the plate is still where its laws hold: on the side of zero on which it started, and going forward. A linear law holds
    /// on both.
    fn passes(&self, state: &State) -> bool {
        let on_its_side = if self.start_m < 0.0 { state[2] < 0.0 } else { state[2] > 0.0 };
        (self.has_linear_spring || on_its_side) && (self.has_linear_damper || state[3] > 0.0)
    }

    fn end(&self, arrested: bool, progress: &Progress) -> ContactEnd {
        let state = &progress.state;
        ContactEnd {
            arrested,
            t_s: progress.t_s,
            penetration_m: self.geometry.depth_m(state[0]),
            plate_displacement_m: state[2],
            plate_velocity_m_s: state[3],
            max_displacement_m: progress.max_displacement_m,
            steps: progress.steps,
        }
    }
}
