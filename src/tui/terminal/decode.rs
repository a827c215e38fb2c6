//! Bytes of the terminal to keys, pastes and clicks.
//!
//! A key may come in several packets, and a terminal also sends what is no key: answers to questions, of this program or of one
//! before it. A key is passed on when it is whole; anything else is swallowed to its end. Whether a lone escape is the key or the
//! beginning of a sequence, only time tells: the caller waits as long as [`Decoder::patience`] says, and calls [`Decoder::expire`]
//! when nothing has come. Knows no clock.

use std::time::Duration;

use crossterm::event::{
    KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};

/// The rest of a sequence may come so much later, on a line that falters.
const REST: Duration = Duration::from_millis(500);

/// A paste whose end does not come is over after this silence.
const PASTE_REST: Duration = Duration::from_secs(10);

/// More bytes than any sequence that is known here.
const LONGEST: usize = 64;

const PASTE_END: &[u8] = b"\x1b[201~";

/// What has come from the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::tui) enum Input {
    Key(KeyEvent),
    Paste(String),
    Mouse(MouseEvent),
    /// The answer to a request for a status report: all that was sent before the request has arrived.
    Arrived,
}

/// Where in a key or a sequence the bytes are.
#[derive(Clone, Debug, PartialEq, Eq)]
enum State {
    Ground,
    /// Some bytes of one character.
    Character(Vec<u8>),
    Escape,
    /// The bytes after `ESC [`.
    Control(Vec<u8>),
    /// After `ESC O`.
    Single,
    /// In a string that is of no interest, after this introducer (OSC, DCS, APC, PM, SOS); whether anything has followed it.
    Text(u8, bool),
    Paste(Vec<u8>),
    /// These bytes of an old mouse report, of three.
    Click(Vec<u8>),
    /// After `ESC [ [`: a function key of the Linux console.
    Console,
}

pub(in crate::tui) struct Decoder {
    state: State,
    /// How long a lone escape may be the beginning of a sequence.
    hold: Duration,
}

impl Decoder {
    pub(in crate::tui) fn new(hold: Duration) -> Self {
        Self { state: State::Ground, hold }
    }

    /// How long to wait for the next byte before calling [`Decoder::expire`]; `None`: for ever.
    pub(in crate::tui) fn patience(&self) -> Option<Duration> {
        match self.state {
            State::Ground => None,
            State::Escape => Some(self.hold),
            State::Paste(_) => Some(PASTE_REST),
            _ => Some(REST),
        }
    }

    /// Nothing more has come in time.
    pub(in crate::tui) fn expire(&mut self, out: &mut Vec<Input>) {
        match std::mem::replace(&mut self.state, State::Ground) {
            State::Escape => out.push(key(KeyCode::Esc)),
            // Esc and the next key, pressed at the same time.
            State::Control(rest) if rest.is_empty() => self.alt('[', out),
            State::Single => self.alt('O', out),
            State::Text(introducer, false) => self.alt(char::from(introducer), out),
            State::Paste(text) => out.push(paste(&text)),
            _ => {}
        }
    }

    /// Takes bytes as they have come, however many.
    pub(in crate::tui) fn feed(&mut self, bytes: &[u8], out: &mut Vec<Input>) {
        for byte in bytes {
            self.take(*byte, out);
        }
    }

    fn take(&mut self, byte: u8, out: &mut Vec<Input>) {
        match std::mem::replace(&mut self.state, State::Ground) {
            State::Ground => self.ground(byte, KeyModifiers::NONE, out),
            State::Character(bytes) => self.character(bytes, byte, out),
            State::Escape => self.after_escape(byte, out),
            State::Control(rest) => self.control(rest, byte, out),
            State::Single => self.single(byte, out),
            State::Text(introducer, _) => match byte {
                // Ended by BEL, ST (whose backslash comes as a sequence of its own), CAN or SUB.
                0x07 | 0x18 | 0x1a | 0x9c => {}
                0x1b => self.state = State::Escape,
                _ => self.state = State::Text(introducer, true),
            },
            State::Paste(mut text) => {
                text.push(byte);
                match text.strip_suffix(PASTE_END) {
                    Some(text) => out.push(paste(text)),
                    None => self.state = State::Paste(text),
                }
            }
            State::Click(mut bytes) => {
                bytes.push(byte);
                match bytes[..] {
                    [button, column, row] => {
                        let place = |byte: u8| u16::from(byte).checked_sub(0x20);
                        let button = button.wrapping_sub(0x20).into();
                        out.extend(click(button, place(column), place(row), true));
                    }
                    _ => self.state = State::Click(bytes),
                }
            }
            State::Console => {
                if let number @ b'A'..=b'E' = byte {
                    out.push(key(KeyCode::F(number - b'A' + 1)));
                }
            }
        }
    }

