//! The Pareto front of a scene: the non-dominated designs under constraints, on one interface law or
//! both; and the position of the scene itself and of the designs of the thesis relative to it.
//!
//! A candidate that no design on the front dominates is checked: COBYLA searches from it for a design that dominates it. With one objective the best design is closed in further by COBYLA (M. J. D. Powell, "A direct search optimization method that
//! models the objective and constraint functions by linear interpolation", 1994). Must not know files, screens or a clock.

use std::cell::RefCell;

use crate::model::run::EndReason;
use crate::model::run::envelope::Check;
use crate::model::scene::{InterfaceLaw, Scene};
use crate::numerics::statistics::sorted_by;
use crate::study::context::Context;
use crate::study::quantities::{Quantity, named};
use crate::study::search::nsga::{self, EvolutionOptions, Individual, Judged};
use crate::study::search::recommended::{self, RECOMMENDED};
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::{Axis, EvaluatedDesign, Failure, Plan, PointOutcome, SweepError};
use crate::study::validity;
pub use constraint::{Constraint, feasibility};
use polish::{Trial, polish};

mod constraint;
mod polish;

/// The objectives of the workbench: depth, stroke, mass and force into the mount.
pub const USUAL: [&str; 4] =
    ["final_penetration_m", "stroke_m", "system_mass_kg", "peak_mount_force_n"];

/// Runs to close in a single best design, and to look for one that beats a candidate.
const POLISHED: usize = 600;
const CHALLENGED: usize = 200;
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

/// The goal.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The variables and their bounds.
    pub axes: Vec<Axis>,
    /// The objectives.
    pub objectives: Vec<Objective>,
    /// The constraints.
    pub constraints: Vec<Constraint>,
    /// On which interface laws.
    pub laws: Vec<InterfaceLaw>,
    /// How much is done for each.
    pub effort: EvolutionOptions,
}

impl Task {
    /// Every measure that is needed, the objectives first, each once.
    pub fn measures(&self) -> Vec<&'static Quantity> {
        let all = self.objectives.iter().map(|it| it.measure);
        let mut list: Vec<&'static Quantity> = Vec::new();
        for column in all.chain(self.constraints.iter().map(|it| it.measure)) {
            if !list.iter().any(|known| known.name == column.name) {
                list.push(column);
            }
        }
        list
    }

    /// The measures to show, by their places: those of objectives and constraints that were named, and what the interface is asked
    /// for.
    pub fn shown(&self) -> Vec<usize> {
        let named = |column: &&'static Quantity| {
            self.objectives.iter().any(|it| it.measure.name == column.name)
                || self
                    .constraints
                    .iter()
                    .any(|it| !it.is_feasibility && it.measure.name == column.name)
                || column.name.starts_with("interface_")
        };
        let measures = self.measures();
        (0..measures.len()).filter(|at| named(&measures[*at])).collect()
    }

    /// Runs for all laws together.
    pub fn runs(&self) -> usize {
        self.laws.len() * self.effort.evaluations()
    }
}

/// A design.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// The variables, in their stored units.
    pub values: Vec<f64>,
    /// Its measures, in the order of [`Task::measures`].
    pub measures: Vec<Option<f64>>,
    /// Its outcome.
    pub outcome: PointOutcome,
}

/// How a design stands against a front.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// No design of the front dominates it.
    OnFront,
    /// This design of the front is better in every objective it differs in.
    Dominated {
        /// Its place on the front.
        by: usize,
    },
    /// It breaks these constraints, by their places.
    Breaks(Vec<usize>),
    /// A measure does not exist: the reason.
    NoValue(PointOutcome),
    /// It cannot be made of this scene.
    Impossible,
}

/// A design of the thesis, or the scene itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its name.
    pub name: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its scene.
    pub scene: Option<Scene>,
    /// Its outcome; `None` if it is not possible with this scene.
    pub outcome: Option<PointOutcome>,
    /// Its measures, in the order of [`Task::measures`].
    pub measures: Vec<Option<f64>>,
    /// How it stands.
    pub standing: Standing,
}

/// Designs without a value of an objective, which cannot be on a front.
#[derive(Clone, Debug, PartialEq)]
pub struct Lack {
    /// The objective's measure.
    pub measure: &'static Quantity,
    /// The outcome of these designs.
    pub outcome: PointOutcome,
    /// How many they are.
    pub count: usize,
}

