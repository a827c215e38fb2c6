//! The comparison at equal areal mass: one row for each candidate, the whole as an object, and its map. SI.

use serde_json::{Map as Object, Value, json};

use crate::model::library;
use crate::model::run::envelope;
use crate::model::units::fixed_significant;
use crate::report::chart::Scale;
use crate::report::chart::levels::Levels;
use crate::report::figures::map_over;
use crate::report::map::{self, Cell, Tone};
use crate::report::table::Table;
use crate::study::compare::map::Map;
use crate::study::compare::{ByClosure, Candidate, Entry, Report};
use crate::study::limit::RANGE_M_S;

/// The meaning of the contour on a map.
const LINE: &str = "line of 1: above 1 the armour is lighter than the solid plate";
/// The lines of a page, by their keys.
const LINES: [&str; 20] = [
    "candidate",
    "mass_efficiency",
    "limit_velocity_m_s",
    "outcome",
    "areal_mass_kg_m2",
    "mass_efficiency_as_built",
    "perforation_velocity_m_s",
    "equivalent_thickness_m",
    "stroke_m",
    "stroke_at_limit_m",
    "stored_energy_j",
    "stored_energy_at_limit_j",
    "peak_mount_force_n",
    "peak_mount_force_at_limit_n",
    "mount_impulse_n_s",
    "preload_energy_j",
    "max_plate_displacement_m",
    "thickness_m",
    "residual_velocity_m_s",
    "penetration_m",
];

/// The candidates with their figures.
pub fn table<'c>(name: &'c str, report: &'c Report) -> Table<'c, &'c Entry> {
    let beyond = |it: &&Entry, _: &Value| it.is_beyond().then(|| format!("beyond {}", RANGE_M_S.1));
    let has_layers = report.entries.iter().any(|it| it.scene.is_stack());
    let thickness = if has_layers { "front plate thickness" } else { "thickness" };
    Table::of(&report.entries)
        .with("scene", "scene", "", move |_| name)
        .with("candidate", "", "", |it| it.candidate.word())
        .with("outcome", "at the design velocity", "", |it| it.outcome.word())
        .shown(|it, _| Some(format!("{}{}", it.outcome.word(), if it.is_held { "" } else { "*" })))
        .with("governed_by", "governed by", "", |it| governed_by(it))
        .with("mass_efficiency", "mass efficiency", "", |it| it.mass_efficiency())
        .shown(|it, value| {
            let value = value.as_f64().filter(|_| !it.is_held);
            let value = value.map(|value| fixed_significant(value, 4));
            let text = it.by_closure().map(ByClosure::range).or(value)?;
            Some(if it.is_held { text } else { text + "*" })
        })
        .with("mass_efficiency_double_yield", "closure=double-yield", "", |it| {
            it.by_closure()?.double_yield
        })
        .with("mass_efficiency_cavity", "closure=cavity", "", |it| it.by_closure()?.cavity)
        .with("sized_thickness_m", "thickness to just stop", "m", |it| {
            Some(it.sized.as_ref().ok()?.scene.target.thickness_m)
        })
        .with("sized_areal_mass_kg_m2", "areal mass to just stop", "kg/m^2", |it| {
            Some(it.sized.as_ref().ok()?.areal_kg_m2)
        })
        .with("solid_areal_mass_kg_m2", "areal mass of the solid", "kg/m^2", |it| {
            Some(it.sized.as_ref().ok()?.solid_areal_kg_m2)
        })
        .with("mass_efficiency_as_built", "mass efficiency as built", "", |it| it.as_built)
        .with("areal_mass_kg_m2", "areal mass", "kg/m^2", |it| it.areal_kg_m2)
        .with("spring_mass_kg", "spring mass", "kg", |it| it.spring_kg)
        .with("limit_velocity_m_s", "limit with hardware", "m/s", |it| it.limit_m_s)
        .shown(beyond)
        .with("perforation_velocity_m_s", "ballistic limit", "m/s", |it| {
            it.perforation.velocity_m_s()
        })
        .shown(beyond)
        .with("equivalent_thickness_m", "solid of equal limit", "m", |it| it.equivalent_m)
        .with("stroke_m", "stroke", "m", |it| it.load.stroke_m)
        .with("stored_energy_j", "stored energy", "J", |it| it.load.stored_j)
        .with("peak_mount_force_n", "mount force", "N", |it| it.load.mount_force_n)
        .with("mount_impulse_n_s", "impulse into mount", "N s", |it| it.load.impulse_n_s)
        .with("preload_energy_j", "preloaded energy", "J", |it| it.load.preload_j)
        .with("stroke_at_limit_m", "  at the limit", "m", |it| it.limit_load.stroke_m)
        .with("stored_energy_at_limit_j", "  at the limit", "J", |it| it.limit_load.stored_j)
        .with("peak_mount_force_at_limit_n", "  at the limit", "N", |it| {
            it.limit_load.mount_force_n
        })
        .with("max_plate_displacement_m", "back-face travel", "m", |it| it.load.max_displacement_m)
        .with("thickness_m", thickness, "m", |it| it.scene.target.thickness_m)
        .with("residual_velocity_m_s", "residual velocity", "m/s", |it| it.residual_m_s)
        .with("penetration_m", "depth", "m", |it| it.depth_m)
}

