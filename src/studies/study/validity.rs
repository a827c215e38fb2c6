//! Warnings of a study about the model's validity, by the checks of [`envelope`], for a scene, a range of scenes, or designs.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::envelope::{self, Breach, Check, Direction};
use crate::study::library;
use crate::study::quantities::{Quantity, QuantityFlag, Search};
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::{Axis, Plan, PointOutcome};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{EndReason, Run, Warning};
use cmra_engine::model::scene::{InterfaceLaw, Scene};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::units::{shortest, significant};
use cmra_engine::model::variables;

/// Step limit of the run of a check. Beyond it only warnings that follow from the scene alone are reported.
const STEPS_MAX: usize = 30_000;
/// Step limit of a run at the end of an axis. Its cost must be small compared with the sweep; typical runs take tens of steps.
const END_STEPS_MAX: usize = 30;

/// Returns the warnings about a scene's results, from one run.
pub fn of_scene(scene: &Scene) -> Vec<Warning> {
    warnings(scene, run(scene, STEPS_MAX).as_ref())
}

fn warnings(scene: &Scene, run: Option<&Run>) -> Vec<Warning> {
    run.map_or_else(
        || {
            let breaches = envelope::of_scene(scene);
            breaches.iter().map(Warning::from).chain(library::warnings(scene)).collect()
        },
        envelope::warnings,
    )
}

/// Runs a scene for a check; `None` if it exceeds the step limit or makes no physical sense.
fn run(scene: &Scene, steps_max: usize) -> Option<Run> {
    run_while(scene, steps_max, &mut || true)
}

/// Number of steps between two calls of `goes_on`.
const LOOK: usize = 256;

