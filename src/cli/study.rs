//! Common parts of the commands that study a scene: arguments, execution, and ranges of variables.

use clap::Args;
use serde_json::Value;

use crate::cli::CliError;
use crate::cli::progress::{self, Extent};
use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::files::preset::Preset;
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::page::{Block, Page};
use cmra_studies::report::table::{Table, texts};
use cmra_studies::study::context::Context;
use cmra_studies::study::monte_carlo::DEFAULT_SEED;
use cmra_studies::study::parallel::cores;
use cmra_studies::study::sweep::{Axis, COUNTS};

/// Common arguments of the studies of a scene.
#[derive(Debug, Args)]
pub(super) struct StudyArguments {
    #[command(flatten)]
    pub(super) scene: SceneArguments,
    #[command(flatten)]
    pub(super) threads: Threads,
    #[command(flatten)]
    pub(super) table: TableArguments,
}

impl StudyArguments {
    /// Loads the scene, after a check that the table can be written.
    pub(super) fn load(&self) -> Result<Preset, CliError> {
        self.table.check(true)?;
        self.scene.load()
    }

    /// Loads the scene of a study that varies variables; [`Self::say_unused`] follows.
    pub(super) fn read(&self) -> Result<Preset, CliError> {
        self.table.check(true)?;
        self.scene.read()
    }

    /// Says which changes have no effect on a scene, whatever values the axes have.
    pub(super) fn say_unused(&self, scene: &Scene, axes: &[Axis]) {
        self.scene.changes.say_unused(scene, axes.iter().map(Axis::variable));
    }

    /// Runs a study and shows its progress.
    pub(super) fn run<P: ?Sized, T>(
        &self,
        items: &'static str,
        study: impl FnOnce(&mut Context<'_, P>) -> T,
    ) -> (T, Extent) {
        progress::study(self.threads.count(), items, study)
    }

    /// Prints the page or the JSON object and writes the table, with the warnings in each row. `command` is the name and the options of the
    /// command, for the scene file beside the table.
    pub(super) fn deliver<R>(
        &self,
        extent: Extent,
        (scene, command): (&Scene, String),
        warnings: &[Warning],
        (mut page, mut object): (Page, Value),
        rows: Table<'_, R>,
    ) -> Result<(), CliError> {
        object["warnings"] = texts(warnings);
        page.push(Block::Warnings(warnings.to_vec()));
        let rows = rows.with_warnings(warnings);
        let source = (&self.scene.changes, scene, command);
        self.table.deliver(extent, Some(source), &page, Some(object), rows)
    }
}

/// Argument `--threads`.
#[derive(Debug, Args)]
pub(super) struct Threads {
    /// Threads; the digits do not depend on it [default: one for each core]
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    /// Returns the number of threads; by default one for each core.
    pub(super) fn count(&self) -> usize {
        self.threads.map_or_else(cores, usize::from)
    }
}

/// Argument `--seed`.
#[derive(Debug, Args)]
pub(super) struct Random {
    /// Random seed: the same seed gives the same digits
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true, default_value_t = DEFAULT_SEED)]
    pub(super) seed: u64,
}

/// Parses variables with their ranges.
pub(super) fn axes(texts: &[String]) -> Result<Vec<Axis>, CliError> {
    let read = |text: &String| Ok(Axis::read_range(text, Some(*COUNTS.start()), &COUNTS)?);
    texts.iter().map(read).collect()
}
