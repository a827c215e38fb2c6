//! The reproduction report, the principles and the screening matrix as tables.

use crate::report::page::{Block, Page};
use crate::report::table::Table;
use crate::study::principles::{CONCEPTS, Concept, PRINCIPLES, Principle};
use crate::study::thesis::{ClaimVerdict, Row, tally};

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

/// Returns the report of the claims; `missing` names the omitted part of an interrupted study.
pub fn page(report: &[Row], missing: Option<String>) -> Page {
    let mut page = Page::default();
    for row in report {
        let claim = row.claim;
        let place = format!("{}  [{}]", claim.place, claim.verdict.words());
        page.push(Block::Ends(place, claim.id.to_owned()));
        page.entries([
            ("says", claim.says),
            ("computed", &row.computed),
            ("as printed", &row.as_printed),
            ("cause", claim.cause),
        ]);
        page.space();
    }
    let counts = ClaimVerdict::ALL.iter().zip(tally(report));
    let counts: Vec<String> =
        counts.map(|(verdict, count)| format!("{count} {}", verdict.words())).collect();
    let whole = || format!("{} rows: {}.", report.len(), counts.join(", "));
    page.line(missing.unwrap_or_else(whole));
    page
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
