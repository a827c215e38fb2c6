//! Quantities by name: lookup, hints for unknown names, and the list of all.

use crate::study::error::QuantityError;
use crate::study::quantities::{QUANTITIES, Quantity};
use cmra_engine::model::variables;

/// Finds the quantity with exactly this name.
pub fn find(name: &str) -> Option<&'static Quantity> {
    QUANTITIES.iter().find(|quantity| quantity.name == name)
}

/// Finds the quantity for a name with blanks or dashes, or without the unit if the quantity is unique (`stroke`, `limit velocity`).
pub fn named(name: &str) -> Result<&'static Quantity, QuantityError> {
    let written = name.trim();
    let spelled = written.to_lowercase().replace([' ', '-'], "_");
    let bare = || {
        let mut same = QUANTITIES.iter().filter(|it| it.bare() == spelled);
        same.next().filter(|_| same.next().is_none())
    };
    find(written)
        .or_else(|| find(&spelled))
        .or_else(bare)
        .ok_or_else(|| QuantityError::Unknown { name: name.to_owned(), cure: nearest(name) })
}

/// Most frequently used quantities.
const DEFAULT: [&str; 6] = [
    "final_penetration_m",
    "percent_of_baseline",
    "max_plate_displacement_m",
    "stroke_m",
    "system_mass_kg",
    "limit_velocity_m_s",
];
const WIDTH: usize = 78;

/// Returns a hint for an unknown name: the quantities with the nearest name or meaning, else the most frequently used.
pub fn nearest(name: &str) -> String {
    let lower = name.trim().to_lowercase();
    let ranked = |quantity: &'static Quantity| {
        // Words such as `depth` occur only in meanings.
        let mut meaning = quantity.meaning.split(|c: char| !c.is_alphanumeric() && c != '_');
        let is_meant = lower.len() > 2 && meaning.any(|word| word == lower);
        let far =
            distance(&lower, quantity.name).min(strsim::osa_distance(&lower, quantity.bare()));
        (if is_meant { far.min(1) } else { far }, quantity.name)
    };
    // Among equally near quantities the most frequently used come first.
    let mut all: Vec<&Quantity> = QUANTITIES.iter().collect();
    all.sort_by_key(|quantity| !DEFAULT.contains(&quantity.name));
    variables::close("", &lower, all.into_iter().map(ranked).collect()).unwrap_or_else(|| {
        format!("the usual ones are {}; `cmra explain` lists all", DEFAULT.join(", "))
    })
}

/// Returns the edit distance from a name to a quantity's name, or to some consecutive words of it.
fn distance(name: &str, quantity: &str) -> usize {
    let words: Vec<&str> = quantity.split('_').collect();
    let parts = (0..words.len()).flat_map(|from| {
        let words = &words;
        (from + 1..=words.len()).map(move |to| words[from..to].join("_"))
    });
    // A single letter is a unit, and near to every word.
    let parts = parts.filter(|part| part.len() > 2);
    // Three or more letters match the beginning of a word.
    let begun = |part: &str| name.len() > 2 && part.starts_with(name);
    let off = |part: &str| if begun(part) { 0 } else { strsim::osa_distance(name, part) };
    let nearest = parts.map(|part| off(&part) + usize::from(part != quantity)).min();
    nearest.unwrap_or(usize::MAX)
}

/// Lists the names of all quantities, in lines that fit the screen.
pub fn listing() -> String {
    let names: Vec<&str> = QUANTITIES.iter().map(|quantity| quantity.name).collect();
    let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
    textwrap::fill(&names.join("  "), options) + "\n"
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::{DEFAULT, QUANTITIES, find, nearest};

    #[test]
    fn names_and_titles_are_unique_and_found() {
        let mut seen = HashSet::new();
        let [mut titles, mut brief_titles] = [(); 2].map(|()| HashSet::new());
        for quantity in QUANTITIES {
            let name = quantity.name;
            assert!(seen.insert(name), "{name} twice");
            assert!(titles.insert(quantity.title()), "title of {name} twice");
            assert!(brief_titles.insert(quantity.brief_title()), "brief title of {name} twice");
            assert!(quantity.brief_title().len() <= quantity.title().len(), "{name}");
            assert!(!quantity.meaning.is_empty());
            assert_eq!(find(quantity.name).map(|found| found.name), Some(quantity.name));
        }
        assert!(find("depth").is_none());
    }

    #[test]
    fn units_and_words_come_from_the_name() {
        let of = |name| find(name).map(|quantity| (quantity.title(), quantity.unit()));
        let expect = |title: &str, unit| Some((title.to_owned(), unit));
        assert_eq!(of("percent_of_baseline"), expect("% of rigid-mount depth", "%"));
        assert_eq!(of("stroke_m"), expect("stroke", "m"));
        assert_eq!(of("residual_velocity_m_s"), expect("residual velocity", "m/s"));
        assert_eq!(of("steps"), expect("steps", ""));
        let percent = find("percent_of_baseline").unwrap();
        assert_eq!(percent.show(60.0, 4), "60 %");
        assert_eq!(percent.show_all_digits(60.0, 4), "60.00 %");
    }

    /// Displayed values can be parsed back, with any prefix. The workbench edits a goal in this way.
    #[test]
    fn values_read_back_as_they_are_shown() {
        for quantity in QUANTITIES {
            for exponent in -6..=7 {
                let value = 1.5 * 10f64.powi(exponent);
                let shown = quantity.show(value, 4);
                let read = quantity.parse(&shown).unwrap_or_else(|why| panic!("{shown}: {why}"));
                assert!((read / value - 1.0).abs() < 1e-12, "{}: {shown}, {read}", quantity.name);
            }
        }
        let read = |name, text| find(name).unwrap().parse(text);
        assert_eq!(read("stored_energy_j", "1kJ"), Ok(1e3));
        assert_eq!(read("mount_impulse_n_s", "12 N s"), Ok(12.0));
        assert_eq!(read("areal_mass_kg_m2", "4 g/cm2"), Ok(40.0));
        assert_eq!(read("percent_of_baseline", "60 %"), Ok(60.0));
        let wrong = read("stored_energy_j", "1kN").unwrap_err().to_string();
        assert!(wrong.contains("use J, kJ") && wrong.ends_with("or no unit for J"), "{wrong}");
    }

    #[test]
    fn an_unknown_name_gets_the_nearest_names_in_a_short_line() {
        assert!(DEFAULT.iter().all(|name| find(name).is_some()));
        assert_eq!(nearest("stroke"), "did you mean `stroke_m`?");
        assert_eq!(nearest("v_bl"), "did you mean `limit_velocity_m_s`?");
        assert_eq!(nearest("percnt"), "did you mean `percent_of_baseline`?");
        assert_eq!(nearest("percent_of_basline"), "did you mean `percent_of_baseline`?");
        assert!(nearest("penetration").starts_with("did you mean `final_penetration_m` or "));
        assert!(nearest("depth").starts_with("did you mean `final_penetration_m` or "));
        assert_eq!(nearest("sistem_mass"), "did you mean `system_mass_kg`?");
        for strange in ["foo", "", "quux_quux"] {
            let hint = nearest(strange);
            assert!(hint.contains(&DEFAULT.join(", ")) && hint.len() < 200, "{strange}: {hint}");
        }
    }
}
