//! The reproduction report, the screening matrix and the principles as tables.

use crate::report::table::Table;
use crate::study::principles::{PRINCIPLES, Principle};
use crate::study::screening::{CONCEPTS, Concept, Ranking, ranking};
use crate::study::thesis::{Opens, Row};

/// The claims.
pub fn claims(report: &[Row]) -> Table<'_, &Row> {
    let text = |text: &str| (!text.is_empty()).then(|| text.to_owned());
    Table::of(report)
        .with("id", "claim", "", |row| row.claim.id)
        .with("where", "place", "", |row| row.claim.place)
        .with("says", "says", "", |row| row.claim.says)
        .with("sound", "computed", "", move |row| text(&row.found.sound))
        .with("as_printed", "as printed", "", move |row| text(&row.found.printed))
        .with("verdict", "verdict", "", |row| row.found.verdict.words())
        .with("cause", "cause", "", |row| row.claim.cause)
        .with("preset", "preset", "", |row| match row.claim.opens() {
            Opens::Preset(name) => Some(name),
            Opens::Nothing | Opens::Scene(_) => None,
        })
        .with("runs", "runs", "", |row| row.runs)
        .with("basis", "basis", "", |row| row.found.basis.words())
}

/// The ranking of the concepts by weights in percent, the first one first, beside the printed one.
pub fn screening(weights: &[f64; 7]) -> Table<'static, Ranking> {
    let concept = |place: &Ranking| -> &'static Concept { &CONCEPTS[place.concept] };
    Table::of(ranking(weights))
        .with("rank", "rank", "", |place| place.rank)
        .with("concept", "concept", "", move |place| concept(place).name)
        .with("total", "total", "", |place| place.total)
        .with("rank_printed", "printed", "", move |place| concept(place).rank)
        .with("total_printed", "printed", "", move |place| concept(place).total)
        .with("section", "section", "", move |place| concept(place).section)
        .with("preset", "preset", "", move |place| concept(place).preset)
}

/// The principles with their families and functions, in the order of Table 4.1.
pub fn principles() -> Table<'static, &'static Principle> {
    Table::of(PRINCIPLES.iter())
        .with("family", "family", "", |it| it.family)
        .with("principle", "principle", "", |it| it.name)
        .with("section", "section", "", |it| it.section)
        .with("idea", "idea", "", |it| it.idea)
        .with("functions", "functions", "", |it| it.functions.join(", "))
        .with("computed", "computed", "", |it| it.computed)
        .with("preset", "preset", "", |it| it.preset)
}
