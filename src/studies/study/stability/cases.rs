//! Test scenes of the engine, stiff or extreme, with the difficulty of each.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use serde::Deserialize;

use crate::study::changed_free_plate;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::VariableError;

/// Test scene.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Short name.
    pub name: &'static str,
    /// Numerical difficulty of the scene.
    pub why: &'static str,
    /// Changes to Table 9.1 with gamma = 1 and neither spring nor damper, as `--set` takes them.
    pub changes: &'static str,
}

impl Case {
    /// Returns the scene.
    pub fn scene(&self) -> Result<Arc<Scene>, VariableError> {
        changed_free_plate(self.changes).map(Arc::new)
    }
}

/// Test scenes of `data/stability.toml`; empty if the file is invalid, which a test excludes.
pub static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| read().unwrap_or_default());

fn read() -> Result<Vec<Case>, toml::de::Error> {
    let mut lists: BTreeMap<&str, Vec<Case>> =
        toml::from_str(include_str!("../../data/stability.toml"))?;
    Ok(lists.remove("scenes").unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_a_valid_scene_with_a_name_of_its_own() {
        let all = read().unwrap_or_else(|problem| panic!("{problem}"));
        assert!(all.len() >= 50);
        for (index, case) in CASES.iter().enumerate() {
            let scene = case.scene().unwrap_or_else(|error| panic!("{}: {error}", case.name));
            cmra_engine::model::variables::validate(&scene)
                .unwrap_or_else(|error| panic!("{}: {error}", case.name));
            assert!(CASES[..index].iter().all(|other| other.name != case.name), "{}", case.name);
            assert!(case.name.chars().count() <= 23, "{}", case.name);
        }
    }
}
