//! The Explore tab: what is swept, what was found, where the cursor stands, and all of it in words.
//!
//! Axes and outputs are the scene's own `[sweep]`, so that they are undone, saved and exported with it; where the scene has
//! none, usual ones stand in until something is changed. The cursor only looks: until it is moved it stands on the grid point nearest
//! to the scene.

use std::time::Duration;

use crate::model::scene::{Sweep, SweepAxis};
use crate::model::units::{self, engineering};
use crate::model::variables;
use crate::study::quantities::Quantity;
use crate::study::sweep::grid::{Cell, Grid};
use crate::study::sweep::{Axis, USUAL_OUTPUTS};
use crate::tui::pages::prelude::*;

pub use crate::tui::pages::explore::plan::no_value;
pub use crate::tui::pages::explore::setup::{Part, SetupRow};
use crate::tui::widgets::axis::over;
use crate::tui::widgets::text::fitting;
pub use crate::worker::studies::Picture;
use crate::worker::studies::PictureSweep;

/// Curves of a family unless another number is chosen.
const CURVES: u64 = 5;
/// The axes that stand in where a scene has none: those of Figure 9.7, 9.10 and 9.11.
const USUAL_AXES: [(&str, f64, f64, usize); 3] =
    [("gamma", 0.8, 7.0, 101), ("k", 0.0, 7.5e6, 41), ("d", 0.0, 0.5, 41)];

#[derive(Clone, Debug)]
pub struct SweepResult {
    pub picture: Picture,
    /// The scene that was swept.
    pub scene: Arc<Scene>,
    /// The grid, filled as far as it is.
    pub grid: Arc<Grid>,
    /// Time taken; `None` while it grows.
    pub took: Option<Duration>,
}

/// How a sweep is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PicturePlan {
    pub curves: u64,
    pub picture: Picture,
}

impl Default for PicturePlan {
    fn default() -> Self {
        Self { curves: CURVES, picture: Picture::Line }
    }
}

#[derive(Clone, Debug, Default)]
pub struct Sweeping {
    /// The last result, of one picture or the other.
    pub result: Option<SweepResult>,
    /// The curves of a figure by the scheme that the thesis prints.
    pub printed: Option<Arc<Grid>>,
    /// The number of the last sweep that was said to take more than a minute.
    pub warned: Option<u64>,
    /// Why the present axes cannot be swept.
    pub problem: Option<String>,
    pub row: SetupRow,
    /// The point under the cursor; `None`: the one nearest to the scene.
    pub cursor: Option<(usize, usize)>,
    /// The part of the variable along that is in view; `None`: all of it.
    pub zoomed: Option<ViewRange>,
    pub output: usize,
    pub value_scale: Scale,
    /// Curves of a family, and the picture.
    pub plan: PicturePlan,
}

impl Sweeping {
    /// The result, where it is of the picture shown.
    pub fn found(&self) -> Option<&SweepResult> {
        self.result.as_ref().filter(|it| it.picture == self.plan.picture)
    }

    /// The place of the output shown among those of a sweep.
    pub fn output_of(&self, sweep: &Sweep) -> usize {
        self.output.min(sweep.outputs.len() - 1)
    }

    /// Show what was found; over other variables the cursor begins again, over other values of them it stays at its own.
    pub fn show(&mut self, found: SweepResult) {
        let before = self.found().map(|found| &*found.grid);
        if before.is_none_or(|grid| grid.plan().axes() != found.grid.plan().axes()) {
            let at = self.cursor.zip(before);
            self.cursor = at.and_then(|(at, grid)| same_place(grid, at, &found.grid));
            self.zoomed = None;
        }
        self.result = Some(found);
    }
}

/// The point of a grid that is nearest to a point of another one over the same variables.
fn same_place(old: &Grid, at: (usize, usize), new: &Grid) -> Option<(usize, usize)> {
    let (before, after) = (old.plan().axes(), new.plan().axes());
    let is_same = before.iter().map(Axis::symbol).eq(after.iter().map(Axis::symbol));
    let value = |axis: usize| nearest(after.get(axis)?, old.coordinate(at, axis));
    let is_inside = at.0 < old.counts().0 && at.1 < old.counts().1;
    if !is_same || !is_inside {
        return None;
    }
    Some((value(0)?, value(1).unwrap_or(0)))
}

