//! Report of a Monte Carlo study: a table with one row for each quantity, and an object. SI, percent for percentages.

use serde_json::{Map, Value, json};

use crate::report::page::Page;
use crate::report::table::Table;
use crate::report::verdict;
use crate::study::context::Reach;
use crate::study::limit::RANGE_M_S;
use crate::study::monte_carlo::{
    Distribution, Estimate, LIMIT, ModelError, MonteCarloReport, PerforatedShare, Summary,
};
use crate::study::validity;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::significant;

const DIGITS: usize = 4;

/// Returns the warnings about the rows.
pub fn warnings(scene: &Scene, report: &MonteCarloReport) -> Vec<Warning> {
    let mut warnings = validity::of_scene(scene);
    let measures: Vec<_> = report.summaries.iter().map(|it| it.measure).collect();
    warnings.extend(validity::of_pair(scene, &[], &measures));
    warnings.extend(without_limit(report));
    warnings
}

/// Notes the samples that have no limit and are missing in the quantiles; `None` if there are none.
fn without_limit(report: &MonteCarloReport) -> Option<Warning> {
    let limits = report.summaries.iter().find(|it| it.measure.name == LIMIT)?;
    let (all, missing) = (report.samples, report.samples - limits.sorted.len());
    let (low, high) = RANGE_M_S;
    (missing > 0).then(|| {
        let value = format!(
            "{missing} of {all} samples have no limit from {low} to {high} m/s that runs decide"
        );
        Warning::remark(value, ": its quantiles are of the others")
    })
}

/// Describes the model error by which limit velocities are corrected; `None` if there is none.
pub fn model_error(report: &MonteCarloReport) -> Option<String> {
    let ModelError { bias, spread } = report.model;
    let (bias, spread) = (100.0 * bias, 100.0 * spread);
    let is_used = report.summaries.iter().any(|it| it.has_model_error);
    is_used.then(|| {
        format!(
            "model error in limit velocities: bias {bias:+.3} %, standard deviation {spread:.3} %"
        )
    })
}

/// Returns the title of a quantity and the brief title; states whether it includes the model error if it can.
pub fn titles(report: &MonteCarloReport, summary: &Summary) -> [String; 2] {
    let is_bare = summary.measure.name == LIMIT && !summary.has_model_error;
    let bare = if is_bare && report.model != ModelError::default() {
        ", model error excluded"
    } else {
        ""
    };
    [summary.measure.title(), summary.measure.brief_title()].map(|title| title + bare)
}

/// Formats V50 with its spread in one line; `None` without a limit.
pub fn v50(report: &MonteCarloReport) -> Option<String> {
    let mut each = report.summaries.iter().filter(|it| it.measure.name == LIMIT);
    let shown = |it: &Summary| {
        let show = |value: f64| it.measure.show_all_digits(value, DIGITS);
        let median = it.quantile(0.5)?;
        let [low, high] = [median.low_95, median.high_95].map(show);
        let [value, spread] = [median.value, it.deviation?].map(show);
        Some(format!("{value} (95 %: {low} to {high}), spread {spread}"))
    };
    let first = shown(each.next()?)?;
    Some(match each.next().and_then(shown) {
        Some(bare) => format!("{first}; model error excluded: {bare}"),
        None => first,
    })
}

/// Quantiles: key, label, probability.
pub const QUANTILES: [(&str, &str, f64); 7] = [
    ("q01", "1 %", 0.01),
    ("q05", "5 %", 0.05),
    ("q25", "25 %", 0.25),
    ("q50", "median", 0.5),
    ("q75", "75 %", 0.75),
    ("q95", "95 %", 0.95),
    ("q99", "99 %", 0.99),
];

/// Returns the table of the quantities.
pub fn table<'c>(name: &'c str, report: &'c MonteCarloReport) -> Table<'c, &'c Summary> {
    // Each row uses the unit of its quantity.
    let in_unit =
        |it: &&Summary, value: &Value| Some(it.measure.show_all_digits(value.as_f64()?, DIGITS));
    let table = Table::new(&report.summaries)
        .field("scene", move |_| name)
        .with("output", "", "", |it| it.measure.name)
        .shown(|it, _| {
            let [title, _] = titles(report, it);
            Some(title)
        })
        .with("nominal", "nominal", "", |it| it.nominal)
        .shown(in_unit)
        .with("count", "values", "", |it| it.sorted.len())
        .with("mean", "mean", "", |it| it.mean.map(|mean| mean.value))
        .shown(in_unit)
        .with("mean_low_95", "mean from", "", |it| it.mean.map(|mean| mean.low_95))
        .shown(in_unit)
        .with("mean_high_95", "mean to", "", |it| it.mean.map(|mean| mean.high_95))
        .shown(in_unit)
        .with("deviation", "std dev", "", |it| it.deviation)
        .shown(in_unit);
    let quantile = |table: Table<'c, &'c Summary>, (key, label, fraction)| {
        table.with(key, label, "", move |it| Some(it.quantile(fraction)?.value)).shown(in_unit)
    };
    QUANTILES
        .into_iter()
        .fold(table, quantile)
        .with("model_error", "", "", |it| it.has_model_error.then_some("included"))
        .with("seed", "seed", "", |_| report.seed)
}

