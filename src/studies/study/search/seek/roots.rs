//! All points in [0, 1] at which a function takes a given value; the function may be discontinuous, or undefined in places.
//!
//! A scan brackets the crossings. The boundaries of intervals without a value are located by bisection: a crossing between the last point
//! of the scan and the boundary is thus found. Each bracket is reduced by the Illinois method, safeguarded by bisection.

use crate::study::search::seek::{Kind, SamplePoint};
use crate::study::statistics::sorted_by;

/// Number of bisections for the boundary of an interval without a value: its error is 2e-13 of the spacing of the scan.
const EDGE_STEPS: usize = 42;
/// Maximum number of iterations for a bracket.
const ROUNDS: usize = 120;
/// Width of a bracket at which the iteration stops, relative to the interval; a few units in the last place.
const WIDTH: f64 = 1e-15;
/// Tolerance of a solution, relative to the goal or to the range of values; far above the numerical error of a run.
const NEAR: f64 = 1e-7;
/// Maximum number of boundaries that are located; a function with more gaps is not worth the runs.
const EDGES_MAX: usize = 64;

/// Function, called with many points: an element is `None` without a value, the whole result is `None` if the search was stopped.
pub type Function<'a> = &'a mut dyn FnMut(&[f64]) -> Option<Vec<Option<f64>>>;

/// Error of a stopped search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

/// Crossing of the goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Kind: solution or jump.
    pub kind: Kind,
    /// Position; for a solution the end of the bracket closer to the goal, or the start of an interval whose points all have the goal's value.
    pub from: SamplePoint,
    /// Other end of the bracket or interval.
    pub to: SamplePoint,
}

/// State of a search.
pub struct RootScan<'f> {
    target: f64,
    function: Function<'f>,
    /// Crossings in order of position.
    pub crossings: Vec<Crossing>,
    /// All points with a value.
    pub seen: Vec<SamplePoint>,
    /// Points of the scan.
    pub scan: Vec<(f64, Option<f64>)>,
    spread: f64,
    /// Number of boundaries located.
    edges: usize,
}

impl<'f> RootScan<'f> {
    /// Creates a search for the points at which the function equals `target`.
    pub fn new(target: f64, function: Function<'f>) -> Self {
        let (crossings, seen, scan) = (Vec::new(), Vec::new(), Vec::new());
        Self { target, function, crossings, seen, scan, spread: 0.0, edges: 0 }
    }

