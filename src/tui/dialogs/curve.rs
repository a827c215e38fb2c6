//! The measured curve of a spring: asked for when its kind becomes `table`, read from a CSV file, put into the scene.

use std::path::Path;
use std::sync::Arc;

use crate::model::scene::SpringKind;
use crate::model::{units, variables};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::{Ask, Dialog, Purpose, ask};
use crate::tui::message::Effect;
use crate::tui::update::edit;
use crate::tui::widgets::input::TextField;

/// The titles of the dialog.
pub(in crate::tui) const TITLES: (&str, &str) =
    ("Measured curve of the spring (CSV)", "Tab completes  Enter reads  Esc keeps");

/// After a word was taken: a spring that is a table now asks for its file.
pub(in crate::tui) fn ask(app: &mut App, word: &str) {
    let second = match app.editor.variable().key {
        "mechanism.spring.kind" => false,
        "mechanism.second.kind" => true,
        _ => return,
    };
    if word == SpringKind::Table.word() {
        ask::open(app, Purpose::Curve(second), TextField::default());
    }
}

/// What the file has to be, and the points there are.
pub(in crate::tui) fn hint(app: &App, second: bool) -> String {
    let mechanism = &app.scene.mechanism;
    let spring = if second { &mechanism.second } else { &mechanism.spring };
    format!(
        "displacement in m, force in N, a point a line, as in 0.01,1000. Now: {} (Esc keeps them)",
        extent(&spring.table.points)
    )
}

/// `3 points, x = 0 to 0.05 m`.
pub(in crate::tui) fn extent(points: &[[f64; 2]]) -> String {
    match (points.first(), points.last()) {
        (Some(first), Some(last)) => format!(
            "{} points, x = {} to {} m",
            points.len(),
            units::shortest(first[0]),
            units::shortest(last[0])
        ),
        _ => "no points".to_owned(),
    }
}

/// Whether the file is asked for.
fn is_asked(dialog: Option<&Dialog>) -> bool {
    matches!(dialog, Some(Dialog::Ask(Ask { purpose: Purpose::Curve(_), .. })))
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
            if is_asked(dialog.as_ref()) {
                *dialog = None;
            }
            app.say(Severity::Note, format!("spring: {count} points from {name} (u undoes)"));
            edit::commit_scene(app, scene, format!("spring curve from {name}"), None)
        }
        (Err(text), Some(Dialog::Ask(state))) => {
            state.text.error = Some(text);
            Vec::new()
        }
        (Err(text), _) => app.refuse(text),
    }
}
