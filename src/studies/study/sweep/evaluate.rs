//! The outputs at a point: by the contact kernel where outputs and scene allow it, else by the simulation.
//!
//! An evaluator belongs to one thread. No digit of a point depends on the points before it.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::study::compare::{self, Hardware, WIDTH};
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

/// The results at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Outcome of the point's run.
    pub outcome: PointOutcome,
    /// Outputs in the order requested; `None` if a quantity does not exist.
    pub values: Vec<Option<f64>>,
    /// Why one that takes many shots does not exist.
    reason: String,
}

impl Point {
    /// With these outputs.
    pub(super) fn new(outcome: PointOutcome, values: impl Iterator<Item = Option<f64>>) -> Self {
        Self { outcome, values: values.collect(), reason: String::new() }
    }

    /// Why it has no result, or lacks one that takes many shots.
    pub fn reason(&self) -> Option<&str> {
        match self.outcome {
            PointOutcome::Failed(failure) => Some(failure.message()),
            PointOutcome::Ended(_) => Some(&*self.reason).filter(|reason| !reason.is_empty()),
        }
    }
}

/// Computes points; one for each thread.
pub struct Evaluator<'p> {
    plan: &'p Plan,
    stop: &'p CancelFlag,
    scene: Arc<Scene>,
    kernel: Option<Kernel>,
    settings: Settings,
}

impl<'p> Evaluator<'p> {
    /// An evaluator for a plan; once `stop` is set, the point under way ends early and the rest are not begun.
    pub fn new(plan: &'p Plan, stop: &'p CancelFlag) -> Self {
        let estimate = plan.outputs().iter().any(|output| output.has(QuantityFlag::Estimate));
        Self {
            plan,
            stop,
            scene: Arc::new(plan.base().clone()),
            kernel: Kernel::from_plan(plan),
            settings: Settings { estimate, ..Settings::BARE },
        }
    }

    /// The results at some points; at fewer when it was stopped.
    pub fn points(&mut self, points: &[u64]) -> Vec<Point> {
        let mut point = |index: &u64| {
            let by_contact = self.by_contact(*index);
            by_contact.or_else(|| Some(self.one(*index)?.0))
        };
        points.iter().map_while(&mut point).collect()
    }

    /// A point that its first contact decides. Where that panics the point is simulated: its run fails by itself.
    fn by_contact(&mut self, index: u64) -> Option<Point> {
        let kernel = self.kernel.as_ref()?;
        self.plan.place(Arc::make_mut(&mut self.scene), index);
        let scene = &self.scene;
        let answer = catch_unwind(AssertUnwindSafe(|| kernel.answer(scene)));
        let (outcome, answer) = answer.ok().flatten()?;
        let values = self.plan.outputs().iter().map(|output| output.of_contact(&answer, scene));
        Some(Point::new(outcome, values))
    }

    /// The full simulation of a point, and its run where it has one; `None` when it was stopped.
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
        Some((Point { outcome, values, reason }, run.ok()))
    }

    /// The full simulation of a point, without a series, and its outputs where it came to its end.
    fn run(&mut self, index: u64) -> Result<(Run, Vec<Result<f64, String>>), Failure> {
        // The last run's scene is gone by now, so nothing is copied.
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
        let (scene, settings) = (&self.scene, &Settings { series, ..self.settings });
        let work = || {
            let run = simulate::simulate(scene, settings, &mut observer).ok()?;
            let known = outputs.iter().filter(|_| run.end.is_complete());
            let values = known.map(|it| found(it, &run)).collect();
            Some((run, values))
        };
        // Each point begins again, so a panic at one leaves nothing behind for the next.
        let done = catch_unwind(AssertUnwindSafe(work)).map_err(|_panic| Failure::Panicked)?;
        done.ok_or(Failure::Refused)
    }
}

/// An output of a run; why not, where a search with many shots does not give it, and empty where there is nothing to say.
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
            let found = compare::mass_efficiency(&run.scene, Hardware::default(), WIDTH);
            found.map_err(|absence| absence.words.to_owned())
        }
        None => output.value(run).ok_or_else(String::new),
    }
}
