//! Pareto front of a scene: the designs that satisfy all constraints and that no other design dominates; with one objective, the best
//! design.
//!
//! [`sampling::search`] draws designs and selects the best; this module evaluates them. Each design is a run with the interface law of the
//! scene. Its violation is the sum of the relative excesses over the constraints. If that is zero and only feasible designs count, it is the
//! number of failed checks on the unsafe side, plus the relative excess of the impact velocity over the lower end of the band of the limit,
//! plus 1 if the run perforates.

use std::fmt;
use std::ops::RangeInclusive;

use crate::study::context::Context;
use crate::study::envelope::Check;
use crate::study::option;
use crate::study::quantities::{Quantity, named};
use crate::study::search::sampling::{self, Evaluation, Sample};
use crate::study::statistics::sorted_by;
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::default_axes::{or_usual, thesis_axes};
use crate::study::sweep::{Axis, Failure, Plan, Point, PointOutcome, StudyError};
use crate::study::validity::{self, DesignValidity, Plastic};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::EndReason;
use cmra_engine::model::scene::Scene;
use cmra_engine::numerics::larger;
pub use constraint::Constraint;

mod constraint;

/// Default objectives: depth, stroke, mass and mount force, all minimised.
pub const DEFAULT: [&str; 4] =
    ["final_penetration_m", "stroke_m", "system_mass_kg", "peak_mount_force_n"];

/// Allowed number of designs; the minimum leaves two for each round of the search.
pub const SAMPLES: RangeInclusive<usize> = 64..=1 << 24;
/// Default number of designs.
const DEFAULT_SAMPLES: usize = 1 << 14;
/// Maximum number of steps of the run of a design; a hundred times the usual number.
pub const STEPS_MAX: usize = 30_000;

/// Quantity to minimise or maximise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Objective {
    /// Quantity.
    pub measure: &'static Quantity,
    /// Maximised if `true`, else minimised.
    pub maximise: bool,
}

impl Objective {
    /// Creates an objective from the name of its quantity.
    pub fn new(name: &str, maximise: bool) -> Result<Self, StudyError> {
        Ok(Self { measure: named(name)?, maximise })
    }

    /// Returns the objectives of [`DEFAULT`].
    pub fn usual() -> Vec<Self> {
        DEFAULT.iter().filter_map(|name| Self::new(name, false).ok()).collect()
    }

    /// Returns the objectives of [`DEFAULT`] that exist for a scene; a stack has one.
    pub fn usual_for(scene: &Scene) -> Vec<Self> {
        Self::usual().into_iter().filter(|it| it.measure.exists(scene)).collect()
    }
}

/// Request for a Pareto front.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Variables with their bounds; those of [`thesis_axes`] if empty.
    pub over: Vec<Axis>,
    /// Objectives.
    pub objectives: Vec<Objective>,
    /// Constraints.
    pub subject_to: Vec<Constraint>,
    /// Whether a design has to stop the projectile and pass all checks on the unsafe side.
    pub is_feasible: bool,
    /// Number of designs.
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

/// Returns the default constraints: a stroke of at most 1 m if the stroke is minimised; otherwise some designs have strokes of kilometres.
pub fn default_bounds(objectives: &[Objective]) -> Vec<Constraint> {
    let stroke = objectives.iter().find(|it| it.measure.name == "stroke_m" && !it.maximise);
    let bound = |it: &Objective| Constraint { measure: it.measure, at_most: true, bound: 1.0 };
    stroke.map(bound).into_iter().collect()
}

/// Formats the command with its options.
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
    /// Returns the quantities of objectives and constraints, in this order, without repetitions.
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

/// Design on the front.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Values of the variables, in their stored units.
    pub values: Vec<f64>,
    /// Values of the quantities, in the order of [`Request::measures`].
    pub measures: Vec<Option<f64>>,
    /// Outcome of the run.
    pub outcome: PointOutcome,
    /// First objective with a plastic interface, if the load of the fused interface exceeds its strength.
    pub plastic: Option<Plastic>,
}

/// Number of designs without a value of an objective; they cannot be on the front.
#[derive(Clone, Debug, PartialEq)]
pub struct MissingObjective {
    /// Quantity of the objective.
    pub measure: &'static Quantity,
    /// Outcome of these designs.
    pub outcome: PointOutcome,
    /// Number of these designs.
    pub count: usize,
}

/// Result of the search.
#[derive(Clone, Debug, Default)]
pub struct FrontReport {
    /// Request, with the variables that were varied.
    pub request: Request,
    /// Scene with the values of all other variables.
    pub base: Scene,
    /// Designs on the front, sorted by the first objective.
    pub designs: Vec<Design>,
    /// Number of designs on the front that fail each check of the validity.
    pub outside: Vec<(Check, usize)>,
    /// Number of designs evaluated.
    pub runs: usize,
    /// Number of runs stopped after [`STEPS_MAX`] steps.
    pub given_up: usize,
    /// Designs without a value of an objective, by objective and outcome.
    pub lacks: Vec<MissingObjective>,
    /// Number of designs that are infeasible because of each check.
    pub infeasible: Vec<(Check, usize)>,
    /// Number of designs that are infeasible because the plate is not known to stop the projectile.
    pub unstopped: usize,
    /// Checks that the scene itself fails.
    pub known: Vec<Check>,
}

