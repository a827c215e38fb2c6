//! `cmra stability`: the battery of stiff and extreme scenes, or the map of a fixed-step method.

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;

use crate::cli::progress::ProgressLine;
use crate::cli::scene::SceneArguments;
use crate::cli::search::all_threads;
use crate::cli::table::{TableArguments, choice};
use crate::cli::{CliError, output, text};
use crate::report::stability as tables;
use crate::study::stability;
use crate::study::stability::map::{self, Axis, FixedStep};

mod table;

/// Rows and columns of a coarser map.
const MAP_CELLS_QUICK: (usize, usize) = (10, 31);

#[derive(Debug, Args)]
#[command(
    after_help = "Without --map, runs stiff and extreme scenes of its own with the default solver (`auto`). Exit status 1 if it fails on any of them.\nSCENE and --set are for --map."
)]
pub(super) struct StabilityArguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    rows: TableArguments,
    /// Map where a fixed-step method is stable on SCENE, over its step and this variable
    #[arg(long, value_name = "k|n|b", value_parser = choice(&Axis::ALL, Axis::symbol, Axis::about))]
    map: Option<Axis>,
    /// The method of the map
    #[arg(long, default_value = "thesis", requires = "map", value_parser = choice(&FixedStep::ALL, FixedStep::word, FixedStep::about))]
    method: FixedStep,
    /// Check a fifth of the stiff scenes, or compute a coarser map
    #[arg(long)]
    quick: bool,
}

pub(super) fn run(arguments: &StabilityArguments) -> Result<ExitCode, CliError> {
    arguments.rows.check()?;
    if let Some(axis) = arguments.map {
        return draw_map(arguments, axis);
    }
    if arguments.scene.is_given() {
        return Err(CliError::Option(
            "SCENE and --set belong to --map: the check of stiff scenes has its own scenes; add --map k (or n, b), or omit SCENE and --set"
                .to_owned(),
        ));
    }
    let cases = stability::battery(arguments.quick);
    let mut line = ProgressLine::begin();
    let start = Instant::now();
    let now_s = || start.elapsed().as_secs_f64();
    let rows =
        line.study(all_threads(), "scenes", |context| stability::run(&cases, &now_s, context))?;
    let took_s = now_s();
    let page = || table::battery(&rows, took_s, text::width());
    let object = || tables::json(&rows);
    arguments.rows.alone().deliver_report(page, object, &tables::table(&rows))?;
    let mut good = true;
    for row in &rows {
        if let Some(shortfall) = row.shortfall {
            good = false;
            output::note(&format!(
                "{} fails: {} ({})",
                row.case.name,
                shortfall.words(),
                row.run.end.words()
            ));
        }
    }
    Ok(line.exit_code(good))
}

fn draw_map(arguments: &StabilityArguments, axis: Axis) -> Result<ExitCode, CliError> {
    arguments.rows.check_beside()?;
    let preset = arguments.scene.load()?;
    map::accepts(&preset.scene)?;
    let cells = if arguments.quick { MAP_CELLS_QUICK } else { map::CELLS };
    let mut line = ProgressLine::begin();
    let map = line.study(1, "rows", |context| {
        map::map(&preset.scene, (arguments.method, axis), cells, context)
    });
    let name = preset.name.as_str();
    let (page, object) = (|| table::map(&map, name), || tables::map_json(name, &map));
    let table = arguments.rows.of(&arguments.scene, &preset.scene);
    table.deliver_report(page, object, &tables::map_table(name, &map))?;
    Ok(line.exit_code(true))
}
