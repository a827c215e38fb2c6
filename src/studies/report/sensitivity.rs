//! Which variables matter: one row for each variable, and the whole as an object. SI; ranges in the result's unit.

use serde_json::{Value, json};

use crate::numerics::statistics::sorted_by;
use crate::report::table::Table;
use crate::study::monte_carlo::Estimate;
use crate::study::sensitivity::Report;

/// The variables, the one that matters most first; a row is a variable's place in the report.
pub fn table<'c>(name: &'c str, report: &'c Report) -> Table<'c, usize> {
    let axis = |at: &usize| &report.axes[*at];
    let bar = |at: &usize| report.bars[*at];
    let first = |at: &usize| report.sobol.as_ref()?.inputs[*at].first;
    let total = |at: &usize| report.sobol.as_ref()?.inputs[*at].total;
    let unit = report.output.unit();
    Table::of(report.order())
        .field("scene", move |_| name)
        .with("output", "quantity", "", |_| report.output.name)
        .with("variable", "", "", move |at| axis(at).symbol())
        .with("key", "key", "", move |at| axis(at).variable().key)
        .with("low", "low end", "", move |at| axis(at).ends().0)
        .shown(move |at, value| Some(axis(at).show(value.as_f64()?, 4)))
        .with("high", "high end", "", move |at| axis(at).ends().1)
        .shown(move |at, value| Some(axis(at).show(value.as_f64()?, 4)))
        .with("output_at_low", "at low", unit, move |at| bar(at).low)
        .with("output_at_high", "at high", unit, move |at| bar(at).high)
        .with("swing", "swing", unit, move |at| bar(at).swing())
        .with("sobol_first", "first", "", move |at| Some(first(at)?.value))
        .with("sobol_first_low_95", "from", "", move |at| Some(first(at)?.low_95))
        .with("sobol_first_high_95", "to", "", move |at| Some(first(at)?.high_95))
        .with("sobol_total", "total", "", move |at| Some(total(at)?.value))
        .with("sobol_total_low_95", "from", "", move |at| Some(total(at)?.low_95))
        .with("sobol_total_high_95", "to", "", move |at| Some(total(at)?.high_95))
}

/// The effect of each variable alone, the greatest first, with a column `bar` of a given number of cells at most.
pub fn tornado(report: &Report, bar: usize) -> Table<'_, usize> {
    let swing = |at: &usize| report.bars[*at].swing().unwrap_or(-1.0);
    let mut table = table("", report);
    table.rows = sorted_by(table.rows, |at| -swing(at));
    let widest = table.rows.first().map_or(0.0, swing);
    table.with("bar", "", "", move |at| {
        // Without a swing there is no bar.
        let length = swing(at).max(0.0) / widest.abs() * bar as f64;
        "#".repeat((1..=bar).filter(|cell| length >= *cell as f64 - 0.5).count())
    })
}

/// The indices in brief: half the interval of an index stands behind it.
pub fn indices(report: &Report) -> Table<'_, usize> {
    let index = |at: &usize| report.sobol.as_ref().map(|sobol| sobol.inputs[*at]);
    let brief = |index: Option<Estimate>| {
        let index = index?;
        let half = 0.5 * (index.high_95 - index.low_95);
        Some(format!("{:.3} +-{half:.3}", index.value))
    };
    Table::of(report.order())
        .with("variable", "", "", |at| report.axes[*at].symbol())
        .with("sobol_first", "Sobol first", "", move |at| brief(index(at)?.first))
        .with("sobol_total", "total", "", move |at| brief(index(at)?.total))
}

/// Where points of the design have no value: whose the indices are.
pub fn condition(report: &Report) -> Option<String> {
    let sobol = report.sobol.as_ref().filter(|sobol| sobol.used < sobol.rows)?;
    let (used, rows) = (sobol.used, sobol.rows);
    Some(format!("only where it exists: Sobol's indices are of {used} of {rows} samples"))
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> Value {
    let sobol = report.sobol.as_ref();
    json!({
        "scene": name,
        "output": report.output.name,
        "output_of_scene": report.own,
        "seed": report.seed,
        "samples": report.samples,
        "samples_used": sobol.map(|sobol| sobol.used),
        "mean": sobol.map(|sobol| sobol.mean),
        "variance": sobol.map(|sobol| sobol.variance),
        "variables": table(name, report).objects(|key| !["scene", "output"].contains(&key)),
    })
}
