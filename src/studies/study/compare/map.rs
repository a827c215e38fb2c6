//! A map of the mass efficiency over two variables.

use std::ops::Range;

use crate::study::compare::hardware::Hardware;
use crate::study::compare::hold_spring_mass;
use crate::study::compare::sizing::{Absence, mass_efficiency};
use crate::study::context::{Context, Work};
use crate::study::sweep::axis::numeric;
use crate::study::sweep::{Axis, Plan, Spacing, SweepError};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;
use cmra_engine::numerics::larger;

/// Points a thread computes at once.
const PIECE: u64 = 16;
/// Points along an axis, if none is given.
pub const DEFAULT_COUNT: u64 = 41;
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
    /// By point: the second variable runs fastest. Fewer than all where it was stopped.
    pub cells: Vec<Result<f64, Absence>>,
}

impl Map {
    /// The map of a scene over two axes.
    pub fn compute(
        scene: &Scene,
        axes: &[Axis; 2],
        hardware: Hardware,
        context: &mut Context<'_>,
    ) -> Result<Self, SweepError> {
        variables::require_single(scene).map_err(|error| SweepError(error.to_string()))?;
        if axes.iter().any(|axis| axis.symbol() == "h") {
            let text = "the map does not depend on h: each point sizes h to just stop its shot; take another variable, or \
                        `cmra sweep --over h --outputs limit_if_spring_survives_m_s`";
            return Err(SweepError(text.to_owned()));
        }
        let mut own = scene.clone();
        own.sweep = None;
        own.run.tolerance = larger(own.run.tolerance, TOLERANCE);
        let plan = Plan::new(&own, axes.to_vec(), &["final_penetration_m"])?;
        let worker = || {
            let mut placed = plan.base().clone();
            let plan = &plan;
            move |piece: Range<u64>| {
                let cell = |index| {
                    plan.place(&mut placed, index);
                    let mut own = placed.clone();
                    hold_spring_mass(&mut own);
                    mass_efficiency(&own, hardware, WIDTH)
                };
                piece.map(cell).collect()
            }
        };
        context.expect(usize::try_from(plan.points()).unwrap_or(0));
        let work = Work { count: plan.points(), at_once: PIECE };
        let cells = context.map(work, worker, |context, _| context.should_continue());
        Ok(Self { plan, cells })
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
        self.cells.len() as u64 == self.plan.points()
    }

    /// The scene of a point, counted along both axes from their first values.
    pub fn placed(&self, x: u64, y: u64) -> Scene {
        self.plan.scene(x * self.y().count() + y)
    }

    /// A point, counted along both axes from their first values; `None` where it was not reached.
    pub fn cell(&self, x: u64, y: u64) -> Option<Result<f64, Absence>> {
        let index = usize::try_from(x * self.y().count() + y).ok()?;
        self.cells.get(index).copied()
    }
}

/// The axes of the usual map of a scene: impact velocity, and gamma or the input that gives the plate's size in its place; `None` where
/// one of them has no such axis.
pub fn default_axes(scene: &Scene) -> Option<[Axis; 2]> {
    let axis = |name| default_axis(scene, name, DEFAULT_COUNT).ok();
    Some([axis("v_i")?, axis(scene.plate.size.key())?])
}

/// The axis of a variable that is requested by its name alone: around the scene's own value at equal ratios, or over the range
/// of Table 9.2.
pub fn default_axis(scene: &Scene, name: &str, count: u64) -> Result<Axis, SweepError> {
    let (variable, number) = numeric(name)?;
    let (low, high) = if variable.symbol == "v_i" { AROUND_VELOCITY } else { AROUND };
    match ((number.get)(scene).filter(|own| *own > 0.0), variable.thesis_range) {
        (Some(own), _) => Axis::new(name, (low * own, high * own), count, Spacing::Log),
        (None, ends) => Axis::new(name, ends.unwrap_or_default(), count, Spacing::Linear),
    }
}
