//! Whether a mechanism is worth it, for machines: a row a candidate, or one JSON object. SI.

use serde_json::{Map, Value, json};

use crate::files::rows::{Rows, number};
use crate::study::worth::{Candidate, FIGURES, Report};

/// One row a candidate.
pub fn rows(name: &str, report: &Report) -> Rows {
    let columns = ["scene", "candidate", "outcome"].into_iter();
    let row = |entry: &crate::study::worth::Entry| {
        let words =
            [name, entry.candidate.word(), entry.outcome.word()].into_iter().map(Value::from);
        words.chain(FIGURES.iter().map(|figure| number((figure.get)(entry)))).collect()
    };
    Rows {
        columns: columns.chain(FIGURES.iter().map(|figure| figure.name)).collect(),
        rows: report.entries.iter().map(row).collect(),
    }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let candidates = Candidate::ALL.into_iter().map(|candidate| {
        let entry = report.of(candidate).map_or(Value::Null, |entry| {
            let mut figures = Map::new();
            figures.insert("outcome".to_owned(), Value::from(entry.outcome.word()));
            let absence = entry.limit.absence().map_or(Value::Null, Value::from);
            figures.insert("no_limit".to_owned(), absence);
            for figure in FIGURES {
                figures.insert(figure.name.to_owned(), number((figure.get)(entry)));
            }
            Value::Object(figures)
        });
        (candidate.word().replace(' ', "_"), entry)
    });
    let object = json!({
        "scene": name,
        "face_m2": number(Some(report.face_m2)),
        "spring_energy_j": number(report.spring_energy_j),
        "spring_mass_kg": number(report.spring_kg),
        "mount_mass_kg": number(Some(report.mount_kg)),
        "penetration_over_solid": number(report.depth_over_solid()),
        "caution": report.caution().map_or(Value::Null, Value::from),
        "candidates": candidates.collect::<Map<_, _>>(),
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}
