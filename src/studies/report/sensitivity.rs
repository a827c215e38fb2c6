//! Report of the sensitivity study: a table with one row for each variable and bars, and an object. SI.

use serde_json::{Value, json};

use crate::report::chart::without_common_unit;
use crate::report::page::Page;
use crate::report::table::Table;
use crate::study::sensitivity::{Effect, POINTS, SensitivityReport};
use cmra_engine::model::units::{Dimension, in_unit, significant};

/// Part of the result that a change must exceed: of the 1e-12 to which results are known, a slope over a thousandth of the value makes at
/// most 5e-11 in a step of a tenth of it.
const ROUNDING: f64 = 1e-10;

/// Number of cells of a bar.
pub const CELLS: usize = 8;

/// Characters for the levels of a bar in ASCII, from zero to the end of the scale.
pub const ASCII: [char; 8] = [' ', '.', ':', '-', '=', '+', '*', '#'];

/// Characters for the levels of a bar in eighths of a block.
pub const BLOCKS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// Draws the bar of an effect: a cell for each eighth of the range, its level on the common scale; blank without a result.
pub fn bar(effect: &Effect, scale: f64, levels: [char; 8]) -> String {
    let level = |value: f64| {
        let count = levels.len();
        let part = value / scale * count as f64;
        levels[(1..count).take_while(|level| part >= *level as f64).count()]
    };
    effect.cells(CELLS).into_iter().map(|cell| cell.map_or(' ', level)).collect()
}

/// Returns the table of the variables, sorted by decreasing effect. A row is the index of a variable in the report.
pub fn table<'c>(name: &'c str, report: &'c SensitivityReport) -> Table<'c, usize> {
    let effect = |at: &usize| &report.effects[*at];
    let axis = move |at: &usize| &effect(at).axis;
    let end = move |at: &usize, place: usize| effect(at).points[place];
    let outcome = move |at: &usize, place: usize| end(at, place).map(|it| it.outcome.key());
    let unit = report.output.unit();
    Table::new(report.order())
        .field("scene", move |_| name)
        .with("output", "quantity", "", |_| report.output.name)
        .with("variable", "", "", move |at| axis(at).symbol())
        .with("key", "key", "", move |at| axis(at).variable().key)
        .field("value", move |at| effect(at).own)
        .field("low", move |at| axis(at).ends().0)
        .field("high", move |at| axis(at).ends().1)
        .with("output_at_low", "at low", unit, move |at| end(at, 0)?.result)
        .with("outcome_at_low", "at low", "", move |at| outcome(at, 0))
        .with("output_at_high", "at high", unit, move |at| end(at, POINTS - 1)?.result)
        .with("outcome_at_high", "at high", "", move |at| outcome(at, POINTS - 1))
        .with("least", "least", unit, move |at| Some(report.range(effect(at))?.0))
        .with("greatest", "greatest", unit, move |at| Some(report.range(effect(at))?.1))
        .with("swing", "swing", unit, move |at| report.swing(effect(at)))
        .field("slope", move |at| effect(at).slope)
        .field("points", move |at| effect(at).computed())
}

/// Columns of [`bars`], the most important first.
pub const COLUMNS: [&str; 5] = ["variable", "bar", "span", "slope", "range"];

/// Returns the table for readers, sorted by decreasing effect, with texts and a bar such as `|  ..:-=#|`.
pub fn bars(report: &SensitivityReport, levels: [char; 8]) -> Table<'_, usize> {
    let effect = |at: &usize| &report.effects[*at];
    let scale = report.scale();
    let span = move |at: &usize| {
        let least_and_greatest = span(report, effect(at))?;
        Some(format!("{least_and_greatest}{}", if effect(at).perforates() { " P" } else { "" }))
    };
    Table::new(report.order())
        .with("variable", "", "", move |at| effect(at).axis.symbol())
        .with("bar", "low to high", "", move |at| {
            scale.map(|scale| format!("|{}|", bar(effect(at), scale, levels)))
        })
        .with("span", report.output.heading(), "", span)
        .with("slope", "here", "", move |at| {
            // The range column shows the unit.
            slope_words(report, effect(at), &Shown { unit: "", ..usual(effect(at)) })
        })
        .with("range", "range", "", move |at| range_words(effect(at), &usual(effect(at))))
}

/// Columns of the page in reading order.
const KEYS: [&str; 5] = ["variable", "range", "bar", "span", "slope"];

