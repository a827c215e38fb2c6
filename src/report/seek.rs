//! The answer of a goal seek: a row a solution, jump, nearest miss or gap, and the whole as an object.

use serde_json::json;

use crate::report::Remark;
use crate::report::table::{Table, pretty};
use crate::study::search::seek::{Place, Report, Solution};
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

/// A solution in words.
pub fn solution(report: &Report, solution: &Solution) -> String {
    let axis = &report.axis;
    let at = axis.show(solution.place.at, 6);
    let until = solution.until.map(|until| format!(" to {}, all of it", axis.show(until, 6)));
    let touch = if solution.touches { ", a least or greatest value" } else { "" };
    let outcome = solution.outcome.map_or("", PointOutcome::word);
    let reached = report.measure.show(solution.place.value, 6);
    format!("{} = {at}{}: {reached}, {outcome}{touch}", axis.symbol(), until.unwrap_or_default())
}

/// What else is to be said: that there is no solution, jumps over the goal, and where there is no value.
pub fn remarks(report: &Report) -> Vec<Remark> {
    let (axis, measure) = (&report.axis, report.measure);
    let at = |value: f64| axis.show(value, 6);
    let shown = |value: f64| measure.show(value, 6);
    let place =
        |place: Place| format!("{} at {} = {}", shown(place.value), axis.symbol(), at(place.at));
    let mut remarks = Vec::new();
    for jump in &report.jumps {
        let (from, to) = (place(jump.before), shown(jump.after.value));
        let text = format!("no solution, a jump over the goal: {from}, then {to}");
        remarks.push(Remark::caution("", text));
    }
    if report.solutions.is_empty() {
        remarks.push(Remark::caution("", format!("nothing reaches {}", shown(report.target))));
        let nearest = report.nearest.map(|it| format!("nearest: {}", place(it)));
        let range = report
            .range
            .map(|(least, most)| format!("least: {}; most: {}", place(least), place(most)));
        remarks.extend(nearest.into_iter().chain(range).map(|text| Remark::new("", text)));
    }
    for gap in &report.gaps {
        let range = match gap.points {
            1 => format!("at {}", at(gap.from)),
            points => format!("from {} to {} ({points} points)", at(gap.from), at(gap.to)),
        };
        let why = gap.outcome.without_value(measure);
        remarks.push(Remark::new("", format!("no value {range}: {why}")));
    }
    remarks
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
