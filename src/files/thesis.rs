//! The reproduction report, the screening matrix and the principles as rows for machines.

use serde_json::Value;

use crate::files::rows::{Rows, number};
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, ranking};
use crate::study::thesis::{Opens, Row};

/// Names of a row's values.
const COLUMNS: [&str; 10] =
    ["id", "where", "says", "sound", "as_printed", "verdict", "cause", "preset", "runs", "basis"];

/// The report as rows.
pub fn rows(report: &[Row]) -> Rows {
    let row = |row: &Row| {
        let preset = match row.claim.opens {
            Opens::Preset(name) => Value::from(name),
            Opens::Nothing | Opens::Scene(_) => Value::Null,
        };
        let text = |text: &str| if text.is_empty() { Value::Null } else { Value::from(text) };
        vec![
            Value::from(row.claim.id),
            Value::from(row.claim.place),
            Value::from(row.claim.says),
            text(&row.found.sound),
            text(&row.found.printed),
            Value::from(row.found.verdict.words()),
            Value::from(row.claim.cause),
            preset,
            Value::from(row.runs),
            Value::from(row.found.basis.words()),
        ]
    };
    Rows { columns: COLUMNS.to_vec(), rows: report.iter().map(row).collect() }
}

/// The ranking of the concepts by weights in percent, the first one first, beside the printed one.
pub fn screening(weights: &[f64; 7]) -> Rows {
    let rows = ranking(weights)
        .iter()
        .map(|place| {
            let concept = &CONCEPTS[place.concept];
            vec![
                Value::from(place.rank),
                Value::from(concept.name),
                number(Some(place.total)),
                Value::from(concept.rank),
                number(Some(concept.total)),
                Value::from(concept.section),
                Value::from(concept.preset),
            ]
        })
        .collect();
    let columns =
        vec!["rank", "concept", "total", "rank_printed", "total_printed", "section", "preset"];
    Rows { columns, rows }
}

/// The principles with their families and functions, in the order of Table 4.1.
pub fn principles() -> Rows {
    let rows = PRINCIPLES
        .iter()
        .map(|it| {
            let functions: Vec<&str> = it.functions.iter().map(|it| it.name()).collect();
            vec![
                Value::from(it.family),
                Value::from(it.name),
                Value::from(it.section),
                Value::from(it.idea),
                Value::from(functions.join(", ")),
                Value::from(it.computed),
                it.preset.map_or(Value::Null, Value::from),
            ]
        })
        .collect();
    let columns = vec!["family", "principle", "section", "idea", "functions", "computed", "preset"];
    Rows { columns, rows }
}
