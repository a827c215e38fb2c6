//! THE table of quantities: the name, unit, meaning and source of every number that a scene comes down to.
//!
//! JSON keys, the rows of exports, the outputs of sweeps, and what searches, Monte Carlo and sensitivity analysis ask for are all
//! taken from here, so that a name means the same everywhere. What a quantity needs decides what it costs: nothing is computed
//! for a quantity that is not requested. Nothing here knows files or screens; the time a run took is measured by whoever ran it.

use crate::model::mechanism::load;
use crate::model::run::{AtLeast, EventKind, Run, envelope};
use crate::model::scene::{InterfaceLaw, Mount, Scene, StopKind};
use crate::model::units::{self, Engineering};

/// One quantity.
#[derive(Clone, Copy, Debug)]
pub struct ResultColumn {
    /// Name in JSON, CSV and `[sweep] outputs`; it ends in its unit.
    pub name: &'static str,
    /// What it means, in a few words.
    pub meaning: &'static str,
    /// Where it comes from; `None` where the quantity does not exist, never a number that is not finite.
    pub source: Source,
}

/// Where a quantity comes from.
#[derive(Clone, Copy, Debug)]
pub enum Source {
    /// From the scene alone.
    Scene(fn(&Scene) -> Option<f64>),
    /// From a run.
    Run(fn(&Run) -> Option<f64>),
    /// From a study of the scene or of its run.
    Study(Studied),
}

/// What a study finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Studied {
    /// The least mass of a steel coil for the greatest energy stored.
    LeastSpringMass,
    /// Plate and springs.
    SystemMass,
    /// Plate and springs over the plate's face.
    ArealMass,
    /// The greatest force into the mount.
    MountForce,
    /// The impulse into the mount.
    MountImpulse,
    /// The ballistic limit.
    LimitVelocity,
    /// Areal mass of the solid plate that does the same, over the scene's.
    MassEfficiency,
}

/// What has to be computed for a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Needs {
    /// Nothing.
    Scene,
    /// A run.
    Run,
    /// A run with its course in time.
    Course,
    /// Many shots.
    Limit,
}

impl Needs {
    /// In words, for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::Scene => "nothing but the scene",
            Self::Run => "a run",
            Self::Course => "a run and its course in time",
            Self::Limit => "many shots (a limit search)",
        }
    }
}

impl PartialEq for ResultColumn {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl ResultColumn {
    /// The unit its name ends in; `%` for a percentage, empty for a pure number.
    pub fn unit(&self) -> &'static str {
        if self.name.starts_with("percent") {
            return "%";
        }
        self.ending().map_or("", |(_, unit)| unit)
    }

    /// Its name in words, without the unit: `max plate displacement`.
    pub fn title(&self) -> String {
        let ending = self.ending().map_or("", |(end, _)| end);
        self.name.strip_suffix(ending).unwrap_or(self.name).replace('_', " ")
    }

    fn ending(&self) -> Option<(&'static str, &'static str)> {
        ENDINGS.into_iter().find(|(end, _)| self.name.ends_with(end))
    }

    /// What has to be computed for it.
    pub fn needs(&self) -> Needs {
        match self.source {
            Source::Scene(_) => Needs::Scene,
            Source::Run(_) => Needs::Run,
            Source::Study(studied) => match studied {
                Studied::LeastSpringMass | Studied::SystemMass | Studied::ArealMass => Needs::Run,
                Studied::MountForce | Studied::MountImpulse => Needs::Course,
                Studied::LimitVelocity | Studied::MassEfficiency => Needs::Limit,
            },
        }
    }

    /// A value with its unit, in so many digits: `64.27 %`, `37.98 mm`, `61.2 g`.
    pub fn show(&self, value: f64, digits: usize) -> String {
        match self.unit() {
            "" => units::significant(value, digits),
            "%" => format!("{} %", units::significant(value, digits)),
            // A prefix stands before grams, not before kilograms.
            "kg" if value.abs() < 1e3 => {
                Engineering { value: 1e3 * value, unit: "g", digits }.to_string()
            }
            unit @ ("kg" | "kg/m2") => format!("{} {unit}", units::significant(value, digits)),
            unit => Engineering { value, unit, digits }.to_string(),
        }
    }

