//! `cmra limit [SCENE]`: the ballistic limit and the residual-velocity curve, as a page, CSV or JSON.

use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::CliError;
use crate::cli::charts::ChartArguments;
use crate::cli::study::StudyArguments;
use cmra_studies::report::limit::{self, FittedLaw, page, residual};
use cmra_studies::report::svg::Picture;
use cmra_studies::study::limit::{COMMAND, find};

#[derive(Debug, Args)]
pub(super) struct LimitArguments {
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    study: StudyArguments,
}

/// Finds the limit. Exit status 0 also if there is none, 1 after an interrupt.
pub(super) fn run(arguments: &LimitArguments) -> Result<ExitCode, CliError> {
    let LimitArguments { study, pictures, .. } = arguments;
    pictures.check(&study.table)?;
    let preset = study.load()?;
    let scene = Arc::new(preset.scene);
    let (report, extent) = study.run("shots or so", |context| find(&scene, context));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = limit::warnings(&report);
    if !pictures.is_stdout() {
        let (page, object) = (page(&preset.heading, &report), limit::json(name, &report));
        let (source, rows) = ((&*report.scene, COMMAND.to_owned()), limit::shots(name, &report));
        study.deliver(extent, source, &warnings, (page, object), rows)?;
    }
    let chart = || {
        residual(&report, report.scene.projectile.velocity_m_s, FittedLaw::name).map(Picture::Chart)
    };
    pictures.write(&study.table, extent.reach, || chart().into_iter().collect())?;
    Ok(extent.exit_code(true))
}
