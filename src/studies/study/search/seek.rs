//! Goal seek: all values of a variable for which a quantity reaches a goal.
//!
//! A scan brackets the crossings of the goal, then each bracket is refined. All solutions farther apart than the spacing of the scan are
//! found. Jumps across the goal, and intervals without a value, are reported separately. This module depends on neither files nor threads
//! nor screens nor a clock.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::study::context::Context;
use crate::study::envelope::Check;
use crate::study::error::TargetError;
use crate::study::quantities::{Quantity, named};
use crate::study::sweep::{Axis, Plan, PointOutcome, StudyError};
use crate::study::validity::DesignValidity;
use cmra_engine::model::scene::{Criterion, InterfaceLaw, Scene};
use cmra_engine::model::units::shortest;
use roots::{Crossing, RootScan};

pub mod roots;

/// Allowed number of points of a scan.
pub const SCAN: RangeInclusive<u64> = 3..=100_000;
/// Default number of points of a scan.
pub const DEFAULT_SCAN: u64 = 65;

/// Request for a goal seek.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Variable with its bounds and the number of points of the scan.
    pub over: Axis,
    /// Quantity and the value to reach.
    pub goal: Goal,
}

/// Formats the command with its options.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "seek --over {} --goal {}", self.over, self.goal)
    }
}

/// Goal: a quantity and the value to reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Quantity.
    pub measure: &'static Quantity,
    /// Value to reach, SI; percent for percentages.
    pub target: f64,
}

/// Parses `QUANTITY=VALUE`, SI or with a unit.
impl FromStr for Goal {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Self, TargetError> {
        let (name, value) = text.split_once('=').ok_or(TargetError::NoGoal)?;
        let measure = named(name.trim())?;
        Ok(Self { measure, target: measure.parse(value)? })
    }
}

/// Formats the goal as it is parsed: `stroke_m=0.045`.
impl fmt::Display for Goal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.measure.name, shortest(self.target))
    }
}

enumeration! {
    /// Kind of a result.
    pub enum Kind in KindRow {
        /// The word in files.
        word: &'static str,
    }
    /// The quantity is continuous and equals the goal.
    Solution { word: "solution" }
    /// The quantity jumps across the goal.
    Jump { word: "jump" }
    /// Closest value without a solution.
    Nearest { word: "nearest" }
    /// Interval of the scan without a value.
    Gap { word: "gap" }
}

/// Point of the scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplePoint {
    /// Value of the variable, in its stored unit.
    pub at: f64,
    /// Value of the quantity.
    pub value: f64,
}

/// Solution, jump, closest value or gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeekResult {
    /// Kind of the result.
    pub kind: Kind,
    /// Position and value; the value is NaN in a gap.
    pub place: SamplePoint,
    /// Other end of a jump, of a gap, or of an interval whose points are all solutions.
    pub until: Option<SamplePoint>,
    /// Outcome of the run.
    pub outcome: Option<PointOutcome>,
    /// Number of points of the scan in a gap.
    pub points: usize,
}

impl SeekResult {
    fn new(kind: Kind, place: SamplePoint) -> Self {
        Self { kind, place, until: None, outcome: None, points: 0 }
    }
}

/// Result of a goal seek.
#[derive(Clone, Debug)]
pub struct SeekReport {
    /// Variable with its bounds.
    pub axis: Axis,
    /// Interface law of all runs.
    pub law: InterfaceLaw,
    /// Criterion of perforation of all runs.
    pub criterion: Criterion,
    /// Quantity.
    pub measure: &'static Quantity,
    /// Value to reach.
    pub target: f64,
    /// Solutions in order of the variable, then jumps, the nearest miss, and gaps.
    pub lines: Vec<SeekResult>,
    /// Validity of each solution.
    pub checked: Vec<DesignValidity>,
    /// Points with the smallest and the largest value.
    pub range: Option<(SamplePoint, SamplePoint)>,
    /// Points of the scan, for charts: value of the variable, value of the quantity.
    pub scan: Vec<(f64, Option<f64>)>,
    /// Number of runs.
    pub runs: usize,
}

impl SeekReport {
    /// Returns the solutions, in the order of `checked`.
    pub fn solutions(&self) -> impl Iterator<Item = &SeekResult> {
        self.of_kind(Kind::Solution)
    }

    /// Returns the results of one kind.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &SeekResult> {
        self.lines.iter().filter(move |line| line.kind == kind)
    }
}

