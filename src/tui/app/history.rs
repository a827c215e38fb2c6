//! Edits that can be undone: the last thousand of the session, held arrow keys merged into one.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::tui::app::pins::Pin;
use crate::tui::pages::explore::state::ChartKind;
use crate::tui::pages::search::state::Setup;
use crate::tui::preset::ReferencePreset;
use cmra_engine::model::scene::Scene;

/// All that edits change, at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub scene: Arc<Scene>,
    /// The preset it is compared with.
    pub base: ReferencePreset,
    /// The units that variables are shown in.
    pub units: BTreeMap<usize, &'static str>,
    /// The setup of the Search tab.
    pub search: Arc<Setup>,
    /// Whether the Explore tab draws curves or a map.
    pub picture: ChartKind,
    /// The pinned scenes, without their results: those can be computed again.
    pub pins: Vec<Pin>,
}

/// Most edits that are kept, at some 1.5 kB each and 3 kB with eight pins: of more the oldest go.
const EDITS_MAX: usize = 1000;

#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// The label of the edit: `gamma 1 -> 1.25`.
    pub label: String,
    /// From one state to another.
    pub states: Box<(Snapshot, Snapshot)>,
    /// The variable that was stepped, by index into the table, while further steps still belong to it.
    pub stepping: Option<usize>,
}

/// The edits of the session, oldest first; those from `done` on have been undone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
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
            last.label = edit.label;
            last.states.1 = edit.states.1;
            return;
        }
        self.edits.push(edit);
        self.edits.drain(..self.edits.len().saturating_sub(EDITS_MAX));
        self.done = self.edits.len();
    }

    /// The state before the edit that a further step of this variable extends: held arrows count from where they began.
    pub fn extended(&self, stepping: Option<usize>) -> Option<&Snapshot> {
        let last = self.edits.last()?;
        (stepping.is_some() && last.stepping == stepping).then_some(&last.states.0)
    }

    /// Further steps start a new edit.
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
