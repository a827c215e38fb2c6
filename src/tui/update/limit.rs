//! The Limit tab: asking for the limit, walking along its curve.

use std::sync::Arc;

use super::{jobs, table};
use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::{Table, wrap};
use crate::tui::app::notice::Severity;
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Finding, Study, StudyBody, StudyKind};

/// Far along the curve, in shots.
const FAR: isize = 5;

/// The tab is shown: find the limit, unless this scene's has been or is being found.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.limit;
    let found = tab.report.as_ref().is_some_and(|report| *report.scene == *app.scene);
    let under_way = tab.finding.as_ref().is_some_and(|study| study.scene == app.scene);
    if found || under_way { Vec::new() } else { find(app) }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(app: &App, action: Action) -> bool {
    let turns = matches!(action, Action::FocusNext | Action::FocusPrevious);
    (turns && app.limit_pages().is_some())
        || matches!(
            action,
            Action::Run
                | Action::Export
                | Action::Scatter
                | Action::CursorLeft
                | Action::CursorRight
                | Action::CursorLeftFar
                | Action::CursorRightFar
                | Action::First
                | Action::Last
        )
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    match action {
        Action::Run => return find(app),
        Action::Scatter => {
            app.limit.scattered = !app.limit.scattered;
            return find(app);
        }
        Action::FocusNext => turn(app, 1),
        Action::FocusPrevious => turn(app, -1),
        Action::CursorLeft => app.limit.move_cursor(-1),
        Action::CursorRight => app.limit.move_cursor(1),
        Action::CursorLeftFar => app.limit.move_cursor(-FAR),
        Action::CursorRightFar => app.limit.move_cursor(FAR),
        Action::First => app.limit.cursor = (!app.limit.shots().is_empty()).then_some(0),
        Action::Last => app.limit.cursor = app.limit.shots().len().checked_sub(1),
        _ => table::open(app, Table::Limit),
    }
    Vec::new()
}

/// Turn from the curve through the pages of words, in a circle.
fn turn(app: &mut App, by: isize) {
    let pages = app.limit_pages().map_or(0, |(_, pages)| pages);
    app.limit.page = wrap(app.limit.page.min(pages), by, pages + 1);
}

fn find(app: &mut App) -> Vec<Effect> {
    let id = app.jobs.next_id();
    let scene = Arc::clone(&app.scene);
    let finding = Measuring { id, scene: Arc::clone(&scene), points: None, long: false };
    app.limit.finding = Some(finding);
    let kind = StudyKind::Limit(app.limit.effort());
    vec![Effect::Study(Study { id, scene, kind }), Effect::After(jobs::LONG, Message::LongJob(id))]
}

/// A report of the study under way.
pub(super) fn report(app: &mut App, body: StudyBody) {
    let tab = &mut app.limit;
    match body {
        StudyBody::Part { done, total, part: Finding::Limit(_) } => {
            if let Some(finding) = &mut tab.finding {
                finding.points = Some((done, total));
            }
        }
        StudyBody::Ended(Finding::Limit(found)) => {
            tab.finding = None;
            if let Some(found) = found {
                // Another curve has its shots elsewhere.
                if tab.shots() != found.shots {
                    tab.cursor = None;
                }
                tab.report = Some(found);
            }
        }
        StudyBody::Failed(text) => {
            tab.finding = None;
            app.say(Severity::Error, text);
        }
        // Findings of other kinds carry other numbers.
        StudyBody::Part { .. } | StudyBody::Ended(_) => {}
    }
}
