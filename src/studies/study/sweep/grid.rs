//! Grid of one or two axes in memory, for the screen; filled in passes from coarse to fine.
//!
//! Each pass halves the spacing of the computed points. A point that is not computed is shown by the closest coarser one. The complete grid
//! does not depend on the passes.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::study::context::Context;
use crate::study::envelope::Check;
use crate::study::outcome::OutcomeCounts;
use crate::study::sweep::{Evaluator, Plan, Point, PointOutcome, StudyError};
use crate::study::validity;
use cmra_engine::model::run::Warning;

/// Maximum number of points of a grid: some tens of megabytes.
pub const GRID_MAX: u64 = 1_000_000;
/// Allowed number of points of an axis of a grid.
pub const GRID_COUNTS: RangeInclusive<u64> = 2..=GRID_MAX;
/// Default number of points that a thread computes at once.
pub const PIECE: u64 = 64;
/// Spacing of the first pass, in points; smaller for a short axis.
const COARSEST: usize = 16;
/// Minimum number of points of an axis in the first pass.
const COARSE_POINTS: usize = 6;
/// An axis of fewer points has all of them in the first pass.
const SHORT: usize = 12;

/// The stride along an axis of so many points.
fn along(count: usize, stride: usize) -> usize {
    if count < SHORT { 1 } else { stride }
}

/// Returns the points of a grid at these strides along its axes that are wanted; the first axis varies slowest.
pub(in crate::study) fn lattice(
    (across, up): (usize, usize),
    strides: [usize; 2],
    is_wanted: impl Fn(usize) -> bool,
) -> Vec<u64> {
    let columns = (0..across).step_by(strides[0]);
    let points = columns.flat_map(|x| (0..up).step_by(strides[1]).map(move |y| x * up + y));
    points.filter(|index| is_wanted(*index)).map(|index| index as u64).collect()
}

/// Checks that a plan has no more points than a grid can hold.
pub fn fits(plan: &Plan) -> Result<(), StudyError> {
    let points = plan.points();
    let most = GRID_MAX;
    if points <= most {
        return Ok(());
    }
    Err(StudyError::TooManyForScreen { points, most })
}

/// Cell of a chart: a quantity at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// Value of the quantity.
    Value(f64),
    /// Computed point without a value, or with a value that does not count for its outcome.
    Outcome(PointOutcome),
    /// Not computed yet.
    Waiting,
}

impl Cell {
    /// Returns the value, if there is one.
    pub fn value(self) -> Option<f64> {
        if let Self::Value(value) = self { Some(value) } else { None }
    }
}

/// Grid, complete or partial.
#[derive(Clone, Debug)]
pub struct Grid {
    plan: Arc<Plan>,
    /// Points along the first axis and the second (1 without one).
    counts: (usize, usize),
    outcomes: Vec<Option<PointOutcome>>,
    values: Vec<f64>,
    /// Lower bounds of the outputs at the points that have any.
    bounds: BTreeMap<usize, Vec<Option<f64>>>,
    done: usize,
    /// Checks of the validity that fail at an end of an axis and not for the scene itself, with their warnings; filled with the last pass.
    pub outside_at_ends: Vec<(Check, Warning)>,
}

impl Grid {
    /// Creates an empty grid for a plan of one or two axes and at most [`GRID_MAX`] points; `None` for other plans.
    pub fn new(plan: Arc<Plan>) -> Option<Self> {
        let counts = match plan.axes() {
            [x] => (x.count(), 1),
            [x, y] => (x.count(), y.count()),
            _ => return None,
        };
        fits(&plan).ok()?;
        let counts = (usize::try_from(counts.0).ok()?, usize::try_from(counts.1).ok()?);
        let points = counts.0 * counts.1;
        Some(Self {
            counts,
            outcomes: vec![None; points],
            values: vec![f64::NAN; points * plan.outputs().len()],
            bounds: BTreeMap::new(),
            done: 0,
            outside_at_ends: Vec::new(),
            plan,
        })
    }

    /// Returns the plan.
    pub fn plan(&self) -> &Arc<Plan> {
        &self.plan
    }

    /// Returns the numbers of points along the first and the second axis.
    pub fn counts(&self) -> (usize, usize) {
        self.counts
    }

    /// Returns the value of an axis at a point, in the stored unit.
    pub fn coordinate(&self, (x, y): (usize, usize), axis: usize) -> f64 {
        self.plan.coordinate((x * self.counts.1 + y) as u64, axis)
    }

    /// Returns the numbers of computed points and of all points.
    pub fn progress(&self) -> (usize, usize) {
        (self.done, self.outcomes.len())
    }

    /// Returns `true` if every point is computed.
    pub fn is_complete(&self) -> bool {
        self.done == self.outcomes.len()
    }

