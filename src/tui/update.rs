//! State update for each message, and the resulting effects. No I/O, no clock.

pub(crate) mod act;

use crate::tui::pages::explore::cursor::chart_kind;
use crate::tui::pages::run::impact::stop_playing;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::files::preset;
use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::app::{ActiveInput, edit, jobs};
use crate::tui::keymap::Key;
use crate::tui::message::{EffectReport, ExportOutcome, Message};
use crate::tui::pages;
use crate::tui::pages::run::{self, impact};
use crate::tui::prelude::*;
use crate::tui::preset::ReferencePreset;
use crate::tui::widgets::input::{TEXT_MAX, TextField};
use crate::tui::widgets::value_steps::Input;
use cmra_engine::model::variables::VARIABLES;

/// Returns the first effects: a run of the scene and of the pins, and the list of presets.
pub fn start(app: &mut App) -> Vec<Effect> {
    jobs::run_now(app);
    jobs::submit_pins(app);
    app.list_presets();
    run::follow_traces(app);
    std::mem::take(&mut app.effects)
}

/// Updates the state with a message; returns the effects to perform.
pub fn update(app: &mut App, message: Message) -> Vec<Effect> {
    let picture = chart_kind(app);
    let is_by_person = matches!(
        message,
        Message::Key(_) | Message::Paste(_) | Message::Click(_) | Message::Wheel(..)
    );
    take(app, message);
    let is_edited = std::mem::take(&mut app.is_edited);
    if is_edited {
        jobs::after_edit(app);
    }
    if is_edited || chart_kind(app) != picture {
        pages::page(app.tab).edited(app);
    }
    run::follow_traces(app);
    if is_by_person || is_edited {
        pages::page(app.tab).await_rest(app);
    }
    keep_listed(app);
    std::mem::take(&mut app.effects)
}

fn take(app: &mut App, message: Message) {
    match message {
        Message::Key(key) => keys(app, key),
        Message::Resize(width, height) => app.size = (width, height),
        Message::Paste(_) | Message::Wheel(..) if app.layout().body.is_none() => {}
        Message::Paste(text) => paste(app, &text),
        Message::Click(target) => click(app, target),
        Message::Wheel(up, target) if app.dialog.is_none() => wheel(app, up, target),
        Message::Wheel(up, _) => {
            let code = if up { KeyCode::Up } else { KeyCode::Down };
            press(app, KeyEvent::new(code, KeyModifiers::NONE));
        }
        Message::Report(report) => {
            if let Some((running, body)) = jobs::report(app, report) {
                pages::page(running.tab).report(app, &running, &body);
            }
        }
        Message::RunDue(serial) => jobs::run_due(app, serial),
        Message::Rest(serial) if serial == app.jobs.rest => pages::page(app.tab).rested(app),
        Message::Rest(_) => {}
        Message::LongJob(id) => app.jobs.long.push(id),
        Message::Tick(serial) => impact::tick(app, serial),
        Message::Done(report) => done(app, report),
    }
}

