//! The Pareto front of a scene: the designs that no other dominates, under constraints, on the scene's interface law. With one
//! objective the best design. Must not know files, screens or a clock.

use std::fmt;
use std::ops::RangeInclusive;

use crate::study::context::Context;
use crate::study::option;
use crate::study::quantities::{Quantity, named};
use crate::study::search::sampling::{self, Evaluation, Sample};
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::default_axes::{or_usual, thesis_axes};
use crate::study::sweep::{Axis, Failure, Plan, Point, PointOutcome, SweepError};
use crate::study::validity::{self, DesignValidity, Plastic};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::EndReason;
use cmra_engine::model::run::envelope::Check;
use cmra_engine::model::scene::Scene;
use cmra_engine::numerics::larger;
use cmra_engine::numerics::statistics::sorted_by;
pub use constraint::Constraint;

mod constraint;

/// The objectives where none is named: depth, stroke, mass and force into the mount.
pub const DEFAULT: [&str; 4] =
    ["final_penetration_m", "stroke_m", "system_mass_kg", "peak_mount_force_n"];

/// How many designs may be tried, and how many are where nothing is said.
pub const SAMPLES: RangeInclusive<usize> = 64..=1 << 24;
const DEFAULT_SAMPLES: usize = 1 << 14;
/// Steps after which the run of a design is given up: a hundred times as many as most take.
pub const STEPS_MAX: usize = 30_000;

/// A measure that is to be small, or great.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Objective {
    /// The measure.
    pub measure: &'static Quantity,
    /// Great is good.
    pub maximise: bool,
}

impl Objective {
    /// Builds an objective from the name of its measure.
    pub fn new(name: &str, maximise: bool) -> Result<Self, SweepError> {
        Ok(Self { measure: named(name)?, maximise })
    }

    /// [`DEFAULT`], each to be small.
    pub fn usual() -> Vec<Self> {
        DEFAULT.iter().filter_map(|name| Self::new(name, false).ok()).collect()
    }
}

/// Request for a Pareto front.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The variables and their bounds; empty: those of [`thesis_axes`].
    pub over: Vec<Axis>,
    /// The objectives.
    pub objectives: Vec<Objective>,
    /// The constraints.
    pub subject_to: Vec<Constraint>,
    /// Only designs count that stop the shot, and whose run has no warning on the unsafe side.
    pub is_feasible: bool,
    /// Designs to try.
    pub samples: usize,
}

impl Default for Request {
    fn default() -> Self {
        let objectives = Objective::usual();
        Self {
            over: Vec::new(),
            subject_to: default_bounds(&objectives),
            objectives,
            is_feasible: true,
            samples: DEFAULT_SAMPLES,
        }
    }
}

/// The constraints where none is named: on the stroke, where that is to be small; without, some designs have a stroke of kilometres.
pub fn default_bounds(objectives: &[Objective]) -> Vec<Constraint> {
    let stroke = objectives.iter().find(|it| it.measure.name == "stroke_m" && !it.maximise);
    let bound = |it: &Objective| Constraint { measure: it.measure, at_most: true, bound: 1.0 };
    stroke.map(bound).into_iter().collect()
}

/// The command's name and options.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let over: String = self.over.iter().map(|it| option("over", Some(it))).collect();
        let is_named = self.objectives != Objective::usual();
        let [minimise, maximise] =
            [("minimise", false), ("maximise", true)].map(|(name, great)| {
                let those = self.objectives.iter().filter(|it| it.maximise == great);
                let names: Vec<&str> = those.map(|it| it.measure.name).collect();
                option(name, (is_named && !names.is_empty()).then(|| names.join(",")))
            });
        let bounds: Vec<String> = self.subject_to.iter().map(ToString::to_string).collect();
        let bounds = match &bounds[..] {
            [] => "none".to_owned(),
            bounds => format!("'{}'", bounds.join(",")),
        };
        let is_bound = self.subject_to != default_bounds(&self.objectives);
        let bounds = option("subject-to", is_bound.then_some(bounds));
        let feasible = if self.is_feasible { "" } else { " --no-feasibility" };
        let samples = option("samples", Some(self.samples).filter(|it| *it != DEFAULT_SAMPLES));
        write!(f, "optimise{over}{minimise}{maximise}{bounds}{feasible}{samples}")
    }
}

impl Request {
    /// Every measure that is needed, the objectives first, each once.
    pub fn measures(&self) -> Vec<&'static Quantity> {
        let all = self.objectives.iter().map(|it| it.measure);
        let mut list: Vec<&'static Quantity> = Vec::new();
        for measure in all.chain(self.subject_to.iter().map(|it| it.measure)) {
            if !list.contains(&measure) {
                list.push(measure);
            }
        }
        list
    }
}