    /// What it is at least, where a run ended before it was final; `None` where it is final, or nothing is known.
    pub fn lower_bound(&self, run: &Run) -> Option<f64> {
        let AtLeast { penetration_m, plate_displacement_m } = run.at_least;
        let bound = match self.name {
            "final_penetration_m" => penetration_m,
            "percent_of_baseline" => Some(100.0 * (penetration_m? / run.baseline_penetration_m?)),
            "max_plate_displacement_m" => plate_displacement_m,
            "stroke_m" => Some(plate_displacement_m? - run.start_m()),
            _ => None,
        };
        bound.filter(|bound| bound.is_finite())
    }

    /// Its value for a run; `None` where it does not exist, or where a study has to find it.
    pub fn value(&self, run: &Run) -> Option<f64> {
        let value = match self.source {
            Source::Scene(get) => get(&run.scene),
            Source::Run(get) => get(run),
            Source::Study(_) => None,
        };
        value.filter(|value| value.is_finite())
    }

    /// Whether it is a number that a run comes down to: limit searches are made on request alone.
    pub fn is_of_run(&self) -> bool {
        self.needs() < Needs::Limit
    }
}

/// How names end, and the units that means; a longer ending stands before its own end.
const ENDINGS: [(&str, &str); 8] = [
    ("_kg_m2", "kg/m2"),
    ("_m_s", "m/s"),
    ("_n_s", "N s"),
    ("_m", "m"),
    ("_s", "s"),
    ("_n", "N"),
    ("_j", "J"),
    ("_kg", "kg"),
];

const fn column(
    name: &'static str,
    meaning: &'static str,
    get: fn(&Run) -> Option<f64>,
) -> ResultColumn {
    ResultColumn { name, meaning, source: Source::Run(get) }
}

const fn of_scene(
    name: &'static str,
    meaning: &'static str,
    get: fn(&Scene) -> Option<f64>,
) -> ResultColumn {
    ResultColumn { name, meaning, source: Source::Scene(get) }
}

const fn studied(name: &'static str, meaning: &'static str, studied: Studied) -> ResultColumn {
    ResultColumn { name, meaning, source: Source::Study(studied) }
}

