//! A dialog on top of the panes, as the rest of the workbench knows it.

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

/// A dialog: its keys, how it is drawn, and what comes of it. While it is open it has all keys but those that work everywhere.
pub(crate) trait Dialog: Debug {
    /// The keys in the last row of the screen, the most useful first: `<enter> load  <back> close`.
    fn footer(&self) -> &'static str;

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome;

    /// A click on a row of its list.
    fn click(&mut self, _row: usize) {}

    /// A text was pasted; whether a field takes it.
    fn paste(&mut self, text: &str) -> bool;

    /// An effect has ended: what becomes of the dialog where it asked for that, `None` where it did not. Relative paths start in
    /// the directory.
    fn answered(&mut self, _directory: &Path, _report: &EffectReport) -> Option<Outcome> {
        None
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>);
}