/// A design.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// The variables, in their stored units.
    pub values: Vec<f64>,
    /// Measures, in the order of [`Request::measures`].
    pub measures: Vec<Option<f64>>,
    /// Outcome of the design's run.
    pub outcome: PointOutcome,
    /// First objective with a plastic interface, if the fused one cannot carry its load.
    pub plastic: Option<Plastic>,
}

/// Designs without a value of an objective, which cannot be on a front.
#[derive(Clone, Debug, PartialEq)]
pub struct MissingObjective {
    /// The objective's measure.
    pub measure: &'static Quantity,
    /// The outcome of these designs.
    pub outcome: PointOutcome,
    /// How many they are.
    pub count: usize,
}

/// The front.
#[derive(Clone, Debug, Default)]
pub struct FrontReport {
    /// Request, with the variables that were varied.
    pub request: Request,
    /// The scene whose other variables were held.
    pub base: Scene,
    /// The designs, by the first objective.
    pub designs: Vec<Design>,
    /// How many of the designs are outside the model's validity, by check.
    pub outside: Vec<(Check, usize)>,
    /// Designs tried.
    pub runs: usize,
    /// Runs stopped after [`STEPS_MAX`] steps.
    pub given_up: usize,
    /// Runs that had no value of an objective.
    pub lacks: Vec<MissingObjective>,
    /// Runs that were infeasible, by check.
    pub infeasible: Vec<(Check, usize)>,
    /// Runs that were infeasible because the plate is not known to stop the shot.
    pub unstopped: usize,
}

impl FrontReport {
    /// The scene of one of its designs.
    pub fn scene(&self, design: &Design) -> Scene {
        scene_with(&self.base, &self.request.over, &design.values)
    }
}

/// Looks for the front, and shows it as it grows.
///
/// # Errors
/// A [`SweepError`] when bounds, names or the scene make no sense: then nothing has run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, FrontReport>,
) -> Result<FrontReport, SweepError> {
    let over = or_usual(&request.over, || thesis_axes(scene))?;
    let mut request = Request { over, ..request.clone() };
    for objective in &mut request.objectives {
        objective.measure = objective.measure.design_quantity(scene);
    }
    for constraint in &mut request.subject_to {
        constraint.measure = constraint.measure.design_quantity(scene);
    }
    let names: Vec<&str> = request.measures().iter().map(|measure| measure.name).collect();
    let plan = Plan::for_designs(scene, request.over.clone(), &names)?.limited(STEPS_MAX);
    context.expect(request.samples);
    let known =
        DesignValidity::from_run(scene, request.objectives[0].measure, &[], &mut || true).fails;
    let front = FrontReport { request, base: scene.clone(), ..FrontReport::default() };
    Ok(Search { plan, known, front }.run(context))
}

struct Search {
    plan: Plan,
    /// The checks that the scene itself fails.
    known: Vec<Check>,
    front: FrontReport,
}

impl Search {
    fn run(mut self, context: &mut Context<'_, FrontReport>) -> FrontReport {
        let (inputs, samples) = (self.plan.axes().len(), self.front.request.samples);
        // The scene itself is tried, where the bounds hold it.
        let share = |axis: &Axis| axis.share(axis.get(&self.front.base)?);
        let own: Option<Vec<f64>> = self.plan.axes().iter().map(share).collect();
        let best = sampling::search(inputs, own, samples, &mut |points, best| {
            self.front.designs = self.designs(best);
            context.show(&self.front).then(|| self.judged(points, context))?
        });
        self.front.designs = self.designs(&best);
        let measure = self.front.request.objectives[0].measure;
        let mut checked = Vec::new();
        for design in &mut self.front.designs {
            let scene = scene_with(&self.front.base, &self.front.request.over, &design.values);
            let found =
                DesignValidity::from_run(&scene, measure, &[], &mut || context.should_continue());
            design.plastic = found.plastic;
            checked.push(found.fails);
        }
        self.front.outside = validity::counts_of(&checked);
        self.front
    }

