//! Strict reader of the `[sweep]` table of a scene: axes and names of quantities.

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeValue, ValueDeserializer};

use crate::files::clean;
use crate::files::reader::{Reader, misfit};
use cmra_engine::model::scene::{Sweep, SweepAxis};
use cmra_engine::model::variables;
use cmra_studies::study::quantities;
use cmra_studies::study::sweep::{Axis, COUNTS};

const EXAMPLE: &str = r#"axes = [{ name = "gamma", from = 0.8, to = 7.0, count = 101 }]"#;

/// Table as in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct Table {
    axes: Vec<AxisRow>,
    #[serde(default)]
    outputs: Vec<Spanned<String>>,
}

/// Axis as in the file: a range or a list of values.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct AxisRow {
    name: Spanned<String>,
    from: Option<f64>,
    to: Option<f64>,
    count: Option<u64>,
    #[serde(default)]
    log: bool,
    values: Option<Vec<f64>>,
}

impl AxisRow {
    fn axis(&self) -> Result<SweepAxis, String> {
        let name = self.name.get_ref();
        let axis = match (self.from, self.to, self.count, &self.values) {
            (Some(from), Some(to), Some(count), None) => {
                let count = usize::try_from(count).unwrap_or(usize::MAX);
                SweepAxis { log: self.log, ..SweepAxis::linear(name, from, to, count) }
            }
            (None, None, None, Some(values)) if !self.log && !values.is_empty() => {
                SweepAxis { values: values.clone(), ..SweepAxis::linear(name, 0.0, 0.0, 0) }
            }
            (.., Some(values)) if !values.is_empty() => {
                return Err(format!(
                    "{name} has `values` and a range: an axis has one of them; omit the other"
                ));
            }
            _ => {
                return Err(format!("{name} lacks from, to or count; write for example {EXAMPLE}"));
            }
        };
        let axis = Axis::from_sweep_axis(&axis, &COUNTS).map_err(|error| error.to_string())?;
        Ok(SweepAxis { name: name.clone(), ..axis.to_sweep_axis() })
    }
}

/// Reads the table; reports problems and returns `None` if it is invalid.
pub(super) fn sweep(reader: &mut Reader<'_>, value: &Spanned<DeValue<'_>>) -> Option<Sweep> {
    let table = match Table::deserialize(ValueDeserializer::from(value.clone())) {
        Ok(table) => table,
        Err(error) => {
            let span = error.span().unwrap_or_else(|| value.span());
            let text = format!("sweep: {}; write for example {EXAMPLE}", misfit(&error));
            reader.problem(span, text);
            return None;
        }
    };
    let mut sweep = Sweep::default();
    if table.axes.is_empty() {
        reader.problem(value.span(), format!("sweep.axes is empty: write for example {EXAMPLE}"));
    }
    for row in &table.axes {
        if reader.is_full() {
            break;
        }
        let key = |name: &str| variables::find(name).map(|variable| variable.key).ok();
        let is_same = |other: &SweepAxis| key(&other.name) == key(row.name.get_ref());
        match row.axis() {
            Err(text) => reader.problem(row.name.span(), format!("sweep.axes: {text}")),
            Ok(axis) if sweep.axes.iter().any(is_same) => {
                let name = axis.name;
                let text = format!("`{name}` is swept twice; give each variable one axis");
                reader.problem(row.name.span(), format!("sweep.axes: {text}"));
            }
            Ok(axis) => sweep.axes.push(axis),
        }
    }
    for name in table.outputs {
        let (span, name) = (name.span(), name.into_inner());
        if quantities::find(&name).is_none() {
            let (hint, name) = (quantities::nearest(&name), clean::line(&name));
            let text = format!("sweep.outputs: \"{name}\" is not a result of a run: {hint}");
            reader.problem(span, text);
        }
        sweep.outputs.push(name);
    }
    Some(sweep)
}
