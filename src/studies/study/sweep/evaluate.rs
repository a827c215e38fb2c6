//! Evaluation of points: by the contact kernel if quantities and scene allow it, else by a simulation.
//!
//! Each thread has its own evaluator. The result of a point does not depend on earlier points.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::study::compare::{self, Hardware};
use crate::study::context::CancelFlag;
use crate::study::limit;
use crate::study::outcome::{Failure, PointOutcome};
use crate::study::quantities::{Quantity, QuantityFlag, Search};
use crate::study::sweep::Plan;
use crate::study::sweep::kernel::Kernel;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{EndReason, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{self, RunSnapshot, Settings};

/// Results at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Outcome of the run.
    pub outcome: PointOutcome,
    /// Outputs in the order requested; `None` if a quantity does not exist.
    pub values: Vec<Option<f64>>,
    /// Lower bounds of the outputs whose run ended before they were final; empty if there are none.
    pub(super) bounds: Vec<Option<f64>>,
    /// Reason why a quantity that takes many shots does not exist; empty otherwise.
    pub(super) reason: String,
}

impl Point {
    /// Creates the results of a point.
    pub(super) fn new(outcome: PointOutcome, values: impl Iterator<Item = Option<f64>>) -> Self {
        Self { outcome, values: values.collect(), bounds: Vec::new(), reason: String::new() }
    }

    /// Returns the lower bound of an output whose run ended before it was final.
    pub fn bound(&self, output: usize) -> Option<f64> {
        *self.bounds.get(output)?
    }

    /// Returns the reason for a missing result.
    pub fn reason(&self) -> Option<&str> {
        match self.outcome {
            PointOutcome::Failed(failure) => Some(failure.message()),
            PointOutcome::Ended(_) => Some(&*self.reason).filter(|reason| !reason.is_empty()),
        }
    }
}

/// Evaluator of points, one for each thread.
pub struct Evaluator<'p> {
    plan: &'p Plan,
    stop: &'p CancelFlag,
    scene: Arc<Scene>,
    kernel: Option<Kernel>,
    /// Whether an output needs the error estimate.
    estimate: bool,
}

impl<'p> Evaluator<'p> {
    /// Creates an evaluator for a plan. After `stop` is set, the current point ends early and no further one starts.
    pub fn new(plan: &'p Plan, stop: &'p CancelFlag) -> Self {
        let estimate = plan.outputs().iter().any(|output| output.has(QuantityFlag::Estimate));
        Self {
            plan,
            stop,
            scene: Arc::new(plan.base().clone()),
            kernel: Kernel::from_plan(plan),
            estimate,
        }
    }

    /// Evaluates points; returns fewer results if stopped.
    pub fn points(&mut self, points: &[u64]) -> Vec<Point> {
        let mut point = |index: &u64| {
            let by_contact = self.by_contact(*index);
            by_contact.or_else(|| Some(self.one(*index)?.0))
        };
        points.iter().map_while(&mut point).collect()
    }

    /// Evaluates a point by its first contact; `None` if that does not determine it. After a panic the point is simulated.
    fn by_contact(&mut self, index: u64) -> Option<Point> {
        let kernel = self.kernel.as_ref()?;
        self.plan.place(Arc::make_mut(&mut self.scene), index);
        let scene = &self.scene;
        let answer = catch_unwind(AssertUnwindSafe(|| kernel.answer(scene)));
        let (outcome, answer) = answer.ok().flatten()?;
        let values = self.plan.outputs().iter().map(|output| output.of_contact(&answer, scene));
        Some(Point::new(outcome, values))
    }

    /// Simulates a point; also returns its run if it has one. `None` if stopped.
    pub fn one(&mut self, index: u64) -> Option<(Point, Option<Run>)> {
        if self.stop.is_set() {
            return None;
        }
        let (run, found) = match self.run(index) {
            Ok((run, found)) => (Ok(run), found),
            Err(failure) => (Err(failure), Vec::new()),
        };
        let outcome = match &run {
            Ok(run) if run.end == EndReason::Cancelled => {
                if self.stop.is_set() {
                    return None;
                }
                PointOutcome::Failed(Failure::Early(EndReason::StepBudget))
            }
            Ok(run) => PointOutcome::from_run(run),
            Err(failure) => PointOutcome::Failed(*failure),
        };
        let reasons = found.iter().filter_map(|it| it.as_ref().err()).filter(|it| !it.is_empty());
        let reason = reasons.cloned().collect::<Vec<String>>().join("; ");
        let mut values: Vec<Option<f64>> = found.into_iter().map(Result::ok).collect();
        values.resize(self.plan.outputs().len(), None);
        let run = run.ok();
        let bound = |output: &&Quantity| output.lower_bound(run.as_ref()?);
        let mut bounds: Vec<Option<f64>> = self.plan.outputs().iter().map(bound).collect();
        if bounds.iter().all(Option::is_none) {
            bounds = Vec::new();
        }
        Some((Point { outcome, values, bounds, reason }, run))
    }

    /// Runs a point without time series, and returns its quantities if the run is complete.
    fn run(&mut self, index: u64) -> Result<(Run, Vec<Result<f64, String>>), Failure> {
        // The previous run is dropped: the scene is not copied.
        self.plan.place(Arc::make_mut(&mut self.scene), index);
        let (stop, mut steps, most) = (self.stop, 0, self.plan.steps_max);
        let mut observer = |_: &RunSnapshot<'_>| {
            steps += 1;
            if stop.is_set() || most.is_some_and(|most| steps > most) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let outputs = self.plan.outputs();
        let series = outputs.iter().any(|it| it.needs_course());
        let scene = &self.scene;
        let settings = &Settings { series, estimate: self.estimate, ..Settings::BARE };
        let work = || {
            let run = simulate::simulate(scene, settings, &mut observer).ok()?;
            let known = outputs.iter().filter(|_| run.end.is_complete());
            let values = known.map(|it| found(it, &run)).collect();
            Some((run, values))
        };
        // Each point starts anew: a panic has no effect on the next point.
        let done = catch_unwind(AssertUnwindSafe(work)).map_err(|_panic| Failure::Panicked)?;
        done.ok_or(Failure::Refused)
    }
}

/// Returns a quantity of a run; the error is the reason why a search of many shots has no result, empty for other quantities.
fn found(output: &Quantity, run: &Run) -> Result<f64, String> {
    match output.search() {
        Some(Search::Limit) => limit::velocity_m_s(&run.scene),
        Some(Search::Expected(get)) => {
            let expected = Verdict::from_scene(&run.scene).expected;
            expected.map(|it| get(&it)).ok_or_else(|| output.absence.to_owned())
        }
        Some(Search::DesignLimit) => match Verdict::from_scene(&run.scene).expected {
            Some(expected) => Ok(expected.low_m_s),
            None => limit::velocity_m_s(&run.scene),
        },
        Some(Search::LimitIfSpringSurvives) => compare::limit_if_spring_survives_m_s(&run.scene),
        Some(Search::MassEfficiency) => {
            let found = compare::mass_efficiency(&run.scene, Hardware::default());
            found.map_err(|absence| absence.words())
        }
        None => output.value(run).ok_or_else(String::new),
    }
}
