//! Dialogs on top of the panes: keys, drawing and effects.

mod choice;
mod help;
pub(crate) mod list;
pub mod palette;
mod path;
mod presets;

use crate::tui::app::dialog::Dialog;
use crate::tui::dialogs::list::listed;
use crate::tui::prelude::*;

pub(crate) use choice::open as list_words;

/// Opens a dialog; reports the reason if it would be empty.
type Open = fn(&mut App) -> Option<Box<dyn Dialog>>;

/// Dialogs, by the action that opens them.
const OPENED: &[(Action, Open)] = &[
    (Action::Help, |_| Some(listed(help::Help, 0))),
    (Action::Palette, |_| Some(listed(palette::Palette, 0))),
    (Action::Presets, |app| {
        app.list_presets();
        Some(listed(presets::Presets, 0))
    }),
    (Action::Save, |app| Some(path::save(app))),
    (Action::Export, path::export),
    (Action::Beside, |app| Some(path::beside(app))),
];

/// Opens the dialog of an action; returns `false` if there is none.
pub(crate) fn open(app: &mut App, action: Action) -> bool {
    let found = OPENED.iter().find(|(opens, _)| *opens == action);
    if let Some((_, open)) = found {
        app.dialog = open(app);
    }
    found.is_some()
}
