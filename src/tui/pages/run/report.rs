//! The report of the scene as one file: its limit and its sweep are computed first.

use crate::files::export::Destination;
use crate::files::report::Subject;
use crate::model::run::Run;
use crate::study::limit;
use crate::study::sweep::Plan;
use crate::study::sweep::grid::{self, Grid};
use crate::tui::message::{Content, FileTask};
use crate::tui::pages::prelude::*;

/// Makes the text of a report of the scene.
#[derive(Clone, Debug)]
pub(crate) struct ReportFile {
    name: String,
    run: Arc<Run>,
    to: Destination,
}

impl Study for ReportFile {
    fn make(&self, scene: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        let watch = &mut reporter.progress();
        let context = &mut Context::new(reporter.threads(), watch);
        let limit = limit::find(scene, context)?;
        let sweep = if scene.sweep.is_some() { own_sweep(scene, reporter)? } else { None };
        if !limit.is_complete || sweep.as_ref().is_some_and(|grid| !grid.is_complete()) {
            return Err("cancelled: no report was written".into());
        }
        let Self { name, run, .. } = self;
        let subject = Subject { name, scene, run, limit: &limit, sweep: sweep.as_ref() };
        Ok(Finding::new(subject.html()))
    }
}

/// The sweep that is kept with the scene, where a picture can show it.
fn own_sweep(scene: &Scene, reporter: &Reporter<'_>) -> Result<Option<Grid>, Box<dyn Error>> {
    let plan = Arc::new(Plan::of(scene)?);
    let grid = Grid::new(Arc::clone(&plan)).filter(|_| grid::fits(&plan).is_ok());
    let watch = &mut reporter.watch(Grid::clone);
    let context = &mut Context::new(reporter.threads(), watch);
    Ok(grid.map(|grid| grid.fill(grid::PIECE, context)))
}

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
    if let (Some(report), Some(text)) = (running.study.of::<ReportFile>(), news.found::<String>()) {
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
