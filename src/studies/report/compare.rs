//! Report of the comparison at equal areal mass: a table with one row for each candidate, an object, a map, and sentences shared by the
//! command line and the workbench. SI.

use serde_json::{Map as Object, Value, json};

use crate::report::chart::levels::Levels;
use crate::report::figures::map_over;
use crate::report::map::{self, Cell, MapMark, Tone};
use crate::report::run::lower_bounds;
use crate::report::table::{Cells, Table, listed};
use crate::report::verdict::{self, expected_columns};
use crate::study::compare::map::Map;
use crate::study::compare::{
    Absence, Candidate, ComparisonReport, Entry, Hardware, SizedArmour, THINNEST_M, Verdict,
    is_equal, is_spring_sized_by_shot,
};
use crate::study::envelope;
use crate::study::library;
use crate::study::limit::RANGE_M_S;
use crate::study::quantities::{EXPECTED, Quantity, find};
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::{ContactModel, PlateSize, Scene};
use cmra_engine::model::units::{fixed_significant, significant, velocity};

pub mod page;

/// Footnote to the mark of a plate without mount, spring, damper and stop.
pub const UNHELD: &str =
    "* nothing stops plate and projectile: not an alternative, only the effect of the mass ratio";

/// Name and meaning of the contour on a map.
const LINE: (&str, &str) = ("line of 1", ": above 1 the armour is lighter than the solid plate");
/// Label of the limit of plate and spring together, and of the results of the shot just below it.
const SURVIVES: &str = "if spring holds";
const AT_SURVIVAL: &str = "  if spring holds";
const DISPLACEMENT: &str = "max_plate_displacement_m";
/// Keys of the lines of a page.
const LINES: [&str; 23] = [
    "candidate",
    "mass_efficiency",
    "limit_velocity_m_s",
    EXPECTED[0],
    EXPECTED[1],
    EXPECTED[2],
    "limit_if_spring_survives_m_s",
    "outcome",
    "verdict",
    "areal_mass_kg_m2",
    "areal_mass_if_spring_survives_kg_m2",
    "stroke_m",
    "stroke_if_spring_survives_m",
    "stored_energy_j",
    "stored_energy_if_spring_survives_j",
    "peak_mount_force_n",
    "peak_mount_force_if_spring_survives_n",
    "mount_impulse_n_s",
    "preload_energy_j",
    DISPLACEMENT,
    "thickness_m",
    "residual_velocity_m_s",
    "penetration_m",
];

/// Marks a text about a plate that nothing holds; [`UNHELD`] says what the mark means.
pub(crate) fn marked(text: &str, is_held: bool) -> String {
    text.to_owned() + if is_held { "" } else { "*" }
}

