//! Loadable scenes: presets, parts of libraries, and designs found by a page.

use std::sync::Arc;

use crate::files::session::Session;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::{self, VariableError};
use cmra_studies::study::library::Entry;

/// Reference of the scene: the preset from which it was loaded.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferencePreset {
    pub name: String,
    /// Whether the preset is the user's, in the data directory.
    pub is_mine: bool,
    pub scene: Arc<Scene>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct PresetEntry {
    pub name: String,
    /// Origin of the preset: `bundled`, `mine` or `recent`.
    pub origin: &'static str,
    pub scene: Scene,
    /// Comment block at the head of the file: source and expected result.
    pub comment: String,
    /// Library entry that changes a part of the present scene, if it is one.
    pub part: Option<Entry>,
    /// Stored session with the reference of its scene, if it is one.
    pub session: Option<Box<(ReferencePreset, Session)>>,
    /// Reason why the file cannot be read; there is no scene to load then.
    pub problem: Option<String>,
}

impl PresetEntry {
    pub fn of_part(part: Entry) -> Self {
        let scene = Scene { title: part.title.clone(), ..Scene::default() };
        let comment = [part.evidence(), part.warning.clone()].join("\n\n");
        let comment = comment.trim_end().to_owned();
        Self {
            name: part.name.clone(),
            origin: part.library.key(),
            scene,
            comment,
            part: Some(part),
            ..Self::default()
        }
    }

    /// Creates the entry of a file that cannot be read.
    pub fn broken(name: String, problem: String) -> Self {
        Self { name, origin: "mine", problem: Some(problem), ..Self::default() }
    }

    /// Converts the entry to the reference of edits.
    pub(crate) fn base(self) -> ReferencePreset {
        ReferencePreset {
            name: self.name,
            is_mine: self.origin == "mine",
            scene: self.scene.into(),
        }
    }

    /// Returns the scene after applying the entry to the present one.
    pub fn scene_on(&self, present: &Scene) -> Result<Scene, VariableError> {
        let Some(part) = &self.part else { return Ok(self.scene.clone()) };
        let mut scene = present.clone();
        part.apply(&mut scene)?;
        variables::validate(&scene)?;
        Ok(scene)
    }
}

/// Loadable or pinnable scene with its label.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelledScene {
    pub scene: Scene,
    pub label: String,
}
