//! What each message does to the state, and what it asks the outside to do. No I/O, no clock.

use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use crate::tui::app::App;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::layout::Body;
use crate::tui::app::notice::{Notice, Severity};
use crate::tui::keymap::{Action, Key, Pane, works_in};
use crate::tui::message::{Effect, Message};
use crate::tui::pages;
use crate::worker::studies::StudyReport;

pub(super) mod accuracy;
mod act;
mod charts;
mod curve;
mod dialogs;
pub(super) mod done;
mod edit;
mod export;
mod field;
mod find;
mod input;
mod jobs;
pub(super) mod limit;
pub(super) mod log;
mod options;
mod palette;
mod path;
mod pointer;
pub(super) mod run;
mod runs;
pub(super) mod search;
mod setup;
pub(super) mod stability;
pub(super) mod sweep;
mod table;
pub(super) mod thesis;

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
    } else if of(&app.limit.comparing) {
        limit::report_comparison(app, report.body);
    } else if of(&app.searching.running) {
        search::report(app, report.body);
    }
    Vec::new()
}

fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    app.notice = None;
    let action = app.keymap.action(key);
    if let Some(effects) = everywhere(app, action) {
        return effects;
    }
    if app.layout().body == Body::TooSmall {
        return unseen(app, action);
    }
    if app.dialog.is_some() {
        return dialogs::press(app, key);
    }
    if app.find.field.is_some() {
        return find::press(app, key);
    }
    if app.is_typing() {
        return match app.pane() {
            Pane::Variables => field::press(app, key),
            Pane::ExploreSetup => setup::press(app, key),
            _ => search::press(app, key),
        };
    }
    if let Some(action) = action.filter(|action| works_in(*action, app.pane())) {
        return act::act(app, action);
    }
    app.history.commit();
    app.hint(key);
    Vec::new()
}

/// On a screen too small to show anything, keys only lead out: nobody edits what cannot be seen.
fn unseen(app: &mut App, action: Option<Action>) -> Vec<Effect> {
    match action {
        Some(action @ (Action::Quit | Action::QuitWithSummary)) => act::act(app, action),
        Some(_) | None => Vec::new(),
    }
}

/// Keys that do the same with a field or dialog open.
fn everywhere(app: &mut App, action: Option<Action>) -> Option<Vec<Effect>> {
    match action? {
        Action::Suspend => Some(vec![Effect::Suspend]),
        Action::Redraw => Some(vec![Effect::Redraw]),
        Action::Cancel if app.jobs.current.is_none() && close_top(app) => Some(Vec::new()),
        Action::Cancel => Some(act::act(app, Action::Cancel)),
        _ => None,
    }
}

/// Close the dialog or field on top; whether there was one.
fn close_top(app: &mut App) -> bool {
    let open = app.dialog.take().is_some();
    let field = app.editor.field.take().is_some();
    let find = app.find.field.take().is_some();
    let setup = app.sweeping.field.take().is_some();
    let search = app.searching.field.take().is_some();
    open || field || find || setup || search
}

impl App {
    /// Whether a value is being typed in the pane that has the keys.
    pub fn is_typing(&self) -> bool {
        match self.pane() {
            Pane::Variables => self.editor.field.is_some(),
            Pane::ExploreSetup => self.sweeping.field.is_some(),
            Pane::SearchSetup => self.searching.field.is_some(),
            _ => false,
        }
    }

    /// Say that a key does nothing here, where a person may have expected something.
    fn hint(&mut self, key: KeyEvent) {
        let is_key = matches!(
            key.code,
            KeyCode::Char(_)
                | KeyCode::Enter
                | KeyCode::PageUp
                | KeyCode::PageDown
                | KeyCode::Delete
        );
        if !is_key || !key.modifiers.difference(KeyModifiers::SHIFT).is_empty() {
            return;
        }
        let label = Key::of(key).label();
        let action = self.keymap.action(key);
        let works = |pane: &&Pane| action.is_some_and(|action| works_in(action, **pane));
        let elsewhere = pages::of(self.tab).panes(self).iter().find(works);
        let text = match (key.code, elsewhere) {
            (KeyCode::Char(c), _) if c.is_ascii_digit() && self.pane() == Pane::Variables => {
                format!("no tab has the number {c}: Enter opens the value to type it")
            }
            (_, Some(pane)) if *pane != self.pane() => {
                format!("`{label}` does nothing here, but in {}: Tab goes there", pane.label())
            }
            (_, _) => format!("`{label}` does nothing here: ? lists the keys"),
        };
        self.notice = Some(Notice { severity: Severity::Note, text });
    }
}
