//! Which variables matter: one at a time (tornado), and Sobol's first and total indices, both over the same bounds and for one result.
//!
//! Inputs are uniform, or uniform in their logarithm, between their bounds, and independent. A point without a value (perforated,
//! say, where a depth is requested) is omitted and counted. Must not know files, screens or a clock.

use std::fmt;
use std::ops::RangeInclusive;

use crate::model::run::envelope::Check;
use crate::model::scene::Scene;
use crate::numerics::statistics::sorted_by;
use crate::study::context::Context;
use crate::study::monte_carlo::{Distribution, USUAL_DEVIATION, usual_tolerances};
use crate::study::option;
use crate::study::quantities::{Quantity, usual_of};
use crate::study::sweep::usual::{or_usual, thesis_axes};
use crate::study::sweep::{Axis, Plan, Point, Spacing, SweepError};
use crate::study::validity;
use indices::{Sobol, sobol};

pub mod indices;

/// A function of points of the unit cube, many at once; NaN where it has no value, `None` when it was stopped.
pub type Function<'a> = &'a mut dyn FnMut(&[Vec<f64>]) -> Option<Vec<f64>>;

/// Samples for Sobol's indices, and how many are taken where nothing is said.
pub const SAMPLES: RangeInclusive<usize> = 16..=1 << 20;
const SAMPLES_USUAL: usize = 1024;

/// What is to be known.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The variables and their bounds; empty: those of [`usual_axes`].
    pub over: Vec<Axis>,
    /// The result; `None`: [`usual_of`] the scene.
    pub output: Option<&'static Quantity>,
    /// Base samples for Sobol's indices, a power of two.
    pub samples: usize,
    /// Seed: the same gives the same digits.
    pub seed: u64,
}

impl Default for Request {
    fn default() -> Self {
        Self { over: Vec::new(), output: None, samples: SAMPLES_USUAL, seed: 1 }
    }
}

/// The command's name and options.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let over: String = self.over.iter().map(|it| option("over", Some(it))).collect();
        let (output, usual) = (option("output", self.output.map(|it| it.name)), Self::default());
        let samples = option("samples", Some(self.samples).filter(|it| *it != usual.samples));
        let seed = option("seed", Some(self.seed).filter(|it| *it != usual.seed));
        write!(f, "sensitivity{over}{output}{samples}{seed}")
    }
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
    pub output: &'static Quantity,
    /// Seed of the samples.
    pub seed: u64,
    /// Base samples.
    pub samples: usize,
    /// The result of the scene itself.
    pub own: Option<f64>,
    /// Checks of the model's validity that fail at an end of an axis and not for the scene itself, each with its warning.
    pub outside_at_ends: Vec<(Check, String)>,
    /// The tornado, variable by variable.
    pub bars: Vec<Bar>,
    /// Sobol's indices; `None` when stopped.
    pub sobol: Option<Sobol>,
}

impl Report {
    /// Whether neither the scene nor any end of a variable nor any sample has the result.
    pub fn is_empty(&self) -> bool {
        self.own.is_none()
            && self.bars.iter().all(|bar| bar.swing().is_none())
            && self.sobol.as_ref().is_none_or(|sobol| sobol.used == 0)
    }

    /// The variables by Sobol's total index, the greatest first; by the tornado where there is none.
    pub fn order(&self) -> Vec<usize> {
        let weight = |at: usize| {
            let total = self.sobol.as_ref().and_then(|sobol| sobol.inputs[at].total);
            total.map(|index| index.value).or_else(|| self.bars[at].swing()).unwrap_or(0.0)
        };
        sorted_by((0..self.axes.len()).collect(), |at| -weight(*at))
    }
}

/// Half the range of an input that scatters, relative: two of its standard deviations.
pub const SCATTER: f64 = 2.0 * USUAL_DEVIATION;

/// What varies where nothing is named: the variables of Table 9.2 over its ranges, and within [`SCATTER`] whatever else a Monte Carlo
/// study scatters, as long as no values of theirs exclude each other.
pub fn usual_axes(scene: &Scene) -> Result<Vec<Axis>, SweepError> {
    let mut axes = thesis_axes(scene)?;
    for tolerance in usual_tolerances(scene, USUAL_DEVIATION) {
        let Distribution(_, (median, _)) = tolerance.distribution;
        let ends = (median * (1.0 - SCATTER), median * (1.0 + SCATTER));
        let Ok(axis) = Axis::new(tolerance.symbol(), ends, 2, Spacing::Linear) else { continue };
        axes.push(axis);
        if axes.len() > indices::INPUTS_MAX
            || Plan::for_designs(scene, axes.clone(), &[] as &[&str]).is_err()
        {
            axes.pop();
        }
    }
    Ok(axes)
}

/// Find out.
///
/// # Errors
/// A [`SweepError`] when bounds or result are bad, or there are more than [`indices::INPUTS_MAX`] variables: then nothing has run.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, Report>,
) -> Result<Report, SweepError> {
    let axes = or_usual(&request.over, || usual_axes(scene))?;
    if axes.len() > indices::INPUTS_MAX {
        return Err(SweepError::too_many_axes(axes.len(), indices::INPUTS_MAX));
    }
    let output = request.output.map_or_else(|| usual_of(scene), |it| it.name);
    let space = Plan::for_designs(scene, axes, &[output])?;
    let axes = space.axes().to_vec();
    let output = space.outputs()[0];
    output.check_exists(scene)?;
    let inputs = axes.len();
    let own = space.design_of(scene);
    context.expect(1 + 2 * inputs + request.samples * (inputs + 2));
    // The result for each design, NaN where it has none; `None` when stopped.
    let mut values = |designs: &[Vec<f64>]| {
        let found = space.evaluate(designs, context);
        let value = |found: &Point| found.values[0].unwrap_or(f64::NAN);
        (!context.is_stopped()).then(|| found.iter().map(value).collect::<Vec<_>>())
    };
    let at_own = values(std::slice::from_ref(&own));
    let mut ends = Vec::new();
    for (at, axis) in axes.iter().enumerate() {
        for end in [axis.ends().0, axis.ends().1] {
            let mut design = own.clone();
            design[at] = end;
            ends.push(design);
        }
    }
    let ends = values(&ends).unwrap_or_else(|| vec![f64::NAN; 2 * inputs]);
    let known = |value: f64| value.is_finite().then_some(value);
    let bars = ends.chunks(2).map(|pair| Bar { low: known(pair[0]), high: known(pair[1]) });
    let mut function = |points: &[Vec<f64>]| {
        let place = |point: &Vec<f64>| {
            axes.iter().zip(point).map(|(axis, share)| axis.at_share(*share)).collect()
        };
        let designs: Vec<Vec<f64>> = points.iter().map(place).collect();
        values(&designs)
    };
    let sobol = sobol(inputs, request.samples, request.seed, &mut function);
    Ok(Report {
        own: at_own.and_then(|values| known(values[0])),
        bars: bars.collect(),
        sobol,
        output,
        seed: request.seed,
        samples: request.samples,
        outside_at_ends: validity::new_at_ends(scene, &axes),
        axes,
    })
}

#[cfg(test)]
mod tests;
