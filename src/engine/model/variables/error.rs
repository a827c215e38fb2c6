//! Errors of variables, by kind.

use thiserror::Error;

use crate::model::units::UnitError;

/// Reason why a variable cannot be set, or why values make no sense together, with the remedy.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum VariableError {
    /// No variable has this name.
    #[error("`{name}` is not a variable: {cure}")]
    Unknown {
        /// Name as it was written.
        name: String,
        /// Nearest names, as a hint.
        cure: String,
    },
    /// The text is not a number of the variable's dimension.
    #[error("{symbol} ({key}): {source}")]
    Unreadable {
        /// Symbol of the variable.
        symbol: &'static str,
        /// Key of the variable.
        key: &'static str,
        /// Reason, with the remedy.
        source: UnitError,
    },
    /// The word is not a choice of the variable.
    #[error("{symbol} ({key}) = `{value}` is not one of {allowed}")]
    NotAChoice {
        /// Symbol of the variable.
        symbol: &'static str,
        /// Key of the variable.
        key: &'static str,
        /// Word as it was written.
        value: String,
        /// Allowed choices.
        allowed: String,
    },
    /// The number makes no physical sense by itself.
    #[error("{symbol} ({key}) = {value} is impossible: {meaning} must be {allowed}; {cure}")]
    Impossible {
        /// Symbol of the variable.
        symbol: &'static str,
        /// Key of the variable.
        key: &'static str,
        /// Number with its unit.
        value: String,
        /// Meaning of the variable.
        meaning: &'static str,
        /// Allowed values.
        allowed: String,
        /// Suggested replacement.
        cure: String,
    },
    /// Values of several variables make no sense together, or not for a study.
    #[error("{problem}")]
    Together {
        /// Keys of the variables.
        keys: Vec<&'static str>,
        /// Values, rule and remedy.
        problem: String,
    },
    /// An element of a stack makes no sense by itself.
    #[error("{place}: {source}")]
    Element {
        /// Name of the element.
        place: String,
        /// Reason why the element makes no sense.
        source: Box<Self>,
    },
    /// The row interval of a series is not positive.
    #[error(
        "every_s = {every_s} s is no distance of rows: it must be a number greater than 0 s; omit it for the solver's own steps"
    )]
    Rows {
        /// Row interval, s.
        every_s: String,
    },
}

impl VariableError {
    /// Creates an error of values that make no sense together.
    pub(in crate::model) fn together(keys: &[&'static str], problem: String) -> Self {
        Self::Together { keys: keys.to_vec(), problem }
    }

    /// Returns the keys of the variables that the error concerns.
    pub fn keys(&self) -> Vec<&'static str> {
        match self {
            Self::Unreadable { key, .. }
            | Self::NotAChoice { key, .. }
            | Self::Impossible { key, .. } => vec![key],
            Self::Together { keys, .. } => keys.clone(),
            Self::Element { source, .. } => source.keys(),
            Self::Unknown { .. } | Self::Rows { .. } => Vec::new(),
        }
    }
}
