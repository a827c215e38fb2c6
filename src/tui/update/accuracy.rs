//! The Accuracy tab: asking for measurements, moving about in them, exporting them.

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};
use tui_input::Input;

use super::{input, jobs};
use crate::study::accuracy::Effort;
use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::{Dialog, Save};
use crate::tui::app::notice::Severity;
use crate::tui::app::runs::name_of;
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Study, StudyBody, StudyKind, StudyReport};

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
        _ => show_or_hide(app),
    }
    Vec::new()
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

/// A report of the study under way; those of replaced ones are dropped.
pub(super) fn report(app: &mut App, report: StudyReport) -> Vec<Effect> {
    let tab = &mut app.accuracy;
    let Some(measuring) = tab.measuring.as_mut().filter(|study| study.id == report.id) else {
        return Vec::new();
    };
    match report.body {
        StudyBody::Part { done, total, part } => {
            measuring.points = Some((done, total));
            tab.report = Some(part);
        }
        StudyBody::Ended(found) => {
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
    }
    Vec::new()
}

fn export(app: &mut App) {
    let Some(report) = &app.accuracy.report else {
        app.say(Severity::Error, "nothing to export yet: r measures");
        return;
    };
    let stem = if *report.scene == *app.base.scene { app.base.name.as_str() } else { "scene" };
    let stem = stem.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml");
    app.dialog = Some(Dialog::ExportAccuracy(Save {
        input: Input::new(format!("{stem}-accuracy.csv")),
        fresh: false,
        question: false,
        error: None,
    }));
}

/// A key while the dialog for the path is open.
pub(super) fn press(app: &mut App, mut state: Save, key: KeyEvent) -> Vec<Effect> {
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Esc => return Vec::new(),
        KeyCode::Char('y' | 'o') if state.question => effects = write(app, &mut state, true),
        KeyCode::Enter if state.question => {}
        KeyCode::Enter => effects = write(app, &mut state, false),
        _ => {
            if input::press(&mut state.input, &mut state.fresh, key) {
                state.question = false;
                state.error = None;
            }
        }
    }
    app.dialog = Some(Dialog::ExportAccuracy(state));
    effects
}

fn write(app: &App, state: &mut Save, overwrite: bool) -> Vec<Effect> {
    let text = state.input.value().trim();
    let Some(report) = &app.accuracy.report else {
        return Vec::new();
    };
    if text.is_empty() || text.ends_with('/') {
        state.error = Some("the path needs a file name, for example `accuracy.csv`".to_owned());
        return Vec::new();
    }
    let path = app.directory.join(text);
    let name = name_of(&report.scene, &app.base.name, &app.base.scene);
    state.question = false;
    let found = Box::new((name, (**report).clone()));
    vec![Effect::ExportAccuracy { path, overwrite, found }]
}
