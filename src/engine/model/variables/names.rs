//! Variables found by the names people write, and the nearest names where there is none.

use super::{VARIABLES, Variable, VariableError};

/// The symbols of the thesis, which are used most.
const USUAL: &str = "m_p R v_i theta h rho S_y C_d gamma d b m k n";

/// The variable with this symbol, alias, full key or name in words; else the nearest names.
pub fn find(name: &str) -> Result<&'static Variable, VariableError> {
    let exact = VARIABLES.iter().find(|variable| {
        variable.symbol == name || variable.key == name || variable.aliases.contains(&name)
    });
    let spelled = name.to_lowercase().replace([' ', '-'], "_");
    exact
        .or_else(|| VARIABLES.iter().find(|variable| variable.name() == spelled))
        .ok_or_else(|| VariableError(format!("`{name}` is not a variable: {}", nearest(name))))
}

/// A hint that names the variables meant by `name`: by symbol, synonym and field before spelling.
pub fn nearest(name: &str) -> String {
    let lower = name.to_lowercase();
    let meant = VARIABLES.iter().filter(|it| is_meant(it, &lower)).map(|it| (0, it.symbol));
    let distance = |candidate: &str| strsim::osa_distance(&lower, &candidate.to_lowercase());
    let spelled = VARIABLES.iter().flat_map(|it| {
        let by_key = distance(it.key).min(distance(field(it)) + 1);
        [(distance(it.symbol), it.symbol), (by_key, it.key)]
    });
    close(name, meant.collect())
        .or_else(|| close(name, spelled.collect()))
        .unwrap_or_else(|| format!("the usual ones are {USUAL}; `cmra explain` lists all"))
}

/// The last part of the key.
fn field(variable: &Variable) -> &'static str {
    variable.key.rsplit('.').next().unwrap_or(variable.key)
}

/// Whether a symbol begins with a name, `v_i` with `v`, or a synonym or the field of the full key has it as a word.
fn is_meant(variable: &Variable, lower: &str) -> bool {
    let mut synonyms = variable.aliases.iter().copied().chain([field(variable)]);
    variable.symbol.to_lowercase().split('_').next() == Some(lower)
        || synonyms.any(|synonym| synonym.split(['_', '-']).any(|word| word == lower))
}

/// `did you mean ...?` with the nearest of some candidates, each with its distance from a name; `None` when none is close. Of those as
/// near as each other the first ones are named.
pub fn close(name: &str, mut candidates: Vec<(usize, &str)>) -> Option<String> {
    const SHOWN_MAX: usize = 4;
    let limit = (name.chars().count() / 3).max(1);
    candidates.sort_by_key(|(distance, _)| *distance);
    let close = candidates.iter().take_while(|(distance, _)| *distance <= limit).take(SHOWN_MAX);
    let close: Vec<String> = close.map(|(_, candidate)| format!("`{candidate}`")).collect();
    (!close.is_empty()).then(|| format!("did you mean {}?", close.join(" or ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_names_are_variables_and_an_unknown_one_gets_their_list() {
        assert!(USUAL.split(' ').all(|name| find(name).is_ok()));
        let hint = nearest("quux");
        assert!(hint.contains(USUAL) && hint.len() < 120, "{hint}");
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
}
