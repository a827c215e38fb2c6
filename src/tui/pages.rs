//! The pages: one for every tab. The loop of the workbench knows only what all of them have.

pub mod explore;
pub mod limit;
pub mod log;
pub mod numerics;
pub(crate) mod page;
pub mod run;
pub mod search;
pub mod states;
pub mod thesis;

use crate::tui::keymap::{Command, CommandTarget, PaneSpec};
use crate::tui::prelude::*;

pub(crate) use page::{Page, PageSpec, all_jobs, move_by, note, nothing_yet, open_field, pictures};

pub(crate) fn page(tab: Tab) -> &'static dyn Page {
    match tab {
        Tab::Run => &run::RunTab,
        Tab::Explore => &explore::ExploreTab,
        Tab::Limit => &limit::LimitTab,
        Tab::Search => &search::SearchTab,
        Tab::Numerics => &numerics::NumericsTab,
        Tab::Thesis => &thesis::ThesisTab,
        Tab::Log => &log::LogTab,
    }
}

/// All panes, in the order of the tabs.
pub fn all_panes() -> impl Iterator<Item = &'static PaneSpec> {
    Tab::ALL.into_iter().flat_map(|tab| page(tab).about().panes)
}

pub fn spec(pane: Pane) -> &'static PaneSpec {
    let panes = page(pane.tab).about().panes;
    panes.iter().find(|spec| spec.pane == pane).unwrap_or(&panes[0])
}

const fn named(
    action: Action,
    name: &'static str,
    what: &'static str,
    synonyms: &'static str,
) -> Command {
    Command { what, ..Command::new(CommandTarget::Do(action), name, synonyms) }
}

/// All of them: tabs and pages first, then what acts anywhere, then what acts on a pane.
pub fn commands() -> impl Iterator<Item = &'static Command> {
    let of = |within: bool| {
        let all = Tab::ALL.into_iter().flat_map(|tab| page(tab).about().commands);
        all.filter(move |command| matches!(command.call, CommandTarget::In(..)) == within)
    };
    of(false).chain(GENERAL).chain(of(true))
}

#[rustfmt::skip]
static GENERAL: &[Command] = &[
    named(Action::Help, "Help", "keys, and the selected row", "keys"),
    named(Action::Characters, "Next characters", "braille, blocks or ASCII", "options settings glyphs ascii block braille"),
    named(Action::Colours, "Next colours", "256, sixteen or none", "options settings theme"),
    named(Action::Mouse, "Mouse on or off", "click and wheel", "options settings click wheel"),
    named(Action::Presets, "Presets", "scenes, threats, materials", "load open threats materials absorbers scenes file"),
    named(Action::Save, "Save the scene", "as a preset or a file", "preset write store"),
    named(Action::Export, "Export", "CSV or SVG of this page", "csv svg write file table picture chart"),
    named(Action::Beside, "Open a measured trace", "its CSV beside the runs", "compare csv overlay experiment finite elements history beside with"),
    named(Action::Copy, "Copy", "this page to the clipboard", "clipboard osc 52"),
    named(Action::Run, "Run again", "what this page computes", "recompute calculate compute"),
    named(Action::Undo, "Undo", "the last edit", "take back"),
    named(Action::Redo, "Redo", "what was undone", "again"),
    named(Action::Mark, "Pin this run", "to compare with, A to H", "compare keep mark"),
    named(Action::ResetAll, "Set all variables as in the preset", "the scene as it was loaded", "reset all start again default"),
    named(Action::Redraw, "Redraw the screen", "after other output", "clear refresh"),
    named(Action::Suspend, "Suspend", "`fg` resumes", "shell background"),
    named(Action::Quit, "Quit", "the session is kept", "exit leave"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::keymap::{GLOBAL_KEYS, Keymap, PANE_KEYS};

    /// The help of 80 columns shows every key and its meaning in full.
    #[test]
    fn keys_and_meanings_fit_the_help_of_80_columns() {
        let map = Keymap::default();
        let lines =
            GLOBAL_KEYS.iter().chain(PANE_KEYS).map(|line| (map.line_label(line), line.meaning));
        let panes = all_panes().flat_map(|pane| pane.keys);
        for (keys, help) in lines.chain(panes.map(|row| (map.label(row.action), row.help))) {
            assert!(keys.len() <= 13 && map.shown(help).len() <= 61, "{keys}: {help}");
        }
    }
}
