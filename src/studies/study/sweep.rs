//! Sweeps: results of a scene at every point of one or more axes.
//!
//! A [`Plan`] is validated before the first run. Points are computed from their index: a sweep of 10^8 points needs no memory, and any part
//! (a [`Shard`]) can be computed in any order, on any number of threads and computers, with the same digits. `evaluate` computes the
//! results of a point; only `study/parallel.rs` starts threads. A point has an outcome, and values of the quantities that exist for it.
//! This module depends on neither files nor screens nor the command line nor a clock.

pub mod axis;
pub mod default_axes;
mod designs;
pub mod evaluate;
pub mod grid;
pub(in crate::study) mod kernel;

use std::sync::Arc;

pub use crate::study::error::{AxisProblem, StudyError};
use crate::study::library;
pub use crate::study::outcome::{Failure, PointOutcome};
use crate::study::quantities::{Quantity, named};
pub use axis::{Axis, COUNTS, Spacing};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units;
use cmra_engine::model::variables;
pub use evaluate::{Evaluator, Point};

/// Maximum number of points: the largest count that is exact in floating point.
const POINTS_MAX: u64 = 1 << 53;
/// Maximum number of axes.
pub const AXES_MAX: usize = 12;

/// Default outputs: the two results of the thesis's figures.
pub const DEFAULT_OUTPUTS: [&str; 2] = ["percent_of_baseline", "max_plate_displacement_m"];

/// Returns the default outputs for a scene; for a stack its depth.
pub fn default_outputs(scene: &Scene) -> &'static [&'static str] {
    if scene.is_stack() { &["final_penetration_m"] } else { &DEFAULT_OUTPUTS }
}

/// Part of a sweep: every `count`-th point, starting with point `index` (counted from 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl Shard {
    /// Complete sweep.
    pub const WHOLE: Self = Self { index: 1, count: 1 };

    /// Parses `I/N`.
    ///
    /// # Errors
    /// [`StudyError`] unless 1 <= I <= N.
    pub fn parse(text: &str) -> Result<Self, StudyError> {
        let refuse = || StudyError::Shard { shard: text.to_owned() };
        let (index, count) = text.split_once('/').ok_or_else(refuse)?;
        let read = |part: &str| part.trim().parse::<u64>().ok();
        let (index, count) = read(index).zip(read(count)).ok_or_else(refuse)?;
        if index == 0 || index > count {
            return Err(refuse());
        }
        Ok(Self { index, count })
    }

    /// Returns the number of points of the part, out of all points.
    pub fn count(self, points: u64) -> u64 {
        (points + self.count - self.index) / self.count
    }

    /// Returns the index of the point in row `row` of the part.
    pub fn point(self, row: u64) -> u64 {
        self.index - 1 + row * self.count
    }
}

/// Validated sweep. Equal plans give equal results.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    base: Scene,
    axes: Vec<Axis>,
    points: u64,
    outputs: Vec<&'static Quantity>,
    /// Listed points in place of a grid: a value on every axis for each.
    list: Option<Arc<[f64]>>,
    /// Maximum number of steps of a run.
    steps_max: Option<usize>,
}

impl Plan {
    /// Creates a sweep over every combination of the values of the axes; the last axis varies fastest. The outputs are names of quantities.
    ///
    /// # Errors
    /// [`StudyError`] if an argument is invalid.
    pub fn new(
        scene: &Scene,
        axes: Vec<Axis>,
        outputs: &[impl AsRef<str>],
    ) -> Result<Self, StudyError> {
        if axes.len() > AXES_MAX {
            return Err(StudyError::TooManyAxes { count: axes.len(), most: AXES_MAX });
        }
        let points = points(&axes)?;
        Ok(Self { points, ..Self::for_designs(scene, axes, outputs)? })
    }

    /// Creates a plan for designs that are listed later, with any number of axes.
    pub fn for_designs(
        scene: &Scene,
        axes: Vec<Axis>,
        outputs: &[impl AsRef<str>],
    ) -> Result<Self, StudyError> {
        if axes.is_empty() {
            return Err(StudyError::NoAxis);
        }
        for (index, axis) in axes.iter().enumerate() {
            let excludes =
                |it: &&Axis| variables::exclude_each_other(it.variable(), axis.variable());
            let symbol = axis.symbol();
            let problem = match axes[..index].iter().find(excludes).map(Axis::symbol) {
                None => continue,
                Some(other) if other == symbol => AxisProblem::SweptTwice,
                Some(other) => AxisProblem::TwoSizes { other },
            };
            return Err(StudyError::axis(symbol, problem));
        }
        one_size(scene, &axes)?;
        let outputs = outputs.iter().map(|name| named(name.as_ref())).collect::<Result<_, _>>()?;
        let mut base = scene.clone();
        (base.title, base.sweep) = (String::new(), None);
        let warnings = scene.notes.lines().filter(|line| library::is_warning(line));
        base.notes = warnings.collect::<Vec<&str>>().join("\n");
        let mut plan = Self { base, axes, points: 0, outputs, list: None, steps_max: None };
        plan.check_corners()?;
        // The axes replace these values of the scene: plans that differ only in them are equal.
        for axis in &plan.axes {
            axis.set(&mut plan.base, axis.ends().0);
        }
        Ok(plan)
    }

