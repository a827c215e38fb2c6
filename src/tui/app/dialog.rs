//! Interface of a dialog on top of the panes.

use std::fmt::Debug;
use std::path::Path;

use crossterm::event::KeyEvent;

use crate::tui::keymap::CommandTarget;
use crate::tui::message::EffectReport;
use crate::tui::prelude::*;

/// Effect of a key on a dialog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Stays,
    Closes,
    /// Closes the dialog and runs a command.
    Calls(CommandTarget),
}

/// Dialog: its keys, drawing and effects. An open dialog receives all keys except the global ones.
pub(crate) trait Dialog: Debug {
    /// Returns the keys for the last row of the screen, the most useful first: `<enter> load  <back> close`.
    fn footer(&self) -> &'static str;

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome;

    /// Handles a click on a row of the list.
    fn click(&mut self, _row: usize) {}

    /// Handles pasted text; returns `true` if a field accepts it.
    fn paste(&mut self, text: &str) -> bool;

    /// Handles the end of an effect: the outcome if the dialog requested it, `None` if it did not. Relative paths start in the directory.
    fn answered(&mut self, _directory: &Path, _report: &EffectReport) -> Option<Outcome> {
        None
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>);
}
