//! The answer of a goal seek: a row a solution, jump, nearest miss or gap, and the whole as an object.

use serde_json::json;

use crate::report::table::{Table, pretty};
use crate::study::search::seek::{Place, Report};
use crate::study::sweep::{PointOutcome, Spacing};

/// One line of the answer.
#[derive(Clone, Copy)]
pub struct Line {
    kind: &'static str,
    /// From where to where.
    at: f64,
    until: Option<f64>,
    value: Option<f64>,
    /// What becomes of the design.
    outcome: Option<PointOutcome>,
}

fn lines(report: &Report) -> Vec<Line> {
    let solutions = report.solutions.iter().map(|found| Line {
        kind: match (found.touches, found.until) {
            (_, Some(_)) => "plateau",
            (true, None) => "touch",
            (false, None) => "solution",
        },
        at: found.place.at,
        until: found.until,
        value: Some(found.place.value),
        outcome: found.outcome,
    });
    let jumps = report.jumps.iter().map(|jump| Line {
        kind: "jump",
        at: jump.before.at,
        until: Some(jump.after.at),
        value: Some(jump.before.value),
        outcome: None,
    });
    let nearest = report.nearest.map(|Place { at, value }| Line {
        kind: "nearest",
        at,
        until: None,
        value: Some(value),
        outcome: None,
    });
    let gaps = report.gaps.iter().map(|gap| Line {
        kind: "gap",
        at: gap.from,
        until: Some(gap.to),
        value: None,
        outcome: Some(gap.outcome),
    });
    solutions.chain(jumps).chain(nearest).chain(gaps).collect()
}

/// The lines of the answer.
pub fn table<'c>(name: &'c str, report: &'c Report) -> Table<'c, Line> {
    Table::of(lines(report))
        .with("scene", "scene", "", move |_| name)
        .with("kind", "kind", "", |line| line.kind)
        .with("variable", "variable", "", |_| report.axis.symbol())
        .with("key", "key", "", |_| report.axis.variable().key)
        .with("at", "at", "", |line| line.at)
        .with("until", "until", "", |line| line.until)
        .with("output", "quantity", "", |_| report.measure.name)
        .with("target", "goal", "", |_| report.target)
        .with("value", "value", "", |line| line.value)
        .with("outcome", "outcome", "", |line| line.outcome.map(PointOutcome::word))
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let own = ["kind", "at", "until", "value", "outcome"];
    let list = |kinds: &[&str]| {
        let mut table = table(name, report);
        table.rows.retain(|line| kinds.contains(&line.kind));
        table.objects(|key| own.contains(&key))
    };
    let place = |place: Place| json!({ "at": place.at, "value": place.value });
    let (low, high) = report.axis.ends();
    pretty(&json!({
        "scene": name,
        "variable": report.axis.symbol(),
        "key": report.axis.variable().key,
        "low": low,
        "high": high,
        "log": report.axis.spacing() == Spacing::Log,
        "scan_points": report.scan.len(),
        "output": report.measure.name,
        "target": report.target,
        "solutions": list(&["solution", "touch", "plateau"]),
        "jumps": list(&["jump"]),
        "gaps": list(&["gap"]),
        "nearest": report.nearest.map(place),
        "least": report.range.map(|range| place(range.0)),
        "most": report.range.map(|range| place(range.1)),
        "runs": report.runs,
        "complete": report.is_complete,
    }))
}
