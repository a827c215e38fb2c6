//! Finding by text: how well a text matches.

use cmra_engine::model::variables::Variable;
use cmra_studies::study::quantities::{QUANTITIES, Quantity, named};

/// How well what was typed matches something with these names, described by this text: smaller is better, `None` not at all.
///
/// A whole name comes first, then the beginning of a name, then the beginnings of words of a name, those of any words, and last a
/// long part of a word.
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

/// Letters from which on a text is found inside a word: fewer are in too many words.
const PART_LEAST: usize = 5;

/// How well what was typed matches a variable: by symbol, alias, label, or its name on the command line, else by its meaning.
pub(crate) fn rank_variable(typed: &str, variable: &Variable) -> Option<usize> {
    let name = variable.name();
    let mut names = vec![variable.symbol, variable.label, &name];
    names.extend(variable.aliases);
    rank(typed, &names, &[variable.key, variable.meaning, variable.group.title()].join(" "))
}

/// The ones that match, best first; those that match alike stay in their order.
pub(crate) fn ranked<T>(
    items: impl Iterator<Item = T>,
    rank: impl Fn(&T) -> Option<usize>,
) -> Vec<T> {
    let mut found: Vec<(usize, T)> = items.filter_map(|item| Some((rank(&item)?, item))).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, item)| item).collect()
}

/// The quantity that is called so on the screen, or by its key.
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

/// Quantities that are named where none is called so.
const NEAR: usize = 4;

/// Lower case, words apart by one blank: `figure 9.8` and `figure-9.8` are the same.
fn plain(text: &str) -> String {
    let text = text.to_lowercase().replace(['-', '_', ':', ','], " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
