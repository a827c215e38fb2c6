//! The measurements with their presets, and the computed table for machines. SI.

use std::ops::{ControlFlow, Range};

use serde_json::Value;

use crate::files::error::FileError;
use crate::files::preset;
use crate::files::rows::{Rows, number};
use crate::study::sweep::crew::Crew;
use crate::study::validation::{Bias, Class, NOT_CHECKED, NotChecked, Row, biases, cases, compute};

/// Every case, computed from its bundled preset on all cores; `watch` is asked with the cases done and all, and `Break` keeps
/// those.
///
/// # Errors
/// [`FileError`] should a preset be missing.
pub fn report(
    watch: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Result<Vec<Row>, FileError> {
    let all: Vec<_> = cases()
        .map(|case| Ok((case, preset::resolve(case.preset, None)?.scene)))
        .collect::<Result<_, FileError>>()?;
    let crew = Crew { piece: 1, ..Crew::of_machine() };
    let mut rows = Vec::new();
    let compute = |piece: Range<u64>| {
        let (case, scene) = all.get(usize::try_from(piece.start).ok()?)?;
        Some(compute(case, scene))
    };
    let _ = crew.work_heard(
        0..all.len() as u64,
        || compute,
        |news| {
            rows.extend(news.and_then(|(_, row)| row));
            watch(rows.len(), all.len())
        },
    );
    Ok(rows)
}

/// Columns of the table.
const COLUMNS: [&str; 22] = [
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
    "class",
    "points",
    "relative_error_deviation",
];

/// One row a case; one for each that cannot be checked, without numbers and with the reason; and one for the bias of each class.
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
            word(case.class.word()),
            Value::Null,
            Value::Null,
        ]
    };
    Rows {
        columns: COLUMNS.to_vec(),
        rows: report
            .iter()
            .map(row)
            .chain(NOT_CHECKED.iter().map(not_checked))
            .chain(biases(report).iter().map(bias))
            .collect(),
    }
}

/// The case, what it says, where it comes from and why it is not checked; the rest is empty.
fn not_checked(it: &NotChecked) -> Vec<Value> {
    let mut row = vec![Value::Null; COLUMNS.len()];
    row[0] = Value::from(it.id);
    row[2] = Value::from(it.says);
    row[15] = Value::from(it.source);
    row[18] = Value::from(it.why);
    row
}

/// The class, how many points it has, and their mean and standard deviation.
fn bias(it: &Bias) -> Vec<Value> {
    let mut row = vec![Value::Null; COLUMNS.len()];
    row[0] = Value::from("bias");
    row[2] = Value::from("mean relative error");
    row[8] = number(Some(it.mean));
    row[19] = Value::from(it.class.map_or("all points", Class::word));
    row[20] = Value::from(it.points);
    row[21] = number(it.deviation);
    row
}
