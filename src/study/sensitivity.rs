//! Which variables matter: one at a time (tornado), Morris's elementary effects, and Sobol's first and total indices, all over the
//! same bounds and for one result.
//!
//! Inputs are uniform, or uniform in their logarithm, between their bounds, and independent. A point without a value (perforated,
//! say, where a depth is asked for) is left out and counted. Must not know files, screens or a clock.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::impact::{Settings, simulate};
use crate::model::results::ResultColumn;
use crate::model::scene::Scene;
use crate::model::variables::{self, Kind, VARIABLES};
use crate::study::sweep::crew::Crew;
use crate::study::sweep::{Axis, Design, Plan, Spacing, SweepError};
use effects::{Effect, morris};
use indices::{Sobol, sobol};

pub mod effects;
pub mod indices;

/// A function of points of the unit cube, many at once; NaN where it has no value, `None` when it was stopped.
pub type Function<'a> = &'a mut dyn FnMut(&[Vec<f64>]) -> Option<Vec<f64>>;

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Rows of the design for Sobol's indices, a power of two.
    pub rows: usize,
    /// Morris's trajectories.
    pub trajectories: usize,
    /// Seed of both.
    pub seed: u64,
    /// Threads; no digit depends on it.
    pub threads: usize,
}

/// One bar of the tornado: the result with one variable at its bounds, the others as in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// With the variable at its first bound.
    pub low: Option<f64>,
    /// At its last.
    pub high: Option<f64>,
}

impl Bar {
    /// How far apart they are.
    pub fn swing(self) -> Option<f64> {
        Some((self.high? - self.low?).abs())
    }
}

/// All that was found.
#[derive(Clone, Debug)]
pub struct Report {
    /// The variables and their bounds.
    pub axes: Vec<Axis>,
    /// The result.
    pub output: &'static ResultColumn,
    /// What was asked for.
    pub effort: Effort,
    /// The result of the scene itself.
    pub own: Option<f64>,
    /// The tornado, variable by variable.
    pub bars: Vec<Bar>,
    /// Morris's effects; empty when stopped.
    pub effects: Vec<Effect>,
    /// Sobol's indices; `None` when stopped.
    pub sobol: Option<Sobol>,
}

impl Report {
    /// The variables by Sobol's total index, the greatest first; by the tornado where there is none.
    pub fn order(&self) -> Vec<usize> {
        let weight = |at: usize| {
            let total = self.sobol.as_ref().and_then(|sobol| sobol.inputs[at].total);
            total.map(|index| index.value).or_else(|| self.bars[at].swing()).unwrap_or(0.0)
        };
        let mut order: Vec<usize> = (0..self.axes.len()).collect();
        order.sort_by(|a, b| weight(*b).total_cmp(&weight(*a)));
        order
    }
}

/// Asked now and then with the runs done and how many there are; `Break` stops, and keeps what there is.
pub type Watch<'a> = &'a mut dyn FnMut(usize, usize) -> ControlFlow<()>;

/// The bounds of Table 9.2 for every variable that has some and an effect within them.
///
/// # Errors
/// None in practice: the table's ranges are sound.
pub fn thesis_axes(scene: &Scene) -> Result<Vec<Axis>, SweepError> {
    let ranges = || {
        VARIABLES.iter().filter_map(|variable| match &variable.kind {
            Kind::Number(number) => Some((variable, number, number.thesis_range?)),
            Kind::Choice(_) | Kind::Switch { .. } => None,
        })
    };
    // A spring's exponent matters where there is a spring: judged with every range at its end.
    let mut far = scene.clone();
    for (_, number, (_, high)) in ranges() {
        (number.set)(&mut far, Some(high));
    }
    ranges()
        .filter(|(variable, ..)| variables::is_used(variable, &far))
        .map(|(variable, _, ends)| Axis::new(variable.symbol, ends, 2, Spacing::Linear))
        .collect()
}

