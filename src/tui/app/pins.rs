//! Displayed runs: the current run and the pinned runs.

use std::sync::Arc;
use std::time::Duration;

use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;

/// Letters of pins, in order.
pub const LETTERS: [char; 8] = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H'];

#[derive(Clone, Debug)]
pub struct DisplayedRun {
    pub run: Arc<Run>,
    /// Wall-clock time of the computation; `None` for a partial result of a cancelled job.
    pub elapsed: Option<Duration>,
}

/// Pinned scene with its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    pub letter: char,
    /// Short name: the preset, or the differences from it.
    pub name: String,
    pub scene: Arc<Scene>,
    pub run: Option<Arc<Run>>,
    pub job: Option<u64>,
}

impl Pin {
    /// Creates a pin whose result is not yet computed.
    pub(crate) fn new(letter: char, name: String, scene: Arc<Scene>) -> Self {
        Self { letter, name, scene, run: None, job: None }
    }

    /// Returns the label: `A: thesis-baseline`.
    pub(crate) fn label(&self) -> String {
        format!("{}: {}", self.letter, self.name)
    }
}

#[derive(Clone, Copy, Debug)]
pub struct RunView<'a> {
    /// Letter of the pin; `None` for the current run.
    pub letter: Option<char>,
    /// Row in the table of runs; 0 is the current run.
    pub index: usize,
    pub name: &'a str,
    pub run: &'a Run,
    /// Whether the run belongs to an older scene than the current one.
    pub old: bool,
}
