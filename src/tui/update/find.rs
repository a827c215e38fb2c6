//! `/`: the field that finds in the pane that has the keys. Lists of variables, claims and messages show only what matches; in
//! other lists the selection goes to the best match.

use crossterm::event::{KeyCode, KeyEvent};

use crate::study::principles::PRINCIPLES;
use crate::study::screening::CRITERIA;
use crate::tui::app::App;
use crate::tui::app::find::{rank, ranked};
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Pane;
use crate::tui::message::Effect;
use crate::tui::pages::explore::state::SetupRow;
use crate::tui::widgets::input::TextField;

/// Open the field, with the text the list is filtered by.
pub(in crate::tui) fn open(app: &mut App) {
    let text = match app.pane() {
        Pane::Variables => app.editor.filter.clone(),
        Pane::Claims => app.find.claims.clone(),
        Pane::Log => app.find.log.clone(),
        Pane::Runs
        | Pane::ExploreSetup
        | Pane::SearchSetup
        | Pane::Accuracy
        | Pane::Battery
        | Pane::Principles
        | Pane::Screening => String::new(),
        _ => {
            app.say(Severity::Note, "nothing to find in this pane: / works in its lists and forms");
            return;
        }
    };
    app.find.field = Some(TextField::new(text));
}

/// A key while it is open: the list follows every character.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match key.code {
        KeyCode::Esc => {
            app.find.field = None;
            clear(app);
        }
        KeyCode::Enter | KeyCode::Tab => app.find.field = None,
        KeyCode::Up | KeyCode::Down => {
            let by = if key.code == KeyCode::Up { -1 } else { 1 };
            match app.pane() {
                Pane::Variables => app.editor.move_by(&app.scene, by),
                Pane::Claims => app.move_in_thesis(by),
                _ => {}
            }
        }
        _ => {
            if app.find.field.as_mut().is_some_and(|field| field.press(key)) {
                follow(app);
            }
        }
    }
    Vec::new()
}

/// Show what matches the text in the field.
pub(in crate::tui) fn follow(app: &mut App) {
    let Some(text) = app.find.field.as_ref().map(|field| field.value().to_owned()) else { return };
    match app.pane() {
        Pane::Variables => app.editor.set_filter(&app.scene, &text),
        Pane::Claims => {
            app.find.claims = text;
            app.thesis.selected = 0;
        }
        Pane::Log => {
            app.find.log = text;
            app.log_scroll = 0;
        }
        _ if text.trim().is_empty() => {}
        _ => select(app, &text),
    }
}

/// Take a filter off the pane that has the keys; whether there was one.
pub(in crate::tui) fn clear(app: &mut App) -> bool {
    let filter = match app.pane() {
        Pane::Variables => &mut app.editor.filter,
        Pane::Claims => &mut app.find.claims,
        Pane::Log => &mut app.find.log,
        _ => return false,
    };
    if filter.is_empty() {
        return false;
    }
    filter.clear();
    true
}

/// The place of the best match among some names.
fn best(text: &str, names: impl Iterator<Item = String>) -> Option<usize> {
    ranked(names.enumerate(), |(_, name)| rank(text, &[name], "")).first().map(|(at, _)| *at)
}

fn select(app: &mut App, text: &str) {
    match app.pane() {
        Pane::Runs => {
            let names = app.pins.iter().map(|pin| format!("{} {}", pin.letter, pin.name));
            if let Some(at) = best(text, std::iter::once("now".to_owned()).chain(names)) {
                app.selected_run = at;
            }
        }
        Pane::ExploreSetup => {
            let picture = app.picture();
            let rows: Vec<SetupRow> = app.setup_choices(picture);
            let names = rows.iter().map(|row| app.setup_shown(picture, *row, 10).label);
            if let Some(at) = best(text, names) {
                app.sweeping.row = rows[at];
            }
        }
        Pane::SearchSetup => {
            let rows = app.search_rows();
            if let Some(at) = best(text, rows.iter().map(|row| app.search_shown(*row).0)) {
                app.searching.row = rows[at];
            }
        }
        Pane::Accuracy => {
            let names = crate::study::accuracy::method::Method::ALL.map(|it| it.name().to_owned());
            if let Some(at) = best(text, names.into_iter()) {
                app.accuracy.selected = Some(at);
            }
        }
        Pane::Battery => {
            let names = app.stability.rows().iter().map(|row| row.case.name.to_string());
            if let Some(at) = best(text, names) {
                app.stability.selected = at;
            }
        }
        Pane::Principles => {
            let names = PRINCIPLES.iter().map(|it| format!("{} {}", it.name, it.family));
            if let Some(at) = best(text, names) {
                app.thesis.principle = at;
            }
        }
        _ => {
            if let Some(at) = best(text, CRITERIA.iter().map(|name| (*name).to_owned())) {
                app.thesis.criterion = at;
            }
        }
    }
}
