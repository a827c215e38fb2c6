//! Report of a comparison of methods: a table with one row for each point, and an object with references and answers.

use serde_json::{Value, json};

use crate::report::chart::{Axis, Chart, Curve, Legend, Mark, Scale, Unit, ViewRange};
use crate::report::page::Page;
use crate::report::svg::Picture;
use crate::report::table::Table;
use crate::report::table::{listed, texts};
use crate::study::accuracy::method::{Method, Parameter};
use crate::study::accuracy::reference::{Reference, References};
use crate::study::accuracy::{
    AccuracyReport, Cheapest, Compared, MethodReport, OmissionGain, Point,
};
use crate::study::context::Reach;
use crate::study::library;
use cmra_engine::model::run::{Outcome, Warning};
use cmra_engine::model::units::engineering;

/// Point of a method.
pub type Row<'r> = (&'r MethodReport, &'r Point);

/// Returns the warnings of the library entries that the scene uses.
pub fn warnings(report: &AccuracyReport) -> Vec<Warning> {
    library::warnings(&report.scene).collect()
}

/// Returns the table of the points of all methods for a named scene.
pub fn table<'r>(name: &'r str, report: &'r AccuracyReport) -> Table<'r, Row<'r>> {
    let rows = |method: &'r MethodReport| method.points.iter().map(move |point| (method, point));
    let measured = |row: &Row<'r>| row.1.result.as_ref().ok();
    let answer = move |row: &Row<'r>| Some(&measured(row)?.answer);
    let warnings = listed(&warnings(report));
    let table = Table::new(report.methods.iter().flat_map(rows))
        .field("scene", move |_| name)
        .field("method", |row| row.0.method.name())
        .field("letter", |row| row.0.method.letter().to_string())
        .field("time_step_s", |row| match row.1.parameter {
            Parameter::Step(dt_s) => Some(dt_s),
            Parameter::Tolerance(_) => None,
        })
        .field("tolerance", |row| match row.1.parameter {
            Parameter::Tolerance(value) => Some(value),
            Parameter::Step(_) => None,
        })
        .field("error", move |row| Some(measured(row)?.error()));
    let table = Compared::ALL
        .into_iter()
        .fold(table, |table, of| table.field(of.key(), move |row| measured(row)?.errors.get(of)));
    table
        .field("at_floor", move |row| Some(measured(row)?.is_at_floor()))
        .field("penetration_m", move |row| answer(row)?.results.get(Compared::Depth))
        .field("end_time_s", move |row| answer(row)?.results.get(Compared::Time))
        .field("steps", move |row| Some(answer(row)?.steps))
        .field("rejected", move |row| Some(answer(row)?.rejected))
        .field("rhs_evaluations", move |row| Some(answer(row)?.evaluations))
        .field("run_time_s_min", move |row| Some(measured(row)?.min_s))
        .field("refused", |row| Some(row.1.result.err()?.message()))
        .field("reference", |row| Some(row.0.reference?.basis.label()))
        .field("reference_uncertainty", |row| row.0.reference?.uncertainty)
        .field(WARNINGS, move |_| warnings.clone())
}

/// Minimum reported speed-up; smaller ones are within the scatter of run times.
const GAIN_LEAST: f64 = 1.1;

/// Key of the warnings in JSON.
const WARNINGS: &str = "warnings";

/// Errors of the columns in the table of methods.
pub const TARGETS: [f64; 2] = [1e-6, 1e-9];

/// Returns the table of methods, one row each.
pub fn methods(methods: &[MethodReport]) -> Table<'_, &MethodReport> {
    let time = |target: f64| move |it: &&MethodReport| Some(it.cheapest(target)?.min_s);
    let in_seconds = |_: &&MethodReport, value: &Value| Some(seconds(value.as_f64()?));
    let brief = |_: &&MethodReport, value: &Value| Some(format!("{:.0e}", value.as_f64()?));
    Table::new(methods)
        .with("letter", "", "", |it| it.method.letter().to_string())
        .with("method", "method", "", |it| it.method.name())
        .with("run_time_s_to_1e-6", "t(1e-6)", "", time(TARGETS[0]))
        .shown(in_seconds)
        .with("run_time_s_to_1e-9", "t(1e-9)", "", time(TARGETS[1]))
        .shown(in_seconds)
        .with("least_error", "least", "", |it| it.min_error())
        .shown(brief)
        .with("reference_uncertainty", "floor", "", |it| it.reference?.uncertainty)
        .shown(brief)
}

/// Formats a method and its parameter.
pub fn by(found: &Cheapest) -> String {
    format!("by {} at {}", found.method.name(), found.parameter)
}

