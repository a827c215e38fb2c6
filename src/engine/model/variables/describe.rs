//! Descriptions of variables: the name in words, and when a scene uses it. Both are read off the table and its rules.

use super::{VARIABLES, Value, Variable, changed, is_listed, is_used};
use crate::model::scene::Scene;

/// How keys end in their units, the longer before its own end.
const UNITS: [&str; 13] = [
    "_kg_m3", "_kg_m2", "_n_s_m", "_rad_m", "_j_kg", "_n_m", "_m_s", "_deg", "_kg", "_pa", "_m",
    "_s", "_n",
];

impl Variable {
    /// Its name in words: `velocity`, `thickness`, `stop_position`. Accepted wherever the symbol is.
    pub fn name(&self) -> String {
        if !self.own_name.is_empty() {
            return self.own_name.to_owned();
        }
        let parts: Vec<&str> = self.key.split('.').skip(1).collect();
        let name = parts.join("_");
        let unit = UNITS.iter().find(|unit| name.ends_with(**unit));
        let stem = unit.and_then(|unit| name.strip_suffix(unit)).filter(|stem| !stem.is_empty());
        stem.unwrap_or(&name).to_owned()
    }
}

/// The variable with this name in words, with blanks, `-` or `_` between them.
pub(super) fn named(name: &str) -> Option<&'static Variable> {
    let spelled = name.to_lowercase().replace([' ', '-'], "_");
    VARIABLES.iter().find(|variable| variable.name() == spelled)
}

/// Changes that bring variables into use or out of it, in words and as they are set.
const CHANGES: [(&str, &str); 9] = [
    ("b > 0", "b=1"),
    ("theta > 0", "theta=30deg"),
    ("m_p below that of the nose sphere", "m_p=1g"),
    ("x_stop given", "x_stop=0.01"),
    ("e_spring = auto", "e_spring=auto"),
    ("e_spring given", "e_spring=2e4"),
    ("a base plate or more elements", "h_base=0.01"),
    ("m_2 given", "m_2=0.1"),
    ("face given", "face=0.1"),
];

/// Each other word of each choice, in words and as it is set.
fn choices(base: &Scene) -> Vec<(String, String)> {
    let mut list = Vec::new();
    for variable in VARIABLES.iter().filter(|variable| is_used(variable, base)) {
        let (symbol, own) = (variable.symbol, variable.show(base));
        let others = variable.words().iter().filter(|word| **word != own);
        list.extend(others.map(|word| (format!("{symbol} = {word}"), format!("{symbol}={word}"))));
    }
    list
}

/// A scene with each of some changes in turn, and the words for it.
fn scenes(base: &Scene, changes: Vec<(String, String)>) -> impl Iterator<Item = (String, Scene)> {
    let with =
        |(text, change): (String, String)| Some((text, changed(base.clone(), &change).ok()?));
    changes.into_iter().filter_map(with)
}

/// Whether a scene uses a variable once it has a value.
fn acts(variable: &Variable, scene: &Scene) -> bool {
    let mut scene = scene.clone();
    if let Some(number) = variable.number()
        && variable.value(&scene) == Value::Absent
    {
        (number.set)(&mut scene, Some(1.0));
    }
    is_used(variable, &scene) && is_listed(variable, &scene)
}

/// Where scenes use a variable that the usual one does not, in words: read off [`is_used`] by changing that scene in one place, or in
/// two.
pub fn used_when(variable: &Variable) -> Option<String> {
    let usual = Scene::default();
    (!acts(variable, &usual)).then(|| used_where(variable, &usual))
}

/// The changes of a scene that does not use a variable which bring it into use: one, or two together.
pub fn used_where(variable: &Variable, scene: &Scene) -> String {
    let acting = |base: &Scene, changes: Vec<(String, String)>| -> Vec<String> {
        let scenes = scenes(base, changes).filter(|(_, scene)| acts(variable, scene));
        scenes.map(|(text, _)| text).collect()
    };
    let owned = |(text, change): (&str, &str)| (text.to_owned(), change.to_owned());
    let changes: Vec<(String, String)> =
        CHANGES.into_iter().map(owned).chain(choices(scene)).collect();
    let single = acting(scene, changes.clone());
    if !single.is_empty() {
        return format!("where {}", single.join(" or "));
    }
    let mut pairs =
        scenes(scene, changes).map(|(first, base)| (first, acting(&base, choices(&base))));
    pairs.find(|(_, double)| !double.is_empty()).map_or_else(
        || "in few scenes: see its meaning".to_owned(),
        |(first, double)| format!("where {first} and {}", double.join(" or ")),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::find;

    /// A name that two variables had would lead to the first.
    #[test]
    fn each_name_leads_to_its_variable_and_ends_in_no_unit() {
        const UNITS: [&str; 11] = ["kg", "j", "m", "m2", "m3", "s", "n", "pa", "deg", "rad", "hz"];
        for variable in VARIABLES.iter() {
            let name = variable.name();
            let names = [variable.symbol, variable.key, &name];
            for name in names.iter().chain(variable.aliases) {
                assert_eq!(find(name).map(|found| found.key), Ok(variable.key), "{name}");
            }
            let last = name.rsplit('_').next().unwrap_or_default();
            assert!(!UNITS.contains(&last), "{name}: {}", variable.key);
        }
        for (name, symbol) in [
            ("velocity", "v_i"),
            ("thickness", "h"),
            ("stiffness", "k"),
            ("obliquity", "theta"),
            ("density", "rho"),
            ("mass_ratio", "gamma"),
            ("stop_position", "x_stop"),
            // The name it had before.
            ("energy_j", "e_spring"),
        ] {
            assert_eq!(find(name).map(|found| found.symbol), Ok(symbol), "{name}");
        }
    }

    #[test]
    fn use_is_described_in_words() {
        let of = |name: &str| find(name).unwrap();
        let when = |name: &str| used_when(of(name)).unwrap_or_default();
        for (name, words) in [
            ("v_i", ""),
            ("m", "where b > 0"),
            ("k_stop", "where x_stop given and stop_kind = elastic"),
            ("k_2", "where combine = parallel"),
            ("Y", "where closure = double-yield or closure = cavity or closure = by-thickness"),
            ("rho_p", "where theta > 0 or m_p below that of the nose sphere"),
        ] {
            assert_eq!(when(name), words, "{name}");
        }
        assert!(when("l_beam").contains("spring = "), "{}", when("l_beam"));
        let rigid = crate::model::variables::scene_with("face=0.1 mount=rigid");
        assert_eq!(used_where(of("face"), &rigid), "where mount = sprung");
    }
}
