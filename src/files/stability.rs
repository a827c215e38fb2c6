//! The battery and the map for machines: CSV and JSON, SI units, empty or null where a quantity does not exist. Knows no screen.

use serde_json::{Value, json};

use crate::files::error::FileError;
use crate::files::rows::{Rows, number};
use crate::study::stability::Row;
use crate::study::stability::map::Map;
use crate::study::stability::others::Other;

/// Names and values of a row.
fn entries(row: &Row) -> Vec<(String, Value)> {
    let run = &row.run;
    let pair = |name: &str, value: Value| (name.to_owned(), value);
    let mut list = vec![
        pair("scene", row.case.name.into()),
        pair("changes", row.case.changes.into()),
        pair("outcome", run.outcome.word().into()),
        pair("end", run.end.words().into()),
        pair("energy_residual", number(Some(run.ledger.residual()))),
        pair("error", number(row.error)),
        pair("reference", row.basis.words().into()),
        pair("method", run.cost.method.into()),
        pair("steps", run.cost.steps.into()),
        pair("rejected", run.cost.rejected.into()),
        pair("run_time_s", number(Some(row.took_s))),
        pair("stiffness", number(Some(row.stiffness.largest()))),
        pair("swings_rad", number(Some(row.stiffness.swings_rad))),
        pair("decays", number(Some(row.stiffness.decays))),
    ];
    for (other, verdict) in Other::ALL.iter().zip(row.others) {
        list.push((other.key().to_owned(), verdict.word().into()));
        list.push((format!("{}_error", other.key()), number(verdict.error())));
    }
    let shortfall = row.shortfall.map_or(Value::Null, |shortfall| shortfall.words().into());
    list.push(pair("shortfall", shortfall));
    list.push(pair("why_hard", row.case.why.into()));
    list
}

/// One row a scene.
///
/// # Errors
/// [`FileError::Csv`] should a row be malformed.
pub fn csv(rows: &[Row]) -> Result<String, FileError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (index, row) in rows.iter().enumerate() {
        let entries = entries(row);
        if index == 0 {
            writer.write_record(entries.iter().map(|(name, _)| name))?;
        }
        writer.write_record(entries.iter().map(|(_, value)| match value {
            Value::String(text) => text.clone(),
            Value::Null => String::new(),
            other => other.to_string(),
        }))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The whole battery.
pub fn json(rows: &[Row]) -> String {
    let short = rows.iter().filter(|row| row.shortfall.is_some()).count();
    let list: Vec<Value> = rows.iter().map(|row| entries(row).into_iter().collect()).collect();
    let value = json!({ "rows": list, "count": rows.len(), "short": short });
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}

/// The map, one row a cell: the greatest step of stability stands beside each, empty where nothing limits it.
pub fn map_rows(scene: &str, map: &Map) -> Rows {
    let row = |row: usize, column: usize| {
        vec![
            Value::from(scene),
            Value::from(map.method.name()),
            Value::from(map.axis.symbol()),
            number(Some(map.values[row])),
            number(Some(map.dt_s[column])),
            Value::from(map.cell(row, column).word()),
            number(map.limit_s[row]),
        ]
    };
    let columns = 0..map.dt_s.len();
    let rows = (0..map.values.len()).flat_map(|at| columns.clone().map(move |other| (at, other)));
    Rows {
        columns: vec!["scene", "method", "variable", "value", "dt_s", "cell", "limit_dt_s"],
        rows: rows.map(|(at, other)| row(at, other)).collect(),
    }
}

/// The map; its cells as letters, row by row.
pub fn map_json(scene: &str, map: &Map) -> String {
    let rows: Vec<String> = (0..map.values.len())
        .map(|row| (0..map.dt_s.len()).map(|column| map.cell(row, column).letter()).collect())
        .collect();
    let value = json!({
        "scene": scene,
        "method": map.method.name(),
        "variable": map.axis.symbol(),
        "dt_s": map.dt_s,
        "values": map.values,
        "cells": rows,
        "limit_dt_s": map.limit_s.iter().map(|limit| number(*limit)).collect::<Vec<_>>(),
        "present": { "value": map.present.0, "dt_s": map.present.1 },
        "largest_stable_dt_s": number(map.largest_stable_dt_s),
    });
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}
