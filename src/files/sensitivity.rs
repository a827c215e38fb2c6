//! Which variables matter, for machines: a row a variable, or one JSON object. SI; effects and swings in the result's unit.

use serde_json::{Value, json};

use crate::files::rows::{Rows, number};
use crate::study::sensitivity::Report;

const COLUMNS: [&str; 18] = [
    "scene",
    "output",
    "variable",
    "key",
    "low",
    "high",
    "output_at_low",
    "output_at_high",
    "swing",
    "morris_mu_star",
    "morris_mu",
    "morris_sigma",
    "sobol_first",
    "sobol_first_low_95",
    "sobol_first_high_95",
    "sobol_total",
    "sobol_total_low_95",
    "sobol_total_high_95",
];

/// One row a variable, the one that matters most first.
pub fn rows(name: &str, report: &Report) -> Rows {
    let row = |at: usize| {
        let (axis, bar) = (&report.axes[at], report.bars[at]);
        let effect = report.effects.get(at).copied().unwrap_or_default();
        let indices = report.sobol.as_ref().map(|sobol| sobol.inputs[at]).unwrap_or_default();
        let mut row = vec![
            Value::from(name),
            Value::from(report.output.name),
            Value::from(axis.symbol()),
            Value::from(axis.variable().key),
        ];
        let (low, high) = axis.ends();
        let numbers = [Some(low), Some(high), bar.low, bar.high, bar.swing()];
        let morris = [effect.magnitude, effect.mean, effect.deviation];
        row.extend(numbers.into_iter().chain(morris).map(number));
        for index in [indices.first, indices.total] {
            row.push(number(index.map(|index| index.value)));
            row.push(number(index.map(|index| index.range95.0)));
            row.push(number(index.map(|index| index.range95.1)));
        }
        row
    };
    Rows { columns: COLUMNS.to_vec(), rows: report.order().into_iter().map(row).collect() }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let table = rows(name, report);
    let variables = table.rows.iter().map(|row| {
        let entries = table.columns.iter().zip(row).skip(2);
        entries.map(|(key, value)| ((*key).to_owned(), value.clone())).collect::<Value>()
    });
    let sobol = report.sobol.as_ref();
    let object = json!({
        "scene": name,
        "output": report.output.name,
        "output_of_scene": number(report.own),
        "seed": report.effort.seed,
        "trajectories": report.effort.trajectories,
        "samples": report.effort.rows,
        "samples_used": sobol.map(|sobol| sobol.used),
        "mean": number(sobol.map(|sobol| sobol.mean)),
        "variance": number(sobol.map(|sobol| sobol.variance)),
        "variables": variables.collect::<Vec<_>>(),
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}