/// The sweep of a scene, with usual axes and outputs where it has none; always two axes.
pub fn sweep_of(scene: &Scene) -> Sweep {
    completed(scene, scene.sweep.clone().unwrap_or_default())
}

/// A sweep with usual axes and outputs where it has none.
pub(super) fn completed(scene: &Scene, mut sweep: Sweep) -> Sweep {
    for (name, from, to, count) in USUAL_AXES {
        let usual = SweepAxis::linear(name, from, to, count);
        // Where another input than gamma gives the plate its size, that one.
        let found = variables::find(name).ok().filter(|it| variables::overrules_size(it, scene));
        let own = found.and_then(|_| variables::find(scene.plate.size.key()).ok());
        let usual = own.and_then(|own| over(scene, own, count).ok()).unwrap_or(usual);
        let taken = sweep.axes.iter().any(|axis| excludes(axis, &usual.name));
        if sweep.axes.len() < 2 && !taken {
            sweep.axes.push(usual);
        }
    }
    if sweep.outputs.is_empty() {
        sweep.outputs = USUAL_OUTPUTS.map(str::to_owned).to_vec();
    }
    sweep
}

/// Whether an axis cannot stand beside one of a variable.
fn excludes(axis: &SweepAxis, name: &str) -> bool {
    let found = variables::find(&axis.name).ok().zip(variables::find(name).ok());
    found.is_some_and(|(one, other)| variables::exclude_each_other(one, other))
}

/// Whether curves are repeated for the values of a second axis.
pub fn has_family(scene: &Scene) -> bool {
    scene.sweep.as_ref().is_some_and(|sweep| sweep.axes.len() >= 2)
}

impl App {
    /// The display of Explore: curves or a map.
    pub fn picture(&self) -> Picture {
        self.pages.explore.plan.picture
    }

    /// Whether the picture belongs to other axes or held variables than those on the screen.
    pub fn sweep_is_old(&self) -> bool {
        let wanted = self.sweep_plan().ok();
        let shown = self.pages.explore.found().map(|found| &**found.grid.plan());
        shown.is_some() && shown != wanted.as_ref()
    }

    pub fn shown_output(&self, grid: &Grid) -> (usize, &'static Quantity) {
        let outputs = grid.plan().outputs();
        let at = self.pages.explore.output.min(outputs.len().saturating_sub(1));
        (at, outputs[at])
    }

    /// The grid point under the cursor: the one it was moved to, or the one nearest to the scene.
    pub fn cursor_point(&self, grid: &Grid) -> (usize, usize) {
        let (across, up) = grid.counts();
        if let Some(at) = self.pages.explore.cursor.filter(|(x, y)| *x < across && *y < up) {
            return at;
        }
        let along = |axis: Option<&Axis>| {
            let axis = axis?;
            nearest(axis, here(axis, &self.scene)?)
        };
        let axes = grid.plan().axes();
        (along(axes.first()).unwrap_or(0), along(axes.get(1)).unwrap_or(0))
    }

    /// What is under the cursor, in at most this many columns: units and long names go first.
    pub fn sweep_readout(&self, width: usize) -> Option<String> {
        let grid = &self.pages.explore.found()?.grid;
        let all = [Detail::Long, Detail::Short, Detail::Least];
        Some(fitting(all.map(|words| self.readout_with(grid, words)), width))
    }

