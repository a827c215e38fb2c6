//! Sensitivity study: a result over the range of each variable, the others as in the scene.
//!
//! Points are computed in order of refinement: the ends of each range, then 3, 5, 9 and 17 points. A cancelled study can therefore compare
//! all variables. The study does not depend on files, the terminal or a clock.

use std::fmt;

use crate::study::context::Context;
use crate::study::envelope::Check;
use crate::study::option;
use crate::study::outcome::PointOutcome;
use crate::study::quantities::{Quantity, named};
use crate::study::statistics::{quantile, sorted_by};
use crate::study::sweep::default_axes::{or_usual, thesis_ends};
use crate::study::sweep::{Axis, AxisProblem, Plan, Point, Spacing, StudyError};
use crate::study::validity;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::{self, Allowed, Variable};
use cmra_engine::numerics::{larger, smaller};

/// Default variables of the study: the design variables of the thesis, then its given parameters.
pub const VARIABLES: [&str; 14] =
    ["gamma", "d", "k", "n", "b", "m", "x_stop", "v_i", "m_p", "R", "h", "rho", "S_y", "C_d"];

/// Default output of the study.
pub const OUTPUT: &str = "final_penetration_m";

/// Number of points along the range of a variable.
pub const POINTS: usize = 17;

/// Indices of the points of each refinement; each halves the distance between points.
const ROUNDS: [&[usize]; 5] =
    [&[0, 16], &[8], &[4, 12], &[2, 6, 10, 14], &[1, 3, 5, 7, 9, 11, 13, 15]];

/// Number of refinements before the slopes. Five points are enough to show the shape of a row.
const ROUNDS_BEFORE_SLOPES: usize = 3;

/// Minimum number of points for the interpolation of a row.
const INTERPOLATED_LEAST: usize = 5;

/// Range of a variable that Table 9.2 omits, relative to its value in the scene.
const QUARTER_TO_FOUR: (f64, f64) = (0.25, 4.0);

/// Relative step of a difference quotient: truncation error 1e-6, rounding error 1e-6 for results accurate to 1e-9.
const STEP: f64 = 1e-3;

/// Percentile of all results at which the common scale of the rows ends.
const SCALE_PERCENTILE: f64 = 0.95;

/// Request for a sensitivity study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// Variables and their ranges; empty for [`default_axes`].
    pub over: Vec<Axis>,
    /// Output; `None` for [`OUTPUT`].
    pub output: Option<&'static Quantity>,
}

/// Writes the name and options of the command.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let over: String = self.over.iter().map(|it| option("over", Some(it))).collect();
        let output = option("output", self.output.map(|it| it.name));
        write!(f, "sensitivity{over}{output}")
    }
}

/// Result at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Outcome of the shot.
    pub outcome: PointOutcome,
    /// Value of the output; for a perforation, the depth at which the nose is clear of the rear face. `None` if it does not exist.
    pub result: Option<f64>,
}

impl Value {
    fn from_point(point: &Point) -> Self {
        let result = point.values.first().copied().flatten();
        Self { outcome: point.outcome, result: result.filter(|value| value.is_finite()) }
    }
}

/// Effect of one variable on the output.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Variable and its range.
    pub axis: Axis,
    /// Value of the variable in the scene, in the stored unit.
    pub own: Option<f64>,
    /// Results at [`POINTS`] points, evenly spaced on the scale of the axis; `None` if not computed.
    pub points: [Option<Value>; POINTS],
    /// Derivative of the result with respect to the variable at its value in the scene.
    pub slope: Option<f64>,
}

impl Effect {
    /// Returns the number of computed points.
    pub fn computed(&self) -> usize {
        self.points.iter().flatten().count()
    }

    /// Returns `true` if a shot of the row perforates.
    pub fn perforates(&self) -> bool {
        let perforated = PointOutcome::Ended(Outcome::Perforated);
        self.points.iter().flatten().any(|it| it.outcome == perforated)
    }

    /// Interpolates the results linearly at the midpoints of `count` equal parts of the range. A row of fewer than five points has results
    /// only in the parts that contain a point.
    pub fn cells(&self, count: usize) -> Vec<Option<f64>> {
        let place = |at: usize| at as f64 / (POINTS - 1) as f64;
        let known: Vec<(f64, Option<f64>)> = (0..POINTS)
            .filter_map(|at| Some((place(at), self.points[at].as_ref()?.result)))
            .collect();
        let of = |cell: usize| {
            let (from, to) = (cell as f64 / count as f64, (cell + 1) as f64 / count as f64);
            if known.len() < INTERPOLATED_LEAST {
                let is_in =
                    |fraction: f64| fraction >= from && (fraction < to || cell + 1 == count);
                return known.iter().find(|point| is_in(point.0)).and_then(|point| point.1);
            }
            let middle = 0.5 * (from + to);
            let after = known.partition_point(|point| point.0 < middle);
            let (above, high) = *known.get(after)?;
            if above <= middle {
                return high;
            }
            let (below, low) = known[after.checked_sub(1)?];
            let (low, high) = low.zip(high)?;
            Some(low + (middle - below) / (above - below) * (high - low))
        };
        (0..count).map(of).collect()
    }

