//! Errors of quantities in user notation, by kind. Columns count from 1; long texts are shortened.

use thiserror::Error;

/// Reason why a text is not a quantity, with the remedy.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitError {
    /// There is no text.
    #[error("empty: write a number, for example `{example}`")]
    Empty {
        /// A value that can be read.
        example: &'static str,
    },
    /// The text does not begin with a number.
    #[error("`{text}` is not a number (column {column}): write for example `{example}`")]
    NotANumber {
        /// Text as it was written.
        text: String,
        /// First column that is not of a number.
        column: usize,
        /// A value that can be read.
        example: &'static str,
    },
    /// The value is NaN or infinite, or overflows.
    #[error("`{text}` is not a finite number: write for example `{example}`")]
    NotFinite {
        /// Text as it was written.
        text: String,
        /// A value that can be read.
        example: &'static str,
    },
    /// The number has a decimal comma or a thousands separator.
    #[error("`{text}` has a comma (column {column}): {cure}")]
    Comma {
        /// Text as it was written.
        text: String,
        /// Column of the comma.
        column: usize,
        /// How to write the number.
        cure: String,
    },
    /// A bare number is an angle where degrees and radians are possible.
    #[error("`{text}` is an angle without a unit: write `{text} deg` or `{text} rad`")]
    AngleWithoutUnit {
        /// Text as it was written.
        text: String,
    },
    /// The unit is unknown, or of another dimension.
    #[error("`{unit}` is not a unit of this quantity (column {column}): use {allowed}")]
    NotAUnit {
        /// Unit as it was written.
        unit: String,
        /// Column of the unit.
        column: usize,
        /// Accepted units.
        allowed: String,
    },
    /// Only one end of a range has a unit.
    #[error("`{bare}` has no unit and `{other}` has one: write {cure}")]
    UnitAtOneEnd {
        /// End without a unit.
        bare: String,
        /// End with a unit.
        other: String,
        /// How to write the range.
        cure: String,
    },
}

impl From<UnitError> for String {
    fn from(error: UnitError) -> Self {
        error.to_string()
    }
}
