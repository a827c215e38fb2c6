//! THE table of results: the name, unit and meaning of every number a run comes down to.
//!
//! JSON keys, the results row of an export and the outputs of a sweep are all taken from here, so that a name means the
//! same wherever it is met. Nothing here knows files or screens; the time a run took is measured by whoever ran it.

use crate::model::run::{AtLeast, Run};
use crate::model::units::{self, Engineering};
use crate::model::variables::edit_distance;

/// One number a run comes down to.
#[derive(Clone, Copy, Debug)]
pub struct ResultColumn {
    /// Name in JSON, CSV and `[sweep] outputs`; it ends in its unit.
    pub name: &'static str,
    /// What it means, in a few words.
    pub meaning: &'static str,
    /// Read it from a run; `None` where the quantity does not exist, never a number that is not finite.
    pub get: fn(&Run) -> Option<f64>,
}

impl PartialEq for ResultColumn {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl ResultColumn {
    /// The unit its name ends in; `%` for a percentage, empty for a pure number.
    pub fn unit(&self) -> &'static str {
        let endings =
            [("_m_s", "m/s"), ("_m", "m"), ("_s", "s"), ("_n", "N"), ("_j", "J"), ("_kg", "kg")];
        if self.name.starts_with("percent") {
            return "%";
        }
        endings.into_iter().find(|(end, _)| self.name.ends_with(end)).map_or("", |(_, unit)| unit)
    }

    /// Its name in words, without the unit: `max plate displacement`.
    pub fn title(&self) -> String {
        let ending = ["_m_s", "_m", "_s", "_n", "_j", "_kg"]
            .into_iter()
            .find(|end| self.name.ends_with(end));
        self.name.strip_suffix(ending.unwrap_or("")).unwrap_or(self.name).replace('_', " ")
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
            "kg" => format!("{} kg", units::significant(value, digits)),
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

    /// Its value for a run; `None` where it does not exist.
    pub fn value(&self, run: &Run) -> Option<f64> {
        (self.get)(run).filter(|value| value.is_finite())
    }
}

const fn column(
    name: &'static str,
    meaning: &'static str,
    get: fn(&Run) -> Option<f64>,
) -> ResultColumn {
    ResultColumn { name, meaning, get }
}

/// Every numeric result, in the order of files.
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
    column("steps", "accepted steps", |run| Some(run.cost.steps as f64)),
    column("rejected", "rejected steps", |run| Some(run.cost.rejected as f64)),
    column("rhs_evaluations", "evaluations of the equations of motion", |run| Some(run.cost.rhs_evaluations as f64)),
];

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
    "peak_contact_force_n",
    "residual_velocity_m_s",
];
/// The most names in a hint.
const NEAREST_MAX: usize = 4;
/// Columns of a line of the listing.
const WIDTH: usize = 78;

/// A hint for a name that no result has: the results spelled most like it, of these and of `further` ones that are known where it
/// was asked for; else those asked for most.
pub fn nearest(name: &str, further: &[&'static str]) -> String {
    let lower = name.trim().to_lowercase();
    let limit = (lower.chars().count() / 3).max(1);
    let names = RESULTS.iter().map(|column| column.name).chain(further.iter().copied());
    let mut ranked: Vec<(usize, &str)> = names
        .map(|candidate| (distance(&lower, candidate), candidate))
        .filter(|(distance, _)| *distance <= limit)
        .collect();
    // Of those as near as each other the ones asked for most come first.
    ranked.sort_by_key(|(distance, name)| (*distance, !USUAL.contains(name)));
    let close: Vec<String> =
        ranked.iter().take(NEAREST_MAX).map(|(_, name)| format!("`{name}`")).collect();
    if !close.is_empty() && !lower.is_empty() {
        return format!("did you mean {}?", close.join(" or "));
    }
    let usual = [&USUAL[..], further].concat().join(", ");
    format!("the usual ones are {usual}; `cmra sweep --help` lists all")
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
    let off = |part: &str| if begun(part) { 0 } else { edit_distance(name, part) };
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
        assert_eq!(nearest("stroke", &[]), "did you mean `stroke_m`?");
        assert_eq!(nearest("percnt", &[]), "did you mean `percent_of_baseline`?");
        assert_eq!(nearest("percent_of_basline", &[]), "did you mean `percent_of_baseline`?");
        assert!(nearest("penetration", &[]).starts_with("did you mean `final_penetration_m` or "));
        assert_eq!(nearest("sistem_mass", &["system_mass_kg"]), "did you mean `system_mass_kg`?");
        for strange in ["foo", "", "quux_quux"] {
            let hint = nearest(strange, &[]);
            assert!(hint.contains(&USUAL.join(", ")) && hint.len() < 200, "{strange}: {hint}");
        }
        assert!(nearest("foo", &["system_mass_kg"]).contains("system_mass_kg"));
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
