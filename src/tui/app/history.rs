//! Edits that can be undone: the last thousand of the session, held arrow keys merged into one.

use std::sync::Arc;

use crate::model::scene::Scene;
use crate::tui::app::Base;
use crate::tui::pages::explore::state::PicturePlan;
use crate::tui::pages::run::runs::Pin;
use crate::tui::pages::search::setup::{Row, Setup};
use crate::tui::pages::search::state::Page;

/// All that edits change but for the pins, at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub scene: Arc<Scene>,
    /// The preset it is compared with.
    pub base: Base,
    /// The setup of the Search tab.
    pub search: Arc<Setup>,
    /// The points that the Explore tab computes.
    pub plan: PicturePlan,
}

/// Most edits that are kept, at some 1.5 kB each: of more the oldest go.
const EDITS_MAX: usize = 1000;

/// Pins of edits whose results are kept: a result is some 100 kB, and can be computed again.
const RESULTS_KEPT: usize = 8;

/// A result with more rows in its series is not kept at all.
const ROWS_MAX: usize = 10_000;

#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// From one state to another.
    State(Box<(Snapshot, Snapshot)>),
    Pinned(Pin),
    Unpinned(Pin),
}

impl Change {
    /// The change back.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::State(states) => Self::State(Box::new((states.1, states.0))),
            Self::Pinned(pin) => Self::Unpinned(pin),
            Self::Unpinned(pin) => Self::Pinned(pin),
        }
    }
}

/// A value that arrow keys step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stepping {
    /// A variable, by index into the table.
    Variable(usize),
    /// A row of the setup of a search.
    Search(Page, Row),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// The label of the edit: `gamma 1 -> 1.25`.
    pub label: String,
    pub change: Change,
    /// What was stepped, while further steps still belong to it.
    pub stepping: Option<Stepping>,
}

impl Edit {
    fn pin(&mut self) -> Option<&mut Pin> {
        match &mut self.change {
            Change::Pinned(pin) | Change::Unpinned(pin) => Some(pin),
            Change::State(_) => None,
        }
    }
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
    pub fn push(&mut self, mut edit: Edit) {
        if let Some(pin) = edit.pin() {
            pin.run.take_if(|run| run.series.len() > ROWS_MAX);
        }
        self.edits.truncate(self.done);
        if let Some(last) = self.edits.last_mut()
            && edit.stepping.is_some()
            && last.stepping == edit.stepping
        {
            last.label = edit.label;
            match (&mut last.change, edit.change) {
                (Change::State(kept), Change::State(new)) => kept.1 = new.1,
                (_, change) => last.change = change,
            }
            return;
        }
        self.edits.push(edit);
        self.edits.drain(..self.edits.len().saturating_sub(EDITS_MAX));
        self.done = self.edits.len();
        let pins = self.edits.iter_mut().rev().filter_map(Edit::pin);
        for pin in pins.skip(RESULTS_KEPT) {
            pin.run = None;
        }
    }

    /// The state before the edit that a further step of this variable extends: held arrows count from where they began.
    pub fn extended(&self, stepping: Option<Stepping>) -> Option<&Snapshot> {
        let last = self.edits.last()?;
        match &last.change {
            Change::State(kept) if stepping.is_some() && last.stepping == stepping => Some(&kept.0),
            Change::State(_) | Change::Pinned(_) | Change::Unpinned(_) => None,
        }
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
    use crate::model::simulate::{Settings, simulate};
    use crate::tui::app::App;

    #[test]
    fn of_very_many_edits_the_last_thousand_are_kept() {
        let at = App::default().snapshot();
        let mut history = History::default();
        for number in 0..2500 {
            let change = Change::State(Box::new((at.clone(), at.clone())));
            history.push(Edit { label: number.to_string(), change, stepping: None });
        }
        assert_eq!((history.edits.len(), history.done), (EDITS_MAX, EDITS_MAX));
        assert_eq!(history.edits[0].label, "1500");
        assert_eq!(history.edits.last().unwrap().label, "2499");
    }

    #[test]
    fn results_of_pins_are_kept_for_the_last_few_edits_only() {
        let scene = Arc::new(Scene::default());
        let go_on = &mut |_| std::ops::ControlFlow::Continue(());
        let run = Arc::new(simulate(&scene, &Settings::default(), go_on).unwrap());
        let mut history = History::default();
        for _ in 0..100 {
            let pin = Pin {
                letter: 'A',
                name: String::new(),
                scene: Arc::clone(&scene),
                run: Some(Arc::clone(&run)),
                visible: true,
                job: None,
            };
            let change = Change::Unpinned(pin);
            history.push(Edit { label: String::new(), change, stepping: None });
        }
        // The hundred edits are all there, and the pins; of the results the newest.
        assert_eq!(history.edits.iter_mut().filter_map(Edit::pin).count(), 100);
        assert_eq!(Arc::strong_count(&run), 1 + RESULTS_KEPT);
        assert!(history.edits.last_mut().unwrap().pin().unwrap().run.is_some());
    }
}
