//! Goal seek: which values of one variable give a wanted value of one measure.
//!
//! A scan covers the whole interval, then every place where the goal is crossed is refined; so
//! all solutions further apart than the scan's spacing are found, and what crosses the goal by a jump, or has no value, is reported
//! apart from a solution. Must not know files, threads, screens or a clock.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::study::context::Context;
use crate::study::quantities::{Quantity, named};
use crate::study::sweep::{Axis, Plan, PointOutcome, SweepError};
use crate::study::validity::DesignValidity;
use cmra_engine::model::run::envelope::Check;
use cmra_engine::model::scene::{Criterion, InterfaceLaw, Scene};
use cmra_engine::model::units::shortest;
use roots::{Crossing, RootScan};

pub mod roots;

/// How many points a scan may have.
pub const SCAN: RangeInclusive<u64> = 3..=100_000;
/// Points of a scan if none is given.
pub const DEFAULT_SCAN: u64 = 65;

/// Request for a goal seek.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The variable, its bounds, and as many points as the scan has.
    pub over: Axis,
    /// The quantity, and the value it should have.
    pub goal: Goal,
}

/// The command's name and options.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "seek --over {} --goal {}", self.over, self.goal)
    }
}

/// A quantity and the value it should have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// The quantity.
    pub measure: &'static Quantity,
    /// The value, SI; percent for percentages.
    pub target: f64,
}

/// Reads `QUANTITY=VALUE`, SI or with a unit.
impl FromStr for Goal {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, value) = text
            .split_once('=')
            .ok_or("write QUANTITY=VALUE, for example percent_of_baseline=60 or stroke_m=45mm")?;
        let measure = named(name.trim()).map_err(|error| error.to_string())?;
        Ok(Self { measure, target: measure.parse(value)? })
    }
}

/// As it is read: `stroke_m=0.045`.
impl fmt::Display for Goal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.measure.name, shortest(self.target))
    }
}

enumeration! {
    /// The kind of a line of the answer.
    pub enum Kind in KindRow {
        /// The word in files.
        word: &'static str,
    }
    /// The goal is reached in passing.
    Solution { word: "solution" }
    /// The measure jumps over the goal.
    Jump { word: "jump" }
    /// The nearest miss where there is no solution.
    Nearest { word: "nearest" }
    /// A stretch of the scan without a value.
    Gap { word: "gap" }
}

/// A value of the variable, and what comes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplePoint {
    /// The variable's value, in its stored unit.
    pub at: f64,
    /// The measure there.
    pub value: f64,
}

/// A line of the answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeekResult {
    /// Kind of the result.
    pub kind: Kind,
    /// Where, and what is reached; the measure is NaN in a gap.
    pub place: SamplePoint,
    /// The other end of a jump or a gap.
    pub until: Option<SamplePoint>,
    /// The outcome of the design.
    pub outcome: Option<PointOutcome>,
    /// Points of the scan in a gap.
    pub points: usize,
}

impl SeekResult {
    fn new(kind: Kind, place: SamplePoint) -> Self {
        Self { kind, place, until: None, outcome: None, points: 0 }
    }
}

/// The result.
#[derive(Clone, Debug)]
pub struct SeekReport {
    /// The variable and its bounds.
    pub axis: Axis,
    /// The interface law of all runs.
    pub law: InterfaceLaw,
    /// The criterion of perforation of all runs.
    pub criterion: Criterion,
    /// The measure.
    pub measure: &'static Quantity,
    /// Value that the goal requires.
    pub target: f64,
    /// Solutions in order of the variable, then jumps, the nearest miss, and gaps.
    pub lines: Vec<SeekResult>,
    /// Validity of each solution.
    pub checked: Vec<DesignValidity>,
    /// The least and the greatest value met with.
    pub range: Option<(SamplePoint, SamplePoint)>,
    /// The scan, for drawing: the variable's value and the measure's.
    pub scan: Vec<(f64, Option<f64>)>,
    /// Runs made.
    pub runs: usize,
}

