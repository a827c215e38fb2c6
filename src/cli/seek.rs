//! `cmra seek [SCENE] --over k=0..7.5e6 --goal percent_of_baseline=60`: values of a variable for which a quantity reaches a goal.

use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::study::StudyArguments;
use cmra_studies::report::seek::{self, page};
use cmra_studies::study::search::seek::{DEFAULT_SCAN, Goal, Request, SCAN, run as solve};
use cmra_studies::study::sweep::Axis;

#[derive(Debug, Args)]
#[command(
    after_help = "The interval is scanned at COUNT points, then every crossing of the goal is located by root finding. \
    Solutions closer together than the points of the scan may be missed: raise COUNT.\n\
    QUANTITY is any quantity: `cmra explain` lists all.\n\
    Exit status 1 when nothing reaches the goal."
)]
pub(super) struct SeekArguments {
    /// The variable and its bounds.
    #[arg(
        long,
        value_name = "NAME=LO..HI[:COUNT][:log]",
        allow_hyphen_values = true,
        help = format!("The variable and its bounds; COUNT points of the scan [default: {DEFAULT_SCAN}]")
    )]
    over: String,
    /// The quantity and the value it should have.
    #[arg(
        long,
        value_name = "QUANTITY=VALUE",
        allow_hyphen_values = true,
        help = "The quantity and the value it should have, SI or with a unit: percent_of_baseline=60, stroke_m=45mm"
    )]
    goal: String,
    #[command(flatten)]
    study: StudyArguments,
}

/// Runs the goal seek; exit status 1 if no value reaches the goal.
pub(super) fn run(arguments: &SeekArguments) -> Result<ExitCode, CliError> {
    let refuse = |why| CliError::Option(format!("--goal {}: {why}", arguments.goal));
    let goal: Goal = arguments.goal.parse().map_err(refuse)?;
    let request =
        Request { over: Axis::read_range(&arguments.over, Some(DEFAULT_SCAN), &SCAN)?, goal };
    let preset = arguments.study.read()?;
    arguments.study.say_unused(&preset.scene, std::slice::from_ref(&request.over));
    let (report, extent) =
        arguments.study.run("runs", |context| solve(&preset.scene, &request, context));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = seek::warnings(&preset.scene, &report);
    let (page, object) =
        (page(&preset.heading, &report, extent.reach), seek::json(name, &report, extent.reach));
    let source = (&preset.scene, request.to_string());
    arguments.study.deliver(
        extent,
        source,
        &warnings,
        (page, object),
        seek::table(name, &report),
    )?;
    Ok(extent.exit_code(report.solutions().next().is_some()))
}
