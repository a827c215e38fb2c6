//! The answer of a goal seek for machines: a row a solution, jump, nearest miss or gap, or one JSON object.

use serde_json::{Value, json};

use crate::files::rows::{Rows, number};
use crate::study::search::seek::{Place, Report};
use crate::study::sweep::{Fate, Spacing};

const COLUMNS: [&str; 10] =
    ["scene", "kind", "variable", "key", "at", "until", "output", "target", "value", "outcome"];

/// One line of the answer: its kind, from where to where, the value, what becomes of the design.
type Line = (&'static str, f64, Option<f64>, Option<f64>, Option<Fate>);

fn lines(report: &Report) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for found in &report.solutions {
        let kind = match (found.touches, found.until) {
            (_, Some(_)) => "plateau",
            (true, None) => "touch",
            (false, None) => "solution",
        };
        lines.push((kind, found.place.at, found.until, Some(found.place.value), found.fate));
    }
    for jump in &report.jumps {
        lines.push(("jump", jump.before.at, Some(jump.after.at), Some(jump.before.value), None));
    }
    if let Some(Place { at, value }) = report.nearest {
        lines.push(("nearest", at, None, Some(value), None));
    }
    for gap in &report.gaps {
        lines.push(("gap", gap.from, Some(gap.to), None, Some(gap.fate)));
    }
    lines
}

fn word(fate: Option<Fate>) -> Value {
    fate.map_or(Value::Null, |fate| Value::from(fate.word()))
}

/// One row a line of the answer.
pub fn rows(name: &str, report: &Report) -> Rows {
    let row = |(kind, at, until, value, fate): Line| {
        vec![
            Value::from(name),
            Value::from(kind),
            Value::from(report.axis.symbol()),
            Value::from(report.axis.variable().key),
            number(Some(at)),
            number(until),
            Value::from(report.measure.name),
            number(Some(report.target)),
            number(value),
            word(fate),
        ]
    };
    Rows { columns: COLUMNS.to_vec(), rows: lines(report).into_iter().map(row).collect() }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let (low, high) = report.axis.ends();
    let list = |kinds: &[&str]| {
        let of = lines(report).into_iter().filter(|line| kinds.contains(&line.0));
        let object = |(kind, at, until, value, fate): Line| {
            json!({
                "kind": kind, "at": number(Some(at)), "until": number(until),
                "value": number(value), "outcome": word(fate),
            })
        };
        of.map(object).collect::<Vec<_>>()
    };
    let place = |place: Option<Place>| {
        place.map(
            |place| json!({ "at": number(Some(place.at)), "value": number(Some(place.value)) }),
        )
    };
    let object = json!({
        "scene": name,
        "variable": report.axis.symbol(),
        "key": report.axis.variable().key,
        "low": number(Some(low)),
        "high": number(Some(high)),
        "log": report.axis.spacing() == Spacing::Log,
        "scan_points": report.scan.len(),
        "output": report.measure.name,
        "target": number(Some(report.target)),
        "solutions": list(&["solution", "touch", "plateau"]),
        "jumps": list(&["jump"]),
        "gaps": list(&["gap"]),
        "nearest": place(report.nearest),
        "least": place(report.range.map(|range| range.0)),
        "most": place(report.range.map(|range| range.1)),
        "runs": report.runs,
        "complete": report.is_complete,
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}
