//! `cmra reproduce`: statements of the thesis with the computed results.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::progress::Extent;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress, text};
use cmra_studies::report::thesis as tables;
use cmra_studies::study::thesis::{self, ClaimVerdict, Row};

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
    arguments.table.deliver(extent, None, &page(&rows, extent), None, tables::claims(&rows))?;
    let failing = rows.iter().filter(|row| !row.holds).map(|row| {
        let (id, verdict) = (row.claim.id, row.claim.verdict.words());
        format!("{id}: the computation does not bear out \"{verdict}\"")
    });
    Ok(extent.exit_code_after(failing))
}

fn page(rows: &[Row], extent: Extent) -> String {
    let mut page = String::new();
    for row in rows {
        let claim = row.claim;
        let place = format!("{}  [{}]", claim.place, claim.verdict.words());
        let gap =
            text::width().saturating_sub(place.chars().count() + claim.id.chars().count()).max(2);
        let _ = writeln!(page, "{place}{:gap$}{}", "", claim.id);
        let lines = [
            ("says", claim.says),
            ("computed", &row.computed),
            ("as printed", &row.as_printed),
            ("cause", claim.cause),
        ];
        text::labelled_each(&mut page, &lines);
        page.push('\n');
    }
    let counts = ClaimVerdict::ALL.iter().zip(thesis::tally(rows));
    let counts: Vec<String> =
        counts.map(|(verdict, count)| format!("{count} {}", verdict.words())).collect();
    let whole = || format!("{} rows: {}.", rows.len(), counts.join(", "));
    let _ = writeln!(page, "{}", extent.missing().unwrap_or_else(whole));
    page
}