/// The candidates beside each other, a figure on each line, as on a page of this width.
pub fn beside(report: &Report, width: usize) -> String {
    let mut page = table("", report).turned(&LINES, width);
    if report.entries.iter().any(|entry| !entry.is_held) {
        page.push_str(
            "* nothing stops plate and projectile: not an alternative, only the effect of the mass ratio\n",
        );
    }
    page
}

fn governed_by(entry: &Entry) -> &'static str {
    match (entry.failure, entry.limit_m_s) {
        (Some(failure), _) => failure.word(),
        (None, Some(_)) => "perforation",
        (None, None) => "",
    }
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, report: &Report) -> Value {
    let table = table(name, report);
    let candidates = Candidate::ALL.into_iter().map(|candidate| {
        let entry = report.of(candidate).map_or(Value::Null, |entry| {
            let mut object = table.object(&entry, |key| !["scene", "candidate"].contains(&key));
            object.extend([
                ("held".to_owned(), entry.is_held.into()),
                ("slower_overload_m_s".to_owned(), entry.slower.map(|slower| slower.0).into()),
                ("no_limit".to_owned(), entry.no_limit().into()),
                (
                    "no_mass_efficiency".to_owned(),
                    entry.sized.as_ref().err().map(|absence| absence.words()).into(),
                ),
            ]);
            Value::Object(object)
        });
        (candidate.word().replace(' ', "_"), entry)
    });
    let own = report.of(Candidate::Scene);
    json!({
        "scene": name,
        "interface": report.scene.interface.law.word(),
        "design_velocity_m_s": report.scene.projectile.velocity_m_s,
        "verdict": report.verdict().words(),
        "pays": report.verdict().pays(),
        "mass_efficiency": own.filter(|it| it.is_held).and_then(Entry::mass_efficiency),
        "mass_not_counted": report.uncounted,
        "spare_mass_kg": report.spare_mass_kg(),
        "closed_form": report.closed_form(),
        "face_m2": report.face_m2,
        "spring_energy_j_per_kg": report.scene.mechanism.specific_energy_j_kg(),
        "spring_energy_j": own.and_then(|own| own.load.stored_j),
        "spring_mass_kg": own.and_then(|own| own.spring_kg),
        "mount_mass_kg": report.hardware.mount_kg,
        "stroke_available_m": report.hardware.stroke_m,
        "penetration_over_solid": report.depth_over_solid(),
        "caution": report.caution(),
        "candidates": candidates.collect::<Object<_, _>>(),
    })
}

/// The points of a map that were computed, the second variable running fastest.
pub fn map_table<'c>(name: &'c str, map: &'c Map) -> Table<'c, (u64, u64)> {
    let (x, y) = (map.x(), map.y());
    let points = (0..x.count()).flat_map(|at| (0..y.count()).map(move |up| (at, up)));
    let cell = |at: &(u64, u64)| map.cell(at.0, at.1);
    Table::of(points.filter(|at| cell(at).is_some()))
        .with("scene", "scene", "", move |_| name)
        .with(x.symbol(), x.symbol(), "", |at| x.value(at.0))
        .with(y.symbol(), y.symbol(), "", |at| y.value(at.1))
        .with("mass_efficiency", "mass efficiency", "", move |at| cell(at)?.ok())
        .with("no_mass_efficiency", "why none", "", move |at| Some(cell(at)?.err()?.words()))
        .with("mass_efficiency_double_yield", "closure=double-yield", "", move |at| {
            cell(at)?.err()?.by_closure()?.double_yield
        })
        .with("mass_efficiency_cavity", "closure=cavity", "", move |at| {
            cell(at)?.err()?.by_closure()?.cavity
        })
        .with("warnings", "warnings", "", move |at| {
            let breaches = envelope::of_scene(&map.placed(at.0, at.1));
            let breaches = breaches.iter().map(ToString::to_string);
            let of_entries = library::warnings(map.scene()).map(str::to_owned);
            breaches.chain(of_entries).collect::<Vec<String>>().join("; ")
        })
}

/// The map as a picture; `None` where no point has a mass efficiency.
pub fn picture(found: &Map) -> Option<map::Map<'static>> {
    let cell = |x: usize, y: usize| match found.cell(x as u64, y as u64) {
        Some(Ok(value)) => Cell::Value(value),
        Some(Err(absence)) => Cell::Mark(absence.letter(), Tone::Faint),
        None => Cell::Empty,
    };
    let absences = found.cells.iter().filter_map(|cell| cell.err());
    let mut marks: Vec<(char, String)> =
        absences.map(|absence| (absence.letter(), absence.brief())).collect();
    marks.sort();
    marks.dedup();
    let levels = Levels::of(Scale::Linear, found.cells.iter().filter_map(|cell| cell.ok()))?;
    Some(map::Map {
        contour: Some((1.0, LINE.into())),
        marks,
        ..map_over("mass efficiency", found.x(), found.y(), Some(levels), cell)
    })
}
