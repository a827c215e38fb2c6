//! `cmra accuracy [SCENE]`: error and run time of every method, as a page with a chart, CSV or JSON.

use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress};
use crate::files::preset::Preset;
use crate::worker::clock;
use cmra_studies::report::accuracy::{self, page};
use cmra_studies::report::page::Block;
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::accuracy::{ComparisonOptions, compare};

#[derive(Debug, Args)]
pub(super) struct AccuracyArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Fewer points and shorter timings
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    table: TableArguments,
}

/// Compares the methods on the scene; exit status 1 if `auto` returns no result at a point.
pub(super) fn run(arguments: &AccuracyArguments) -> Result<ExitCode, CliError> {
    arguments.table.check(true)?;
    let Preset { name, heading, scene, .. } = arguments.scene.load()?;
    let effort = if arguments.quick { ComparisonOptions::QUICK } else { ComparisonOptions::FULL };
    let (report, extent) = progress::study(1, "points", |context| {
        compare(&Arc::new(scene.clone()), effort, &mut clock::processor_s, context)
    });
    let report = report?;
    let reach = extent.reach;
    let table = &arguments.table;
    let mut page = page(&heading, &report, reach);
    page.push(Block::Warnings(accuracy::warnings(&report)));
    let (object, rows) = (accuracy::json(&name, &report, reach), accuracy::table(&name, &report));
    let source = (&arguments.scene.changes, &scene, effort.to_string());
    table.deliver(extent, Some(source), &page, Some(object), rows)?;
    let auto = report.methods.iter().filter(|it| it.method == Method::Auto);
    Ok(extent.exit_code_after(auto.flat_map(|method| &method.points).filter_map(|point| {
        let why = point.result.as_ref().err()?.message();
        Some(format!("{name}: auto gave no answer at {}: {why}", point.parameter))
    })))
}
