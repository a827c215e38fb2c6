//! The battery and the map of a fixed-step method, SI.

use serde_json::{Value, json};

use crate::report::chart::{Axis, Scale, Unit, ViewRange};
use crate::report::map::{self, MapMark, Tone};
use crate::report::page::{MAP, Page};
use crate::report::svg::Picture;
use crate::report::table::Table;
use crate::study::accuracy::reference::ReferenceSource;
use crate::study::stability::map::{Cell, Map, THESIS_DT_S};
use crate::study::stability::scene::{SceneStability, ToleranceRow};
use crate::study::stability::{ERROR_MAX, FailureReason, RESIDUAL_MAX, Row};
use crate::study::sweep;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::units::{engineering, significant};
use cmra_engine::numerics::larger;

/// Columns of a page that say how a scene has run.
pub const HOW_IT_RAN: [&str; 5] = ["outcome", "energy_residual", "error", "steps", "run_time_s"];

/// A size in five characters: `2e-13`.
fn brief(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.0e}") }
}

/// Returns the outcome of a run in four characters.
fn ends(run: &Run) -> &'static str {
    match run.outcome {
        _ if !run.end.is_complete() => "CUT",
        Outcome::Arrested => "arr",
        Outcome::Perforated => "perf",
        Outcome::Separated => "sep",
        Outcome::Moving => "mov",
        Outcome::Unmeasured => "open",
    }
}

/// The runs of one scene, one row for each tolerance.
pub fn scene_table(found: &SceneStability) -> Table<'_, &ToleranceRow> {
    let letter = found.basis.map_or(' ', ReferenceSource::letter);
    let small = |value: &Value| Some(brief(value.as_f64()?.abs()));
    Table::new(&found.rows)
        .with("tolerance", "tolerance", "", |row| row.run.scene.run.tolerance)
        .shown(move |_, value| small(value))
        .with("outcome", "ends", "", |row| row.run.outcome.word())
        .shown(|row, _| Some(ends(&row.run).to_owned()))
        .with("steps", "steps", "", |row| row.run.cost.steps)
        .with("rejected", "rejected", "", |row| row.run.cost.rejected)
        .with("rhs_evaluations", "evaluations", "", |row| row.run.cost.rhs_evaluations)
        .with("energy_residual", "energy", "", |row| row.run.ledger.residual())
        .shown(move |_, value| small(value))
        .with("error", "error", "", |row| row.error)
        .shown(move |_, value| Some(format!("{}{letter}", small(value)?)))
        .with("greatest_estimate", "estimate", "", |row| {
            row.run.estimate.by_result.iter().map(|it| it.1).reduce(larger)
        })
        .shown(move |_, value| small(value))
}

/// Returns the report of one scene.
pub fn scene_page(found: &SceneStability, scene: &str) -> Page {
    let mut page = Page::new(format!("{scene}: how auto runs it, by tolerance"));
    page.space();
    let columns = [
        "tolerance",
        "outcome",
        "steps",
        "rejected",
        "rhs_evaluations",
        "energy_residual",
        "error",
        "greatest_estimate",
    ];
    page.table(scene_table(found).cells(&columns));
    page.space();
    let stiffness = found.stiffness_ratio.map_or_else(
        || "unknown: the plate is fixed, or the projectile is not stopped".to_owned(),
        |ratio| {
            format!(
                "{}: contact time over the shortest time scale of the mount",
                significant(ratio, 2)
            )
        },
    );
    page.fact("stiffness", 12, stiffness);
    for (label, text) in LEGEND {
        page.fact(label, 12, text);
    }
    page.fact("estimate", 12, "the greatest of the errors that the run states for its results");
    page
}

/// The runs of one scene, with the source of their errors.
pub fn scene_json(found: &SceneStability) -> Value {
    json!({
        "stiffness_ratio": found.stiffness_ratio,
        "reference": found.basis.map(ReferenceSource::label),
        "rows": scene_table(found).objects(|_| true),
    })
}

/// The battery, one row for each scene.
pub fn table<'c>(rows: impl IntoIterator<Item = &'c Row>) -> Table<'c, &'c Row> {
    Table::new(rows)
        .with("scene", "scene", "", |row| row.case.name)
        .field("changes", |row| row.case.changes)
        .with("outcome", "ends", "", |row| row.run.outcome.word())
        .shown(|row, _| Some(ends(&row.run).to_owned()))
        .field("end", |row| row.run.end.words())
        .with("energy_residual", "energy", "", |row| row.run.ledger.residual())
        .shown(|_, value| Some(brief(value.as_f64()?.abs())))
        .with("error", "error", "", |row| row.error)
        .shown(|row, value| Some(format!("{}{}", brief(value.as_f64()?), row.basis?.letter())))
        .with("reference", "error against", "", |row| {
            row.basis.map_or_else(|| "none".to_owned(), ReferenceSource::label)
        })
        .field("method", |row| row.run.cost.method)
        .with("steps", "steps", "", |row| row.run.cost.steps)
        .field("rejected", |row| row.run.cost.rejected)
        .with("run_time_s", "time", "", |row| row.took_s)
        .shown(|row, _| Some(engineering(row.took_s, "s", 2)))
        .with("shortfall", "pass", "", |row| row.shortfall.map(FailureReason::words))
        .shown(|row, _| Some(if row.shortfall.is_some() { "FAIL" } else { "ok" }.to_owned()))
        .with("why_hard", "difficulty", "", |row| row.case.why)
}

