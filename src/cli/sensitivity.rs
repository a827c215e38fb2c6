//! `cmra sensitivity [SCENE]`: which variables matter to one result, as a page, CSV or JSON.

mod page;

use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::outlook::say_if_long;
use crate::cli::progress::ProgressLine;
use crate::cli::scene::SceneArguments;
use crate::cli::search::{Random, Threads, bounds};
use crate::cli::table::TableArguments;
use crate::report::sensitivity;
use crate::study::sensitivity::{Effort, study};
use crate::study::sweep::Plan;
use crate::study::validity;

/// Rows of the design and trajectories at most.
const SAMPLES_MAX: usize = 1 << 20;
const TRAJECTORIES_MAX: usize = 100_000;

#[derive(Debug, Args)]
pub(super) struct SensitivityArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// A variable and its bounds; may be repeated [default: the ranges of Table 9.2]
    #[arg(long, value_name = "NAME=LO..HI[:log]", allow_hyphen_values = true)]
    over: Vec<String>,
    /// The result: a key of `cmra run --json`
    #[arg(long, alias = "outputs", value_name = "NAME", default_value = "percent_of_baseline")]
    output: String,
    /// Base samples for Sobol's indices, a power of two; each takes two runs and one more per variable
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 1024)]
    samples: usize,
    /// Trajectories for Morris's elementary effects; each takes one run and one more per variable
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 100)]
    trajectories: usize,
    #[command(flatten)]
    random: Random,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

impl SensitivityArguments {
    fn effort(&self) -> Result<Effort, CliError> {
        let (rows, trajectories) = (self.samples, self.trajectories);
        if !(16..=SAMPLES_MAX).contains(&rows) || !rows.is_power_of_two() {
            let near = rows.clamp(16, SAMPLES_MAX).next_power_of_two();
            return Err(CliError::Option(format!(
                "--samples {rows} is not a power of two in 16..{SAMPLES_MAX}: write {near}"
            )));
        }
        if !(2..=TRAJECTORIES_MAX).contains(&trajectories) {
            return Err(CliError::Option(format!(
                "--trajectories {trajectories} is outside 2..{TRAJECTORIES_MAX}"
            )));
        }
        Ok(Effort { rows, trajectories, seed: self.random.seed })
    }
}

pub(super) fn run(arguments: &SensitivityArguments) -> Result<ExitCode, CliError> {
    arguments.table.check_beside()?;
    let effort = arguments.effort()?;
    let preset = arguments.scene.load()?;
    let axes = bounds(&arguments.over, &preset.scene)?;
    let mut line = ProgressLine::begin();
    let threads = arguments.threads.count();
    if let Ok(space) = Plan::for_designs(&preset.scene, axes.clone(), &[&arguments.output]) {
        say_if_long(&space, effort.runs(axes.len()) as u64, "runs", threads);
    }
    let report = line.study(threads, "runs", |context| {
        study(&preset.scene, axes, &arguments.output, effort, context)
    })?;
    let name = preset.name.as_str();
    let page = || page::text(name, &report);
    let object = || sensitivity::json(name, &report);
    let warnings = validity::of_axes(&preset.scene, &report.axes);
    arguments.table.of(&arguments.scene, &preset.scene).deliver_warned(
        &warnings,
        page,
        object,
        sensitivity::table(name, &report),
    )?;
    Ok(line.exit_code(true))
}
