//! The rows of the table of variables, in the order of the editor: one file a subject.

use super::Variable;
use crate::model::scene::{Combination, Scene};

/// A required number at a path of the scene.
macro_rules! number {
    ($quantity:ident, $allowed:expr, $thesis:expr, $step:ident, $($field:ident).+) => {
        Kind::Number(Number {
            quantity: Quantity::$quantity,
            allowed: $allowed,
            thesis_range: $thesis,
            step: Step::$step,
            absent: None,
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value.unwrap_or_default(),
        })
    };
}

/// A required number on which the plate's mass ratio may depend.
macro_rules! sizing {
    ($quantity:ident, $($field:ident).+) => {
        Kind::Number(Number {
            quantity: Quantity::$quantity,
            allowed: Allowed::Positive,
            thesis_range: None,
            step: Step::Linear,
            absent: None,
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| {
                scene.$($field).+ = value.unwrap_or_default();
                scene.follow_size();
            },
        })
    };
}

/// An optional number at a path of the scene, with the word for its absence.
macro_rules! optional {
    ($quantity:ident, $allowed:expr, $absent:literal, $($field:ident).+) => {
        Kind::Number(Number {
            quantity: Quantity::$quantity,
            allowed: $allowed,
            thesis_range: None,
            step: Step::Linear,
            absent: Some($absent),
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = value,
        })
    };
}

mod bodies;
mod contact;
mod mechanism;
mod spring;

const TABLE_9_1: &str = "thesis Table 9.1";
const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";

/// The tables one after the other; N is how many rows they have together.
const fn joined<const N: usize>(tables: &[&[Variable]]) -> [Variable; N] {
    let mut rows = [bodies::ROWS[0]; N];
    let (mut table, mut at) = (0, 0);
    while table < tables.len() {
        let mut row = 0;
        while row < tables[table].len() {
            rows[at] = tables[table][row];
            at += 1;
            row += 1;
        }
        table += 1;
    }
    assert!(at == N, "every row has its place");
    rows
}

const TABLES: &[&[Variable]] = &[
    bodies::ROWS,
    mechanism::DAMPER,
    spring::FIRST,
    mechanism::COMBINATION,
    spring::SECOND,
    mechanism::STOP,
    mechanism::STACK,
    contact::ROWS,
];

const COUNT: usize = {
    let (mut count, mut table) = (0, 0);
    while table < TABLES.len() {
        count += TABLES[table].len();
        table += 1;
    }
    count
};

static ROWS: [Variable; COUNT] = joined(TABLES);

/// The rows whose values a run of this scene may read: a plain spring has no need of the rest.
pub(super) fn checked(scene: &Scene) -> impl Iterator<Item = &'static Variable> {
    let alone = scene.mechanism.combination == Combination::Alone;
    let first = if scene.mechanism.is_plain() { spring::PLAIN } else { spring::FIRST.len() };
    let second = if alone { 0 } else { spring::SECOND.len() };
    let before = bodies::ROWS.iter().chain(mechanism::DAMPER).chain(&spring::FIRST[..first]);
    before
        .chain(&spring::SECOND[..second])
        .chain(mechanism::STOP)
        .chain(mechanism::STACK)
        .chain(contact::ROWS)
}

/// Every variable there is.
pub static VARIABLES: &[Variable] = &ROWS;

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::VARIABLES;

    #[test]
    fn names_are_unique() {
        let mut seen = HashSet::new();
        for variable in VARIABLES {
            for name in [variable.symbol, variable.key].iter().chain(variable.aliases) {
                assert!(seen.insert(*name), "{name} twice");
            }
        }
    }
}