/// The whole battery.
pub fn json(rows: &[Row]) -> Value {
    let short = rows.iter().filter(|row| row.shortfall.is_some()).count();
    let list = table(rows).objects(|_| true);
    json!({ "rows": list, "count": rows.len(), "short": short })
}

/// Returns a sentence for each scene that fails.
pub fn failures(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter().filter_map(|row| {
        let (name, end) = (row.case.name, row.run.end.words());
        Some(format!("{name} fails: {} ({end})", row.shortfall?.words()))
    })
}

/// Legend of the columns, a line each.
const LEGEND: [(&str, &str); 2] = [
    ("ends", "arrested, perforated, separated, moving (undecided), or CUT"),
    (
        "error",
        "the greatest of depth, times, displacement, velocity and forces (of an undecided scene, of the first stop), against \
     s stored digits, D DOP853 at 1e-13 or R Radau IIA of order 5 at 1e-12, or t this solver at 1e-13 where both fail",
    ),
];

/// Returns the report of the test scenes: table, legend and a summary line; `missing` names the omitted part of an interrupted study.
pub fn battery_page(rows: &[Row], took_s: f64, is_wide: bool, missing: Option<String>) -> Page {
    let mut keys = vec!["scene"];
    keys.extend(HOW_IT_RAN);
    if is_wide {
        keys.extend(["reference", "why_hard"]);
    }
    let mut page = Page::default();
    page.table(table(rows).cells(&keys));
    page.lines(failures(rows));
    page.space();
    for (label, text) in LEGEND {
        page.fact(label, 12, text);
    }
    page.space();
    match missing {
        Some(missing) => page.line(missing),
        None => summary(&mut page, rows, took_s),
    }
    page
}

fn summary(page: &mut Page, rows: &[Row], took_s: f64) {
    let short: Vec<&str> =
        rows.iter().filter(|row| row.shortfall.is_some()).map(|row| row.case.name).collect();
    let without = rows.iter().filter(|row| row.basis.is_none()).count();
    let (all, passed) = (rows.len(), rows.len() - short.len());
    page.line(format!(
        "{passed} of {all} scenes pass (energy and error within {RESIDUAL_MAX:e} and {ERROR_MAX:e}; {without} without a reference); {took_s:.1} s"
    ));
    if !short.is_empty() {
        page.line(format!("auto fails on: {}", short.join("; ")));
    }
}

/// Returns the report of a map of a method with a fixed step.
pub fn map_page(map: &Map, scene: &str) -> Page {
    let (method, symbol) = (map.method.name(), map.variable.symbol());
    let mut page = Page::new(format!(
        "{method} on {scene}: time step against {symbol}; a run uses auto, for which see cmra accuracy"
    ));
    page.space();
    page.picture(Picture::Map(picture(map)), MAP);
    page
}

/// The map, one row a cell.
pub fn map_table<'c>(scene: &'c str, map: &'c Map) -> Table<'c, (usize, usize)> {
    let (columns, rows) = map.counts();
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    Table::new(cells)
        .field("scene", move |_| scene)
        .field("method", |_| map.method.name())
        .field("variable", |_| map.variable.symbol())
        .field("value", |at| map.variable.value(at.0 as u64))
        .field("dt_s", |at| map.dt.value(at.1 as u64))
        .field("cell", |at| map.cell(at.0, at.1).word())
}

/// The map; its cells as they are shaded, row by row.
pub fn map_json(scene: &str, map: &Map) -> Value {
    let (columns, rows) = map.counts();
    let shades = |row| (0..columns).map(move |column| map.cell(row, column).shade());
    let rows: Vec<String> = (0..rows).map(|row| shades(row).collect()).collect();
    json!({
        "scene": scene,
        "method": map.method.name(),
        "variable": map.variable.symbol(),
        "dt_s": map.dt.values(),
        "values": map.variable.values(),
        "cells": rows,
        "present": { "value": map.present, "dt_s": THESIS_DT_S },
    })
}

/// The map as a picture.
pub fn picture(found: &Map) -> map::Map<'static> {
    let axis = |axis: &sweep::Axis| {
        let (low, high) = axis.ends();
        let unit = Unit::new(axis.variable().unit());
        Axis::new(axis.symbol(), ViewRange::new(low, high)).scale(Scale::Log10).unit(unit)
    };
    let axes = (axis(&found.dt), axis(&found.variable));
    let cell = |column: usize, row: usize| {
        let cell = found.cell(row, column);
        map::Cell::Mark(cell.shade(), tone(cell))
    };
    let named = Cell::ALL.into_iter().filter(|cell| *cell != Cell::Waiting);
    let mark =
        |cell: Cell| MapMark { more: cell.more(), ..MapMark::new(cell.shade(), cell.label()) };
    let mut marks: Vec<MapMark> = named.map(mark).collect();
    marks.push(MapMark::new('+', "the scene with dt = 1e-6 s"));
    map::Map {
        present: found.present_at().map(|at| (at, '+')),
        marks,
        ..map::Map::new(title(found), axes, found.counts(), None, cell)
    }
}

/// The title of a map: of which scheme it speaks.
pub fn title(found: &Map) -> String {
    format!("{}, not auto", found.method.name())
}

/// How a cell's shade stands out.
pub fn tone(cell: Cell) -> Tone {
    match cell {
        Cell::Accurate => Tone::Plain,
        Cell::Inaccurate => Tone::Warning,
        Cell::BlownUp => Tone::Error,
        Cell::TooManySteps | Cell::Unknown | Cell::Waiting => Tone::Faint,
    }
}
