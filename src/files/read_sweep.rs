//! The `[sweep]` table of a scene: axes over variables, and names of results. Read strictly, run elsewhere.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::files::error::nearest;
use crate::files::read::{Reader, kind_of, number};
use crate::model::scene::{Sweep, SweepAxis};
use crate::model::units;
use crate::model::variables::{self, Kind, Number};
use crate::study::quantities;
use crate::study::sweep::{Axis, COUNTS};

const AXIS_EXAMPLE: &str = r#"{ name = "gamma", from = 0.8, to = 7.0, count = 101 }"#;
const AXIS_KEYS: [&str; 6] = ["name", "from", "to", "count", "log", "values"];
const RANGE_KEYS: [&str; 4] = ["from", "to", "count", "log"];
const LIST_EXAMPLE: &str = r#"{ name = "k", values = [1e4, 1e5] }"#;

/// Read the table; `None` when it is unusable (the reader knows why).
pub(super) fn sweep(reader: &mut Reader<'_>, value: &Spanned<DeValue<'_>>) -> Option<Sweep> {
    let DeValue::Table(table) = value.get_ref() else {
        let text = format!(
            "sweep = {} is {}: `sweep` is a table; write [sweep] with axes and outputs below it",
            reader.shown(value),
            kind_of(value.get_ref())
        );
        reader.problem(value.span(), text);
        return None;
    };
    let mut sweep = Sweep::default();
    for (key, value) in table {
        match key.get_ref().as_ref() {
            "axes" => sweep.axes = axes(reader, value),
            "outputs" => sweep.outputs = outputs(reader, value),
            other => {
                let hint = nearest(other, &["axes", "outputs"], "the keys here are");
                reader.problem(
                    key.span(),
                    format!("`sweep.{other}` is not a key of a scene: {hint}"),
                );
            }
        }
    }
    if !table.contains_key("axes") {
        reader.problem(
            value.span(),
            format!("sweep.axes is missing: write at least one axis, for example axes = [{AXIS_EXAMPLE}]"),
        );
    }
    Some(sweep)
}

fn axes(reader: &mut Reader<'_>, value: &Spanned<DeValue<'_>>) -> Vec<SweepAxis> {
    let rows = match value.get_ref() {
        DeValue::Array(rows) if !rows.is_empty() => rows,
        _ => {
            let text = format!(
                "sweep.axes = {} must be a list of one or more axes; write for example [{AXIS_EXAMPLE}]",
                reader.shown(value)
            );
            reader.problem(value.span(), text);
            return Vec::new();
        }
    };
    let mut axes: Vec<SweepAxis> = Vec::new();
    for row in rows {
        if reader.is_full() {
            break;
        }
        let Some(axis) = axis(reader, row) else {
            continue;
        };
        let key_of = |name: &str| variables::find(name).map(|variable| variable.key).ok();
        if axes.iter().any(|other| key_of(&other.name) == key_of(&axis.name)) {
            let text =
                format!("sweep.axes: `{}` is swept twice; give each variable one axis", axis.name);
            reader.problem(row.span(), text);
        }
        axes.push(axis);
    }
    axes
}

fn axis(reader: &mut Reader<'_>, row: &Spanned<DeValue<'_>>) -> Option<SweepAxis> {
    let DeValue::Table(table) = row.get_ref() else {
        let text = format!(
            "sweep.axes: {} is {}: an axis is a table; write for example {AXIS_EXAMPLE}",
            reader.shown(row),
            kind_of(row.get_ref())
        );
        reader.problem(row.span(), text);
        return None;
    };
    for key in table.keys() {
        let name = key.get_ref().as_ref();
        if !AXIS_KEYS.contains(&name) {
            let hint = nearest(name, &AXIS_KEYS, "the keys here are");
            reader.problem(
                key.span(),
                format!("sweep.axes: `{name}` is not a key of an axis: {hint}"),
            );
        }
    }
    let (name, variable) = swept(reader, row, table)?;
    if let Some(values) = table.get("values") {
        return listed(reader, table, values, &name);
    }
    let from = bound(reader, row, table, "from", &name, variable);
    let to = bound(reader, row, table, "to", &name, variable);
    let count = count(reader, row, table, &name);
    let log = log(reader, table, &name);
    let axis =
        SweepAxis { name, from: from?, to: to?, count: count?, log: log?, values: Vec::new() };
    check_ends(reader, row, &axis);
    Some(axis)
}

/// An axis over a list of values.
fn listed(
    reader: &mut Reader<'_>,
    table: &DeTable<'_>,
    value: &Spanned<DeValue<'_>>,
    name: &str,
) -> Option<SweepAxis> {
    if let Some(key) = RANGE_KEYS.into_iter().find(|key| table.contains_key(*key)) {
        let text = format!(
            "sweep.axes: {name} has `values` and `{key}`: an axis is a list of values or a range; leave out one of them"
        );
        reader.problem(value.span(), text);
        return None;
    }
    let numbers: Option<Vec<f64>> = match value.get_ref() {
        DeValue::Array(items) => items.iter().map(|item| number(item.get_ref())).collect(),
        _ => None,
    };
    let Some(values) = numbers else {
        let text = format!(
            "sweep.axes: values = {} of {name} must be a list of numbers; write for example {LIST_EXAMPLE}",
            reader.shown(value)
        );
        reader.problem(value.span(), text);
        return None;
    };
    let axis: Result<_, _> = Axis::listed(name, &values, &COUNTS);
    axis.map_err(|problem| reader.problem(value.span(), format!("sweep.axes: {problem}")))
        .ok()
        .map(|axis| SweepAxis { name: name.to_owned(), ..axis.asked() })
}

