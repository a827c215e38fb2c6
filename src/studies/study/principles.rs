//! Families, principles and functions of thesis Tables 4.1 and 5.1, and the presets that show them.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::study::listed;

/// A design principle (chapter 4) with the functions that serve it (Table 5.1).
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Principle {
    /// The family it belongs to.
    pub family: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The thesis's section.
    pub section: &'static str,
    /// Its function, in other words.
    pub idea: &'static str,
    /// The functions that serve it.
    pub functions: Vec<&'static str>,
    /// The results of this program for it.
    pub computed: &'static str,
    /// The bundled preset that shows it, if one does.
    pub preset: Option<&'static str>,
    /// Those that show its functions, or come nearest.
    pub see_also: Vec<&'static str>,
}

/// Tables 4.1 and 5.1, as they are written in `data/principles.toml`; none where the file is wrong, which a test refuses.
pub static PRINCIPLES: LazyLock<Vec<Principle>> = LazyLock::new(|| read().unwrap_or_default());

fn read() -> Result<Vec<Principle>, toml::de::Error> {
    listed(include_str!("../data/principles.toml"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_seven_principles_in_three_families_and_four_functions() {
        let all = read().unwrap_or_else(|problem| panic!("{problem}"));
        let mut families: Vec<&str> = all.iter().map(|it| it.family).collect();
        families.dedup();
        let mut functions: Vec<&str> = all.iter().flat_map(|it| it.functions.clone()).collect();
        functions.sort_unstable();
        functions.dedup();
        assert_eq!((all.len(), families.len(), functions.len()), (7, 3, 4));
    }
}
