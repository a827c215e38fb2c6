//! Error against run time: every method over its steps or tolerances, compared with a reference.
//!
//! The error of a point is the greatest of the errors of its results, those of the whole run: depth, time, greatest displacement, peak
//! force and residual velocity. A method that gives no answer, or a wrong outcome, keeps its row with the reason. The printed scheme
//! of the thesis is compared with its own limit: what is left then is the error of its step. Time comes from a clock passed in.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::context::Context;
use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::{self, VariableError};
use cmra_engine::numerics::larger;

pub mod method;
pub mod reference;
pub mod timing;

pub use method::RESULTS;
use method::{Answer, Job, Method, Parameter, Refusal, Results, SettingGrid};
use reference::{Reference, References, printed_limit};
use timing::{Clock, time};

/// From here on the printed scheme is another model; a rigid mount and a perforation, whose depth is no measure, hide its fault.
const PRINTED_OFF_FROM: f64 = 1e-3;
/// Run times up to this factor apart count as alike.
const ALIKE: f64 = 1.05;

/// How thorough a comparison is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparisonOptions {
    /// Grid of step sizes or tolerances.
    pub ladder: SettingGrid,
    /// For how long one point is repeated at most, beyond a few batches, s.
    pub point_s: f64,
    /// Evaluations of the equations by a point after which finer ones of its method are not run.
    pub evaluations: usize,
}

impl ComparisonOptions {
    /// A few seconds a scene; most where methods give up.
    pub const FULL: Self =
        Self { ladder: SettingGrid::Full, point_s: 1.2e-2, evaluations: 300_000 };
    /// A fraction of a second a scene, or seconds where methods give up.
    pub const QUICK: Self = Self { ladder: SettingGrid::Quick, point_s: 2e-3, evaluations: 40_000 };
}

/// The command's name and options.
impl fmt::Display for ComparisonOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::QUICK { "accuracy --quick" } else { "accuracy" })
    }
}

/// The result of a method for one value of its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The value.
    pub parameter: Parameter,
    /// The result, or why there is none.
    pub result: Result<Measured, Refusal>,
}

/// A compared and timed result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The computed results.
    pub answer: Answer,
    /// Errors of the results; `None` of what it has not.
    pub errors: Results,
    /// The uncertainty of the reference.
    pub floor: f64,
    /// Least run time, s.
    pub min_s: f64,
}

impl Measured {
    /// The greatest of its errors, but not less than the reference can tell: what is drawn and compared. The mount's greatest force
    /// lies within a step, where DOP853 is less accurate than at its ends: by that a reference tells less than by the others.
    pub fn error(&self) -> f64 {
        let [results @ .., _mount_force] = self.errors;
        results.into_iter().flatten().fold(self.floor, larger)
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
    /// Reference results; `None` if no independent one could be computed.
    pub reference: Option<Reference>,
    /// Points of the method, coarse to fine.
    pub points: Vec<Point>,
}

/// The comparison for one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct AccuracyReport {
    /// The scene.
    pub scene: Arc<Scene>,
    /// Reference results of the scene.
    pub references: References,
    /// Reports of the methods.
    pub methods: Vec<MethodReport>,
    /// How far the depth that the printed scheme approaches is off, relative: an error of that model, not of its step.
    pub printed_off: Option<f64>,
    /// The run time of a run as it is shown, with its series and its error estimate, s.
    pub run_s: Option<f64>,
    /// The gain from omitted terms.
    pub savings: Vec<OmissionGain>,
}

/// A part of a run with the time it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OmissionGain {
    /// The part.
    pub part: &'static str,
    /// Least run time with it, s.
    pub with_s: f64,
    /// Least run time without it, s.
    pub without_s: f64,
}

/// The cheapest way to an accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cheapest {
    /// Method of the job.
    pub method: Method,
    /// With which parameter.
    pub parameter: Parameter,
    /// Least time, s.
    pub min_s: f64,
}

/// Compares all methods on a scene, and shows the report as it grows.
pub fn compare(
    scene: &Arc<Scene>,
    effort: ComparisonOptions,
    clock: Clock<'_>,
    context: &mut Context<'_, AccuracyReport>,
) -> Result<AccuracyReport, VariableError> {
    variables::validate(scene)?;
    variables::require_single(scene)?;
    variables::require_hydrodynamic(scene)?;
    let references = References::from_scene(scene);
    let end_s = references.any().map_or(f64::NAN, |reference| reference.end_s());
    let plan: Vec<(Method, Vec<Parameter>)> =
        Method::ALL.map(|method| (method, method.parameters(end_s, effort.ladder))).into();
    context.expect(plan.iter().map(|(_, parameters)| parameters.len()).sum());
    let printed = printed_limit(scene, end_s);
    let printed_off = printed.zip(references.any()).and_then(|(limit, right)| {
        right.errors(scene, &limit.results)[0].filter(|off| *off > PRINTED_OFF_FROM)
    });
    let mut report = AccuracyReport {
        scene: Arc::clone(scene),
        references,
        methods: Vec::new(),
        printed_off,
        run_s: None,
        savings: Vec::new(),
    };
    for (method, parameters) in plan {
        let reference = match method {
            Method::ThesisPrinted => printed,
            _ if method.has_own_steps() => references.other,
            _ => references.engine,
        };
        report.methods.push(MethodReport { method, reference, points: Vec::new() });
        let mut is_costly = false;
        for parameter in parameters {
            if !context.show(&report) {
                break;
            }
            context.count(1);
            let job = Job::new(method, parameter, scene);
            let result = match reference {
                None => Err(job.run().err().unwrap_or(Refusal::NoReference)),
                Some(_) if is_costly => Err(Refusal::TooMuchWork),
                Some(reference) => {
                    let result = measure(scene, &job, &reference, effort.point_s, clock);
                    let work = result.map_or(0, |measured| measured.answer.evaluations);
                    is_costly = work > effort.evaluations;
                    result
                }
            };
            if let Some(method) = report.methods.last_mut() {
                method.points.push(Point { parameter, result });
            }
        }
    }
    if !context.is_stopped() {
        (report.run_s, report.savings) = savings(scene, effort.point_s, clock);
        context.show(&report);
    }
    Ok(report)
}

