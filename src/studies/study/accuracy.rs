//! Error and run time of every method over its step sizes or tolerances.
//!
//! The error of a point is the largest relative error of the results of the whole run: depth, time, maximum displacement, peak force and
//! residual velocity. A method without a result, or with another outcome than the reference, has a row with the reason. The printed scheme
//! of the thesis is compared with its own limit for a vanishing step size: the difference is the error of its step size. Times come from a
//! clock passed by the caller.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::context::Context;
use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::run::RunSnapshot;
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::{self, VariableError};
use cmra_engine::numerics::larger;

pub mod method;
pub mod reference;
pub mod timing;

pub use method::Compared;
use method::{Answer, Job, Method, Parameter, Refusal, Results, SettingGrid};
use reference::{Reference, References, printed_limit};
use timing::{Clock, time};

/// Steps of a reference from which on it asks whether to stop.
const LONG_REFERENCE: u64 = 4096;
/// Relative error above which the printed scheme counts as a different model. A rigid mount hides its error, and a perforation has no
/// depth.
const PRINTED_OFF_FROM: f64 = 1e-3;
/// Ratio of run times up to which they count as equal; about the scatter of timings.
const ALIKE: f64 = 1.05;

/// Effort of a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparisonOptions {
    /// Grid of step sizes or tolerances.
    pub ladder: SettingGrid,
    /// Time limit for the repetitions of one point, beyond the minimum number of batches, s.
    pub point_s: f64,
    /// Number of evaluations of a point above which finer points of its method are skipped.
    pub evaluations: usize,
}

impl ComparisonOptions {
    /// Full comparison: a few seconds for a scene.
    pub const FULL: Self =
        Self { ladder: SettingGrid::Full, point_s: 1.2e-2, evaluations: 300_000 };
    /// Quick comparison: a fraction of a second for most scenes.
    pub const QUICK: Self = Self { ladder: SettingGrid::Quick, point_s: 2e-3, evaluations: 40_000 };
}

/// Formats the command with its options.
impl fmt::Display for ComparisonOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::QUICK { "accuracy --quick" } else { "accuracy" })
    }
}

/// Result of a method for one value of its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Step size or tolerance.
    pub parameter: Parameter,
    /// Result, or the reason for its absence.
    pub result: Result<Measured, Refusal>,
}

/// Result with its errors and its run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Computed results.
    pub answer: Answer,
    /// Errors of the results; `None` for a result that does not exist.
    pub errors: Results,
    /// Uncertainty of the reference.
    pub floor: f64,
    /// Minimum run time, s.
    pub min_s: f64,
}

impl Measured {
    /// Returns the largest error, at least the uncertainty of the reference. The peak mount force is excluded: it occurs within a step,
    /// where the dense output of DOP853 is less accurate than at the ends.
    pub fn error(&self) -> f64 {
        let others = self.errors.known().filter(|it| it.0 != Compared::MountForce);
        others.map(|it| it.1).fold(self.floor, larger)
    }

    /// Returns `true` if the error is at most the uncertainty of the reference.
    pub fn is_at_floor(&self) -> bool {
        self.error() <= self.floor
    }
}

/// Points of a method, coarsest first.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodReport {
    /// Method.
    pub method: Method,
    /// Reference results; `None` if no independent one could be computed.
    pub reference: Option<Reference>,
    /// Points of the method, coarse to fine.
    pub points: Vec<Point>,
}

/// Comparison of all methods on a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct AccuracyReport {
    /// Scene.
    pub scene: Arc<Scene>,
    /// Reference results of the scene.
    pub references: References,
    /// Reports of the methods.
    pub methods: Vec<MethodReport>,
    /// Relative error of the limit of the printed scheme for a vanishing step size: an error of the model, not of the step size.
    pub printed_off: Option<f64>,
    /// Run time with time series and error estimate, s.
    pub run_s: Option<f64>,
    /// The gain from omitted terms.
    pub savings: Vec<OmissionGain>,
}

/// Run time with and without a part of the computation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OmissionGain {
    /// Part of the computation.
    pub part: &'static str,
    /// Minimum run time with the part, s.
    pub with_s: f64,
    /// Minimum run time without the part, s.
    pub without_s: f64,
}

/// Fastest point with a given accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cheapest {
    /// Method.
    pub method: Method,
    /// Step size or tolerance.
    pub parameter: Parameter,
    /// Minimum run time, s.
    pub min_s: f64,
}