/// Formats a fraction as a whole percentage.
pub fn percent(fraction: f64) -> String {
    format!("{:.0} %", 100.0 * fraction)
}

/// Names the fastest method with an error of at most 1e-6, and its run time.
pub fn advice(report: &AccuracyReport) -> String {
    let target = TARGETS[0];
    let with = report.run_s.map(|run_s| format!("; {} with series and estimate", seconds(run_s)));
    let with = with.unwrap_or_default();
    let is_measured = |it: &MethodReport| it.method == Method::Auto && !it.points.is_empty();
    let found = match report.usable(target) {
        Some(found) => format!("{} {}{with}", seconds(found.min_s), by(&found)),
        None if report.methods.iter().any(is_measured) => "auto does not reach it here".to_owned(),
        None => "auto is not measured yet".to_owned(),
    };
    format!("{target:.0e}: {found}")
}

/// Describes the error of the printed scheme of the thesis, which does not depend on the step size.
pub fn printed_scheme(report: &AccuracyReport) -> Option<String> {
    Some(format!("printed scheme: {} off at any step", percent(report.printed_off?)))
}

/// Returns the table of speed-ups from omitted terms.
pub fn savings(savings: &[OmissionGain]) -> Table<'_, &OmissionGain> {
    let in_seconds = |_: &&OmissionGain, value: &Value| Some(seconds(value.as_f64()?));
    Table::new(savings)
        .with("part", "omitted", "", |it| it.part)
        .with("with_s", "with it", "", |it| it.with_s)
        .shown(in_seconds)
        .with("without_s", "without", "", |it| it.without_s)
        .shown(in_seconds)
        .with("gain", "gain", "", |it| gain(it))
}

/// Formats the speed-up without a term; `none` if it is within the scatter of run times.
pub fn gain(saving: &OmissionGain) -> String {
    let times = saving.with_s / saving.without_s;
    if times < GAIN_LEAST { "none".to_owned() } else { format!("{times:.1} times") }
}

/// Formats a run time in a few characters.
pub fn seconds(value: f64) -> String {
    engineering(value, "s", 2)
}

/// Errors for which the fastest method is reported.
pub const ANSWERS: [f64; 4] = [1e-4, 1e-6, 1e-9, 1e-12];

/// Returns the JSON object of the report for a named scene.
pub fn json(name: &str, report: &AccuracyReport, reach: Reach) -> Value {
    let References { engine, other } = report.references;
    let references = engine.into_iter().chain(other).map(|reference| {
        json!({
            "basis": reference.basis.label(),
            "ending": reference.outcome.word(),
            "penetration_m": reference.results.get(Compared::Depth),
            "end_time_s": reference.results.get(Compared::Time),
            "uncertainty": reference.uncertainty,
        })
    });
    let answers = ANSWERS.map(|target| {
        let found = report.cheapest(target);
        json!({
            "error": target,
            "method": found.map(|it| it.method.name()),
            "parameter": found.map(|it| it.parameter.value()),
            "run_time_s": found.map(|it| it.min_s),
            "auto_tolerance": report.usable(target).map(|it| it.parameter.value()),
            "auto_run_time_s": report.usable(target).map(|it| it.min_s),
        })
    });
    json!({
        "scene": name,
        "references": references.collect::<Vec<_>>(),
        "complete": reach.is_complete(),
        "answers": reach.is_complete().then_some(answers),
        "printed_scheme_off": report.printed_off,
        "run_time_s": report.run_s,
        "omitted": savings(&report.savings).objects(|_| true),
        "points": table(name, report).objects(|key| key != WARNINGS),
        WARNINGS: texts(&warnings(report)),
    })
}

/// Returns the curve of the error of a method over its run time, s.
fn curve(of: &MethodReport) -> Curve<'static> {
    let points: Vec<(f64, f64)> = of.measured().map(|(_, it)| (it.min_s, it.error())).collect();
    Curve::new(of.method.letter(), of.method.name(), points).colour(of.method as usize)
}

/// Returns the level lines: the errors of the table, the uncertainty of the reference, and the error of the printed scheme.
fn levels(report: &AccuracyReport) -> Vec<Mark<'static>> {
    let floor = report.references.any().and_then(|reference| reference.uncertainty);
    let floor = floor.map(|at| Mark::new(at, "reference's floor"));
    let printed = report.printed_off.map(|at| Mark::new(at, "printed scheme"));
    TARGETS.map(|at| Mark::new(at, "")).into_iter().chain(floor).chain(printed).collect()
}