/// Runs a scene until `goes_on` returns `false`.
fn run_while(scene: &Scene, steps_max: usize, goes_on: &mut dyn FnMut() -> bool) -> Option<Run> {
    if !goes_on() {
        return None;
    }
    let mut own = scene.clone();
    own.sweep = None;
    let mut steps = 0;
    let run = simulate(&Arc::new(own), &Settings::BARE, &mut |_| {
        steps += 1;
        let is_cut = steps > steps_max || steps.is_multiple_of(LOOK) && !goes_on();
        if is_cut { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    run.ok().filter(|run| run.end != EndReason::Cancelled)
}

/// Returns the breaches of a scene, including those of its run if there is one.
fn breaches(scene: &Scene, run: Option<&Run>) -> Vec<Breach> {
    run.map_or_else(|| envelope::of_scene(scene), envelope::of_run)
}

/// Returns the warnings about results over these axes: the warnings of the scene, and additional breaches at the ends of each axis,
/// including loads of spring, stop and interface. Each breach is reported at its worst end.
pub fn of_axes(scene: &Scene, axes: &[Axis]) -> Vec<Warning> {
    let own = run(scene, STEPS_MAX);
    let far = at_ends(scene, own.as_ref(), axes);
    let mut list = warnings(scene, own.as_ref());
    for breach in breaches(scene, own.as_ref()) {
        if far.iter().any(|(_, worse)| worse.is_same(&breach)) {
            list.retain(|warning| *warning != Warning::from(&breach));
        }
    }
    list.extend(far.into_iter().map(|(place, breach)| Warning::from(&breach).at(place)));
    list
}

/// Returns the checks that fail at an end of an axis but not for the scene itself, each with its warning.
pub fn new_at_ends(scene: &Scene, axes: &[Axis]) -> Vec<(Check, Warning)> {
    let own = run(scene, STEPS_MAX);
    let known = breaches(scene, own.as_ref());
    let far = at_ends(scene, own.as_ref(), axes).into_iter();
    let new = far.filter(|(_, far)| known.iter().all(|breach| breach.check != far.check));
    new.map(|(place, breach)| (breach.check, Warning::from(&breach).at(place))).collect()
}

/// Warns that a limit velocity does not account for the springs whose mass is shown; `None` if only one of both was requested, or if
/// neither scene nor upper ends of its axes have springs.
pub fn of_pair(scene: &Scene, axes: &[Axis], measures: &[&'static Quantity]) -> Option<Warning> {
    let has_limit =
        measures.iter().any(|it| matches!(it.search(), Some(Search::Limit | Search::DesignLimit)));
    let mass = measures.iter().find(|it| has_limit && it.has(QuantityFlag::CountsSprings))?.name;
    let ends: Vec<f64> = axes.iter().map(|axis| axis.ends().1).collect();
    let is_sprung = |scene: &Scene| scene.is_sprung() && scene.mechanism.has_springs();
    (is_sprung(scene) || is_sprung(&scene_with(scene, axes, &ends))).then(|| {
        let meaning = format!(
            "; those in {mass} are sized for v_i and hold no faster shot: `cmra compare --size` gives the limit with them"
        );
        Warning::remark("limit_velocity_m_s is that of the plate, whatever its springs have to store", meaning)
    })
}

/// Returns the warnings about the results of a sweep: those over its axes, and those about combinations of its outputs.
pub fn of_plan(plan: &Plan) -> Vec<Warning> {
    let mut list = of_axes(plan.base(), plan.axes());
    list.extend(of_pair(plan.base(), plan.axes(), plan.outputs()));
    list
}

/// Returns the breaches that are worse at an end of an axis than in the scene itself, each at its worst end.
fn at_ends(scene: &Scene, own: Option<&Run>, axes: &[Axis]) -> Vec<(String, Breach)> {
    let known = breaches(scene, own);
    let mut list: Vec<(String, Breach)> = Vec::new();
    for axis in axes {
        for end in [axis.ends().0, axis.ends().1] {
            let mut far = scene.clone();
            axis.set(&mut far, end);
            if variables::validate(&far).is_err() {
                continue;
            }
            for breach in breaches(&far, run(&far, END_STEPS_MAX).as_ref()) {
                let place = format!("at {} = {}", axis.symbol(), shortest(end));
                let all = known.iter().chain(list.iter().map(|(_, other)| other));
                if breach.is_new_to(all) {
                    list.retain(|(_, other)| !other.is_same(&breach));
                    list.push((place, breach));
                }
            }
        }
    }
    list
}

/// Validity of a design.
#[derive(Clone, Debug)]
pub struct DesignValidity {
    /// Result with a plastic interface; `None` if the design's interface stays within its limit load.
    pub plastic: Option<Plastic>,
    /// Failed checks.
    pub fails: Vec<Check>,
    /// Warnings that the original scene does not have, without those of library entries.
    pub new: Vec<Warning>,
    /// Warnings that the original scene also has.
    pub known: Vec<Warning>,
    /// Verdict on the design's shot.
    pub verdict: Verdict,
}

impl DesignValidity {
    /// Checks a design that a measure found: by its run, or by the scene alone once `goes_on` returns `false`. `known` contains the checks
    /// that the original scene fails.
    pub fn from_run(
        design: &Scene,
        measure: &Quantity,
        known: &[Check],
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Self {
        let run = run_while(design, STEPS_MAX, goes_on);
        let breaches = breaches(design, run.as_ref());
        let fails: Vec<Check> = breaches.iter().map(|breach| breach.check).collect();
        let (known, new): (Vec<Breach>, Vec<Breach>) =
            breaches.into_iter().partition(|breach| known.contains(&breach.check));
        let remarks = run.iter().flat_map(envelope::remarks);
        Self {
            plastic: Plastic::beside(design, &fails, measure, goes_on),
            fails,
            new: new.iter().map(Warning::from).chain(remarks).collect(),
            known: known.iter().map(Warning::from).collect(),
            verdict: Verdict::from_scene(design),
        }
    }
}

/// Result of a design with a plastic interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic {
    /// Outcome of the design's run.
    pub outcome: PointOutcome,
    /// Value of the design's measure; `None` if it does not exist.
    pub value: Option<f64>,
}

impl Plastic {
    /// Returns the result with a plastic interface for a design that fails these checks; `None` if its interface is plastic or within its
    /// limit load.
    fn beside(
        design: &Scene,
        fails: &[Check],
        measure: &Quantity,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Option<Self> {
        let is_overloaded = fails.iter().any(|it| matches!(it, Check::Interface | Check::Rebound));
        if design.interface.law == InterfaceLaw::Plastic || !is_overloaded {
            return None;
        }
        let mut plastic = design.clone();
        plastic.interface.law = InterfaceLaw::Plastic;
        let run = run_while(&plastic, STEPS_MAX, goes_on)?;
        let outcome = PointOutcome::from_run(&run);
        let value = measure.value(&run).filter(|_| outcome.counts(measure));
        Some(Self { outcome, value })
    }

    /// Formats the result: `plastic: 5.269 mm`, `plastic: perforated`.
    pub fn message(&self, measure: &Quantity) -> String {
        format!("plastic: {}", self.result(measure))
    }

    /// Formats the result alone: `5.269 mm`, `perforated`.
    pub fn result(&self, measure: &Quantity) -> String {
        let shown = self.value.map(|value| measure.show(value, 4));
        shown.unwrap_or_else(|| self.outcome.key().to_owned())
    }
}

/// Whether a search lets pass a check that its designs fail: one of the choice of model that the original scene also fails (`known`).
pub fn lets_pass(check: Check, known: &[Check]) -> bool {
    !check.is_of_load() && known.contains(&check)
}

/// Returns the checks that make a design infeasible: those with an unsafe error, except those that are let pass.
pub fn infeasible(
    design: &Scene,
    known: &[Check],
    goes_on: &mut dyn FnMut() -> bool,
) -> Vec<Check> {
    let run = run_while(design, STEPS_MAX, goes_on);
    let found = breaches(design, run.as_ref()).into_iter();
    let is_unsafe = |it: &Breach| it.direction == Direction::Unconservative;
    let checks = found.filter(is_unsafe).map(|it| it.check);
    checks.filter(|it| !lets_pass(*it, known)).collect()
}

/// Returns the warnings of a design that are not in `known`, with the values that define the design.
pub fn of_design(name: &str, scene: &Scene, axes: &[Axis], known: &[Warning]) -> Vec<Warning> {
    let value =
        |axis: &Axis| Some(format!("{}={}", axis.symbol(), significant(axis.get(scene)?, 4)));
    let values: Vec<String> = axes.iter().filter_map(value).collect();
    let lead = format!("{name} ({})", values.join(" "));
    let found = of_scene(scene).into_iter().filter(|warning| !known.contains(warning));
    found.map(|warning| warning.at(&*lead)).collect()
}

/// Counts how many designs fail each check.
pub fn counts_of(fails: &[Vec<Check>]) -> Vec<(Check, usize)> {
    let count = |check: &Check| fails.iter().filter(|fails| fails.contains(check)).count();
    let counts = Check::ALL.map(|check| (check, count(&check))).into_iter();
    counts.filter(|(_, count)| *count > 0).collect()
}

/// Formats the counts: `h/D 100, interface 88`.
pub fn counted(counts: &[(Check, usize)]) -> String {
    let words: Vec<String> =
        counts.iter().map(|(check, count)| format!("{} {count}", check.label())).collect();
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::study::sweep::Spacing;

    fn texts(warnings: &[Warning]) -> Vec<String> {
        warnings.iter().map(ToString::to_string).collect()
    }

    fn of_scene(scene: &Scene) -> Vec<String> {
        texts(&super::of_scene(scene))
    }

    fn of_axes(scene: &Scene, axes: &[Axis]) -> Vec<String> {
        texts(&super::of_axes(scene, axes))
    }

    /// The baseline's interface carries 0.108 of its limit load; with an offset of 0.5 m it carries 2.875 times the limit load.
    #[test]
    fn an_interface_overloaded_at_the_end_of_an_axis_is_reported() {
        let axes = [Axis::new("d", (0.0, 0.5), 2, Spacing::Linear).unwrap()];
        let list = of_axes(&Scene::default(), &axes);
        let found: Vec<&String> =
            list.iter().filter(|text| text.contains("interface push is 2.875")).collect();
        assert!(matches!(found[..], [text] if text.starts_with("at d = 0.5: ")), "{list:?}");
    }

    /// The baseline's plate is 2 D thick and 1.63 D wide. Both checks fail for h = 5 mm with a face of 46.7 mm; theta = 30 deg fails at the
    /// end of the axis.
    #[test]
    fn what_comes_up_at_the_ends_of_an_axis_is_added_once() {
        let scene = Scene::default();
        let count =
            |list: &[String], word: &str| list.iter().filter(|text| text.contains(word)).count();
        let own = of_scene(&scene);
        assert_eq!((count(&own, "h/D = 2"), count(&own, "1.63 D")), (1, 1), "{own:?}");
        let axis = |name, ends| Axis::new(name, ends, 2, Spacing::Linear).unwrap();
        let axes = [axis("theta", (0.0, 30.0)), axis("h", (0.005, 0.05))];
        let list = of_axes(&scene, &axes);
        assert_eq!(count(&list, "at theta = 30: outside validity"), 1, "{list:?}");
        assert_eq!(count(&list, "h/D"), 1, "{list:?}");
    }

    /// S = 1.1e9 Pa and c = 677.5 kg/m³: 0.551 times the strength of the projectile at 50 m/s, 0.635 at 500 m/s.
    #[test]
    fn of_a_breach_along_an_axis_the_worst_is_given() {
        let mut scene = Scene::default();
        scene.target.flow_strength_pa = 1.1e9;
        scene.projectile.velocity_m_s = 50.0;
        let axes = [Axis::new("v_i", (50.0, 500.0), 9, Spacing::Linear).unwrap()];
        let list = of_axes(&scene, &axes);
        let found: Vec<&String> = list.iter().filter(|text| text.contains("S + c v^2")).collect();
        let is_worst =
            |text: &str| text.starts_with("at v_i = 500: ") && text.contains("is 0.635 times");
        assert!(matches!(found[..], [text] if is_worst(text)), "{list:?}");
        // The check fails for the scene itself, too.
        assert!(new_at_ends(&scene, &axes).iter().all(|it| it.0 != Check::NosePressure));
    }

    /// 20 m/s is 2.5 times below the minimum of measurements, 50 m/s; 5000 m/s is five times above their maximum, 1000 m/s. Both are
    /// reported.
    #[test]
    fn a_shot_too_slow_and_one_too_fast_are_both_named() {
        let mut scene = Scene::default();
        scene.projectile.velocity_m_s = 20.0;
        for low in [20.0, 30.0] {
            let axes = [Axis::new("v_i", (low, 5000.0), 3, Spacing::Linear).unwrap()];
            let list = of_axes(&scene, &axes);
            let found: Vec<&String> = list.iter().filter(|it| it.contains(": v_i = ")).collect();
            assert!(
                matches!(found[..], [slow, fast] if slow.contains("20 m/s is below the 50 m/s")
                    && fast.starts_with("at v_i = 5000: ")),
                "{list:?}"
            );
        }
    }
}
