//! Parsers of numeric options: positive values with a unit, counts, fractions.

use std::ops::RangeInclusive;

use clap::builder::{RangedU64ValueParser, TypedValueParser};

use cmra_engine::model::units::{self, Bare, Dimension};

/// Parses a positive value, SI or with a unit.
pub(super) fn above_zero(
    quantity: Dimension,
    example: &'static str,
) -> impl TypedValueParser<Value = f64> {
    move |text: &str| {
        let value = units::parse(text, quantity, Bare::Si)?;
        let problem = || format!("must be greater than 0, for example {example}");
        (value > 0.0).then_some(value).ok_or_else(problem)
    }
}

/// Returns a parser of a count within a range.
pub(super) fn count(bounds: RangeInclusive<u64>) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(bounds)
}

/// Parses a fraction, as a number or in percent.
pub(super) fn part(text: &str) -> Result<f64, String> {
    let (number, whole) = match text.trim().strip_suffix('%') {
        Some(percent) => (percent.trim(), 100.0),
        None => (text.trim(), 1.0),
    };
    let number = number.parse::<f64>().map(|number| number / whole);
    number.map_err(|_not_a_number| "write a fraction, for example 0.02 or 2%".to_owned())
}

/// Parses a relative standard deviation of at most 0.5.
pub(super) fn deviation(text: &str) -> Result<f64, String> {
    let part = part(text)?;
    let problem = || "outside 0..0.5: write a fraction, for example 0.02 or 2%".to_owned();
    (0.0..=0.5).contains(&part).then_some(part).ok_or_else(problem)
}
