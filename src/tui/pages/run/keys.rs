//! The Run tab: what keys do in the list of variables, in the charts and in the table of runs.

use crate::tui::app::App;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::Effect;
use crate::tui::pages::run::editor::field;
use crate::tui::pages::run::steps::Size;
use crate::tui::pages::run::{charts, layout, runs};
use crate::tui::update::act::rows_moved;
use crate::tui::update::{edit, jobs};

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if action == Action::Run {
        return Some(jobs::run_now(app));
    }
    match app.pane() {
        Pane::Charts => charts::keys::act(app, action),
        Pane::Runs => in_runs(app, action),
        _ => in_variables(app, action),
    }
}

/// Up or down, and by how much, an action steps a value.
pub(in crate::tui) fn step_of(action: Action) -> Option<(bool, Size)> {
    match action {
        Action::Left => Some((false, Size::Plain)),
        Action::Right => Some((true, Size::Plain)),
        Action::FarLeft => Some((false, Size::Coarse)),
        Action::FarRight => Some((true, Size::Coarse)),
        Action::FineLess => Some((false, Size::Fine)),
        Action::FineMore => Some((true, Size::Fine)),
        _ => None,
    }
}

fn in_variables(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if let Some((up, size)) = step_of(action) {
        return Some(edit::step(app, up, size));
    }
    if let Some(by) = rows_moved(action, layout::variable_rows(app)) {
        app.editor.move_by(&app.scene, by);
        return Some(Vec::new());
    }
    match action {
        Action::Enter => Some(field::open(app)),
        Action::Reset => Some(edit::reset(app)),
        Action::Mark => Some(runs::keys::pin_scene(app)),
        _ => None,
    }
}

fn in_runs(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if let Some(by) = rows_moved(action, 8) {
        let last = app.pins.len();
        app.selected_run = app.selected_run.saturating_add_signed(by).min(last);
        return Some(Vec::new());
    }
    match action {
        Action::Enter => Some(runs::keys::load(app)),
        Action::Mark if app.selected_run == 0 => Some(runs::keys::pin_scene(app)),
        Action::Mark => Some(runs::keys::unpin(app)),
        Action::ShowHide => Some(runs::keys::show_or_hide(app)),
        Action::Difference => charts::keys::act(app, action),
        _ => None,
    }
}
