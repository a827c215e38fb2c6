//! The measured curve of a spring: the file that it is read from.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crossterm::event::KeyEvent;

use crate::model::scene::{Scene, SpringKind};
use crate::model::variables;
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::ask::{Ask, Step};
use crate::tui::message::{EffectReport, FileTask};
use crate::tui::pages::run::editor::extent;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

/// After a word was taken: a spring that is a table now requests its file.
pub(super) fn ask(app: &mut App, word: &str) {
    let is_kind = app.pages.run.editor.variable().key == "mechanism.spring.kind";
    if is_kind && word == SpringKind::Table.word() {
        app.dialog = Some(Box::new(Curve::default()));
    }
}

#[derive(Clone, Debug, Default)]
struct Curve(Ask);

impl Dialog for Curve {
    fn footer(&self) -> Footer {
        &[
            (FootKey::Of(Action::FocusNext), "complete"),
            (FootKey::Of(Action::Enter), "read"),
            (FootKey::Of(Action::Back), "keep"),
        ]
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        match self.0.press(app, key, true) {
            Step::Accept { .. } => {
                let task =
                    self.0.path(app, "curve.csv").map(|path| Some(FileTask::ReadCurve(path)));
                self.0.begun(app, task);
            }
            Step::Closes => return Outcome::Closes,
            Step::Stays => {}
        }
        Outcome::Stays
    }

    fn click(&mut self, _: &mut App, _: usize) -> Outcome {
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        Some(&mut self.0.text)
    }

    fn pasted(&mut self) {
        self.0.forget();
    }

    fn answered(&mut self, directory: &Path, report: &EffectReport) -> Option<Outcome> {
        match report {
            EffectReport::Curve(path, points) if self.0.is_of(directory, path) => {
                Some(self.0.ended(points))
            }
            EffectReport::Completions(names) => Some(self.0.complete(names)),
            _ => None,
        }
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        // The required format of the file, and the present points.
        let hint = format!(
            "displacement in m, force in N, one point per line, as in 0.01,1000. Now: {} (Esc keeps them)",
            extent(&app.scene.mechanism.spring.table.points)
        );
        let pane = PaneFrame::new("Measured curve of the spring (CSV)");
        self.0.draw(app, (pane, "file  ", hint), screen, canvas);
    }
}

/// A curve that was read, where the scene makes sense with it; else why not.
pub(crate) fn checked(
    app: &App,
    path: PathBuf,
    points: Result<Arc<[[f64; 2]]>, String>,
) -> (EffectReport, Option<Scene>) {
    let scene = points.clone().and_then(|points| {
        let mut scene = (*app.scene).clone();
        let spring = &mut scene.mechanism.spring;
        spring.kind = SpringKind::Table;
        spring.table.points = points;
        variables::validate(&scene).map_err(|error| error.to_string())?;
        Ok(scene)
    });
    match scene {
        Ok(scene) => (EffectReport::Curve(path, points), Some(scene)),
        Err(why) => (EffectReport::Curve(path, Err(why)), None),
    }
}