fn check_ends(reader: &mut Reader<'_>, row: &Spanned<DeValue<'_>>, axis: &SweepAxis) {
    let SweepAxis { name, from, to, .. } = axis;
    let (low, high) = (units::shortest(*from), units::shortest(*to));
    if from.to_bits() == to.to_bits() {
        let text =
            format!("sweep.axes: {name} goes from {low} to {high}: the two ends must differ");
        reader.problem(row.span(), text);
    } else if axis.log && (*from <= 0.0 || *to <= 0.0) {
        let text = format!(
            "sweep.axes: {name} goes from {low} to {high} at equal ratios: both ends must be greater than 0; \
             leave out log or change the ends"
        );
        reader.problem(row.span(), text);
    }
}

/// The axis's variable, which must have numbers.
fn swept(
    reader: &mut Reader<'_>,
    row: &Spanned<DeValue<'_>>,
    table: &DeTable<'_>,
) -> Option<(String, &'static Number)> {
    let Some(value) = table.get("name") else {
        reader.problem(
            row.span(),
            format!("sweep.axes: `name` is missing; write for example {AXIS_EXAMPLE}"),
        );
        return None;
    };
    let DeValue::String(name) = value.get_ref() else {
        let text = format!(
            "sweep.axes: name = {} is {}: it must be a variable's symbol or key in quotes",
            reader.shown(value),
            kind_of(value.get_ref())
        );
        reader.problem(value.span(), text);
        return None;
    };
    match variables::find(name) {
        Err(error) => {
            reader.problem(value.span(), format!("sweep.axes: {error}"));
            None
        }
        Ok(variable) => match &variable.kind {
            Kind::Number(number) => Some((name.clone().into_owned(), number)),
            Kind::Choice(_) | Kind::Switch { .. } => {
                reader.problem(
                    value.span(),
                    format!("sweep.axes: `{name}` has no numbers to sweep over; choose a numeric variable"),
                );
                None
            }
        },
    }
}

fn bound(
    reader: &mut Reader<'_>,
    row: &Spanned<DeValue<'_>>,
    table: &DeTable<'_>,
    key: &str,
    name: &str,
    variable: &Number,
) -> Option<f64> {
    let allowed = variable.allowed.describe(variable.quantity);
    let Some(value) = table.get(key) else {
        reader.problem(
            row.span(),
            format!("sweep.axes: `{key}` of {name} is missing; it must be {allowed}"),
        );
        return None;
    };
    let found = number(value.get_ref()).filter(|number| variable.allowed.contains(*number));
    if found.is_none() {
        let text = format!(
            "sweep.axes: {key} = {} of {name} is impossible: it must be {allowed}",
            reader.shown(value)
        );
        reader.problem(value.span(), text);
    }
    found
}

fn count(
    reader: &mut Reader<'_>,
    row: &Spanned<DeValue<'_>>,
    table: &DeTable<'_>,
    name: &str,
) -> Option<usize> {
    let Some(value) = table.get("count") else {
        reader.problem(
            row.span(),
            format!("sweep.axes: `count` of {name} is missing; write for example count = 101"),
        );
        return None;
    };
    let whole = match value.get_ref() {
        DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix()).ok(),
        _ => None,
    };
    let allowed = whole.filter(|count| COUNTS.contains(count));
    let found = allowed.and_then(|count| usize::try_from(count).ok());
    if found.is_none() {
        let text = format!(
            "sweep.axes: count = {} of {name} must be a whole number from {} to {}",
            reader.shown(value),
            COUNTS.start(),
            COUNTS.end()
        );
        reader.problem(value.span(), text);
    }
    found
}

fn log(reader: &mut Reader<'_>, table: &DeTable<'_>, name: &str) -> Option<bool> {
    let Some(value) = table.get("log") else {
        return Some(false);
    };
    if let DeValue::Boolean(on) = value.get_ref() {
        return Some(*on);
    }
    let text = format!(
        "sweep.axes: log = {} of {name} is {}: it must be true or false",
        reader.shown(value),
        kind_of(value.get_ref())
    );
    reader.problem(value.span(), text);
    None
}

fn outputs(reader: &mut Reader<'_>, value: &Spanned<DeValue<'_>>) -> Vec<String> {
    let DeValue::Array(rows) = value.get_ref() else {
        let text = format!(
            "sweep.outputs = {} is {}: it must be a list of result names in quotes",
            reader.shown(value),
            kind_of(value.get_ref())
        );
        reader.problem(value.span(), text);
        return Vec::new();
    };
    let mut outputs = Vec::new();
    for row in rows {
        match row.get_ref() {
            DeValue::String(name) if quantities::find(name).is_some() => {
                outputs.push(name.clone().into_owned());
            }
            other => {
                let shown = reader.shown(row);
                let bare = shown.trim_matches(['"', '\'']);
                let hint = quantities::nearest(bare);
                let kind = match other {
                    DeValue::String(_) => "is not a result of a run".to_owned(),
                    other => format!("is {}, not the name of a result", kind_of(other)),
                };
                reader.problem(row.span(), format!("sweep.outputs: {shown} {kind}: {hint}"));
            }
        }
    }
    outputs
}