    /// Returns the outcome of a point; `None` if it is not computed yet.
    pub fn outcome(&self, x: usize, y: usize) -> Option<PointOutcome> {
        *self.outcomes.get(x * self.counts.1 + y)?
    }

    /// Returns a quantity at a point; `None` if it is not computed yet or does not exist.
    pub fn value(&self, x: usize, y: usize, output: usize) -> Option<f64> {
        let index = (x * self.counts.1 + y) * self.plan.outputs().len() + output;
        self.values.get(index).copied().filter(|value| !value.is_nan())
    }

    /// Returns the computed points in the order of the sweep, with their results.
    pub fn points(&self) -> (Vec<u64>, Vec<Point>) {
        let outputs = self.plan.outputs().len();
        let there = self.outcomes.iter().enumerate().filter_map(|(at, outcome)| {
            let values = self.values[at * outputs..][..outputs].iter();
            let values = values.map(|value| Some(*value).filter(|value| !value.is_nan()));
            let bounds = self.bounds.get(&at).cloned().unwrap_or_default();
            Some((at as u64, Point { bounds, ..Point::new((*outcome)?, values) }))
        });
        there.unzip()
    }

    /// Returns the cell to draw for an output at a point; the nearest coarser point while the grid is incomplete.
    pub fn cell(&self, x: usize, y: usize, output: usize) -> Cell {
        let mut stride = 1;
        loop {
            let (x, y) =
                (x - x % along(self.counts.0, stride), y - y % along(self.counts.1, stride));
            if let Some(outcome) = self.outcome(x, y) {
                let shown = outcome.counts(self.plan.outputs()[output]);
                return match self.value(x, y, output).filter(|_| shown) {
                    Some(value) => Cell::Value(value),
                    None => Cell::Outcome(outcome),
                };
            }
            if stride >= COARSEST {
                return Cell::Waiting;
            }
            stride *= 2;
        }
    }

    /// Counts the points by outcome.
    pub fn outcomes(&self) -> OutcomeCounts {
        let mut counts = OutcomeCounts::default();
        self.outcomes.iter().flatten().for_each(|outcome| counts.add(*outcome));
        counts
    }

    /// Fills the grid, with a given number of points for a thread at once, and reports it after each pass; a stopped grid is partial.
    #[must_use]
    pub fn fill(mut self, at_once: u64, context: &mut Context<'_, Self>) -> Self {
        let (plan, stop) = (Arc::clone(&self.plan), context.stop());
        context.expect(self.outcomes.len());
        for stride in self.strides() {
            let worker = || {
                let mut evaluator = Evaluator::new(&plan, &stop);
                move |points: &[u64]| evaluator.points(points)
            };
            context.each_of((&self.pass(stride), at_once), worker, |context, points, found| {
                self.put(points.iter().copied(), &found);
                context.should_continue()
            });
            if context.is_stopped() || !context.show(&self) {
                break;
            }
        }
        if self.is_complete() {
            self.outside_at_ends = validity::new_at_ends(plan.base(), plan.axes());
        }
        self
    }

    /// Returns the spacing of each pass, from coarse to fine.
    fn strides(&self) -> Vec<usize> {
        let longest = self.counts.0.max(self.counts.1);
        let mut stride = COARSEST;
        while stride > 1 && longest / stride < COARSE_POINTS {
            stride /= 2;
        }
        std::iter::successors(Some(stride), |stride| (*stride > 1).then_some(stride / 2)).collect()
    }

    /// Returns the points of a pass that are not computed yet; the first axis varies slowest.
    fn pass(&self, stride: usize) -> Vec<u64> {
        let strides = [self.counts.0, self.counts.1].map(|count| along(count, stride));
        lattice(self.counts, strides, |index| self.outcomes[index].is_none())
    }

    /// Appends the next points to a grid that is filled in the order of its points.
    pub fn extend(&mut self, found: &[Point]) {
        let first = self.done as u64;
        self.put(first.., found);
    }

    fn put(&mut self, points: impl IntoIterator<Item = u64>, found: &[Point]) {
        let outputs = self.plan.outputs().len();
        for (point, index) in found.iter().zip(points) {
            let Ok(index) = usize::try_from(index) else { continue };
            self.done += usize::from(self.outcomes[index].is_none());
            self.outcomes[index] = Some(point.outcome);
            if !point.bounds.is_empty() {
                self.bounds.insert(index, point.bounds.clone());
            }
            let values = &mut self.values[index * outputs..][..outputs];
            for (kept, value) in values.iter_mut().zip(&point.values) {
                *kept = value.unwrap_or(f64::NAN);
            }
        }
    }
}
