//! The dialog for the path of a table: typing, confirming, overwriting. What is written there is each tab's own business.

use std::path::PathBuf;

use crossterm::event::{KeyCode, KeyEvent};
use tui_input::Input;

use crate::model::scene::Scene;
use crate::tui::app::App;
use crate::tui::dialogs::{Dialog, Save};
use crate::tui::message::Effect;
use crate::tui::widgets::input;

/// A key while it is open. `write` is given the state and whether a file may be overwritten; `dialog` keeps it open.
pub(in crate::tui) fn press(
    app: &mut App,
    mut state: Save,
    key: KeyEvent,
    write: impl FnOnce(&App, &mut Save, bool) -> Vec<Effect>,
    dialog: impl FnOnce(Save) -> Dialog,
) -> Vec<Effect> {
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Esc => return Vec::new(),
        KeyCode::Char('y' | 'o') if state.question => effects = write(app, &mut state, true),
        KeyCode::Char('r') if state.question => {
            state.input = Input::new(next_name(state.input.value()));
            state.question = false;
        }
        KeyCode::Enter if state.question => {}
        KeyCode::Enter => effects = write(app, &mut state, false),
        KeyCode::Tab => effects = vec![Effect::Complete(state.input.value().to_owned())],
        _ => {
            if input::press(&mut state.input, &mut state.all_selected, key) {
                state.question = false;
                state.error = None;
            }
        }
    }
    app.dialog = Some(dialog(state));
    effects
}

/// The path that was typed; `None`, with the reason in the dialog, where it names no file.
pub(in crate::tui) fn typed(app: &App, state: &mut Save, example: &str) -> Option<PathBuf> {
    let text = state.input.value().trim();
    if text.is_empty() || text.ends_with('/') {
        state.error = Some(format!("the path needs a file name, for example `{example}`"));
        return None;
    }
    let path = app.directory.join(text);
    state.question = false;
    Some(path)
}

/// The next name of a series: `run.csv`, `run-2.csv`, `run-3.csv`.
pub(in crate::tui) fn next_name(text: &str) -> String {
    let (stem, ending) = match text.rsplit_once('.') {
        Some((stem, ending)) if !ending.contains('/') => (stem, format!(".{ending}")),
        _ => (text, String::new()),
    };
    match stem.rsplit_once('-') {
        Some((front, number)) => match number.parse::<u32>() {
            Ok(number) => format!("{front}-{}{ending}", number.saturating_add(1)),
            Err(_) => format!("{stem}-2{ending}"),
        },
        None => format!("{stem}-2{ending}"),
    }
}

/// The first part of the name proposed for a file about a scene: the preset's, where the scene is still that.
pub(in crate::tui) fn stem<'a>(app: &'a App, scene: &Scene) -> &'a str {
    if *scene == *app.base.scene { base_stem(app) } else { "scene" }
}

/// The preset's name without folders and ending.
pub(in crate::tui) fn base_stem(app: &App) -> &str {
    app.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml")
}
