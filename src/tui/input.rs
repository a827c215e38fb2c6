//! Input thread: converts terminal input to messages.
//!
//! The thread is never joined. The loop detects a hang-up itself, and the thread ends with the process.

use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::Sender;
use std::thread;
use std::time::{Duration, Instant};

use super::backlog::LoopEvent;
use super::signals::HUNG_UP;
use super::terminal;
use super::terminal::decode::{Decoder, Input};
use crate::tui::message::Message;

/// Time for which a single escape may be the start of a key sequence; over SSH the rest may come in another packet.
const ESCAPE_TIMEOUT: Duration = Duration::from_millis(50);
const HOLD_OVER_SSH: Duration = Duration::from_millis(100);

/// Returns the escape timeout for this environment.
pub(super) fn hold(env: impl Fn(&str) -> Option<String>) -> Duration {
    let is_remote = ["SSH_CONNECTION", "SSH_TTY"].into_iter().any(|name| env(name).is_some());
    if is_remote { HOLD_OVER_SSH } else { ESCAPE_TIMEOUT }
}

/// Starts the thread. The terminal counts as lost when the thread ends.
pub(super) fn spawn(inbox: Sender<LoopEvent>, hold: Duration) -> io::Result<()> {
    let reading = move || {
        let decoder = Decoder::new(hold);
        let read = |buffer: &mut [u8], patience| {
            let start = Instant::now();
            Ok((terminal::read(buffer, patience)?, start.elapsed()))
        };
        // An error or a panic of the thread counts as a lost terminal.
        let _ = panic::catch_unwind(AssertUnwindSafe(|| listen(&inbox, decoder, read)));
        // The loop may have ended.
        let _ = inbox.send(LoopEvent::End(HUNG_UP));
    };
    thread::Builder::new().name("input".to_owned()).spawn(reading).map(drop)
}

