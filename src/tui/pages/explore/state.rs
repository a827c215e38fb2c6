//! State of the Explore tab: axes, results, cursor.
//!
//! Axes and outputs are stored in the scene's `[sweep]`, so they are undone, saved and exported with it. A scene without `[sweep]` has
//! default axes until the first change. The cursor does not change the scene; before it is moved, it is at the grid point nearest to the
//! scene.

use std::sync::Arc;

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::preset::LabelledScene;
use crate::tui::widgets::axis::over;
use crate::worker::studies::{PictureSweep, RequestVariant};
use cmra_engine::model::scene::{Scene, Sweep, SweepAxis};
use cmra_engine::model::variables;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::sweep::{Axis, default_outputs};

pub use crate::tui::widgets::axis::Part;
pub use crate::worker::studies::ChartKind;

/// Pane of the curves or the map.
pub const RESULTS: Pane = Pane::new(Tab::Explore, 0);
pub const SETUP: Pane = Pane::new(Tab::Explore, 1);

/// Number of curves of a family.
pub(crate) const CURVES: u64 = 5;
/// Default axes of a scene without a sweep: those of Figures 9.7, 9.10 and 9.11.
const DEFAULT_AXES: [(&str, f64, f64, usize); 3] =
    [("gamma", 0.8, 7.0, 101), ("k", 0.0, 7.5e6, 41), ("d", 0.0, 0.5, 41)];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetupRow {
    Heading(&'static str),
    Axis(usize, Part),
    Picture,
    Output,
}

impl Default for SetupRow {
    fn default() -> Self {
        Self::Axis(0, Part::Name)
    }
}

#[derive(Clone, Debug, Default)]
pub struct Sweeping {
    /// Latest result, as curves or as a map.
    pub result: CachedResult<Grid>,
    /// Curves of a figure by the printed scheme of the thesis.
    pub printed: Option<Arc<Grid>>,
    /// Reason why the present axes cannot be swept.
    pub problem: Option<String>,
    pub row: SetupRow,
    /// Point under the cursor; `None` for the point nearest to the scene.
    pub cursor: Option<(usize, usize)>,
    pub output: usize,
    pub picture: ChartKind,
}

impl Sweeping {
    /// Returns the grid of the displayed picture, possibly partial.
    pub fn found(&self) -> Option<&Arc<Grid>> {
        let sweep = PictureSweep::downcast(self.result.request.as_ref()?)?;
        self.result.result.as_ref().filter(|_| sweep.picture == self.picture)
    }

    /// Returns the index of the displayed output among those of a sweep.
    pub fn output_of(&self, sweep: &Sweep) -> usize {
        self.output.min(sweep.outputs.len() - 1)
    }
}

/// Returns the sweep of a scene with default axes and outputs where it has none; always two axes.
pub fn sweep_of(scene: &Scene) -> Sweep {
    completed(scene, scene.sweep.clone().unwrap_or_default())
}

/// Completes a sweep with default axes and outputs.
pub(super) fn completed(scene: &Scene, mut sweep: Sweep) -> Sweep {
    for (name, from, to, count) in DEFAULT_AXES {
        let usual = SweepAxis::linear(name, from, to, count);
        // Use the scene's own input for the plate's size if it is not gamma.
        let found = variables::find(name).ok().filter(|it| variables::overrules_size(it, scene));
        let own = found.and_then(|_| variables::find(scene.plate.size.key()).ok());
        let usual = own.and_then(|own| over(scene, own, count).ok()).unwrap_or(usual);
        let taken = sweep.axes.iter().any(|axis| excludes(axis, &usual.name));
        if sweep.axes.len() < 2 && !taken {
            sweep.axes.push(usual);
        }
    }
    if sweep.outputs.is_empty() {
        sweep.outputs = default_outputs(scene).iter().map(|it| (*it).to_owned()).collect();
    }
    sweep
}

/// Returns `true` if an axis cannot be combined with one of a variable.
fn excludes(axis: &SweepAxis, name: &str) -> bool {
    let found = variables::find(&axis.name).ok().zip(variables::find(name).ok());
    found.is_some_and(|(one, other)| variables::exclude_each_other(one, other))
}

/// Returns `true` if curves are repeated for the values of a second axis.
pub fn has_family(scene: &Scene) -> bool {
    scene.sweep.as_ref().is_some_and(|sweep| sweep.axes.len() >= 2)
}

/// Returns the index of the axis value nearest to a number.
pub fn nearest(axis: &Axis, value: f64) -> Option<usize> {
    usize::try_from(axis.nearest(value)).ok()
}

pub fn copy_value(axis: &Axis, from: &Scene, to: &mut Scene) {
    if variables::sizes_plate(axis.variable()) {
        to.plate.size = from.plate.size;
    } else {
        axis.set(to, axis.get(from).unwrap_or(f64::NAN));
    }
}

/// Returns a scene with these values of some variables, which are also its label.
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
