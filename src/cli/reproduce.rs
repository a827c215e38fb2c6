//! `cmra reproduce`: every checkable claim of the thesis against what is computed.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::progress::was_interrupted;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, output, progress, text};
use crate::report::thesis as tables;
use crate::study::thesis::{self, Claim, ClaimVerdict, Evidence, Row};

#[derive(Debug, Args)]
#[command(
    after_help = "Exit status 1 if a verdict differs from the table stored with this program."
)]
pub(super) struct ReproduceArguments {
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
    /// Show only the rows whose name, place, sentence or verdict contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

/// Check every claim; exit status 1 when a verdict differs from the stored one.
pub(super) fn run(arguments: &ReproduceArguments) -> Result<ExitCode, CliError> {
    arguments.table.check()?;
    let check = |claims: &[&'static Claim]| {
        progress::study(arguments.threads.count(), "rows", |context| {
            thesis::check_all(claims, context)
        })
    };
    let all: Vec<&Claim> = thesis::claims().iter().collect();
    let shown = match &arguments.only {
        None => check(&all),
        Some(text) => only(text, &all, check)?,
    };
    let is_whole = arguments.only.is_none() && !was_interrupted();
    let differences = if is_whole { thesis::differences(&shown) } else { thesis::changed(&shown) };
    let page = page(&shown, differences.len());
    arguments.table.alone().deliver(&page, tables::claims(&shown))?;
    for difference in &differences {
        output::note(&format!("verdict differs from the stored table: {difference}"));
    }
    Ok(progress::exit_code(differences.is_empty()))
}

/// The rows with this text in them; all are computed only where it may be a verdict's. No row at all is refused.
fn only(
    text: &str,
    all: &[&'static Claim],
    check: impl Fn(&[&'static Claim]) -> Vec<Row>,
) -> Result<Vec<Row>, CliError> {
    let wanted = text.to_lowercase();
    let has = |field: &str| field.to_lowercase().contains(&wanted);
    let said = |claim: &Claim| [claim.id, claim.place, claim.says].into_iter().any(has);
    if ClaimVerdict::ALL.into_iter().any(|verdict| has(verdict.words())) {
        let mut rows = check(all);
        rows.retain(|row| said(row.claim) || has(row.found.verdict.words()));
        return Ok(rows);
    }
    let chosen: Vec<_> = all.iter().copied().filter(|claim| said(claim)).collect();
    if chosen.is_empty() {
        return Err(CliError::Option(format!(
            "--only {text}: none of the {} rows has this in its name, place, sentence or verdict; write a section (9.3), a \
             name (A.2-coupling), a word (stiffness) or a verdict (misprint)",
            all.len()
        )));
    }
    Ok(check(&chosen))
}

fn page(report: &[Row], differences: usize) -> String {
    let mut page = String::new();
    for row in report {
        let claim = row.claim;
        let place = format!("{}  [{}]", claim.place, row.found.verdict.words());
        let gap =
            text::width().saturating_sub(place.chars().count() + claim.id.chars().count()).max(2);
        let _ = writeln!(page, "{place}{:gap$}{}", "", claim.id);
        let lines = [
            ("says", claim.says),
            (
                if row.found.basis == Evidence::Read { "read" } else { "computed" },
                row.found.sound.as_str(),
            ),
            ("as printed", row.found.printed.as_str()),
            ("cause", claim.cause),
        ];
        text::labelled_each(&mut page, &lines);
        page.push('\n');
    }
    page.push_str(&summary(report, differences));
    page
}

/// A summary: rows by source, by verdict, and compared with the stored verdicts.
fn summary(report: &[Row], differences: usize) -> String {
    let on = |basis| report.iter().filter(|row| row.found.basis == basis).count();
    let runs: usize = report.iter().map(|row| row.runs).sum();
    let counts = thesis::tally(report);
    let verdicts: Vec<String> = ClaimVerdict::ALL
        .iter()
        .zip(counts)
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| format!("{count} {}", verdict.words()))
        .collect();
    let stored = match (progress::not_complete(), differences) {
        (Some(missing), _) => missing,
        (None, 0) => "Every verdict is the one stored with this program.".to_owned(),
        (None, _) => format!(
            "{differences} verdicts differ from those stored with this program (listed on standard error)."
        ),
    };
    let [computed, read, none] = [Evidence::Computed, Evidence::Read, Evidence::None].map(on);
    let (rows, verdicts) = (report.len(), verdicts.join(", "));
    format!(
        "{rows} rows: {computed} computed ({runs} runs), {read} read from the text, {none} not checked.\nVerdicts: {verdicts}.\n{stored}\n"
    )
}
