//! The input thread: keys, pastes and sizes from the terminal become messages.
//!
//! crossterm's reading never returns once the terminal is gone (crossterm issue 793: it retries for ever), so it has a thread
//! of its own that is never joined: the loop detects a hang-up by itself, and the end of the process ends this thread.
//!
//! It waits by crossterm's feature `use-dev-tty`. Without it crossterm is woken by what is new only, takes a kilobyte at a time,
//! and waits again with the rest unread: a long text that comes as keys (a paste in a terminal without bracketed paste) would
//! fill the line, and no further key could ever get through.

use std::collections::VecDeque;
use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use crossterm::event::{
    self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEvent,
    MouseEventKind,
};

use super::signals::{HUNG_UP, Signal};
use super::{Incoming, terminal};
use crate::tui::message::Message;

/// Start the thread. When it ends, whatever the reason, the terminal counts as gone.
pub(super) fn spawn(inbox: Sender<Incoming>) -> io::Result<()> {
    let reading = move || {
        // Whether more has come in the same read. Without any time crossterm does not look at what it has read already.
        let waits = || event::poll(Duration::from_millis(1)).unwrap_or(false);
        // A panic is in the log.
        let ended = panic::catch_unwind(AssertUnwindSafe(|| listen(&inbox, event::read, waits)));
        if let Ok(Err(error)) = ended {
            log::warn!("reading from the terminal failed: {error}");
        }
        // The loop may be over already.
        let _ = inbox.send(Incoming::Signal(Signal::End(HUNG_UP)));
    };
    thread::Builder::new().name("input".to_owned()).spawn(reading).map(drop)
}

/// Pass events on until reading fails or the loop is over.
fn listen(
    inbox: &Sender<Incoming>,
    mut read: impl FnMut() -> io::Result<Event>,
    mut waits: impl FnMut() -> bool,
) -> io::Result<()> {
    loop {
        let event = read()?;
        let follows = is_escape(&event) && waits();
        let mut events = VecDeque::from([event]);
        if follows {
            events.extend(after_escape(&mut read, &mut waits)?);
        }
        for incoming in events.into_iter().filter_map(incoming_of) {
            if inbox.send(incoming).is_err() {
                return Ok(());
            }
        }
    }
}

fn is_escape(event: &Event) -> bool {
    matches!(event, Event::Key(key) if key.code == KeyCode::Esc && key.modifiers.is_empty())
}

/// What came in the same read as an Esc. crossterm takes the two escapes of `Esc` and an arrow (`\x1b\x1b[D`) for one Esc and
/// leaves `[D` as letters; a person cannot type a bracket and a letter within one read, so they are the arrow again.
fn after_escape(
    read: &mut impl FnMut() -> io::Result<Event>,
    waits: &mut impl FnMut() -> bool,
) -> io::Result<VecDeque<Event>> {
    let mut events: VecDeque<Event> = VecDeque::new();
    let mut text = String::new();
    loop {
        let event = read()?;
        let letter = match event {
            Event::Key(KeyEvent { code: KeyCode::Char(c), modifiers, .. })
                if (modifiers - KeyModifiers::SHIFT).is_empty() =>
            {
                Some(c)
            }
            _ => None,
        };
        events.push_back(event);
        let Some(letter) = letter else { return Ok(events) };
        text.push(letter);
        if let Some(key) = arrow(&text) {
            return Ok([Event::Key(key)].into());
        }
        let may_become = matches!(text.as_bytes(), [b'[' | b'O', rest @ ..]
            if rest.iter().all(|byte| byte.is_ascii_digit() || *byte == b';'));
        if !may_become || text.len() > 6 || !waits() {
            return Ok(events);
        }
    }
}

