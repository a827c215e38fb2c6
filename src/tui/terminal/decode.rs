//! Decoder of terminal input: bytes to keys, pastes and clicks.
//!
//! A key may arrive in several packets. A terminal also sends other data, such as answers to requests of this program or an earlier one.
//! The decoder returns complete keys and discards all other sequences. Only time distinguishes a single escape key from the start of a
//! sequence. The caller waits for [`Decoder::patience`] and then calls [`Decoder::expire`]. The decoder does not read a clock.

use std::time::Duration;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

/// Longest pause inside an escape sequence, for slow connections.
const REST: Duration = Duration::from_millis(500);

/// Longest pause inside a bracketed paste; the paste ends after it.
const PASTE_REST: Duration = Duration::from_secs(10);

/// Time that each received byte adds to the deadline of an escape sequence. The slowest lines send 200 bytes per second and a held key
/// repeats 30 times per second, so key repeats cannot keep an unterminated sequence open.
const PER_BYTE: Duration = Duration::from_millis(10);

/// Interrupt character, Ctrl-C.
const INTERRUPT: u8 = 0x03;

/// Maximum length of an escape sequence, bytes; larger than that of any known sequence.
const LONGEST: usize = 64;

const PASTE_END: &[u8] = b"\x1b[201~";

/// Decoded input from the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::tui) enum Input {
    Key(KeyEvent),
    Paste(String),
    Mouse(MouseEvent),
    /// Answer to a request for a status report: all data sent before the request has been received.
    Arrived,
}

/// State of the decoder within a key or a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum State {
    Ground,
    /// First bytes of a character.
    Character(Vec<u8>),
    Escape,
    /// Bytes after `ESC [`.
    Control(Vec<u8>),
    /// After `ESC O`.
    Single,
    /// Inside an ignored string with this introducer (OSC, DCS, APC); whether a byte has followed it.
    Text(u8, bool),
    /// After an escape inside a string: its end, or the start of another sequence.
    TextEscape,
    Paste(Vec<u8>),
    /// Number of missing coordinate bytes of an old mouse report, which are ignored.
    Click(u8),
    /// After `ESC [ [`: a function key of the Linux console.
    Console,
}

pub(in crate::tui) struct Decoder {
    state: State,
    /// Maximum time for which a single escape may be the start of a sequence.
    hold: Duration,
    /// Remaining time for the current sequence.
    left: Duration,
}

impl Decoder {
    pub(in crate::tui) fn new(hold: Duration) -> Self {
        Self { state: State::Ground, hold, left: Duration::ZERO }
    }

    /// Returns the timeout for the next byte, after which [`Decoder::expire`] must be called; `None` for no timeout.
    pub(in crate::tui) fn patience(&self) -> Option<Duration> {
        (self.state != State::Ground).then_some(self.left)
    }

    /// Records how long the caller waited for the last bytes.
    pub(in crate::tui) fn waited(&mut self, time: Duration) {
        self.left = self.left.saturating_sub(time);
    }

    /// Returns the maximum pause in this state.
    fn longest(&self) -> Duration {
        match self.state {
            State::Ground => Duration::ZERO,
            State::Escape => self.hold,
            State::Paste(_) => PASTE_REST,
            _ => REST,
        }
    }

    /// Handles a timeout.
    pub(in crate::tui) fn expire(&mut self, out: &mut Vec<Input>) {
        match std::mem::replace(&mut self.state, State::Ground) {
            State::Escape => out.push(key(KeyCode::Esc)),
            // Esc and the next key, pressed at the same time.
            State::Control(rest) if rest.is_empty() => out.push(character('[', KeyModifiers::ALT)),
            State::Single => out.push(character('O', KeyModifiers::ALT)),
            State::Text(introducer, false) => {
                out.push(character(char::from(introducer), KeyModifiers::ALT));
            }
            State::Paste(text) => out.push(paste(&text)),
            _ => {}
        }
    }

