//! The integration of a contact from step to step: the step size of each expansion, and the ends of slip, of a piece of travel
//! and of a kind of expansion.

use std::ops::ControlFlow;

use crate::model::contact::AreaLaw;
use crate::model::contact_kernel::expansion::{Area, Series, StepTime, trusted};
use crate::model::contact_kernel::slow_manifold::ManifoldRun;
use crate::model::contact_kernel::slow_manifold_series::tolerance_factor;
use crate::model::contact_kernel::{Contact, ContactEnd};
use crate::numerics::crossing::{dips, rise, zero};
use crate::numerics::larger;
use crate::numerics::series::evaluate;

/// Steps after which the simulation is the better method.
pub(super) const STEPS_MAX: usize = 1500;
/// Part of its unit below which a step is tried again with a shorter one.
const SHORT: f64 = 0.02;

/// Where a contact is.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntegrationState {
    pub(super) t_s: f64,
    /// (travel, slip, plate, speed).
    pub(super) state: [f64; 4],
    pub(super) clock: StepTime,
    pub(super) piece: usize,
    pub(super) max_displacement_m: f64,
    pub(super) steps: usize,
}

/// The rest of a contact that plain steps can compute.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    pub(super) progress: IntegrationState,
    pub(super) tolerance: f64,
    /// The plate's displacement matters against this, m, or only against the travel.
    pub(super) reach_m: Option<f64>,
    pub(super) terms: usize,
}

/// How far a contact comes before plain steps.
pub(super) enum InitialPhase {
    Ended(ContactEnd),
    Steps(Plan),
    /// The plate follows the slow manifold of its spring first.
    OnManifold(ManifoldRun),
    /// To where the simulation must take over.
    Left,
}

impl InitialPhase {
    /// Without plain steps: to the end of the contact, or to where the simulation must take over.
    pub(super) fn without_steps(end: Option<ContactEnd>) -> Self {
        end.map_or(Self::Left, Self::Ended)
    }
}

/// Which laws are one analytic function on both sides of zero.
#[derive(Clone, Copy)]
pub(super) struct Sides {
    pub(super) spring: bool,
    pub(super) damper: bool,
}

/// A step as far as it is trusted.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepEnd {
    /// Up to this part of its unit.
    pub(super) trusted: f64,
    /// (travel, slip, plate, speed) there.
    pub(super) state: [f64; 4],
    /// The slip rises there.
    pub(super) rises: bool,
    /// The plate's velocity where it begins, m/s.
    pub(super) speed_m_s: f64,
}

impl StepEnd {
    #[inline(always)]
    pub(super) fn of<const N: usize>(series: &Series<N>, trusted: f64) -> Self {
        Self {
            trusted,
            state: series.state(trusted),
            rises: series.slip_slope(trusted) > 0.0,
            speed_m_s: series.speed[0],
        }
    }
}

/// The scale of the plate's displacement at `plate_m`, m.
pub(super) fn plate_scale_m(plate_m: f64, reach_m: Option<f64>) -> f64 {
    match reach_m {
        Some(reach_m) => plate_m.abs() * tolerance_factor(plate_m.abs(), reach_m),
        None => f64::INFINITY,
    }
}

impl Contact {
    pub(super) fn begin(&self, t_s: f64, state: [f64; 4], clock: StepTime) -> IntegrationState {
        IntegrationState { t_s, state, clock, piece: 0, max_displacement_m: self.start_m, steps: 0 }
    }

    /// Go on by steps to the end; `None` where the simulation must take over.
    #[inline(always)]
    pub(super) fn go_on<const N: usize>(
        &self,
        expand: impl Fn(&IntegrationState, Area) -> Series<N>,
        sides: Sides,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        let Plan { mut progress, tolerance, reach_m, .. } = *plan;
        while progress.steps < STEPS_MAX {
            let area = self.area_law(progress.piece)?;
            progress.steps += 1;
            let series = expand(&progress, area);
            let plate_scale_m = plate_scale_m(progress.state[2], reach_m);
            let last_terms = self.constants.last_terms(&series, plate_scale_m);
            let end_of_step = StepEnd::of(&series, trusted::<N>(last_terms, tolerance));
            let stepped = self.advance(&mut progress, sides, &end_of_step, &series);
            if let ControlFlow::Break(end) = stepped {
                return end;
            }
        }
        None
    }

    /// The area on a piece; `None` where it is not a polynomial.
    pub(super) fn area_law(&self, piece: usize) -> Option<Area> {
        match self.geometry.pieces().get(piece)?.law {
            AreaLaw::Quadratic { origin_m, a } => Some(Area { origin_m, a }),
            _ => None,
        }
    }

    /// Take a step as far as it is trusted, or to what ends it before. Breaks with the end of the contact, or with nothing where the
    /// simulation must take over.
    pub(super) fn advance<const N: usize>(
        &self,
        progress: &mut IntegrationState,
        sides: Sides,
        end_of_step: &StepEnd,
        series: &Series<N>,
    ) -> ControlFlow<Option<ContactEnd>> {
        if end_of_step.trusted < SHORT {
            // The unit is far too long for what happens now.
            progress.clock = progress.clock.shorter(larger(2.0 * end_of_step.trusted, 1e-3));
            return ControlFlow::Continue(());
        }
        let to_m = self.geometry.pieces()[progress.piece].to_m;
        let (mut span, mut state) = (end_of_step.trusted, end_of_step.state);
        let stops = state[1] <= 0.0;
        if !stops && end_of_step.rises && dips(&series.slip, span) {
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
        // A step is shorter than half a swing, so there is one maximum at most.
        let turns = end_of_step.speed_m_s > 0.0 && state[3] < 0.0;
        if turns {
            let top = zero(&series.speed, span);
            progress.max_displacement_m =
                larger(progress.max_displacement_m, evaluate(&series.plate, top));
        }
        progress.max_displacement_m = larger(progress.max_displacement_m, state[2]);
        if !self.passes(sides, &state) {
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
        progress.clock = progress.clock.next(span, end_of_step.trusted);
        ControlFlow::Continue(())
    }

    /// Whether the plate is still where its laws hold: on the side of zero on which it started, and going forward.
    fn passes(&self, sides: Sides, state: &[f64; 4]) -> bool {
        let on_its_side = if self.start_m < 0.0 { state[2] < 0.0 } else { state[2] > 0.0 };
        (sides.spring || on_its_side) && (sides.damper || state[3] > 0.0)
    }

    pub(super) fn end(&self, arrested: bool, progress: &IntegrationState) -> ContactEnd {
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
