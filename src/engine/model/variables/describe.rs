//! Descriptions of variables: the name in words, and when a scene uses it. Both are read off the table and its rules.

use super::{VARIABLES, Value, Variable, changed, is_listed, is_used};
use crate::model::scene::Scene;

impl Variable {
    /// Its name in words: `velocity`, `thickness`, `stop_position`. Accepted wherever the symbol is.
    pub fn name(&self) -> String {
        if !self.own_name.is_empty() {
            return self.own_name.to_owned();
        }
        let key: Vec<&str> = self.key.split('.').skip(1).collect();
        let name = key.join("_");
        let end = format!("_{}", self.unit().to_lowercase().replace(['/', ' '], "_"));
        name.strip_suffix(&end).unwrap_or(&name).to_owned()
    }
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

/// The scenes that have another word of one choice, each with that in words.
fn choices(base: &Scene) -> Vec<(String, Scene)> {
    let mut list = Vec::new();
    for variable in VARIABLES.iter().filter(|variable| is_used(variable, base)) {
        let own = variable.value(base);
        for word in variable.words().iter().filter(|word| Value::Word(word) != own) {
            let mut scene = base.clone();
            if variable.set(&mut scene, Value::Word(word)).is_ok() {
                list.push((format!("{} = {word}", variable.symbol), scene));
            }
        }
    }
    list
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

/// Where scenes use a variable that this one does not, in words: read off [`is_used`] by changing the scene in one place, or in two.
pub fn used_where(variable: &Variable, scene: &Scene) -> Option<String> {
    if acts(variable, scene) {
        return None;
    }
    let acting = |scenes: &[(String, Scene)]| -> Vec<String> {
        let acting = scenes.iter().filter(|(_, scene)| acts(variable, scene));
        acting.map(|(text, _)| text.clone()).collect()
    };
    let given = CHANGES.iter().filter_map(|(text, change)| {
        Some(((*text).to_owned(), changed(scene.clone(), change).ok()?))
    });
    let scenes: Vec<(String, Scene)> = given.chain(choices(scene)).collect();
    let single = acting(&scenes);
    if !single.is_empty() {
        return Some(format!("where {}", single.join(" or ")));
    }
    let mut pairs = scenes.into_iter().map(|(first, scene)| (first, acting(&choices(&scene))));
    let found = pairs.find(|(_, double)| !double.is_empty());
    Some(found.map_or_else(
        || "in few scenes: see its meaning".to_owned(),
        |(first, double)| format!("where {first} and {}", double.join(" or ")),
    ))
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
        let when = |name: &str| used_where(of(name), &Scene::default()).unwrap_or_default();
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
        assert_eq!(used_where(of("face"), &rigid).as_deref(), Some("where mount = sprung"));
    }
}
