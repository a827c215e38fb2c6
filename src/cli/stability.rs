//! `cmra stability`: stiff and extreme test scenes, one scene over its tolerance, or the stability map of a method with a fixed step size.

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;

use crate::cli::study::StudyArguments;
use crate::cli::table::choice;
use crate::cli::{CliError, text};
use cmra_engine::model::run::Warning;
use cmra_engine::model::variables;
use cmra_studies::report::stability as tables;
use cmra_studies::report::stability::{
    battery_page, failures, map_page, scene_page, scene_table, table,
};
use cmra_studies::study::library;
use cmra_studies::study::stability;
use cmra_studies::study::stability::map::{self, FixedStep, MapVariable, StabilityMapRequest};
use cmra_studies::study::stability::scene;

/// Minimum width of a page with the column `difficulty`.
const WIDE: usize = 118;

#[derive(Debug, Args)]
#[command(
    after_help = "Without SCENE, runs stiff and extreme scenes of its own with the default solver (`auto`). Exit status 1 if it fails on any of them.\nWith SCENE or --set, runs that scene over its tolerance: steps, rejected steps, error, stiffness."
)]
pub(super) struct StabilityArguments {
    /// Map where a fixed-step method is stable on SCENE, over its step and this variable
    #[arg(long, value_name = "k|n|b", value_parser = choice(&MapVariable::ALL, MapVariable::symbol, MapVariable::about))]
    map: Option<MapVariable>,
    /// The method of the map
    #[arg(long, default_value = "thesis", requires = "map", value_parser = choice(&FixedStep::ALL, FixedStep::word, FixedStep::about))]
    method: FixedStep,
    /// Check a fifth of the stiff scenes, or compute a coarser map
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    study: StudyArguments,
}

pub(super) fn run(arguments: &StabilityArguments) -> Result<ExitCode, CliError> {
    if let Some(variable) = arguments.map {
        return draw_map(arguments, variable);
    }
    if arguments.study.scene.is_given() {
        return check_scene(arguments);
    }
    arguments.study.table.check(false)?;
    let cases = stability::battery(arguments.quick);
    let start = Instant::now();
    let now_s = || start.elapsed().as_secs_f64();
    let (rows, extent) =
        arguments.study.run("scenes", |context| stability::run(&cases, &now_s, context));
    let rows = rows?;
    let took_s = now_s();
    let page = battery_page(&rows, took_s, text::width() >= WIDE, extent.missing());
    let object = tables::json(&rows);
    arguments.study.table.deliver(extent, None, &page, Some(object), table(&rows))?;
    Ok(extent.exit_code_after(failures(&rows)))
}

fn check_scene(arguments: &StabilityArguments) -> Result<ExitCode, CliError> {
    let preset = arguments.study.load()?;
    let (found, extent) = arguments.study.run("runs", |context| scene::run(&preset.scene, context));
    let found = found?;
    let warnings: Vec<Warning> = library::warnings(&preset.scene).collect();
    let (page, object) = (scene_page(&found, &preset.heading), tables::scene_json(&found));
    let source = (&preset.scene, "stability".to_owned());
    arguments.study.deliver(extent, source, &warnings, (page, object), scene_table(&found))?;
    Ok(extent.exit_code(true))
}

fn draw_map(arguments: &StabilityArguments, variable: MapVariable) -> Result<ExitCode, CliError> {
    let preset = arguments.study.read()?;
    let changes = &arguments.study.scene.changes;
    changes.say_unused(&preset.scene, variables::find(variable.symbol()).ok());
    map::accepts(&preset.scene)?;
    let size = if arguments.quick { map::QUICK } else { map::SIZE };
    let wanted = StabilityMapRequest { method: arguments.method, variable, size };
    let (map, extent) =
        arguments.study.run("rows", |context| map::map(&preset.scene, wanted, context));
    let map = map?;
    let name = preset.name.as_str();
    let warnings: Vec<Warning> = library::warnings(&preset.scene).collect();
    let (page, object) = (map_page(&map, &preset.heading), tables::map_json(name, &map));
    let (source, rows) = ((&preset.scene, wanted.to_string()), tables::map_table(name, &map));
    arguments.study.deliver(extent, source, &warnings, (page, object), rows)?;
    Ok(extent.exit_code(true))
}
