//! The Accuracy page: what was measured, what is selected, and its rows and readouts in words. No drawing.

pub(crate) mod draw;

use crate::model::scene::{ContactModel, RunSettings};
use crate::model::units::engineering;
use crate::report::accuracy::{TARGETS, advice, gain, printed_scheme, seconds};
use crate::study::accuracy::method::Method;
use crate::study::accuracy::{ComparisonOptions, RESULTS};
use crate::tui::pages::page::prelude::*;
use crate::worker::studies::Measurements;

impl App {
    /// The scene on the screen at the tolerance of what was measured: every tolerance is, whichever the scene has.
    pub(crate) fn accuracy_scene(&self) -> Scene {
        let RunSettings { tolerance, .. } = self.pages.numerics.accuracy.report.scene.run;
        let run = RunSettings { tolerance, ..self.scene.run };
        Scene { run, ..Scene::clone(&self.scene) }
    }

    pub fn accuracy_status(&self) -> Vec<StatusPart> {
        let tab = &self.pages.numerics.accuracy;
        let count = tab.points();
        let words = |it: &Running| format!("measuring{}", it.counted("of", " points"));
        let scene = self.accuracy_scene();
        let progress = match progress::<Measurements, _>(self, &tab.report, &scene, words) {
            None => Progress::Done(format!("measured {count} points")),
            Some(Progress::Cut(_)) => Progress::Cut(format!(" after {count} points")),
            Some(other) => other,
        };
        let mut parts = vec![progress.part()];
        let Some(report) = &tab.report.found else { return parts };
        if let Some(reference) = report.references.any() {
            let sure = reference.uncertainty.map(|it| format!(", to {it:.0e}"));
            let words = reference.basis.words();
            let text = format!("reference {words}{}", sure.unwrap_or_default());
            parts.push(part(Severity::Note, text));
            let ending = match reference.results[0] {
                Some(depth_m) => format!("{} deep", engineering(depth_m, "m", 7)),
                None => reference.outcome.word().to_owned(),
            };
            parts.push(part(Severity::Note, ending));
        }
        parts
    }

    /// What to use and what it costs, how far the printed scheme is off, and what leaving out gains.
    pub(crate) fn accuracy_answers(&self) -> Vec<String> {
        let tab = &self.pages.numerics.accuracy;
        let Some(report) = &tab.report.found else { return Vec::new() };
        if !report.is_complete {
            let counted = self.jobs.running::<Measurements>().and_then(|it| it.points);
            let counted = counted.map(|(done, total)| format!(" ({done} of {total})"));
            let counted = counted.unwrap_or_default();
            return vec![format!("error {:.0e}: not computed yet{counted}", TARGETS[0])];
        }
        let gains: Vec<String> = report
            .savings
            .iter()
            .map(|it| {
                let [with, without] = [it.with_s, it.without_s].map(seconds);
                format!("{} {with} -> {without} ({})", it.part, gain(it))
            })
            .collect();
        let gains = (!gains.is_empty()).then(|| format!("omitted: {}", gains.join("; ")));
        let printed = printed_scheme(report);
        std::iter::once(format!("error {}", advice(report))).chain(printed).chain(gains).collect()
    }

    /// All about the selected method: its example point, then what it refused and why.
    pub fn accuracy_details(&self) -> Vec<TextLine> {
        let tab = &self.pages.numerics.accuracy;
        let method = tab.method();
        let mut lines = vec![(format!("{} {}", method.letter(), method.name()), Role::Title)];
        let mut add = |role, text: String| lines.push((text, role));
        let Some(report) = tab.of(method) else {
            add(Role::Text, "not measured yet".to_owned());
            return lines;
        };
        if let Some((parameter, it)) = tab.example() {
            let floor = if it.is_at_floor() { " (floor)" } else { "" };
            add(Role::Text, format!("{parameter}: error {:.1e}{floor}", it.error()));
            let errors = RESULTS.iter().zip(it.errors);
            let errors: Vec<String> = errors
                .filter_map(|((_, words), error)| Some(format!("{words} {:.0e}", error?)))
                .collect();
            add(Role::Text, errors.join(", "));
        }
        let total = report.points.len();
        for (words, points) in report.refusals() {
            add(Role::Warning, format!("{} of {total}: {words}", points.len()));
        }
        if let Some((_, it)) = tab.example() {
            add(Role::Text, format!("{}, {} steps", seconds(it.min_s), it.answer.steps));
        }
        lines
    }
}

/// The tab is shown: measure, unless this scene has been or is being measured.
pub(crate) fn enter(app: &mut App) {
    if app.jobs.lacks::<Measurements, _>(&app.pages.numerics.accuracy.report, &app.accuracy_scene())
    {
        measure(app);
    }
}

pub(crate) fn act(app: &mut App, action: Action) -> bool {
    match action {
        Action::Run => measure(app),
        Action::Enter => use_method(app),
        _ => return false,
    }
    true
}

/// Set the scene to the selected method at the accuracy requested first: its tolerance, or the thesis's listing.
fn use_method(app: &mut App) {
    let tab = &app.pages.numerics.accuracy;
    let method = tab.method();
    if tab.report.is_old(&app.accuracy_scene()) || tab.report.found.is_none() {
        return app.refuse(nothing::<Measurements>(app, BEING_COMPUTED, None));
    }
    let mut scene = (*app.scene).clone();
    let what = match method {
        Method::ThesisPrinted => {
            scene.contact.model = ContactModel::Appendix;
            "the listing of the thesis (contact model appendix)".to_owned()
        }
        Method::Auto => {
            let Some(tolerance) = tab.tolerance() else {
                let text = format!("{} does not reach an error of 1e-6 here", method.name());
                return app.refuse(text);
            };
            scene.run.tolerance = tolerance;
            format!("{}: tolerance {tolerance:.0e} gives 1e-6", method.name())
        }
        _ => {
            let text = format!(
                "{} is here for comparison: a scene is run by auto, which chooses the method",
                method.name()
            );
            return app.refuse(text);
        }
    };
    if scene == *app.scene {
        return app.tell(format!("the scene has this already: {what}"));
    }
    edit::commit_scene(app, scene, format!("use {what}"), None);
    app.tell(format!("{what} (<undo> undoes)"));
}

fn measure(app: &mut App) {
    jobs::study(app, Measurements(ComparisonOptions::FULL));
}

pub(crate) fn report(app: &mut App, running: &Running, news: &ReportBody) {
    let tab = &mut app.pages.numerics.accuracy;
    let is_kept = tab.report.keep(running, news, |report| report.is_complete);
    if is_kept && news.is_last() && !tab.report.is_complete {
        app.tell(jobs::CANCELLED);
    }
}
