//! The texts of the claims: numbers in words, and texts with expressions in them.

use crate::model::units::{self, engineering};
use crate::study::thesis::value::{Curve, Value};

#[derive(Clone, Copy, Debug)]
struct Format {
    /// The separator of the values of a list.
    between: &'static str,
    style: Style,
}

#[derive(Clone, Copy, Debug)]
enum Style {
    Number,
    Millimetres,
    Percent,
    Signed,
    Unit(&'static str),
    Ends,
}

const UNITS: [&str; 6] = ["m/s", "N/m", "N", "s", "Pa", "J"];

/// A text with the expressions in it computed: `{depth(rigid) | mm} deep`.
pub(super) fn filled(
    text: &str,
    value: &dyn Fn(&str) -> Result<Value, String>,
) -> Result<String, String> {
    let mut parts = text.split('{');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (inner, plain) =
            part.split_once('}').ok_or_else(|| format!("`{text}`: `}}` is missing"))?;
        let (expression, format) = inner.split_once(" | ").unwrap_or((inner, ""));
        out += &Format::parse(format)?.write(&value(expression)?)?;
        out += plain;
    }
    Ok(out)
}

impl Format {
    fn parse(text: &str) -> Result<Self, String> {
        let spaced = text.strip_prefix("spaced");
        let between = if spaced.is_some() { " " } else { ", " };
        let style = match spaced.unwrap_or(text).trim() {
            "" => Style::Number,
            "mm" => Style::Millimetres,
            "%" => Style::Percent,
            "+%" => Style::Signed,
            "ends" => Style::Ends,
            unit => Style::Unit(UNITS.into_iter().find(|own| *own == unit).ok_or_else(|| {
                format!(
                    "`{unit}` is no format: take mm, %, +%, ends or one of {}",
                    UNITS.join(", ")
                )
            })?),
        };
        Ok(Self { between, style })
    }

    fn write(self, value: &Value) -> Result<String, String> {
        Ok(match value {
            Value::List(list) => {
                let all: Vec<String> =
                    list.iter().map(|it| self.write(it)).collect::<Result<_, _>>()?;
                all.join(self.between)
            }
            Value::Text(text) => text.clone(),
            Value::Truth(truth) => truth.to_string(),
            Value::Curve(curve) => ends(curve),
            Value::Number(value) => match self.style {
                Style::Number | Style::Ends => number(*value),
                Style::Millimetres if value.is_finite() => format!("{:.4} mm", 1e3 * value),
                Style::Millimetres => "perforated".to_owned(),
                Style::Percent => percent(*value),
                Style::Signed if value.is_nan() => "-".to_owned(),
                Style::Signed => format!("{value:+.1} %"),
                Style::Unit(unit) => engineering(*value, unit, 4),
            },
        })
    }
}

/// Four figures.
fn number(value: f64) -> String {
    units::significant(value, 4)
}

/// One decimal.
pub(super) fn percent(value: f64) -> String {
    if value.is_finite() { format!("{value:.1} %") } else { "perforated".to_owned() }
}

/// First and last value of a curve: `60.0 % at gamma = 0.8, 91.5 % at 7`.
pub(super) fn ends(curve: &Curve) -> String {
    let (Some(first), Some(last)) = (curve.points.first(), curve.points.last()) else {
        return "nothing finite".to_owned();
    };
    let (along, unit) = (curve.along, curve.unit);
    let [from, low, to, high] = [first.0, first.1, last.0, last.1].map(number);
    format!("{low} {unit} at {along} = {from}, {high} {unit} at {to}")
}
