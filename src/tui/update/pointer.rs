//! The mouse, where the person has let the program have it: a click selects what it hits, a click on what is selected does
//! what Enter does there, and the wheel moves what it is over.

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::{Action, Pane};
use crate::tui::message::{Effect, Target};
use crate::tui::pages::explore;
use crate::tui::update::act;
use crate::tui::{dialogs, pages};

/// A click.
pub(in crate::tui) fn click(app: &mut App, target: Target) -> Vec<Effect> {
    app.notice = None;
    if app.dialog.is_some() {
        return dialogs::list::click(app, target);
    }
    if is_typing(app) {
        app.say(Severity::Note, "a field is open: Enter takes it, Esc leaves it as it was");
        return Vec::new();
    }
    app.history.commit();
    match target {
        Target::Tab(tab) => return act::go_to(app, tab),
        Target::Page(page) => return pages::of(app.tab).turn_to(app, page),
        Target::Variable(index) => {
            if app.pane() == Pane::Variables && app.editor.selected == index {
                return act::act(app, Action::Enter);
            }
            app.focus_on(Pane::Variables);
            app.editor.selected = index;
        }
        Target::Time { chart, t_s } => {
            app.focus_on(Pane::Charts);
            app.charts.selected = chart;
            app.charts.cursor_s = Some(t_s);
        }
        Target::Run(run) => return choose_run(app, run),
        Target::Event(event) => {
            app.focus_on(Pane::Charts);
            app.place_at_event(event);
        }
        Target::Pane(pane) => app.focus_on(pane),
        Target::Setup(_) | Target::SearchSetup(_) => return in_form(app, target),
        Target::Point(point) => {
            app.focus_on(Pane::Explore);
            explore::keys::jump(app, point);
        }
        Target::RunTime(run_time_s) => app.accuracy.place_cursor(run_time_s),
        Target::Method(method) => {
            if app.accuracy.selected == Some(method) {
                return act::act(app, Action::ShowHide);
            }
            app.accuracy.selected = Some(method);
        }
        Target::Cell(row, column) => app.stability.cursor = Some((row, column)),
        Target::Row(row) => return pick(app, row),
        Target::Shot(shot) => {
            app.focus_on(Pane::Residual);
            app.limit.cursor = Some(shot);
        }
        Target::Efficiency(x, y) => {
            app.focus_on(Pane::EfficiencyMap);
            app.limit.map_cursor = Some((x, y));
        }
        Target::Design(design) => {
            let again = app.pane() == Pane::Search && app.searching.selected() == design;
            app.focus_on(Pane::Search);
            if again {
                return act::act(app, Action::Enter);
            }
            app.searching.select(design);
        }
        // Without a dialog there is nothing of the kind.
        Target::DialogRow(_) | Target::Beside => {}
    }
    Vec::new()
}

/// A row of a form: selected, and opened where it was selected already.
fn in_form(app: &mut App, target: Target) -> Vec<Effect> {
    let before = (app.pane(), app.sweeping.row, app.searching.row);
    match target {
        Target::Setup(row) => {
            app.focus_on(Pane::ExploreSetup);
            app.sweeping.row = row;
        }
        Target::SearchSetup(row) => {
            app.focus_on(Pane::SearchSetup);
            app.searching.row = row;
        }
        _ => {}
    }
    let again = before == (app.pane(), app.sweeping.row, app.searching.row);
    if again { act::act(app, Action::Enter) } else { Vec::new() }
}

/// A row of the table of runs: selected, and loaded where it was selected already.
fn choose_run(app: &mut App, run: usize) -> Vec<Effect> {
    if app.pane() == Pane::Runs && app.selected_run == run {
        return act::act(app, Action::Enter);
    }
    app.focus_on(Pane::Runs);
    app.selected_run = run;
    Vec::new()
}

/// A row of the list that the tab shows: selected, and opened where it was selected already.
fn pick(app: &mut App, row: usize) -> Vec<Effect> {
    if app.pane() == Pane::Battery {
        app.stability.selected = row;
    } else if app.pick_in_thesis(row) {
        return act::act(app, Action::Enter);
    }
    Vec::new()
}

/// The wheel, upward or downward, over something or over nothing in particular.
pub(in crate::tui) fn wheel(app: &mut App, up: bool, target: Option<Target>) -> Vec<Effect> {
    if is_typing(app) {
        return Vec::new();
    }
    match target {
        Some(Target::Time { chart, t_s }) => {
            app.focus_on(Pane::Charts);
            app.charts.selected = chart;
            app.charts.cursor_s = Some(t_s);
            return act::act(app, if up { Action::ZoomIn } else { Action::ZoomOut });
        }
        Some(Target::Variable(_)) => app.focus_on(Pane::Variables),
        Some(Target::Setup(_)) => app.focus_on(Pane::ExploreSetup),
        Some(Target::SearchSetup(_)) => app.focus_on(Pane::SearchSetup),
        Some(Target::Run(_)) => app.focus_on(Pane::Runs),
        Some(Target::Pane(pane)) => app.focus_on(pane),
        Some(Target::Design(_)) => app.focus_on(Pane::Search),
        Some(Target::Point(_)) => app.focus_on(Pane::Explore),
        Some(Target::RunTime(run_time_s)) => {
            app.accuracy.place_cursor(run_time_s);
            return act::act(app, if up { Action::ZoomIn } else { Action::ZoomOut });
        }
        Some(_) | None => {}
    }
    let action = match (app.pane(), up) {
        (Pane::Residual, true) => Action::Left,
        (Pane::Residual, false) => Action::Right,
        (_, true) => Action::Up,
        (_, false) => Action::Down,
    };
    act::act(app, action)
}

/// Whether a text is being typed: no click may take it away.
fn is_typing(app: &App) -> bool {
    app.is_typing() || app.find.field.is_some()
}
