//! The result on the screen, the pinned ones, and what the worker has been asked.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;

use std::sync::Arc;
use std::time::Duration;

use crate::model::run::Run;
use crate::model::scene::Scene;
use crate::model::units::{self, Engineering};
use crate::model::variables::VARIABLES;
use crate::report::run::{Compared, comparison};
use crate::report::table::Table;
use crate::tui::app::App;
use crate::tui::pages::run::editor::shown_value;

/// The letters pins get, in order.
pub const LETTERS: [char; 8] = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H'];

/// The result on the screen.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The run.
    pub run: Arc<Run>,
    /// Wall-clock time of the computation; `None` for a part kept from a cancelled job.
    pub took: Option<Duration>,
}

/// A frozen scene with its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    /// A to H.
    pub letter: char,
    /// A few words: the preset, or what differs from it.
    pub name: String,
    /// Its scene.
    pub scene: Arc<Scene>,
    /// Its result, once there is one.
    pub run: Option<Arc<Run>>,
    /// Whether it is drawn.
    pub visible: bool,
    /// The job that computes it.
    pub job: Option<u64>,
}

/// A run to draw.
#[derive(Clone, Copy, Debug)]
pub struct RunView<'a> {
    /// The pin's letter; `None` for the current run.
    pub letter: Option<char>,
    /// Row in the table of runs; 0 is the current run.
    pub index: usize,
    /// Its name.
    pub name: &'a str,
    /// The run.
    pub run: &'a Run,
    /// It belongs to an older scene than the one on the screen.
    pub old: bool,
}

impl App {
    /// The current run and the pinned ones beside each other.
    pub(in crate::tui) fn compared_runs(&self) -> Table<'_, Compared<'_>> {
        let now = self.shown.as_ref().map(|shown| &*shown.run);
        let now = Compared { name: self.name_of(&self.scene), run: now };
        let pins = self.pins.iter();
        let pins = pins.map(|pin| Compared { name: pin.name.clone(), run: pin.run.as_deref() });
        comparison(std::iter::once(now).chain(pins))
    }

    /// The runs in the order of their table: 0 the current one, then the pins.
    pub fn run_order(&self) -> Vec<usize> {
        self.runs_sorted.order(&self.compared_runs())
    }

    /// A name for a scene: the preset's where nothing differs, else what differs (`gamma=1 d=0.5`).
    pub fn name_of(&self, scene: &Scene) -> String {
        let differing = Self::differing(scene, &self.base.scene);
        if differing.is_empty() {
            return self.base.name.clone();
        }
        let shown = |index: usize| {
            let variable = &VARIABLES[index];
            format!("{}={}", variable.symbol, shown_value(variable, scene, 24))
        };
        differing.into_iter().map(shown).collect::<Vec<_>>().join(" ")
    }
}

/// A length in mm with four figures, `-` where it does not exist.
pub fn millimetres(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |metres| units::fixed_significant(metres * 1e3, 4))
}

/// A value with prefix and unit, four figures: `19.26 kN`.
pub fn engineering(value: f64, unit: &'static str) -> String {
    Engineering { value, unit, digits: 4 }.to_string()
}