/// Describes how many samples without physical sense were drawn again; `None` for none.
pub fn drawn_again(count: usize) -> Option<String> {
    (count > 0).then(|| format!("{count} impossible samples drawn again"))
}

/// Describes the probability of perforation, at length and briefly; `None` if unknown.
pub fn perforation(report: &MonteCarloReport) -> Option<[String; 2]> {
    let PerforatedShare { least, most, low_95, high_95 } = report.perforated?;
    let [least, most, low, high] =
        [least, most, low_95, high_95].map(|part| significant(100.0 * part, 3));
    let (part, open) = if least == most {
        (least, "")
    } else {
        (format!("{least} to {most}"), ", some undecided")
    };
    Some([
        format!("perforated: {part} % of the shots{open} (95 % confidence: {low} to {high} %)"),
        format!("perforated: {part} % (95 %: {low} to {high} %)"),
    ])
}

/// Returns the report: inputs, outcomes, and the table of the quantities; `answer` is the verdict on the scene's own shot.
pub fn page(title: &str, report: &MonteCarloReport, (answer, reach): (&str, Reach)) -> Page {
    let early = if reach.is_complete() { "" } else { ", stopped early" };
    let (samples, seed) = (report.samples, report.seed);
    let mut page = Page::new(format!("{title}: {samples} samples, seed {seed}{early}"));
    page.line(answer);
    page.space();
    for (tolerance, redrawn) in report.tolerances.iter().zip(&report.redrawn) {
        let again = drawn_again(*redrawn).map(|text| format!("   truncated: {text}"));
        page.line(format!("  {tolerance}{}", again.unwrap_or_default()));
    }
    if let Some(again) = drawn_again(report.redrawn_together) {
        page.line(format!("  truncated: {again}, whose values are not allowed together"));
    }
    page.space();
    page.line(report.outcomes.to_string());
    let through = perforation(report).map(|[text, _]| text);
    for text in through.into_iter().chain(model_error(report)) {
        page.line(text);
    }
    let mut table = table(title, report);
    table.rows.retain(|summary| summary.deviation.is_some());
    page.space();
    let some_lack = table.rows.iter().any(|summary| summary.sorted.len() < report.samples);
    let keys = ["output", "nominal", "mean", "q05", "q50", "q95", "deviation", "count"];
    page.table(table.cells(&keys[..if some_lack { 8 } else { 7 }]));
    let absent = report.summaries.iter().filter(|summary| summary.deviation.is_none());
    let absent: Vec<String> = absent.map(|summary| summary.measure.title()).collect();
    if !absent.is_empty() {
        page.line(format!("  without values: {}", absent.join(", ")));
    }
    page
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, report: &MonteCarloReport, verdict: &Verdict, reach: Reach) -> Value {
    let inputs = report.tolerances.iter().zip(&report.redrawn).map(|(tolerance, redrawn)| {
        let Distribution(kind, (first, second)) = tolerance.distribution;
        json!({
            "variable": tolerance.symbol(), "key": tolerance.variable.key,
            "distribution": kind.word(),
            "parameters": [first, second], "redrawn": redrawn,
        })
    });
    let outcomes = report.outcomes.each();
    let outcomes = outcomes.map(|(word, count)| (word.to_owned(), Value::from(count)));
    let table = table(name, report);
    let outputs = table.rows.iter().map(|summary| {
        let is_quantile = |key: &str| QUANTILES.iter().any(|it| it.0 == key);
        let is_own = |key: &str| key != "scene" && key != "seed" && !is_quantile(key);
        let mut object = table.object(summary, is_own);
        let quantiles = QUANTILES.iter().filter_map(|(_, _, fraction)| {
            let Estimate { value, low_95, high_95 } = summary.quantile(*fraction)?;
            Some(json!({ "share": fraction, "value": value, "low_95": low_95, "high_95": high_95 }))
        });
        object.insert("quantiles".to_owned(), quantiles.collect());
        object
    });
    let perforation = report.perforated.map(|share| {
        let PerforatedShare { least, most, low_95, high_95 } = share;
        let probability = Some(least).filter(|_| most - least == 0.0);
        json!({ "probability": probability, "low_95": low_95, "high_95": high_95 })
    });
    let mut object = json!({
        "scene": name,
        "inputs": inputs.collect::<Vec<_>>(),
        "redrawn_together": report.redrawn_together,
        "seed": report.seed,
        "samples": report.samples,
        "model_error": { "bias": report.model.bias, "spread": report.model.spread },
        "complete": reach.is_complete(),
        "outcomes": outcomes.collect::<Map<_, _>>(),
        "perforation": perforation,
        "outputs": outputs.collect::<Vec<_>>(),
    });
    for (key, value) in verdict::object(verdict) {
        object[key] = value;
    }
    object
}
