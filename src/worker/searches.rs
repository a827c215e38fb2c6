//! Searches as studies of the background thread: goal seek, fronts, sensitivity, scatter, and the comparison at equal areal mass.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::scene::Scene;
use crate::study::compare::map::{self, Map};
use crate::study::compare::{self, Hardware};
use crate::study::context::{Context, Progress};
use crate::study::monte_carlo;
use crate::study::search::front::{self, Front, Task};
use crate::study::search::seek::{self, Goal};
use crate::study::sensitivity;
use crate::study::sweep::Axis;

/// Points along each axis of the map of the mass efficiency.
const MAP_POINTS: u64 = 41;

/// What is looked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Which values of a variable give a wanted result.
    Seek(Goal),
    /// The designs that nothing beats.
    Front(Task),
    /// Which variables matter to a result.
    Sensitivity {
        /// The variables and their bounds.
        axes: Vec<Axis>,
        /// The result.
        output: String,
        /// How much is done.
        effort: sensitivity::Effort,
    },
    /// How results scatter when inputs do.
    MonteCarlo(monte_carlo::Task),
    /// The comparison at equal areal mass, and its map.
    Compare,
}

/// What was found.
#[derive(Clone, Debug)]
pub enum Answer {
    /// See [`Request::Seek`].
    Seek(Arc<seek::Report>),
    /// See [`Request::Front`]; the first law's.
    Front(Arc<Front>),
    /// See [`Request::Sensitivity`].
    Sensitivity(Arc<sensitivity::Report>),
    /// See [`Request::MonteCarlo`].
    MonteCarlo(Arc<monte_carlo::Report>),
    /// See [`Request::Compare`].
    Compare(Arc<Comparison>),
}

/// A comparison at equal areal mass with its map, where there is one.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The candidates.
    pub report: compare::Report,
    /// Mass efficiency over impact velocity and mass ratio.
    pub map: Option<Map>,
}

/// Given how far a search is, and what there is to show so far; `Break` stops.
pub(super) type Tell<'a> =
    &'a mut dyn FnMut(Progress, &dyn Fn() -> Option<Answer>) -> ControlFlow<()>;

/// Look; what there is when it is stopped is kept.
pub(super) fn make(
    scene: &Arc<Scene>,
    request: &Request,
    threads: usize,
    tell: Tell<'_>,
) -> Result<Answer, String> {
    let mut plain = |progress, _: Option<&()>| tell(progress, &|| None);
    match request {
        Request::Seek(goal) => seek::seek(scene, goal, &mut Context::new(threads, &mut plain))
            .map(|report| Answer::Seek(Arc::new(report)))
            .map_err(|error| error.to_string()),
        Request::Front(task) => {
            let watch = &mut |progress, so_far: Option<&Front>| {
                tell(progress, &|| so_far.map(|front| Answer::Front(Arc::new(front.clone()))))
            };
            let fronts = front::optimise(scene, task, &mut Context::new(threads, watch));
            let fronts = fronts.map_err(|error| error.to_string())?;
            let front = fronts.into_iter().next().ok_or("no interface law was given")?;
            Ok(Answer::Front(Arc::new(front)))
        }
        Request::Sensitivity { axes, output, effort } => {
            let context = &mut Context::new(threads, &mut plain);
            sensitivity::study(scene, axes.clone(), output, *effort, context)
                .map(|report| Answer::Sensitivity(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        Request::MonteCarlo(task) => {
            monte_carlo::sample(scene, task, &mut Context::new(threads, &mut plain))
                .map(|report| Answer::MonteCarlo(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        Request::Compare => compared(scene, threads, tell),
    }
}

/// The comparison with its map around the scene; a scene without such a map, a stack for one, has none.
fn compared(scene: &Arc<Scene>, threads: usize, tell: Tell<'_>) -> Result<Answer, String> {
    let axes = [("v_i", MAP_POINTS), ("gamma", MAP_POINTS)]
        .map(|(name, count)| map::usual_axis(scene, name, count).ok());
    let points = usize::try_from(MAP_POINTS * MAP_POINTS).unwrap_or(usize::MAX);
    let whole = points + compare::Candidate::ALL.len();
    let of_all =
        |progress: Progress, before: usize| Progress { done: before + progress.done, total: whole };
    let watch = &mut |progress, _: Option<&()>| tell(of_all(progress, 0), &|| None);
    let report = compare::compare(scene, Hardware::default(), &mut Context::new(1, watch));
    let report = report.map_err(|error| error.to_string())?;
    let [Some(x), Some(y)] = axes else {
        return Ok(Answer::Compare(Arc::new(Comparison { report, map: None })));
    };
    if !report.is_complete {
        return Ok(Answer::Compare(Arc::new(Comparison { report, map: None })));
    }
    let part = || {
        let comparison = Comparison { report: report.clone(), map: None };
        Some(Answer::Compare(Arc::new(comparison)))
    };
    let done = whole - points;
    let watch = &mut |progress, _: Option<&()>| tell(of_all(progress, done), &part);
    let context = &mut Context::new(threads, watch);
    let map = Map::compute(scene, &[x, y], Hardware::default(), context).ok();
    Ok(Answer::Compare(Arc::new(Comparison { report, map })))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::scene::InterfaceLaw;
    use crate::study::search::nsga::Effort;
    use crate::study::sweep::Spacing;

    fn axis(name: &str, ends: (f64, f64), count: u64) -> Axis {
        Axis::new(name, ends, count, Spacing::Linear).unwrap()
    }

    fn front_request() -> Request {
        Request::Front(Task {
            axes: vec![axis("gamma", (0.8, 7.0), 2), axis("k", (1e3, 7.5e6), 2)],
            objectives: front::objectives(&["final_penetration_m", "stroke_m"], &[] as &[&str])
                .unwrap(),
            constraints: Vec::new(),
            laws: vec![InterfaceLaw::Fused],
            effort: Effort { population: 20, generations: 20, seed: 1 },
        })
    }

    #[test]
    fn a_front_shows_its_parts_and_keeps_them_when_stopped() {
        let mut parts = 0;
        let mut tell = |progress: Progress, part: &dyn Fn() -> Option<Answer>| {
            parts += usize::from(matches!(part(), Some(Answer::Front(_))));
            if progress.done > 200 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let answer = make(&Arc::default(), &front_request(), 1, &mut tell).unwrap();
        let Answer::Front(front) = answer else { panic!("not a front") };
        assert!(parts >= 8 && !front.is_complete && !front.designs.is_empty(), "{parts}");
        assert!(front.runs > 200 && front.runs < 420);
    }

    #[test]
    fn what_makes_no_sense_is_refused_in_words() {
        let goal = |measure: &str| Goal {
            axis: axis("k", (0.0, 1e6), 9),
            measure: measure.to_owned(),
            target: 60.0,
        };
        let go_on: Tell<'_> = &mut |_, _| ControlFlow::Continue(());
        let refused = make(&Arc::default(), &Request::Seek(goal("depth")), 1, go_on).unwrap_err();
        assert!(refused.contains("output depth"), "{refused}");
        let found = make(&Arc::default(), &Request::Seek(goal("percent_of_baseline")), 1, go_on);
        assert!(matches!(found, Ok(Answer::Seek(report)) if report.solutions.is_empty()));
        let none = Request::Sensitivity {
            axes: Vec::new(),
            output: "stroke_m".to_owned(),
            effort: sensitivity::Effort { rows: 16, trajectories: 2, seed: 1 },
        };
        assert!(make(&Arc::default(), &none, 1, go_on).is_err());
    }
}
