//! Measured ballistic limits: the built-in table and a user's own, the classes computed from them, and the errors of the law.
//!
//! Does not depend on files, screens or a clock.

use std::sync::LazyLock;

pub(in crate::study) mod class;
mod errors;
pub(in crate::study) mod known;
mod table;

pub use class::{Alloy, Class, Expectation, Key, Sample, classes};
pub use errors::{Computed, Errors, Row, WITHOUT_CLASS, errors, evaluate, leave_out};
pub use known::{built_in, known};
pub use table::{FindEntry, Measured, Measurement, OUTPUTS, read};

/// Returns the built-in table, each row with the limit expected from the measurements of all other papers.
pub fn left_out() -> &'static [Row] {
    static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| leave_out(built_in()));
    &ROWS
}

#[cfg(test)]
mod tests;
