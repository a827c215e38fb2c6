//! The point under the cursor of the Explore tab, as a design and in words.

use crate::model::units::{self, engineering};
use crate::study::quantities::Quantity;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::{Cell, Grid};
use crate::tui::pages::explore::state::{Picture, nearest, placed};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::text::fitting;
use crate::worker::studies::PictureSweep;

impl App {
    /// The display of Explore: curves or a map.
    pub fn picture(&self) -> Picture {
        self.pages.explore.plan.picture
    }

    /// Whether the picture belongs to other axes or held variables than those on the screen.
    pub fn sweep_is_old(&self) -> bool {
        let wanted = self.sweep_plan().ok();
        let shown = self.pages.explore.found().map(|grid| &**grid.plan());
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
        let grid = self.pages.explore.found()?;
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
        let Some(grid) = self.pages.explore.found() else {
            return Err(no_sweep(self));
        };
        if self.sweep_is_old() {
            return Err(old("setup"));
        }
        let point = self.cursor_point(grid);
        Ok(placed((*self.scene).clone(), values_at(grid, point)))
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

/// An output with its unit: `64.27 %`, `37.98 mm`.
fn output_value(output: &Quantity, value: f64) -> String {
    match output.unit() {
        "" => significant(value, 5),
        "%" => format!("{} %", units::fixed_significant(value, 4)),
        unit => engineering(value, unit, 4),
    }
}
