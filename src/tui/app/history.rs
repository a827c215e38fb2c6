//! Undo history: the last thousand edits of the session; held arrow keys are merged into one edit.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::tui::app::pins::Pin;
use crate::tui::pages::explore::state::ChartKind;
use crate::tui::pages::search::state::Setup;
use crate::tui::preset::ReferencePreset;
use cmra_engine::model::scene::Scene;

/// Undoable state at a given time.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub scene: Arc<Scene>,
    /// Preset with which the scene is compared.
    pub base: ReferencePreset,
    /// Display units of variables.
    pub units: BTreeMap<usize, &'static str>,
    /// Setup of the Search tab.
    pub search: Arc<Setup>,
    /// Display of the Explore tab: curves or a map.
    pub picture: ChartKind,
    /// Pinned scenes without their results, which can be recomputed.
    pub pins: Vec<Pin>,
}

/// Maximum number of edits; the oldest are dropped. Each takes about 1.5 kB, 3 kB with eight pins.
const EDITS_MAX: usize = 1000;

#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// Label of the edit: `gamma 1 -> 1.25`.
    pub label: String,
    /// States before and after the edit.
    pub states: Box<(Snapshot, Snapshot)>,
    /// Stepped variable, by index into the table, while further steps merge with the edit.
    pub stepping: Option<usize>,
}

/// Edits of the session, oldest first; edits from index `done` on are undone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    pub edits: Vec<Edit>,
    /// Number of edits in effect.
    pub done: usize,
}

impl History {
    /// Adds an edit and drops undone edits. A further step of the same variable extends the last edit.
    pub fn push(&mut self, edit: Edit) {
        self.edits.truncate(self.done);
        if let Some(last) = self.edits.last_mut()
            && edit.stepping.is_some()
            && last.stepping == edit.stepping
        {
            last.label = edit.label;
            last.states.1 = edit.states.1;
            return;
        }
        self.edits.push(edit);
        self.edits.drain(..self.edits.len().saturating_sub(EDITS_MAX));
        self.done = self.edits.len();
    }

    /// Returns the state before the edit that a further step of this variable extends.
    pub fn extended(&self, stepping: Option<usize>) -> Option<&Snapshot> {
        let last = self.edits.last()?;
        (stepping.is_some() && last.stepping == stepping).then_some(&last.states.0)
    }

    /// Ends merging: further steps start a new edit.
    pub fn commit(&mut self) {
        if let Some(last) = self.edits.last_mut() {
            last.stepping = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::app::App;

    #[test]
    fn of_very_many_edits_the_last_thousand_are_kept() {
        let at = App::default().snapshot();
        let mut history = History::default();
        for number in 0..2500 {
            let states = Box::new((at.clone(), at.clone()));
            history.push(Edit { label: number.to_string(), states, stepping: None });
        }
        assert_eq!((history.edits.len(), history.done), (EDITS_MAX, EDITS_MAX));
        assert_eq!(history.edits[0].label, "1500");
        assert_eq!(history.edits.last().unwrap().label, "2499");
    }
}
