//! Runs on the screen: the current one, and those pinned beside it.

use std::sync::Arc;
use std::time::Duration;

use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;

/// The letters pins get, in order.
pub const LETTERS: [char; 8] = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H'];

#[derive(Clone, Debug)]
pub struct DisplayedRun {
    pub run: Arc<Run>,
    /// Wall-clock time of the computation; `None` for a part kept from a cancelled job.
    pub elapsed: Option<Duration>,
}

/// A frozen scene with its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    pub letter: char,
    /// A few words: the preset, or what differs from it.
    pub name: String,
    pub scene: Arc<Scene>,
    pub run: Option<Arc<Run>>,
    pub job: Option<u64>,
}

impl Pin {
    /// A scene that is pinned now, and has yet to be computed.
    pub(crate) fn new(letter: char, name: String, scene: Arc<Scene>) -> Self {
        Self { letter, name, scene, run: None, job: None }
    }

    /// `A: thesis-baseline`.
    pub(crate) fn label(&self) -> String {
        format!("{}: {}", self.letter, self.name)
    }
}

#[derive(Clone, Copy, Debug)]
pub struct RunView<'a> {
    /// The pin's letter; `None` for the current run.
    pub letter: Option<char>,
    /// Row in the table of runs; 0 is the current run.
    pub index: usize,
    pub name: &'a str,
    pub run: &'a Run,
    /// Whether it belongs to an earlier scene than the one on the screen.
    pub old: bool,
}