    /// Limits the number of steps of each run; a run beyond the limit fails. In a search, a few plates with millions of oscillations would
    /// otherwise take most of the time.
    #[must_use]
    pub fn limited(self, steps: usize) -> Self {
        Self { steps_max: Some(steps), ..self }
    }

    /// Creates the sweep that a scene contains.
    pub fn from_scene(scene: &Scene) -> Result<Self, StudyError> {
        let sweep = scene.sweep.as_ref().ok_or(StudyError::NoAxis)?;
        Self::new(scene, Axis::all_of(sweep)?, &sweep.outputs)
    }

    /// Returns the scene with the values of all other variables, without title and sweep; its notes are reduced to warnings of library
    /// entries.
    pub fn base(&self) -> &Scene {
        &self.base
    }

    /// Returns the axes.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Returns the number of points.
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Returns the requested quantities.
    pub fn outputs(&self) -> &[&'static Quantity] {
        &self.outputs
    }

    /// Returns the value of axis `axis` at point `index`, in the stored unit.
    pub fn coordinate(&self, index: u64, axis: usize) -> f64 {
        if let Some(list) = &self.list {
            let at = usize::try_from(index).unwrap_or(usize::MAX);
            return list[at * self.axes.len() + axis];
        }
        let faster: u64 = self.axes[axis + 1..].iter().map(Axis::count).product();
        self.axes[axis].value(index / faster % self.axes[axis].count())
    }

    /// Sets the values of point `index` in a scene.
    pub fn place(&self, scene: &mut Scene, index: u64) {
        for (at, axis) in self.axes.iter().enumerate() {
            axis.set(scene, self.coordinate(index, at));
        }
    }

    /// Returns the scene at point `index`.
    pub fn scene(&self, index: u64) -> Scene {
        let mut scene = self.base.clone();
        self.place(&mut scene, index);
        scene
    }

    /// Returns the scene of a design, which has a value for every axis in its stored unit.
    pub fn scene_of(&self, design: &[f64]) -> Scene {
        axis::scene_with(&self.base, &self.axes, design)
    }

    /// Returns the values of a scene on every axis; NaN for an absent variable.
    pub fn design_of(&self, scene: &Scene) -> Vec<f64> {
        self.axes.iter().map(|axis| axis.get(scene).unwrap_or(f64::NAN)).collect()
    }

    /// Checks the rules between variables at every corner of the box of axes. They are linear: valid corners imply a valid interior.
    fn check_corners(&self) -> Result<(), StudyError> {
        // With more axes there are only listed points, each of which is checked.
        for corner in 0..1u32 << self.axes.len().min(AXES_MAX) {
            let mut scene = self.base.clone();
            let mut place = Vec::new();
            for (bit, axis) in self.axes.iter().enumerate() {
                let (from, to) = axis.ends();
                let value = if corner >> bit & 1 == 0 { from } else { to };
                axis.set(&mut scene, value);
                place.push(format!("{}={}", axis.symbol(), units::shortest(value)));
            }
            variables::validate(&scene).map_err(|source| StudyError::Corner {
                place: place.join(" "),
                source: Box::new(source),
            })?;
        }
        Ok(())
    }
}

/// Rejects an axis over the size of the plate if the scene sets it by another variable, which the axis would silently replace.
fn one_size(scene: &Scene, axes: &[Axis]) -> Result<(), StudyError> {
    let overrules = |axis: &&Axis| variables::overrules_size(axis.variable(), scene);
    let Some(axis) = axes.iter().find(overrules).map(Axis::symbol) else { return Ok(()) };
    let Ok(given) = variables::find(scene.plate.size.key()) else { return Ok(()) };
    let value = format!("{} {}", given.show(scene), given.unit());
    Err(StudyError::TwoSizes { axis, symbol: given.symbol, value })
}

fn points(axes: &[Axis]) -> Result<u64, StudyError> {
    let product = axes.iter().try_fold(1u64, |all, axis| all.checked_mul(axis.count()));
    product.filter(|points| *points <= POINTS_MAX).ok_or_else(|| {
        let all: f64 = axes.iter().map(|axis| axis.count() as f64).product();
        let most = POINTS_MAX as f64;
        StudyError::TooManyPoints { points: format!("{all:.1e}"), most: format!("{most:e}") }
    })
}

#[cfg(test)]
mod tests;
