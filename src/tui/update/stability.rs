//! The Stability tab: asking for the map and the battery, and moving about in them.

use std::sync::Arc;

use super::{jobs, table};
use crate::study::stability::map::{Axis, Method};
use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::Table;
use crate::tui::app::notice::Severity;
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Finding, Study, StudyBody, StudyKind, StudyReport};

/// Far along the map.
const FAR: isize = 10;

/// What is shown is computed, unless it has been or is being.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.stability;
    if tab.battery_shown {
        let there = tab.battery.as_ref().is_some_and(|(_, all)| *all) || tab.running.is_some();
        return if there { Vec::new() } else { battery(app) };
    }
    let there = tab.map.as_ref().is_some_and(|(scene, map)| {
        *scene == app.scene && map.method == tab.method && map.axis == tab.axis
    });
    if there { Vec::new() } else { map(app) }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(action: Action) -> bool {
    matches!(
        action,
        Action::Run
            | Action::Export
            | Action::FocusNext
            | Action::FocusPrevious
            | Action::MapVariable
            | Action::MapMethod
            | Action::CursorLeft
            | Action::CursorRight
            | Action::CursorLeftFar
            | Action::CursorRightFar
            | Action::CursorUpFar
            | Action::CursorDownFar
            | Action::Quantity
    )
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    let tab = &mut app.stability;
    match action {
        Action::Run if tab.battery_shown => return battery(app),
        Action::Run => return map(app),
        Action::FocusNext | Action::FocusPrevious => {
            tab.battery_shown = !tab.battery_shown;
            return enter(app);
        }
        Action::MapVariable => {
            tab.axis = match tab.axis {
                Axis::K => Axis::N,
                Axis::N => Axis::B,
                Axis::B => Axis::K,
            };
            return map(app);
        }
        Action::MapMethod => {
            tab.method = match tab.method {
                Method::Thesis => Method::Rk4,
                Method::Rk4 => Method::Thesis,
            };
            return map(app);
        }
        Action::Quantity => tab.turned += 1,
        Action::CursorLeft => tab.move_cursor(0, -1),
        Action::CursorRight => tab.move_cursor(0, 1),
        Action::CursorUpFar => tab.move_cursor(FAR, 0),
        Action::CursorDownFar => tab.move_cursor(-FAR, 0),
        Action::CursorLeftFar => tab.move_cursor(0, -FAR),
        Action::CursorRightFar => tab.move_cursor(0, FAR),
        _ if tab.battery_shown => table::open(app, Table::Battery),
        _ => table::open(app, Table::Map),
    }
    Vec::new()
}

fn study(app: &mut App, kind: StudyKind) -> (Measuring, Vec<Effect>) {
    let id = app.jobs.next_id();
    let scene = Arc::clone(&app.scene);
    let measuring = Measuring { id, scene: Arc::clone(&scene), points: None, long: false };
    let effects = vec![
        Effect::Study(Study { id, scene, kind }),
        Effect::After(jobs::LONG, Message::LongJob(id)),
    ];
    (measuring, effects)
}

fn map(app: &mut App) -> Vec<Effect> {
    let kind = StudyKind::Map(app.stability.method, app.stability.axis);
    let (measuring, effects) = study(app, kind);
    app.stability.mapping = Some(measuring);
    effects
}

fn battery(app: &mut App) -> Vec<Effect> {
    let (measuring, effects) = study(app, StudyKind::Battery);
    app.stability.running = Some(measuring);
    effects
}

/// A report of the map or the battery under way.
pub(super) fn report(app: &mut App, report: StudyReport) {
    let tab = &mut app.stability;
    match report.body {
        StudyBody::Part { done, total, part: Finding::Battery(rows, all) } => {
            if let Some(running) = &mut tab.running {
                running.points = Some((done, total));
            }
            tab.battery = Some((rows, all));
        }
        StudyBody::Ended(Finding::Battery(rows, all)) => {
            tab.running = None;
            tab.battery = Some((rows, all));
        }
        StudyBody::Ended(Finding::Map(map)) => {
            if tab.map.as_ref().is_some_and(|(_, old)| old.axis != map.axis) {
                tab.cursor = None;
            }
            tab.map = tab.mapping.take().map(|mapping| (mapping.scene, map));
        }
        StudyBody::Failed(text) => {
            if tab.mapping.as_ref().is_some_and(|it| it.id == report.id) {
                tab.mapping = None;
            } else {
                tab.running = None;
            }
            app.say(Severity::Error, text);
        }
        // Findings of other kinds carry other numbers.
        StudyBody::Part { .. } | StudyBody::Ended(_) => {}
    }
}