    /// Returns the part of the range that contains the scene's value; `None` outside the range.
    pub fn own_cell(&self, count: usize) -> Option<usize> {
        let fraction = self.axis.fraction(self.own?)?;
        (1..=count)
            .find(|cell| fraction * (count as f64) < *cell as f64)
            .or(Some(count))
            .map(|it| it - 1)
    }
}

/// Result of a sensitivity study; may be partial.
#[derive(Clone, Debug)]
pub struct SensitivityReport {
    /// Output of the study.
    pub output: &'static Quantity,
    /// Result of the unchanged scene.
    pub own: Option<Value>,
    /// Effects, in the order of the request.
    pub effects: Vec<Effect>,
    /// Validity checks that fail at an end of a range but not for the scene itself, each with its warning.
    pub outside_at_ends: Vec<(Check, Warning)>,
}

impl SensitivityReport {
    /// Returns the result of the unchanged scene.
    pub fn own_result(&self) -> Option<f64> {
        self.own?.result
    }

    /// Iterates over the results of a row that exist: at the points from the low end to the high end, then of the scene itself if its value is
    /// within. The scene alone is no row: before the first point there are none.
    pub fn results(&self, effect: &Effect) -> impl Iterator<Item = f64> {
        let is_row = effect.computed() > 0 && effect.own_cell(1).is_some();
        let own = self.own_result().filter(|_| is_row);
        effect.points.iter().flatten().filter_map(|it| it.result).chain(own)
    }

    /// Returns the minimum and maximum result of a row; `None` without results.
    pub fn range(&self, effect: &Effect) -> Option<(f64, f64)> {
        let least = self.results(effect).reduce(smaller)?;
        Some((least, self.results(effect).reduce(larger)?))
    }

    /// Returns the difference between the maximum and minimum result of a row.
    pub fn swing(&self, effect: &Effect) -> Option<f64> {
        self.range(effect).map(|(least, greatest)| greatest - least)
    }

    /// Returns `true` if the output exists at no point.
    pub fn is_empty(&self) -> bool {
        self.effects.iter().all(|effect| self.results(effect).next().is_none())
    }

    /// Returns the indices of the effects, sorted by decreasing difference.
    pub fn order(&self) -> Vec<usize> {
        let swing = |at: usize| self.swing(&self.effects[at]).unwrap_or(-1.0);
        sorted_by((0..self.effects.len()).collect(), |at| -swing(*at))
    }

    /// Returns the upper end of the common scale of all rows, which starts at zero: the 95th percentile of all results.
    pub fn scale(&self) -> Option<f64> {
        let sizes = self.effects.iter().flat_map(|effect| self.results(effect)).map(f64::abs);
        let sorted = sorted_by(sizes.collect::<Vec<f64>>(), |size| *size);
        (!sorted.is_empty()).then(|| quantile(&sorted, SCALE_PERCENTILE)).filter(|top| *top > 0.0)
    }

    /// Returns the effect of a variable, by its symbol.
    pub fn effect(&self, symbol: &str) -> Option<&Effect> {
        self.effects.iter().find(|effect| effect.axis.symbol() == symbol)
    }

    /// Returns the smallest number of computed points of a row.
    pub fn points_least(&self) -> usize {
        self.effects.iter().map(Effect::computed).min().unwrap_or(0)
    }
}

/// Returns the range of a variable: that of Table 9.2, else 0.25 to 4 times its value, spaced geometrically. `None` if the scene ignores
/// the variable, or without a range.
pub fn range(scene: &Scene, variable: &Variable) -> Option<Axis> {
    let number = variable.number()?;
    let own = (number.get)(scene)?;
    if !variables::is_used(variable, scene) || variables::overrules_size(variable, scene) {
        return None;
    }
    let axis = if let Some(ends) = thesis_ends(scene, variable) {
        Axis::new(variable.symbol, ends, 2, Spacing::Linear)
    } else {
        let high = match number.allowed {
            Allowed::Between(_, most) => smaller(QUARTER_TO_FOUR.1 * own, most),
            _ => QUARTER_TO_FOUR.1 * own,
        };
        Axis::new(variable.symbol, (QUARTER_TO_FOUR.0 * own, high), 2, Spacing::Log)
    };
    let axis = axis.ok()?;
    Plan::for_designs(scene, vec![axis.clone()], &[OUTPUT]).is_ok().then_some(axis)
}

