//! Measured ballistic limits: the built-in table and a user's own, the classes computed from them, and the errors of the law.
//!
//! Does not depend on files, screens or a clock.

use std::sync::LazyLock;

mod class;
mod errors;
mod table;

pub use class::{Alloy, Class, Expectation, Key, Sample, classes};
pub use errors::{Computed, Errors, Row, WITHOUT_CLASS, errors, evaluate, leave_out};
pub use table::{FindEntry, Measured, Measurement, OUTPUTS, read};

/// Built-in table of measured limits, as CSV.
const FILE: &str = include_str!("../data/limits.csv");

/// Returns the built-in table; empty if the file is invalid, which a test excludes.
pub fn built_in() -> &'static [Measurement] {
    static TABLE: LazyLock<Vec<Measurement>> = LazyLock::new(|| {
        let none: FindEntry<'_> = &|_, name| Err(format!("no entry {name}"));
        read(FILE, none).unwrap_or_default()
    });
    &TABLE
}

/// Returns the built-in table, each row with the limit expected from the measurements of all other papers.
pub fn left_out() -> &'static [Row] {
    static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| leave_out(built_in()));
    &ROWS
}

/// Returns the classes of the built-in table.
pub fn known() -> &'static [Class] {
    static KNOWN: LazyLock<Vec<Class>> = LazyLock::new(|| errors::classes_of(built_in()));
    &KNOWN
}

#[cfg(test)]
mod tests;
