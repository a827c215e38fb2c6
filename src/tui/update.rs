//! What each message does to the state, and what it asks the outside to do. No I/O, no clock.

use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use crate::tui::app::App;
use crate::tui::app::notice::{Notice, Severity};
use crate::tui::keymap::{Action, Key, PaneSpec, Part};
use crate::tui::message::{Effect, Message};
use crate::tui::widgets::input::TEXT_MAX;
use crate::tui::{dialogs, pages};

pub(in crate::tui) mod act;
pub(in crate::tui) mod done;
pub(in crate::tui) mod edit;
pub(in crate::tui) mod field;
pub(in crate::tui) mod find;
pub(in crate::tui) mod jobs;
mod pointer;
pub(in crate::tui) mod zoom;

/// What to ask for first: a run of the scene and of the pins, and the list of presets.
pub fn start(app: &mut App) -> Vec<Effect> {
    let mut effects = jobs::submit_now(app);
    effects.extend(jobs::submit_pins(app));
    effects.push(app.list_presets());
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
        Message::Paste(_) | Message::Wheel(..) if app.layout().body.is_none() => Vec::new(),
        Message::Paste(text) => paste(app, &text),
        Message::Click(target) => pointer::click(app, target),
        Message::Wheel(up, target) if app.dialog.is_none() => pointer::wheel(app, up, target),
        Message::Wheel(up, _) => {
            let code = if up { KeyCode::Up } else { KeyCode::Down };
            press(app, KeyEvent::new(code, KeyModifiers::NONE))
        }
        Message::Act(action) => act::act(app, action),
        Message::Report(report) => jobs::report(app, report),
        Message::RunDue(serial) => jobs::run_due(app, serial),
        Message::LongJob(id) => {
            app.jobs.long.push(id);
            Vec::new()
        }
        Message::Done(report) => done::done(app, report),
        Message::Logged(level, text) => {
            app.note(level, text);
            Vec::new()
        }
    }
}

fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    app.notice = None;
    let action = app.keymap.action(key);
    if let Some(effects) = everywhere(app, action) {
        return effects;
    }
    if app.layout().body.is_none() {
        return unseen(app, action);
    }
    if app.dialog.is_some() {
        return dialogs::list::press(app, key);
    }
    if app.find.field.is_some() {
        return find::press(app, key);
    }
    if app.field.is_some() {
        return field::press(app, key);
    }
    if let Some(action) = action.filter(|action| pages::spec(app.pane()).knows(*action)) {
        return act::act(app, action);
    }
    app.history.commit();
    app.hint(key);
    Vec::new()
}

/// Pasted text goes into the open field, without line breaks and control characters; else it is ignored with a note.
fn paste(app: &mut App, text: &str) -> Vec<Effect> {
    app.notice = None;
    let clean: String =
        text.trim().chars().filter(|c| !c.is_control()).take(TEXT_MAX + 1).collect();
    if clean.chars().count() > TEXT_MAX {
        let text = format!("pasted text is ignored: it is longer than {TEXT_MAX} characters");
        app.say(Severity::Warning, text);
        return Vec::new();
    }
    let field = match &mut app.dialog {
        Some(dialog) => dialog.field_mut(),
        None => app.field.as_mut().map(|field| &mut field.text).or(app.find.field.as_mut()),
    };
    match field {
        Some(field) => field.insert(&clean),
        None => app.say(
            Severity::Note,
            "pasted text is ignored here: open a field first (Enter on a variable)",
        ),
    }
    dialogs::list::after_typing(app);
    if app.dialog.is_none() {
        find::follow(app);
    }
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
    let field = app.field.take().is_some();
    let find = app.find.field.take().is_some();
    open || field || find
}

impl App {
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
        let here = pages::spec(self.pane());
        let works = |pane: &&PaneSpec| action.is_some_and(|action| pane.knows(action));
        let shown = pages::of(self.tab).shown_panes(self).into_iter().map(pages::spec);
        let elsewhere = shown.filter(|pane| pane.pane != here.pane).find(works);
        let text = match (key.code, elsewhere) {
            (KeyCode::Char(c), _) if c.is_ascii_digit() && here.has.contains(&Part::Form) => {
                format!("no tab has the number {c}: Enter opens the value to type it")
            }
            (_, Some(pane)) => {
                format!("`{label}` does nothing here, but in {}: Tab goes there", pane.label)
            }
            (_, _) => format!("`{label}` does nothing here: ? lists the keys"),
        };
        self.notice = Some(Notice { severity: Severity::Note, text });
    }
}