/// The key of what follows the escape of a control sequence: `[D`, `[1;2D`, `[5~`.
fn arrow(text: &str) -> Option<KeyEvent> {
    let rest = text.strip_prefix(['[', 'O'])?;
    let (numbers, last) = rest.split_at_checked(rest.len().checked_sub(1)?)?;
    let (number, modifier) = numbers.split_once(';').unwrap_or((numbers, "1"));
    let code = match (last, number) {
        ("A", _) => KeyCode::Up,
        ("B", _) => KeyCode::Down,
        ("C", _) => KeyCode::Right,
        ("D", _) => KeyCode::Left,
        ("H", _) | ("~", "1" | "7") => KeyCode::Home,
        ("F", _) | ("~", "4" | "8") => KeyCode::End,
        ("Z", _) => KeyCode::BackTab,
        ("~", "3") => KeyCode::Delete,
        ("~", "5") => KeyCode::PageUp,
        ("~", "6") => KeyCode::PageDown,
        _ => return None,
    };
    let shift = if modifier == "2" { KeyModifiers::SHIFT } else { KeyModifiers::NONE };
    Some(KeyEvent::new(code, shift))
}

/// Translates an event of the terminal into a message.
fn incoming_of(event: Event) -> Option<Incoming> {
    Some(Incoming::Message(match event {
        // Some terminals also report releases.
        Event::Key(key) if key.kind == KeyEventKind::Release => return None,
        Event::Key(key) => Message::Key(key),
        Event::Paste(text) => Message::Paste(text),
        Event::Resize(..) => {
            let (columns, rows) = terminal::size().ok()?;
            Message::Resize(columns, rows)
        }
        Event::Mouse(mouse) => return pointing(mouse),
        Event::FocusGained | Event::FocusLost => return None,
    }))
}

/// The left button and the wheel; other buttons are left to the terminal's own menus. What they point at only the loop knows,
/// which has the screen.
fn pointing(mouse: MouseEvent) -> Option<Incoming> {
    // The wheel turned sideways would step values by mistake when a touchpad is brushed.
    let used = matches!(
        mouse.kind,
        MouseEventKind::Down(MouseButton::Left)
            | MouseEventKind::ScrollUp
            | MouseEventKind::ScrollDown
    );
    // A terminal counts from one; one that sends a zero has clicked nowhere, and crossterm makes 65535 of it.
    (used && mouse.column.max(mouse.row) < u16::MAX).then_some(Incoming::Mouse(mouse))
}

#[cfg(test)]
mod tests {
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

    /// `Esc` and an arrow in one read: the arrow is an arrow, not the letters of its sequence.
    #[test]
    fn an_arrow_in_the_same_read_as_an_escape_stays_an_arrow() {
        let press = |code| Event::Key(KeyEvent::new(code, KeyModifiers::NONE));
        let keys_of = |text: &str| {
            let (send, inbox) = std::sync::mpsc::channel();
            let mut rest: VecDeque<Event> = text
                .chars()
                .map(|c| press(if c == '\x1b' { KeyCode::Esc } else { KeyCode::Char(c) }))
                .collect();
            let left = std::cell::Cell::new(rest.len());
            let read = || {
                left.set(left.get().saturating_sub(1));
                rest.pop_front().ok_or_else(|| io::ErrorKind::NotConnected.into())
            };
            listen(&send, read, || left.get() > 0).unwrap_err();
            drop(send);
            let code = |incoming| match incoming {
                Incoming::Message(Message::Key(key)) => Some(key.code),
                _ => None,
            };
            inbox.iter().filter_map(code).collect::<Vec<_>>()
        };
        // crossterm has taken both escapes as one.
        assert_eq!(keys_of("\x1b[D"), [KeyCode::Esc, KeyCode::Left]);
        assert_eq!(keys_of("\x1b[5~"), [KeyCode::Esc, KeyCode::PageUp]);
        assert_eq!(keys_of("\x1b[1;2C"), [KeyCode::Esc, KeyCode::Right]);
        assert_eq!(keys_of("\x1bOA"), [KeyCode::Esc, KeyCode::Up]);
        assert_eq!(keys_of("\x1bj"), [KeyCode::Esc, KeyCode::Char('j')]);
        assert_eq!(keys_of("\x1b"), [KeyCode::Esc]);
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