/// The run time of a run as it is shown, and what is saved by leaving out its parts one after the other.
fn savings(scene: &Arc<Scene>, point_s: f64, clock: Clock<'_>) -> (Option<f64>, Vec<OmissionGain>) {
    let run = |settings: Settings| simulate(scene, &settings, &mut |_| ControlFlow::Continue(()));
    let tolerance = scene.run.tolerance;
    let kernel = Job::new(Method::ContactKernel, Parameter::Tolerance(tolerance), scene);
    let [shown_s, drawn_s, bare_s] = [Settings::default(), Settings::SERIES, Settings::BARE]
        .map(|settings| run(settings).is_ok().then(|| time(clock, point_s, || run(settings))));
    // The same engine with and without it.
    let ways = [
        IntegrationMethod::CollocationInFull(tolerance),
        IntegrationMethod::Collocation(tolerance),
    ];
    let [followed_s, by_energy_s] = ways.map(|way| {
        let run = || step_by(way, scene);
        run().is_ok_and(|run| run.is_some()).then(|| time(clock, point_s, run))
    });
    let kernel_s = kernel.run().is_ok().then(|| time(clock, point_s, || kernel.run()));
    let savings = [
        ("error estimate", shown_s, drawn_s),
        ("series to draw", drawn_s, bare_s),
        ("way to the greatest displacement", followed_s, by_energy_s),
        ("motion after the contact", bare_s, kernel_s),
    ];
    let saving = |(part, with_s, without_s): (&'static str, Option<f64>, Option<f64>)| {
        Some(OmissionGain { part, with_s: with_s?, without_s: without_s? })
    };
    (shown_s, savings.into_iter().filter_map(saving).collect())
}

fn measure(
    scene: &Scene,
    job: &Job,
    reference: &Reference,
    point_s: f64,
    clock: Clock<'_>,
) -> Result<Measured, Refusal> {
    let answer = job.run()?;
    if answer.outcome != reference.outcome {
        return Err(Refusal::OtherOutcome);
    }
    let errors = reference.errors(scene, &answer.results);
    if errors.iter().flatten().any(|error| !error.is_finite()) {
        return Err(Refusal::NonFinite);
    }
    let min_s = time(clock, point_s, || job.run());
    let floor = reference.uncertainty.unwrap_or(f64::EPSILON);
    Ok(Measured { answer, errors, floor, min_s })
}

impl MethodReport {
    /// The points that gave a result.
    pub fn measured(&self) -> impl DoubleEndedIterator<Item = (Parameter, &Measured)> {
        self.points.iter().filter_map(|point| {
            point.result.as_ref().ok().map(|measured| (point.parameter, measured))
        })
    }

    /// Why points have no result, each reason with its points.
    pub fn refusals(&self) -> Vec<(&'static str, Vec<Parameter>)> {
        let mut reasons: Vec<(&str, Vec<Parameter>)> = Vec::new();
        for Point { parameter, result } in &self.points {
            let Err(refusal) = result else { continue };
            match reasons.iter_mut().find(|(words, _)| *words == refusal.message()) {
                Some((_, parameters)) => parameters.push(*parameter),
                None => reasons.push((refusal.message(), vec![*parameter])),
            }
        }
        reasons
    }

    /// The least error reached.
    pub fn min_error(&self) -> Option<f64> {
        self.measured().map(|(_, measured)| measured.error()).min_by(f64::total_cmp)
    }

    /// The cheapest point that meets an accuracy together with all finer ones of this method: a lucky hit does not count.
    pub fn cheapest(&self, target: f64) -> Option<Cheapest> {
        let meeting = self.measured().rev().take_while(|(_, measured)| measured.error() <= target);
        let meeting: Vec<Cheapest> = meeting
            .map(|(parameter, measured)| Cheapest {
                method: self.method,
                parameter,
                min_s: measured.min_s,
            })
            .collect();
        let least_s = meeting.iter().map(|found| found.min_s).min_by(f64::total_cmp)?;
        // Of those that the clock cannot distinguish the coarsest: of a closed form no tolerance is the fastest.
        meeting.into_iter().rev().find(|found| found.min_s <= ALIKE * least_s)
    }
}

impl AccuracyReport {
    /// The cheapest way to an accuracy that a scene can be run by: that of `auto`, at a tolerance that is not looser. A looser one may
    /// happen to be as accurate here, and promises nothing of another scene, or of results that are not compared.
    pub fn usable(&self, target: f64) -> Option<Cheapest> {
        let mut auto = self.methods.iter().find(|it| it.method == Method::Auto)?.clone();
        auto.points.retain(|it| it.parameter.value() <= target);
        auto.cheapest(target)
    }

    /// The cheapest way of all to an accuracy; the printed scheme is no way to one.
    pub fn cheapest(&self, target: f64) -> Option<Cheapest> {
        let methods = self.methods.iter().filter(|it| it.method != Method::ThesisPrinted);
        let each = methods.filter_map(|method| method.cheapest(target));
        each.min_by(|a, b| a.min_s.total_cmp(&b.min_s))
    }
}

#[cfg(test)]
mod tests;
