//! `cmra validate [FILE.csv]`: measurements, built-in or the user's own, with the computed results.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use serde_json::Value;

use crate::cli::charts::ChartArguments;
use crate::cli::progress::Extent;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress};
use crate::files::validation;
use cmra_studies::report::measured as limits;
use cmra_studies::report::page::Page;
use cmra_studies::report::svg::Picture;
use cmra_studies::report::validation as tables;
use cmra_studies::study::context::Context;
use cmra_studies::study::measured;

#[derive(Debug, Args)]
#[command(
    after_help = "FILE.csv has a row for each shot. Columns are variables as `--set` takes them, the unit in the heading: `R [mm]`, `m_p [g]`, \
    `theta [deg]`; `threat` and `material` name entries of the libraries. Measured are any of limit_m_s, deviation_m_s, depth_m, \
    residual_velocity_m_s, and of a plate that moves first_arrest_plate_velocity_m_s, plate_velocity_after_m_s, separation_velocity_m_s, \
    max_plate_displacement_m, max_plate_displacement_time_s and peak_mount_force_n; source and note are free text. A blank cell is not given. The mount is rigid and the closure cylindrical unless the row \
    says otherwise.\n\
    Such a file begins, for example:\n  \
    nose,core,R [mm],m_p [g],h [mm],rho [kg/m3],E [GPa],Y [MPa],UTS [MPa],theta [deg],mount,closure,C_d,limit_m_s,source\n\
    A row is refused, and counts nowhere, if the computed shot lacks a quantity that the row measures, such as the residual velocity of a \
    stopped shot.\n\
    Exit status 1 when a row is refused."
)]
pub(super) struct ValidateArguments {
    /// Your own measurements [default: the built-in ones, by class]
    #[arg(value_name = "FILE.csv")]
    file: Option<PathBuf>,
    /// List all rows of the built-in measurements
    #[arg(long)]
    rows: bool,
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

/// Computes every row; exit status 1 if a row is refused.
pub(super) fn run(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    let ValidateArguments { table, pictures, threads, .. } = arguments;
    table.check(false)?;
    pictures.check(table)?;
    let Some(file) = &arguments.file else { return built_in(arguments) };
    let measurements = validation::read_measurements(file)?;
    let (rows, extent) = progress::study(threads.count(), "rows", |context: &mut Context<'_>| {
        measured::evaluate(&measurements, context)
    });
    deliver(arguments, extent, &limits::page(&rows), limits::json(&rows), &rows)?;
    Ok(extent.exit_code_after(limits::refusals(&rows)))
}

/// Compares the built-in measurements.
fn built_in(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    let (report, extent) =
        progress::study(arguments.threads.count(), "measurements", validation::report);
    let report = report?;
    let rows = measured::left_out();
    let page = tables::page(rows, &report, arguments.rows, extent.missing());
    deliver(arguments, extent, &page, tables::json(rows, &report), rows)?;
    let missing = report.iter().filter(|row| row.computed.is_none());
    let missing = missing.map(|row| format!("nothing could be computed for {}", row.case.id));
    Ok(extent.exit_code_after(missing))
}

fn deliver(
    arguments: &ValidateArguments,
    extent: Extent,
    page: &Page,
    object: Value,
    rows: &[measured::Row],
) -> Result<(), CliError> {
    let ValidateArguments { table, pictures, .. } = arguments;
    let picture = || limits::picture(rows).map(Picture::Chart).into_iter().collect();
    if pictures.is_stdout() {
        return pictures.write(table, extent.reach, picture);
    }
    table.deliver(extent, None, page, Some(object), limits::rows(rows))?;
    pictures.write(table, extent.reach, picture)
}
