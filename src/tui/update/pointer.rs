//! The mouse, where the person has let the program have it: a click selects what it hits, a click on what is selected does
//! what Enter does there, and the wheel moves what it is over.

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action;
use crate::tui::message::{Effect, Target};
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
        Target::Pane(pane) => app.focus_on(pane),
        Target::Row(pane, row) => {
            let had_keys = app.pane() == pane;
            app.focus_on(pane);
            let page = pages::of(app.tab);
            if had_keys && page.rows(app).is_some_and(|rows| rows.selected == row) {
                return act::act(app, page.second_click(app));
            }
            page.select(app, row);
        }
        Target::Cell(pane, cell) => {
            app.focus_on(pane);
            pages::of(app.tab).go_to_cell(app, cell);
        }
        Target::Value { pane, chart, value } => {
            app.focus_on(pane);
            pages::of(app.tab).go_to_value(app, chart, value);
        }
        // Without a dialog there is nothing of the kind.
        Target::DialogRow(_) | Target::Beside => {}
    }
    Vec::new()
}

/// The wheel, upward or downward, over something or over nothing in particular.
pub(in crate::tui) fn wheel(app: &mut App, up: bool, target: Option<Target>) -> Vec<Effect> {
    if is_typing(app) {
        return Vec::new();
    }
    match target {
        Some(Target::Value { pane, chart, value }) => {
            app.focus_on(pane);
            pages::of(app.tab).go_to_value(app, chart, value);
            return act::act(app, if up { Action::ZoomIn } else { Action::ZoomOut });
        }
        Some(Target::Row(pane, _) | Target::Cell(pane, _) | Target::Pane(pane)) => {
            app.focus_on(pane);
        }
        Some(_) | None => {}
    }
    if pages::of(app.tab).rows(app).is_some() {
        app.history.commit();
        act::move_by(app, if up { -1 } else { 1 });
        return Vec::new();
    }
    act::act(app, if up { Action::Up } else { Action::Down })
}

/// Whether a text is being typed: no click may take it away.
fn is_typing(app: &App) -> bool {
    app.field.is_some() || app.find.field.is_some()
}
