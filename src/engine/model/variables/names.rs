//! Names of variables: lookup, setting by name, long names in user notation, and hints for unknown names.

use super::error::VariableError;
use super::table::{VARIABLES, Variable};
use crate::model::scene::Scene;

/// Most frequently used symbols of the thesis.
const DEFAULT: &str = "m_p R v_i theta h rho S_y C_d gamma d b m k n";

impl Variable {
    /// Returns the long name: `velocity`, `thickness`, `stop_position`. Accepted as an alternative to the symbol.
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

/// Finds the variable with this symbol, alias, full key or long name. The error names the nearest variables.
pub fn find(name: &str) -> Result<&'static Variable, VariableError> {
    let exact = VARIABLES.iter().find(|variable| {
        variable.symbol == name || variable.key == name || variable.aliases.contains(&name)
    });
    let spelled = name.to_lowercase().replace([' ', '-'], "_");
    exact
        .or_else(|| VARIABLES.iter().find(|variable| variable.name() == spelled))
        .ok_or_else(|| VariableError::Unknown { name: name.to_owned(), cure: nearest(name) })
}

/// Returns a hint with the variables nearest to `name`, else the most frequently used.
pub fn nearest(name: &str) -> String {
    did_you_mean(name)
        .unwrap_or_else(|| format!("the usual ones are {DEFAULT}; `cmra explain` lists all"))
}

/// Returns a hint with the variables nearest to `name`: by symbol, synonym and field before spelling. `None` if none is close.
pub fn did_you_mean(name: &str) -> Option<String> {
    let lower = name.to_lowercase();
    let meant = VARIABLES.iter().filter(|it| is_meant(it, &lower)).map(|it| (0, it.symbol));
    let distance = |candidate: &str| strsim::osa_distance(&lower, &candidate.to_lowercase());
    let names: Vec<String> = VARIABLES.iter().map(Variable::name).collect();
    let spelled = VARIABLES.iter().zip(&names).flat_map(|(it, own)| {
        let by_key = distance(it.key).min(distance(field(it)) + 1);
        // A word of the screen, such as `damping` for b, leads to the symbol.
        let words = it.label.split(' ').chain([it.label]).filter(|word| word.len() > 3);
        let by_label = words.map(|word| distance(word) + 1).min().unwrap_or(usize::MAX);
        let by_symbol = distance(it.symbol).min(by_label);
        let own_names = std::iter::once(own.as_str()).chain(it.aliases.iter().copied());
        own_names.map(|own| (distance(own), own)).chain([(by_symbol, it.symbol), (by_key, it.key)])
    });
    // A scene file has keys only.
    let is_key = name.contains('.');
    let spelled = spelled.filter(|(_, name)| !is_key || name.contains('.'));
    let spelled: Vec<(usize, &str)> = spelled.collect();
    close("", name, meant.collect()).or_else(|| close("", name, spelled))
}

/// Returns the last part of the key.
fn field(variable: &Variable) -> &'static str {
    variable.key.rsplit('.').next().unwrap_or(variable.key)
}

/// Returns `true` if a symbol begins with the name (`v` for `v_i`), or if a synonym or the field of the key contains it as a word.
fn is_meant(variable: &Variable, lower: &str) -> bool {
    let mut synonyms = variable.aliases.iter().copied().chain([field(variable)]);
    variable.symbol.to_lowercase().split('_').next() == Some(lower)
        || synonyms.any(|synonym| synonym.split(['_', '-']).any(|word| word == lower))
}

/// Formats `did you mean ...?` with the nearest of the candidates, given with their distances, after the word for their kind; `None` if
/// none is close. Equally near candidates keep their order.
pub fn close(what: &str, name: &str, mut candidates: Vec<(usize, &str)>) -> Option<String> {
    const SHOWN_MAX: usize = 4;
    let limit = (name.chars().count() / 3).max(1);
    candidates.sort_by_key(|(distance, _)| *distance);
    let mut seen = std::collections::BTreeSet::new();
    candidates.retain(|(_, candidate)| seen.insert(*candidate));
    let close = candidates.iter().take_while(|(distance, _)| *distance <= limit).take(SHOWN_MAX);
    let close: Vec<String> = close.map(|(_, candidate)| format!("`{candidate}`")).collect();
    (!close.is_empty()).then(|| format!("did you mean {what}{}?", close.join(" or ")))
}

