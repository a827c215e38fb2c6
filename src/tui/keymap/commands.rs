//! Every action by name, with the words people look for it by: what `:` finds.

use super::Action as A;
use super::{Action, Pane};
use crate::tui::dialogs::options::OptionRow as O;
use crate::tui::pages::{self, Tab};

/// Something that can be called by name.
pub struct Command {
    /// What it does.
    pub call: Call,
    /// Its name, a verb first.
    pub name: &'static str,
    /// Other words it is found by.
    pub synonyms: &'static str,
}

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// An action, in the pane that has the keys.
    Do(Action),
    /// An action of a pane, which is shown first.
    In(Pane, Action),
    /// Shows a pane, with one of the pages of its tab where the pane has several.
    Show(Pane, Option<usize>),
}

impl Command {
    /// An action by name.
    pub const fn new(call: Call, name: &'static str, synonyms: &'static str) -> Self {
        Self { call, name, synonyms }
    }
}

const fn named(action: Action, name: &'static str, synonyms: &'static str) -> Command {
    Command::new(Call::Do(action), name, synonyms)
}

/// All of them: tabs and pages first, then what acts anywhere, then what acts on a pane.
pub fn commands() -> impl Iterator<Item = &'static Command> {
    let of = |within: bool| {
        let all = Tab::ALL.into_iter().flat_map(|tab| pages::of(tab).about().commands);
        all.filter(move |command| matches!(command.call, Call::In(..)) == within)
    };
    of(false).chain(GENERAL).chain(of(true))
}

#[rustfmt::skip]
static GENERAL: &[Command] = &[
    named(A::Help, "Help", "keys"),
    named(A::Options, "Options", "settings preferences menu"),
    named(A::Presets, "Presets", "load open threats materials absorbers scenes file"),
    named(A::Save, "Save the scene", "preset write store"),
    named(A::Export, "Export", "csv write file table"),
    named(A::Copy, "Copy", "clipboard osc 52"),
    named(A::Run, "Run again", "recompute calculate compute"),
    named(A::Undo, "Undo", "take back"),
    named(A::Redo, "Redo", "again"),
    named(A::History, "List of edits", "history undo"),
    named(A::Mark, "Pin this run", "compare keep mark"),
    named(A::ResetAll, "Reset all variables to the preset", "start again default"),
    named(A::FullPane, "Show this pane alone", "full zoom maximise"),
    named(A::Switch(O::Interface), "Switch the interface law", "fused plastic"),
    named(A::Models, "Pin this scene by every contact model", "compare interaction half-sine initial velocity lumped appendix"),
    named(A::Switch(O::Contact), "Next contact model", "interaction half-sine initial velocity lumped appendix"),
    named(A::Switch(O::Threads), "Next number of threads", "cores processors parallel"),
    named(A::Switch(O::AutoRun), "Switch auto-run", "run after every edit"),
    named(A::Switch(O::Characters), "Next set of characters", "ascii block braille glyphs"),
    named(A::Switch(O::Colours), "Next set of colours", "theme colors"),
    named(A::Switch(O::Mouse), "Switch the mouse", "click wheel release"),
    named(A::Redraw, "Redraw the screen", "clear refresh"),
    named(A::Suspend, "Suspend", "shell background"),
    named(A::Quit, "Quit", "exit leave"),
    named(A::QuitWithSummary, "Quit with a summary", "exit print"),
];