impl SeekReport {
    /// The solutions, in the order in which they were checked.
    pub fn solutions(&self) -> impl Iterator<Item = &SeekResult> {
        self.of_kind(Kind::Solution)
    }

    /// The lines of one kind.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &SeekResult> {
        self.lines.iter().filter(move |line| line.kind == kind)
    }
}

/// Looks for every value of the variable that reaches the goal, on the interface law of the scene.
///
/// # Errors
/// A [`SweepError`] when bounds, name or scene make no sense: then nothing has run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, SeekReport>,
) -> Result<SeekReport, SweepError> {
    let Request { over: axis, goal } = request;
    let goal = Goal { measure: goal.measure.design_quantity(scene), ..*goal };
    let space = Plan::for_designs(scene, vec![axis.clone()], &[goal.measure.name])?;
    goal.measure.check_exists(scene)?;
    let scan = usize::try_from(axis.count()).unwrap_or(usize::MAX);
    let mut runs = 0;
    let mut outcomes: Vec<(f64, PointOutcome)> = Vec::new();
    let mut function = |shares: &[f64]| {
        let designs: Vec<Vec<f64>> =
            shares.iter().map(|share| vec![axis.at_share(*share)]).collect();
        // A guess that is right for one solution or two.
        context.expect(if runs < scan { scan + 40 } else { 40 });
        let found = space.evaluate(&designs, context);
        runs += found.len();
        outcomes.extend(shares.iter().zip(&found).map(|(share, found)| (*share, found.outcome)));
        (!context.is_stopped()).then(|| found.iter().map(|found| found.values[0]).collect())
    };
    let mut root_scan = RootScan::new(goal.target, &mut function);
    // A stopped scan leaves what it has seen.
    let _stopped = root_scan.run(scan);
    let RootScan { crossings, seen, scan: scanned, .. } = root_scan;
    let place = |point: SamplePoint| SamplePoint { at: axis.at_share(point.at), ..point };
    let outcome_at = |share: f64| {
        let mut same = outcomes.iter().filter(|(other, _)| other.to_bits() == share.to_bits());
        same.next().map(|(_, outcome)| *outcome)
    };
    let (found, jumps): (Vec<Crossing>, Vec<Crossing>) =
        crossings.into_iter().partition(|crossing| crossing.kind == Kind::Solution);
    let mut lines: Vec<SeekResult> = Vec::new();
    lines.extend(found.iter().map(|Crossing { kind, from, .. }| SeekResult {
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
    let designs = found.iter().map(|it| space.scene_of(&[axis.at_share(it.from.at)]));
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
        scan: scanned.iter().map(|(share, value)| (axis.at_share(*share), *value)).collect(),
        runs,
    })
}

/// Neighbouring points of the scan without a value and with the same outcome.
fn gaps(
    scan: &[(f64, Option<f64>)],
    axis: &Axis,
    outcome_at: impl Fn(f64) -> Option<PointOutcome>,
) -> Vec<SeekResult> {
    let mut gaps: Vec<SeekResult> = Vec::new();
    let outcome = |point: &(f64, Option<f64>)| outcome_at(point.0).filter(|_| point.1.is_none());
    for points in scan.chunk_by(|a, b| outcome(a) == outcome(b)) {
        let ([first, ..], [.., last]) = (points, points) else { continue };
        let place = |share: f64| SamplePoint { at: axis.at_share(share), value: f64::NAN };
        gaps.extend(outcome(first).map(|outcome| SeekResult {
            until: Some(place(last.0)),
            outcome: Some(outcome),
            points: points.len(),
            ..SeekResult::new(Kind::Gap, place(first.0))
        }));
    }
    gaps
}

/// The points with the least and the greatest value.
fn range(seen: &[SamplePoint]) -> Option<(SamplePoint, SamplePoint)> {
    let by = |a: &&SamplePoint, b: &&SamplePoint| a.value.total_cmp(&b.value);
    Some((*seen.iter().min_by(by)?, *seen.iter().max_by(by)?))
}

#[cfg(test)]
mod tests;
