//! The spread of results as a page of text: the inputs, the outcomes, and quantiles result by result.

use std::fmt::Write as _;

use crate::cli::text::width;
use crate::report::monte_carlo::{perforation, table};
use crate::study::monte_carlo::Report;

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
    let _ = writeln!(page, "\n{}", report.outcomes);
    if let Some(perforation) = perforation(report) {
        let _ = writeln!(page, "{perforation}");
    }
    let mut table = table(name, report);
    table.rows.retain(|summary| !summary.quantiles.is_empty());
    page.push('\n');
    let some_lack = table.rows.iter().any(|summary| summary.sorted.len() < report.samples);
    let keys = ["output", "nominal", "mean", "q05", "q50", "q95", "deviation", "count"];
    page += &table.page(&keys[..if some_lack { 8 } else { 7 }], width());
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