/// Handles Alt and a key, which a terminal sends for Esc directly followed by a key.
fn keys(app: &mut App, key: KeyEvent) {
    jobs::end_looks(app);
    if !key.modifiers.contains(KeyModifiers::ALT) {
        return press(app, key);
    }
    press(app, KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
    press(app, KeyEvent::new(key.code, key.modifiers - KeyModifiers::ALT));
}

/// Returns the edited text if no dialog is open; `None` without one.
fn open_text(app: &mut App) -> Option<&mut TextField> {
    let (ActiveInput::Field(text) | ActiveInput::Find(text) | ActiveInput::Place(text)) =
        app.typing.as_mut()?;
    Some(text)
}

fn press(app: &mut App, key: KeyEvent) {
    app.notice = None;
    let action = app.keymap.action(key);
    // Every key ends the animation; `Back` and `Play` have no other effect then.
    if stop_playing(app) && matches!(action, Some(Action::Back | Action::Play)) {
        return;
    }
    if everywhere(app, action) {
        return;
    }
    if app.layout().body.is_none() {
        // On a screen that is too small, keys only quit, because edited values would be invisible.
        if action == Some(Action::Quit) {
            act::act(app, Action::Quit);
        }
        return;
    }
    if app.dialog.is_some() {
        return in_dialog(app, |dialog, app| dialog.press(app, key));
    }
    if app.find().is_some() {
        return in_find(app, key);
    }
    if app.field().is_some() {
        return in_field(app, key);
    }
    if app.place().is_some() {
        return in_place(app, key);
    }
    if let Some(action) = action.filter(|action| pages::spec(app.pane()).knows(*action)) {
        return act::act(app, action);
    }
    app.history.commit();
    act::does_nothing(app, &Key::from_event(key).label());
}

/// Inserts pasted text into the open field, without line breaks and control characters; otherwise ignores it with a note.
fn paste(app: &mut App, text: &str) {
    app.notice = None;
    let clean: String =
        text.trim().chars().filter(|c| !c.is_control()).take(TEXT_MAX + 1).collect();
    if clean.chars().count() > TEXT_MAX {
        let text = format!("pasted text is ignored: it is longer than {TEXT_MAX} characters");
        return app.say(Severity::Warning, text);
    }
    let is_taken = match &mut app.dialog {
        Some(dialog) => dialog.paste(&clean),
        None => open_text(app).map(|field| field.insert(&clean)).is_some(),
    };
    if !is_taken {
        app.report_progress(
            "pasted text is ignored here: open a field first (<enter> on a variable)",
        );
    } else if app.dialog.is_none() {
        follow(app);
    }
}

/// Runs a function on the open dialog and handles the outcome.
fn in_dialog(app: &mut App, does: impl FnOnce(&mut dyn Dialog, &mut App) -> Outcome) {
    let Some(mut dialog) = app.dialog.take() else { return };
    match does(&mut *dialog, app) {
        // The dialog may have opened another one.
        Outcome::Stays if app.dialog.is_none() => app.dialog = Some(dialog),
        Outcome::Stays | Outcome::Closes => {}
        Outcome::Calls(call) => act::call(app, call),
    }
}

/// Handles keys with the same effect in a field or dialog.
fn everywhere(app: &mut App, action: Option<Action>) -> bool {
    match action {
        Some(action @ (Action::Suspend | Action::Redraw | Action::Cancel)) => {
            let is_open = app.dialog.is_some() || app.typing.is_some();
            let closes = action == Action::Cancel && app.jobs.current.is_none() && is_open;
            if closes {
                (app.dialog, app.typing) = (None, None);
            }
            // While studies go on the key only closes; else it counts as the first of two that quit.
            if !closes || pages::all_jobs(app).next().is_none() {
                act::act(app, action);
            }
        }
        _ => return false,
    }
    true
}

pub(crate) fn in_field(app: &mut App, key: KeyEvent) {
    let then = match key.code {
        KeyCode::Esc => {
            app.typing = None;
            return;
        }
        KeyCode::Enter => None,
        KeyCode::Down => Some(Action::Down),
        KeyCode::Up => Some(Action::Up),
        KeyCode::Tab => Some(Action::FocusNext),
        KeyCode::BackTab => Some(Action::FocusPrevious),
        _ => {
            if let Some(text) = open_text(app) {
                text.press(key);
            }
            return;
        }
    };
    commit(app);
    if let Some(action) = then.filter(|_| app.field().is_none()) {
        act::act(app, action);
    }
}

/// Applies the typed text. A rejected text remains in the field with the reason; nothing else changes.
fn commit(app: &mut App) {
    let Some(mut field) = app.field().cloned() else { return };
    app.typing = None;
    let page = pages::page(app.tab);
    let text = field.value().trim().to_owned();
    if field.all_selected || !page.is_new(app, &text) {
        return;
    }
    let variable = page.field_quantity(app).and_then(|quantity| quantity.variable);
    let before = app.snapshot();
    if let Err(error) = page.change(app, Input::Text(&text)) {
        field.error = Some(error);
        app.typing = Some(ActiveInput::Field(field));
    } else if let Some(variable) = variable {
        let index = VARIABLES.iter().position(|it| it.key == variable.key).unwrap_or_default();
        edit::show_in_unit_of(app, index, &text, before);
    }
}

/// Handles a key in the field of the crosshair position. A rejected text remains with the reason.
fn in_place(app: &mut App, key: KeyEvent) {
    match key.code {
        KeyCode::Esc => app.typing = None,
        KeyCode::Enter => {
            let Some(mut field) = app.place().cloned() else { return };
            app.typing = None;
            let text = field.value().trim();
            if !text.is_empty()
                && let Err(error) = pages::page(app.tab).go_to_place(app, text)
            {
                field.error = Some(error);
                app.typing = Some(ActiveInput::Place(field));
            }
        }
        _ => {
            if let Some(text) = open_text(app) {
                text.press(key);
            }
        }
    }
}

/// Opens the search field with the present filter.
pub(crate) fn open_find(app: &mut App) {
    let page = pages::page(app.tab);
    let Some(text) = page.filter(app).map(|filter| filter.clone()) else {
        return app
            .report_progress("<find> works in the variables and the log; <palette> elsewhere");
    };
    // Typing replaces the old text.
    app.typing = Some(ActiveInput::Find(TextField::selected(text)));
}

/// Handles a key in the search field; the list is filtered after each character.
pub(crate) fn in_find(app: &mut App, key: KeyEvent) {
    match key.code {
        KeyCode::Esc => {
            app.typing = None;
            clear(app);
        }
        KeyCode::Enter | KeyCode::Tab => app.typing = None,
        KeyCode::Up => pages::move_by(app, -1),
        KeyCode::Down => pages::move_by(app, 1),
        _ => {
            if open_text(app).is_some_and(|field| field.press(key)) {
                follow(app);
            }
        }
    }
}

/// Filters the list by the text in the field.
pub(crate) fn follow(app: &mut App) {
    let Some(field) = app.find() else { return };
    let text = field.value().trim().to_owned();
    let page = pages::page(app.tab);
    let Some(filter) = page.filter(app) else { return };
    filter.clone_from(&text);
    if !text.is_empty() {
        page.select(app, 0);
    }
}

/// Returns `true` if the rows of the focused pane are filtered.
fn is_filtered(app: &mut App) -> bool {
    let filter = pages::page(app.tab).filter(app);
    filter.is_some_and(|filter| !filter.is_empty())
}

/// Returns `true` if no row of the focused pane matches its filter.
pub(crate) fn matches_nothing(app: &mut App) -> bool {
    is_filtered(app) && pages::page(app.tab).rows(app).is_some_and(|rows| rows.count == 0)
}

/// Moves the selection to a visible row if the filter or the rows have changed.
fn keep_listed(app: &mut App) {
    let page = pages::page(app.tab);
    if is_filtered(app)
        && let Some(rows) = page.rows(app)
        && let Some(last) = rows.count.checked_sub(1)
    {
        page.select(app, rows.selected.min(last));
    }
}

/// Removes the filter of the focused pane; returns whether there was one.
pub(crate) fn clear(app: &mut App) -> bool {
    let filter = pages::page(app.tab).filter(app);
    filter.is_some_and(|filter| !std::mem::take(filter).is_empty())
}

pub(crate) fn click(app: &mut App, target: Target) {
    app.notice = None;
    jobs::end_looks(app);
    if let Some(dialog) = &mut app.dialog {
        if let Target::DialogRow(row) = target {
            dialog.click(row);
        }
        return;
    }
    // A click does not discard typed text.
    if app.typing.is_some() {
        return app.report_progress("a field is open: Enter takes it, Esc leaves it as it was");
    }
    app.history.commit();
    if let Some(pane) = target.pane() {
        app.focus_on(pane);
        // A click that follows a key before the next frame may mean what is no longer shown.
        if app.pane() != pane {
            return;
        }
    }
    let page = pages::page(app.tab);
    match target {
        Target::Tab(tab) => act::go_to(app, tab),
        Target::Page(at) => page.turn_to(app, at),
        Target::Row(_, row) if page.rows(app).is_some_and(|rows| row < rows.count) => {
            page.select(app, row);
        }
        Target::Cell(_, cell) => page.go_to_cell(app, cell),
        Target::Value { chart, value, .. } => page.go_to_value(app, chart, value),
        Target::Row(..) | Target::Pane(_) | Target::DialogRow(_) => {}
    }
}

/// Handles the wheel, upward or downward, over a target or elsewhere.
pub(crate) fn wheel(app: &mut App, up: bool, target: Option<Target>) {
    if app.typing.is_some() {
        return;
    }
    if let Some(pane) = target.and_then(Target::pane) {
        app.focus_on(pane);
    }
    if pages::page(app.tab).rows(app).is_some() {
        app.history.commit();
        pages::move_by(app, if up { -1 } else { 1 });
    } else {
        act::act(app, if up { Action::Up } else { Action::Down });
    }
}

/// Handles the end of an effect, first in the dialog that requested it.
pub(crate) fn done(app: &mut App, report: EffectReport) {
    let dialog = app.dialog.as_mut();
    let outcome = dialog.and_then(|dialog| dialog.answered(&app.files.directory, &report));
    if outcome == Some(Outcome::Closes) {
        app.dialog = None;
    }
    // The dialog shows the result; another dialog may have been opened meanwhile.
    let is_heard = outcome.is_some();
    match report {
        EffectReport::Saved(name, ExportOutcome::Written(files)) => saved(app, name, &files),
        EffectReport::Exported(_, ExportOutcome::Written(files)) => {
            let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
            app.report_progress(format!("written: {}", names.join(" and ")));
        }
        EffectReport::Saved(_, outcome) | EffectReport::Exported(_, outcome) if !is_heard => {
            app.refuse(outcome.message());
        }
        EffectReport::Presets(list) => app.files.presets = list,
        EffectReport::Loaded(Ok((name, scene))) => {
            app.note_recent(Path::new(&name));
            let base = ReferencePreset { name, is_mine: false, scene: Arc::new(*scene) };
            let picture = chart_kind(app);
            edit::load(app, base, picture);
        }
        EffectReport::Loaded(Err(text)) => app.refuse(text),
        EffectReport::Traces(_, Ok(traces)) => run::lay_beside(app, traces),
        EffectReport::Traces(_, Err(why)) if !is_heard => app.refuse(why),
        EffectReport::Session(kept) => session(app, &kept),
        EffectReport::Said(severity, text) => app.say(severity, text),
        EffectReport::Saved(..) | EffectReport::Exported(..) | EffectReport::Traces(..) => {}
    }
}

/// Handles the result of saving the session: warns what quitting would lose and requires a confirmation.
pub(crate) fn session(app: &mut App, kept: &Result<(), String>) {
    match kept {
        Ok(()) => app.report_progress("the session is kept again"),
        Err(why) => {
            let text = format!("the session cannot be kept: {why}; <export> exports the table");
            app.say(Severity::Warning, text);
        }
    }
    app.files.session_lost = kept.is_err();
}

fn saved(app: &mut App, name: String, files: &[PathBuf]) {
    let Some(path) = files.first() else { return };
    app.report_progress(format!("saved {}", path.display()));
    let is_mine = !preset::is_path(&name);
    if !is_mine {
        app.note_recent(path);
    }
    app.base = ReferencePreset { name, is_mine, scene: Arc::clone(&app.scene) };
    app.list_presets();
    app.request(Effect::SaveSession);
}
