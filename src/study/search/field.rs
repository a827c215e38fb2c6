//! Designs evaluated many at once: what became of each, and its measures.
//!
//! The evaluation is that of sweeps, the quick way included; a design whose computation fails, or panics, keeps its place and
//! says so. No digit depends on the number of threads.

use std::ops::{ControlFlow, Range};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::model::impact::{Settings, simulate};
use crate::model::results::ResultColumn;
use crate::model::run::EndReason;
use crate::model::scene::{InterfaceLaw, Mount, Scene};
use crate::numerics::larger;
use crate::study::compare::load::holds_still;
use crate::study::search::measure::{
    CONTACT_FORCE, DESIGN_MEASURES, FARTHEST, Way, mass_kg, measure, mount_force_n, needs_course,
};
use crate::study::sweep::crew::Crew;
use crate::study::sweep::grid::tells;
use crate::study::sweep::{Axis, Design, Evaluator, Failure, Fate, Plan, Rows, SweepError};

/// Designs a thread takes at once; those that take a whole run each, whose costs differ by far, one by one.
const PIECE: u64 = 16;
const PIECE_OF_RUNS: u64 = 1;

/// What is known of one design.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// What became of it.
    pub fate: Fate,
    /// Its measures, in the order asked for; `None` where one does not exist, or where a number would mislead (the depth of a
    /// perforation).
    pub values: Vec<Option<f64>>,
}

/// A scene, the variables that are changed, and the measures.
#[derive(Clone, Debug)]
pub struct Field {
    plan: Plan,
    measures: Vec<&'static ResultColumn>,
    ways: Vec<Way>,
    farthest: Option<usize>,
    contact: Option<usize>,
    /// The force into the mount is asked for, and the error estimate.
    needs_course: bool,
    estimate: bool,
    /// Steps after which a run is given up.
    steps_max: Option<usize>,
    threads: usize,
}

/// Asked now and then with the designs done; `Break` stops.
pub type Watch<'a> = &'a mut dyn FnMut(usize) -> ControlFlow<()>;

