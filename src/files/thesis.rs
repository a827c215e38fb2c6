//! The reproduction report as rows for machines, and the stored verdicts it is held to.

use serde_json::Value;

use crate::files::rows::Rows;
use crate::study::thesis::{Opens, Row};

/// Verdict by claim, as last looked through by a person: `id,verdict` lines.
const STORED: &str = include_str!("../../tests/cases/thesis-verdicts.csv");

/// Names of a row's values.
const COLUMNS: [&str; 9] =
    ["id", "where", "says", "sound", "as_printed", "verdict", "cause", "preset", "runs"];

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
            Value::from(row.found.cause),
            preset,
            Value::from(row.runs),
        ]
    };
    Rows { columns: COLUMNS.to_vec(), rows: report.iter().map(row).collect() }
}

/// Where verdicts differ from the stored ones, in words; rows that are missing count, too.
pub fn differences(report: &[Row]) -> Vec<String> {
    let stored: Vec<(&str, &str)> =
        STORED.lines().skip(1).filter_map(|line| line.split_once(',')).collect();
    let mut told = Vec::new();
    for row in report {
        let (id, now) = (row.claim.id, row.found.verdict.words());
        match stored.iter().find(|(known, _)| *known == id) {
            None => told.push(format!("{id}: {now}, and no verdict is stored")),
            Some((_, before)) if *before != now => {
                told.push(format!("{id}: {now}, stored is {before}"));
            }
            Some(_) => {}
        }
    }
    for (id, before) in stored {
        if report.iter().all(|row| row.claim.id != id) {
            told.push(format!("{id}: no such row, stored is {before}"));
        }
    }
    told
}