    fn ground(&mut self, byte: u8, modifiers: KeyModifiers, out: &mut Vec<Input>) {
        let control = |c: u8| (KeyCode::Char(char::from(c)), modifiers | KeyModifiers::CONTROL);
        let (code, modifiers) = match byte {
            0x1b => return self.state = State::Escape,
            b'\r' => (KeyCode::Enter, modifiers),
            b'\t' => (KeyCode::Tab, modifiers),
            0x7f => (KeyCode::Backspace, modifiers),
            0x00 => control(b' '),
            0x01..=0x1a => control(byte - 1 + b'a'),
            0x1c..=0x1f => control(byte - 0x1c + b'4'),
            b' '..=b'~' => return out.push(character(char::from(byte), modifiers)),
            0xc2..=0xf4 => return self.state = State::Character(vec![byte]),
            // The middle of a character whose beginning was lost, or no UTF-8 at all.
            _ => return,
        };
        out.push(Input::Key(KeyEvent::new(code, modifiers)));
    }

    fn character(&mut self, mut bytes: Vec<u8>, byte: u8, out: &mut Vec<Input>) {
        if !(0x80..0xc0).contains(&byte) {
            return self.ground(byte, KeyModifiers::NONE, out);
        }
        bytes.push(byte);
        match std::str::from_utf8(&bytes) {
            Ok(text) => out.extend(text.chars().map(|c| character(c, KeyModifiers::NONE))),
            Err(error) if error.error_len().is_none() => self.state = State::Character(bytes),
            Err(_) => {}
        }
    }

    fn after_escape(&mut self, byte: u8, out: &mut Vec<Input>) {
        match byte {
            b'[' => self.state = State::Control(Vec::new()),
            b'O' => self.state = State::Single,
            b']' | b'P' | b'X' | b'^' | b'_' => self.state = State::Text(byte, false),
            // Two escapes: the first is the key.
            0x1b => {
                out.push(key(KeyCode::Esc));
                self.state = State::Escape;
            }
            // The Linux console's Shift-Tab.
            b'\t' => out.push(key(KeyCode::BackTab)),
            // The end of a string.
            b'\\' => {}
            b' '..=b'~' | 0x7f => self.ground(byte, KeyModifiers::ALT, out),
            _ => {
                out.push(key(KeyCode::Esc));
                self.ground(byte, KeyModifiers::NONE, out);
            }
        }
    }

    fn alt(&mut self, c: char, out: &mut Vec<Input>) {
        out.push(character(c, KeyModifiers::ALT));
    }

    fn single(&mut self, byte: u8, out: &mut Vec<Input>) {
        match byte {
            0x1b => self.state = State::Escape,
            b'P'..=b'S' => out.push(key(KeyCode::F(byte - b'P' + 1))),
            // The keypad's keys.
            b'M' => out.push(key(KeyCode::Enter)),
            b'j'..=b'y' => out.push(character(char::from(byte - 0x40), KeyModifiers::NONE)),
            _ => out.extend(named(byte).map(key)),
        }
    }

    /// One more byte of a control sequence: parameters, then intermediates, then the final byte.
    fn control(&mut self, mut rest: Vec<u8>, byte: u8, out: &mut Vec<Input>) {
        match byte {
            0x1b => self.state = State::Escape,
            b'[' if rest.is_empty() => self.state = State::Console,
            b'M' if rest.is_empty() => self.state = State::Click(Vec::new()),
            // With Shift urxvt ends the number of a key in a `$`.
            b'$' if !rest.is_empty() && rest.iter().all(u8::is_ascii_digit) => {
                out.extend(numbered(&rest).map(|code| with(code, KeyModifiers::SHIFT)));
            }
            b' '..=b'?' => {
                // What is too long to be a key is swallowed all the same.
                if rest.len() < LONGEST {
                    rest.push(byte);
                }
                self.state = State::Control(rest);
            }
            b'@'..=b'~' if rest.as_slice() == b"200" && byte == b'~' => {
                self.state = State::Paste(Vec::new());
            }
            b'@'..=b'~' => out.extend(sequence(&rest, byte)),
            // No sequence: the byte is what it is by itself.
            0x00..=0x1f => self.ground(byte, KeyModifiers::NONE, out),
            _ => {}
        }
    }
}

