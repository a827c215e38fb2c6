//! Report of measured and computed limits: a row for each measurement, a line for each class, and a picture. SI.

use serde_json::{Value, json};

use crate::report::chart::{Axis, Chart, Curve, Scale, Unit};
use crate::report::page::Page;
use crate::report::table::{Cells, Table};
use crate::report::verdict;
use crate::study::measured::{Errors, OUTPUTS, Row, errors};
use crate::study::quantities::{EXPECTED, find};

/// Markers of the classes in the picture; the largest class comes first.
const MARKERS: [char; 8] = ['o', 'x', '+', 's', 'd', '*', 'v', 'm'];

/// Returns the table of measurements with their computed values.
pub fn rows(rows: &[Row]) -> Table<'_, &Row> {
    let measured = |row: &&Row| row.measurement.measured;
    let table = Table::new(rows)
        .with("line", "line", "", |row| row.measurement.line)
        .field("source", |row| row.measurement.source.as_str())
        .with("measured_limit_m_s", "measured", "m/s", move |row| measured(row).limit_m_s)
        .field("deviation_m_s", move |row| measured(row).deviation_m_s)
        .with("limit_velocity_m_s", "law", "m/s", |row| row.verdict()?.limit_m_s);
    let table = verdict::expected_columns(table, |row| row.verdict()?.expected.as_ref());
    let table = table
        .with("relative_error", "error", "", |row| row.limit_error())
        .shown(|_, value| Some(format!("{:+.1} %", 100.0 * value.as_f64()?)))
        .with("inside_band", "inside", "", |row| row.is_inside())
        .with("measured_depth_m", "depth", "m", move |row| measured(row).depth_m)
        .with("depth_m", "computed", "m", |row| row.computed.as_ref().ok()?.depth_m)
        .with("measured_residual_velocity_m_s", "residual", "m/s", move |row| {
            measured(row).residual_velocity_m_s
        })
        .with("residual_velocity_m_s", "computed", "m/s", |row| {
            row.computed.as_ref().ok()?.residual_velocity_m_s
        });
    let outputs = (0..OUTPUTS.len()).fold(table, |table, at| {
        let (name, key) = OUTPUTS[at];
        let (title, unit) =
            find(name).map_or_else(|| (name.to_owned(), ""), |it| (it.heading(), it.unit()));
        table.with(key, title, unit, move |row| measured(row).outputs[at]).with(
            name,
            "computed",
            unit,
            move |row| row.computed.as_ref().ok()?.outputs[at],
        )
    });
    outputs
        .field("note", |row| row.measurement.note.as_str())
        .with("refused", "", "", |row| row.computed.as_ref().err().cloned())
}

/// Returns the columns of a page: those of measured quantities.
fn page_keys(rows: &[Row]) -> Vec<&'static str> {
    let limit = [
        "measured_limit_m_s",
        "limit_velocity_m_s",
        EXPECTED[0],
        EXPECTED[1],
        EXPECTED[2],
        "relative_error",
    ];
    let has = |is_measured: fn(&Row) -> bool| rows.iter().any(is_measured);
    let mut keys = vec!["line"];
    if has(|row| row.measurement.measured.limit_m_s.is_some()) {
        keys.extend(limit);
    }
    if has(|row| row.measurement.measured.depth_m.is_some()) {
        keys.extend(["measured_depth_m", "depth_m"]);
    }
    if has(|row| row.measurement.measured.residual_velocity_m_s.is_some()) {
        keys.extend(["measured_residual_velocity_m_s", "residual_velocity_m_s"]);
    }
    for (at, (name, key)) in OUTPUTS.into_iter().enumerate() {
        if rows.iter().any(|row| row.measurement.measured.outputs[at].is_some()) {
            keys.extend([key, name]);
        }
    }
    keys
}

