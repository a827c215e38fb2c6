//! The measured curve of a spring: the file that it is read from.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::model::scene::{Scene, SpringKind};
use crate::model::variables;
use crate::tui::dialogs::ask::{Ask, Asking, Purpose};
use crate::tui::message::{EffectReport, ExportOutcome, FileTask};
use crate::tui::pages::run::editor::draw::extent;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

/// After a word was taken: a spring that is a table now requests its file.
pub(super) fn ask(app: &mut App, word: &str) {
    let is_kind = app.pages.run.editor.variable().key == "mechanism.spring.kind";
    if is_kind && word == SpringKind::Table.word() {
        app.dialog = Some(Asking::open(Curve, TextField::default()));
    }
}

#[derive(Debug)]
struct Curve;

impl Purpose for Curve {
    const FOOTER: &'static str = "<enter> read  <back> keep";

    fn accept(&self, app: &App, ask: &mut Ask, _: bool) -> Result<Option<FileTask>, String> {
        Ok(Some(FileTask::ReadCurve(ask.path(app, "curve.csv")?)))
    }

    fn ended(&self, ask: &Ask, directory: &Path, report: &EffectReport) -> Option<ExportOutcome> {
        let EffectReport::Curve(path, points) = report else { return None };
        let ended = points.as_ref().err().cloned();
        let ended = ended.map_or(ExportOutcome::Written(Vec::new()), ExportOutcome::Failed);
        ask.is_of(directory, path).then_some(ended)
    }

    fn title(&self) -> (&'static str, &'static str) {
        ("Measured curve of the spring (CSV)", "file  ")
    }

    /// The required format of the file, and the present points.
    fn hint(&self, app: &App, _: &Ask) -> String {
        format!(
            "displacement in m, force in N, one point per line, as in 0.01,1000. Now: {} (Esc keeps them)",
            extent(&app.scene.mechanism.spring.table.points)
        )
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