/// Returns the table of the candidates.
pub fn table<'c>(name: &'c str, report: &'c ComparisonReport) -> Table<'c, &'c Entry> {
    let beyond = |it: &&Entry, _: &Value| it.is_beyond().then(|| format!("beyond {}", RANGE_M_S.1));
    let own = |name| move |it: &&Entry| find(name)?.value(&it.run);
    let label = |name| find(name).map_or_else(String::new, Quantity::heading);
    let preload_j = |it: &&Entry| {
        (!Mechanism::from_scene(&it.run.scene).is_absent())
            .then_some(it.run.ledger.initial_spring_j)
    };
    let at_limit = |name| move |it: &&Entry| find(name)?.value(it.at_limit.as_ref()?);
    let table = Table::new(&report.entries)
        .field("scene", move |_| name)
        .with("candidate", "", "", |it| it.candidate.word())
        .with("outcome", "at the design velocity", "", |it| it.run.shot_outcome().word())
        .shown(|it, word| Some(marked(word.as_str()?, it.is_held)))
        .with("verdict", "verdict", "", |it| it.shot.decision.word())
        .field("governed_by", |it| governed_by(it))
        .with("mass_efficiency", "mass efficiency", "", |it| it.mass_efficiency())
        .shown(|it, value| {
            let value = value.as_f64().filter(|_| !it.is_held)?;
            Some(fixed_significant(value, 4) + "*")
        })
        .field("sized_thickness_m", |it| Some(it.sized.as_ref().ok()?.scene.target.thickness_m))
        .field("sized_areal_mass_kg_m2", |it| Some(it.sized.as_ref().ok()?.areal_kg_m2))
        .field("solid_areal_mass_kg_m2", |it| Some(it.sized.as_ref().ok()?.solid_areal_kg_m2))
        .with("areal_mass_kg_m2", "areal mass", "kg/m^2", own("areal_mass_kg_m2"))
        .with(
            "areal_mass_if_spring_survives_kg_m2",
            AT_SURVIVAL,
            "kg/m^2",
            at_limit("areal_mass_kg_m2"),
        )
        .field("counted_spring_mass_kg", |it| it.spring_kg)
        .with("limit_velocity_m_s", "ballistic limit", "m/s", |it| it.perforation.velocity_m_s())
        .shown(beyond)
        .with("limit_if_spring_survives_m_s", SURVIVES, "m/s", |it| it.limit_m_s)
        .shown(beyond)
        .with("stroke_m", label("stroke_m"), "m", own("stroke_m"))
        .with("stored_energy_j", label("stored_energy_j"), "J", own("stored_energy_j"))
        .with("peak_mount_force_n", label("peak_mount_force_n"), "N", own("peak_mount_force_n"))
        .with("mount_impulse_n_s", label("mount_impulse_n_s"), "N s", own("mount_impulse_n_s"))
        .with("preload_energy_j", "preloaded energy", "J", preload_j)
        .with("stroke_if_spring_survives_m", AT_SURVIVAL, "m", at_limit("stroke_m"))
        .with("stored_energy_if_spring_survives_j", AT_SURVIVAL, "J", at_limit("stored_energy_j"))
        .with(
            "peak_mount_force_if_spring_survives_n",
            AT_SURVIVAL,
            "N",
            at_limit("peak_mount_force_n"),
        )
        .with(DISPLACEMENT, label(DISPLACEMENT), "m", own(DISPLACEMENT))
        .with("thickness_m", "thickness", "m", |it| it.run.scene.target.thickness_m)
        .with(
            "residual_velocity_m_s",
            label("residual_velocity_m_s"),
            "m/s",
            own("residual_velocity_m_s"),
        )
        .with("penetration_m", "depth", "m", |it| it.depth_m());
    expected_columns(table, |it| it.shot.expected.as_ref())
}

/// Returns the candidates side by side, a column each, with a line for each quantity.
fn beside(report: &ComparisonReport) -> Vec<Cells> {
    let has_class = report.entries.iter().any(|entry| entry.shot.expected.is_some());
    let lines: Vec<&str> =
        LINES.into_iter().filter(|key| has_class || !EXPECTED.contains(key)).collect();
    table("", report).turned(&lines)
}

fn governed_by(entry: &Entry) -> &'static str {
    match (entry.failure, entry.limit_m_s) {
        (Some(failure), _) => failure.word,
        (None, Some(_)) => "perforation",
        (None, None) => "",
    }
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, report: &ComparisonReport) -> Value {
    let table = table(name, report);
    let candidates = Candidate::ALL.into_iter().map(|candidate| {
        let entry = report.entry(candidate).map_or(Value::Null, |entry| {
            let mut object = table.object(&entry, |key| !["scene", "candidate"].contains(&key));
            object.extend([
                ("held".to_owned(), entry.is_held.into()),
                ("no_limit".to_owned(), entry.no_limit().into()),
                (
                    "no_mass_efficiency".to_owned(),
                    entry.sized.as_ref().err().map(Absence::words).into(),
                ),
            ]);
            Value::Object(object)
        });
        (candidate.word().replace(' ', "_"), entry)
    });
    let own = report.entry(Candidate::Scene);
    let mut object = json!({
        "scene": name,
        "interface": report.scene.interface.law.word(),
        "design_velocity_m_s": report.scene.projectile.velocity_m_s,
        "conclusion": report.verdict().message(),
        "pays": report.verdict().pays(),
        "mass_efficiency": own.filter(|it| it.is_held).and_then(Entry::mass_efficiency),
        "mass_not_counted": report.uncounted,
        "face_m2": report.face_m2,
        "spring_energy_j_per_kg": report.scene.mechanism.specific_energy_j_kg(),
        "spring_energy_j": own.and_then(|own| own.run.mechanism.stored_j),
        "counted_spring_mass_kg": own.and_then(|own| own.spring_kg),
        "criterion": report.scene.target.criterion.word(),
        "spring_is_sized": report.hardware == Hardware::Sized,
        "penetration_over_solid": report.depth_over_solid(),
        "caution": report.caution(),
        "candidates": candidates.collect::<Object<_, _>>(),
    });
    for (key, value) in own.iter().flat_map(|own| verdict::object(&own.shot)) {
        object[key] = value;
    }
    object
}