    /// The results at points of the unit cube; `None` when it was stopped.
    fn judged(
        &mut self,
        points: &[Vec<f64>],
        context: &mut Context<'_, FrontReport>,
    ) -> Option<Vec<(Evaluation, Point)>> {
        let designs: Vec<Vec<f64>> = points.iter().map(|shares| self.place(shares)).collect();
        let found = self.plan.evaluate(&designs, context);
        let mut judged: Vec<Evaluation> = found.iter().map(|found| self.judge(found)).collect();
        self.front.runs += found.len();
        let budget = PointOutcome::Failed(Failure::Early(EndReason::StepBudget));
        self.front.given_up += found.iter().filter(|found| found.outcome == budget).count();
        for found in &found {
            self.note_lack(found);
        }
        if self.front.request.is_feasible {
            let keeps = |at: &usize| judged[*at].is_feasible();
            let candidates: Vec<usize> = (0..judged.len()).filter(keeps).collect();
            let fails = self.infeasible(&designs, &candidates, context);
            for (at, fails) in candidates.into_iter().zip(&fails) {
                let excess = self.excess(&designs[at], found[at].outcome);
                self.front.unstopped += usize::from(excess > 0.0);
                judged[at].violation = fails.len() as f64 + excess;
            }
            for (check, count) in validity::counts_of(&fails) {
                match self.front.infeasible.iter_mut().find(|it| it.0 == check) {
                    Some(known) => known.1 += count,
                    None => self.front.infeasible.push((check, count)),
                }
            }
        }
        (!context.is_stopped()).then(|| judged.into_iter().zip(found).collect())
    }

    /// By how much the shot is too fast for a design, relative to the velocity that it stops; 1 for a shot that perforates in its own run.
    fn excess(&self, design: &[f64], outcome: PointOutcome) -> f64 {
        let is_perforated = outcome.is_through();
        let scene = self.plan.scene_of(design);
        let by_band = Verdict::from_scene(&scene).expected.map_or(0.0, |expected| {
            larger(scene.projectile.velocity_m_s / expected.low_m_s - 1.0, 0.0)
        });
        by_band + if is_perforated { 1.0 } else { 0.0 }
    }

    /// Counts the checks that make designs infeasible.
    fn infeasible(
        &self,
        designs: &[Vec<f64>],
        candidates: &[usize],
        context: &mut Context<'_, FrontReport>,
    ) -> Vec<Vec<Check>> {
        let stop = context.stop();
        let check = |at: &usize| {
            let scene = self.plan.scene_of(&designs[*at]);
            let fails = validity::infeasible(&scene, &self.known, &mut || !stop.is_set());
            (!stop.is_set()).then_some(fails)
        };
        context.uncounted(|inner| {
            inner.map_items(candidates, check, |inner, _| inner.should_continue())
        })
    }

    /// Counts a design that has no value of an objective.
    fn note_lack(&mut self, found: &Point) {
        let mut measures = self.front.request.objectives.iter().map(|it| it.measure);
        let Some(measure) = measures.find(|it| self.value(found, it).is_none()) else { return };
        let outcome = found.outcome;
        let lacks = &mut self.front.lacks;
        match lacks.iter_mut().find(|it| it.measure == measure && it.outcome == outcome) {
            Some(lack) => lack.count += 1,
            None => lacks.push(MissingObjective { measure, outcome, count: 1 }),
        }
    }

    /// A measure of a design; `None` where it does not exist, and where the plate is perforated and designs may not be compared by it.
    fn value(&self, found: &Point, measure: &Quantity) -> Option<f64> {
        let is_perforated = found.outcome.is_through();
        let at = self.plan.outputs().iter().position(|other| *other == measure)?;
        found.values[at].filter(|_| !is_perforated || measure.is_defined_when_perforated())
    }

    /// The values of a point of the unit cube.
    fn place(&self, shares: &[f64]) -> Vec<f64> {
        let axes = self.plan.axes().iter();
        axes.zip(shares).map(|(axis, share)| axis.at_share(*share)).collect()
    }

    fn designs(&self, best: &[Sample<Point>]) -> Vec<Design> {
        let design = |one: &Sample<Point>| {
            let Point { outcome, values, .. } = one.found.clone();
            Design { values: self.place(&one.shares), measures: values, outcome, plastic: None }
        };
        let first = |design: &Design| design.measures[0].unwrap_or(f64::NAN);
        sorted_by(sampling::front(best).into_iter().map(design).collect(), first)
    }

    fn judge(&self, found: &Point) -> Evaluation {
        let Request { objectives, subject_to, .. } = &self.front.request;
        let value = |objective: &Objective| {
            let value = self.value(found, objective.measure)?;
            Some(if objective.maximise { -value } else { value })
        };
        let Some(values) = objectives.iter().map(value).collect() else {
            let none = vec![f64::INFINITY; objectives.len()];
            return Evaluation { objectives: none, violation: f64::INFINITY };
        };
        let violation = |it: &Constraint| it.violation(self.value(found, it.measure));
        let violation = subject_to.iter().map(violation).sum();
        Evaluation { objectives: values, violation }
    }
}

#[cfg(test)]
mod tests;
