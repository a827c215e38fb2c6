//! Why a variable cannot be set.

use thiserror::Error;

use crate::model::units::QuantityError;

/// Why a variable cannot be set.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum VariableError {
    /// No variable has this name.
    #[error("`{name}` is not a variable: {hint}")]
    Unknown {
        /// What was written.
        name: String,
        /// The nearest names, or where to find the list.
        hint: String,
    },
    /// The text is no value for this variable.
    #[error("{symbol} ({key}): {problem}")]
    Unreadable {
        /// The symbol.
        symbol: &'static str,
        /// The key.
        key: &'static str,
        /// What is wrong with the text.
        problem: QuantityError,
    },
    /// A word or switch value that is not among the choices.
    #[error("{symbol} ({key}) = `{text}` is not one of {choices}")]
    NotAChoice {
        /// The symbol.
        symbol: &'static str,
        /// The key.
        key: &'static str,
        /// What was written.
        text: String,
        /// What is allowed.
        choices: String,
    },
    /// A number without physical sense.
    #[error("{symbol} ({key}) = {value} is impossible: {meaning} must be {allowed}; {cure}")]
    Impossible {
        /// The symbol.
        symbol: &'static str,
        /// The key.
        key: &'static str,
        /// The value with its unit.
        value: String,
        /// What the variable is.
        meaning: &'static str,
        /// What is allowed.
        allowed: String,
        /// What to do.
        cure: String,
    },
    /// Two values that make no sense together.
    #[error("{0}")]
    Together(String),
}