impl FrontReport {
    /// Returns the scene of a design.
    pub fn scene(&self, design: &Design) -> Scene {
        scene_with(&self.base, &self.request.over, &design.values)
    }
}

/// Searches for the front and reports it after each round.
///
/// # Errors
/// A [`StudyError`] when bounds, names or the scene make no sense: then nothing has run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, FrontReport>,
) -> Result<FrontReport, StudyError> {
    let over = or_usual(&request.over, || thesis_axes(scene))?;
    let mut request = Request { over, ..request.clone() };
    for objective in &mut request.objectives {
        objective.measure = objective.measure.design_quantity(scene);
    }
    for constraint in &mut request.subject_to {
        constraint.measure = constraint.measure.design_quantity(scene);
    }
    request.measures().iter().try_for_each(|measure| measure.check_exists(scene))?;
    let names: Vec<&str> = request.measures().iter().map(|measure| measure.name).collect();
    let plan = Plan::for_designs(scene, request.over.clone(), &names)?.limited(STEPS_MAX);
    context.expect(request.samples);
    let known =
        DesignValidity::from_run(scene, request.objectives[0].measure, &[], &mut || true).fails;
    let front = FrontReport { request, base: scene.clone(), known, ..FrontReport::default() };
    Ok(Search { plan, front }.run(context))
}

struct Search {
    plan: Plan,
    front: FrontReport,
}

impl Search {
    fn run(mut self, context: &mut Context<'_, FrontReport>) -> FrontReport {
        let (inputs, samples) = (self.plan.axes().len(), self.front.request.samples);
        // The scene itself is the first design, if it is within the bounds.
        let fraction = |axis: &Axis| axis.fraction(axis.get(&self.front.base)?);
        let own: Option<Vec<f64>> = self.plan.axes().iter().map(fraction).collect();
        let best = sampling::search(inputs, own, samples, &mut |points, best| {
            self.front.designs = self.designs(best);
            if !context.show(&self.front) {
                return None;
            }
            self.evaluate(points, context)
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

    /// Evaluates points of the unit cube; `None` if the search was stopped.
    fn evaluate(
        &mut self,
        points: &[Vec<f64>],
        context: &mut Context<'_, FrontReport>,
    ) -> Option<Vec<(Evaluation, Point)>> {
        let designs: Vec<Vec<f64>> = points.iter().map(|fractions| self.place(fractions)).collect();
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

    /// Returns the relative excess of the impact velocity over the lower end of the band of the limit, plus 1 if the run perforates.
    fn excess(&self, design: &[f64], outcome: PointOutcome) -> f64 {
        let is_perforated = outcome.is_through();
        let scene = self.plan.scene_of(design);
        let by_band = Verdict::from_scene(&scene).expected.map_or(0.0, |expected| {
            larger(scene.projectile.velocity_m_s / expected.low_m_s - 1.0, 0.0)
        });
        by_band + if is_perforated { 1.0 } else { 0.0 }
    }

    /// Returns the failed checks of each candidate that make it infeasible.
    fn infeasible(
        &self,
        designs: &[Vec<f64>],
        candidates: &[usize],
        context: &mut Context<'_, FrontReport>,
    ) -> Vec<Vec<Check>> {
        let stop = context.stop();
        let check = |at: &usize| {
            let scene = self.plan.scene_of(&designs[*at]);
            let fails = validity::infeasible(&scene, &self.front.known, &mut || !stop.is_set());
            (!stop.is_set()).then_some(fails)
        };
        context.uncounted(|inner| {
            inner.map_items(candidates, check, |inner, _| inner.should_continue())
        })
    }

    /// Counts a design without a value of an objective.
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

    /// Returns a quantity of a design; `None` if it does not exist, or cannot be compared because the plate is perforated.
    fn value(&self, found: &Point, measure: &Quantity) -> Option<f64> {
        let is_perforated = found.outcome.is_through();
        let at = self.plan.outputs().iter().position(|other| *other == measure)?;
        found.values[at].filter(|_| !is_perforated || measure.is_defined_when_perforated())
    }

    /// Returns the values of the variables at a point of the unit cube.
    fn place(&self, fractions: &[f64]) -> Vec<f64> {
        let axes = self.plan.axes().iter();
        axes.zip(fractions).map(|(axis, fraction)| axis.at_fraction(*fraction)).collect()
    }

    fn designs(&self, best: &[Sample<Point>]) -> Vec<Design> {
        let design = |one: &Sample<Point>| {
            let Point { outcome, values, .. } = one.found.clone();
            Design { values: self.place(&one.fractions), measures: values, outcome, plastic: None }
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