/// Forwards input until reading fails or the loop has ended. `read` waits for bytes, at most for the given time. It returns their number
/// (`None` on timeout) and the time waited.
fn listen(
    inbox: &Sender<LoopEvent>,
    mut decoder: Decoder,
    mut read: impl FnMut(&mut [u8], Option<Duration>) -> io::Result<(Option<usize>, Duration)>,
) -> io::Result<()> {
    let mut buffer = [0; 4096];
    let mut found = Vec::new();
    loop {
        let (count, waited) = read(&mut buffer, decoder.patience())?;
        decoder.waited(waited);
        match count {
            Some(count) => decoder.feed(&buffer[..count], &mut found),
            None => decoder.expire(&mut found),
        }
        for input in found.drain(..) {
            let incoming = match input {
                Input::Key(key) => LoopEvent::Message(Message::Key(key)),
                Input::Paste(text) => LoopEvent::Message(Message::Paste(text)),
                Input::Mouse(mouse) => LoopEvent::Mouse(mouse),
                Input::Arrived => LoopEvent::Arrived,
            };
            if inbox.send(incoming).is_err() {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::VecDeque;
    use std::sync::mpsc;

    use crossterm::event::{KeyCode, KeyModifiers};

    use super::*;

    /// Decodes packets, each a number of milliseconds after the previous one.
    fn keys(hold: Duration, packets: &[(u64, &[u8])]) -> Vec<KeyCode> {
        let code = |incoming| match incoming {
            LoopEvent::Message(Message::Key(key)) => key.code,
            _ => panic!("no key"),
        };
        events(hold, packets).into_iter().map(code).collect()
    }

    fn events(hold: Duration, packets: &[(u64, &[u8])]) -> Vec<LoopEvent> {
        let (send, inbox) = mpsc::channel();
        let mut rest: VecDeque<(Duration, &[u8])> =
            packets.iter().map(|(ms, bytes)| (Duration::from_millis(*ms), *bytes)).collect();
        let read = |buffer: &mut [u8], patience: Option<Duration>| {
            let Some((delay, bytes)) = rest.front_mut() else {
                return match patience {
                    Some(patience) => Ok((None, patience)),
                    None => Err(io::ErrorKind::UnexpectedEof.into()),
                };
            };
            if let Some(patience) = patience.filter(|patience| *patience < *delay) {
                *delay -= patience;
                return Ok((None, patience));
            }
            let (delay, bytes) = (*delay, *bytes);
            rest.pop_front();
            buffer[..bytes.len()].copy_from_slice(bytes);
            Ok((Some(bytes.len()), delay))
        };
        listen(&send, Decoder::new(hold), read).unwrap_err();
        drop(send);
        inbox.iter().collect()
    }

    /// After any unterminated sequence keys are recognised again after a while; an interrupt immediately, also in a paste.
    #[test]
    fn no_sequence_without_an_end_keeps_the_keys() {
        const TYPED: usize = 200;
        let is_interrupt = |event: &LoopEvent| match event {
            LoopEvent::Message(Message::Key(key)) => {
                (key.code, key.modifiers) == (KeyCode::Char('c'), KeyModifiers::CONTROL)
            }
            _ => false,
        };
        let begun: [&[u8]; 9] = [
            b"\x1b[200~",
            b"\x1b[200~abc",
            b"\x1b]11;",
            b"\x1bP1",
            b"\x1b_G",
            b"\x1b[",
            b"\x1b[1;",
            b"\x1b]11;x\x1b",
            b"\x1b[M",
        ];
        for begun in begun {
            // Digits and letters, held down or typed as fast as possible.
            for (every, key) in [(33, &b"j"[..]), (33, b"5"), (33, b";"), (100, b"j"), (150, b"5")]
            {
                let mut packets = vec![(0, begun)];
                packets.extend(std::iter::repeat_n((every, key), TYPED));
                let is_key =
                    |event: &LoopEvent| matches!(event, LoopEvent::Message(Message::Key(_)));
                let heard = events(ESCAPE_TIMEOUT, &packets).iter().filter(|it| is_key(it)).count();
                // A paste may wait for 10 s in total, which are 435 repeats of a held key.
                let is_paste = begun.starts_with(b"\x1b[200~");
                let least = if !is_paste {
                    TYPED - 25
                } else if every > 33 {
                    TYPED - 120
                } else {
                    0
                };
                assert!(heard >= least, "{heard} keys after {begun:?}");
            }
        }
        let cut: [&[u8]; 5] = [b"\x1b", b"\x1bO", b"\x1b[[", b"\xc3", b"\x1b[M "];
        for begun in begun.iter().chain(&cut) {
            let found = events(ESCAPE_TIMEOUT, &[(0, *begun), (33, b"\x03")]);
            assert!(found.last().is_some_and(is_interrupt), "{begun:?}");
        }
        // Paste on a slow connection, byte by byte.
        let mut packets = vec![(0, &b"\x1b[200~"[..])];
        packets.extend(std::iter::repeat_n((5, &b"x"[..]), 10_000));
        packets.push((9_000, b"\x1b[201~"));
        let pasted = events(ESCAPE_TIMEOUT, &packets);
        assert!(
            matches!(&pasted[..], [LoopEvent::Message(Message::Paste(text))] if text.len() == 10_000)
        );
    }

    #[test]
    fn an_escape_is_a_key_once_nothing_follows_within_the_hold() {
        use KeyCode as K;
        assert_eq!(keys(ESCAPE_TIMEOUT, &[(0, b"\x1b"), (20, b"[H")]), [K::Home]);
        assert_eq!(keys(ESCAPE_TIMEOUT, &[(0, b"\x1b"), (60, b"j")]), [K::Esc, K::Char('j')]);
        assert_eq!(keys(HOLD_OVER_SSH, &[(0, b"\x1b"), (60, b"[D")]), [K::Left]);
        assert_eq!(keys(ESCAPE_TIMEOUT, &[(0, b"\x1b")]), [K::Esc]);
        assert_eq!(keys(ESCAPE_TIMEOUT, &[(0, b"\x1b\x1b")]), [K::Esc; 2]);
    }

    #[test]
    fn an_escape_is_held_longer_over_ssh() {
        assert_eq!(hold(|_| None), ESCAPE_TIMEOUT);
        let over_ssh =
            |name: &str| (name == "SSH_CONNECTION").then(|| "10.0.0.1 1 10.0.0.2 22".to_owned());
        assert_eq!(hold(over_ssh), HOLD_OVER_SSH);
    }
}