/// Returns the table of the computed points of a map; the second variable varies fastest.
pub fn map_table<'c>(name: &'c str, map: &'c Map) -> Table<'c, (u64, u64)> {
    let (x, y) = (map.x(), map.y());
    let points = (0..x.count()).flat_map(|at| (0..y.count()).map(move |up| (at, up)));
    let cell = |at: &(u64, u64)| map.cell(at.0, at.1);
    Table::new(points.filter(|at| cell(at).is_some()))
        .field("scene", move |_| name)
        .field(x.symbol(), |at| x.value(at.0))
        .field(y.symbol(), |at| y.value(at.1))
        .field("mass_efficiency", move |at| cell(at)?.ok())
        .field("no_mass_efficiency", move |at| Some(cell(at)?.err()?.words()))
        .field("warnings", move |at| {
            let breaches = envelope::of_scene(&map.placed(at.0, at.1));
            let of_entries = library::warnings(map.scene());
            listed(&breaches.iter().map(Warning::from).chain(of_entries).collect::<Vec<Warning>>())
        })
}

/// Returns the picture of the map; `None` if no point has a mass efficiency.
pub fn picture(found: &Map) -> Option<map::Map<'static>> {
    let cell = |x: usize, y: usize| match found.shown(x as u64, y as u64) {
        Some(Ok(value)) => Cell::Value(value),
        Some(Err(absence)) => Cell::Mark(absence.letter, Tone::Faint),
        None => Cell::Empty,
    };
    let absences = found.cells.iter().filter_map(|cell| (*cell)?.err());
    let mark = |it: Absence| MapMark { more: it.more, ..MapMark::new(it.letter, it.label) };
    let mut marks: Vec<MapMark> = absences.map(mark).collect();
    marks.sort();
    marks.dedup();
    let levels = Levels::from_values(found.cells.iter().filter_map(|cell| (*cell)?.ok()))?;
    let bounds = (1..levels.bands()).map(|band| levels.band(band).0).filter(|it| !is_equal(*it));
    let labels = std::iter::once(1.0).chain(bounds);
    let labels = labels.map(|bound| (bound, significant(bound, 3))).collect();
    Some(map::Map {
        contour: Some((1.0, MapMark { more: LINE.1, ..MapMark::new('O', LINE.0) })),
        labels,
        marks,
        ..map_over("mass efficiency", found.x(), found.y(), Some(levels), cell)
    })
}

/// Describes where the mechanism pays at the scene's value of the second variable: the ranges of the first variable with a mass efficiency
/// above 1, else the maximum of the map; `None` if too few points are computed. A point without a mass efficiency, or not computed yet, may
/// hide where it pays.
pub fn where_it_pays(map: &Map, scene: &Scene) -> Option<String> {
    let (x, y) = (map.x(), map.y());
    let (row, points) = map.row(y.nearest(y.own_value(scene)?));
    let points: Vec<(f64, f64)> = points.into_iter().map(|(at, it)| (x.value(at), it)).collect();
    let [(first, _), .., (last, _)] = points[..] else { return None };
    let ranges = above_one(&points);
    let is_open = |cell: Result<f64, Absence>| cell.is_err_and(|absence| !absence.rules_out());
    let is_row_open = (0..x.count()).any(|x| map.cell(x, row).is_some_and(is_open));
    let about = if map.is_complete() { "" } else { "about " };
    let at = format!("at {} {}", y.symbol(), y.show(y.value(row), 3));
    let show = |value: f64| x.show(value, 3);
    let range = |&(from, to): &(f64, f64)| match (from <= first, to >= last) {
        (true, true) => format!("at all {} of the map", x.symbol()),
        (true, false) => format!("below {about}{}", show(to)),
        (false, true) => format!("above {about}{}", show(from)),
        (false, false) => format!("from {about}{} to {}", show(from), show(to)),
    };
    if !ranges.is_empty() {
        let ranges: Vec<String> = ranges.iter().map(range).collect();
        let open = if is_row_open { ", not known whether elsewhere" } else { "" };
        return Some(format!("it pays {} {at}{open}", ranges.join(" and ")));
    }
    let place = |(x_at, y_at): (u64, u64)| {
        let [(a, a_at), (b, b_at)] = [(x, x_at), (y, y_at)];
        let [one, other] = [(a, a_at), (b, b_at)]
            .map(|(axis, at)| format!("{} {}", axis.symbol(), axis.show(axis.value(at), 3)));
        format!("{one}, {other}")
    };
    let all = (0..x.count()).flat_map(|x| (0..y.count()).map(move |y| (x, y)));
    let known = all.filter_map(|at| Some((at, map.cell(at.0, at.1)?.ok()?)));
    let (best, most) = known.max_by(|one, other| one.1.total_cmp(&other.1))?;
    let (best, most) = (place(best), fixed_significant(most, 3));
    let is_above = most.parse().is_ok_and(|most: f64| most > 1.0);
    let is_part_open =
        if is_above { is_row_open } else { map.cells.iter().flatten().any(|cell| is_open(*cell)) };
    Some(match (is_above, is_part_open || !map.is_complete()) {
        (true, false) => format!("it does not pay {at}; most on the map: {most} at {best}"),
        (true, true) => {
            format!("not known whether it pays {at}; most on the map: {most} at {best}")
        }
        (false, false) => format!("it pays nowhere on the map; most: {most} at {best}"),
        (false, true) => format!("not known whether it pays on the map; most: {most} at {best}"),
    })
}