    /// Decodes bytes, in packets of any size.
    pub(in crate::tui) fn feed(&mut self, bytes: &[u8], out: &mut Vec<Input>) {
        // A paste without an end does not swallow a single interrupt, which cannot be part of it.
        if bytes == [INTERRUPT] && matches!(self.state, State::Paste(_)) {
            self.expire(out);
        }
        for byte in bytes {
            let before = std::mem::discriminant(&self.state);
            self.take(*byte, out);
            let (more, longest) = (self.left + PER_BYTE, self.longest());
            let goes_on = std::mem::discriminant(&self.state) == before;
            self.left = if goes_on { more.min(longest) } else { longest };
        }
    }

    fn take(&mut self, byte: u8, out: &mut Vec<Input>) {
        match std::mem::replace(&mut self.state, State::Ground) {
            State::Ground => self.ground(byte, KeyModifiers::NONE, out),
            State::Character(bytes) => self.character(bytes, byte, out),
            State::Escape => self.after_escape(byte, out),
            State::Control(rest) => self.control(rest, byte, out),
            // Esc and the next keys, pressed at the same time.
            State::Text(introducer, false) if !may_begin(introducer, byte) => {
                out.push(character(char::from(introducer), KeyModifiers::ALT));
                self.ground(byte, KeyModifiers::NONE, out);
            }
            State::Text(introducer, _) => match byte {
                // Terminated by BEL, CAN or SUB, and by `ESC \\`.
                0x07 | 0x18 | 0x1a => {}
                0x1b => self.state = State::TextEscape,
                // The end was lost: strings contain no control characters.
                0x00..=0x1f => self.ground(byte, KeyModifiers::NONE, out),
                _ => self.state = State::Text(introducer, true),
            },
            State::TextEscape => {
                if byte != b'\\' {
                    self.after_escape(byte, out);
                }
            }
            State::Paste(mut text) => {
                text.push(byte);
                match text.strip_suffix(PASTE_END) {
                    Some(text) => out.push(paste(text)),
                    None => self.state = State::Paste(text),
                }
            }
            // Only characters follow `ESC O`, `ESC [ [` and coordinates: the end was lost.
            State::Single | State::Console | State::Click(_) if byte < b' ' && byte != 0x1b => {
                self.ground(byte, KeyModifiers::NONE, out);
            }
            State::Single => self.single(byte, out),
            State::Click(1) => {}
            State::Click(left) => self.state = State::Click(left - 1),
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
            // Middle of a character without its start, or invalid UTF-8.
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
            b']' | b'P' | b'_' => self.state = State::Text(byte, false),
            // Two escapes: the first is a key.
            0x1b => {
                out.push(key(KeyCode::Esc));
                self.state = State::Escape;
            }
            // Shift-Tab of the Linux console.
            b'\t' => out.push(key(KeyCode::BackTab)),
            b' '..=b'~' | 0x7f => self.ground(byte, KeyModifiers::ALT, out),
            _ => {
                out.push(key(KeyCode::Esc));
                self.ground(byte, KeyModifiers::NONE, out);
            }
        }
    }

    fn single(&mut self, byte: u8, out: &mut Vec<Input>) {
        match byte {
            0x1b => self.state = State::Escape,
            b'P'..=b'S' => out.push(key(KeyCode::F(byte - b'P' + 1))),
            _ => out.extend(named(byte).map(key)),
        }
    }

    /// Decodes the next byte of a control sequence: parameters, intermediates, final byte.
    fn control(&mut self, mut rest: Vec<u8>, byte: u8, out: &mut Vec<Input>) {
        match byte {
            0x1b => self.state = State::Escape,
            b'[' if rest.is_empty() => self.state = State::Console,
            b'M' if rest.is_empty() => self.state = State::Click(3),
            // With Shift, urxvt ends the number of a key with `$`.
            b'$' if !rest.is_empty() && rest.iter().all(u8::is_ascii_digit) => {}
            b' '..=b'?' => {
                // Sequences that are too long for a key are discarded.
                if rest.len() < LONGEST {
                    rest.push(byte);
                }
                self.state = State::Control(rest);
            }
            b'@'..=b'~' if rest.as_slice() == b"200" && byte == b'~' => {
                self.state = State::Paste(Vec::new());
            }
            b'@'..=b'~' => out.extend(sequence(&rest, byte)),
            // Not a sequence: handle the byte separately.
            0x00..=0x1f => self.ground(byte, KeyModifiers::NONE, out),
            _ => {}
        }
    }
}

