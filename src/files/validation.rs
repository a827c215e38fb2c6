//! The measurements with their presets, and the computed table for machines. SI.

use serde_json::Value;

use crate::files::error::FileError;
use crate::files::preset;
use crate::files::rows::{Rows, number};
use crate::study::validation::{CASES, NOT_CHECKED, NotChecked, Row, compute};

/// Every case, computed from its bundled preset.
///
/// # Errors
/// [`FileError`] should a preset be missing.
pub fn report() -> Result<Vec<Row>, FileError> {
    CASES.iter().map(|case| Ok(compute(case, &preset::resolve(case.preset, None)?.scene))).collect()
}

/// One row a case, and one for each that cannot be checked, without numbers and with the reason.
pub fn rows(report: &[Row]) -> Rows {
    let row = |row: &Row| {
        let case = row.case;
        let word = |text: &str| Value::from(text);
        vec![
            word(case.id),
            word(case.preset),
            word(case.quantity.word()),
            word(case.quantity.unit()),
            number(Some(case.measured)),
            number(case.resolution),
            word(row.closure),
            number(row.computed),
            number(row.computed.map(|value| row.error(value))),
            number(row.other),
            number(row.other.map(|value| row.error(value))),
            number(Some(row.thickness_ratio)),
            number(Some(row.pressure_pa)),
            word(case.nose),
            word(case.projectile),
            word(case.source),
            word(case.caution),
            row.beyond.as_deref().map_or(Value::Null, Value::from),
            Value::Null,
        ]
    };
    Rows {
        columns: vec![
            "case",
            "preset",
            "quantity",
            "unit",
            "measured",
            "resolution",
            "closure",
            "computed",
            "relative_error",
            "other_closure",
            "other_relative_error",
            "thickness_over_diameter",
            "nose_pressure_pa",
            "nose",
            "projectile",
            "source",
            "caution",
            "beyond_closure",
            "not_checked_because",
        ],
        rows: report.iter().map(row).chain(NOT_CHECKED.iter().map(not_checked)).collect(),
    }
}

/// The case, what it says, where it comes from and why it is not checked; the rest is empty.
fn not_checked(it: &NotChecked) -> Vec<Value> {
    let mut row = vec![Value::Null; 19];
    row[0] = Value::from(it.id);
    row[2] = Value::from(it.says);
    row[15] = Value::from(it.source);
    row[18] = Value::from(it.why);
    row
}
