//! The comparison at equal areal mass, for machines: a row a candidate, or one JSON object; and its map. SI.

use serde_json::{Map as Object, Value, json};

use crate::files::rows::{Rows, number};
use crate::study::compare::map::Map;
use crate::study::compare::{Candidate, Entry, FIGURES, Report};

/// One row a candidate.
pub fn rows(name: &str, report: &Report) -> Rows {
    let columns = ["scene", "candidate", "outcome", "governed_by"].into_iter();
    let row = |entry: &Entry| {
        let words = [name, entry.candidate.word(), entry.outcome.word(), governed_by(entry)];
        let words = words.into_iter().map(Value::from);
        words.chain(FIGURES.iter().map(|figure| number((figure.get)(entry)))).collect()
    };
    Rows {
        columns: columns.chain(FIGURES.iter().map(|figure| figure.name)).collect(),
        rows: report.entries.iter().map(row).collect(),
    }
}

/// What the limit velocity is governed by.
fn governed_by(entry: &Entry) -> &'static str {
    match (entry.failure, entry.limit_m_s) {
        (Some(failure), _) => failure.word(),
        (None, Some(_)) => "perforation",
        (None, None) => "",
    }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> String {
    let candidates = Candidate::ALL.into_iter().map(|candidate| {
        let entry = report.of(candidate).map_or(Value::Null, |entry| {
            let mut figures = Object::new();
            let text = |text: Option<String>| text.map_or(Value::Null, Value::from);
            figures.insert("outcome".to_owned(), Value::from(entry.outcome.word()));
            figures.insert("held".to_owned(), Value::from(entry.is_held));
            figures.insert("governed_by".to_owned(), Value::from(governed_by(entry)));
            figures.insert("no_limit".to_owned(), text(entry.no_limit()));
            let absent = entry.sized.as_ref().err().map(|absence| absence.words());
            figures.insert("no_mass_efficiency".to_owned(), text(absent));
            for figure in FIGURES {
                figures.insert(figure.name.to_owned(), number((figure.get)(entry)));
            }
            Value::Object(figures)
        });
        (candidate.word().replace(' ', "_"), entry)
    });
    let closed = report.closed_form().map(|closed| {
        json!({
            "mass_efficiency": number(Some(closed.mass_efficiency)),
            "needed_j_per_kg": number(Some(closed.needed_j_per_kg)),
            "pays_below_m_s": number(Some(closed.pays_below_m_s)),
        })
    });
    let hardware = &report.hardware;
    let own = report.of(Candidate::Scene);
    let object = json!({
        "scene": name,
        "design_velocity_m_s": number(Some(report.scene.projectile.velocity_m_s)),
        "verdict": report.verdict().words(),
        "pays": report.verdict().pays(),
        "mass_efficiency": number(own.and_then(Entry::mass_efficiency)),
        "closed_form": closed.unwrap_or(Value::Null),
        "face_m2": number(Some(report.face_m2)),
        "spring_energy_j_per_kg": number(Some(report.scene.mechanism.specific_energy_j_kg())),
        "spring_energy_j": number(own.and_then(|own| own.load.stored_j)),
        "spring_mass_kg": number(own.and_then(|own| own.spring_kg)),
        "mount_mass_kg": number(Some(hardware.mount_kg)),
        "stroke_available_m": number(hardware.stroke_m),
        "penetration_over_solid": number(report.depth_over_solid()),
        "caution": report.caution().map_or(Value::Null, Value::from),
        "candidates": candidates.collect::<Object<_, _>>(),
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

/// One row a point of the map, the second variable running fastest.
pub fn map_rows(name: &str, map: &Map) -> Rows {
    let (x, y) = (map.x(), map.y());
    let points = (0..x.count()).flat_map(|at| (0..y.count()).map(move |up| (at, up)));
    let row = |(at, up): (u64, u64)| {
        let cell = map.cell(at, up)?;
        Some(vec![
            Value::from(name),
            number(Some(x.value(at))),
            number(Some(y.value(up))),
            number(cell.ok()),
            cell.err().map_or(Value::Null, |absence| Value::from(absence.words())),
        ])
    };
    Rows {
        columns: vec!["scene", x.symbol(), y.symbol(), "mass_efficiency", "no_mass_efficiency"],
        rows: points.filter_map(row).collect(),
    }
}
