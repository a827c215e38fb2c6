//! The input thread: keys, pastes and sizes from the terminal become messages.
//!
//! crossterm's reading never returns once the terminal is gone (crossterm issue 793: it retries for ever), so it has a thread
//! of its own that nobody waits for: the loop notices a hang-up by itself, and leaving the process ends this thread.

use std::sync::mpsc::Sender;
use std::thread;

use crossterm::event::{
    self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseEventKind,
};

use super::Incoming;
use crate::tui::message::Message;

/// Start the thread. It says [`Incoming::InputLost`] when it ends, whatever the reason.
///
/// # Errors
/// When the system has no thread to give.
pub(super) fn spawn(inbox: Sender<Incoming>) -> std::io::Result<()> {
    let reading = move || {
        let last_words = LastWords(inbox);
        loop {
            match event::read() {
                Ok(event) => {
                    let Some(message) = message_of(event) else {
                        continue;
                    };
                    if last_words.0.send(Incoming::Message(message)).is_err() {
                        return;
                    }
                }
                Err(error) => {
                    log::warn!("reading from the terminal failed: {error}");
                    return;
                }
            }
        }
    };
    thread::Builder::new().name("input".to_owned()).spawn(reading).map(drop)
}

/// Says that input is over, even when the thread panics.
struct LastWords(Sender<Incoming>);

impl Drop for LastWords {
    fn drop(&mut self) {
        // Nobody listens any more when the loop has ended first.
        let _ = self.0.send(Incoming::InputLost);
    }
}

/// What an event of the terminal means to the workbench.
fn message_of(event: Event) -> Option<Message> {
    match event {
        // Some terminals also report releases.
        Event::Key(key) => (key.kind != KeyEventKind::Release).then_some(Message::Key(key)),
        Event::Paste(text) => Some(Message::Paste(text)),
        Event::Resize(columns, rows) => Some(Message::Resize(columns, rows)),
        Event::Mouse(mouse) => wheel(mouse.kind),
        Event::FocusGained | Event::FocusLost => None,
    }
}

/// The wheel moves as the arrow keys do; buttons are left to the terminal's own menus.
fn wheel(kind: MouseEventKind) -> Option<Message> {
    let code = match kind {
        MouseEventKind::ScrollUp => KeyCode::Up,
        MouseEventKind::ScrollDown => KeyCode::Down,
        // Sideways would step values, which nobody means by brushing a touchpad.
        MouseEventKind::ScrollLeft
        | MouseEventKind::ScrollRight
        | MouseEventKind::Down(_)
        | MouseEventKind::Up(_)
        | MouseEventKind::Drag(_)
        | MouseEventKind::Moved => return None,
    };
    Some(Message::Key(KeyEvent::new(code, KeyModifiers::NONE)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn releases_are_not_keys() {
        let mut key = KeyEvent::new(KeyCode::Char('x'), KeyModifiers::NONE);
        assert!(matches!(message_of(Event::Key(key)), Some(Message::Key(seen)) if seen == key));
        key.kind = KeyEventKind::Repeat;
        assert!(message_of(Event::Key(key)).is_some());
        key.kind = KeyEventKind::Release;
        assert!(message_of(Event::Key(key)).is_none());
    }
}