/// Returns the chart of error over run time; `None` if no result could be compared.
pub fn error_over_time(report: &AccuracyReport) -> Option<Chart<'static>> {
    let curves: Vec<Curve<'static>> = report.methods.iter().map(curve).collect();
    let points = || curves.iter().flat_map(|curve| curve.points.iter());
    let times = ViewRange::from_values(Scale::Log10, points().map(|point| point.0))?;
    let errors = ViewRange::from_values(Scale::Log10, points().map(|point| point.1))?;
    let (times, errors) = (times.in_decades(), errors.in_decades());
    // Choose the unit for the fast end: microseconds.
    let unit = Unit::with_prefix(30.0 * times.lo(), "s");
    let x = Axis::new("run time", times).scale(Scale::Log10).unit(unit);
    let y = Axis::new("relative error", errors).scale(Scale::Log10);
    let title = "relative error, the greatest of all results";
    Some(Chart {
        // The table of methods explains the letters.
        legend: Legend::Hidden,
        levels: levels(report),
        ..Chart::new(title, x, y, curves)
    })
}

/// Size of the chart in text.
const SIZE: (u16, u16) = (80, 20);
/// Columns of the table of methods.
const KEYS: [&str; 6] =
    ["letter", "method", "least_error", "run_time_s_to_1e-6", "run_time_s_to_1e-9", "cheapest"];

/// Returns the report: advice, the chart of error against run time, the methods, answers and references.
pub fn page(heading: &str, report: &AccuracyReport, reach: Reach) -> Page {
    let mut page = Page::new(format!("{heading}: error against run time"));
    page.space();
    if reach.is_complete() {
        page.line(advice(report));
    }
    if let Some(printed) = printed_scheme(report) {
        page.line(format!("{printed}; T is the error of its step"));
    }
    page.space();
    match error_over_time(report) {
        Some(chart) => page.picture(Picture::Chart(chart), SIZE),
        None => page.line("no method gave a result to compare"),
    }
    let pick = report.cheapest(TARGETS[1]).filter(|_| reach.is_complete()).map(|pick| pick.method);
    let mark = |it: &&MethodReport| if pick == Some(it.method) { "<- cheapest" } else { "" };
    let table = methods(&report.methods).with("cheapest", "", "", mark);
    page.space();
    page.table(table.cells(&KEYS));
    if !reach.is_complete() {
        page.space();
        page.line("not complete: no answer is drawn from these points");
        return page;
    }
    answers(&mut page, report);
    references(&mut page, report);
    refusals(&mut page, report);
    page
}

/// Appends the run times for some accuracies, and the gain from omitted terms.
fn answers(page: &mut Page, report: &AccuracyReport) {
    page.heading("run time for a given accuracy");
    for target in ANSWERS {
        let found = report.cheapest(target).map_or_else(
            || "no method reaches it".to_owned(),
            |found| format!("{} {}", seconds(found.min_s), by(&found)),
        );
        page.line(format!("  {target:>5.0e}: {found}"));
    }
    if !report.savings.is_empty() {
        let keys = ["part", "with_s", "without_s", "gain"];
        page.space();
        page.table(savings(&report.savings).cells(&keys));
    }
}

fn references(page: &mut Page, report: &AccuracyReport) {
    page.heading("references (depth, time, relative uncertainty: methods)");
    let mut compared: Vec<(Reference, String)> = Vec::new();
    for method in &report.methods {
        let Some(own) = method.reference else { continue };
        let letter = method.method.letter();
        match compared.iter_mut().find(|(reference, _)| reference.basis == own.basis) {
            Some((_, letters)) => letters.push(letter),
            None => compared.push((own, letter.to_string())),
        }
    }
    for (reference, letters) in compared {
        let [depth_m, time_s] =
            [Compared::Depth, Compared::Time].map(|of| reference.results.get(of));
        let depth = match reference.outcome {
            Outcome::Perforated => "perforated".to_owned(),
            _ => depth_m.map_or_else(|| "-".to_owned(), |depth_m| engineering(depth_m, "m", 6)),
        };
        let end = time_s.map_or_else(|| "-".to_owned(), |time_s| engineering(time_s, "s", 6));
        let sure = reference
            .uncertainty
            .map_or_else(|| "unknown".to_owned(), |uncertainty| format!("{uncertainty:.0e}"));
        let basis = reference.basis.label();
        page.line(format!("  {basis:<23}{depth}, {end}, to {sure}: {letters}"));
    }
}

fn refusals(page: &mut Page, report: &AccuracyReport) {
    let mut heading = Some("without result");
    for method in &report.methods {
        for (words, points) in method.refusals() {
            let which = match points.as_slice() {
                [first, .., last] => format!("{} points, {first} to {last}", points.len()),
                one => one.iter().map(ToString::to_string).collect(),
            };
            if let Some(heading) = heading.take() {
                page.heading(heading);
            }
            page.line(format!("  {} {which}: {words}", method.method.letter()));
        }
    }
}
