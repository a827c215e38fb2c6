//! Scenes that can be loaded: presets, parts of libraries, and designs that a page has found.

use std::sync::Arc;

use crate::files::session::Session;
use cmra_engine::model::library::Entry;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::{self, VariableError};

/// The reference of the scene: the preset it was loaded from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferencePreset {
    pub name: String,
    /// Whether it is the user's own, in the data directory.
    pub is_mine: bool,
    pub scene: Arc<Scene>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct PresetEntry {
    pub name: String,
    /// Where it comes from: `bundled`, `mine` or `recent`.
    pub origin: &'static str,
    pub scene: Scene,
    /// The comment block at the head of its file: source and what to expect.
    pub comment: String,
    /// The entry of a library, where it is one: it changes a part of the present scene.
    pub part: Option<Entry>,
    /// The session that was kept, with the reference of its scene, where it is one.
    pub session: Option<Box<(ReferencePreset, Session)>>,
    /// Why its file cannot be read: then there is no scene to load.
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

    /// The row of a file that cannot be read.
    pub fn broken(name: String, problem: String) -> Self {
        Self { name, origin: "mine", problem: Some(problem), ..Self::default() }
    }

    /// Converts it to the reference of edits.
    pub(crate) fn base(self) -> ReferencePreset {
        ReferencePreset {
            name: self.name,
            is_mine: self.origin == "mine",
            scene: self.scene.into(),
        }
    }

    /// The scene it makes of the present one.
    pub fn scene_on(&self, present: &Scene) -> Result<Scene, VariableError> {
        let Some(part) = &self.part else { return Ok(self.scene.clone()) };
        let mut scene = present.clone();
        part.apply(&mut scene)?;
        variables::validate(&scene)?;
        Ok(scene)
    }
}

/// A scene that can be loaded or pinned, and what it is in words.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelledScene {
    pub scene: Scene,
    pub label: String,
}