/// Find out.
///
/// # Errors
/// A [`SweepError`] when bounds or result are bad, or there are more than [`indices::INPUTS_MAX`] variables: then nothing has run.
pub fn study(
    scene: &Scene,
    axes: Vec<Axis>,
    output: &str,
    effort: Effort,
    watch: Watch<'_>,
) -> Result<Report, SweepError> {
    if axes.len() > indices::INPUTS_MAX {
        return Err(SweepError::TooManyAxes { count: axes.len(), most: indices::INPUTS_MAX });
    }
    // A plan refuses all that a sweep over these axes would refuse.
    let design = Design::Sobol { points: effort.rows as u64, seed: effort.seed };
    let plan = Plan::new(scene, axes, design, &[output])?;
    let (axes, output) = (plan.axes().to_vec(), plan.outputs()[0]);
    let inputs = axes.len();
    let total = 1 + 2 * inputs + effort.trajectories * (inputs + 1) + effort.rows * (inputs + 2);
    let mut range = Range { output, threads: effort.threads, watch, done: 0, total };
    let own = range.values(vec![scene.clone()]);
    let ends = axes.iter().flat_map(|axis| [axis.ends().0, axis.ends().1].map(|end| (axis, end)));
    let scenes = ends.map(|(axis, end)| {
        let mut scene = scene.clone();
        (axis.number().set)(&mut scene, Some(end));
        scene
    });
    let ends = range.values(scenes.collect()).unwrap_or_else(|| vec![f64::NAN; 2 * inputs]);
    let known = |value: f64| value.is_finite().then_some(value);
    let bars = ends.chunks(2).map(|pair| Bar { low: known(pair[0]), high: known(pair[1]) });
    let mut function = |points: &[Vec<f64>]| {
        let place = |point: &Vec<f64>| {
            let mut scene = scene.clone();
            for (axis, share) in axes.iter().zip(point) {
                (axis.number().set)(&mut scene, Some(axis.at_share(*share)));
            }
            scene
        };
        range.values(points.iter().map(place).collect())
    };
    let effects = morris(inputs, effort.trajectories, effort.seed, &mut function);
    let sobol = sobol(inputs, effort.rows, effort.seed, &mut function);
    Ok(Report {
        own: own.and_then(|values| known(values[0])),
        bars: bars.collect(),
        effects: effects.unwrap_or_default(),
        sobol,
        output,
        effort,
        axes,
    })
}

/// Where scenes are run.
struct Range<'w> {
    output: &'static ResultColumn,
    threads: usize,
    watch: Watch<'w>,
    done: usize,
    total: usize,
}

impl Range<'_> {
    /// The result for each scene, NaN where it has none; `None` when stopped.
    fn values(&mut self, scenes: Vec<Scene>) -> Option<Vec<f64>> {
        let scenes: Vec<Arc<Scene>> = scenes.into_iter().map(Arc::new).collect();
        let output = self.output;
        let estimate = output.name == "error_estimate";
        let settings = Settings { series: false, estimate };
        let one = |scene: &Arc<Scene>| {
            let run = simulate(scene, &settings, &mut |_| ControlFlow::Continue(()));
            let told = run.ok().filter(|run| run.end.is_complete());
            told.and_then(|run| output.value(&run)).unwrap_or(f64::NAN)
        };
        let crew = Crew { threads: self.threads, piece: 16 };
        let mut values = Vec::with_capacity(scenes.len());
        let piece = |range: std::ops::Range<u64>| {
            let at = |index: u64| usize::try_from(index).ok().and_then(|at| scenes.get(at));
            range.filter_map(at).map(one).collect::<Vec<f64>>()
        };
        let (done, total) = (self.done, self.total);
        let watch = &mut *self.watch;
        let ended = crew.work(
            0..scenes.len() as u64,
            || piece,
            |_, found: Vec<f64>| {
                values.extend(found);
                watch(done + values.len(), total)
            },
        );
        self.done += values.len();
        ended.is_continue().then_some(values)
    }
}

#[cfg(test)]
mod tests;