/// Returns the report: the bars of all variables, and what they mean.
pub fn page(title: &str, report: &SensitivityReport, levels: [char; 8], is_usual: bool) -> Page {
    let own = report.output.show_any(report.own.and_then(|own| own.result), 4);
    let mut page = Page::new(format!("{title}: what {} depends on", report.output.title()));
    page.line(format!("the scene itself: {own}"));
    if is_usual {
        page.paragraph(
            "one variable at a time: the ranges of Table 9.2, else a quarter to four times the scene's value by logarithm; \
             --over NAME=LO..HI, repeated, varies others instead",
            2,
        );
    }
    page.space();
    let Some(scale) = report.scale().filter(|_| !report.is_empty()) else {
        page.line("nothing to compare: no run has this result; choose another one: --output");
        return page;
    };
    page.table(bars(report, levels).cells(&KEYS));
    let top = report.output.show(scale, 3);
    let through = if report.effects.iter().any(Effect::perforates) {
        "; P: shots perforate within the range"
    } else {
        ""
    };
    page.space();
    let bars = format!(
        "bars: 0 to {top}, the 95th percentile of all runs; here: by the slope at the scene's value{through}"
    );
    page.paragraph(bars, 2);
    page
}

/// Display of a variable's values: a number in a unit.
pub struct Shown<'a> {
    /// Factor from the stored unit to this unit.
    pub in_one: f64,
    /// Name of the unit.
    pub unit: &'a str,
}

/// Returns the display in the unit of screens.
fn usual(effect: &Effect) -> Shown<'static> {
    let quantity = effect.axis.variable().number().map(|number| number.quantity);
    let unit = quantity.map_or("", Dimension::shown_unit);
    let in_one = quantity.and_then(|quantity| in_unit(1.0, unit, quantity)).unwrap_or(1.0);
    Shown { in_one, unit }
}

/// Formats the range: `0.8 to 7`.
fn range_words(effect: &Effect, shown: &Shown<'_>) -> String {
    let ends = effect.axis.ends();
    let [from, to] = [ends.0, ends.1].map(|end| significant(shown.in_one * end, 4));
    format!("{from} to {to} {}", shown.unit).trim_end().to_owned()
}

/// Formats the minimum and maximum result: `4.27 to 6.49 mm`.
fn span(report: &SensitivityReport, effect: &Effect) -> Option<String> {
    let (least, greatest) = report.range(effect)?;
    let [least, greatest] = [least, greatest].map(|value| report.output.show(value, 3));
    Some(format!("{} to {greatest}", without_common_unit(least, &greatest)))
}

/// Formats the slope as `+0.13 mm for +0.1`: the change of the result for a round change of at most a tenth of the variable.
pub fn slope_words(
    report: &SensitivityReport,
    effect: &Effect,
    shown: &Shown<'_>,
) -> Option<String> {
    let (slope, own) = (effect.slope?, effect.own?);
    let (low, high) = effect.axis.ends();
    let size = if own == 0.0 { 0.1 * (high - low).abs() } else { own.abs() };
    let step = 10f64.powf((shown.in_one * size).log10().floor() - 1.0);
    let by = slope * step / shown.in_one;
    let by =
        if by.abs() < report.own_result().map_or(0.0, |it| ROUNDING * it.abs()) { 0.0 } else { by };
    if by == 0.0 {
        let step = format!("{} {}", significant(step, 1), shown.unit);
        return Some(format!("{} for +{}", report.output.show(0.0, 2), step.trim_end()));
    }
    let sign = if by < 0.0 { "-" } else { "+" };
    let by = report.output.show(by.abs(), 2);
    let step = format!("{} {}", significant(step, 1), shown.unit);
    Some(format!("{sign}{by} for +{}", step.trim_end()))
}

/// Describes an effect: `gamma 0.8 to 7: depth 4.27 to 6.49 mm; here +0.13 mm for +0.1`.
pub fn words(report: &SensitivityReport, effect: &Effect, of: &str, shown: &Shown<'_>) -> String {
    let range = format!("{} {}", effect.axis.symbol(), range_words(effect, shown));
    let Some(span) = span(report, effect) else { return format!("{range}: {of} has no value") };
    let through = if effect.perforates() { ", perforates" } else { "" };
    let here = slope_words(report, effect, shown);
    let here = here.map_or_else(String::new, |here| format!("; here {here}"));
    format!("{range}: {of} {span}{through}{here}")
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, report: &SensitivityReport) -> Value {
    json!({
        "scene": name,
        "output": report.output.name,
        "output_of_scene": report.own.and_then(|own| own.result),
        "scale": report.scale(),
        "variables": table(name, report).objects(|key| !["scene", "output"].contains(&key)),
    })
}