/// What a control sequence stands for; `None`: nothing that is of interest here.
fn sequence(rest: &[u8], last: u8) -> Option<Input> {
    if let Some(report) = rest.strip_prefix(b"<") {
        let [button, column, row] = numbers(report)?[..] else { return None };
        return match last {
            b'M' | b'm' => click(button, Some(column), Some(row), last == b'M'),
            _ => None,
        };
    }
    let numbers = numbers(rest)?;
    let modifiers = modifiers(numbers.get(1).copied().unwrap_or(1));
    let first = numbers.first().copied().unwrap_or(0);
    match last {
        b'~' | b'^' | b'@' => {
            let shift = if last == b'@' { KeyModifiers::SHIFT } else { KeyModifiers::NONE };
            let control = if last == b'~' { KeyModifiers::NONE } else { KeyModifiers::CONTROL };
            numbered(first.to_string().as_bytes()).map(|code| with(code, modifiers | shift | control))
        }
        b'n' => (numbers == [0]).then_some(Input::Arrived),
        b'u' => Some(with(KeyCode::Char(char::from_u32(first.into())?), modifiers)),
        b'Z' => Some(key(KeyCode::BackTab)),
        // With other numbers it is the place of the cursor.
        b'P' | b'Q' | b'S' if first <= 1 => Some(with(KeyCode::F(last - b'P' + 1), modifiers)),
        b'a'..=b'd' => named(last.to_ascii_uppercase()).map(|code| with(code, KeyModifiers::SHIFT)),
        _ => named(last).map(|code| with(code, modifiers)),
    }
}

/// Numbers between semicolons; `None` for a private sequence, or one with intermediate bytes.
fn numbers(rest: &[u8]) -> Option<Vec<u16>> {
    let text = std::str::from_utf8(rest).ok()?;
    if text.is_empty() {
        return Some(Vec::new());
    }
    let number = |part: &str| {
        // A number may have parts of its own (kitty): the first counts.
        let first = part.split(':').next().unwrap_or_default();
        if first.is_empty() { Some(0) } else { first.parse().ok() }
    };
    text.split(';').map(number).collect()
}

/// The modifiers of a number: one more than its bits.
fn modifiers(number: u16) -> KeyModifiers {
    let bits = number.saturating_sub(1);
    [(1, KeyModifiers::SHIFT), (2, KeyModifiers::ALT), (4, KeyModifiers::CONTROL)]
        .into_iter()
        .filter(|(bit, _)| bits & bit != 0)
        .fold(KeyModifiers::NONE, |all, (_, one)| all | one)
}

/// The keys that end in a letter.
fn named(letter: u8) -> Option<KeyCode> {
    Some(match letter {
        b'A' => KeyCode::Up,
        b'B' => KeyCode::Down,
        b'C' => KeyCode::Right,
        b'D' => KeyCode::Left,
        b'F' => KeyCode::End,
        b'H' => KeyCode::Home,
        _ => return None,
    })
}

/// The keys that have a number.
fn numbered(digits: &[u8]) -> Option<KeyCode> {
    let number: u8 = std::str::from_utf8(digits).ok()?.parse().ok()?;
    Some(match number {
        1 | 7 => KeyCode::Home,
        2 => KeyCode::Insert,
        3 => KeyCode::Delete,
        4 | 8 => KeyCode::End,
        5 => KeyCode::PageUp,
        6 => KeyCode::PageDown,
        // The numbers leave gaps: F5 is 15, F6 17, F11 23.
        11..=15 => KeyCode::F(number - 10),
        17..=21 => KeyCode::F(number - 11),
        23..=24 => KeyCode::F(number - 12),
        _ => return None,
    })
}

fn key(code: KeyCode) -> Input {
    with(code, KeyModifiers::NONE)
}

fn with(code: KeyCode, modifiers: KeyModifiers) -> Input {
    Input::Key(KeyEvent::new(code, modifiers))
}

/// A character, which says by itself whether it is a capital.
fn character(c: char, modifiers: KeyModifiers) -> Input {
    let shift = if c.is_uppercase() { KeyModifiers::SHIFT } else { KeyModifiers::NONE };
    with(KeyCode::Char(c), modifiers | shift)
}

fn paste(text: &[u8]) -> Input {
    Input::Paste(String::from_utf8_lossy(text).into_owned())
}

/// The left button and the wheel: other buttons are left to the terminal's own menus, and the wheel turned sideways would step values
/// by mistake when a touchpad is brushed. A terminal counts from one; one that sends a zero has clicked nowhere.
fn click(button: u16, column: Option<u16>, row: Option<u16>, is_press: bool) -> Option<Input> {
    // Bits 2 to 4 are Shift, Alt and Control, bit 5 a movement.
    let kind = match button & !0b1_1100 {
        0 if is_press => MouseEventKind::Down(MouseButton::Left),
        64 => MouseEventKind::ScrollUp,
        65 => MouseEventKind::ScrollDown,
        _ => return None,
    };
    let (column, row) = (column?.checked_sub(1)?, row?.checked_sub(1)?);
    Some(Input::Mouse(MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE }))
}
