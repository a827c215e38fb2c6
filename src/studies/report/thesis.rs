//! The reproduction report, the principles and the screening matrix as tables.

use crate::report::table::Table;
use crate::study::principles::{CONCEPTS, Concept, PRINCIPLES, Principle};
use crate::study::thesis::Row;

/// The claims.
pub fn claims(report: &[Row]) -> Table<'_, &Row> {
    Table::of(report)
        .with("id", "claim", "", |row| row.claim.id)
        .with("where", "place", "", |row| row.claim.place)
        .with("says", "says", "", |row| row.claim.says)
        .with("computed", "computed", "", |row| row.computed.clone())
        .with("as_printed", "as printed", "", |row| {
            (!row.as_printed.is_empty()).then(|| row.as_printed.clone())
        })
        .with("verdict", "verdict", "", |row| row.claim.verdict.words())
        .with("holds", "holds", "", |row| row.holds)
        .with("cause", "cause", "", |row| row.claim.cause)
        .with("preset", "preset", "", |row| row.claim.preset)
}

/// The concepts of Table 7.1 with their printed and computed totals.
pub fn concepts() -> Table<'static, Concept> {
    Table::of(CONCEPTS)
        .with("concept", "concept", "", |it| it.name)
        .with("total", "total", "", Concept::weighted)
        .with("total_printed", "printed", "", |it| it.total)
        .with("rank_printed", "rank", "", |it| it.rank)
        .with("preset", "preset", "", |it| it.preset)
}

/// The principles with their families and functions, in the order of Table 4.1.
pub fn principles() -> Table<'static, Principle> {
    Table::of(PRINCIPLES)
        .with("family", "family", "", |it| it.family)
        .with("principle", "principle", "", |it| it.name)
        .with("section", "section", "", |it| it.section)
        .with("idea", "idea", "", |it| it.idea)
        .with("functions", "functions", "", |it| it.functions.join(", "))
        .with("preset", "preset", "", |it| it.preset)
}
