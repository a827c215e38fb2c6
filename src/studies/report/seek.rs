//! Report of a goal seek: a table with one row for each solution, jump, nearest miss or gap, and an object.

use serde_json::{Value, json};

use crate::report::Remark;
use crate::report::page::Page;
use crate::report::table::Table;
use crate::report::verdict::expected_columns;
use crate::study::context::Reach;
use crate::study::library;
use crate::study::search::seek::{Kind, SamplePoint, SeekReport, SeekResult};
use crate::study::sweep::{PointOutcome, Spacing};
use crate::study::validity::DesignValidity;
use crate::study::verdict::Decision;
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::significant;

/// Returns warnings about the rows: those of the solutions and of library entries.
pub fn warnings(scene: &Scene, report: &SeekReport) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = library::warnings(scene).collect();
    for (solution, checked) in report.solutions().zip(&report.checked) {
        let at = format!("{}={}", report.axis.symbol(), significant(solution.place.at, 4));
        let own = checked.new.iter().chain(&checked.known);
        warnings.extend(own.cloned().map(|warning| warning.at(format!("solution ({at})"))));
    }
    warnings
}

/// Formats the position of a solution, or both ends of an interval of solutions.
pub fn position(report: &SeekReport, solution: &SeekResult) -> String {
    let at = |place: SamplePoint| report.axis.display(place.at, 6);
    let until = solution.until.map_or_else(String::new, |until| format!(" to {}", at(until)));
    at(solution.place) + &until
}

/// Describes a solution; adds the result with a plastic interface if the fused one exceeds its limit load.
pub fn solution(report: &SeekReport, solution: &SeekResult, checked: &DesignValidity) -> String {
    let at = position(report, solution);
    let outcome = solution.outcome.map_or("", PointOutcome::key);
    let reached = report.measure.show(solution.place.value, 6);
    let plastic = checked.plastic.map(|it| format!("; {}", it.message(report.measure)));
    let plastic = plastic.unwrap_or_default();
    // Without measurements of such shots only the outcome by the law is available; the table states it.
    let verdict = match checked.verdict.decision {
        Decision::NotMeasured => String::new(),
        decision => format!("; verdict: {}", decision.word()),
    };
    format!("{} = {at}: {reached}, {outcome}{plastic}{verdict}", report.axis.symbol())
}

/// Returns further remarks: a missing solution, jumps across the goal, and gaps without values.
pub fn remarks(report: &SeekReport, reach: Reach) -> Vec<Remark> {
    let (axis, measure) = (&report.axis, report.measure);
    let at = |value: f64| axis.display(value, 6);
    let shown = |value: f64| measure.show(value, 6);
    let place = |place: SamplePoint| {
        format!("{} at {} = {}", shown(place.value), axis.symbol(), at(place.at))
    };
    let mut remarks = Vec::new();
    for jump in report.of_kind(Kind::Jump) {
        let (from, to) =
            (place(jump.place), jump.until.map_or_else(String::new, |it| shown(it.value)));
        let text = format!("no solution: the result jumps over the goal: {from}, then {to}");
        remarks.push(Remark::caution("", text));
    }
    if report.solutions().next().is_none() {
        let text = if reach.is_complete() {
            format!("nothing reaches {}", shown(report.target))
        } else {
            let (runs, target) = (report.runs, shown(report.target));
            format!("{target} not reached in the first {runs} runs")
        };
        remarks.push(Remark::caution("", text));
        let nearest =
            report.of_kind(Kind::Nearest).map(|it| format!("nearest: {}", place(it.place)));
        let range = report
            .range
            .map(|(least, most)| format!("minimum: {}; maximum: {}", place(least), place(most)));
        remarks.extend(nearest.chain(range).map(|text| Remark::new("", text)));
        if reach.is_complete() && report.range.is_none() {
            let text = "no run has this quantity: choose another goal, for example stroke_m";
            remarks.push(Remark::new("", text));
        }
    }
    for gap in report.of_kind(Kind::Gap) {
        let (Some(until), Some(outcome)) = (gap.until, gap.outcome) else { continue };
        let range = match gap.points {
            1 => format!("at {}", at(gap.place.at)),
            points => format!("from {} to {} ({points} points)", at(gap.place.at), at(until.at)),
        };
        let why = outcome.without_value(measure);
        remarks.push(Remark::new("", format!("no value {range}: {why}")));
    }
    remarks
}

