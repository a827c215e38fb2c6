//! `cmra reproduce`: statements of the thesis with the computed results.

use std::process::ExitCode;

use clap::Args;

use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress};
use cmra_studies::report::thesis as tables;
use cmra_studies::study::thesis;

#[derive(Debug, Args)]
#[command(after_help = "Exit status 1 if a computation no longer bears out its verdict.")]
pub(super) struct ReproduceArguments {
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

/// Checks every claim.
pub(super) fn run(arguments: &ReproduceArguments) -> Result<ExitCode, CliError> {
    arguments.table.check(false)?;
    let (rows, extent) = progress::study(arguments.threads.count(), "rows", thesis::reproduce);
    let page = tables::page(&rows, extent.missing());
    arguments.table.deliver(extent, None, &page, None, tables::claims(&rows))?;
    let failing = rows.iter().filter(|row| !row.holds).map(|row| {
        let (id, verdict) = (row.claim.id, row.claim.verdict.words());
        format!("{id}: the computation does not bear out \"{verdict}\"")
    });
    Ok(extent.exit_code_after(failing))
}
