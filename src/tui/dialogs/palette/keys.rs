//! What Enter does in the palette and in help: the action, in the pane it belongs to; the variable; the preset.

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs;
use crate::tui::dialogs::Picker;
use crate::tui::dialogs::palette::Item;
use crate::tui::keymap::{Action, Command, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::run::editor::field;
use crate::tui::update::act;

/// Do what the selected row of the palette is for.
pub(in crate::tui) fn chosen(app: &mut App, picker: &Picker) -> Vec<Effect> {
    let found = app.palette(picker.filter.value());
    match found.get(picker.selected).copied() {
        None => {
            let typed = picker.filter.value().trim().to_owned();
            app.say(Severity::Note, format!("nothing is called `{typed}`"));
            Vec::new()
        }
        Some(Item::Command(command)) => call(app, command),
        Some(Item::Variable(index)) => {
            app.focus_on(Pane::Variables);
            app.editor.filter.clear();
            app.editor.selected = index;
            field::open(app)
        }
        Some(Item::Preset(entry)) => {
            let entry = entry.clone();
            dialogs::keys::take_preset(app, entry)
        }
    }
}

/// Call an action, in the pane it belongs to.
pub(in crate::tui) fn call(app: &mut App, command: &Command) -> Vec<Effect> {
    let mut effects = Vec::new();
    if let Some(pane) = command.pane.filter(|pane| *pane != app.pane()) {
        let before = app.tab;
        app.focus_on(pane);
        if app.tab != before {
            effects = crate::tui::pages::of(app.tab).enter(app);
        }
    }
    effects.extend(act::act(app, command.action));
    effects
}

/// Call the action of a row of help.
pub(in crate::tui) fn press(app: &mut App, action: Action) -> Vec<Effect> {
    act::act(app, action)
}