/// Returns the report: the question, the solutions with further remarks, and how to run the first one.
pub fn page(title: &str, report: &SeekReport, reach: Reach) -> Page {
    let axis = &report.axis;
    let (low, high) = axis.ends();
    let spacing = if axis.spacing() == Spacing::Log { ", at equal ratios" } else { "" };
    let (symbol, measure, points) = (axis.symbol(), report.measure.title(), report.scan.len());
    let (target, runs) = (report.measure.show(report.target, 6), report.runs);
    let [low, high] = [low, high].map(|end| axis.show(end, 6));
    let mut page = Page::new(format!("{title}: which {symbol} gives {measure} = {target}?"));
    page.line(format!("{points} points from {low} to {high}{spacing}, {runs} runs in all"));
    page.space();
    let solutions = report.solutions().zip(&report.checked);
    let solutions = solutions.map(|(found, checked)| solution(report, found, checked));
    for text in solutions.chain(remarks(report, reach).into_iter().map(|remark| remark.text)) {
        page.line(format!("  {text}"));
    }
    if let Some(solution) = report.solutions().next() {
        page.space();
        page.line(format!("`--set {}` runs it", axis.assignment(solution.place.at)));
    }
    page
}

/// Returns the table of the report.
pub fn table<'c>(name: &'c str, report: &'c SeekReport) -> Table<'c, &'c SeekResult> {
    let verdict = |line: &SeekResult| {
        let at = report.solutions().position(|it| it == line)?;
        Some(&report.checked.get(at)?.verdict)
    };
    let plastic = |line: &SeekResult| {
        let at = report.solutions().position(|it| it == line)?;
        Some(report.checked.get(at)?.plastic?.message(report.measure))
    };
    let table = Table::new(&report.lines)
        .field("scene", move |_| name)
        .field("kind", |line| line.kind.word())
        .field("variable", |_| report.axis.symbol())
        .field("key", |_| report.axis.variable().key)
        .field("at", |line| line.place.at)
        .field("until", |line| line.until.map(|it| it.at))
        .field("output", |_| report.measure.name)
        .field("target", |_| report.target)
        .field("value", |line| line.place.value)
        .field("outcome", |line| line.outcome.map(PointOutcome::key))
        .field("interface", |_| report.law.word())
        .field("plastic", move |line| plastic(line))
        .field("verdict", move |line| Some(verdict(line)?.decision.word()));
    expected_columns(table, move |line| verdict(line)?.expected.as_ref())
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, report: &SeekReport, reach: Reach) -> Value {
    let fixed = ["scene", "variable", "key", "output", "target", "interface"];
    let list = |kind: Kind| {
        let mut table = table(name, report);
        table.rows.retain(|line| line.kind == kind);
        table.objects(|key| !fixed.contains(&key))
    };
    let place = |place: SamplePoint| json!({ "at": place.at, "value": place.value });
    let (low, high) = report.axis.ends();
    json!({
        "scene": name,
        "variable": report.axis.symbol(),
        "key": report.axis.variable().key,
        "low": low,
        "high": high,
        "log": report.axis.spacing() == Spacing::Log,
        "scan_points": report.scan.len(),
        "interface": report.law.word(),
        "criterion": report.criterion.word(),
        "output": report.measure.name,
        "target": report.target,
        "solutions": list(Kind::Solution),
        "jumps": list(Kind::Jump),
        "gaps": list(Kind::Gap),
        "nearest": report.of_kind(Kind::Nearest).map(|it| place(it.place)).next(),
        "least": report.range.map(|range| place(range.0)),
        "most": report.range.map(|range| place(range.1)),
        "runs": report.runs,
        "complete": reach.is_complete(),
    })
}