/// The front on one interface law.
#[derive(Clone, Debug, Default)]
pub struct Front {
    /// The law.
    pub law: InterfaceLaw,
    /// The scene whose other variables were held.
    pub base: Scene,
    /// The designs, by the first objective.
    pub designs: Vec<Design>,
    /// The scene itself and the designs of the thesis.
    pub candidates: Vec<Candidate>,
    /// How many of the designs are outside the model's validity, by check.
    pub outside: Vec<(Check, usize)>,
    /// Generations made.
    pub generations: usize,
    /// Runs made.
    pub runs: usize,
    /// Runs stopped after [`STEPS_MAX`] steps.
    pub given_up: usize,
    /// Runs that had no value of an objective.
    pub lacks: Vec<Lack>,
    /// Whether it was done to its end.
    pub is_complete: bool,
}

impl Front {
    /// The scene of one of its designs.
    pub fn scene(&self, task: &Task, design: &Design) -> Scene {
        scene_with(&self.base, &task.axes, &design.values)
    }
}

/// Look for the fronts, law by law, and show each as it grows.
///
/// # Errors
/// A [`SweepError`] when bounds, names or the scene make no sense: then nothing has run.
pub fn optimise(
    scene: &Scene,
    task: &Task,
    context: &mut Context<'_, Front>,
) -> Result<Vec<Front>, SweepError> {
    context.expect(task.runs());
    // All laws are checked before any is run.
    let mut spaces = Vec::new();
    for law in &task.laws {
        let mut own = scene.clone();
        own.interface.law = *law;
        let names: Vec<&str> = task.measures().iter().map(|column| column.name).collect();
        let space = Plan::for_designs(&own, task.axes.clone(), &names)?.limited(STEPS_MAX);
        spaces.push((own, space));
    }
    let mut fronts: Vec<Front> = Vec::new();
    for (own, space) in spaces {
        let search = Search { task, space: &space, scene: &own };
        fronts.push(search.run(context));
        if context.is_stopped() {
            break;
        }
    }
    Ok(fronts)
}

struct State<'s, 'w> {
    front: Front,
    context: &'s mut Context<'w, Front>,
}

struct Search<'a> {
    task: &'a Task,
    space: &'a Plan,
    scene: &'a Scene,
}