/// Every quantity, in the order of files.
#[rustfmt::skip]
pub static RESULTS: &[ResultColumn] = &[
    column("first_arrest_penetration_m", "depth when projectile and plate first reach common velocity", |run| Some(run.first_arrest?.penetration_m)),
    column("first_arrest_time_s", "time of the first arrest", |run| Some(run.first_arrest?.t_s)),
    column("first_arrest_plate_displacement_m", "plate displacement at the first arrest", |run| Some(run.first_arrest?.plate_displacement_m)),
    column("first_arrest_plate_velocity_m_s", "common velocity at the first arrest", |run| Some(run.first_arrest?.plate_velocity_m_s)),
    column("final_penetration_m", "depth of the hole at the end", |run| run.final_penetration_m),
    column("percent_of_baseline", "final depth over that of the same plate on a rigid mount, percent", Run::percent_of_baseline),
    column("baseline_penetration_m", "depth of the same shot into the same plate on a rigid mount", |run| run.baseline_penetration_m),
    column("peak_contact_force_n", "greatest contact force while penetrating", |run| run.peak_contact_force_n),
    column("max_plate_displacement_m", "greatest plate displacement", |run| run.max_plate_displacement_m),
    column("stroke_m", "greatest displacement plus cocking distance: the space the mechanism needs", Run::stroke_m),
    column("residual_velocity_m_s", "projectile velocity after perforation", |run| run.residual_velocity_m_s),
    column("exit_time_s", "when the nose was clear of the rear face", |run| run.exit_time_s),
    column("separation_time_s", "when the projectile left through the entry face", |run| Some(run.separation?.0)),
    column("separation_velocity_m_s", "projectile velocity when it left through the entry face", |run| Some(run.separation?.1)),
    column("interface_demand_ratio", "greatest push the fused interface had to carry over its strength A S_y", |run| run.interface_demand_ratio),
    column("energy_residual", "energy that does not add up, relative to that at the start", |run| Some(run.ledger.residual())),
    column("error_estimate", "relative error estimate of the final depth", |run| Some(run.error_estimate?.relative)),
    column("stored_energy_j", "greatest energy stored in the springs", |run| run.mechanism.stored_j),
    column("yield_margin", "yield strength over the greatest bending stress of the mechanism's beams", |run| run.mechanism.yield_margin),
    column("added_inertia_kg", "what the mechanism adds to the plate's mass: rotation, and the springs' own", |run| run.mechanism.added_kg),
    column("spring_mass_kg", "the springs' own mass", |run| run.mechanism.spring_mass_kg),
    column("rotational_energy_j", "greatest energy of the plate's rotation", |run| run.mechanism.rotation_j),
    column("stack_penetration_m", "thickness perforated in a stack, and the depth in what stopped the shot", |run| run.stack.as_ref()?.penetration_m),
    column("stack_plates_perforated", "plates of a stack that were perforated, the base plate included", |run| Some(run.stack.as_ref()?.passed() as f64)),
    column("stack_residual_velocity_m_s", "projectile velocity behind a perforated base plate", |run| run.stack.as_ref()?.residual_velocity_m_s),
    studied("peak_mount_force_n", "greatest force into the mount: spring, damper and elastic stop", Studied::MountForce),
    studied("mount_impulse_n_s", "impulse into the mount along the plate's normal, up to the greatest displacement", Studied::MountImpulse),
    column("travel_margin", "how far a spring may go before its law ends or it yields, over how far it goes", travel_margin),
    column("fused_stop_hits", "hits on a rigid stop under a fused interface, which cannot carry them", fused_stop_hits),
    of_scene("plate_mass_kg", "mass of the plate: gamma times that of the projectile", |scene| Some(scene.plate_mass_kg())),
    studied("least_spring_mass_kg", "least mass of a helical steel spring for the greatest energy stored", Studied::LeastSpringMass),
    studied("system_mass_kg", "plate and springs: their own mass where it is known, else the least of a steel spring", Studied::SystemMass),
    studied("areal_mass_kg_m2", "plate and springs over the plate's face", Studied::ArealMass),
    of_scene("plate_face_m", "side of the plate's square face: the plate is a block of its material", |scene| sprung(scene).then(|| scene.plate_face_m())),
    of_scene("face_over_diameter", "side of the plate's face over the projectile's diameter: 3 or more for the model to hold", envelope::face_ratio),
    of_scene("thickness_over_diameter", "plate thickness over projectile diameter, h/D", |scene| Some(envelope::thickness_ratio(scene))),
    of_scene("nose_pressure_ratio", "pressure on the nose at impact, S + c v^2, over 2 GPa of hardened steel: below 0.5 it stays rigid", |scene| Some(envelope::nose_pressure_ratio(scene))),
    studied("limit_velocity_m_s", "ballistic limit: the least impact velocity that perforates", Studied::LimitVelocity),
    studied("mass_efficiency", "areal mass of the solid plate that does the same, over the scene's own", Studied::MassEfficiency),
    column("steps", "accepted steps", |run| Some(run.cost.steps as f64)),
    column("rejected", "rejected steps", |run| Some(run.cost.rejected as f64)),
    column("rhs_evaluations", "evaluations of the equations of motion", |run| Some(run.cost.rhs_evaluations as f64)),
];

fn sprung(scene: &Scene) -> bool {
    scene.plate.mount == Mount::Sprung
}

/// The least of limit over displacement, of every spring and limit; `None` where no spring has a limit that a run comes near.
fn travel_margin(run: &Run) -> Option<f64> {
    let farthest = run.max_plate_displacement_m.filter(|_| sprung(&run.scene))?;
    load::travel_margin(&run.scene, run.start_m(), farthest)
}

fn fused_stop_hits(run: &Run) -> Option<f64> {
    let scene = &run.scene;
    let stopped = sprung(scene)
        && scene.interface.law == InterfaceLaw::Fused
        && scene.mechanism.stop.position_m.is_some()
        && scene.mechanism.stop.kind == StopKind::Rigid;
    let hits = || run.events.iter().filter(|event| event.kind == EventKind::StopHit).count();
    stopped.then(|| hits() as f64)
}

/// Every quantity that a run without its course in time comes down to: what a sweep gives where nothing is named.
pub fn of_every_run() -> impl Iterator<Item = &'static ResultColumn> {
    RESULTS.iter().filter(|column| column.needs() <= Needs::Run)
}

/// Every quantity a run with its course comes down to.
pub fn of_run() -> impl Iterator<Item = &'static ResultColumn> {
    RESULTS.iter().filter(|column| column.is_of_run())
}

/// The result with this name, if there is one.
pub fn find(name: &str) -> Option<&'static ResultColumn> {
    RESULTS.iter().find(|column| column.name == name)
}

/// The results asked for most.
const USUAL: [&str; 6] = [
    "final_penetration_m",
    "percent_of_baseline",
    "max_plate_displacement_m",
    "stroke_m",
    "system_mass_kg",
    "limit_velocity_m_s",
];
/// The most names in a hint.
const NEAREST_MAX: usize = 4;
/// Columns of a line of the listing.
const WIDTH: usize = 78;