/// Returns the ranges in which a curve through these points exceeds 1, interpolated over ln `x`.
fn above_one(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut ranges: Vec<(f64, f64)> = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    let mut is_inside = false;
    for &(x, it) in points {
        let is_above = it > 1.0;
        if is_above != is_inside {
            let edge = match before {
                Some((x_0, it_0)) if it.is_finite() && it_0.is_finite() => {
                    let part = (1.0 - it_0) / (it - it_0);
                    if x_0 > 0.0 { x_0 * (x / x_0).powf(part) } else { x_0 + (x - x_0) * part }
                }
                Some((x_0, _)) if is_inside => x_0,
                _ => x,
            };
            match ranges.last_mut().filter(|_| is_inside) {
                Some(range) => range.1 = edge,
                None => ranges.push((edge, f64::INFINITY)),
            }
            is_inside = is_above;
        }
        before = Some((x, it));
    }
    ranges
}

/// Returns whether moving pays for the scene's own shot, with the reason.
pub fn short_verdict(report: &ComparisonReport) -> (&'static str, String) {
    match report.verdict() {
        Verdict::Stops(efficiency) => {
            let answer = match efficiency {
                _ if is_equal(efficiency) => "Moving makes no difference",
                _ if efficiency > 1.0 => "Moving pays",
                _ => "Moving does not pay",
            };
            let efficiency = fixed_significant(efficiency, 4);
            (answer, format!(": mass efficiency {efficiency}{}", uncounted(report)))
        }
        Verdict::NotMet(why) => ("Moving does not pay", format!(": {why}")),
        Verdict::Unknown => ("Whether moving pays is undecided", String::new()),
    }
}

/// Describes whether the mechanism pays, and by how much.
pub fn verdict(report: &ComparisonReport) -> String {
    let design = velocity(report.scene.projectile.velocity_m_s, 4);
    let Some(own) = report.entry(Candidate::Scene) else {
        return "cancelled before the scene itself was computed".to_owned();
    };
    let verdict = report.verdict();
    let words = verdict.message();
    match verdict {
        Verdict::Stops(efficiency) => {
            let (efficiency, counted) = (fixed_significant(efficiency, 4), uncounted(report));
            format!("mass efficiency {efficiency} at {design}: {words}{counted}")
        }
        Verdict::NotMet(_) => format!("{words} ({design})"),
        Verdict::Unknown => {
            // The caution describes an open verdict.
            let why = own.sized.as_ref().err().filter(|it| !it.is_open());
            let why = why.map_or_else(String::new, |it| format!(": {}", it.words()));
            format!("{words} ({design}){why}")
        }
    }
}

/// Returns the end of a verdict that depends on parts without mass; empty for other verdicts.
fn uncounted(report: &ComparisonReport) -> String {
    if report.uncounted.is_empty() || report.verdict().pays() != Some(true) {
        return String::new();
    }
    format!(", without the mass of its {}", report.uncounted.join(" and "))
}

