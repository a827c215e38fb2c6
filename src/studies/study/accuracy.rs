//! Error against run time: every method over its steps or tolerances, compared with a reference it shares no code with.
//!
//! The error of a point is the greater of the relative errors of depth and time at the end of the first contact. A method that
//! gives no answer, or a wrong outcome, keeps its row with the reason. Time comes from a clock passed in.

use std::sync::Arc;

use crate::model::contact_phase::{ContactSolution, Ending, Refusal};
use crate::model::scene::Scene;
use crate::model::variables::{self, VariableError};
use crate::numerics::statistics::slope;
use crate::numerics::{larger, smaller};
use crate::study::context::Context;

pub mod method;
pub mod reference;
pub mod timing;

use method::{Job, Ladder, Method, Parameter};
use reference::{Reference, references};
use timing::{Clock, Patience, Timing, time};

/// Fixed-step methods may need this many times the steps of the reference's contact, and this many more.
const STEPS_BEYOND: (f64, f64) = (2.0, 1_000.0);
const STEPS_MAX: usize = 100_000;
/// The observed order is fitted through this many of the finest points (never fewer than the second number)...
const FIT_POINTS: usize = 5;
const FIT_POINTS_MIN: usize = 3;
/// ...or as many as it takes for their steps to differ by this factor...
const FIT_SPAN: f64 = 1.5;
/// ...of those whose error is below this, and above [`FIT_FLOOR`] times what the reference can tell.
const FIT_CEILING: f64 = 0.5;
const FIT_FLOOR: f64 = 10.0;

/// Run times up to this factor apart count as alike.
const ALIKE: f64 = 1.05;

const UNSTEADY: f64 = 0.2;

/// How thorough a comparison is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparisonOptions {
    /// Which values of the parameters.
    pub ladder: Ladder,
    /// How much time each may take.
    pub patience: Patience,
}

impl ComparisonOptions {
    /// A few seconds a scene.
    pub const FULL: Self =
        Self { ladder: Ladder::Full, patience: Patience { point_s: 1.2e-2, slow_s: 8e-2 } };
    /// A fraction of a second a scene.
    pub const QUICK: Self =
        Self { ladder: Ladder::Quick, patience: Patience { point_s: 2e-3, slow_s: 1e-2 } };
}

/// The result of a method for one value of its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The value.
    pub parameter: Parameter,
    /// The result, or why there is none.
    pub result: Result<Measured, Refusal>,
}

/// A judged and timed result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The computed quantity.
    pub answer: ContactSolution,
    /// Relative error of the depth.
    pub depth_error: f64,
    /// Relative error of the time.
    pub time_error: f64,
    /// The uncertainty of the reference.
    pub floor: f64,
    /// How long it took.
    pub timing: Timing,
}

impl Measured {
    /// The greater of both errors, but not less than the reference can tell: what is drawn and compared.
    pub fn error(&self) -> f64 {
        larger(larger(self.depth_error, self.time_error), self.floor)
    }

    /// The error an order shows in: of the depth, unless a perforation fixes it. (The thesis's stopping rule leaves an error of
    /// time that no step makes smaller.)
    fn order_error(&self) -> f64 {
        match self.answer.ending {
            Ending::Arrest => self.depth_error,
            Ending::Perforation => self.time_error,
        }
    }

    /// Whether the error is at or below what the reference can tell.
    pub fn is_at_floor(&self) -> bool {
        self.error() <= self.floor
    }
}

/// A method with its points, the coarsest first.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodReport {
    /// The method.
    pub method: Method,
    /// Its reference; `None` if no independent one could be computed.
    pub reference: Option<Reference>,
    /// Its points.
    pub points: Vec<Point>,
}

/// The comparison for one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The scene.
    pub scene: Arc<Scene>,
    /// All references, the most trustworthy first.
    pub references: Vec<Reference>,
    /// One for each method.
    pub methods: Vec<MethodReport>,
    /// Whether it was stopped before its end.
    pub is_complete: bool,
}

/// The cheapest way to an accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cheapest {
    /// Which method.
    pub method: Method,
    /// With which parameter.
    pub parameter: Parameter,
    /// Least time, s.
    pub min_s: f64,
}

/// Compare all methods on the contact phase of a scene, and show the report as it grows.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn compare(
    scene: &Arc<Scene>,
    effort: ComparisonOptions,
    clock: Clock<'_>,
    context: &mut Context<'_, Report>,
) -> Result<Report, VariableError> {
    variables::validate(scene)?;
    variables::require_single(scene)?;
    variables::require_hydrodynamic(scene)?;
    let references = references(scene);
    let end_s = references.first().map_or(f64::NAN, |reference| reference.answer.t_s);
    let plan: Vec<(Method, Vec<Parameter>)> =
        Method::ALL.map(|method| (method, method.parameters(end_s, effort.ladder))).into();
    context.expect(plan.iter().map(|(_, parameters)| parameters.len()).sum());
    let mut report = Report {
        scene: Arc::clone(scene),
        references: references.clone(),
        methods: Vec::new(),
        is_complete: true,
    };
    for (method, parameters) in plan {
        let independent = |reference: &&Reference| !reference.basis.shares_code_with(method);
        let reference = references.iter().find(independent).copied();
        report.methods.push(MethodReport { method, reference, points: Vec::new() });
        let mut is_slow = false;
        for parameter in parameters {
            report.is_complete = context.show(&report);
            if !report.is_complete {
                break;
            }
            context.count(1);
            let job = Job::new(method, parameter, scene, end_s, steps_max(parameter, end_s));
            let result = match reference {
                None => Err(Refusal::NoReference),
                Some(_) if is_slow => Err(Refusal::TooSlow),
                Some(reference) => {
                    let start = clock();
                    let result = judged(&job, &reference, effort.patience, clock);
                    is_slow = match &result {
                        Ok(measured) => measured.timing.mad_s.is_none(),
                        Err(_) => clock() - start > effort.patience.slow_s,
                    };
                    result
                }
            };
            if let Some(method) = report.methods.last_mut() {
                method.points.push(Point { parameter, result });
            }
        }
    }
    Ok(report)
}

