//! The input thread: keys, pastes and sizes from the terminal become messages.
//!
//! crossterm's reading never returns once the terminal is gone (crossterm issue 793: it retries for ever), so it has a thread
//! of its own that nobody waits for: the loop notices a hang-up by itself, and leaving the process ends this thread.
//!
//! It waits by crossterm's feature `use-dev-tty`. Without it crossterm is woken by what is new only, takes a kilobyte at a time,
//! and waits again with the rest unread: a long text that comes as keys (a paste in a terminal without bracketed paste) would
//! fill the line, and no further key could ever get through.

use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::Sender;
use std::thread;

use crossterm::event::{self, Event, KeyEventKind, MouseButton, MouseEvent, MouseEventKind};

use super::{Incoming, terminal};
use crate::tui::message::{EffectReport, Message};

/// Panics in a row, without an event between them, after which reading is given up.
const PANICS_MAX: usize = 16;

/// What a person is told when reading panicked.
const RESTARTED: &str = "internal error while reading keys: reading was restarted, the last keys may be lost (see the log)";

/// Start the thread. It reports [`Incoming::InputLost`] when it ends, whatever the reason.
///
/// # Errors
/// When the system has no thread to give.
pub(super) fn spawn(inbox: Sender<Incoming>) -> io::Result<()> {
    let reading = move || {
        listen(&inbox, event::read);
        // The loop may be over already.
        let _ = inbox.send(Incoming::InputLost);
    };
    thread::Builder::new().name("input".to_owned()).spawn(reading).map(drop)
}

/// Pass events on until reading fails, panics again and again, or the loop is over. A panic costs the bytes that had been read.
fn listen(inbox: &Sender<Incoming>, mut read: impl FnMut() -> io::Result<Event>) {
    let mut panics = 0;
    while panics < PANICS_MAX {
        let incoming = match panic::catch_unwind(AssertUnwindSafe(&mut read)) {
            Err(_panic) => {
                panics += 1;
                let report = EffectReport::Warned(RESTARTED.to_owned());
                Some(Incoming::Message(Message::Done(report)))
            }
            Ok(Ok(event)) => {
                panics = 0;
                incoming_of(event)
            }
            Ok(Err(error)) => {
                log::warn!("reading from the terminal failed: {error}");
                return;
            }
        };
        if incoming.is_some_and(|incoming| inbox.send(incoming).is_err()) {
            return;
        }
    }
    log::error!("reading from the terminal failed {PANICS_MAX} times in a row");
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
    // A terminal counts from one; one that sends a zero has clicked nowhere, and crossterm makes 65535 of it.
    let place = (mouse.column, mouse.row);
    (used && place == terminal::usable(mouse.column, mouse.row)).then_some(Incoming::Mouse(mouse))
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
    fn a_panic_of_the_parser_is_reported_and_reading_goes_on() {
        let (send, inbox) = std::sync::mpsc::channel();
        let key = Event::Key(KeyEvent::new(KeyCode::Char('x'), KeyModifiers::NONE));
        let mut turn = 0;
        listen(&send, || {
            turn += 1;
            match turn {
                1 => panic!("the parser"),
                2 => Ok(key.clone()),
                _ => Err(io::ErrorKind::NotConnected.into()),
            }
        });
        let reported = inbox.recv().unwrap();
        assert!(
            matches!(reported, Incoming::Message(Message::Done(EffectReport::Warned(text))) if text == RESTARTED)
        );
        assert!(matches!(inbox.recv().unwrap(), Incoming::Message(Message::Key(_))));
        // One that panics for ever does not keep a core busy for ever.
        let mut turns = 0;
        listen(&send, || {
            turns += 1;
            panic!("the parser")
        });
        assert_eq!(turns, PANICS_MAX);
    }

    #[test]
    fn a_click_nowhere_is_not_one() {
        let kind = MouseEventKind::Down(MouseButton::Left);
        let seen = |column, row| {
            incoming_of(Event::Mouse(MouseEvent {
                kind,
                column,
                row,
                modifiers: KeyModifiers::NONE,
            }))
        };
        assert!(seen(u16::MAX, 4).is_none() && seen(4, u16::MAX).is_none());
        assert!(seen(0, 0).is_some());
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
