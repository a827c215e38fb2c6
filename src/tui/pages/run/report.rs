//! The report of the scene as one file: its limit and its sweep are computed first.

use crate::files::export::Destination;
use crate::tui::message::{Content, FileTask};
use crate::tui::pages::prelude::*;
use crate::worker::studies::ReportFile;

/// Compute a report for a file, which is written then.
pub(crate) fn write(app: &mut App, to: Destination) -> Result<(), String> {
    if let Some((running, report)) = app.jobs.study::<ReportFile>() {
        // A second Enter does not begin again.
        let is_this = report.to.path == to.path && running.scene == app.scene;
        let other = "another report is being written: wait for it, or close this and press <back>";
        return if is_this { Ok(()) } else { Err(other.to_owned()) };
    }
    let shown = app.shown.as_ref().filter(|shown| *shown.run.scene == *app.scene);
    let shown = shown.filter(|shown| shown.took.is_some());
    let run = shown
        .map(|shown| Arc::clone(&shown.run))
        .ok_or("no run of this scene yet: <run> runs it")?;
    let name = app.name_of(&app.scene);
    jobs::study(app, Tab::Run, ReportFile { name, run, to });
    Ok(())
}

/// The text is there: it is written.
pub(crate) fn made(app: &mut App, running: &Running, news: &ReportBody) {
    if let (Some(report), Some(text)) = (ReportFile::of(&running.asked), news.found::<String>()) {
        let content = Content::Text((*text).clone());
        app.request(Effect::Files(FileTask::Export(report.to.clone(), content)));
    }
}

/// How it stands, while it is computed.
pub(crate) fn status(app: &App) -> Option<StatusPart> {
    let running = app.jobs.running::<ReportFile>()?;
    let words = format!("writing the report{}", running.counted("of", ""));
    Some(Progress::Running(words).part())
}
