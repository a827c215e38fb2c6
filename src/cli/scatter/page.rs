//! Scatter as a page of text: the inputs, the outcomes, and quantiles result by result.

use std::fmt::Write as _;

use crate::model::units::significant;
use crate::study::search::scatter::{Report, Summary};
use crate::study::sweep::summary::CENSUS_WORDS;

/// Columns of a result's name, and of a number.
const NAME: usize = 32;
const CELL: usize = 11;

/// The page.
pub(super) fn text(name: &str, report: &Report) -> String {
    let early = if report.is_complete { "" } else { ", stopped early" };
    let mut page = format!("{name}: {} samples, seed {}{early}\n\n", report.samples, report.seed);
    for (tolerance, redrawn) in report.tolerances.iter().zip(&report.redrawn) {
        let unit = tolerance.variable().unit().trim_matches('-');
        let again = match redrawn {
            0 => String::new(),
            count => format!("   truncated: {count} impossible draws made again"),
        };
        let words = format!("{} {unit}", tolerance.distribution.words());
        let _ = writeln!(page, "  {:8}{}{again}", tolerance.symbol(), words.trim_end());
    }
    outcomes(&mut page, report);
    let heads = ["nominal", "mean", "5 %", "median", "95 %", "deviation"];
    let head =
        heads.iter().fold(format!("  {:NAME$}", ""), |line, cell| line + &format!("{cell:>CELL$}"));
    let _ = writeln!(page, "\n{head}");
    for summary in report.summaries.iter().filter(|summary| !summary.quantiles.is_empty()) {
        line(&mut page, report, summary);
    }
    let absent: Vec<String> = report
        .summaries
        .iter()
        .filter(|summary| summary.quantiles.is_empty())
        .map(|summary| summary.measure.title())
        .collect();
    if !absent.is_empty() {
        let _ = writeln!(page, "  without values: {}", absent.join(", "));
    }
    page
}

fn outcomes(page: &mut String, report: &Report) {
    let parts: Vec<String> = report
        .census
        .iter()
        .zip(CENSUS_WORDS)
        .filter(|(count, _)| **count > 0)
        .map(|(count, word)| format!("{count} {word}"))
        .collect();
    let _ = writeln!(page, "\n{}", parts.join(", "));
    if let Some((part, (low, high))) = report.perforated {
        let percent = |share: f64| significant(100.0 * share, 3);
        let _ = writeln!(
            page,
            "probability of perforation {} %, with 95 % confidence {} to {} %",
            percent(part),
            percent(low),
            percent(high)
        );
    }
}

fn line(page: &mut String, report: &Report, summary: &Summary) {
    let column = summary.measure;
    let show =
        |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| column.show(value, 4));
    let at = |share: f64| show(summary.quantile(share).map(|quantile| quantile.value));
    let mean = show(summary.mean.map(|mean| mean.0));
    let cells = [show(summary.nominal), mean, at(0.05), at(0.5), at(0.95), show(summary.deviation)];
    let cells = cells.iter().fold(String::new(), |line, cell| line + &format!("{cell:>CELL$}"));
    let count = summary.sorted.len();
    let of = if count == report.samples { String::new() } else { format!("   of {count}") };
    let _ = writeln!(page, "  {:NAME$}{cells}{of}", column.title());
}
