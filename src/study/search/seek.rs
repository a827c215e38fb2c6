//! Goal seek: which values of one variable give a wanted value of one measure.
//!
//! The whole interval is looked at by a scan first, then every place where the goal is crossed or nearly reached is closed in; so
//! all solutions further apart than the scan's spacing are found, and what crosses the goal by a jump, or has no value, is told
//! apart from a solution. Must not know files, threads, screens or a clock.

use std::ops::RangeInclusive;

use crate::model::scene::Scene;
use crate::study::context::Context;
use crate::study::quantities::Quantity;
use crate::study::search::design_space::DesignSpace;
use crate::study::sweep::{Axis, PointOutcome, SweepError};
use roots::{Kind, RootScan};

pub mod roots;

/// How many points a scan may have.
pub const SCAN: RangeInclusive<u64> = 3..=100_000;
/// Points of a scan where none are asked for.
pub const SCAN_USUAL: u64 = 65;

/// What is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The variable, its bounds, and as many points as the scan has.
    pub axis: Axis,
    /// The measure's name.
    pub measure: String,
    /// The value it should have, SI; percent for percentages.
    pub target: f64,
}

/// A value of the variable, and what comes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The variable's value, in its stored unit.
    pub at: f64,
    /// The measure there.
    pub value: f64,
}

/// A solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// Where, and what is reached.
    pub place: Place,
    /// The goal is touched, not crossed: a least or greatest value.
    pub touches: bool,
    /// The goal is met up to here as well, and all between: the measure does not depend on the variable.
    pub until: Option<f64>,
    /// What becomes of the design.
    pub outcome: Option<PointOutcome>,
}

/// The measure jumps over the goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jump {
    /// The last place before.
    pub before: Place,
    /// The first place after.
    pub after: Place,
}

/// A stretch of the scan without a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// First and last point of the scan in it.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// What becomes of the designs there.
    pub outcome: PointOutcome,
    /// Points of the scan in it.
    pub points: usize,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Report {
    /// The variable and its bounds.
    pub axis: Axis,
    /// The measure.
    pub measure: &'static Quantity,
    /// Its wanted value.
    pub target: f64,
    /// In order of the variable.
    pub solutions: Vec<Solution>,
    /// Where the measure jumps over the goal.
    pub jumps: Vec<Jump>,
    /// Where it has no value.
    pub gaps: Vec<Gap>,
    /// The nearest miss where there is no solution.
    pub nearest: Option<Place>,
    /// The least and the greatest value met with.
    pub range: Option<(Place, Place)>,
    /// The scan, for drawing: the variable's value and the measure's.
    pub scan: Vec<(f64, Option<f64>)>,
    /// Runs made.
    pub runs: usize,
    /// Whether it was done to its end.
    pub is_complete: bool,
}

/// Seek.
///
/// # Errors
/// A [`SweepError`] when bounds, name or scene make no sense: then nothing has run.
pub fn seek(scene: &Scene, goal: &Goal, context: &mut Context<'_>) -> Result<Report, SweepError> {
    let axis = &goal.axis;
    let space = DesignSpace::new(scene, vec![axis.clone()], &[goal.measure.as_str()])?;
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
    let ended = root_scan.run(scan);
    let RootScan { crossings, seen, scan: scanned, .. } = root_scan;
    let place = |(share, value): (f64, f64)| Place { at: axis.at_share(share), value };
    let outcome_at = |share: f64| {
        outcomes
            .iter()
            .find(|(other, _)| other.to_bits() == share.to_bits())
            .map(|(_, outcome)| *outcome)
    };
    let mut report = Report {
        axis: axis.clone(),
        measure: space.measures()[0],
        target: goal.target,
        solutions: Vec::new(),
        jumps: Vec::new(),
        gaps: gaps(&scanned, axis, outcome_at),
        nearest: None,
        range: range(&seen).map(|(least, most)| (place(least), place(most))),
        scan: scanned.iter().map(|(share, value)| (axis.at_share(*share), *value)).collect(),
        runs,
        is_complete: ended.is_ok(),
    };
    for crossing in crossings {
        let (a, b) = (place(crossing.from), place(crossing.to));
        let solution = |touches, until| {
            let outcome = outcome_at(crossing.from.0);
            Solution { place: a, touches, until, outcome }
        };
        match crossing.kind {
            Kind::Root => report.solutions.push(solution(false, None)),
            Kind::Touch => report.solutions.push(solution(true, None)),
            Kind::Plateau => report.solutions.push(solution(false, Some(b.at))),
            Kind::Jump => report.jumps.push(Jump { before: a, after: b }),
        }
    }
    if report.solutions.is_empty() {
        let miss = |seen: &(f64, f64)| (seen.1 - goal.target).abs();
        let nearest = seen.iter().min_by(|a, b| miss(a).total_cmp(&miss(b)));
        report.nearest = nearest.map(|seen| place(*seen));
    }
    Ok(report)
}

/// Neighbouring points of the scan without a value and with the same outcome.
fn gaps(
    scan: &[(f64, Option<f64>)],
    axis: &Axis,
    outcome_at: impl Fn(f64) -> Option<PointOutcome>,
) -> Vec<Gap> {
    let mut gaps: Vec<Gap> = Vec::new();
    let mut goes_on = false;
    for (share, value) in scan {
        let Some(outcome) = outcome_at(*share).filter(|_| value.is_none()) else {
            goes_on = false;
            continue;
        };
        let at = axis.at_share(*share);
        match gaps.last_mut().filter(|gap| goes_on && gap.outcome == outcome) {
            Some(gap) => {
                gap.to = at;
                gap.points += 1;
            }
            None => gaps.push(Gap { from: at, to: at, outcome, points: 1 }),
        }
        goes_on = true;
    }
    gaps
}

/// The points with the least and the greatest value.
fn range(seen: &[(f64, f64)]) -> Option<((f64, f64), (f64, f64))> {
    let by = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
    Some((*seen.iter().min_by(by)?, *seen.iter().max_by(by)?))
}

#[cfg(test)]
mod tests;
