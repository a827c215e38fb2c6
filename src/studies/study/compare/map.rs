//! Map of the mass efficiency over two variables, computed on successively finer grids.

use crate::study::compare::hardware::Hardware;
use crate::study::compare::hold_spring_mass;
use crate::study::compare::sizing::{Absence, known_absence, mass_efficiency};
use crate::study::context::Context;
use crate::study::sweep::axis::numeric;
use crate::study::sweep::grid::lattice;
use crate::study::sweep::{Axis, Plan, Spacing, StudyError};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;

/// Points per batch of a thread.
const PIECE: u64 = 16;
/// Grid spacing of each pass, in points. A point that is not yet computed shows the nearest point of a coarser pass.
const STRIDES: [usize; 5] = [16, 8, 4, 2, 1];
/// Default number of points along an axis.
pub const DEFAULT_COUNT: u64 = 41;
/// Placeholder output for the plan of a map, which requires one. The map itself does not use it.
const OUTPUT: &str = "final_penetration_m";
/// Range of a default axis, relative to the scene's own value: of the impact velocity, and of any other variable.
const AROUND_VELOCITY: (f64, f64) = (0.1, 2.0);
const AROUND: (f64, f64) = (0.1, 10.0);

/// Mass efficiency over two variables.
#[derive(Clone, Debug)]
pub struct Map {
    plan: Plan,
    /// Result of each point; the second variable varies fastest. `None` if the study was cancelled before the point.
    pub cells: Vec<Option<Result<f64, Absence>>>,
}

impl Map {
    /// Computes the map of a scene over two axes.
    pub fn compute(
        scene: &Scene,
        axes: &[Axis; 2],
        hardware: Hardware,
        context: &mut Context<'_, Self>,
    ) -> Result<Self, StudyError> {
        variables::require_single(scene)?;
        if axes.iter().any(|axis| axis.symbol() == "h") {
            return Err(StudyError::MapOverThickness);
        }
        let mut own = scene.clone();
        own.sweep = None;
        let plan = Plan::new(&own, axes.to_vec(), &[OUTPUT])?;
        let count = usize::try_from(plan.points()).unwrap_or(0);
        context.expect(count);
        let mut map = Self { cells: vec![None; count], plan };
        if let Some(absence) = map.known_absence() {
            map.cells.fill(Some(Err(absence)));
            context.show(&map);
            return Ok(map);
        }
        for stride in STRIDES {
            if !context.is_stopped() {
                map.fill(&map.pass(stride), hardware, context);
            }
        }
        Ok(map)
    }

    /// Returns the reason why no point has a value, if it is known at all corners without a shot.
    fn known_absence(&self) -> Option<Absence> {
        let [x, y] = [self.x(), self.y()].map(|axis| axis.count() - 1);
        let corners = [(0, 0), (0, y), (x, 0), (x, y)];
        let mut absences = corners.into_iter().map(|(x, y)| known_absence(&self.placed(x, y)));
        let first = absences.next()??;
        absences.all(|it| it == Some(first)).then_some(first)
    }

    /// Returns the common reason of a complete map without a value.
    pub fn absence(&self) -> Option<Absence> {
        let mut absences = self.cells.iter().map(|cell| (*cell)?.err());
        let first = absences.next()??;
        absences.all(|it| it == Some(first)).then_some(first)
    }

    /// Computes the given points in batches and reports progress after each batch.
    fn fill(&mut self, points: &[u64], hardware: Hardware, context: &mut Context<'_, Self>) {
        let (plan, stop) = (self.plan.clone(), context.stop());
        let worker = || {
            let mut placed = plan.base().clone();
            let (plan, stop) = (&plan, stop.clone());
            move |points: &[u64]| -> Vec<Result<f64, Absence>> {
                let cell = |index: &u64| {
                    plan.place(&mut placed, *index);
                    let mut own = placed.clone();
                    hold_spring_mass(&mut own);
                    mass_efficiency(&own, hardware)
                };
                points.iter().take_while(|_| !stop.is_set()).map(cell).collect()
            }
        };
        context.each_of((points, PIECE), worker, |context, points, found| {
            for (index, cell) in points.iter().zip(found) {
                if let Ok(index) = usize::try_from(*index) {
                    self.cells[index] = Some(cell);
                }
            }
            context.show(self)
        });
    }

