//! Evaluation of many designs at once: outcome and quantities of each.
//!
//! Designs are listed points of a plan, evaluated as in sweeps, with the contact kernel if possible. A design whose computation fails or
//! panics has a failed outcome. The results do not depend on the number of threads.

use std::ops::Range;

use crate::study::context::{Context, Work};
use crate::study::sweep::kernel::Kernel;
use crate::study::sweep::{Evaluator, Plan, Point};
use cmra_engine::model::scene::InterfaceLaw;

/// Number of designs that a thread takes at once, for designs by the contact kernel.
const PIECE: u64 = 16;
/// Number of designs that a thread takes at once, for designs with a complete run: their run times differ by orders of magnitude.
const PIECE_OF_RUNS: u64 = 1;

impl Plan {
    /// Evaluates designs, each with a value for every axis in its stored unit (NaN for an absent variable); fewer results if stopped.
    ///
    /// The caller ensures that the designs are physically possible. Values that do not count for their outcome are `None`, see
    /// [`crate::study::outcome::PointOutcome::counts`].
    pub fn evaluate<P: ?Sized>(
        &self,
        designs: &[Vec<f64>],
        context: &mut Context<'_, P>,
    ) -> Vec<Point> {
        let mut found = self.evaluate_all(designs, context);
        for Point { outcome, values, .. } in &mut found {
            for (value, output) in values.iter_mut().zip(&self.outputs) {
                value.take_if(|_| !outcome.counts(output));
            }
        }
        found
    }

    /// Evaluates designs as [`Plan::evaluate`] does, and keeps values that do not count for their outcome.
    pub(in crate::study) fn evaluate_all<P: ?Sized>(
        &self,
        designs: &[Vec<f64>],
        context: &mut Context<'_, P>,
    ) -> Vec<Point> {
        if context.is_stopped() {
            return Vec::new();
        }
        let list = designs.iter().flatten().copied().collect();
        let plan = Self { points: designs.len() as u64, list: Some(list), ..self.clone() };
        let stop = context.stop();
        let worker = || {
            let mut evaluator = Evaluator::new(&plan, &stop);
            move |points: Range<u64>| evaluator.points(&points.collect::<Vec<u64>>())
        };
        let at_once = if self.runs_whole() { PIECE_OF_RUNS } else { PIECE };
        let work = Work { count: plan.points, at_once };
        context.map(work, worker, |context, _| context.should_continue())
    }

    /// Returns `true` if each design needs a complete run: for a plastic interface, or a quantity that does not follow from the first
    /// contact.
    fn runs_whole(&self) -> bool {
        self.base.interface.law == InterfaceLaw::Plastic || Kernel::from_plan(self).is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::context::never_cancel;
    use crate::study::quantities::named;
    use crate::study::run_with;
    use crate::study::sweep::{Failure, PointOutcome};
    use crate::study::testing::axes;
    use cmra_engine::model::mechanism::Mechanism;
    use cmra_engine::model::run::{EndReason, Outcome};
    use cmra_engine::model::scene::Scene;
    use cmra_engine::model::simulate::Settings;

    fn whole(space: &Plan, designs: &[Vec<f64>], threads: usize) -> Vec<Point> {
        space.evaluate(designs, &mut Context::<()>::new(threads, &mut never_cancel))
    }

    const FOUR: [&str; 4] =
        ["final_penetration_m", "stroke_m", "system_mass_kg", "peak_mount_force_n"];

    /// Depth, stroke and force are those of a run of its own; the spring's energy follows from its law.
    #[test]
    fn measures_are_those_of_single_runs_whatever_the_threads() {
        let bounds = axes(&[("gamma", 0.8, 7.0), ("k", 1e3, 7.5e6), ("b", 0.0, 100.0)]);
        let designs =
            [vec![1.0, 1e5, 0.0], vec![2.0, 1e6, 0.0], vec![1.0, 1e5, 50.0], vec![0.8, 7.5e6, 0.0]];
        let with = |threads| {
            let space = Plan::for_designs(&Scene::default(), bounds.clone(), &FOUR).unwrap();
            (whole(&space, &designs, threads), space)
        };
        let (found, space) = with(1);
        assert_eq!(found, with(3).0);
        for (design, found) in designs.iter().zip(&found) {
            let scene = space.scene_of(design);
            let run = run_with(&scene, Settings::SERIES).unwrap();
            let close = |value: Option<f64>, exact: Option<f64>| {
                let (value, exact) = (value.unwrap(), exact.unwrap());
                assert!((value - exact).abs() <= 1e-7 * exact, "{design:?}: {value} {exact}");
            };
            close(found.values[0], run.penetration.final_m);
            close(found.values[1], run.stroke_m());
            let farthest = run.max_plate_displacement_m.unwrap();
            let energy = 0.5 * design[1] * farthest * farthest;
            let kg = design[0] * 0.0295 + SPRING_FOR_TEST * energy;
            close(found.values[2], Some(kg));
            let damper = Mechanism::from_scene(&scene).damper;
            let force = |row: &cmra_engine::model::run::Sample| {
                design[1] * row.plate_displacement_m + damper.force(row.plate_velocity_m_s)
            };
            let sampled = run.series.iter().map(force).fold(design[1] * farthest, f64::max);
            // The greatest of the rows is a lower bound: the located extreme lies between them.
            let located = found.values[3].unwrap();
            assert!(located >= sampled * (1.0 - 1e-9), "{design:?}: {located} {sampled}");
            assert!(located <= 1.01 * sampled, "{design:?}: {located} {sampled}");
            close(found.values[3], named("peak_mount_force_n").unwrap().value(&run));
        }
    }

    /// 4 rho G/tau² of a steel spring, by hand.
    const SPRING_FOR_TEST: f64 = 5.081_673_469_387_755e-3;

    #[test]
    fn a_run_that_takes_too_many_steps_is_given_up_and_the_others_are_as_without_a_limit() {
        let mut scene = Scene::default();
        scene.interface.law = InterfaceLaw::Plastic;
        scene.mechanism.damper.exponent = 1.406_25;
        let bounds = axes(&[
            ("gamma", 0.8, 7.0),
            ("k", 1e3, 7.5e6),
            ("n", 0.25, 3.0),
            ("d", 0.0, 0.5),
            ("b", 0.0, 2000.0),
        ]);
        // The second one oscillates thousands of times on a spring of small exponent before it is decided.
        let designs =
            [vec![1.0, 1e5, 1.0, 0.0, 0.0], vec![4.2875, 3_281_250.0, 0.546_875, 0.406_25, 375.0]];
        let space =
            Plan::for_designs(&scene, bounds, &["final_penetration_m", "stroke_m"]).unwrap();
        let free = whole(&space, &designs, 1);
        let found = whole(&space.limited(1000), &designs, 1);
        assert_eq!(found[0], free[0]);
        assert_eq!(free[1].outcome, PointOutcome::Ended(Outcome::Arrested));
        assert_eq!(found[1].outcome, PointOutcome::Failed(Failure::Early(EndReason::StepBudget)));
        assert_eq!(found[1].values, [None, None]);
    }
}