    /// Searches with a scan of a given number of points, at least 2.
    ///
    /// # Errors
    /// [`Stopped`]; the results so far are kept.
    pub fn run(&mut self, points: usize) -> Result<(), Stopped> {
        let last = points.max(2) - 1;
        let fractions: Vec<f64> = (0..=last).map(|at| at as f64 / last as f64).collect();
        let values = self.values(&fractions)?;
        self.scan = fractions.into_iter().zip(values).collect();
        let known = || self.scan.iter().filter_map(|point| point.1);
        let (least, most) = known().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), v| {
            (if v < least { v } else { least }, if v > most { v } else { most })
        });
        self.spread = if most > least { most - least } else { 0.0 };
        let stretches = self.stretches()?;
        for stretch in stretches {
            self.along(&stretch)?;
        }
        // Sorted, without repetitions.
        self.crossings = sorted_by(std::mem::take(&mut self.crossings), |it| it.from.at);
        self.crossings.dedup_by(|b, a| a.kind == b.kind && (b.from.at - a.from.at).abs() < 1e-12);
        Ok(())
    }

    fn values(&mut self, fractions: &[f64]) -> Result<Vec<Option<f64>>, Stopped> {
        let values = (self.function)(fractions).ok_or(Stopped)?;
        let known = fractions.iter().zip(&values);
        self.seen.extend(
            known.filter_map(|(at, value)| Some(SamplePoint { at: *at, value: (*value)? })),
        );
        Ok(values)
    }

    /// Evaluates the function at a point; `None` without a value.
    fn look(&mut self, at: f64) -> Result<Option<SamplePoint>, Stopped> {
        let value = self.values(&[at])?.first().copied().flatten();
        Ok(value.map(|value| SamplePoint { at, value }))
    }

    fn off(&self, point: SamplePoint) -> f64 {
        point.value - self.target
    }

    fn near(&self) -> f64 {
        let scale = self.target.abs();
        NEAR * if scale > self.spread { scale } else { self.spread }
    }

    /// Returns the intervals of the scan with values, each extended to its boundaries.
    fn stretches(&mut self) -> Result<Vec<Vec<SamplePoint>>, Stopped> {
        let scan = self.scan.clone();
        let (mut stretches, mut stretch) = (Vec::new(), Vec::new());
        for (index, (at, value)) in scan.iter().enumerate() {
            let Some(value) = *value else { continue };
            let known = SamplePoint { at: *at, value };
            let gap = |index: Option<usize>| {
                let beside = index.and_then(|index| scan.get(index));
                beside.filter(|beside| beside.1.is_none()).map(|beside| beside.0)
            };
            if let Some(gap) = gap(index.checked_sub(1)) {
                stretch.extend(self.edge(known, gap, |_| true)?);
            }
            stretch.push(known);
            if let Some(gap) = gap(index.checked_add(1)) {
                stretch.extend(self.edge(known, gap, |_| true)?);
                stretches.push(std::mem::take(&mut stretch));
            }
        }
        stretches.push(stretch);
        Ok(stretches)
    }

    /// Locates the boundary between a point inside and one without a value, or with a value that does not belong inside; `None` if it is not
    /// beyond the known point, or after [`EDGES_MAX`] boundaries.
    fn edge(
        &mut self,
        known: SamplePoint,
        gap: f64,
        belongs: impl Fn(f64) -> bool,
    ) -> Result<Option<SamplePoint>, Stopped> {
        if self.edges == EDGES_MAX {
            return Ok(None);
        }
        self.edges += 1;
        let (mut inside, mut outside) = (known, gap);
        for _ in 0..EDGE_STEPS {
            let middle = 0.5 * (inside.at + outside);
            match self.look(middle)?.filter(|place| belongs(place.value)) {
                Some(place) => inside = place,
                None => outside = middle,
            }
        }
        Ok((inside.at.to_bits() != known.at.to_bits()).then_some(inside))
    }

    /// Finds the crossings along points that all have values.
    fn along(&mut self, points: &[SamplePoint]) -> Result<(), Stopped> {
        let target = self.target;
        let is_hit = |point: &SamplePoint| point.value - target == 0.0;
        let mut end = 0;
        for alike in points.chunk_by(|a, b| is_hit(a) == is_hit(b)) {
            let first = end;
            end += alike.len();
            if is_hit(&alike[0]) {
                self.hit(points, first, end - 1)?;
            }
        }
        let crosses = |pair: &&[SamplePoint]| self.off(pair[0]) * self.off(pair[1]) < 0.0;
        let brackets: Vec<&[SamplePoint]> = points.windows(2).filter(crosses).collect();
        for pair in brackets {
            self.close(pair[0], pair[1])?;
        }
        Ok(())
    }

    /// Adds the points that have the goal's value, extended to the boundaries if there are several.
    fn hit(&mut self, points: &[SamplePoint], first: usize, last: usize) -> Result<(), Stopped> {
        let (mut from, mut to) = (points[first], points[last]);
        if first < last {
            let target = self.target;
            for (end, beside) in [(&mut from, first.checked_sub(1)), (&mut to, Some(last + 1))] {
                if let Some(beside) = beside.and_then(|at| points.get(at)) {
                    let edge = self.edge(*end, beside.at, |value| value - target == 0.0)?;
                    *end = edge.unwrap_or(*end);
                }
            }
        }
        self.crossings.push(Crossing { kind: Kind::Solution, from, to });
        Ok(())
    }

    /// Reduces a bracket; if the function has no value inside, searches both sides of the gap.
    fn close(&mut self, mut a: SamplePoint, mut b: SamplePoint) -> Result<(), Stopped> {
        let (mut weight_a, mut weight_b) = (1.0, 1.0);
        for round in 0..ROUNDS {
            if (b.at - a.at).abs() <= WIDTH {
                break;
            }
            let (fa, fb) = (weight_a * self.off(a), weight_b * self.off(b));
            let secant = (a.at * fb - b.at * fa) / (fb - fa);
            let inside = (secant - a.at) * (secant - b.at) < 0.0;
            let fraction = if inside && round % 3 != 2 { secant } else { 0.5 * (a.at + b.at) };
            let Some(point) = self.look(fraction)? else {
                return self.around(a, b, fraction);
            };
            let f = self.off(point);
            if f == 0.0 {
                self.crossings.push(Crossing { kind: Kind::Solution, from: point, to: point });
                return Ok(());
            }
            if (f > 0.0) == (fb > 0.0) {
                (b, weight_b, weight_a) = (point, 1.0, 0.5 * weight_a);
            } else {
                (a, weight_a, weight_b) = (point, 1.0, 0.5 * weight_b);
            }
        }
        let (near, far) = if self.off(a).abs() <= self.off(b).abs() { (a, b) } else { (b, a) };
        let kind = if self.off(near).abs() <= self.near() { Kind::Solution } else { Kind::Jump };
        let (from, to) = if kind == Kind::Solution { (near, far) } else { (a, b) };
        self.crossings.push(Crossing { kind, from, to });
        Ok(())
    }

    /// Searches both sides of a point without a value within a bracket.
    fn around(&mut self, a: SamplePoint, b: SamplePoint, hole: f64) -> Result<(), Stopped> {
        for known in [a, b] {
            let edge = self.edge(known, hole, |_| true)?;
            if let Some(edge) = edge.filter(|edge| self.off(*edge) * self.off(known) < 0.0) {
                self.close(known, edge)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(f: impl Fn(f64) -> Option<f64>, target: f64, points: usize) -> Vec<Crossing> {
        let function: Function<'_> =
            &mut |fractions| Some(fractions.iter().map(|s| f(*s)).collect());
        let mut scan = RootScan::new(target, function);
        scan.run(points).unwrap();
        scan.crossings
    }

    fn roots(found: &[Crossing]) -> Vec<f64> {
        found.iter().filter(|it| it.kind == Kind::Solution).map(|it| it.from.at).collect()
    }

    fn assert_roots(found: &[f64], exact: &[f64]) {
        assert_eq!(found.len(), exact.len(), "{found:?} {exact:?}");
        for (found, exact) in found.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-13, "{found} {exact}");
        }
    }

    #[test]
    fn every_crossing_of_a_wave_is_found_once() {
        let pi = std::f64::consts::PI;
        let exact: Vec<f64> = (0..6).map(|n| (f64::from(n) + 1.0 / 6.0) / 5.0).collect();
        let exact: Vec<f64> = exact.into_iter().filter(|s| *s < 1.0).collect();
        // sin(10 pi s - pi/3) = 0 at s = (n + 1/3)/10; take all of them.
        let all: Vec<f64> = (0..10).map(|n| (f64::from(n) + 1.0 / 3.0) / 10.0).collect();
        let found = scan(|s| Some((10.0 * pi * s - pi / 3.0).sin() + 2.0), 2.0, 41);
        assert_roots(&roots(&found), &all);
        // tan-like slopes of one sign only: cos² touches nothing between.
        let half = scan(|s| Some((5.0 * pi * s - pi / 6.0).sin() + 2.0), 2.0, 41);
        assert_roots(&roots(&half), &exact[..5]);
    }

    #[test]
    fn a_jump_and_a_pole_are_not_solutions() {
        let step = scan(|s| Some(if s < 0.3217 { 1.0 } else { 3.0 }), 2.0, 17);
        assert_eq!((step.len(), step[0].kind), (1, Kind::Jump));
        assert!((step[0].from.at - 0.3217).abs() < 1e-13 && (step[0].to.at - 0.3217).abs() < 1e-13);
        let pole = scan(|s| Some(1.0 / (s - 0.4321)), 0.0, 17);
        assert!(pole.iter().all(|it| it.kind == Kind::Jump), "{pole:?}");
    }

    #[test]
    fn a_crossing_between_the_scan_and_an_edge_is_found() {
        // Known only below 0.43; crosses at 0.42, between the points 0.4 and 0.5.
        let known = |s: f64| (s < 0.43).then_some(s);
        assert_roots(&roots(&scan(known, 0.42, 11)), &[0.42]);
        let above = |s: f64| (s > 0.57).then_some(s);
        assert_roots(&roots(&scan(above, 0.58, 11)), &[0.58]);
        // A hole within a bracket: crossing before it, and one that falls into it.
        let hole = |s: f64| (!(0.44..0.46).contains(&s)).then_some(s);
        assert_roots(&roots(&scan(hole, 0.43, 11)), &[0.43]);
        assert!(roots(&scan(hole, 0.45, 11)).is_empty());
        assert!(scan(|_| None, 1.0, 11).is_empty());
    }

    #[test]
    fn points_that_all_have_the_goal_are_one_interval() {
        let plateau = |s: f64| Some(s.clamp(0.2345, 0.6789));
        for (target, ends) in [(0.2345, [0.0, 0.2345]), (0.6789, [0.6789, 1.0])] {
            let found = scan(plateau, target, 17);
            assert_eq!((found.len(), found[0].kind), (1, Kind::Solution), "{found:?}");
            assert!((found[0].from.at - ends[0]).abs() < 1e-13, "{found:?}");
            assert!((found[0].to.at - ends[1]).abs() < 1e-13, "{found:?}");
        }
        let hill = scan(|s| Some((1.0 - s).min(s).min(0.3456)), 0.3456, 17);
        assert!((hill[0].from.at - 0.3456).abs() < 1e-13, "{hill:?}");
        assert!((hill[0].to.at - 0.6544).abs() < 1e-13 && hill.len() == 1, "{hill:?}");
        // One that only touches the goal is a point.
        let peak = scan(|s| Some(-(s - 0.5).abs()), 0.0, 17);
        assert_eq!((peak.len(), peak[0].from, peak[0].to.at), (1, peak[0].to, 0.5));
    }

    #[test]
    fn a_function_full_of_holes_is_searched_to_an_end() {
        let mut looks = 0;
        let function: Function<'_> = &mut |fractions| {
            looks += fractions.len();
            let value = |fraction: &f64| (9e15 * fraction * fraction).sin();
            Some(fractions.iter().map(value).map(|it| (it.abs() > 0.1).then_some(it)).collect())
        };
        RootScan::new(0.0, function).run(41).unwrap();
        assert!(looks < 41 + EDGES_MAX * (EDGE_STEPS + ROUNDS) + 40 * ROUNDS, "{looks}");
    }
}
