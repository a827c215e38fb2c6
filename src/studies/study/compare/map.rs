//! A map of the mass efficiency over two variables, computed coarse first.

use std::ops::Range;

use crate::study::compare::hardware::Hardware;
use crate::study::compare::hold_spring_mass;
use crate::study::compare::sizing::{Absence, mass_efficiency};
use crate::study::context::{Context, Work};
use crate::study::sweep::axis::numeric;
use crate::study::sweep::{Axis, Plan, Spacing, StudyError};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;
use cmra_engine::numerics::larger;

/// Points a thread computes at once.
const PIECE: u64 = 16;
/// Distance between the points of each pass: until a point is computed, one of a coarser pass stands for it.
const STRIDES: [usize; 5] = [16, 8, 4, 2, 1];
/// Points along an axis, if none is given.
pub const DEFAULT_COUNT: u64 = 41;
/// A result that the plan of a map has: the map itself has none of a sweep.
const OUTPUT: &str = "final_penetration_m";
/// Relative width to which thicknesses are closed in, and the tolerance of the shots, at least: the efficiency is as good.
const WIDTH: f64 = 1e-5;
const TOLERANCE: f64 = 1e-6;
/// Least and greatest value of a usual axis over the scene's own value; of the impact velocity, of any other variable.
const AROUND_VELOCITY: (f64, f64) = (0.1, 2.0);
const AROUND: (f64, f64) = (0.1, 10.0);

/// Mass efficiency over two variables.
#[derive(Clone, Debug)]
pub struct Map {
    plan: Plan,
    /// By point: the second variable runs fastest. `None` where it was stopped before.
    pub cells: Vec<Option<Result<f64, Absence>>>,
}

impl Map {
    /// The map of a scene over two axes.
    pub fn compute(
        scene: &Scene,
        axes: &[Axis; 2],
        hardware: Hardware,
        context: &mut Context<'_, Self>,
    ) -> Result<Self, StudyError> {
        variables::require_single(scene)?;
        if axes.iter().any(|axis| axis.symbol() == "h") {
            let text = "the map does not depend on h: each point sizes h to just stop its shot; take another variable, or \
                        `cmra sweep --over h --outputs limit_if_spring_survives_m_s`";
            return Err(StudyError::Points(text.to_owned()));
        }
        let mut own = scene.clone();
        own.sweep = None;
        own.run.tolerance = larger(own.run.tolerance, TOLERANCE);
        let plan = Plan::new(&own, axes.to_vec(), &[OUTPUT])?;
        let count = usize::try_from(plan.points()).unwrap_or(0);
        context.expect(count);
        let mut map = Self { cells: vec![None; count], plan };
        for stride in STRIDES {
            if !context.is_stopped() {
                map.fill(&map.pass(stride), hardware, context);
            }
        }
        Ok(map)
    }

    /// Computes some points, in pieces, and shows them piece by piece.
    fn fill(&mut self, points: &[u64], hardware: Hardware, context: &mut Context<'_, Self>) {
        let (plan, stop) = (self.plan.clone(), context.stop());
        let slice = |piece: &Range<u64>| {
            let at = |end: u64| usize::try_from(end).unwrap_or(points.len());
            &points[at(piece.start)..at(piece.end)]
        };
        let worker = || {
            let mut placed = plan.base().clone();
            let (plan, stop) = (&plan, stop.clone());
            move |piece: Range<u64>| -> Vec<Result<f64, Absence>> {
                let cell = |index: &u64| {
                    plan.place(&mut placed, *index);
                    let mut own = placed.clone();
                    hold_spring_mass(&mut own);
                    mass_efficiency(&own, hardware, WIDTH)
                };
                slice(&piece).iter().take_while(|_| !stop.is_set()).map(cell).collect()
            }
        };
        let work = Work { count: points.len() as u64, at_once: PIECE };
        context.each(work, worker, |context, piece, found| {
            context.count(found.len());
            let is_whole = found.len() == slice(&piece).len();
            for (index, cell) in slice(&piece).iter().zip(found) {
                if let Ok(index) = usize::try_from(*index) {
                    self.cells[index] = Some(cell);
                }
            }
            context.show(self) && is_whole
        });
    }

    /// The points of a stride that are not there yet.
    fn pass(&self, stride: usize) -> Vec<u64> {
        let (across, up) = (self.x().count(), self.y().count());
        let along = |count: u64| (0..count).step_by(stride);
        let points = along(across).flat_map(|x| along(up).map(move |y| x * up + y));
        let is_missing = |index: &u64| {
            let cell = usize::try_from(*index).ok().and_then(|index| self.cells.get(index));
            cell.is_some_and(Option::is_none)
        };
        points.filter(is_missing).collect()
    }