/// Returns `true` if a terminal string may start in this way: OSC with a number, DCS with a number or report mark, APC with the graphics
/// mark.
fn may_begin(introducer: u8, byte: u8) -> bool {
    match introducer {
        b']' => byte.is_ascii_digit(),
        b'P' => byte.is_ascii_digit() || matches!(byte, b'>' | b'!' | b'$' | b'+' | b'='),
        _ => byte == b'G',
    }
}

/// Decodes a control sequence; `None` if the workbench does not use it.
fn sequence(rest: &[u8], last: u8) -> Option<Input> {
    if let Some(report) = rest.strip_prefix(b"<") {
        let fields = fields(report)?;
        let [button, column, row] = &fields[..] else { return None };
        let first = |field: &Vec<u32>| field.first().and_then(|it| u16::try_from(*it).ok());
        let (button, column, row) = (first(button)?, first(column)?, first(row)?);
        return match last {
            b'M' | b'm' => click(button, column, row, last == b'M'),
            _ => None,
        };
    }
    let fields = fields(rest)?;
    let field = |at: usize, part: usize| fields.get(at).and_then(|it| it.get(part)).copied();
    let modifiers = modifiers(field(1, 0).unwrap_or(1));
    let first = field(0, 0).unwrap_or(0);
    // The kitty protocol also reports releases, if another program has left it on.
    if field(1, 1) == Some(RELEASED) {
        return None;
    }
    match last {
        // xterm's modifyOtherKeys: the number of the character is last.
        b'~' if first == 27 => spelled(field(2, 0)?, None, modifiers),
        b'~' => numbered(first).map(|code| with(code, modifiers)),
        // Use the text of the key if given, else the shifted character.
        b'u' => spelled(first, field(2, 0).or_else(|| field(0, 1)), modifiers),
        b'n' => (fields == [[0]]).then_some(Input::Arrived),
        b'Z' => Some(key(KeyCode::BackTab)),
        // With other numbers it is the cursor position.
        b'P' | b'Q' | b'S' if first <= 1 => Some(with(KeyCode::F(last - b'P' + 1), modifiers)),
        _ => named(last).map(|code| with(code, modifiers)),
    }
}

/// Returns the fields between semicolons, each with its parts between colons; `None` for a private sequence, or one with intermediate
/// bytes.
fn fields(rest: &[u8]) -> Option<Vec<Vec<u32>>> {
    let text = std::str::from_utf8(rest).ok()?;
    if text.is_empty() {
        return Some(Vec::new());
    }
    let number = |part: &str| if part.is_empty() { Some(0) } else { part.parse().ok() };
    text.split(';').map(|field| field.split(':').map(number).collect()).collect()
}

/// Event type of a released key.
const RELEASED: u32 = 3;

/// Returns the key of a character number, as reported by kitty and xterm if another program has left that mode on; `text` is the typed
/// character. With Control, a key has the meaning of its control character.
fn spelled(number: u32, text: Option<u32>, modifiers: KeyModifiers) -> Option<Input> {
    let has_control = modifiers.contains(KeyModifiers::CONTROL);
    let has_shift = modifiers.contains(KeyModifiers::SHIFT);
    let c = match number {
        13 | 57414 => return Some(key(KeyCode::Enter)),
        9 if has_shift => return Some(key(KeyCode::BackTab)),
        9 => return Some(key(KeyCode::Tab)),
        8 | 127 => return Some(key(KeyCode::Backspace)),
        27 => return Some(key(KeyCode::Esc)),
        // Keypad: digits and signs, then cursor keys.
        57399..=57413 => {
            char::from(*b"0123456789./*-+".get(usize::try_from(number - 57399).ok()?)?)
        }
        57417..=57426 => {
            use KeyCode as K;
            let codes = [K::Left, K::Right, K::Up, K::Down, K::PageUp];
            let others = [K::PageDown, K::Home, K::End, K::Insert, K::Delete];
            let at = usize::try_from(number - 57417).ok()?;
            return codes.iter().chain(&others).nth(at).map(|code| with(*code, modifiers));
        }
        // Other keys without a character.
        0..=31 | 57344..=63743 => return None,
        _ => char::from_u32(number)?,
    };
    if has_control {
        return Some(match c.to_ascii_lowercase() {
            '[' => key(KeyCode::Esc),
            'i' => key(KeyCode::Tab),
            'm' => key(KeyCode::Enter),
            c => with(KeyCode::Char(c), modifiers - KeyModifiers::SHIFT),
        });
    }
    let text = text.filter(|it| *it > 0).and_then(char::from_u32);
    let capital = || c.to_uppercase().next().unwrap_or(c);
    let c = text.unwrap_or_else(|| if has_shift { capital() } else { c });
    Some(character(c, modifiers - KeyModifiers::SHIFT))
}

