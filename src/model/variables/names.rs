//! Variables found by the names people write, and the nearest names where there is none.

use super::{VARIABLES, Variable, VariableError};

/// The variable with this symbol, alias or full key.
///
/// # Errors
/// [`VariableError::Unknown`], with the nearest names.
pub fn find(name: &str) -> Result<&'static Variable, VariableError> {
    let exact = VARIABLES.iter().find(|variable| {
        variable.symbol == name || variable.key == name || variable.aliases.contains(&name)
    });
    exact.ok_or_else(|| VariableError::Unknown { name: name.to_owned(), hint: nearest(name) })
}

/// A hint that names the variables spelled most like `name`.
pub fn nearest(name: &str) -> String {
    let lower = name.to_lowercase();
    let mut ranked: Vec<(usize, &str)> = VARIABLES
        .iter()
        .flat_map(|variable| {
            let last = variable.key.rsplit('.').next().unwrap_or(variable.key);
            let distance = |candidate: &str| edit_distance(&lower, &candidate.to_lowercase());
            [
                (distance(variable.symbol), variable.symbol),
                (distance(variable.key).min(distance(last) + 1), variable.key),
            ]
        })
        .collect();
    ranked.sort_unstable();
    let limit = (name.chars().count() / 3).max(1);
    let close: Vec<String> = ranked
        .iter()
        .take_while(|(distance, _)| *distance <= limit)
        .take(3)
        .map(|(_, candidate)| format!("`{candidate}`"))
        .collect();
    if close.is_empty() {
        let symbols: Vec<&str> = VARIABLES.iter().map(|variable| variable.symbol).collect();
        format!("the variables are {}", symbols.join(" "))
    } else {
        format!("did you mean {}?", close.join(" or "))
    }
}

/// How many letters have to be inserted, removed or replaced to turn `a` into `b`.
pub fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(from != *to);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(row[j + 1] + 1);
        }
    }
    row[b.len()]
}
