//! The input thread: keys, pastes and sizes from the terminal become messages.
//!
//! crossterm's reading never returns once the terminal is gone (crossterm issue 793: it retries for ever), so it has a thread
//! of its own that nobody waits for: the loop notices a hang-up by itself, and leaving the process ends this thread.
//!
//! It waits by crossterm's feature `use-dev-tty`. Without it crossterm is woken by what is new only, takes a kilobyte at a time,
//! and waits again with the rest unread: a long text that comes as keys (a paste in a terminal without bracketed paste) would
//! fill the line, and no further key could ever get through.

use std::sync::mpsc::Sender;
use std::thread;

use crossterm::event::{self, Event, KeyEventKind, MouseButton, MouseEvent, MouseEventKind};

use super::{Incoming, terminal};
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
                    let Some(incoming) = incoming_of(event) else {
                        continue;
                    };
                    if last_words.0.send(incoming).is_err() {
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
fn incoming_of(event: Event) -> Option<Incoming> {
    Some(Incoming::Message(match event {
        // Some terminals also report releases.
        Event::Key(key) if key.kind == KeyEventKind::Release => return None,
        Event::Key(key) => Message::Key(key),
        Event::Paste(text) => Message::Paste(text),
        Event::Resize(columns, rows) => {
            let (columns, rows) = terminal::usable(columns, rows);
            Message::Resize(columns, rows)
        }
        Event::Mouse(mouse) => return pointing(mouse),
        Event::FocusGained | Event::FocusLost => return None,
    }))
}

/// The left button and the wheel; other buttons are left to the terminal's own menus. What they point at only the loop knows,
/// which has the screen.
fn pointing(mouse: MouseEvent) -> Option<Incoming> {
    let used = match mouse.kind {
        MouseEventKind::Down(button) => button == MouseButton::Left,
        MouseEventKind::ScrollUp | MouseEventKind::ScrollDown => true,
        // Sideways would step values, which nobody means by brushing a touchpad.
        MouseEventKind::ScrollLeft
        | MouseEventKind::ScrollRight
        | MouseEventKind::Up(_)
        | MouseEventKind::Drag(_)
        | MouseEventKind::Moved => false,
    };
    used.then_some(Incoming::Mouse(mouse))
}

#[cfg(test)]
mod tests {
    use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

    use super::*;

    #[test]
    fn releases_are_not_keys() {
        let mut key = KeyEvent::new(KeyCode::Char('x'), KeyModifiers::NONE);
        let seen = incoming_of(Event::Key(key));
        assert!(matches!(seen, Some(Incoming::Message(Message::Key(seen))) if seen == key));
        key.kind = KeyEventKind::Repeat;
        assert!(incoming_of(Event::Key(key)).is_some());
        key.kind = KeyEventKind::Release;
        assert!(incoming_of(Event::Key(key)).is_none());
    }

    #[test]
    fn only_the_left_button_and_the_wheel_upward_and_downward_count() {
        let counts = |kind| {
            let mouse = MouseEvent { kind, column: 3, row: 4, modifiers: KeyModifiers::NONE };
            matches!(incoming_of(Event::Mouse(mouse)), Some(Incoming::Mouse(seen)) if seen == mouse)
        };
        assert!(counts(MouseEventKind::Down(MouseButton::Left)));
        assert!(counts(MouseEventKind::ScrollUp) && counts(MouseEventKind::ScrollDown));
        assert!(!counts(MouseEventKind::Down(MouseButton::Right)));
        assert!(!counts(MouseEventKind::ScrollLeft) && !counts(MouseEventKind::Moved));
    }
}