impl Field {
    /// A field over axes, for measures by their names.
    ///
    /// # Errors
    /// A [`SweepError`] when bounds, names or the scene make no sense: then nothing has run.
    pub fn new(
        scene: &Scene,
        axes: Vec<Axis>,
        measures: &[impl AsRef<str>],
        threads: usize,
    ) -> Result<Self, SweepError> {
        let measures: Vec<&'static ResultColumn> =
            measures.iter().map(|name| measure(name.as_ref())).collect::<Result<_, _>>()?;
        let mut outputs: Vec<&str> = Vec::new();
        let mut place = |name: &'static str| {
            outputs.iter().position(|output| *output == name).unwrap_or_else(|| {
                outputs.push(name);
                outputs.len() - 1
            })
        };
        let mut ways = Vec::new();
        let (mut farthest, mut contact) = (None, None);
        for column in &measures {
            let own = DESIGN_MEASURES.iter().any(|other| other.name == column.name);
            ways.push(match column.name {
                "plate_mass_kg" => Way::Masses,
                "peak_mount_force_n" => {
                    if scene.plate.mount == Mount::Rigid {
                        contact = Some(place(CONTACT_FORCE));
                    } else {
                        farthest = Some(place(FARTHEST));
                    }
                    Way::MountForce
                }
                _ if own => {
                    farthest = Some(place(FARTHEST));
                    Way::Masses
                }
                name => Way::Result(place(name)),
            });
        }
        if outputs.is_empty() {
            // What becomes of a design has to be known all the same.
            outputs.push("final_penetration_m");
        }
        // A plan refuses all that a sweep over these axes would refuse.
        let plan = Plan::new(scene, axes, Design::Sobol { points: 2, seed: 0 }, &outputs)?;
        let needs_course = ways.contains(&Way::MountForce);
        let estimate = outputs.contains(&"error_estimate");
        Ok(Self {
            plan,
            measures,
            ways,
            farthest,
            contact,
            needs_course,
            estimate,
            steps_max: None,
            threads,
        })
    }

    /// A field whose runs are given up after so many steps: such a design fails with its step budget used up. A search looks at
    /// many designs; a few whose plate swings millions of times must not take all of its time.
    #[must_use]
    pub fn limited(self, steps: usize) -> Self {
        Self { steps_max: Some(steps), ..self }
    }

    /// The axes.
    pub fn axes(&self) -> &[Axis] {
        self.plan.axes()
    }

    /// The measures, in order.
    pub fn measures(&self) -> &[&'static ResultColumn] {
        &self.measures
    }

    /// The scene whose other variables are held.
    pub fn base(&self) -> &Scene {
        self.plan.base()
    }

    /// The scene of a design: a value for every axis, in the stored unit.
    pub fn scene(&self, design: &[f64]) -> Scene {
        let mut scene = self.plan.base().clone();
        for (axis, value) in self.axes().iter().zip(design) {
            (axis.number().set)(&mut scene, (!value.is_nan()).then_some(*value));
        }
        scene
    }

    /// Evaluate designs, each a value for every axis, in the stored unit (NaN: the variable is absent). `Break`, with what is
    /// done, when it was stopped.
    pub fn evaluate(
        &self,
        designs: &[Vec<f64>],
        watch: Watch<'_>,
    ) -> ControlFlow<Vec<Found>, Vec<Found>> {
        let plan = self.plan.over_points(designs);
        let stop = AtomicBool::new(false);
        let piece = if self.runs_whole() { PIECE_OF_RUNS } else { PIECE };
        let crew = Crew { threads: self.threads, piece };
        let mut all = Vec::with_capacity(designs.len());
        let hire = || {
            let mut evaluator = Evaluator::new(&plan, &stop);
            let (plan, stop) = (&plan, &stop);
            move |points: Range<u64>| self.piece(plan, stop, &mut evaluator, points)
        };
        let ended = crew.work_heard(0..designs.len() as u64, hire, |news| {
            if let Some((points, found)) = news {
                let whole = found.len() as u64 == points.end - points.start;
                all.extend(found);
                if !whole {
                    return ControlFlow::Break(());
                }
            }
            let go_on = watch(all.len());
            if go_on.is_break() {
                stop.store(true, Ordering::Relaxed);
            }
            go_on
        });
        if ended.is_break() { ControlFlow::Break(all) } else { ControlFlow::Continue(all) }
    }

    fn piece<'p>(
        &self,
        plan: &'p Plan,
        stop: &'p AtomicBool,
        evaluator: &mut Evaluator<'p>,
        points: Range<u64>,
    ) -> Vec<Found> {
        let whole =
            catch_unwind(AssertUnwindSafe(|| self.rows((plan, stop), evaluator, points.clone())));
        if let Ok(found) = whole {
            return found;
        }
        // One of them panics: find out which, with evaluators that have not seen it.
        let mut all = Vec::new();
        for point in points {
            let mut fresh = Evaluator::new(plan, stop);
            let work = AssertUnwindSafe(|| self.rows((plan, stop), &mut fresh, point..point + 1));
            match catch_unwind(work) {
                Ok(found) if found.is_empty() => break,
                Ok(found) => all.extend(found),
                Err(_) => all.push(Found {
                    fate: Fate::Failed(Failure::Panicked),
                    values: vec![None; self.measures.len()],
                }),
            }
        }
        all
    }

    fn rows(
        &self,
        (plan, stop): (&Plan, &AtomicBool),
        evaluator: &mut Evaluator<'_>,
        points: Range<u64>,
    ) -> Vec<Found> {
        let by_course = |point: &u64| {
            let course = || self.needs_course && needs_course(&plan.scene(*point));
            (self.steps_max.is_some() && self.runs_whole()) || course()
        };
        let (mut slow, mut quick) = (Vec::new(), Vec::new());
        for point in points.clone() {
            if by_course(&point) { slow.push(point) } else { quick.push(point) }
        }
        let rows = evaluator.rows_of(&quick);
        let mut quickly = (0..rows.len()).zip(&quick).map(|(row, point)| {
            let farthest = self.farthest.and_then(|place| rows.value(row, place));
            if self.needs_course && holds_still(&plan.scene(*point), farthest) {
                return self.course(plan.scene(*point), stop);
            }
            Some(self.found(plan, &rows, row, *point))
        });
        let mut all = Vec::new();
        for point in points {
            // What was stopped is not there: no later point counts.
            let found = if slow.contains(&point) {
                self.course(plan.scene(point), stop)
            } else {
                quickly.next().flatten()
            };
            let Some(found) = found else { break };
            all.push(found);
        }
        all
    }

    fn found(&self, plan: &Plan, rows: &Rows, row: usize, point: u64) -> Found {
        let fate = rows.fate(row);
        let at = |place: Option<usize>| place.and_then(|place| rows.value(row, place));
        let value = |(way, column): (&Way, &&'static ResultColumn)| {
            if !tells(column, fate) {
                return None;
            }
            match way {
                Way::Result(place) => rows.value(row, *place),
                Way::Masses => mass_kg(column.name, &plan.scene(point), at(self.farthest)),
                Way::MountForce => {
                    mount_force_n(&plan.scene(point), at(self.farthest), at(self.contact))
                }
            }
        };
        Found { fate, values: self.ways.iter().zip(&self.measures).map(value).collect() }
    }

    /// Whether there is no quick way: on the plastic law, and where the force into the mount is looked for along the run.
    fn runs_whole(&self) -> bool {
        let scene = self.plan.base();
        let mut far = scene.clone();
        for axis in self.axes() {
            (axis.number().set)(&mut far, Some(larger(axis.ends().0, axis.ends().1)));
        }
        scene.interface.law == InterfaceLaw::Plastic || (self.needs_course && needs_course(&far))
    }

    /// A design by a run, which keeps its series where that is looked at; `None` when it was stopped.
    fn course(&self, scene: Scene, stop: &AtomicBool) -> Option<Found> {
        let settings = Settings { series: self.needs_course, estimate: self.estimate };
        let mut steps = 0;
        let mut observer = |_t_s: f64| {
            steps += 1;
            let given_up = self.steps_max.is_some_and(|most| steps > most);
            if given_up || stop.load(Ordering::Relaxed) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let Ok(run) = simulate(&Arc::new(scene), &settings, &mut observer) else {
            let fate = Fate::Failed(Failure::Refused);
            return Some(Found { fate, values: vec![None; self.measures.len()] });
        };
        if run.end == EndReason::Cancelled {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let fate = Fate::Failed(Failure::Early(EndReason::StepBudget));
            return Some(Found { fate, values: vec![None; self.measures.len()] });
        }
        let fate = Fate::of(&run);
        let value = |column: &&'static ResultColumn| {
            tells(column, fate).then(|| column.value(&run)).flatten()
        };
        Some(Found { fate, values: self.measures.iter().map(value).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mechanism::Mechanism;
    use crate::study::sweep::Spacing;

    fn axes(list: &[(&str, f64, f64)]) -> Vec<Axis> {
        let axis = |(name, low, high): &(&str, f64, f64)| {
            Axis::new(name, (*low, *high), 2, Spacing::Linear).unwrap()
        };
        list.iter().map(axis).collect()
    }

    fn go_on(_: usize) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn whole(ended: ControlFlow<Vec<Found>, Vec<Found>>) -> Vec<Found> {
        match ended {
            ControlFlow::Continue(found) => found,
            ControlFlow::Break(_) => panic!("stopped"),
        }
    }

    const FOUR: [&str; 4] =
        ["final_penetration_m", "stroke_m", "system_mass_kg", "peak_mount_force_n"];

    /// Depth and stroke are those of a run of its own; the spring's energy and force follow from its law.
    #[test]
    fn measures_are_those_of_single_runs_whatever_the_threads() {
        let bounds = axes(&[("gamma", 0.8, 7.0), ("k", 1e3, 7.5e6), ("b", 0.0, 100.0)]);
        let designs =
            [vec![1.0, 1e5, 0.0], vec![2.0, 1e6, 0.0], vec![1.0, 1e5, 50.0], vec![0.8, 7.5e6, 0.0]];
        let with = |threads| {
            let field = Field::new(&Scene::default(), bounds.clone(), &FOUR, threads).unwrap();
            (whole(field.evaluate(&designs, &mut go_on)), field)
        };
        let (found, field) = with(1);
        assert_eq!(found, with(3).0);
        for (design, found) in designs.iter().zip(&found) {
            let scene = Arc::new(field.scene(design));
            let settings = Settings { series: true, estimate: false };
            let run = simulate(&scene, &settings, &mut |_| ControlFlow::Continue(())).unwrap();
            let close = |value: Option<f64>, exact: Option<f64>| {
                let (value, exact) = (value.unwrap(), exact.unwrap());
                assert!((value - exact).abs() <= 1e-7 * exact, "{design:?}: {value} {exact}");
            };
            close(found.values[0], run.final_penetration_m);
            close(found.values[1], run.stroke_m());
            let farthest = run.max_plate_displacement_m.unwrap();
            let energy = 0.5 * design[1] * farthest * farthest;
            let kg = design[0] * 0.0295 + SPRING_FOR_TEST * energy;
            close(found.values[2], Some(kg));
            let damper = Mechanism::of(&scene).damper;
            let force = |row: &crate::model::run::Sample| {
                design[1] * row.plate_displacement_m + damper.force(row.plate_velocity_m_s)
            };
            let sampled = run.series.iter().map(force).fold(design[1] * farthest, f64::max);
            close(found.values[3], Some(sampled));
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
        // The second swings thousands of times on a spring of small exponent before it is decided.
        let designs =
            [vec![1.0, 1e5, 1.0, 0.0, 0.0], vec![4.2875, 3_281_250.0, 0.546_875, 0.406_25, 375.0]];
        let field = Field::new(&scene, bounds, &["final_penetration_m", "stroke_m"], 1).unwrap();
        let free = whole(field.evaluate(&designs, &mut go_on));
        let found = whole(field.limited(1000).evaluate(&designs, &mut go_on));
        assert_eq!(found[0], free[0]);
        assert_eq!(free[1].fate, Fate::Arrested);
        assert_eq!(found[1].fate, Fate::Failed(Failure::Early(EndReason::StepBudget)));
        assert_eq!(found[1].values, [None, None]);
    }

    #[test]
    fn what_perforates_has_no_depth_and_a_stop_keeps_what_is_done() {
        let field = Field::new(&Scene::default(), axes(&[("v_i", 50.0, 900.0)]), &FOUR, 1).unwrap();
        let found = whole(field.evaluate(&[vec![100.0], vec![800.0]], &mut go_on));
        assert_eq!(found[1].fate, Fate::Perforated);
        assert!(found[1].values.iter().all(Option::is_none) && found[0].values[0].is_some());
        let many = vec![vec![100.0]; 200];
        let stopped = field.evaluate(&many, &mut |done| {
            if done > 40 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert!(matches!(stopped, ControlFlow::Break(part) if part.len() > 40 && part.len() < 200));
    }

    #[test]
    fn bad_names_and_bounds_are_refused_before_anything_runs() {
        let scene = Scene::default();
        let error = Field::new(&scene, axes(&[("k", 0.0, 1e5)]), &["mass"], 1).unwrap_err();
        assert!(error.to_string().contains("system_mass_kg"), "{error}");
        assert!(Field::new(&scene, Vec::new(), &["stroke_m"], 1).is_err());
    }
}