/// Returns the ranges of the [`VARIABLES`] that the scene uses.
pub fn default_axes(scene: &Scene) -> Vec<Axis> {
    let named = VARIABLES.iter().filter_map(|symbol| variables::find(symbol).ok());
    named.filter_map(|variable| range(scene, variable)).collect()
}

/// Computes the effects, and the validity checks at the ends of the ranges.
///
/// # Errors
/// Returns a [`StudyError`] for invalid variables or output, before any run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, SensitivityReport>,
) -> Result<SensitivityReport, StudyError> {
    let mut report = compute(scene, request, context)?;
    let axes: Vec<Axis> = report.effects.iter().map(|effect| effect.axis.clone()).collect();
    if !context.is_stopped() {
        report.outside_at_ends = validity::new_at_ends(scene, &axes);
    }
    Ok(report)
}

/// Computes the effects without validity checks.
///
/// # Errors
/// As [`run`].
pub fn compute(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, SensitivityReport>,
) -> Result<SensitivityReport, StudyError> {
    let axes = or_usual(&request.over, || Ok(default_axes(scene)))?;
    let output = request.output.map_or_else(|| named(OUTPUT), Ok)?;
    output.check_exists(scene)?;
    for (at, axis) in axes.iter().enumerate() {
        if axes[..at].iter().any(|other| other.symbol() == axis.symbol()) {
            return Err(StudyError::axis(axis.symbol(), AxisProblem::GivenTwice));
        }
    }
    let plan = |axis: &Axis| Plan::for_designs(scene, vec![axis.clone()], &[output.name]);
    let plans: Vec<Plan> = axes.iter().map(plan).collect::<Result<_, _>>()?;
    let effect = |axis: Axis| {
        let own = axis.get(scene);
        Effect { axis, own, points: [None; POINTS], slope: None }
    };
    let effects: Vec<Effect> = axes.into_iter().map(effect).collect();
    let mut report = SensitivityReport { output, own: None, effects, outside_at_ends: Vec::new() };
    context.expect(1 + plans.len() * (POINTS + 2));
    if let Some(plan) = plans.first() {
        let own = plan.evaluate_all(&[plan.design_of(scene)], context);
        report.own = own.first().map(Value::from_point);
    }
    for (number, round) in ROUNDS.iter().enumerate() {
        if number == ROUNDS_BEFORE_SLOPES && !slopes(scene, &plans, &mut report, context) {
            return Ok(report);
        }
        for (plan, effect) in plans.iter().zip(&mut report.effects) {
            let designs: Vec<Vec<f64>> =
                round.iter().map(|at| vec![value_at(&effect.axis, *at)]).collect();
            let found = plan.evaluate_all(&designs, context);
            for (at, point) in round.iter().zip(&found) {
                effect.points[*at] = Some(Value::from_point(point));
            }
            if context.is_stopped() {
                return Ok(report);
            }
        }
        if !context.show(&report) {
            break;
        }
    }
    Ok(report)
}

/// Returns the value of a variable at a point of its range.
fn value_at(axis: &Axis, at: usize) -> f64 {
    let (low, high) = axis.ends();
    match at {
        0 => low,
        _ if at + 1 == POINTS => high,
        _ => axis.at_fraction(at as f64 / (POINTS - 1) as f64),
    }
}

/// Computes the slopes at the scene; returns `false` once cancelled.
fn slopes(
    scene: &Scene,
    plans: &[Plan],
    report: &mut SensitivityReport,
    context: &mut Context<'_, SensitivityReport>,
) -> bool {
    let own_result = report.own_result();
    for (plan, effect) in plans.iter().zip(&mut report.effects) {
        let Some(own) = effect.own else { continue };
        let (low, high) = effect.axis.ends();
        let size = if own == 0.0 { (high - low).abs() } else { own.abs() };
        let step = STEP * size;
        let is_allowed = |value: f64| {
            let mut other = scene.clone();
            effect.axis.set(&mut other, value);
            variables::validate(&other).is_ok()
        };
        // At the end of the allowed range all points lie on one side.
        let (is_below, is_above) = (is_allowed(own - step), is_allowed(own + step));
        let places = match (is_below, is_above) {
            (true, true) => [own - step, own + step],
            (false, true) => [own + step, own + 2.0 * step],
            (true, false) => [own - step, own - 2.0 * step],
            (false, false) => continue,
        };
        let found = plan.evaluate_all(&places.map(|value| vec![value]), context);
        let value = |at: usize| found.get(at).and_then(|point| Value::from_point(point).result);
        effect.slope =
            value(0).zip(value(1)).zip(own_result).map(|((first, second), own)| {
                match (is_below, is_above) {
                    (true, true) => (second - first) / (2.0 * step),
                    (false, _) => (4.0 * first - second - 3.0 * own) / (2.0 * step),
                    (true, false) => (3.0 * own - 4.0 * first + second) / (2.0 * step),
                }
            });
        if context.is_stopped() {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests;