fn steps_max(parameter: Parameter, end_s: f64) -> usize {
    match parameter {
        Parameter::Step(dt_s) => {
            let (times, more) = STEPS_BEYOND;
            let steps = times * end_s / dt_s + more;
            // Ladders end well below the last of these.
            let mut powers = (0..24).map(|bit| 1usize << bit);
            powers.find(|power| *power as f64 > steps).unwrap_or(STEPS_MAX)
        }
        Parameter::None | Parameter::Tolerance(_) => STEPS_MAX,
    }
}

fn judged(
    job: &Job,
    reference: &Reference,
    patience: Patience,
    clock: Clock<'_>,
) -> Result<Measured, Refusal> {
    let answer = job.run()?;
    if answer.ending != reference.answer.ending {
        return Err(Refusal::OtherEnding);
    }
    let (depth_error, time_error) = reference.errors(&answer);
    if !(depth_error.is_finite() && time_error.is_finite()) {
        return Err(Refusal::NonFinite);
    }
    let timing = time(clock, patience, || job.run());
    let floor = reference.uncertainty.unwrap_or(f64::EPSILON);
    Ok(Measured { answer, depth_error, time_error, floor, timing })
}

impl MethodReport {
    /// The points that gave a result.
    pub fn measured(&self) -> impl DoubleEndedIterator<Item = (Parameter, &Measured)> {
        self.points.iter().filter_map(|point| {
            point.result.as_ref().ok().map(|measured| (point.parameter, measured))
        })
    }

    /// The order that is observed: how fast log error falls with log steps, by least squares through the finest points that
    /// lie above what the reference can tell. `None` with fewer than three, or none that differ in their steps.
    pub fn observed_order(&self) -> Option<f64> {
        let points: Vec<(f64, f64)> = self
            .measured()
            .filter(|(_, measured)| {
                let error = measured.order_error();
                error < FIT_CEILING && error > FIT_FLOOR * measured.floor
            })
            .map(|(_, measured)| ((measured.answer.steps as f64).ln(), measured.order_error().ln()))
            .collect();
        // Coarser points come in until the steps differ enough to show a slope: an adaptive method may hardly need more of them.
        let spans = |from: &usize| {
            let steps = points[*from..].iter().map(|point| point.0);
            let least = steps.clone().fold(f64::INFINITY, smaller);
            steps.fold(f64::NEG_INFINITY, larger) - least >= FIT_SPAN.ln()
        };
        let from = (0..=points.len().checked_sub(FIT_POINTS_MIN)?)
            .rev()
            .find(|from| points.len() - from >= FIT_POINTS.min(points.len()) && spans(from))?;
        // An error that grows with the steps shows no order: rounding, in a method that is accurate from its first step on.
        Some(-slope(&points[from..])).filter(|order| *order > -0.5)
    }

    /// The greatest spread of its timings, over their median.
    pub fn spread(&self) -> Option<f64> {
        let spreads = self.measured().filter_map(|(_, measured)| measured.timing.spread());
        spreads.max_by(f64::total_cmp)
    }

    /// The least error reached.
    pub fn least_error(&self) -> Option<f64> {
        self.measured().map(|(_, measured)| measured.error()).min_by(f64::total_cmp)
    }

    /// The cheapest point that meets an accuracy together with all finer ones of this method: a lucky hit does not count.
    pub fn cheapest(&self, target: f64) -> Option<Cheapest> {
        let meeting = self.measured().rev().take_while(|(_, measured)| measured.error() <= target);
        let meeting: Vec<Cheapest> = meeting
            .map(|(parameter, measured)| Cheapest {
                method: self.method,
                parameter,
                min_s: measured.timing.min_s,
            })
            .collect();
        let least_s = meeting.iter().map(|found| found.min_s).min_by(f64::total_cmp)?;
        // Of those that the clock cannot distinguish the coarsest: of a closed form no tolerance is the fastest.
        meeting.into_iter().rev().find(|found| found.min_s <= ALIKE * least_s)
    }
}

impl Report {
    /// The cheapest way to an accuracy by the full simulation: the engine's general path with events and ledger of every law and no
    /// term omitted, also where a closed form or a bound would do. Other methods of the contact alone may be faster.
    pub fn cheapest_in_full(&self, target: f64) -> Option<Cheapest> {
        self.methods.iter().find(|it| it.method == Method::Full)?.cheapest(target)
    }

    /// How many points have timings that spread by more than a fifth: the machine is busy.
    pub fn unsteady(&self) -> usize {
        let measured = self.methods.iter().flat_map(MethodReport::measured);
        measured
            .filter(|(_, it)| it.timing.spread().is_some_and(|spread| spread > UNSTEADY))
            .count()
    }

    /// The cheapest way of all to an accuracy.
    pub fn cheapest(&self, target: f64) -> Option<Cheapest> {
        let each = self.methods.iter().filter_map(|method| method.cheapest(target));
        each.min_by(|a, b| a.min_s.total_cmp(&b.min_s))
    }
}

#[cfg(test)]
mod tests;
