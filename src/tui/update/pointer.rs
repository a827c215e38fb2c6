//! The mouse, where the person has let the program have it: a click selects what it hits, a click on what is selected does
//! what Enter does there, and the wheel moves what it is over.

use super::{act, dialogs, sweep};
use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Tab};
use crate::tui::message::{Action, Effect, Place, Target};

/// A click.
pub(super) fn click(app: &mut App, target: Target) -> Vec<Effect> {
    app.notice = None;
    if app.dialog.is_some() {
        return dialogs::click(app, target);
    }
    if is_typing(app) {
        app.say(Severity::Note, "a field is open: Enter takes it, Esc leaves it as it was");
        return Vec::new();
    }
    app.history.seal();
    match target {
        Target::Tab(tab) => return act::act(app, action_of(tab)),
        Target::Variable(index) => {
            if app.focus == Place::Variables && app.editor.selected == index {
                return act::act(app, Action::Edit);
            }
            app.focus = Place::Variables;
            app.editor.selected = index;
        }
        Target::Time { chart, t_s } => {
            app.focus = Place::Charts;
            app.charts.selected = chart;
            app.charts.cursor_s = Some(t_s);
        }
        Target::Run(run) => return choose_run(app, run),
        Target::Event(event) => {
            app.focus = Place::Charts;
            app.place_at_event(event);
        }
        Target::Pane(place) => focus(app, place),
        Target::Setup(row) => {
            if app.sweeping.on_setup && app.sweeping.row == row {
                return act::act(app, Action::Edit);
            }
            app.sweeping.on_setup = true;
            app.sweeping.row = row;
        }
        Target::SearchSetup(row) => {
            if app.searching.on_setup && app.searching.row == row {
                return act::act(app, Action::Edit);
            }
            app.searching.on_setup = true;
            app.searching.row = row;
        }
        Target::Point(point) => {
            app.sweeping.on_setup = false;
            return sweep::jump(app, point);
        }
        Target::RunTime(run_time_s) => app.accuracy.place_cursor(run_time_s),
        Target::Method(method) => {
            if app.accuracy.selected == method {
                return act::act(app, Action::ShowHide);
            }
            app.accuracy.selected = method;
        }
        Target::Cell(row, column) => app.stability.cursor = Some((row, column)),
        Target::Row(row) => return pick(app, row),
        Target::Shot(shot) => app.limit.cursor = Some(shot),
        Target::Design(design) => {
            let again = !app.searching.on_setup && app.searching.selected() == design;
            app.searching.on_setup = false;
            if again {
                return act::act(app, Action::OpenDesign);
            }
            app.searching.select(design);
        }
        // Without a dialog there is nothing of the kind.
        Target::DialogRow(_) | Target::Beside => {}
    }
    Vec::new()
}

/// A row of the table of runs: selected, and adopted where it was selected already.
fn choose_run(app: &mut App, run: usize) -> Vec<Effect> {
    if app.focus == Place::Runs && app.selected_run == run {
        return act::act(app, Action::Adopt);
    }
    app.focus = Place::Runs;
    app.selected_run = run;
    Vec::new()
}

/// A row of the list that the tab shows: selected, and opened where it was selected already.
fn pick(app: &mut App, row: usize) -> Vec<Effect> {
    if app.tab == Tab::Stability {
        app.stability.selected = row;
    } else if app.thesis.pick(row) {
        return act::act(app, Action::OpenDesign);
    }
    Vec::new()
}

/// The wheel, upward or downward, over something or over nothing in particular.
pub(super) fn wheel(app: &mut App, up: bool, target: Option<Target>) -> Vec<Effect> {
    if is_typing(app) {
        return Vec::new();
    }
    match target {
        Some(Target::Time { chart, t_s }) => {
            app.focus = Place::Charts;
            app.charts.selected = chart;
            app.charts.cursor_s = Some(t_s);
            return act::act(app, if up { Action::ZoomIn } else { Action::ZoomOut });
        }
        Some(Target::Variable(_)) => app.focus = Place::Variables,
        Some(Target::Setup(_)) => app.sweeping.on_setup = true,
        Some(Target::SearchSetup(_)) => app.searching.on_setup = true,
        Some(Target::Run(_)) => app.focus = Place::Runs,
        Some(Target::Pane(place)) => focus(app, place),
        Some(Target::Design(_)) => app.searching.on_setup = false,
        Some(Target::Point(_)) => app.sweeping.on_setup = false,
        Some(Target::RunTime(run_time_s)) => {
            app.accuracy.place_cursor(run_time_s);
            return act::act(app, if up { Action::ZoomIn } else { Action::ZoomOut });
        }
        Some(_) | None => {}
    }
    let action = match (app.place(), up) {
        (Place::Search | Place::Limit, true) => Action::CursorLeft,
        (Place::Search | Place::Limit, false) => Action::CursorRight,
        (_, true) => Action::Up,
        (_, false) => Action::Down,
    };
    act::act(app, action)
}

/// Whether a text is being typed: no click may take it away.
fn is_typing(app: &App) -> bool {
    app.editor.field.is_some()
        || app.editor.filter_field.is_some()
        || (app.sweeping.field.is_some() && app.picture().is_some())
        || (app.searching.field.is_some() && app.tab == Tab::Search)
}

fn focus(app: &mut App, place: Place) {
    match place {
        Place::Search | Place::SearchSetup => {
            app.searching.on_setup = place == Place::SearchSetup;
        }
        Place::Setup | Place::Lines | Place::Surface => {
            app.sweeping.on_setup = place == Place::Setup;
        }
        _ => app.focus = place,
    }
}

fn action_of(tab: Tab) -> Action {
    match tab {
        Tab::Run => Action::TabRun,
        Tab::Sweep => Action::TabSweep,
        Tab::Surface => Action::TabSurface,
        Tab::Accuracy => Action::TabAccuracy,
        Tab::Stability => Action::TabStability,
        Tab::Log => Action::TabLog,
        Tab::Thesis => Action::TabThesis,
        Tab::Limit => Action::TabLimit,
        Tab::Search => Action::TabSearch,
    }
}
