//! The measured curve of a spring: asked for when its kind becomes `table`, read from a CSV file, put into the scene.

use std::path::Path;
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};
use tui_input::Input;

use crate::model::scene::SpringKind;
use crate::model::variables;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::{Dialog, Save, path};
use crate::tui::message::Effect;
use crate::tui::update::edit;

/// After a word was taken: a spring that is a table now asks for its file.
pub(in crate::tui) fn ask(app: &mut App, word: &str) {
    let second = match app.editor.variable().key {
        "mechanism.spring.kind" => false,
        "mechanism.second.kind" => true,
        _ => return,
    };
    if word == SpringKind::Table.word() {
        let save =
            Save { input: Input::default(), all_selected: false, question: false, error: None };
        app.dialog = Some(Dialog::Curve(second, save));
    }
}

/// A key while the dialog is open: Tab completes, Enter reads, Esc keeps the points there are.
pub(in crate::tui) fn press(
    app: &mut App,
    second: bool,
    state: Save,
    key: KeyEvent,
) -> Vec<Effect> {
    if key.code == KeyCode::Tab {
        let typed = state.input.value().to_owned();
        app.dialog = Some(Dialog::Curve(second, state));
        return vec![Effect::Complete(typed)];
    }
    let read = |app: &App, state: &mut Save, _overwrite| {
        path::typed(app, state, "curve.csv")
            .map_or_else(Vec::new, |path| vec![Effect::ReadCurve(second, path)])
    };
    path::press(app, state, key, read, |state| Dialog::Curve(second, state))
}

/// The file was read, or could not be: its points become the spring's as one edit, or the dialog says why not.
pub(in crate::tui) fn read(
    app: &mut App,
    second: bool,
    path: &Path,
    points: Result<Arc<[[f64; 2]]>, String>,
) -> Vec<Effect> {
    let name = path
        .file_name()
        .map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned());
    let taken = points.and_then(|points| {
        let count = points.len();
        let mut scene = (*app.scene).clone();
        let mechanism = &mut scene.mechanism;
        let spring = if second { &mut mechanism.second } else { &mut mechanism.spring };
        spring.kind = SpringKind::Table;
        spring.table.points = points;
        variables::validate(&scene).map_err(|error| error.to_string())?;
        Ok((scene, count))
    });
    match (taken, &mut app.dialog) {
        (Ok((scene, count)), dialog) => {
            if matches!(dialog, Some(Dialog::Curve(..))) {
                *dialog = None;
            }
            app.say(Severity::Note, format!("spring: {count} points from {name} (u undoes)"));
            edit::commit_scene(app, scene, format!("spring curve from {name}"), None)
        }
        (Err(text), Some(Dialog::Curve(_, save))) => {
            save.error = Some(text);
            Vec::new()
        }
        (Err(text), _) => {
            app.say(Severity::Error, text);
            Vec::new()
        }
    }
}
