//! Words of screens and pages that are neither variables nor quantities nor warnings, each with its explanation.

mod keys;
mod results;
mod studies;

pub(super) use keys::FAMILIES;

/// Words with the same explanation, and the explanation.
pub(super) type Entry = (&'static [&'static str], &'static str);

/// Iterates over all words.
pub(super) fn all() -> impl Iterator<Item = &'static Entry> {
    results::WORDS.iter().chain(studies::WORDS)
}

/// Iterates over the keys of files that are no words of screens.
pub(super) fn keys() -> impl Iterator<Item = &'static Entry> {
    keys::KEYS.iter()
}