/// Finds all values of the variable that reach the goal, with the interface law of the scene.
///
/// # Errors
/// A [`StudyError`] when bounds, name or scene make no sense: then nothing has run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, SeekReport>,
) -> Result<SeekReport, StudyError> {
    let Request { over: axis, goal } = request;
    let goal = Goal { measure: goal.measure.design_quantity(scene), ..*goal };
    let space = Plan::for_designs(scene, vec![axis.clone()], &[goal.measure.name])?;
    goal.measure.check_exists(scene)?;
    let scan = usize::try_from(axis.count()).unwrap_or(usize::MAX);
    let mut runs = 0;
    let mut outcomes: Vec<(f64, PointOutcome)> = Vec::new();
    let mut function = |fractions: &[f64]| {
        let designs: Vec<Vec<f64>> =
            fractions.iter().map(|fraction| vec![axis.at_fraction(*fraction)]).collect();
        // Estimate for one or two solutions.
        context.expect(if runs < scan { scan + 40 } else { 40 });
        let found = space.evaluate(&designs, context);
        runs += found.len();
        outcomes.extend(
            fractions.iter().zip(&found).map(|(fraction, found)| (*fraction, found.outcome)),
        );
        (!context.is_stopped()).then(|| found.iter().map(|found| found.values[0]).collect())
    };
    let mut root_scan = RootScan::new(goal.target, &mut function);
    // A stopped scan keeps its results so far.
    let _stopped = root_scan.run(scan);
    let RootScan { crossings, seen, scan: scanned, .. } = root_scan;
    let place = |point: SamplePoint| SamplePoint { at: axis.at_fraction(point.at), ..point };
    let outcome_at = |fraction: f64| {
        let mut same = outcomes.iter().filter(|(other, _)| other.to_bits() == fraction.to_bits());
        same.next().map(|(_, outcome)| *outcome)
    };
    let (found, jumps): (Vec<Crossing>, Vec<Crossing>) =
        crossings.into_iter().partition(|crossing| crossing.kind == Kind::Solution);
    let mut lines: Vec<SeekResult> = Vec::new();
    lines.extend(found.iter().map(|Crossing { kind, from, to }| SeekResult {
        until: (to.at > from.at && to.value - goal.target == 0.0).then(|| place(*to)),
        outcome: outcome_at(from.at),
        ..SeekResult::new(*kind, place(*from))
    }));
    lines.extend(jumps.iter().map(|Crossing { kind, from, to }| SeekResult {
        until: Some(place(*to)),
        ..SeekResult::new(*kind, place(*from))
    }));
    if found.is_empty() {
        let miss = |seen: &SamplePoint| (seen.value - goal.target).abs();
        let nearest = seen.iter().min_by(|a, b| miss(a).total_cmp(&miss(b)));
        lines.extend(nearest.map(|seen| SeekResult::new(Kind::Nearest, place(*seen))));
    }
    let designs = found.iter().map(|it| space.scene_of(&[axis.at_fraction(it.from.at)]));
    let mut check = |design: &Scene, known: &[Check]| {
        DesignValidity::from_run(design, goal.measure, known, &mut || context.should_continue())
    };
    let known = check(scene, &[]).fails;
    let checked = designs.map(|design| check(&design, &known)).collect();
    lines.extend(gaps(&scanned, axis, outcome_at));
    Ok(SeekReport {
        axis: axis.clone(),
        law: scene.interface.law,
        criterion: scene.target.criterion,
        measure: goal.measure,
        target: goal.target,
        lines,
        checked,
        range: range(&seen).map(|(least, most)| (place(least), place(most))),
        scan: scanned
            .iter()
            .map(|(fraction, value)| (axis.at_fraction(*fraction), *value))
            .collect(),
        runs,
    })
}

/// Returns the intervals of the scan without a value and with the same outcome.
fn gaps(
    scan: &[(f64, Option<f64>)],
    axis: &Axis,
    outcome_at: impl Fn(f64) -> Option<PointOutcome>,
) -> Vec<SeekResult> {
    let mut gaps: Vec<SeekResult> = Vec::new();
    let outcome = |point: &(f64, Option<f64>)| outcome_at(point.0).filter(|_| point.1.is_none());
    for points in scan.chunk_by(|a, b| outcome(a) == outcome(b)) {
        let ([first, ..], [.., last]) = (points, points) else { continue };
        let place = |fraction: f64| SamplePoint { at: axis.at_fraction(fraction), value: f64::NAN };
        gaps.extend(outcome(first).map(|outcome| SeekResult {
            until: Some(place(last.0)),
            outcome: Some(outcome),
            points: points.len(),
            ..SeekResult::new(Kind::Gap, place(first.0))
        }));
    }
    gaps
}

/// Returns the points with the smallest and the largest value.
fn range(seen: &[SamplePoint]) -> Option<(SamplePoint, SamplePoint)> {
    let by = |a: &&SamplePoint, b: &&SamplePoint| a.value.total_cmp(&b.value);
    Some((*seen.iter().min_by(by)?, *seen.iter().max_by(by)?))
}

#[cfg(test)]
mod tests;