/// Sets a variable by name from text, as `--set NAME=VALUE` does; the scene is unchanged on error.
pub fn set_by_name(scene: &mut Scene, name: &str, text: &str) -> Result<(), VariableError> {
    let variable = find(name.trim())?;
    let value = variable.parse(scene, text, variable.bare(name.trim()))?;
    variable.set(scene, value)
}

/// Returns a scene with changed variables, in the format of `--set`: `k=1e5 n=0.5`.
pub fn changed(mut scene: Scene, changes: &str) -> Result<Scene, VariableError> {
    for change in changes.split_whitespace() {
        let (name, value) = change.split_once('=').unwrap_or((change, ""));
        set_by_name(&mut scene, name, value)?;
    }
    Ok(scene)
}

/// Applies [`changed`] to the scene of Table 9.1 with gamma = 1 and without spring and damper.
pub fn changed_free_plate(changes: &str) -> Result<Scene, VariableError> {
    changed(Scene::default(), &format!("k=0 {changes}"))
}

/// Returns the default scene with changes such as `k=1e6 n=0.5`, in SI units.
#[cfg(test)]
pub(in crate::model) fn scene_with(pairs: &str) -> Scene {
    changed(Scene::default(), pairs).expect("values the variables take")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_names_are_variables_and_an_unknown_one_gets_their_list() {
        assert!(DEFAULT.split(' ').all(|name| find(name).is_ok()));
        let hint = nearest("quux");
        assert!(hint.contains(DEFAULT) && hint.len() < 120, "{hint}");
        assert!(nearest("gama").contains("`gamma`"));
    }

    #[test]
    fn what_is_meant_goes_before_what_is_spelled_alike() {
        for (name, meant) in
            [("v", "`v_i`"), ("m_P", "`m_p`"), ("ratio", "`gamma`"), ("Velocity", "`v_i`")]
        {
            let hint = nearest(name);
            assert!(hint.starts_with(&format!("did you mean {meant}")), "{name}: {hint}");
        }
    }

    /// Misspelled names, including long names and those of the screen.
    #[test]
    fn a_misspelled_name_leads_to_its_variable() {
        for (name, symbol) in [
            ("stifness", "k"),
            ("thicknes", "h"),
            ("velocty", "v_i"),
            ("dampng", "b"),
            ("cockng", "d"),
            ("densty", "rho"),
            ("mas_ratio", "gamma"),
            ("flow_strengt", "S_y"),
            ("stop_postion", "x_stop"),
            ("projectile.velocity_ms", "v_i"),
        ] {
            let hint = nearest(name);
            let mut offered = hint.split('`').skip(1).step_by(2);
            assert!(
                offered.any(|it| find(it).is_ok_and(|it| it.symbol == symbol)),
                "{name}: {hint}"
            );
        }
        // Every name is found without its middle letter.
        for variable in VARIABLES.iter().filter(|it| it.name().len() > 5) {
            let mut misspelled = variable.name();
            misspelled.remove(misspelled.len() / 2);
            let hint = nearest(&misspelled);
            let mut offered = hint.split('`').skip(1).step_by(2);
            let is_there = find(&misspelled).is_ok()
                || offered.any(|it| find(it).is_ok_and(|it| it.key == variable.key));
            assert!(is_there, "{misspelled} of {}: {hint}", variable.symbol);
        }
    }

    /// A duplicate name would always lead to the first variable.
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
            // Previous name of the variable.
            ("energy_j", "e_spring"),
        ] {
            assert_eq!(find(name).map(|found| found.symbol), Ok(symbol), "{name}");
        }
    }
}