/// Compares all methods on a scene and reports partial results.
pub fn compare(
    scene: &Arc<Scene>,
    effort: ComparisonOptions,
    clock: Clock<'_>,
    context: &mut Context<'_, AccuracyReport>,
) -> Result<AccuracyReport, VariableError> {
    variables::validate(scene)?;
    if scene.contact.model == ContactModel::Appendix {
        variables::require_hydrodynamic(scene)?;
    }
    let mut steps = 0_u64;
    let mut observe = context.observer();
    // Only one that takes very long is looked at: the number of points is known after it.
    let patient = &mut |look: &RunSnapshot<'_>| {
        steps += 1;
        if steps > LONG_REFERENCE { observe(look) } else { ControlFlow::Continue(()) }
    };
    let references = References::from_scene(scene, patient);
    drop(observe);
    let end_s = references.any().map_or(f64::NAN, |reference| reference.end_s());
    let mut plan = Method::ALL.map(|method| (method, method.parameters(end_s, effort.ladder)));
    // First the method that runs scenes: its answer is the one that a stopped comparison needs.
    plan.sort_by_key(|(method, _)| *method != Method::Auto);
    context.expect(plan.iter().map(|(_, parameters)| parameters.len()).sum());
    let printed = printed_limit(scene, end_s);
    let printed_off = printed.zip(references.any()).and_then(|(limit, right)| {
        let off = right.errors(scene, &limit.results).get(Compared::Depth);
        off.filter(|off| *off > PRINTED_OFF_FROM)
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
        let at = report.methods.partition_point(|it| (it.method as usize) < method as usize);
        report.methods.insert(at, MethodReport { method, reference, points: Vec::new() });
        let mut is_costly = false;
        for parameter in parameters {
            if !context.show(&report) {
                break;
            }
            context.count(1);
            let job = Job::new(method, parameter, scene);
            let result = match reference {
                _ if is_costly => Err(Refusal::TooMuchWork),
                None => Err(job.run().err().unwrap_or(Refusal::NoReference)),
                Some(reference) => measure(scene, &job, &reference, effort.point_s, clock),
            };
            is_costly |= match result {
                Ok(measured) => measured.answer.evaluations > effort.evaluations,
                // A tighter tolerance takes more evaluations; a shorter fixed step may be what a method lacks.
                Err(refusal) => refusal.is_of_work() && !parameter.is_step(),
            };
            report.methods[at].points.push(Point { parameter, result });
        }
    }
    if !context.is_stopped() {
        (report.run_s, report.savings) = savings(scene, effort.point_s, clock);
        context.show(&report);
    }
    Ok(report)
}

/// Measures the run time with time series and error estimate, and the gain from omitting parts one after the other.
fn savings(scene: &Arc<Scene>, point_s: f64, clock: Clock<'_>) -> (Option<f64>, Vec<OmissionGain>) {
    let run = |settings: Settings| simulate(scene, &settings, &mut |_| ControlFlow::Continue(()));
    let tolerance = scene.run.tolerance;
    let kernel = Job::new(Method::ContactKernel, Parameter::Tolerance(tolerance), scene);
    let [shown_s, drawn_s, bare_s] = [Settings::default(), Settings::SERIES, Settings::BARE]
        .map(|settings| run(settings).is_ok().then(|| time(clock, point_s, || run(settings))));
    // The engine with and without the omitted terms.
    let ways = [
        IntegrationMethod::CollocationInFull(tolerance),
        IntegrationMethod::Collocation(tolerance),
    ];
    let [followed_s, by_energy_s] = ways.map(|way| {
        let run = || step_by(way, scene, &mut |_| ControlFlow::Continue(()));
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
    if errors.known().any(|(_, error)| !error.is_finite()) {
        return Err(Refusal::NonFinite);
    }
    let min_s = time(clock, point_s, || job.run());
    let floor = reference.uncertainty.unwrap_or(f64::EPSILON);
    Ok(Measured { answer, errors, floor, min_s })
}

impl MethodReport {
    /// Returns the points with a result.
    pub fn measured(&self) -> impl DoubleEndedIterator<Item = (Parameter, &Measured)> {
        self.points.iter().filter_map(|point| {
            point.result.as_ref().ok().map(|measured| (point.parameter, measured))
        })
    }

    /// Returns the reasons for missing results, each with its points.
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

    /// Returns the smallest error of all points.
    pub fn min_error(&self) -> Option<f64> {
        self.measured().map(|(_, measured)| measured.error()).min_by(f64::total_cmp)
    }

    /// Returns the fastest point with an accuracy that all finer points of the method also reach; `None` if there is none.
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
        // The coarsest point of those with equal run times: a closed form takes the same time for every tolerance.
        meeting.into_iter().rev().find(|found| found.min_s <= ALIKE * least_s)
    }
}

impl AccuracyReport {
    /// Returns the fastest point of `auto` with an accuracy and a tolerance that is at least as small. A larger tolerance may be accurate
    /// enough by chance, but not for other scenes or other results.
    pub fn usable(&self, target: f64) -> Option<Cheapest> {
        let mut auto = self.methods.iter().find(|it| it.method == Method::Auto)?.clone();
        auto.points.retain(|it| it.parameter.value() <= target);
        auto.cheapest(target)
    }

    /// Returns the fastest point of all methods with an accuracy, without the printed scheme.
    pub fn cheapest(&self, target: f64) -> Option<Cheapest> {
        let methods = self.methods.iter().filter(|it| it.method != Method::ThesisPrinted);
        let each = methods.filter_map(|method| method.cheapest(target));
        each.min_by(|a, b| a.min_s.total_cmp(&b.min_s))
    }
}

#[cfg(test)]
mod tests;