    /// The scene that the axes change.
    pub fn scene(&self) -> &Scene {
        self.plan.base()
    }

    /// The variable across.
    pub fn x(&self) -> &Axis {
        &self.plan.axes()[0]
    }

    /// The variable up.
    pub fn y(&self) -> &Axis {
        &self.plan.axes()[1]
    }

    /// Whether every point was computed.
    pub fn is_complete(&self) -> bool {
        self.cells.iter().all(Option::is_some)
    }

    /// The scene of a point, counted along both axes from their first values.
    pub fn placed(&self, x: u64, y: u64) -> Scene {
        self.plan.scene(x * self.y().count() + y)
    }

    /// A point, counted along both axes from their first values; `None` where it was not reached.
    pub fn cell(&self, x: u64, y: u64) -> Option<Result<f64, Absence>> {
        let index = usize::try_from(x * self.y().count() + y).ok()?;
        self.cells.get(index).copied().flatten()
    }

    /// The point itself, or the nearest coarser one that stands for it so far.
    pub fn shown(&self, x: u64, y: u64) -> Option<Result<f64, Absence>> {
        let coarser = |stride: &usize| {
            let stride = *stride as u64;
            self.cell(x - x % stride, y - y % stride)
        };
        STRIDES.iter().rev().find_map(coarser)
    }

    /// The computed points of the row that is nearest below a point of the second axis and has any: the row, and the place and
    /// the mass efficiency of each point, NaN where it has none.
    pub fn row(&self, y: u64) -> (u64, Vec<(u64, f64)>) {
        let at = |y: u64| (0..self.x().count()).filter_map(move |x| Some((x, self.number(x, y)?)));
        line(y, |y| at(y).collect())
    }

    /// The computed points of a column, as [`Self::row`] has those of a row.
    pub fn column(&self, x: u64) -> (u64, Vec<(u64, f64)>) {
        let at = |x: u64| (0..self.y().count()).filter_map(move |y| Some((y, self.number(x, y)?)));
        line(x, |x| at(x).collect())
    }

    fn number(&self, x: u64, y: u64) -> Option<f64> {
        Some(self.cell(x, y)?.unwrap_or(f64::NAN))
    }
}

/// The line of the finest stride that has two points or more.
fn line(own: u64, at: impl Fn(u64) -> Vec<(u64, f64)>) -> (u64, Vec<(u64, f64)>) {
    let lines = STRIDES.iter().rev().map(|stride| own - own % (*stride as u64));
    let found = lines.map(|line| (line, at(line))).find(|(_, points)| points.len() > 1);
    found.unwrap_or((own, Vec::new()))
}

/// The axes of the usual map of a scene: impact velocity, and gamma or the input that gives the plate's size in its place; `None` where
/// one of them has no such axis. The plate's size begins at a greater value where a small plate is impossible.
pub fn default_axes(scene: &Scene) -> Option<[Axis; 2]> {
    let axis = |name| default_axis(scene, name, DEFAULT_COUNT).ok();
    let (across, up) = (axis("v_i")?, axis(scene.plate.size.key())?);
    let own = up.get(scene)?;
    let from = |least: f64| {
        let ends = (least * own, up.ends().1);
        Axis::new(up.symbol(), ends, DEFAULT_COUNT, up.spacing()).ok()
    };
    let raised = [0.2, 0.5, 1.0].into_iter().filter_map(from);
    let axes = std::iter::once(up.clone()).chain(raised).map(|up| [across.clone(), up]);
    axes.into_iter().find(|axes| Plan::new(scene, axes.to_vec(), &[OUTPUT]).is_ok())
}

/// The axis of a variable that is requested by its name alone: around the scene's own value at equal ratios, or over the range
/// of Table 9.2.
pub fn default_axis(scene: &Scene, name: &str, count: u64) -> Result<Axis, StudyError> {
    let (variable, number) = numeric(name)?;
    let (low, high) = if variable.symbol == "v_i" { AROUND_VELOCITY } else { AROUND };
    match ((number.get)(scene).filter(|own| *own > 0.0), variable.thesis_range) {
        (Some(own), _) => Axis::new(name, (low * own, high * own), count, Spacing::Log),
        (None, ends) => Axis::new(name, ends.unwrap_or_default(), count, Spacing::Linear),
    }
}
