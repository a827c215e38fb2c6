//! Edits that can be undone: every one of the session, held arrow keys merged into one.

use std::sync::Arc;

use super::Base;
use super::runs::Pin;
use crate::model::scene::Scene;

/// The scene and what it is compared with, at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The preset it is compared with.
    pub base: Base,
}

/// One edit.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// What was done: `gamma 1 -> 1.25`.
    pub label: String,
    /// Before it.
    pub before: Snapshot,
    /// After it.
    pub after: Snapshot,
    /// The pin it took away: then the scene is the same before and after.
    pub unpinned: Option<Pin>,
    /// The variable it was stepped with, while further steps still belong to it.
    pub stepping: Option<usize>,
}

/// The edits of the session, oldest first; those from `done` on have been undone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// All edits.
    pub edits: Vec<Edit>,
    /// How many of them are in force.
    pub done: usize,
}

impl History {
    /// Add an edit; what had been undone is forgotten. A further step of the same variable extends the last edit.
    pub fn push(&mut self, edit: Edit) {
        self.edits.truncate(self.done);
        if let Some(last) = self.edits.last_mut()
            && edit.stepping.is_some()
            && last.stepping == edit.stepping
        {
            last.after = edit.after;
            last.label = edit.label;
            return;
        }
        self.edits.push(edit);
        self.done = self.edits.len();
    }

    /// Further steps start a new edit.
    pub fn seal(&mut self) {
        if let Some(last) = self.edits.last_mut() {
            last.stepping = None;
        }
    }

    /// Take the last edit back; gives it.
    pub fn undo(&mut self) -> Option<&Edit> {
        self.done = self.done.checked_sub(1)?;
        self.edits.get(self.done)
    }

    /// The pins that some of the edits took away.
    pub fn unpinned(&self, edits: std::ops::Range<usize>) -> Vec<Pin> {
        let edits = self.edits.get(edits).unwrap_or_default();
        edits.iter().filter_map(|edit| edit.unpinned.clone()).collect()
    }

    /// Do the last undone edit again; gives it.
    pub fn redo(&mut self) -> Option<&Edit> {
        let edit = self.edits.get(self.done)?;
        self.done += 1;
        Some(edit)
    }
}
