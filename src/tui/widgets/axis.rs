//! Form rows of an axis: variable, ends, number of points, spacing.

use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::tui::widgets::cycled;
use crate::tui::widgets::form::{FieldQuantity, FormRow, VALUE_WIDTH};
use crate::tui::widgets::value_steps::{self, Input, shown_number};
use cmra_engine::model::scene::{Scene, SweepAxis};
use cmra_engine::model::units::{self, Bare};
use cmra_engine::model::variables::{self, Allowed, Number, VARIABLES, Variable};

/// Maximum number of digits of a field.
pub(crate) const FIELD_DIGITS: usize = 12;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Name,
    From,
    To,
    Points,
    Spacing,
}

impl Part {
    /// Returns the form row, with the ends in the display unit of the variable.
    pub(crate) fn line(self, axis: &SweepAxis, unit: &'static str) -> FormRow {
        let variable = variables::find(&axis.name).ok();
        let end = |label: &str, value: f64| {
            let number = variable.and_then(Variable::number);
            let value =
                number.and_then(|it| units::in_unit(value, unit, it.quantity)).unwrap_or(value);
            FormRow {
                text: Some(units::significant(value, FIELD_DIGITS)),
                unit,
                quantity: Some(FieldQuantity { unit: unit.to_owned(), variable }),
                ..FormRow::choice(label, shown_number(value, usize::from(VALUE_WIDTH)))
            }
        };
        let line = match self {
            Self::Name => FormRow::typed("variable", &axis.name),
            Self::From => end("from", axis.from),
            Self::To => end("to", axis.to),
            Self::Points => FormRow::typed("points", axis.count.to_string()),
            Self::Spacing => FormRow::choice("spacing", if axis.log { "log" } else { "linear" }),
        };
        line.means(variable.map_or_else(|| axis.name.clone(), meaning))
    }

    /// Changes a value; the number of points must be in the given range.
    pub(crate) fn change(
        self,
        axis: &mut SweepAxis,
        (scene, unit): (&Scene, &str),
        input: Input<'_>,
        counts: &RangeInclusive<u64>,
    ) -> Result<(), String> {
        match (self, input) {
            (Self::Name, Input::Text(text)) => *axis = over(scene, find(text)?, axis.count)?,
            (Self::Name, Input::Step(press)) => {
                let all: Vec<&'static Variable> = numeric(scene).collect();
                let now = variables::find(&axis.name).ok();
                let at = all.iter().position(|it| now.is_some_and(|now| it.key == now.key));
                let next = cycled(at.unwrap_or(0), press.by(), all.len());
                *axis = over(scene, all[next], axis.count)?;
            }
            (Self::From | Self::To, _) => {
                let greatest = if axis.from.abs() > axis.to.abs() { axis.from } else { axis.to };
                let end = if self == Self::From { &mut axis.from } else { &mut axis.to };
                *end = changed_end((find(&axis.name)?, unit), *end, greatest, input)?;
            }
            (Self::Points, Input::Text(text)) => {
                axis.count = usize::try_from(whole(text, counts)?).unwrap_or(usize::MAX);
            }
            (Self::Points, Input::Step(_)) => return Err("<enter> types a value here".to_owned()),
            (Self::Spacing, _) => axis.log = !axis.log,
        }
        Ok(())
    }
}

/// Changes an end. Steps are proportional to the range, because an end at 0 has no magnitude.
fn changed_end(
    (variable, unit): (&'static Variable, &str),
    end: f64,
    greatest: f64,
    input: Input<'_>,
) -> Result<f64, String> {
    let number = number_of(variable)?;
    match input {
        Input::Text(text) => units::parse_relative(text, end, number.quantity, Bare::In(unit))
            .map_err(|problem| format!("{}: {problem}", variable.symbol)),
        Input::Step(press) => {
            let plain = value_steps::decade(variable, greatest);
            value_steps::stepped(variable, end, press, plain).ok_or_else(|| {
                format!("{} cannot go further: it must be {}", variable.symbol, variable.allowed())
            })
        }
    }
}

/// Describes a variable: `gamma: mass ratio of the plate to the projectile`.
pub(crate) fn meaning(variable: &Variable) -> String {
    format!("{}: {}", variable.symbol, variable.meaning)
}

/// Creates an axis over a variable: the thesis's range, or from half to twice the present value.
pub(crate) fn over(
    scene: &Scene,
    variable: &'static Variable,
    count: usize,
) -> Result<SweepAxis, String> {
    let number = number_of(variable)?;
    let (from, to) = variable.thesis_range.unwrap_or_else(|| {
        let value = (number.get)(scene)
            .unwrap_or_else(|| value_steps::first_value(variable, number, scene));
        let (from, to) = if value == 0.0 { (0.0, 1.0) } else { (0.5 * value, 2.0 * value) };
        let most = match number.allowed {
            Allowed::Between(_, high) => high,
            Allowed::Below(_, high) => 0.75 * high,
            _ => f64::INFINITY,
        };
        (from, if to < most { to } else { most })
    });
    Ok(SweepAxis::linear(variable.symbol, from, to, count))
}

/// Iterates over the numeric variables in the order of the editor, the possible axes. Of the inputs for the plate's size only the scene's
/// own is included.
pub(crate) fn numeric(scene: &Scene) -> impl Iterator<Item = &'static Variable> {
    let is_axis = |variable: &&Variable| {
        variable.number().is_some() && !variables::overrules_size(variable, scene)
    };
    VARIABLES.iter().filter(is_axis)
}

/// Parses or steps a whole number in a range.
pub(crate) fn whole<T: FromStr + PartialOrd + Display>(
    text: &str,
    allowed: &RangeInclusive<T>,
) -> Result<T, String> {
    let value = text.parse().ok().filter(|value| allowed.contains(value));
    let (least, most) = (allowed.start(), allowed.end());
    value.ok_or_else(|| format!("`{text}` must be a whole number, {least} to {most}"))
}

fn find(name: &str) -> Result<&'static Variable, String> {
    variables::find(name).map_err(|error| error.to_string())
}

fn number_of(variable: &'static Variable) -> Result<&'static Number, String> {
    variable.number().ok_or_else(|| {
        let (symbol, allowed) = (variable.symbol, variable.allowed());
        format!("{symbol} has no numbers to sweep over, only {allowed}: choose a numeric variable")
    })
}