    fn readout_with(&self, grid: &Grid, words: Detail) -> String {
        let (x, y) = self.cursor_point(grid);
        let values = || values_at(grid, (x, y));
        let at = |(axis, value): (&Axis, f64)| {
            let shown = match words {
                Detail::Long => axis.show(value, 5),
                Detail::Short => significant(value, 5),
                Detail::Least => significant(value, 4),
            };
            format!("{} {shown}", axis.symbol())
        };
        let mut parts: Vec<String> = values().map(at).collect();
        let away = values().any(|(axis, value)| {
            here(axis, &self.scene).is_none_or(|now| now.to_bits() != value.to_bits())
        });
        let place = if away { "near " } else { "" }.to_owned() + &parts.join(" ");
        parts.clear();
        let (shown, _) = self.shown_output(grid);
        for (index, output) in grid.plan().outputs().iter().enumerate() {
            if words == Detail::Least && index != shown {
                continue;
            }
            let name = words.of(output);
            let text = match grid.cell(x, y, index) {
                Cell::Value(value) if output.unit() == "%" => {
                    format!("{} of rigid mount", output_value(output, value))
                }
                Cell::Value(value) => format!("{name} {}", output_value(output, value)),
                Cell::Outcome(outcome) if outcome.is_stopped() => {
                    format!("{name}: {}", outcome.without_value(output))
                }
                // The whole point is so, whatever the output.
                Cell::Outcome(outcome) => outcome.without_value(output).to_owned(),
                Cell::Waiting => "not computed yet".to_owned(),
            };
            if !parts.contains(&text) {
                parts.push(text);
            }
        }
        format!("{place}: {}", parts.join(", "))
    }

    /// The design under the cursor as a scene, with the values of the axes in words.
    pub fn sweep_design(&self) -> Result<LabelledScene, String> {
        let Some(found) = self.pages.explore.found() else {
            return Err(no_sweep(self));
        };
        if self.sweep_is_old() {
            return Err(old("setup"));
        }
        let point = self.cursor_point(&found.grid);
        Ok(placed((*self.scene).clone(), values_at(&found.grid, point)))
    }
}

/// The words where there is no sweep to act on yet.
pub(crate) fn no_sweep(app: &App) -> String {
    nothing::<PictureSweep>(app, BEING_COMPUTED, None)
}

/// How much room a readout has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Detail {
    Long,
    Short,
    /// Only the output that is shown.
    Least,
}

impl Detail {
    fn of(self, output: &Quantity) -> String {
        match output.name {
            _ if self == Self::Long => output.title(),
            "max_plate_displacement_m" => "plate".to_owned(),
            "final_penetration_m" | "first_arrest_penetration_m" => "depth".to_owned(),
            _ => output.title(),
        }
    }
}

/// The value that a scene has of an axis, also where another variable gives the plate its size.
fn here(axis: &Axis, scene: &Scene) -> Option<f64> {
    axis.get(scene).or_else(|| match axis.variable().key {
        "plate.mass_kg" => Some(scene.plate_mass_kg()),
        "plate.face_m" => Some(scene.plate_face_m()),
        _ => None,
    })
}

/// The axes of a grid with their values at a point.
fn values_at(grid: &Grid, point: (usize, usize)) -> impl Iterator<Item = (&Axis, f64)> {
    let axes = grid.plan().axes().iter().enumerate();
    axes.map(move |(place, axis)| (axis, grid.coordinate(point, place)))
}

/// The place of the value of an axis nearest to a number.
pub fn nearest(axis: &Axis, value: f64) -> Option<usize> {
    usize::try_from(axis.nearest(value)).ok()
}

pub fn copy_value(axis: &Axis, from: &Scene, to: &mut Scene) {
    if variables::sizes_plate(axis.variable()) {
        (to.plate.size, to.plate.mass_ratio) = (from.plate.size, from.plate.mass_ratio);
    } else {
        axis.set(to, axis.get(from).unwrap_or(f64::NAN));
    }
}

/// A scene with some variables at these values; its label has them.
pub fn placed<'a>(
    mut scene: Scene,
    values: impl IntoIterator<Item = (&'a Axis, f64)>,
) -> LabelledScene {
    let mut words = Vec::new();
    for (axis, value) in values {
        axis.set(&mut scene, value);
        words.push(format!("{} = {}", axis.symbol(), axis.show(value, 5)));
    }
    LabelledScene { scene, label: words.join(", ") }
}

/// An output with its unit: `64.27 %`, `37.98 mm`.
pub fn output_value(output: &Quantity, value: f64) -> String {
    match output.unit() {
        "" => significant(value, 5),
        "%" => format!("{} %", units::fixed_significant(value, 4)),
        unit => engineering(value, unit, 4),
    }
}
