//! The answer of a goal seek as a page of text.

use std::fmt::Write as _;

use crate::model::units::shortest;
use crate::report::seek::{remarks, solution};
use crate::study::search::seek::Report;
use crate::study::sweep::Spacing;

pub(super) fn text(name: &str, report: &Report) -> String {
    let axis = &report.axis;
    let (low, high) = axis.ends();
    let spacing = if axis.spacing() == Spacing::Log { ", at equal ratios" } else { "" };
    let mut page = format!(
        "{name}: which {} gives {} = {}?\n{} points from {} to {}{spacing}, {} runs in all\n\n",
        axis.symbol(),
        report.measure.title(),
        report.measure.show(report.target, 6),
        report.scan.len(),
        axis.show(low, 6),
        axis.show(high, 6),
        report.runs
    );
    let solutions = report.solutions.iter().map(|found| solution(report, found));
    for line in solutions.chain(remarks(report).into_iter().map(|remark| remark.text)) {
        let _ = writeln!(page, "  {line}");
    }
    if let Some(solution) = report.solutions.first() {
        let set = format!("{}={}", axis.symbol(), shortest(solution.place.at));
        let _ = writeln!(page, "\n`--set {set}` runs it");
    }
    page
}
