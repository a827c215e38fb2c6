//! Scatter for machines: a row a result, or one JSON object. SI, percent for percentages.

use serde_json::{Map, Value, json};

use crate::files::rows::{Rows, number};
use crate::study::search::scatter::{Report, SHARES, Summary};

const COLUMNS: [&str; 16] = [
    "scene",
    "output",
    "nominal",
    "count",
    "mean",
    "mean_low_95",
    "mean_high_95",
    "deviation",
    "q01",
    "q05",
    "q25",
    "q50",
    "q75",
    "q95",
    "q99",
    "seed",
];

/// One row a result.
pub fn rows(name: &str, report: &Report) -> Rows {
    let row = |summary: &Summary| {
        let mut row = vec![
            Value::from(name),
            Value::from(summary.measure.name),
            number(summary.nominal),
            Value::from(summary.sorted.len()),
        ];
        let mean = summary.mean;
        row.push(number(mean.map(|mean| mean.0)));
        row.push(number(mean.map(|mean| mean.1.0)));
        row.push(number(mean.map(|mean| mean.1.1)));
        row.push(number(summary.deviation));
        for share in SHARES {
            row.push(number(summary.quantile(share).map(|quantile| quantile.value)));
        }
        row.push(Value::from(report.seed));
        row
    };
    Rows { columns: COLUMNS.to_vec(), rows: report.summaries.iter().map(row).collect() }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let inputs = report.tolerances.iter().zip(&report.redrawn).map(|(tolerance, redrawn)| {
        let (first, second) = tolerance.distribution.numbers();
        json!({
            "variable": tolerance.symbol(), "key": tolerance.variable().key,
            "distribution": tolerance.distribution.word(),
            "parameters": [number(Some(first)), number(Some(second))], "redrawn": redrawn,
        })
    });
    let words = ["arrested", "perforated", "separated", "moving", "failed"];
    let census: Map<String, Value> = words
        .iter()
        .zip(report.census)
        .map(|(word, count)| ((*word).to_owned(), Value::from(count)))
        .collect();
    let outputs = report.summaries.iter().map(|summary| {
        let quantiles = summary.quantiles.iter().map(|quantile| {
            json!({
                "share": quantile.share, "value": number(Some(quantile.value)),
                "low_95": number(Some(quantile.range95.0)), "high_95": number(Some(quantile.range95.1)),
            })
        });
        json!({
            "output": summary.measure.name, "nominal": number(summary.nominal),
            "count": summary.sorted.len(), "mean": number(summary.mean.map(|mean| mean.0)),
            "mean_low_95": number(summary.mean.map(|mean| mean.1.0)),
            "mean_high_95": number(summary.mean.map(|mean| mean.1.1)),
            "deviation": number(summary.deviation), "quantiles": quantiles.collect::<Vec<_>>(),
        })
    });
    let perforated = report.perforated.map(|(part, (low, high))| {
        json!({ "probability": number(Some(part)), "low_95": number(Some(low)), "high_95": number(Some(high)) })
    });
    let object = json!({
        "scene": name,
        "inputs": inputs.collect::<Vec<_>>(),
        "seed": report.seed,
        "samples": report.samples,
        "complete": report.is_complete,
        "outcomes": census,
        "perforation": perforated,
        "outputs": outputs.collect::<Vec<_>>(),
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}
