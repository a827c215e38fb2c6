//! The Run tab: what keys do in the list of variables, in the charts and in the table of runs.

use crate::model::variables::Kind;
use crate::tui::app::App;
use crate::tui::dialogs::List;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::run::steps::{Press, Size};
use crate::tui::pages::run::{CHARTS, RUNS, charts, runs};
use crate::tui::pages::{self, Tab};
use crate::tui::update::{edit, field, jobs};

/// Words from which on a list is clearer than going to the next one.
const WORDS_LISTED: usize = 3;

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if action == Action::Run {
        return Some(jobs::run_now(app));
    }
    match app.pane() {
        CHARTS => charts::keys::act(app, action),
        RUNS => in_runs(app, action),
        _ => in_variables(app, action),
    }
}

/// Up or down, and by how much, an action steps a value.
pub(in crate::tui) fn step_of(action: Action) -> Option<Press> {
    let press = |up, size| Some(Press { up, size });
    match action {
        Action::Left => press(false, Size::Plain),
        Action::Right => press(true, Size::Plain),
        Action::FarLeft => press(false, Size::Coarse),
        Action::FarRight => press(true, Size::Coarse),
        Action::FineLess => press(false, Size::Fine),
        Action::FineMore => press(true, Size::Fine),
        _ => None,
    }
}

fn in_variables(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if let Some(press) = step_of(action) {
        return Some(edit::step(app, press));
    }
    match action {
        Action::Enter => Some(open(app)),
        Action::Reset => Some(edit::reset(app)),
        Action::Mark => Some(runs::keys::pin_scene(app)),
        _ => None,
    }
}

/// Open the selected variable's field, or the list of its words; of two words, the other one is taken.
pub(in crate::tui) fn open(app: &mut App) -> Vec<Effect> {
    match &app.editor.variable().kind {
        Kind::Choice(choice) if choice.words.len() >= WORDS_LISTED => {
            app.dialog = Some(List::Words.at((choice.get)(&app.scene)));
            Vec::new()
        }
        Kind::Choice(_) | Kind::Switch { .. } => edit::step(app, Press::NEXT),
        Kind::Number(_) => {
            let row = pages::of(Tab::Run).rows(app).map_or(0, |rows| rows.selected);
            field::open(app, row)
        }
    }
}

fn in_runs(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Enter => Some(runs::keys::load(app)),
        Action::Mark if app.selected_run == 0 => Some(runs::keys::pin_scene(app)),
        Action::Mark => Some(runs::keys::unpin(app)),
        Action::ShowHide => Some(runs::keys::show_or_hide(app)),
        Action::Difference => charts::keys::act(app, action),
        Action::Sort => {
            let keys = app.compared_runs().keys();
            app.runs_sorted = app.runs_sorted.next(&keys);
            Some(Vec::new())
        }
        _ => None,
    }
}
