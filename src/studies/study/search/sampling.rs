//! Derivative-free minimisation over the unit cube by sampling: a Sobol sequence over the cube, then over boxes around the best points,
//! which shrink in each round.
//!
//! The search is deterministic. With several objectives the best points are the feasible ones that no other point dominates, with one
//! objective the feasible point with the smallest value.

use crate::study::sobol;

/// Number of rounds after the first one, which has a quarter of the points.
const ROUNDS: usize = 20;
/// Minimum number of points kept after a round; a single point would restrict the search to its neighbourhood.
const KEPT_LEAST: usize = 8;
/// Maximum number of points kept after a round, and of points on the front.
pub const KEPT_MOST: usize = 100;
/// Half the side of the first boxes, relative to the mean distance of the points of the first round.
const REACH: f64 = 1.5;
/// Side of a box, relative to that of the previous round.
const SHRINK: f64 = 0.7;

/// Result of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Objectives, all minimised.
    pub objectives: Vec<f64>,
    /// Total violation of the constraints: 0 if all are satisfied, infinite without a value.
    pub violation: f64,
}

impl Evaluation {
    /// Returns `true` if every constraint is satisfied.
    pub fn is_feasible(&self) -> bool {
        self.violation == 0.0
    }

    /// Returns `true` if this point is better than the other one:
    ///
    /// - it has a smaller violation, or
    /// - both are feasible, and it is better in one objective and worse in none.
    pub fn dominates(&self, other: &Self) -> bool {
        if !self.is_feasible() || !other.is_feasible() {
            return self.violation < other.violation;
        }
        let mut pairs = self.objectives.iter().zip(&other.objectives);
        let no_worse = pairs.clone().all(|(own, others)| own <= others);
        no_worse && pairs.any(|(own, others)| own < others)
    }
}

/// Point with its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample<T> {
    /// Coordinates, 0 to 1.
    pub fractions: Vec<f64>,
    /// Result.
    pub judged: Evaluation,
    /// Further data of the caller.
    pub found: T,
}

/// Function to minimise, called with many points and the best points so far; returns `None` if the search was stopped.
pub type Function<'a, T> =
    &'a mut dyn FnMut(&[Vec<f64>], &[Sample<T>]) -> Option<Vec<(Evaluation, T)>>;

/// Returns the best points after about a given number of evaluations; those of the previous rounds if the search was stopped. At most
/// [`KEPT_MOST`] points are on the [`front`]. `start` is the first point.
pub fn search<T>(
    inputs: usize,
    start: Option<Vec<f64>>,
    evaluations: usize,
    function: Function<'_, T>,
) -> Vec<Sample<T>> {
    let first = evaluations / 4;
    let mut points: Vec<Vec<f64>> = start.into_iter().collect();
    points.extend((0..first as u64).map(|index| {
        // The outermost points lie on the bounds, where the best designs often are.
        (0..inputs)
            .map(|input| (1.02 * sobol::point_coordinate(index, input, 0) - 0.01).clamp(0.0, 1.0))
            .collect()
    }));
    let mut reach = REACH * (first as f64).powf(-1.0 / inputs as f64);
    let mut best: Vec<Sample<T>> = Vec::new();
    for round in 0..=ROUNDS {
        let Some(judged) = function(&points, &best) else { break };
        let found = points.drain(..).zip(judged);
        best.extend(found.map(|(fractions, (judged, found))| Sample { fractions, judged, found }));
        best = fittest(best);
        // Each box has its own part of the sequence.
        let count = (evaluations - first) / ROUNDS;
        let each = count.div_ceil(best.len());
        points.extend((0..count).map(|at| {
            let (centre, place) = (at % best.len(), at / best.len());
            let index = ((round * best.len() + centre) * each + place) as u64;
            let side = |(input, fraction): (usize, &f64)| {
                (fraction + reach * (2.0 * sobol::point_coordinate(index, input, 0) - 1.0))
                    .clamp(0.0, 1.0)
            };
            best[centre].fractions.iter().enumerate().map(side).collect()
        }));
        reach *= SHRINK;
    }
    best
}

/// Returns the feasible points that no other point dominates.
pub fn front<T>(points: &[Sample<T>]) -> Vec<&Sample<T>> {
    let feasible = || points.iter().filter(|one| one.judged.is_feasible());
    let is_best = |one: &&Sample<T>| feasible().all(|it| !it.judged.dominates(&one.judged));
    feasible().filter(is_best).collect()
}

/// Returns the points to keep: the non-dominated ones, spread over the front if there are too many; if there are too few, also those that
/// only these dominate, and so on.
fn fittest<T>(mut points: Vec<Sample<T>>) -> Vec<Sample<T>> {
    let mut kept = Vec::new();
    while kept.len() < KEPT_LEAST && !points.is_empty() {
        let (front, rest) = split(points);
        kept.extend(spread(front));
        points = rest;
    }
    kept
}

/// Separates the non-dominated points, without repeated results, from the rest.
fn split<T>(points: Vec<Sample<T>>) -> (Vec<Sample<T>>, Vec<Sample<T>>) {
    let (mut front, mut rest): (Vec<Sample<T>>, Vec<Sample<T>>) = (Vec::new(), Vec::new());
    for one in points {
        if front.iter().any(|other| other.judged == one.judged) {
            continue;
        }
        if front.iter().any(|other| other.judged.dominates(&one.judged)) {
            rest.push(one);
            continue;
        }
        rest.extend(front.extract_if(.., |other| one.judged.dominates(&other.judged)));
        front.push(one);
    }
    (front, rest)
}

/// Returns at most [`KEPT_MOST`] points of a front, as far apart as possible: the minimum of each objective, then repeatedly the point
/// farthest from those selected. Objectives are scaled by their ranges.
fn spread<T>(mut front: Vec<Sample<T>>) -> Vec<Sample<T>> {
    if front.len() <= KEPT_MOST {
        return front;
    }
    let count = front[0].judged.objectives.len();
    let value = |at: usize, objective: usize| front[at].judged.objectives[objective];
    let mut taken = Vec::new();
    let mut ranges = Vec::new();
    for objective in 0..count {
        let by = |a: &usize, b: &usize| value(*a, objective).total_cmp(&value(*b, objective));
        let Some((least, most)) = (0..front.len()).min_by(by).zip((0..front.len()).max_by(by))
        else {
            continue;
        };
        ranges.push(value(most, objective) - value(least, objective));
        taken.push(least);
    }
    let distance = |a: usize, b: usize| -> f64 {
        let parts = ranges.iter().enumerate().filter(|(_, range)| **range > 0.0);
        parts.map(|(it, range)| ((value(a, it) - value(b, it)) / range).powi(2)).sum()
    };
    let nearest =
        |at: usize| taken.iter().map(|it| distance(at, *it)).fold(f64::INFINITY, f64::min);
    let mut gaps: Vec<f64> = (0..front.len()).map(nearest).collect();
    while taken.len() < KEPT_MOST {
        let Some(next) = (0..front.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b])) else {
            break;
        };
        taken.push(next);
        for (at, gap) in gaps.iter_mut().enumerate() {
            *gap = gap.min(distance(at, next));
        }
    }
    let mut at = 0;
    front.retain(|_| {
        at += 1;
        taken.contains(&(at - 1))
    });
    front
}

#[cfg(test)]
mod tests;