/// Returns the table of errors by class and for all rows.
pub fn error_table(list: &[Errors]) -> Table<'_, &Errors> {
    // A class of a single paper has no band, one of few rows no scatter.
    let shown = |value: &Value, text: fn(f64) -> String| {
        Some(value.as_f64().map_or_else(String::new, text))
    };
    let signed = move |_: &&Errors, it: &Value| shown(it, |it| format!("{:+.1} %", 100.0 * it));
    let scatter = move |_: &&Errors, it: &Value| shown(it, |it| format!("{:.1} %", 100.0 * it));
    let share = move |_: &&Errors, it: &Value| shown(it, |it| format!("{:.0} %", 100.0 * it));
    let speed = move |_: &&Errors, it: &Value| shown(it, |it| format!("{it:.1}"));
    Table::new(list)
        .with("class", "class", "", |it| it.group.as_deref().unwrap_or("all"))
        .with("rows", "rows", "", |it| it.rows)
        .with("papers", "from", "", |it| it.papers)
        .with("bias", "bias", "", |it| it.bias)
        .shown(signed)
        .with("standard_deviation", "sd", "", |it| it.deviation)
        .shown(scatter)
        .with("mean_absolute_error_m_s", "mean", "", |it| it.mean_absolute_m_s)
        .shown(speed)
        .with("rms_error_m_s", "RMS", "", |it| it.rms_m_s)
        .shown(speed)
        .field("rows_with_band", |it| it.banded)
        .with("share_inside_band", "inside", "", |it| it.share_inside())
        .shown(share)
}

/// Columns of the errors on a page, with the widest last.
const ERROR_KEYS: [&str; 8] = [
    "rows",
    "papers",
    "bias",
    "standard_deviation",
    "mean_absolute_error_m_s",
    "rms_error_m_s",
    "share_inside_band",
    "class",
];

/// Returns the errors by class and for all rows, as columns of a page.
pub fn error_cells(list: &[Errors]) -> Vec<Cells> {
    error_table(list).cells(&ERROR_KEYS)
}

/// Returns the page of measurements: the rows, those that cannot be computed, and the errors.
pub fn page(rows: &[Row]) -> Page {
    let mut page = Page::default();
    list(&mut page, rows);
    for line in refusals(rows) {
        page.fact("refused: ", 9, line);
    }
    page.space();
    error_page(&mut page, rows);
    page
}

/// Appends the rows, in the columns of measured quantities.
pub(super) fn list(page: &mut Page, list: &[Row]) {
    page.table(rows(list).cells(&page_keys(list)));
}

/// Appends the errors by class and what their columns mean; nothing without errors.
pub(super) fn error_page(page: &mut Page, list: &[Row]) {
    let list = errors(list);
    if !list.is_empty() {
        page.table(error_cells(&list));
        page.paragraph(ERRORS_MEAN, 0);
    }
}

/// Explanation of the columns.
const ERRORS_MEAN: &str = "from: number of papers; bias and sd: mean and standard deviation of computed over measured, less 1; mean: mean \
     absolute error, m/s; RMS: root mean square error, m/s; inside: part of the limits inside their 90 % band. Positive bias is \
     unconservative.";

/// Returns the whole report as an object.
pub fn json(list: &[Row]) -> Value {
    let refused = list.iter().filter(|row| row.computed.is_err()).count();
    json!({
        "rows": rows(list).objects(|_| true),
        "errors": error_table(&errors(list)).objects(|_| true),
        "refused": refused,
    })
}

/// Lists the rows that cannot be computed, one per line.
pub fn refusals(list: &[Row]) -> Vec<String> {
    let refused = list.iter().filter_map(|row| {
        let why = row.computed.as_ref().err()?;
        Some(format!("line {}: {why}", row.measurement.line))
    });
    refused.collect()
}

/// Returns the chart of computed over measured limits, by class; `None` without a measured limit.
pub fn picture(list: &[Row]) -> Option<Chart<'static>> {
    let points = |row: &Row| Some((row.measurement.measured.limit_m_s?, 1.0 + row.limit_error()?));
    let all: Vec<(f64, f64)> = list.iter().filter_map(points).collect();
    let x = Axis::over("measured limit", "m/s", Scale::Linear, all.iter().map(|at| at.0))?;
    let y = Axis::over("computed over measured", "", Scale::Linear, all.iter().map(|at| at.1))?;
    let groups: Vec<String> = errors(list).into_iter().filter_map(|it| it.group).collect();
    let curves = groups.into_iter().enumerate().map(|(at, group)| {
        let own = list.iter().filter(|row| row.group() == group).filter_map(points);
        let own: Vec<(f64, f64)> = own.collect();
        let marker = MARKERS[at % MARKERS.len()];
        Curve::points(marker, group, own).colour(at + 1)
    });
    let (x, y) = (x.unit(Unit::new("m/s")).padded(0.04), y.padded(0.04));
    Some(Chart::new("computed over measured limits, by class", x, y, curves.collect()))
}