/// Returns the reasons for the verdict, one sentence each.
pub fn reasons(report: &ComparisonReport) -> Vec<String> {
    let Some(own) = report.entry(Candidate::Scene) else { return Vec::new() };
    let mut lines = Vec::new();
    lines.extend(sized(own, &report.verdict()));
    lines.extend(outside_validity(report));
    lines.extend(limits(report));
    if let Some(ratio) = report.depth_over_solid() {
        let percent = 100.0 * (ratio - 1.0);
        lines.push(format!("depth {percent:+.1} % against the solid plate of equal areal mass"));
    }
    if report.scene.contact.model != ContactModel::Hydrodynamic {
        lines.push("mount impulse: known of model = hydrodynamic alone".to_owned());
    }
    lines
}

/// Describes breaches of the model's validity that the scene as built does not have: of the sized armour, and of each candidate at its
/// limit.
fn outside_validity(report: &ComparisonReport) -> Vec<String> {
    let known = envelope::of_scene(&report.scene);
    let mut lines = Vec::new();
    let mut note = |who: String, scene: &Scene| {
        let new = envelope::of_scene(scene).into_iter();
        let new = new.filter(|breach| known.iter().all(|other| other.check != breach.check));
        let labels: Vec<&str> = new.map(|breach| breach.check.label()).collect();
        if !labels.is_empty() {
            lines.push(format!("{who}: outside the model's validity in {}", labels.join(", ")));
        }
    };
    for entry in &report.entries {
        if let (Candidate::Scene, Ok(sized)) = (entry.candidate, &entry.sized) {
            note("the sized armour".to_owned(), &sized.scene);
        }
        let Some(limit_m_s) = entry.limit_m_s.filter(|_| entry.is_held) else { continue };
        let mut at_limit = (*entry.run.scene).clone();
        at_limit.projectile.velocity_m_s = limit_m_s;
        let place = if entry.failure.is_some() { "where its spring fails" } else { "at its limit" };
        note(format!("{} {place}", entry.candidate.word()), &at_limit);
    }
    let own = report.entry(Candidate::Scene).and_then(|own| own.sized.as_ref().ok());
    if own.is_some_and(|sized| sized.scene.target.thickness_m < THINNEST_M) {
        let least = 1e3 * THINNEST_M;
        lines.push(format!(
            "the sized armour: thinner than {least} mm, the least thickness within the model's range"
        ));
    }
    lines
}

/// Describes the two armours that just stop the shot.
fn sized(own: &Entry, verdict: &Verdict) -> Option<String> {
    let sized: &SizedArmour = match &own.sized {
        Ok(sized) => sized,
        // The caution gives the reason.
        Err(absence) if absence.is_open() => return None,
        Err(absence) => return Some(format!("no mass efficiency: {}", absence.words())),
    };
    let density = sized.scene.target.density_kg_m3;
    let solid_m = sized.solid_areal_kg_m2 / density;
    let efficiency = match verdict {
        Verdict::Stops(_) => String::new(),
        Verdict::NotMet(_) | Verdict::Unknown => {
            format!(", mass efficiency {}", fixed_significant(sized.mass_efficiency(), 4))
        }
    };
    let given = match own.run.scene.plate.size {
        PlateSize::Face(_) => "",
        PlateSize::Ratio(_) | PlateSize::Mass(_) => " (the mass ratio is kept)",
    };
    let margin = match (sized.margin > 1.0, own.run.scene.is_sprung()) {
        (false, _) => "",
        (true, false) => "; below the band of measured limits",
        (true, true) => {
            "; both below the band of limits measured on rigid mounts, which is an assumption for a plate that moves"
        }
    };
    let scene = &sized.scene;
    let in_thousandths = [scene.target.thickness_m, scene.plate_face_m(), sized.spring_kg, solid_m];
    let [thickness, face, spring, solid] =
        in_thousandths.map(|value| fixed_significant(1e3 * value, 4));
    let [areal, solid_areal] =
        [sized.areal_kg_m2, sized.solid_areal_kg_m2].map(|value| fixed_significant(value, 4));
    Some(format!(
        "sized to just stop the shot: this armour with {thickness} mm over a face of {face} mm square{given} and {spring} g of spring, \
         {areal} kg/m^2; a solid plate of {solid} mm, {solid_areal} kg/m^2{efficiency}{margin}"
    ))
}