    /// Returns the points of a pass that are not yet computed.
    fn pass(&self, stride: usize) -> Vec<u64> {
        let along = |axis: &Axis| usize::try_from(axis.count()).unwrap_or(0);
        let counts = (along(self.x()), along(self.y()));
        lattice(counts, [stride; 2], |index| self.cells[index].is_none())
    }

    /// Returns the base scene of the map.
    pub fn scene(&self) -> &Scene {
        self.plan.base()
    }

    /// Returns the horizontal axis.
    pub fn x(&self) -> &Axis {
        &self.plan.axes()[0]
    }

    /// Returns the vertical axis.
    pub fn y(&self) -> &Axis {
        &self.plan.axes()[1]
    }

    /// Returns `true` if every point is computed.
    pub fn is_complete(&self) -> bool {
        self.cells.iter().all(Option::is_some)
    }

    /// Returns the scene of a point, given by its index along each axis.
    pub fn placed(&self, x: u64, y: u64) -> Scene {
        self.plan.scene(x * self.y().count() + y)
    }

    /// Returns the result of a point, given by its index along each axis; `None` if it is not computed.
    pub fn cell(&self, x: u64, y: u64) -> Option<Result<f64, Absence>> {
        let index = usize::try_from(x * self.y().count() + y).ok()?;
        self.cells.get(index).copied().flatten()
    }

    /// Returns the result of a point, or of the nearest computed point of a coarser pass.
    pub fn shown(&self, x: u64, y: u64) -> Option<Result<f64, Absence>> {
        let coarser = |stride: &usize| {
            let stride = *stride as u64;
            self.cell(x - x % stride, y - y % stride)
        };
        STRIDES.iter().rev().find_map(coarser)
    }

    /// Returns the row nearest to `y` that has computed points: its index, and the index and mass efficiency of each point; NaN
    /// where the efficiency does not exist.
    pub fn row(&self, y: u64) -> (u64, Vec<(u64, f64)>) {
        let at = |y: u64| (0..self.x().count()).filter_map(move |x| Some((x, self.number(x, y)?)));
        line((y, self.y()), |y| at(y).collect())
    }

    /// Returns the computed points of a column, in the format of [`Self::row`].
    pub fn column(&self, x: u64) -> (u64, Vec<(u64, f64)>) {
        let at = |x: u64| (0..self.y().count()).filter_map(move |y| Some((y, self.number(x, y)?)));
        line((x, self.x()), |x| at(x).collect())
    }

    fn number(&self, x: u64, y: u64) -> Option<f64> {
        Some(self.cell(x, y)?.unwrap_or(f64::NAN))
    }
}

/// Returns the line of the finest pass with two or more points, nearest to a point of its axis.
fn line((own, axis): (u64, &Axis), at: impl Fn(u64) -> Vec<(u64, f64)>) -> (u64, Vec<(u64, f64)>) {
    let nearest = |stride: u64| {
        let below = own - own % stride;
        let is_above = 2 * (own - below) > stride && below + stride < axis.count();
        if is_above { below + stride } else { below }
    };
    let lines = STRIDES.iter().rev().map(|stride| nearest(*stride as u64));
    let found = lines.map(|line| (line, at(line))).find(|(_, points)| points.len() > 1);
    found.unwrap_or((own, Vec::new()))
}

/// Returns the default axes of a scene: impact velocity, and gamma or the input that gives the plate's size in its place; `None` if one of
/// them cannot be an axis. The axis of the plate's size starts at a larger value if a small plate is impossible.
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

/// Returns the axis of a variable that is given by name only: geometrically spaced around the scene's own value, or over the range of Table
/// 9.2.
pub fn default_axis(scene: &Scene, name: &str, count: u64) -> Result<Axis, StudyError> {
    let (variable, number) = numeric(name)?;
    let (low, high) = if variable.symbol == "v_i" { AROUND_VELOCITY } else { AROUND };
    match ((number.get)(scene).filter(|own| *own > 0.0), variable.thesis_range) {
        (Some(own), _) => Axis::new(name, (low * own, high * own), count, Spacing::Log),
        (None, ends) => Axis::new(name, ends.unwrap_or_default(), count, Spacing::Linear),
    }
}
