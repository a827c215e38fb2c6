//! Options that are an amount with a unit.

use crate::cli::CliError;
use crate::model::units::{self, Bare, Quantity};

/// An amount above zero, SI.
pub(super) fn amount(
    option: &str,
    text: &str,
    quantity: Quantity,
    example: &str,
) -> Result<f64, CliError> {
    let value = read(option, text, quantity)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(CliError::Option(format!("{option} {text}: must be greater than 0, for example {example}")))
}

/// An amount, SI.
pub(super) fn read(option: &str, text: &str, quantity: Quantity) -> Result<f64, CliError> {
    let value = units::parse(text, quantity, Bare::Si)
        .map_err(|problem| CliError::Option(format!("{option} {text}: {problem}")))?;
    if value.is_finite() {
        return Ok(value);
    }
    Err(CliError::Option(format!("{option} {text}: must be a finite number")))
}
