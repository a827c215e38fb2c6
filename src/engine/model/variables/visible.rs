//! Visibility and use of variables, and their description in words.

use super::names::changed;
use super::row::{Group, Value};
use super::table::{VARIABLES, Variable};
use crate::model::scene::{PlateSize, Scene};

/// Returns `true` if a variable has an effect on this scene.
pub fn is_used(variable: &Variable, scene: &Scene) -> bool {
    let Variable { when, used, part: [is_there, acts], .. } = variable;
    is_there(scene) && acts(scene) && when(scene) && used(scene)
}

/// Returns `true` if a scene uses a variable for some values of the variables that vary.
pub fn can_be_used(variable: &Variable, scene: &Scene, varied: &[&Variable]) -> bool {
    let mut scenes = vec![scene.clone()];
    // Rules ask whether a number is there, is zero, or is above or below another one. The first value that is allowed counts.
    for values in [&[0.0][..], &[1e-6, 1.0], &[1e6, 2.0, 1.0]] {
        let mut far = scene.clone();
        for it in varied {
            let mut values = values.iter().map(|value| Value::Number(*value));
            let _is_set = values.any(|value| it.set(&mut far, value).is_ok());
        }
        scenes.push(far);
    }
    for it in varied {
        let with = |word| {
            let of = move |scene: &Scene| {
                let mut scene = scene.clone();
                it.set(&mut scene, Value::Word(word)).ok().map(|()| scene)
            };
            scenes.iter().filter_map(of)
        };
        let more: Vec<Scene> = it.keys().iter().copied().flat_map(with).collect();
        scenes.extend(more);
    }
    scenes.iter().any(|scene| is_used(variable, scene))
}

/// Returns `true` if lists show the variable.
pub fn is_listed(variable: &Variable, scene: &Scene) -> bool {
    (variable.part[0])(scene) && (variable.when)(scene) && (variable.listed)(scene)
}

/// Returns `true` if the variable is one of the inputs that define the plate's size. The last one set is used.
pub fn sizes_plate(variable: &Variable) -> bool {
    PlateSize::KEYS.contains(&variable.key)
}

/// Returns `true` if the variable also determines a mass or an area that the motion of the plate may not need.
pub fn gives_mass(variable: &Variable) -> bool {
    sizes_plate(variable) || matches!(variable.key, "target.thickness_m" | "target.density_kg_m3")
}

/// Returns `true` if two variables cannot be chosen independently.
pub fn exclude_each_other(one: &Variable, other: &Variable) -> bool {
    one.key == other.key || (sizes_plate(one) && sizes_plate(other))
}

/// Returns `true` if the variable would replace the scene's own input for the plate's size. An axis over it would override that input
/// silently.
pub fn overrules_size(variable: &Variable, scene: &Scene) -> bool {
    let own = scene.plate.size.key();
    sizes_plate(variable) && own != PlateSize::KEYS[0] && own != variable.key
}

/// Returns `true` if the workbench's lists offer the variable: listed variables and those of the plate's size, except the values of a
/// missing stop or of another kind of stop. Files keep these values for a later stop.
pub fn is_offered(variable: &Variable, scene: &Scene) -> bool {
    let places_stop = variable.key == "mechanism.stop.position_m";
    let of_stop = variable.group == Group::Stop && !places_stop;
    let is_there = is_listed(variable, scene) || (scene.is_sprung() && sizes_plate(variable));
    is_there && (!of_stop || is_used(variable, scene))
}

/// Changes that make variables take effect or lose it: description and `--set` text.
const CHANGES: [(&str, &str); 10] = [
    ("b > 0", "b=1"),
    ("theta > 0", "theta=30deg"),
    ("m_p below that of the nose sphere", "m_p=1g"),
    ("x_stop given", "x_stop=0.01"),
    ("e_spring = auto", "e_spring=auto"),
    ("e_spring given", "e_spring=2e4"),
    ("a base plate or more elements", "h_base=0.01"),
    ("m_2 given", "m_2=0.1"),
    ("face given", "face=0.1"),
    ("weight = on", "weight=on"),
];

/// Returns the scenes that differ in the keyword of one choice, each with its description.
fn choices(base: &Scene) -> Vec<(String, Scene)> {
    let mut list = Vec::new();
    for variable in VARIABLES.iter().filter(|variable| is_used(variable, base)) {
        let own = variable.value(base);
        for word in variable.keys().iter().filter(|word| Value::Word(word) != own) {
            let mut scene = base.clone();
            if variable.set(&mut scene, Value::Word(word)).is_ok() {
                list.push((format!("{} = {word}", variable.symbol), scene));
            }
        }
    }
    list
}

/// Returns `true` if a scene uses a variable once it has a value.
fn acts(variable: &Variable, scene: &Scene) -> bool {
    let mut scene = scene.clone();
    if let (Some(number), Value::Absent) = (variable.number(), variable.value(&scene)) {
        (number.set)(&mut scene, Some(1.0));
    }
    is_used(variable, &scene) && is_listed(variable, &scene)
}

/// Describes the scenes that use a variable that this scene does not. Found with [`is_used`] by one or two changes of the scene.
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
    use crate::model::variables::{find, scene_with};

    /// The depth is the travel times h/(h + 2 R) for every force. A stop and a spring's neutral position are equally far from the start at
    /// -d.
    #[test]
    fn what_a_scene_uses() {
        for (scene, name, used) in [
            ("model=half-sine t_d=1e-4", "h", true),
            ("model=half-sine t_d=1e-4", "dishing", true),
            ("model=half-sine t_d=1e-4", "S_y", false),
            ("model=lumped k_load=1e7", "h", true),
            ("model=lumped k_load=1e7", "rho", false),
            ("model=lumped k_load=1e7 face=0.1", "rho", true),
            ("model=initial-velocity", "h", false),
            ("closure=double-yield", "S_y", false),
            ("", "Y", false),
            ("", "tau_wire", true),
            ("spring=helix", "tau_wire", true),
            ("e_spring=1000", "tau_wire", false),
            ("spring=prbm-cantilever", "tau_wire", false),
            ("k=0", "tau_wire", false),
            ("combine=parallel", "k_2", true),
            ("combine=parallel k_2=0", "n_2", false),
            ("", "k_2", false),
            ("", "g", true),
            ("mount=rigid", "g", false),
            ("k=0", "d", true),
            ("mount=rigid", "d", false),
            ("k=0 x_stop=0.01", "d", true),
        ] {
            assert_eq!(is_used(find(name).unwrap(), &scene_with(scene)), used, "{scene}: {name}");
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
            (
                "Y",
                "where closure = double-yield or closure = cavity or closure = cylindrical or closure = by-thickness",
            ),
            ("rho_p", "where theta > 0 or m_p below that of the nose sphere"),
        ] {
            assert_eq!(when(name), words, "{name}");
        }
        assert!(when("l_beam").contains("spring = "), "{}", when("l_beam"));
        let rigid = scene_with("face=0.1 mount=rigid");
        assert_eq!(used_where(of("face"), &rigid).as_deref(), Some("where mount = sprung"));
    }
}