impl Search<'_> {
    fn run(&self, context: &mut Context<'_, Front>) -> Front {
        let (law, base) = (self.scene.interface.law, self.scene.clone());
        let front = Front { law, base, is_complete: true, ..Front::default() };
        let state = RefCell::new(State { front, context });
        let mut function = |points: &[Vec<f64>]| {
            let found = self.evaluate_all(points, &state)?.into_iter();
            Some(found.map(|found| (self.judge(&found.values), found)).collect())
        };
        let mut observe = |generation: usize, people: &[Individual<EvaluatedDesign>]| {
            let mut state = state.borrow_mut();
            state.front.generations = generation;
            state.front.designs = self.designs(nsga::front(people));
            let State { front, context } = &mut *state;
            front.is_complete = context.show(front);
        };
        // The scene itself and what the thesis recommends are tried first, where the bounds hold them.
        let own = std::iter::once(self.scene.clone());
        let thesis = RECOMMENDED.iter().filter_map(|it| recommended::scene_of(it, self.scene));
        let starts: Vec<Vec<f64>> =
            own.chain(thesis).filter_map(|it| self.shares_of(&it)).collect();
        let inputs = self.task.axes.len();
        let people = nsga::evolve(inputs, &starts, self.task.effort, &mut function, &mut observe);
        let mut best = nsga::front(&people);
        let whole = state.borrow().front.is_complete;
        if let ([start], true, 1) = (best.as_slice(), whole, self.task.objectives.len()) {
            let mut attempt = |shares: &[f64]| self.attempt(shares, &[], &state);
            best = vec![polish(start.clone(), self.task.constraints.len(), POLISHED, &mut attempt)];
        }
        state.borrow_mut().front.designs = self.designs(best);
        let mut candidates = self.candidates(state.borrow_mut().context);
        for candidate in &mut candidates {
            self.challenge(candidate, &state);
        }
        let State { mut front, context } = state.into_inner();
        front.designs = sorted_by(front.designs, first);
        front.candidates = candidates;
        let scenes = front.designs.iter().map(|design| front.scene(self.task, design));
        front.outside = validity::breached(scenes, &mut || context.goes_on());
        for candidate in &mut front.candidates {
            candidate.standing = self.standing(&front.designs, candidate);
        }
        front
    }

    /// The measures at points of the unit cube, which are kept; `None` when it was stopped.
    fn evaluate_all(
        &self,
        points: &[Vec<f64>],
        state: &RefCell<State<'_, '_>>,
    ) -> Option<Vec<EvaluatedDesign>> {
        let mut state = state.borrow_mut();
        let State { front, context } = &mut *state;
        if !front.is_complete {
            return None;
        }
        let designs: Vec<Vec<f64>> = points.iter().map(|shares| self.place(shares)).collect();
        let found = self.space.evaluate(&designs, *context);
        front.is_complete = !context.is_stopped();
        front.runs += found.len();
        let budget = PointOutcome::Failed(Failure::Early(EndReason::StepBudget));
        front.given_up += found.iter().filter(|found| found.outcome == budget).count();
        for found in &found {
            self.note_lack(found, &mut front.lacks);
        }
        front.is_complete.then_some(found)
    }

    /// Counts a design that has no value of an objective.
    fn note_lack(&self, found: &EvaluatedDesign, lacks: &mut Vec<Lack>) {
        let mut measures = self.task.objectives.iter().map(|it| it.measure);
        let Some(measure) = measures.find(|it| self.value(&found.values, it).is_none()) else {
            return;
        };
        let outcome = found.outcome;
        match lacks.iter_mut().find(|it| it.measure == measure && it.outcome == outcome) {
            Some(lack) => lack.count += 1,
            None => lacks.push(Lack { measure, outcome, count: 1 }),
        }
    }

    /// A point of the unit cube for COBYLA: how far it is, in relative terms, from being worse than `held` in an objective after the
    /// first, and from the bound of each constraint.
    fn attempt(
        &self,
        shares: &[f64],
        held: &[f64],
        state: &RefCell<State<'_, '_>>,
    ) -> Option<Trial<EvaluatedDesign>> {
        let found = self.evaluate_all(&[shares.to_vec()], state)?.into_iter().next()?;
        let judged = self.judge(&found.values);
        let rest = judged.objectives.iter().zip(held).skip(1);
        let rest =
            rest.map(|(own, held)| (held - own) / if *held == 0.0 { 1.0 } else { held.abs() });
        let constraints = self.task.constraints.iter();
        let bounds = constraints.map(|it| it.margin(self.value(&found.values, it.measure)));
        let margins = rest.chain(bounds).collect();
        Some(Trial { judged, found, margins })
    }

    /// A measure's value among those of a design.
    fn value(&self, measures: &[Option<f64>], measure: &Quantity) -> Option<f64> {
        let at = self.space.outputs().iter().position(|other| other.name == measure.name)?;
        *measures.get(at)?
    }

    /// The values of a point of the unit cube.
    fn place(&self, shares: &[f64]) -> Vec<f64> {
        let axes = self.space.axes().iter();
        axes.zip(shares).map(|(axis, share)| axis.at_share(*share)).collect()
    }

    /// Where a scene lies, if within the bounds and like the scene in everything else.
    fn shares_of(&self, scene: &Scene) -> Option<Vec<f64>> {
        let axes = self.space.axes();
        if scene_with(scene, axes, &self.space.design_of(self.scene)) != *self.scene {
            return None;
        }
        let share = |axis: &Axis| axis.share(axis.get(scene)?);
        axes.iter().map(share).collect()
    }

    fn designs(&self, best: Vec<Individual<EvaluatedDesign>>) -> Vec<Design> {
        sorted_by(best.into_iter().map(|one| self.design(one)).collect(), first)
    }

    fn design(&self, one: Individual<EvaluatedDesign>) -> Design {
        let EvaluatedDesign { outcome, values } = one.found;
        Design { values: self.place(&one.shares), measures: values, outcome }
    }

    fn judge(&self, measures: &[Option<f64>]) -> Judged {
        let value = |measure: &Quantity| self.value(measures, measure);
        let objectives = self.task.objectives.iter().map(|objective| {
            let value = value(objective.measure)?;
            Some(if objective.maximise { -value } else { value })
        });
        let objectives: Option<Vec<f64>> = objectives.collect();
        let broken = self.task.constraints.iter();
        let violation: f64 = broken.map(|it| it.violation(value(it.measure))).sum();
        match objectives {
            Some(objectives) => Judged { objectives, violation },
            None => Judged {
                objectives: vec![f64::INFINITY; self.task.objectives.len()],
                violation: f64::INFINITY,
            },
        }
    }

    /// The references of the front; none of a search that was stopped.
    fn candidates(&self, context: &mut Context<'_, Front>) -> Vec<Candidate> {
        let own = ("the scene itself", "as it is", Some(self.scene.clone()));
        let thesis = RECOMMENDED
            .iter()
            .map(|it| (it.name, it.source, recommended::scene_of(it, self.scene)));
        let all = std::iter::once(own).chain(thesis);
        all.filter_map(|(name, source, scene)| {
            let found = scene.as_ref().and_then(|scene| self.evaluate(scene, context));
            if context.is_stopped() {
                return None;
            }
            let none = || vec![None; self.space.outputs().len()];
            let (scene, outcome, measures) = match found {
                Some(found) => (scene, Some(found.outcome), found.values),
                None => (None, None, none()),
            };
            let standing = Standing::Impossible;
            Some(Candidate { name, source, scene, outcome, measures, standing })
        })
        .collect()
    }

    /// Look from a candidate that nothing beats yet for a design that does: the first objective as good as can be, no other worse.
    /// Results join the front.
    fn challenge(&self, candidate: &Candidate, state: &RefCell<State<'_, '_>>) {
        let shares = candidate.scene.as_ref().and_then(|scene| self.shares_of(scene));
        let Some((shares, outcome)) = shares.zip(candidate.outcome) else { return };
        let judged = self.judge(&candidate.measures);
        if self.standing(&state.borrow().front.designs, candidate) != Standing::OnFront {
            return;
        }
        let mut attempt = |shares: &[f64]| self.attempt(shares, &judged.objectives, state);
        let others = judged.objectives.len() - 1 + self.task.constraints.len();
        let found = EvaluatedDesign { outcome, values: candidate.measures.clone() };
        let start = Individual { shares, judged: judged.clone(), found };
        let better = polish(start, others, CHALLENGED, &mut attempt);
        if !better.judged.dominates(&judged) {
            return;
        }
        let designs = &mut state.borrow_mut().front.designs;
        let of = |design: &Design| self.judge(&design.measures);
        if !designs.iter().any(|design| of(design).dominates(&better.judged)) {
            designs.retain(|other| !better.judged.dominates(&of(other)));
            designs.push(self.design(better));
        }
    }

    fn standing(&self, front: &[Design], candidate: &Candidate) -> Standing {
        let Some(outcome) = candidate.outcome else { return Standing::Impossible };
        let judged = self.judge(&candidate.measures);
        let broken = self.task.constraints.iter().enumerate().filter(|(_, constraint)| {
            let value = self.value(&candidate.measures, constraint.measure);
            value.is_some() && constraint.violation(value) > 0.0
        });
        let broken: Vec<usize> = broken.map(|(at, _)| at).collect();
        if !broken.is_empty() {
            return Standing::Breaks(broken);
        }
        if !judged.is_feasible() {
            return Standing::NoValue(outcome);
        }
        let beats = |design: &Design| self.judge(&design.measures).dominates(&judged);
        let by = front.iter().position(beats);
        by.map_or(Standing::OnFront, |by| Standing::Dominated { by })
    }

    /// The measures of any scene, by a space of one point; `None` when stopped.
    fn evaluate(&self, scene: &Scene, context: &mut Context<'_, Front>) -> Option<EvaluatedDesign> {
        let axis = self.space.axes().first()?;
        let names: Vec<&str> = self.space.outputs().iter().map(|column| column.name).collect();
        let space = Plan::for_designs(scene, vec![axis.clone()], &names).ok()?.limited(STEPS_MAX);
        let own = space.design_of(scene);
        context.uncounted(|context| space.evaluate(&[own], context)).into_iter().next()
    }
}

/// The first measure, by which fronts are sorted.
fn first(design: &Design) -> f64 {
    design.measures[0].unwrap_or(f64::NAN)
}

/// The usual objectives, those named, or the names' own.
///
/// # Errors
/// A [`SweepError`] for an unknown name.
pub fn objectives(
    minimise: &[impl AsRef<str>],
    maximise: &[impl AsRef<str>],
) -> Result<Vec<Objective>, SweepError> {
    let of = |name: &str, maximise| Ok(Objective { measure: named(name)?, maximise });
    let small = minimise.iter().map(|name| of(name.as_ref(), false));
    let great = maximise.iter().map(|name| of(name.as_ref(), true));
    let named: Vec<Objective> = small.chain(great).collect::<Result<_, SweepError>>()?;
    if named.is_empty() { USUAL.iter().map(|name| of(name, false)).collect() } else { Ok(named) }
}

#[cfg(test)]
mod tests;
