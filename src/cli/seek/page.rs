//! The answer of a goal seek as a page of text.

use std::fmt::Write as _;

use crate::model::units::significant;
use crate::study::search::seek::{Place, Report};
use crate::study::sweep::{Axis, PointOutcome, Spacing};

/// The page.
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
        value(axis, low),
        value(axis, high),
        report.runs
    );
    for solution in &report.solutions {
        let at = value(axis, solution.place.at);
        let until = solution
            .until
            .map_or_else(String::new, |until| format!(" to {}, all of it", value(axis, until)));
        let touch = if solution.touches { ", a least or greatest value" } else { "" };
        let outcome = solution.outcome.map_or("", PointOutcome::word);
        let reached = report.measure.show(solution.place.value, 6);
        let _ = writeln!(page, "  {} = {at}{until}   {reached}, {outcome}{touch}", axis.symbol());
    }
    for jump in &report.jumps {
        let _ = writeln!(
            page,
            "  no solution, a jump over the goal: at {} = {} from {} to {}",
            axis.symbol(),
            value(axis, jump.before.at),
            report.measure.show(jump.before.value, 6),
            report.measure.show(jump.after.value, 6)
        );
    }
    if report.solutions.is_empty() {
        nothing(&mut page, report);
    }
    for gap in &report.gaps {
        let range = if gap.points == 1 {
            format!("at {}", value(axis, gap.from))
        } else {
            format!(
                "from {} to {} ({} points)",
                value(axis, gap.from),
                value(axis, gap.to),
                gap.points
            )
        };
        let why = gap.outcome.without_value(report.measure);
        let _ = writeln!(page, "  no value {range}: {why}");
    }
    if let Some(solution) = report.solutions.first() {
        let set = format!("{}={}", axis.symbol(), crate::model::units::shortest(solution.place.at));
        let _ = writeln!(page, "\n`--set {set}` runs it");
    }
    page
}

fn nothing(page: &mut String, report: &Report) {
    let axis = &report.axis;
    let _ = writeln!(page, "  nothing reaches {}", report.measure.show(report.target, 6));
    let told = |place: Place| {
        let at = value(axis, place.at);
        format!("{} at {} = {at}", report.measure.show(place.value, 6), axis.symbol())
    };
    if let Some(nearest) = report.nearest {
        let _ = writeln!(page, "  nearest: {}", told(nearest));
    }
    if let Some((least, most)) = report.range {
        let _ = writeln!(page, "  least:   {}\n  most:    {}", told(least), told(most));
    }
}

/// A value of the variable with its unit.
fn value(axis: &Axis, value: f64) -> String {
    let unit = axis.variable().unit().trim_matches('-');
    format!("{} {unit}", significant(value, 6)).trim_end().to_owned()
}