/// Converts a modifier number, which is one more than its bits.
fn modifiers(number: u32) -> KeyModifiers {
    let bits = number.saturating_sub(1);
    [(1, KeyModifiers::SHIFT), (2, KeyModifiers::ALT), (4, KeyModifiers::CONTROL)]
        .into_iter()
        .filter(|(bit, _)| bits & bit != 0)
        .fold(KeyModifiers::NONE, |all, (_, one)| all | one)
}

/// Returns the key of a final letter.
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

/// Returns the key of a number.
fn numbered(number: u32) -> Option<KeyCode> {
    let number = u8::try_from(number).ok()?;
    Some(match number {
        1 | 7 => KeyCode::Home,
        2 => KeyCode::Insert,
        3 => KeyCode::Delete,
        4 | 8 => KeyCode::End,
        5 => KeyCode::PageUp,
        6 => KeyCode::PageDown,
        // The numbers have gaps: F5 is 15, F6 17, F11 23.
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

/// Creates a character key; the character itself determines its case.
fn character(c: char, modifiers: KeyModifiers) -> Input {
    let shift = if c.is_uppercase() { KeyModifiers::SHIFT } else { KeyModifiers::NONE };
    with(KeyCode::Char(c), modifiers | shift)
}

fn paste(text: &[u8]) -> Input {
    Input::Paste(String::from_utf8_lossy(text).into_owned())
}

/// Decodes the left button and the wheel. Other buttons are left to the terminal's own menus, and horizontal scrolling would step values by
/// accident. Terminal coordinates start at 1; a zero is not a position.
fn click(button: u16, column: u16, row: u16, is_press: bool) -> Option<Input> {
    // Bits 2 to 4 are Shift, Alt and Control, bit 5 is a movement.
    let kind = match button & !0b1_1100 {
        0 if is_press => MouseEventKind::Down(MouseButton::Left),
        64 => MouseEventKind::ScrollUp,
        65 => MouseEventKind::ScrollDown,
        _ => return None,
    };
    let (column, row) = (column.checked_sub(1)?, row.checked_sub(1)?);
    Some(Input::Mouse(MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE }))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Decodes packets, followed by silence.
    fn inputs(packets: &[&[u8]]) -> Vec<Input> {
        let (mut decoder, mut found) = (Decoder::new(Duration::ZERO), Vec::new());
        for packet in packets {
            decoder.feed(packet, &mut found);
        }
        while decoder.patience().is_some() {
            decoder.expire(&mut found);
        }
        found
    }

    fn one(bytes: &[u8]) -> Vec<Input> {
        inputs(&[bytes])
    }

    fn code(c: char) -> Input {
        character(c, KeyModifiers::NONE)
    }

    /// Sequences of xterm and the Linux console, by their manuals.
    #[test]
    fn keys_are_what_terminals_send_for_them() {
        use KeyCode as K;
        const SHIFT: KeyModifiers = KeyModifiers::SHIFT;
        const CONTROL: KeyModifiers = KeyModifiers::CONTROL;
        let plain = KeyModifiers::NONE;
        for (bytes, code, modifiers) in [
            (&b"\r"[..], K::Enter, plain),
            (b"\t", K::Tab, plain),
            (b"\x7f", K::Backspace, plain),
            (b"\x1a", K::Char('z'), CONTROL),
            (b"\x00", K::Char(' '), CONTROL),
            (b"G", K::Char('G'), SHIFT),
            (b"\x1b[D", K::Left, plain),
            (b"\x1bOD", K::Left, plain),
            (b"\x1b[1;2C", K::Right, SHIFT),
            (b"\x1b[1;5A", K::Up, CONTROL),
            (b"\x1b[H", K::Home, plain),
            (b"\x1b[7~", K::Home, plain),
            (b"\x1b[4~", K::End, plain),
            (b"\x1b[5~", K::PageUp, plain),
            (b"\x1b[3;5~", K::Delete, CONTROL),
            (b"\x1b[Z", K::BackTab, plain),
            (b"\x1b\t", K::BackTab, plain),
            (b"\x1b[[A", K::F(1), plain),
            (b"\x1bOP", K::F(1), plain),
            (b"\x1b[15~", K::F(5), plain),
            (b"\x1b[24~", K::F(12), plain),
            (b"\x1bj", K::Char('j'), KeyModifiers::ALT),
            (b"\x1b[", K::Char('['), KeyModifiers::ALT),
            (b"\x1bO", K::Char('O'), KeyModifiers::ALT | SHIFT),
            (b"\x1b]", K::Char(']'), KeyModifiers::ALT),
        ] {
            assert_eq!(one(bytes), [with(code, modifiers)], "{bytes:?}");
        }
        assert_eq!(one(b"\x1b\r"), [key(K::Esc), key(K::Enter)]);
        assert_eq!(one(b"\x1b\x1b[D"), [key(K::Esc), key(K::Left)]);
    }

    /// Keyboard protocol of kitty and xterm's modifyOtherKeys, by their manuals. Another program may have left them on.
    #[test]
    fn keys_that_are_spelled_out_are_the_same_keys() {
        for (spelled, plain) in [
            (&b"\x1b[113u"[..], &b"q"[..]),
            (b"\x1b[113;1u", b"q"),
            (b"\x1b[113;1:1u", b"q"),
            (b"\x1b[113;1:2u", b"q"),
            (b"\x1b[113;1:3u", b""),
            (b"\x1b[99;5u", b"\x03"),
            (b"\x1b[99;6u", b"\x03"),
            (b"\x1b[27;5;99~", b"\x03"),
            (b"\x1b[27;5;67~", b"\x03"),
            (b"\x1b[122;5u", b"\x1a"),
            (b"\x1b[32;5u", b"\x00"),
            (b"\x1b[105;5u", b"\t"),
            (b"\x1b[109;5u", b"\r"),
            (b"\x1b[27u", b"\x1b"),
            (b"\x1b[13u", b"\r"),
            (b"\x1b[27;2;13~", b"\r"),
            (b"\x1b[9u", b"\t"),
            (b"\x1b[9;2u", b"\x1b[Z"),
            (b"\x1b[127u", b"\x7f"),
            (b"\x1b[103;2u", b"G"),
            (b"\x1b[103:71;2u", b"G"),
            (b"\x1b[49:33;2u", b"!"),
            (b"\x1b[27;2;33~", b"!"),
            (b"\x1b[49;2;33u", b"!"),
            (b"\x1b[106;3u", b"\x1bj"),
            (b"\x1b[246u", b"\xc3\xb6"),
            // Caps Lock and Num Lock do not modify commands.
            (b"\x1b[113;129u", b"q"),
            (b"\x1b[57400u", b"1"),
            (b"\x1b[57414u", b"\r"),
            (b"\x1b[57417u", b"\x1b[D"),
            (b"\x1b[1;1:1D", b"\x1b[D"),
            (b"\x1b[1;1:3D", b""),
            (b"\x1b[3;1:3~", b""),
            // Modifier pressed alone.
            (b"\x1b[57441;2u", b""),
        ] {
            assert_eq!(one(spelled), one(plain), "{spelled:?}");
        }
    }

    #[test]
    fn what_is_no_key_is_swallowed_to_its_end() {
        for bytes in [
            &b"\x1b]11;rgb:0000/0000/0000\x1b\\"[..],
            b"\x1b]11;rgb:ffff/ffff/dddd\x07",
            b"\x1bP>|xterm(380)\x1b\\",
            b"\x1bP1$r0m\x1b\\",
            b"\x1b_Gi=1;OK\x1b\\",
            b"\x1b[>41;380;0c",
            b"\x1b[?62;22c",
            b"\x1b[12;40R",
            b"\x1b[?2026;2$y",
            b"\x1b[4;1$y",
            b"\x1b[8;24;80t",
            b"\x1b[I",
            b"\x1b[O",
            b"\x1b[1;1z",
            b"\x1b[999999999999999999~",
            b"\x1b[ q",
            b"\x1bOz",
            b"\x1b[3$",
            b"\x1b[3^",
            b"\x1b[a",
            b"\x1b[M\x20\x25\x28",
            b"\xff\xfe\x80",
        ] {
            let with_key = [bytes, b"j"].concat();
            assert_eq!(one(&with_key), [code('j')], "{bytes:?}");
        }
        // An incomplete string ends at the next sequence, or on timeout.
        assert_eq!(one(b"\x1b]11;rgb:00\x1b[D"), [key(KeyCode::Left)]);
        assert_eq!(one(b"\x1b]11;rgb:00"), []);
        assert_eq!(one(b"\x1b]11;rgb:00\rj"), [key(KeyCode::Enter), code('j')]);
        // A key directly after Esc starts a string only if the next byte matches.
        let alt = |c| character(c, KeyModifiers::ALT);
        assert_eq!(one(b"\x1b]j"), [alt(']'), code('j')]);
        assert_eq!(one(b"\x1bXj\x1bPj"), [alt('X'), code('j'), alt('P'), code('j')]);
        assert_eq!(one(b"\x1b[1;5"), []);
        assert_eq!(one(b"\x1b[0n"), [Input::Arrived]);
    }

    #[test]
    fn a_paste_is_one_text_whatever_is_in_it() {
        let text = "gamma=2\nx \x1b[D ö";
        let sent = format!("\x1b[200~{text}\x1b[201~j");
        assert_eq!(one(sent.as_bytes()), [Input::Paste(text.to_owned()), code('j')]);
    }

    #[test]
    fn clicks_and_the_wheel_count_and_other_buttons_do_not() {
        let modifiers = KeyModifiers::NONE;
        let mouse = |kind| [Input::Mouse(MouseEvent { kind, column: 4, row: 7, modifiers })];
        let press = MouseEventKind::Down(MouseButton::Left);
        assert_eq!(one(b"\x1b[<0;5;8M"), mouse(press));
        assert_eq!(one(b"\x1b[<64;5;8M"), mouse(MouseEventKind::ScrollUp));
        assert_eq!(one(b"\x1b[<65;5;8M"), mouse(MouseEventKind::ScrollDown));
        for none in ["0;5;8m", "2;5;8M", "35;5;8M", "66;5;8M", "0;0;8M", "0;5M", "0;5;8;9M"] {
            assert_eq!(one(format!("\x1b[<{none}").as_bytes()), [], "{none}");
        }
    }

    proptest! {
        /// The result does not depend on the division into packets.
        #[test]
        fn packets_make_no_difference(
            pieces in proptest::collection::vec(
                proptest::sample::select(vec![
                    &b"\x1b[H"[..], b"\x1b[3~", b"j", b"\x1bOA", b"\x1b\x1b[D", b"\xc3\xb6", b"\x1b[3$", b"\x1b[<0;5;8M",
                    b"\x1b[200~a\x1b[Bb\x1b[201~", b"\x1b]11;rgb:1/2/3\x1b\\", b"\x1b[>41;380;0c", b"\x1b\t", b"\x1b[M\x20\x25\x28",
                    b"\xff", b"\r",
                ]),
                1..8,
            ),
            cuts in proptest::collection::vec(any::<bool>(), 200),
        ) {
            let bytes = pieces.concat();
            let mut packets = vec![Vec::new()];
            for (byte, cut) in bytes.iter().zip(cuts) {
                packets.last_mut().unwrap().push(*byte);
                if cut {
                    packets.push(Vec::new());
                }
            }
            let packets: Vec<&[u8]> = packets.iter().map(Vec::as_slice).collect();
            prop_assert_eq!(inputs(&packets), one(&packets.concat()));
        }

        #[test]
        fn no_bytes_do_harm(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            one(&bytes);
        }
    }
}
