//! A full grid of one or two axes, or the points of another design in a row, kept in memory and filled coarse first, for the
//! screen.
//!
//! Each pass computes the points of a smaller step between points. Until a point is computed, the nearest computed one stands for
//! it. The finished grid does not depend on the passes.

use std::ops::{Range, RangeInclusive};
use std::sync::Arc;

use crate::study::context::{Context, Work};
use crate::study::outcome::OutcomeCounts;
use crate::study::sweep::{Evaluator, Plan, Point, PointOutcome, SweepError};
use crate::study::validity;
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::envelope::Check;

/// The most points a grid may have: some tens of megabytes.
pub const GRID_MAX: u64 = 1_000_000;
/// How many of them an axis may have.
pub const GRID_COUNTS: RangeInclusive<u64> = 2..=GRID_MAX;
/// Points that a thread usually computes at once.
pub const PIECE: u64 = 64;
/// The first pass takes every n-th point of an axis, unless the axis is short.
const COARSEST: usize = 16;
/// An axis has at least this many points in the first pass.
const COARSE_POINTS: usize = 6;

/// Checks that a plan has no more points than a grid can hold.
pub fn fits(plan: &Plan) -> Result<(), SweepError> {
    let points = plan.points();
    let most = GRID_MAX;
    if points <= most {
        return Ok(());
    }
    Err(SweepError(format!(
        "{points} points are too many for the screen, which keeps at most {most}: take fewer along the axes, or use `cmra sweep`"
    )))
}

/// The results of one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// The output's value.
    Value(f64),
    /// Computed point whose output does not exist, or would mislead as a number.
    Outcome(PointOutcome),
    /// Not computed yet.
    Waiting,
}

impl Cell {
    /// The number, where there is one.
    pub fn value(self) -> Option<f64> {
        if let Self::Value(value) = self { Some(value) } else { None }
    }
}

/// A grid, filled as far as it is.
#[derive(Clone, Debug)]
pub struct Grid {
    plan: Arc<Plan>,
    /// Points along the first axis and the second (1 without one).
    counts: (usize, usize),
    outcomes: Vec<Option<PointOutcome>>,
    values: Vec<f64>,
    /// The stride that is filled everywhere; 0: not even the coarsest.
    stride: usize,
    done: usize,
    /// Checks of the model's validity that fail at an end of an axis and not for the scene itself; known once all is filled; each
    /// with its warning.
    pub outside_at_ends: Vec<(Check, Warning)>,
}

impl Grid {
    /// An empty grid for a plan of one or two axes, of at most [`GRID_MAX`] points; `None` for other plans.
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
            stride: 0,
            done: 0,
            outside_at_ends: Vec::new(),
            plan,
        })
    }

    /// The sweep it belongs to.
    pub fn plan(&self) -> &Arc<Plan> {
        &self.plan
    }

    /// Points along the first axis and the second.
    pub fn counts(&self) -> (usize, usize) {
        self.counts
    }

    /// The value of an axis at a point, in the stored unit.
    pub fn coordinate(&self, (x, y): (usize, usize), axis: usize) -> f64 {
        self.plan.coordinate((x * self.counts.1 + y) as u64, axis)
    }

    /// Points done, and in all.
    pub fn progress(&self) -> (usize, usize) {
        (self.done, self.outcomes.len())
    }

    /// Whether every point is there.
    pub fn is_complete(&self) -> bool {
        self.done == self.outcomes.len()
    }

    /// The outcome of a point; `None` where it is not computed yet.
    pub fn outcome(&self, x: usize, y: usize) -> Option<PointOutcome> {
        *self.outcomes.get(x * self.counts.1 + y)?
    }

    /// An output at a point; `None` where it is not there yet or does not exist.
    pub fn value(&self, x: usize, y: usize, output: usize) -> Option<f64> {
        let index = (x * self.counts.1 + y) * self.plan.outputs().len() + output;
        self.values.get(index).copied().filter(|value| !value.is_nan())
    }

    /// The points that are there, in the order of the sweep, and what came out.
    pub fn points(&self) -> (Vec<u64>, Vec<Point>) {
        let outputs = self.plan.outputs().len();
        let there = self.outcomes.iter().enumerate().filter_map(|(at, outcome)| {
            let values = self.values[at * outputs..][..outputs].iter();
            let values = values.map(|value| Some(*value).filter(|value| !value.is_nan()));
            Some((at as u64, Point::new((*outcome)?, values)))
        });
        there.unzip()
    }

    /// Returns the cell to draw for an output at a point; the nearest coarser point while the grid is incomplete.
    pub fn cell(&self, x: usize, y: usize, output: usize) -> Cell {
        let mut stride = 1;
        loop {
            let (x, y) = (x - x % stride, y - y % stride);
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

    /// How the points ended.
    pub fn outcomes(&self) -> OutcomeCounts {
        let mut counts = OutcomeCounts::default();
        self.outcomes.iter().flatten().for_each(|outcome| counts.add(*outcome));
        counts
    }

    /// Fill the grid, a given number of points of a thread at once, and show it after each pass. What is done when it is stopped is kept.
    #[must_use]
    pub fn fill(mut self, at_once: u64, context: &mut Context<'_, Self>) -> Self {
        let plan = Arc::clone(&self.plan);
        let stop = context.stop();
        context.expect(self.outcomes.len());
        for stride in self.strides() {
            let points = self.pass(stride);
            let slice = |piece: &Range<u64>| {
                let at = |end: u64| usize::try_from(end).unwrap_or(points.len());
                &points[at(piece.start)..at(piece.end)]
            };
            let worker = || {
                let mut evaluator = Evaluator::new(&plan, &stop);
                move |piece: Range<u64>| evaluator.points(slice(&piece))
            };
            let all = points.len() as u64;
            let work = Work { count: all, at_once };
            context.each(work, worker, |context, piece, found: Vec<Point>| {
                let whole = found.len() == slice(&piece).len();
                self.put(slice(&piece).iter().copied(), &found);
                context.count(found.len());
                let finished = whole && piece.end == all;
                if finished {
                    self.stride = stride;
                }
                whole && if finished { context.show(&self) } else { context.should_continue() }
            });
            if context.is_stopped() {
                break;
            }
        }
        if self.is_complete() {
            self.outside_at_ends = validity::new_at_ends(plan.base(), plan.axes());
        }
        self
    }

    /// The stride of each pass, from coarse to fine.
    fn strides(&self) -> Vec<usize> {
        let longest = self.counts.0.max(self.counts.1);
        let mut stride = COARSEST;
        while stride > 1 && longest / stride < COARSE_POINTS {
            stride /= 2;
        }
        std::iter::successors(Some(stride), |stride| (*stride > 1).then_some(stride / 2)).collect()
    }

    /// The points of a stride that are not there yet, first axis slowest.
    fn pass(&self, stride: usize) -> Vec<u64> {
        let (along_x, along_y) = self.counts;
        let mut points = Vec::new();
        for x in (0..along_x).step_by(stride) {
            for y in (0..along_y).step_by(stride) {
                let index = x * along_y + y;
                if self.outcomes[index].is_none() {
                    points.push(index as u64);
                }
            }
        }
        points
    }

    /// Keep the points that follow those kept so far, of a grid that is filled in the order of its points.
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
            let values = &mut self.values[index * outputs..][..outputs];
            for (kept, value) in values.iter_mut().zip(&point.values) {
                *kept = value.unwrap_or(f64::NAN);
            }
        }
    }
}
