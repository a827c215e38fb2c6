//! Search by text: ranking of matches.

use cmra_engine::model::variables::Variable;
use cmra_studies::study::quantities::{QUANTITIES, Quantity, named};

/// Ranks how well typed text matches an item with these names and this description: smaller is better, `None` for no match.
///
/// The order is: a whole name, the beginning of a name, the beginnings of words of a name, the beginnings of other words, and a long part
/// of a word.
pub(crate) fn rank(typed: &str, names: &[&str], text: &str) -> Option<usize> {
    let typed = plain(typed);
    if typed.is_empty() {
        return Some(0);
    }
    let names: Vec<String> = names.iter().map(|name| plain(name)).collect();
    let all = format!("{} {}", names.join(" "), plain(text));
    let begin_words = |text: &str| {
        let begins = |word: &str| text.split(' ').any(|other| other.starts_with(word));
        typed.split(' ').all(begins)
    };
    if names.contains(&typed) {
        Some(1)
    } else if names.iter().any(|name| name.starts_with(&typed)) {
        Some(2)
    } else if names.iter().any(|name| begin_words(name)) {
        Some(3)
    } else if begin_words(&all) {
        Some(4)
    } else {
        (typed.len() >= PART_LEAST && all.contains(&typed)).then_some(5)
    }
}

/// Minimum length of a text that is searched inside words; shorter texts match too many words.
const PART_LEAST: usize = 5;

/// Ranks how well typed text matches a variable: by symbol, alias, label or long name, else by its meaning.
pub(crate) fn rank_variable(typed: &str, variable: &Variable) -> Option<usize> {
    let name = variable.name();
    let mut names = vec![variable.symbol, variable.label, &name];
    names.extend(variable.aliases);
    rank(typed, &names, &[variable.key, variable.meaning, variable.group.title()].join(" "))
}

/// Returns the matching items, best first; equal matches keep their order.
pub(crate) fn ranked<T>(
    items: impl Iterator<Item = T>,
    rank: impl Fn(&T) -> Option<usize>,
) -> Vec<T> {
    let mut found: Vec<(usize, T)> = items.filter_map(|item| Some((rank(&item)?, item))).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, item)| item).collect()
}

/// Finds a quantity by its displayed name or its key.
pub(crate) fn quantity_called(text: &str) -> Result<&'static Quantity, String> {
    let text = text.trim();
    let titled = QUANTITIES.iter().find(|column| column.title().eq_ignore_ascii_case(text));
    if let Some(found) = titled.or_else(|| named(text).ok()) {
        return Ok(found);
    }
    let matching = ranked(QUANTITIES.iter(), |column| {
        rank(text, &[&column.title(), &column.key_words()], column.meaning)
    });
    let near: Vec<String> = matching.iter().take(NEAR).map(|column| column.title()).collect();
    let hint = if near.is_empty() {
        "<right> steps through all of them".to_owned()
    } else {
        format!("there are {}", near.join(", "))
    };
    Err(format!("no quantity is called `{text}`: {hint}"))
}

/// Maximum number of quantities in the hint for an unknown name.
const NEAR: usize = 4;

/// Converts to lower case with words separated by one blank: `figure 9.8` and `figure-9.8` are equal.
fn plain(text: &str) -> String {
    let text = text.to_lowercase().replace(['-', '_', ':', ','], " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
