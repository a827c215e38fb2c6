//! The reproduction report, the principles and the screening matrix as tables.

use crate::report::table::Table;
use crate::study::principles::{CONCEPTS, Concept, PRINCIPLES, Principle};
use crate::study::thesis::Row;

/// The claims.
pub fn claims(report: &[Row]) -> Table<'_, &Row> {
    Table::new(report)
        .field("id", |row| row.claim.id)
        .field("where", |row| row.claim.place)
        .field("says", |row| row.claim.says)
        .field("computed", |row| row.computed.clone())
        .field("as_printed", |row| (!row.as_printed.is_empty()).then(|| row.as_printed.clone()))
        .field("verdict", |row| row.claim.verdict.words())
        .field("holds", |row| row.holds)
        .field("cause", |row| row.claim.cause)
        .field("preset", |row| row.claim.preset)
}

/// The concepts of Table 7.1 with their printed and computed totals.
pub fn concepts() -> Table<'static, Concept> {
    Table::new(CONCEPTS)
        .field("concept", |it| it.name)
        .field("functions", |it| it.functions.join(", "))
        .field("total", Concept::weighted)
        .field("total_printed", |it| it.total)
        .field("rank_printed", |it| it.rank)
        .field("preset", |it| it.preset)
}

/// The principles with their families and functions, in the order of Table 4.1.
pub fn principles() -> Table<'static, Principle> {
    Table::new(PRINCIPLES)
        .field("family", |it| it.family)
        .field("principle", |it| it.name)
        .field("section", |it| it.section)
        .field("idea", |it| it.idea)
        .field("functions", |it| it.functions.join(", "))
        .field("preset", |it| it.preset)
}
