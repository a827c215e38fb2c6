//! Sensitivity bars beside the variables: the effect of every variable on one result of the scene.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::state::Matters;
use crate::tui::pages::search::levels;
use crate::worker::studies::{SearchAnswer, SearchRequest};
use cmra_engine::model::units::in_unit;
use cmra_engine::model::variables::Variable;
use cmra_studies::report::sensitivity::{CELLS, Shown, bar, words};
use cmra_studies::study::quantities::find;
use cmra_studies::study::sensitivity::{OUTPUT, POINTS, Request, SensitivityReport};

/// Outputs of the bars in cyclic order, each with a label.
const OUTPUTS: [(&str, &str); 3] =
    [(OUTPUT, "depth"), ("max_plate_displacement_m", "travel"), ("peak_contact_force_n", "force")];

/// Bar beside a variable.
pub(crate) struct Bar {
    pub text: String,
    /// Cell of the scene's value.
    pub own: Option<usize>,
}

impl Matters {
    fn request(&self) -> Option<Request> {
        let (name, _) = OUTPUTS[self.output?];
        Some(Request { over: Vec::new(), output: find(name).filter(|_| name != OUTPUT) })
    }

    /// Returns the report of the displayed output.
    fn report(&self) -> Option<&SensitivityReport> {
        let request = SearchRequest::Sensitivity(self.request()?);
        let is_asked = **SearchRequest::downcast(self.kept.request.as_ref()?)? == request;
        match &**self.kept.result.as_ref()? {
            SearchAnswer::Sensitivity(report) if is_asked => Some(report),
            _ => None,
        }
    }

    /// Returns `true` if the report of a scene is complete, or its time limit is used up.
    fn is_settled(&self, scene: &Scene) -> bool {
        let kept = &self.kept;
        self.report().is_some() && *kept.scene == *scene && kept.has_been_looked_at()
    }
}

/// Shows the next output, or labels instead of bars.
pub(crate) fn next(app: &mut App) {
    let matters = &mut app.pages.run.matters;
    matters.output = match matters.output {
        None => Some(0),
        Some(at) => Some(at + 1).filter(|at| *at < OUTPUTS.len()),
    };
    match matters.output {
        None => app.report_progress("words again; <view> shows what matters"),
        Some(at) => {
            app.report_progress(format!(
                "what matters: {} over the range of each variable; <view> shows the next result",
                OUTPUTS[at].1
            ));
            look(app);
        }
    }
}

fn look(app: &mut App) {
    let Some(request) = app.pages.run.matters.request() else { return };
    let request = SearchRequest::Sensitivity(request);
    let is_it = |running: &Running| {
        let is_asked = SearchRequest::downcast(&running.request).is_some_and(|it| **it == request);
        running.tab == Tab::Run && is_asked && *running.scene == *app.scene
    };
    let is_coming = app.jobs.studies.iter().any(is_it);
    if app.tab == Tab::Run && !is_coming && !app.pages.run.matters.is_settled(&app.scene) {
        jobs::look(app, jobs::LOOK, request);
    }
}

/// Restarts the idle time before the bars are computed, because a key was pressed.
pub(crate) fn wait(app: &mut App) {
    let matters = &app.pages.run.matters;
    if matters.output.is_some() && !matters.is_settled(&app.scene) {
        jobs::begin_rest(app);
    }
}

/// Computes the bars after the idle time, unless the run of the scene is still active.
pub(crate) fn rested(app: &mut App) {
    if app.jobs.current.is_some() { wait(app) } else { look(app) }
}

/// Computes the rest of the bars on request; returns `false` if they are complete.
pub(crate) fn fill(app: &mut App, action: Action) -> bool {
    let matters = &app.pages.run.matters;
    let is_partial = matters.report().is_some_and(|report| report.points_least() < POINTS);
    let is_of_scene = *matters.kept.scene == *app.scene;
    let Some(request) = matters.request().filter(|_| is_partial && is_of_scene) else {
        return false;
    };
    jobs::study(app, action, SearchRequest::Sensitivity(request));
    true
}

/// Stores the results of a report.
pub(crate) fn report(app: &mut App, running: &Running, news: &ReportBody) {
    if SearchRequest::downcast(&running.request).is_some() {
        app.pages.run.matters.kept.keep(running, news);
    }
}

/// Returns the output and the scale of the bars; `None` if labels are shown.
pub(crate) fn matters_title(app: &App) -> Option<String> {
    let (_, word) = OUTPUTS[app.pages.run.matters.output?];
    let mut word = word.to_owned();
    word[..1].make_ascii_uppercase();
    let report = app.pages.run.matters.report();
    let scale = report.and_then(|report| Some(report.output.show(report.scale()?, 3)));
    Some(scale.map_or_else(|| format!("{word} by range"), |top| format!("{word}, 0 to {top}")))
}

/// Returns the bar of a variable if bars are shown; empty for a variable that the scene ignores.
pub(crate) fn matters_bar(app: &App, variable: &Variable) -> Option<Bar> {
    let matters = &app.pages.run.matters;
    matters.output?;
    let drawn = || {
        let report = matters.report()?;
        let effect = report.effect(variable.symbol)?;
        let levels = levels(app.settings.theme.glyphs);
        let own = effect.own_cell(CELLS).filter(|_| *matters.kept.scene == *app.scene);
        Some(Bar { text: bar(effect, report.scale()?, levels), own })
    };
    Some(drawn().unwrap_or(Bar { text: String::new(), own: None }))
}

/// Describes the effect of the selected variable; `None` if unknown.
pub(crate) fn matters_words(app: &App) -> Option<String> {
    let matters = &app.pages.run.matters;
    let (_, word) = OUTPUTS[matters.output?];
    let report = matters.report().filter(|_| *matters.kept.scene == *app.scene)?;
    let editor = &app.pages.run.editor;
    let (variable, unit) = (editor.variable(), editor.unit(editor.selected));
    let effect = report.effect(variable.symbol)?;
    let in_one = in_unit(1.0, unit, variable.number()?.quantity).unwrap_or(1.0);
    let text = words(report, effect, word, &Shown { in_one, unit });
    let computed = effect.computed();
    Some(if computed < POINTS {
        format!("{text} ({computed} of {POINTS} points; <run> computes all)")
    } else {
        text
    })
}