/// A hint for a name that no quantity has: the quantities spelled most like it, else those asked for most.
pub fn nearest(name: &str) -> String {
    let lower = name.trim().to_lowercase();
    let limit = (lower.chars().count() / 3).max(1);
    let mut ranked: Vec<(usize, &str)> = RESULTS
        .iter()
        .map(|column| (distance(&lower, column.name), column.name))
        .filter(|(distance, _)| *distance <= limit)
        .collect();
    // Of those as near as each other the ones asked for most come first.
    ranked.sort_by_key(|(distance, name)| (*distance, !USUAL.contains(name)));
    let close: Vec<String> =
        ranked.iter().take(NEAREST_MAX).map(|(_, name)| format!("`{name}`")).collect();
    if !close.is_empty() && !lower.is_empty() {
        return format!("did you mean {}?", close.join(" or "));
    }
    let usual = USUAL.join(", ");
    format!("the usual ones are {usual}; `cmra explain quantities` lists all")
}

/// How far a name is from a result's, or from some words of it that stand together.
fn distance(name: &str, result: &str) -> usize {
    let words: Vec<&str> = result.split('_').collect();
    let parts = (0..words.len()).flat_map(|from| {
        let words = &words;
        (from + 1..=words.len()).map(move |to| words[from..to].join("_"))
    });
    // A single letter is a unit's, and near to everything.
    let parts = parts.filter(|part| part.len() > 2);
    // Whoever types three letters or more of the beginning of a word means that word.
    let begun = |part: &str| name.len() > 2 && part.starts_with(name);
    let off = |part: &str| if begun(part) { 0 } else { strsim::osa_distance(name, part) };
    let nearest = parts.map(|part| off(&part) + usize::from(part != result)).min();
    nearest.unwrap_or(usize::MAX)
}

/// The names of all results in lines that fit a screen, for people.
pub fn listing() -> String {
    let mut text = String::new();
    let mut line = String::new();
    for column in RESULTS {
        if line.len() + 2 + column.name.len() > WIDTH {
            text = text + &line + "\n";
            line.clear();
        }
        line = line + "  " + column.name;
    }
    text + &line + "\n"
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::{RESULTS, USUAL, WIDTH, find, listing, nearest};

    #[test]
    fn names_are_unique_and_found() {
        let mut seen = HashSet::new();
        for column in RESULTS {
            assert!(seen.insert(column.name), "{} twice", column.name);
            assert!(!column.meaning.is_empty());
            assert_eq!(find(column.name).map(|found| found.name), Some(column.name));
        }
        assert!(find("depth").is_none());
    }

    #[test]
    fn units_and_words_come_from_the_name() {
        let of = |name| find(name).map(|column| (column.title(), column.unit()));
        let expect = |title: &str, unit| Some((title.to_owned(), unit));
        assert_eq!(of("percent_of_baseline"), expect("percent of baseline", "%"));
        assert_eq!(of("stroke_m"), expect("stroke", "m"));
        assert_eq!(of("residual_velocity_m_s"), expect("residual velocity", "m/s"));
        assert_eq!(of("steps"), expect("steps", ""));
    }

    #[test]
    fn a_name_that_no_result_has_is_told_the_nearest_ones_in_a_line_that_can_be_read() {
        assert!(USUAL.iter().all(|name| find(name).is_some()));
        assert_eq!(nearest("stroke"), "did you mean `stroke_m`?");
        assert_eq!(nearest("percnt"), "did you mean `percent_of_baseline`?");
        assert_eq!(nearest("percent_of_basline"), "did you mean `percent_of_baseline`?");
        assert!(nearest("penetration").starts_with("did you mean `final_penetration_m` or "));
        assert_eq!(nearest("sistem_mass"), "did you mean `system_mass_kg`?");
        for strange in ["foo", "", "quux_quux"] {
            let hint = nearest(strange);
            assert!(hint.contains(&USUAL.join(", ")) && hint.len() < 200, "{strange}: {hint}");
        }
    }

    #[test]
    fn the_listing_has_every_result_once_in_lines_that_fit() {
        let listing = listing();
        assert!(listing.lines().all(|line| line.chars().count() <= WIDTH), "{listing}");
        let listed: Vec<&str> = listing.split_whitespace().collect();
        let all: Vec<&str> = RESULTS.iter().map(|column| column.name).collect();
        assert_eq!(listed, all);
    }
}