/// Describes for which plates the limit velocities hold, their causes, and missing limits.
fn limits(report: &ComparisonReport) -> Vec<String> {
    let mut lines = Vec::new();
    if is_spring_sized_by_shot(&report.scene) {
        lines.push(
            "scene: keeps the spring of the design shot at every velocity; `cmra limit` sizes its counted mass for each shot".to_owned(),
        );
    }
    if report.scene.plate_velocity_m_s() != 0.0 {
        lines.push(
            "w_0: of the scene alone; the other candidates are at rest before the shot".to_owned(),
        );
    }
    for entry in &report.entries {
        let word = entry.candidate.word();
        if let (Some(failure), Some(limit)) = (entry.failure, entry.limit_m_s) {
            let plate = entry.perforation.velocity_m_s().map_or_else(
                || "beyond the searched range".to_owned(),
                |plate| format!("at {}", velocity(plate, 4)),
            );
            let (limit, why) = (velocity(limit, 4), failure.words);
            let text = format!(
                "the spring survives up to {limit}, where {why}; the plate is perforated {plate}"
            );
            lines.push(format!("{word}: {text}"));
        }
        lines.extend(entry.no_limit().map(|absence| format!("{word}: {absence}")));
        if !entry.is_held {
            lines.push(format!("{word}: nothing stops plate and projectile"));
        }
        if entry.candidate == Candidate::Scene && lower_bounds(&entry.run).next().is_some() {
            lines.push(format!(
                "{word}: the run ends undecided; `cmra run` has lower bounds of what is missing"
            ));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::compare::mass_efficiency;
    use crate::study::context::{Context, never_cancel};
    use crate::study::sweep::{Axis, Spacing};
    use cmra_engine::model::variables::changed_free_plate;

    /// Without dishing the mechanism pays if and only if v² < 2 (1 + gamma) e, with e in J/kg; a steel coil has 196.8 J/kg.
    #[test]
    fn valid_the_edge_of_where_it_pays_is_the_closed_form() {
        for (gamma, edge) in [(1.0, "28.1 m/s"), (3.0, "39.7 m/s")] {
            let scene = changed_free_plate(&format!("dishing=off k=1 gamma={gamma}")).unwrap();
            let axis = |name, ends, count, spacing| Axis::new(name, ends, count, spacing).unwrap();
            let axes = [
                axis("v_i", (10.0, 90.0), 41, Spacing::Log),
                axis("gamma", (1.0, 3.0), 2, Spacing::Linear),
            ];
            let mut watch = never_cancel;
            let context = &mut Context::new(1, &mut watch);
            let map = Map::compute(&scene, &axes, Hardware::default(), context).unwrap();
            let told = format!("it pays below {edge} at gamma {gamma}");
            assert_eq!(where_it_pays(&map, &scene), Some(told));
        }
    }

    /// Between two points of the row, one of which has no mass efficiency, a shot computed by itself says that moving pays.
    #[test]
    fn what_no_point_of_a_row_decides_is_not_said_of_the_row() {
        let scene = changed_free_plate("k=1e5 d=0.0051 v_i=10.5 gamma=1").unwrap();
        let between = mass_efficiency(&scene, Hardware::default()).unwrap();
        assert!(between > 1.0, "{between}");
        let axis = |name, ends| Axis::new(name, ends, 2, Spacing::Linear).unwrap();
        let axes = [axis("v_i", (10.0, 11.0)), axis("gamma", (1.0, 3.0))];
        let mut watch = never_cancel;
        let context = &mut Context::new(1, &mut watch);
        let map = Map::compute(&scene, &axes, Hardware::default(), context).unwrap();
        let told = where_it_pays(&map, &scene).unwrap_or_default();
        assert!(!told.contains("does not pay") && !told.contains("nowhere"), "{told}");
    }

    #[test]
    fn ranges_above_one_end_where_the_curve_crosses_it() {
        let inf = f64::INFINITY;
        assert_eq!(above_one(&[(1.0, 2.0), (4.0, 0.0)]), [(1.0, 2.0)]);
        assert_eq!(above_one(&[(1.0, 0.0), (4.0, 2.0), (9.0, 2.0)]), [(2.0, inf)]);
        assert_eq!(above_one(&[(1.0, 2.0), (2.0, f64::NAN), (3.0, 2.0)]), [(1.0, 1.0), (3.0, inf)]);
        assert_eq!(above_one(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.5)]).len(), 1);
        assert!(above_one(&[(1.0, 0.5), (2.0, 0.9)]).is_empty());
    }
}
