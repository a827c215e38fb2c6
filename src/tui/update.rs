//! What each message does to the state, and what it asks the outside to do. No I/O, no clock.

use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use crate::tui::app::accuracy::Measuring;
use crate::tui::app::layout::Body;
use crate::tui::app::notice::{Notice, Severity};
use crate::tui::app::{App, Tab};
use crate::tui::message::{self, Action, Effect, Message, Place};
use crate::worker::studies::StudyReport;

mod accuracy;
mod act;
mod charts;
mod curve;
mod dialogs;
pub(super) mod done;
mod edit;
mod export;
mod field;
mod input;
mod jobs;
mod limit;
mod path;
mod pointer;
mod runs;
mod search;
mod setup;
mod stability;
mod sweep;
mod table;
mod thesis;

/// What to ask for first: a run of the scene and of the pins, and the list of presets.
pub fn start(app: &mut App) -> Vec<Effect> {
    let mut effects = jobs::submit_now(app);
    effects.extend(jobs::submit_pins(app));
    effects.push(Effect::ListPresets);
    effects
}

/// Change the state by a message.
pub fn update(app: &mut App, message: Message) -> Vec<Effect> {
    match message {
        Message::Key(key) if key.kind == KeyEventKind::Release => Vec::new(),
        Message::Key(key) => press(app, key),
        Message::Resize(width, height) => {
            app.size = (width, height);
            Vec::new()
        }
        Message::Paste(_) | Message::Wheel(..) if app.layout().body == Body::TooSmall => Vec::new(),
        Message::Paste(text) => input::paste(app, &text),
        Message::Click(target) => pointer::click(app, target),
        Message::Wheel(up, target) if app.dialog.is_none() => pointer::wheel(app, up, target),
        Message::Wheel(up, _) => {
            let code = if up { KeyCode::Up } else { KeyCode::Down };
            press(app, KeyEvent::new(code, KeyModifiers::NONE))
        }
        Message::Act(action) => act::act(app, action),
        Message::Report(report) => jobs::report(app, report),
        Message::Study(report) => studied(app, report),
        Message::Sweep(report) => {
            sweep::report(app, report);
            Vec::new()
        }
        Message::RunDue(serial) => jobs::run_due(app, serial),
        Message::LongJob(id) => {
            jobs::long(app, id);
            Vec::new()
        }
        Message::Done(report) => done::done(app, report),
        Message::Logged(level, text) => {
            app.note(level, text);
            Vec::new()
        }
    }
}

/// A report of a study goes to the tab that asked for it; those of replaced ones are dropped.
fn studied(app: &mut App, report: StudyReport) -> Vec<Effect> {
    let of = |study: &Option<Measuring>| study.as_ref().is_some_and(|it| it.id == report.id);
    if of(&app.accuracy.measuring) {
        accuracy::report(app, report.body);
    } else if of(&app.stability.mapping) || of(&app.stability.running) {
        stability::report(app, report);
    } else if of(&app.thesis.running) {
        thesis::report(app, report.body);
    } else if of(&app.limit.finding) {
        limit::report(app, report.body);
    } else if of(&app.searching.running) {
        search::report(app, report.body);
    }
    Vec::new()
}

fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    app.notice = None;
    if let Some(effects) = everywhere(app, key) {
        return effects;
    }
    if app.layout().body == Body::TooSmall {
        return unseen(app, key);
    }
    if app.dialog.is_some() {
        return dialogs::press(app, key);
    }
    if app.editor.field.is_some() {
        return field::press(app, key);
    }
    if app.editor.filter_field.is_some() {
        return field::press_in_filter(app, key);
    }
    if app.sweeping.field.is_some() && app.picture().is_some() {
        return setup::press(app, key);
    }
    if app.searching.field.is_some() && app.tab == Tab::Search {
        return search::press(app, key);
    }
    if let Some(action) = message::action_for(app.place(), key) {
        return act::act(app, action);
    }
    app.history.seal();
    app.hint(key);
    Vec::new()
}

/// On a screen too small to show anything, keys only lead out: nobody edits what cannot be seen.
fn unseen(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match message::action_for(Place::Anywhere, key) {
        Some(action @ (Action::Quit | Action::QuitWithSummary)) => act::act(app, action),
        Some(_) | None => Vec::new(),
    }
}

/// Keys that do the same with a field or dialog open.
fn everywhere(app: &mut App, key: KeyEvent) -> Option<Vec<Effect>> {
    if key.modifiers != KeyModifiers::CONTROL {
        return None;
    }
    match key.code {
        KeyCode::Char('z') => Some(vec![Effect::Suspend]),
        KeyCode::Char('l') => Some(vec![Effect::Redraw]),
        KeyCode::Char('c') if app.jobs.current.is_none() && close_top(app) => Some(Vec::new()),
        KeyCode::Char('c') => Some(act::act(app, Action::Cancel)),
        _ => None,
    }
}

/// Close the dialog or field on top; whether there was one.
fn close_top(app: &mut App) -> bool {
    let open = app.dialog.take().is_some();
    let field = app.editor.field.take().is_some();
    let filter = app.editor.filter_field.take().is_some();
    let setup = app.sweeping.field.take().is_some();
    let search = app.searching.field.take().is_some();
    open || field || filter || setup || search
}

impl App {
    /// Say that a key does nothing here, where a person may have expected something.
    fn hint(&mut self, key: KeyEvent) {
        let pressed = match key.code {
            KeyCode::Char(_) => message::Key(key.code, KeyModifiers::NONE),
            KeyCode::Enter | KeyCode::PageUp | KeyCode::PageDown | KeyCode::Delete => {
                message::Key(key.code, key.modifiers)
            }
            _ => return,
        };
        if !key.modifiers.difference(KeyModifiers::SHIFT).is_empty() {
            return;
        }
        let word = pressed.words();
        let works_in = |place: Place| {
            message::BINDINGS.iter().any(|row| row.place == place && row.keys.contains(&pressed))
        };
        let elsewhere = self.panes().iter().find(|place| works_in(**place));
        let text = match (key.code, elsewhere) {
            (KeyCode::Char(c), _) if c.is_ascii_digit() && self.place() == Place::Variables => {
                format!("no tab has the number {c}: Enter opens the value to type it")
            }
            (_, Some(place)) => {
                format!("`{word}` does nothing here, but in {}: Tab goes there", place.words())
            }
            (_, None) => format!("`{word}` does nothing here: ? lists the keys"),
        };
        self.notice = Some(Notice { severity: Severity::Note, text });
    }
}
