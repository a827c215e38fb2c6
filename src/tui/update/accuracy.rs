//! The Accuracy tab: asking for measurements, moving about in them, exporting them.

use std::sync::Arc;

use crossterm::event::KeyEvent;
use tui_input::Input;

use super::{jobs, path};
use crate::study::accuracy::Effort;
use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::{Dialog, Save};
use crate::tui::app::notice::Severity;
use crate::tui::app::runs::name_of;
use crate::tui::chart::scale::Scale;
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Finding, Study, StudyBody, StudyKind};

/// One zoom step.
const ZOOM: f64 = 2.0;
/// One pan step, as a share of the span.
const PAN: f64 = 0.25;

/// The tab is shown: measure, unless this scene has been or is being measured.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.accuracy;
    let measured = tab.report.as_ref().is_some_and(|report| *report.scene == *app.scene);
    let under_way = tab.measuring.as_ref().is_some_and(|study| study.scene == app.scene);
    if measured || under_way { Vec::new() } else { measure(app) }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(action: Action) -> bool {
    matches!(
        action,
        Action::Run
            | Action::Export
            | Action::ShowHide
            | Action::CursorLeft
            | Action::CursorRight
            | Action::CursorLeftFar
            | Action::CursorRightFar
            | Action::ZoomIn
            | Action::ZoomOut
            | Action::ZoomFit
            | Action::PanLeft
            | Action::PanRight
            | Action::LogX
            | Action::LogY
            | Action::SlopeGuides
            | Action::SpreadBars
            | Action::Quantity
    )
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    let column = 1.0 / f64::from(app.layout().chart_columns().max(1));
    match action {
        Action::Run => return measure(app),
        Action::Export => export(app),
        Action::CursorLeft => app.accuracy.move_cursor(-column),
        Action::CursorRight => app.accuracy.move_cursor(column),
        Action::CursorLeftFar => app.accuracy.move_cursor(-10.0 * column),
        Action::CursorRightFar => app.accuracy.move_cursor(10.0 * column),
        Action::ZoomIn => app.accuracy.zoom(ZOOM),
        Action::ZoomOut => app.accuracy.zoom(1.0 / ZOOM),
        Action::ZoomFit => app.accuracy.sight.times = None,
        Action::PanLeft => app.accuracy.pan(-PAN),
        Action::PanRight => app.accuracy.pan(PAN),
        Action::Quantity => app.accuracy.turned += 1,
        Action::LogX | Action::LogY | Action::SlopeGuides | Action::SpreadBars => look(app, action),
        _ => show_or_hide(app),
    }
    Vec::new()
}

/// Another way to look at the chart.
fn look(app: &mut App, action: Action) {
    let sight = &mut app.accuracy.sight;
    let word = |scale| match scale {
        Scale::Linear => "linear",
        Scale::Log10 => "logarithmic",
    };
    let text = match action {
        Action::LogX => {
            sight.time_scale = sight.time_scale.toggled();
            format!("run time: {}", word(sight.time_scale))
        }
        Action::LogY => {
            sight.error_scale = sight.error_scale.toggled();
            format!("error: {}", word(sight.error_scale))
        }
        Action::SlopeGuides => {
            sight.guides = !sight.guides;
            let logarithmic = (sight.time_scale, sight.error_scale) == (Scale::Log10, Scale::Log10);
            match (sight.guides, logarithmic) {
                (true, true) => "slopes of orders 1, 2, 4 and 8, from the upper left".to_owned(),
                (true, false) => "slopes of orders show where both axes are logarithmic".to_owned(),
                (false, _) => "no slopes".to_owned(),
            }
        }
        _ => {
            sight.bars = !sight.bars;
            if sight.bars {
                "bars: from the least of the timings to their median and its deviation".to_owned()
            } else {
                "no bars".to_owned()
            }
        }
    };
    app.say(Severity::Note, text);
}

fn measure(app: &mut App) -> Vec<Effect> {
    let id = app.jobs.next_id();
    let scene = Arc::clone(&app.scene);
    let measuring = Measuring { id, scene: Arc::clone(&scene), points: None, long: false };
    app.accuracy.measuring = Some(measuring);
    vec![
        Effect::Study(Study { id, scene, kind: StudyKind::Accuracy(Effort::FULL) }),
        Effect::After(jobs::LONG, Message::LongJob(id)),
    ]
}

fn show_or_hide(app: &mut App) {
    let tab = &mut app.accuracy;
    let method = tab.method();
    if tab.hidden.contains(&method) {
        tab.hidden.retain(|hidden| *hidden != method);
    } else {
        tab.hidden.push(method);
    }
}

/// What is said of the study under way.
pub(super) fn report(app: &mut App, body: StudyBody) {
    let tab = &mut app.accuracy;
    match body {
        StudyBody::Part { done, total, part: Finding::Accuracy(part) } => {
            if let Some(measuring) = &mut tab.measuring {
                measuring.points = Some((done, total));
            }
            tab.report = Some(part);
        }
        StudyBody::Ended(Finding::Accuracy(found)) => {
            tab.measuring = None;
            let stopped = !found.is_complete;
            tab.report = Some(found);
            if stopped {
                app.say(Severity::Note, "stopped: what was measured is shown, r measures again");
            }
        }
        StudyBody::Failed(text) => {
            tab.measuring = None;
            app.say(Severity::Error, text);
        }
        // Findings of other kinds carry other numbers.
        StudyBody::Part { .. } | StudyBody::Ended(_) => {}
    }
}

fn export(app: &mut App) {
    let Some(report) = &app.accuracy.report else {
        app.say(Severity::Error, "nothing to export yet: r measures");
        return;
    };
    let name = format!("{}-accuracy.csv", path::stem(app, &report.scene));
    app.dialog = Some(Dialog::ExportAccuracy(Save {
        input: Input::new(name),
        fresh: false,
        question: false,
        error: None,
    }));
}

/// A key while the dialog for the path is open.
pub(super) fn press(app: &mut App, state: Save, key: KeyEvent) -> Vec<Effect> {
    path::press(app, state, key, write, Dialog::ExportAccuracy)
}

fn write(app: &App, state: &mut Save, overwrite: bool) -> Vec<Effect> {
    let Some(report) = &app.accuracy.report else {
        return Vec::new();
    };
    let Some(path) = path::typed(app, state, "accuracy.csv") else { return Vec::new() };
    let name = name_of(&report.scene, &app.base.name, &app.base.scene);
    let found = Box::new((name, (**report).clone()));
    vec![Effect::ExportAccuracy { path, overwrite, found }]
}
