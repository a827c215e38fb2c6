//! `cmra reproduce`: every checkable claim of the thesis against what is computed.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Args;

use crate::cli::table::TableArguments;
use crate::cli::{CliError, output};
use crate::files::thesis as rows;
use crate::study::thesis::{self, Basis, Claim, Row, Verdict};

/// Width to write for.
const WIDTH: usize = 100;
/// Column where a claim's own lines begin.
const INDENT: usize = 4;

#[derive(Debug, Args)]
#[command(
    after_help = "Exit status 1 if a verdict differs from the table stored with this program."
)]
pub(super) struct ReproduceArguments {
    #[command(flatten)]
    table: TableArguments,
    /// Only the rows whose name, place, sentence or verdict contains this
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

/// Check every claim; exit status 1 when a verdict differs from the stored one.
pub(super) fn run(arguments: &ReproduceArguments) -> Result<ExitCode, CliError> {
    arguments.table.check()?;
    let (shown, differences) = match &arguments.only {
        None => {
            let report = report(&thesis::claims().collect::<Vec<_>>());
            let differences = rows::differences(&report);
            (report, differences)
        }
        Some(text) => {
            let shown = only(text)?;
            let differences = rows::changed(&shown);
            (shown, differences)
        }
    };
    arguments.table.deliver(&page(&shown, differences.len()), &rows::rows(&shown))?;
    for difference in &differences {
        output::note(&format!("verdict differs from the stored table: {difference}"));
    }
    Ok(if differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The rows with this text in them; all are computed only where it may be a verdict's. No row at all is refused.
fn only(text: &str) -> Result<Vec<Row>, CliError> {
    let wanted = text.to_lowercase();
    let has = |field: &str| field.to_lowercase().contains(&wanted);
    let said = |claim: &Claim| [claim.id, claim.place, claim.says].into_iter().any(has);
    if Verdict::ALL.into_iter().any(|verdict| has(verdict.words())) {
        let mut rows = report(&thesis::claims().collect::<Vec<_>>());
        rows.retain(|row| said(row.claim) || has(row.found.verdict.words()));
        return Ok(rows);
    }
    let chosen: Vec<_> = thesis::claims().filter(|claim| said(claim)).collect();
    if chosen.is_empty() {
        return Err(CliError::Option(format!(
            "--only {text}: none of the {} rows has this in its name, place, sentence or verdict; write a section (9.3), a \
             name (A.2-coupling), a word (stiffness) or a verdict (misprint)",
            thesis::claims().count()
        )));
    }
    Ok(report(&chosen))
}

/// These claims, computed on all cores, in thesis order.
fn report(claims: &[&'static Claim]) -> Vec<Row> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let (next, found) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(claim) = claims.get(at) else { return };
                    let row = thesis::check(claim);
                    if let Ok(mut rows) = found.lock() {
                        rows.push((at, row));
                    }
                }
            });
        }
    });
    let mut rows = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    rows.sort_by_key(|(at, _)| *at);
    rows.into_iter().map(|(_, row)| row).collect()
}

fn page(report: &[Row], differences: usize) -> String {
    let mut page = String::new();
    for row in report {
        let claim = row.claim;
        let place = format!("{}  [{}]", claim.place, row.found.verdict.words());
        let gap = WIDTH.saturating_sub(place.chars().count() + claim.id.chars().count()).max(2);
        let _ = writeln!(page, "{place}{:gap$}{}", "", claim.id);
        let lines = [
            ("says", claim.says),
            (
                if row.found.basis == Basis::Read { "read" } else { "computed" },
                row.found.sound.as_str(),
            ),
            ("as printed", row.found.printed.as_str()),
            ("cause", row.found.cause),
        ];
        for (label, text) in lines.iter().filter(|(_, text)| !text.is_empty()) {
            wrapped(&mut page, label, text);
        }
        page.push('\n');
    }
    page.push_str(&summary(report, differences));
    page
}

/// What was done: rows by what they rest on, by verdict, and against the stored verdicts.
fn summary(report: &[Row], differences: usize) -> String {
    let on = |basis| report.iter().filter(|row| row.found.basis == basis).count();
    let runs: usize = report.iter().map(|row| row.runs).sum();
    let counts = thesis::tally(report);
    let verdicts: Vec<String> = Verdict::ALL
        .iter()
        .zip(counts)
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| format!("{count} {}", verdict.words()))
        .collect();
    let stored = if differences == 0 {
        "Every verdict is the one stored with this program.".to_owned()
    } else {
        format!(
            "{differences} verdicts differ from those stored with this program (listed on standard error)."
        )
    };
    format!(
        "{} rows: {} computed ({runs} runs), {} read from the text, {} not checked.\nVerdicts: {}.\n{stored}\n",
        report.len(),
        on(Basis::Computed),
        on(Basis::Read),
        on(Basis::None),
        verdicts.join(", ")
    )
}

/// A label and a text over as many lines as it needs.
pub(super) fn wrapped(page: &mut String, label: &str, text: &str) {
    let column = INDENT + 12;
    let mut line = format!("{:INDENT$}{label:<12}", "");
    let mut length = column;
    for word in text.split_whitespace() {
        let long = word.chars().count();
        if length > column && length + 1 + long > WIDTH {
            let _ = writeln!(page, "{}", line.trim_end());
            line = " ".repeat(column);
            length = column;
        }
        if length > column {
            line.push(' ');
            length += 1;
        }
        line.push_str(word);
        length += long;
    }
    let _ = writeln!(page, "{}", line.trim_end());
}
